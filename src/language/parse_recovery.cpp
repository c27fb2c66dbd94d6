// Failures of a statement, and where to go on behind one.
#include <algorithm>
#include <utility>

#include "language/parser.h"
#include "language/token_text.h"

namespace filigree {

namespace {

bool opens(TokenKind kind) { return kind == TokenKind::open_round || kind == TokenKind::open_square; }
bool closes(TokenKind kind) { return kind == TokenKind::close_round || kind == TokenKind::close_square; }
TokenKind partner(TokenKind open) {
    return open == TokenKind::open_round ? TokenKind::close_round : TokenKind::close_square;
}

// What never stands inside ( ) or [ ], so that an open one must have been forgotten.
bool ends_brackets(TokenKind kind) {
    return kind == TokenKind::end_of_text || kind == TokenKind::arrow || kind == TokenKind::semicolon ||
           kind == TokenKind::open_curly || kind == TokenKind::close_curly;
}

}  // namespace

void Parser::fail(const Token& at, Diagnostic diagnostic) {
    if (has_failed_) return;
    has_failed_ = true;
    failed_at_ = at;
    report(std::move(diagnostic));
}

void Parser::fail_expected(std::string_view code, std::string_view wanted, std::vector<std::string> hints) {
    const Token found = ahead_;
    if (found.kind == TokenKind::invalid) return fail(found, explain(found, text_, file_));
    const bool is_in_block = open_block_ || !blocks_.empty();
    const bool is_unmatched =
        open_.empty() && (closes(found.kind) || (found.kind == TokenKind::close_curly && !is_in_block));
    if (is_unmatched) {
        return fail(found, error("language.unmatched-bracket", "this " + describe(found, text_) + " closes nothing",
                                 span_of(found)));
    }
    const bool is_end = found.kind == TokenKind::end_of_line || found.kind == TokenKind::end_of_text;
    const SourceSpan span = is_end ? SourceSpan{file_, taken_end_, taken_end_} : span_of(found);
    fail(found, error(std::string(code), "expected " + std::string(wanted) + ", found " + describe(found, text_), span,
                      std::move(hints)));
}

void Parser::fail_behind_value(std::string_view code, std::string_view wanted, std::vector<std::string> hints) {
    const Token found = peek();
    if (found.kind == TokenKind::assign) {
        std::vector<std::string> ways = {"a comparison is written '=='"};
        if (!open_.empty()) ways.push_back("an argument is named with ':', as in 'size: 20'");
        return fail(found, error("language.lone-equals", "found '=' inside an expression", span_of(found), ways));
    }
    if (found.kind == TokenKind::name) {
        const std::string_view word = bytes_of(found);
        if (word == "and") hints = {"'and' is written '&&'"};
        if (word == "or") hints = {"'or' is written '||'"};
        if (word == "mod") hints = {"a remainder is written 'mod(a, b)'"};
    }
    fail_expected(code, wanted, std::move(hints));
}

bool Parser::fail_if_unclosed() {
    if (open_.empty()) return false;
    const Token found = ahead_;
    const Token& open = open_.back();
    const bool is_wrong_partner = closes(found.kind) && found.kind != partner(open.kind);
    if (!is_wrong_partner && !ends_brackets(found.kind)) return false;
    fail_unclosed(open, found);
    return true;
}

void Parser::fail_unclosed(const Token& open, const Token& found) {
    const std::string sign(bytes_of(open));
    const std::string_view close = sign == "(" ? "')'" : sign == "[" ? "']'" : sign == "<" ? "'>'" : "'}'";
    fail(found, error("language.unclosed-bracket", "this '" + sign + "' is never closed", span_of(open),
                      {"expected " + std::string(close) + " before " + describe(found, text_)}));
}

void Parser::fail_in_list() {
    peek(ahead_mode_);
    if (ahead_.kind == TokenKind::invalid) return fail_expected("", "");
    if (fail_if_unclosed()) return;
    const Token open = open_.back();
    if (ahead_.kind != TokenKind::assign && !behind_brackets(ahead_.begin, open_.size())) {
        return fail_unclosed(open, ahead_);
    }
    const std::string wanted = open.kind == TokenKind::open_round ? "',' or ')'" : "',' or ']'";
    if (ahead_mode_ == LexMode::tag) return fail_expected("language.unexpected-token", wanted);
    std::vector<std::string> hints;
    const bool is_item = at(TokenKind::number) || at(TokenKind::name) || at(TokenKind::text) || at(TokenKind::colour);
    if (is_item && open.kind == TokenKind::open_round && taken_kind_ == TokenKind::name && !ahead_.starts_line) {
        hints = {"an argument is named with ':', as in 'size: 20'"};
    } else if (is_item) {
        hints = {"what stands in brackets is separated by ','"};
    }
    fail_behind_value("language.unexpected-token", wanted, std::move(hints));
}

void Parser::fail_trailing_comma(const Token& comma, std::vector<std::string> hints) {
    fail(comma,
         error("language.trailing-comma", "found a ',' with nothing behind it", span_of(comma), std::move(hints)));
}

// --- going on ------------------------------------------------------------------------------------------------------

// Looking ahead has a budget in proportion to the text, so that many failures stay linear together.
bool Parser::spend(const Token& token, std::uint32_t from) {
    const std::uint64_t cost = std::uint64_t{token.end} - from + 1;
    if (cost > lookahead_left_) return false;
    lookahead_left_ -= cost;
    return true;
}

std::optional<std::uint32_t> Parser::behind_brackets(std::uint32_t from, std::size_t depth) {
    while (true) {
        const Token token = read_token(text_, from, LexMode::value, true);
        if (ends_brackets(token.kind) || !spend(token, from)) return std::nullopt;
        if (opens(token.kind)) ++depth;
        if (closes(token.kind) && --depth == 0) return token.end;
        from = token.end;
    }
}

// Where every '{' of the text ends: found by one scan, when it is asked for first.
std::optional<std::uint32_t> Parser::end_of_block(std::uint32_t open) {
    if (!has_block_ends_) {
        has_block_ends_ = true;
        std::vector<std::size_t> around;
        for (std::uint32_t from = text_start(text_);;) {
            const Token token = read_token(text_, from, LexMode::value, true);
            if (token.kind == TokenKind::end_of_text) break;
            if (token.kind == TokenKind::open_curly) {
                around.push_back(block_ends_.size());
                block_ends_.push_back({token.begin, 0});
            } else if (token.kind == TokenKind::close_curly && !around.empty()) {
                block_ends_[around.back()].end = token.end;
                around.pop_back();
            }
            from = token.end;
        }
    }
    const auto found = std::lower_bound(block_ends_.begin(), block_ends_.end(), open,
                                        [](const BlockEnd& block, std::uint32_t at) { return block.begin < at; });
    if (found == block_ends_.end() || found->begin != open || found->end == 0) return std::nullopt;
    return found->end;
}

// Inside a block that nothing closes, one over several lines may have taken the outer one's '}'.
std::optional<std::uint32_t> Parser::behind_block(std::uint32_t open) {
    const std::optional<std::uint32_t> end = end_of_block(open);
    if (!end || blocks_.empty() || end_of_block(blocks_.front().open.begin)) return end;
    const bool has_lines = text_.substr(open, *end - open).find('\n') != std::string_view::npos;
    return has_lines ? std::nullopt : end;
}

void Parser::skip_failed_statement(const Token& first) {
    std::uint32_t at = failed_at_.begin;
    // Inside brackets that nothing closes only the end of a line can be trusted.
    bool is_lost = false;
    if (open_block_) {
        const std::optional<std::uint32_t> behind = behind_block(open_block_->begin);
        is_lost = !behind;
        if (behind && *behind > at) at = *behind;
    } else if (!open_.empty()) {
        const std::optional<std::uint32_t> behind = behind_brackets(at, open_.size());
        is_lost = !behind;
        if (behind) at = *behind;
    }
    open_.clear();
    open_block_.reset();
    nesting_ = 0;
    has_ahead_ = false;
    // A failure at the start of a later line is most likely the next statement.
    const bool is_next_statement = is_lost && failed_at_.starts_line && failed_at_.begin > first.begin;
    at_ = is_next_statement ? at : behind_line(at, is_lost);
    if (is_continued_) skip_continuation();
    if (rules_ == Rules::of_shapes) skip_right_side(first.begin);
}

// A rule goes on behind an arrow at the line's end.
void Parser::skip_right_side(std::uint32_t begin) {
    std::string_view skipped = text_.substr(begin, at_ - begin);
    skipped = skipped.substr(0, skipped.find_last_not_of(" \t\r") + 1);
    if (!skipped.ends_with("->") && !skipped.ends_with("\xE2\x86\x92")) return;
    if (!next_line_is_right_side()) return;
    skip_line_ends();
    at_ = behind_line(peek().begin, false);
    has_ahead_ = false;
}

std::uint32_t Parser::behind_line(std::uint32_t at, bool is_lost) {
    bool may_jump = true;
    while (true) {
        const Token token = read_token(text_, at, LexMode::value, false);
        std::optional<std::uint32_t> behind;
        switch (token.kind) {
            case TokenKind::end_of_text:
            case TokenKind::end_of_line:
                return token.begin;
            case TokenKind::semicolon:
                if (!is_lost) return token.begin;
                break;
            case TokenKind::close_curly:
                if (!blocks_.empty()) return token.begin;
                break;
            case TokenKind::open_round:
            case TokenKind::open_square:
                if (is_lost) break;
                behind = behind_brackets(token.end, 1);
                is_lost = !behind;
                break;
            case TokenKind::open_curly:
                if (!may_jump) break;
                behind = behind_block(token.begin);
                may_jump = behind.has_value();
                is_lost = is_lost || !behind;
                break;
            default:
                break;
        }
        at = behind.value_or(token.end);
    }
}

void Parser::skip_continuation() {
    const Token line_end = read_token(text_, at_, LexMode::tag, false);
    if (line_end.kind != TokenKind::end_of_line) return;
    const Token word = read_token(text_, line_end.end, LexMode::tag, false);
    bool goes_on = word.kind == TokenKind::open_square || word.kind == TokenKind::less ||
                   word.kind == TokenKind::open_curly || word.kind == TokenKind::star;
    if (word.kind == TokenKind::name) {
        // Tags or paths.
        const Token next = token_behind(word);
        goes_on = next.kind == TokenKind::comma || next.kind == TokenKind::end_of_line ||
                  next.kind == TokenKind::end_of_text || next.kind == TokenKind::close_curly ||
                  next.kind == TokenKind::slash || next.kind == TokenKind::open_square || next.kind == TokenKind::arrow;
    }
    if (goes_on) at_ = behind_line(word.begin, false);
}

}  // namespace filigree
