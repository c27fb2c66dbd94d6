#include "language/lexer.h"

#include "base/number_text.h"
#include "base/unicode.h"

namespace filigree {

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr std::string_view arrow_sign = "\xE2\x86\x92";  // U+2192

bool is_ascii_digit(char c) { return c >= '0' && c <= '9'; }
bool is_ascii_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
bool is_hexadecimal(char c) { return is_ascii_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); }

class Reader {
public:
    Reader(std::string_view text, std::uint32_t offset) : text_(text), at_(offset) {}

    Token read(LexMode mode, bool lines_go_on) {
        starts_line_ = at_ == text_start(text_) || (at_ > 0 && text_[at_ - 1] == '\n');
        skip_blanks(lines_go_on);
        begin_ = at_;
        if (at_ == size()) return token(TokenKind::end_of_text);
        const char c = text_[at_];
        if (c == '\n') return take(1, TokenKind::end_of_line);
        if (c == '"') return quoted();
        if (mode == LexMode::path) {
            if (starts_path()) return path();
        } else if (mode == LexMode::tag) {
            if (skip_word()) return token(TokenKind::name);
        } else {
            if (is_ascii_digit(c) || (c == '.' && is_ascii_digit(next(1)))) return number();
            if (skip_word()) {
                if (mode == LexMode::property) skip_hyphenated();
                return token(TokenKind::name);
            }
        }
        if (c == '#') return hash();
        if (text_.substr(at_).starts_with(arrow_sign)) {
            return take(static_cast<std::uint32_t>(arrow_sign.size()), TokenKind::arrow);
        }
        return sign(c);
    }

private:
    std::uint32_t size() const { return static_cast<std::uint32_t>(text_.size()); }
    char next(std::uint32_t ahead) const { return at_ + ahead < size() ? text_[at_ + ahead] : '\0'; }

    Token token(TokenKind kind) const {
        return {.kind = kind, .starts_line = starts_line_, .begin = begin_, .end = at_};
    }
    Token take(std::uint32_t bytes, TokenKind kind) {
        at_ += bytes;
        return token(kind);
    }
    Token invalid(Trouble trouble) const {
        Token bad = token(TokenKind::invalid);
        bad.trouble = trouble;
        return bad;
    }

    void skip_blanks(bool lines_go_on) {
        while (at_ < size()) {
            const char c = text_[at_];
            if (c == '#' && is_comment()) {
                const std::size_t line_end = text_.find('\n', at_);
                at_ = line_end == std::string_view::npos ? size() : static_cast<std::uint32_t>(line_end);
            } else if (c == '\n' && lines_go_on) {
                ++at_;
                starts_line_ = true;
            } else if (is_blank(c)) {
                ++at_;
            } else {
                return;
            }
        }
    }
    bool is_comment() const {
        if (starts_line_ && next(1) == '#') return true;
        const bool may_start = starts_line_ || (at_ > 0 && is_blank(text_[at_ - 1]));
        return may_start && (at_ + 1 == size() || next(1) == '\n' || is_blank(next(1)));
    }

    // Letters, digits and '_'; whether there was one.
    bool skip_word() {
        const std::uint32_t from = at_;
        while (at_ < size()) {
            const char c = text_[at_];
            if (is_ascii_letter(c) || is_ascii_digit(c) || c == '_') {
                ++at_;
            } else if (static_cast<unsigned char>(c) >= 0x80) {
                const unicode::Decoded decoded = unicode::decode(text_, at_);
                if (!decoded.valid || !unicode::is_letter(decoded.code_point)) break;
                at_ += decoded.length;
            } else {
                break;
            }
        }
        return at_ > from;
    }
    void skip_hyphenated() {
        while (next(0) == '-' && is_ascii_letter(next(1))) {
            ++at_;
            skip_word();
        }
    }
    void skip_digits() {
        while (at_ < size() && is_ascii_digit(text_[at_])) ++at_;
    }

    // What is no part of any path: '=', ';', braces, arrows, blanks, and a comma before these.
    bool ends_path(std::uint32_t at) const {
        if (at < size() && text_[at] == ',') ++at;
        if (at == size() || std::string_view("=;{} \t\r\n").find(text_[at]) != std::string_view::npos) return true;
        const std::string_view rest = text_.substr(at);
        return rest.starts_with("->") || rest.starts_with(arrow_sign);
    }
    // Neither a bracket, a colour or a comma, which messages name as such.
    bool starts_path() const {
        return !ends_path(at_) && std::string_view("#,()[]").find(text_[at_]) == std::string_view::npos;
    }
    Token path() {
        while (!ends_path(at_)) ++at_;
        return token(TokenKind::path);
    }

