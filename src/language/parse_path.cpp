// Paths: segments between '/', then a parameter behind '.', then '~' and the number of one of its choices.
#include <algorithm>
#include <utility>

#include "base/number_text.h"
#include "base/unicode.h"
#include "language/parser.h"
#include "language/token_text.h"

namespace filigree {

namespace {

constexpr std::string_view form = "a path is written as in 'leaf/outline/in/place#2.size' or 'leaf/**.size'";

bool has_only_digits(std::string_view bytes) { return bytes.find_first_not_of("0123456789") == std::string_view::npos; }

// Reads the token of a path; the first thing that is wrong with it is its only diagnostic.
class PathReader {
public:
    PathReader(std::string_view text, const Token& token, std::uint32_t file)
        : text_(text), begin_(token.begin), end_(token.end), file_(file), at_(token.begin) {}

    Result<ChoicePath> read() {
        do read_segment();
        while (accept('/'));
        if (accept('.')) read_parameter();
        if (accept('~')) read_draw();
        if (!problem_ && !at_end()) fail_character();
        if (problem_) return std::move(*problem_);
        path_.span = {file_, begin_, end_};
        return std::move(path_);
    }

private:
    bool at_end() const { return at_ == end_; }
    char next() const { return at_end() ? '\0' : text_[at_]; }
    bool accept(char c) {
        if (problem_ || next() != c) return false;
        ++at_;
        return true;
    }
    SourceSpan span_from(std::uint32_t begin) const { return {file_, begin, at_}; }
    SourceSpan one_character() const { return {file_, at_, at_end() ? at_ : at_ + unicode::decode(text_, at_).length}; }
    // Letters, digits and '_' as far as they go.
    std::string_view take_word() {
        const Token word = read_token(text_, at_, LexMode::tag, false);
        if (at_end() || word.kind != TokenKind::name || word.begin != at_) return {};
        at_ = word.end;
        return text_.substr(word.begin, word.end - word.begin);
    }

    void fail(std::string_view code, std::string message, SourceSpan span, std::vector<std::string> hints) {
        if (problem_) return;
        // Where the path breaks off, a blank is the likely reason.
        const Token more = read_token(text_, end_, LexMode::value, false);
        const bool goes_on = more.kind != TokenKind::end_of_line && more.kind != TokenKind::end_of_text &&
                             more.kind != TokenKind::semicolon && more.kind != TokenKind::assign;
        const bool is_apart = more.begin > end_ || more.kind == TokenKind::comma;
        if (at_end() && goes_on && is_apart) hints.push_back("a path has no blanks");
        problem_ = error(std::string(code), std::move(message), span, std::move(hints));
    }
    // What stands here is no part of a path, or of this place in one.
    void fail_character(std::vector<std::string> hints = {std::string(form)}) {
        const char c = next();
        if (c == '-') hints = {"a tag has letters, digits and '_' only"};
        if (c == ',') hints = {"paths are separated by ',' and a blank"};
        if (c == ':') hints = {"a value is given with '=', as in 'set leaf/outline.distance = 25'"};
        if (c == '*') hints = {"'*' stands for a whole segment, '**' for any number of them"};
        if (c == '~') hints = {"'~' counts the choices of a parameter, as in 'outline.distance~2'"};
        if (c == '"') hints = {"a path is written without quotes"};
        const Token token = read_token(text_, at_, LexMode::value, false);
        if (!problem_ && token.trouble == Trouble::stray_character && c != '~') {
            problem_ = explain(token, text_, file_);
            return;
        }
        const SourceSpan span = one_character();
        fail("language.bad-path",
             "found " + in_quotes(text_.substr(span.begin, span.end - span.begin)) + " inside a path", span,
             std::move(hints));
    }
    std::string normal_name(std::string_view word) {
        if (word.size() <= max_name_bytes) return unicode::normalise(word);
        fail("language.long-name", "this name has more than 1000 bytes",
             span_from(at_ - static_cast<std::uint32_t>(word.size())), {});
        return {};
    }

    // --- segments ---

    void read_segment() {
        const std::uint32_t from = at_;
        if (accept('*')) return read_any(from);
        const std::string_view word = take_word();
        if (word.empty()) return fail_no_segment();
        PathSegment segment;
        if (has_only_digits(word)) {
            at_ = from;
            read_shapes(segment);
        } else {
            segment.name = normal_name(word);
            if (accept('#')) {
                const std::uint32_t number = read_number("rule");
                if (number > 1) segment.name += "#" + to_text(std::uint64_t{number});
            }
            if (accept('[')) read_groups(segment.ordinals);
        }
        std::sort(segment.ordinals.begin(), segment.ordinals.end());
        segment.ordinals.erase(std::unique(segment.ordinals.begin(), segment.ordinals.end()), segment.ordinals.end());
        path_.segments.push_back(std::move(segment));
    }
    void read_any(std::uint32_t from) {
        while (accept('*')) {}
        const std::uint32_t count = at_ - from;
        if (count > 2) {
            return fail("language.bad-path", in_quotes(text_.substr(from, count)) + " is no segment", span_from(from),
                        {"'*' stands for one segment, '**' for any number of them"});
        }
        if (!at_end() && next() != '/' && next() != '.') {
            return fail_character({"'*' stands for a whole segment, '**' for any number of them"});
        }
        const PathSegment::Kind kind = count == 2 ? PathSegment::Kind::any_depth : PathSegment::Kind::any;
        const bool is_repeated = kind == PathSegment::Kind::any_depth && !path_.segments.empty() &&
                                 path_.segments.back().kind == PathSegment::Kind::any_depth;
        if (is_repeated) return;
        path_.segments.emplace_back();
        path_.segments.back().kind = kind;
    }
    void fail_no_segment() {
        const SourceSpan span = one_character();
        const bool is_first = at_ == begin_;
        if (next() == '/' && is_first) {
            return fail("language.bad-path", "a path starts with a tag, not with '/'", span, {std::string(form)});
        }
        if (next() == '/') {
            return fail("language.bad-path", "found nothing between '/' and '/'", span,
                        {"any number of segments is written '**'"});
        }
        if (next() == '.') {
            return fail("language.bad-path",
                        is_first ? "found no path before '.'" : "found nothing between '/' and '.'", span,
                        {"a parameter of all steps is written '**.name'"});
        }
        if (at_end()) {
            return fail("language.bad-path", "found nothing behind '/'", {file_, at_ - 1, at_}, {std::string(form)});
        }
        fail_character();
    }