    Token number() {
        skip_digits();
        if (next(0) == '.' && next(1) != '.') {
            ++at_;
            skip_digits();
        }
        const char sign = next(1);
        if ((next(0) == 'e' || next(0) == 'E') &&
            (is_ascii_digit(sign) || ((sign == '+' || sign == '-') && is_ascii_digit(next(2))))) {
            at_ += 2;
            skip_digits();
        }
        const std::optional<double> value = parse_number(text_.substr(begin_, at_ - begin_));

        const std::uint32_t unit_begin = at_;
        if (!skip_word() && next(0) == '%') {
            ++at_;
            if (skip_word()) at_ = unit_begin;  // 5%2 is no percentage: the sign is reported instead
        }
        Unit unit = Unit::none;
        if (at_ > unit_begin) {
            const std::optional<Unit> found = unit_named(text_.substr(unit_begin, at_ - unit_begin));
            if (!found) return invalid(Trouble::bad_unit);
            unit = *found;
        }
        if (!value) return invalid(Trouble::too_large);
        Token result = token(TokenKind::number);
        result.number = *value;
        result.unit = unit;
        return result;
    }
    Token quoted() {
        ++at_;
        while (at_ < size() && text_[at_] != '\n') {
            if (text_[at_] == '"') return take(1, TokenKind::text);
            const bool is_escape = text_[at_] == '\\' && at_ + 1 < size() && text_[at_ + 1] != '\n';
            at_ += is_escape ? 2 : 1;
        }
        if (text_[at_ - 1] == '\r') --at_;
        return invalid(Trouble::unterminated_text);
    }

    Token hash() {
        ++at_;
        const std::uint32_t from = at_;
        skip_word();
        const std::string_view digits = text_.substr(from, at_ - from);
        bool is_colour = digits.size() == 3 || digits.size() == 4 || digits.size() == 6 || digits.size() == 8;
        for (const char c : digits) is_colour = is_colour && is_hexadecimal(c);
        return is_colour ? token(TokenKind::colour) : invalid(Trouble::hash);
    }

    Token sign(char c) {
        switch (c) {
            case '-':
                return next(1) == '>' ? take(2, TokenKind::arrow) : take(1, TokenKind::minus);
            case '.':
                return next(1) == '.' ? take(2, TokenKind::range) : take(1, TokenKind::dot);
            case '=':
                return next(1) == '=' ? take(2, TokenKind::equal) : take(1, TokenKind::assign);
            case '!':
                return next(1) == '=' ? take(2, TokenKind::unequal) : take(1, TokenKind::invert);
            case '<':
                return next(1) == '=' ? take(2, TokenKind::less_equal) : take(1, TokenKind::less);
            case '>':
                return next(1) == '=' ? take(2, TokenKind::greater_equal) : take(1, TokenKind::greater);
            case '&':
                return next(1) == '&' ? take(2, TokenKind::both) : take(1, TokenKind::meet);
            case '|':
                if (next(1) == '|') return take(2, TokenKind::either);
                break;
            case '?':
                return take(1, TokenKind::question);
            case ':':
                return take(1, TokenKind::colon);
            case ',':
                return take(1, TokenKind::comma);
            case ';':
                return take(1, TokenKind::semicolon);
            case '+':
                return take(1, TokenKind::plus);
            case '*':
                return take(1, TokenKind::star);
            case '/':
                return take(1, TokenKind::slash);
            case '(':
                return take(1, TokenKind::open_round);
            case ')':
                return take(1, TokenKind::close_round);
            case '[':
                return take(1, TokenKind::open_square);
            case ']':
                return take(1, TokenKind::close_square);
            case '{':
                return take(1, TokenKind::open_curly);
            case '}':
                return take(1, TokenKind::close_curly);
            default:
                break;
        }
        at_ += unicode::decode(text_, at_).length;
        return invalid(c == '%' || c == '^' || c == '|' ? Trouble::foreign_sign : Trouble::stray_character);
    }

    std::string_view text_;
    std::uint32_t at_;
    std::uint32_t begin_ = 0;
    bool starts_line_ = false;
};

}  // namespace

Token read_token(std::string_view text, std::uint32_t offset, LexMode mode, bool lines_go_on) {
    return Reader(text, offset).read(mode, lines_go_on);
}

std::uint32_t text_start(std::string_view text) {
    return text.starts_with(byte_order_mark) ? static_cast<std::uint32_t>(byte_order_mark.size()) : 0;
}

std::optional<Unit> unit_named(std::string_view spelling) {
    struct Row {
        std::string_view spelling;
        Unit unit;
    };
    constexpr Row rows[] = {
        {"mm", Unit::mm},       {"cm", Unit::cm},     {"m", Unit::m},         {"in", Unit::inch},
        {"pt", Unit::pt},       {"px", Unit::px},     {"deg", Unit::deg},     {"rad", Unit::rad},
        {"turn", Unit::turn},   {"%", Unit::percent}, {"KB", Unit::kilobyte}, {"MB", Unit::megabyte},
        {"GB", Unit::gigabyte}, {"s", Unit::second},
    };
    for (const Row& row : rows) {
        if (row.spelling == spelling) return row.unit;
    }
    return std::nullopt;
}

}  // namespace filigree