    // --- numbers ---

    // From 1; 0 where the number is wrong.
    std::uint32_t read_number(std::string_view what) {
        if (problem_) return 0;
        const std::uint32_t from = at_;
        const std::string_view word = take_word();
        if (word.empty()) {
            const SourceSpan span = one_character();
            const std::string found = at_end() ? "nothing" : in_quotes(text_.substr(span.begin, span.end - span.begin));
            fail("language.bad-ordinal", "expected the number of a " + std::string(what) + ", found " + found, span,
                 {});
            return 0;
        }
        std::uint64_t number = 0;
        for (const char c : has_only_digits(word) ? word : "") {
            number = std::min(number * 10 + static_cast<std::uint64_t>(c - '0'), std::uint64_t{1} << 32);
        }
        if (number == 0 || number > UINT32_MAX) {
            fail("language.bad-ordinal", in_quotes(word) + " is no number of a " + std::string(what), span_from(from),
                 {std::string(what) + "s are counted from 1 to 4294967295"});
            return 0;
        }
        return static_cast<std::uint32_t>(number);
    }
    void read_shapes(PathSegment& segment) {
        segment.kind = PathSegment::Kind::shapes;
        const std::uint32_t from = at_;
        do segment.ordinals.push_back(read_number("shape"));
        while (accept(','));
        if (!path_.segments.empty()) return;
        fail("language.bad-path", "a path starts with a tag, and digits alone are numbers of shapes", span_from(from),
             {std::string(form)});
    }
    // Behind the '['.
    void read_groups(std::vector<std::uint32_t>& ordinals) {
        const SourceSpan open = span_from(at_ - 1);
        do {
            if (at_end()) break;
            ordinals.push_back(read_number("group"));
        } while (accept(','));
        if (problem_ || accept(']')) return;
        if (at_end()) {
            return fail("language.unclosed-bracket", "this '[' is never closed", open,
                        {"groups are numbered as in 'quads[1,3]'"});
        }
        fail_character({"groups are numbered as in 'quads[1,3]'"});
    }

    // --- behind the segments ---

    void read_parameter() {
        const std::uint32_t from = at_;
        const std::string_view word = take_word();
        const bool has_digit = !word.empty() && word[0] >= '0' && word[0] <= '9';
        if (word.empty() || has_digit) {
            if (!has_digit && !at_end()) return fail_character({"behind '.' stands the name of a parameter"});
            const std::string found = has_digit ? in_quotes(word) : "nothing";
            std::vector<std::string> hints;
            if (has_digit) hints = {"a name starts with a letter or '_'"};
            return fail("language.missing-name", "expected a parameter behind '.', found " + found, span_from(from),
                        std::move(hints));
        }
        path_.parameter = normal_name(word);
        if (at_end() || next() == '~') return;
        if (next() == '/' || next() == '.') return fail_character({"a path ends in its parameter"});
        fail_character();
    }
    // Behind the '~'. A value with a name has choices without being a parameter of a step.
    void read_draw() {
        const std::vector<PathSegment>& segments = path_.segments;
        const auto is_plain = [](const PathSegment& segment) {
            return segment.kind == PathSegment::Kind::name && segment.ordinals.empty();
        };
        const bool is_definition =
            (segments.size() == 1 && is_plain(segments[0])) ||
            (segments.size() == 2 && is_plain(segments[0]) && segments[0].name == "let" && is_plain(segments[1]));
        if (path_.parameter.empty() && !is_definition) {
            --at_;
            return fail_character();
        }
        path_.draw = read_number("choice");
    }

    std::string_view text_;
    std::uint32_t begin_, end_, file_;
    std::uint32_t at_;
    ChoicePath path_;
    std::optional<Diagnostic> problem_;
};

}  // namespace

std::optional<ChoicePath> Parser::read_path(std::string_view example) {
    if (!at(TokenKind::path, LexMode::path)) {
        std::vector<std::string> hints = {std::string(example)};
        if (ahead_.kind == TokenKind::text) hints = {"a path is written without quotes"};
        fail_expected("language.missing-path", "a path", std::move(hints));
        return std::nullopt;
    }
    const Token token = take(LexMode::path);
    Result<ChoicePath> path = PathReader(text_, token, file_).read();
    if (path) return std::move(*path);
    // Its brackets and quotes end with it: what follows is read as if it had been right.
    Token behind = token;
    behind.begin = token.end;
    fail(behind, path.diagnostics().front());
    return std::nullopt;
}

// Right behind a path, where it may have been meant to go on.
void Parser::fail_behind_path(std::string_view code, std::string_view wanted, std::vector<std::string> hints) {
    const Token found = peek();
    if (found.kind == TokenKind::slash || found.kind == TokenKind::dot || found.kind == TokenKind::open_square) {
        return fail(found, error("language.bad-path", "found a blank inside a path", {file_, taken_end_, found.begin},
                                 {"a path has no blanks, as in 'leaf/outline.distance'"}));
    }
    fail_expected(code, wanted, std::move(hints));
}

}  // namespace filigree
