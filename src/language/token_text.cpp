#include "language/token_text.h"

#include <algorithm>
#include <vector>

#include "base/unicode.h"

namespace filigree {

namespace {

constexpr std::uint32_t longest_shown = 40;  // bytes

std::string_view bytes_of(const Token& token, std::string_view text) {
    return text.substr(token.begin, token.end - token.begin);
}

std::string code_point_name(char32_t code_point) {
    constexpr char digits[] = "0123456789ABCDEF";
    std::string name;
    for (char32_t rest = code_point; rest != 0 || name.size() < 4; rest >>= 4)
        name.insert(name.begin(), digits[rest & 15]);
    return "U+" + name;
}

// What somebody who typed this character, or had a word processor type it, most likely meant.
std::vector<std::string> stray_hints(char32_t c) {
    switch (c) {
        case '\'':
        case 0x2018:
        case 0x2019:
        case 0x201C:
        case 0x201D:
        case 0x201E:
        case 0x00AB:
        case 0x00BB:
            return {"a text stands in straight double quotes: \"leaf.svg\""};
        case 0x00A0:
        case 0x2007:
        case 0x2009:
        case 0x202F:
        case 0x3000:
            return {"this is a special blank; use a plain one"};
        case 0x200B:
        case 0x200C:
        case 0x200D:
        case 0xFEFF:
            return {"this character has no width; delete it"};
        case 0x2012:
        case 0x2013:
        case 0x2014:
        case 0x2212:
            return {"a minus sign is written '-'"};
        case 0x00D7:
            return {"'times' is written '*', and the 'by' of a page size 'x'"};
        case 0x00F7:
            return {"'divided by' is written '/'"};
        case 0x2026:
            return {"a range is written with two dots: 5..9"};
        case 0x2264:
            return {"'at most' is written '<='"};
        case 0x2265:
            return {"'at least' is written '>='"};
        case 0x2260:
            return {"'unequal' is written '!='"};
        case 0x00B0:
            return {"degrees are written '30deg'"};
        case 0x21D2:
            return {"an arrow is written '->'"};
        default:
            return {};
    }
}

Diagnostic explain_stray(const Token& token, std::string_view text, SourceSpan span) {
    const char32_t c = unicode::decode(text, token.begin).code_point;
    return error("language.stray-character", "the character " + describe(token, text) + " is no part of the language",
                 span, stray_hints(c));
}

Diagnostic explain_foreign_sign(const Token& token, std::string_view text, SourceSpan span) {
    std::string hint;
    switch (text[token.begin]) {
        case '%':
            hint = "the remainder of a division is written 'mod(a, b)'";
            break;
        case '^':
            hint = "a power is written 'pow(a, b)'";
            break;
        default:
            hint = "'or' is written '||'";
            break;
    }
    return error("language.no-such-sign", "there is no operator " + describe(token, text), span, {hint});
}

Diagnostic explain_hash(const Token& token, std::string_view text, SourceSpan span) {
    const std::string found = describe(token, text);
    const bool is_behind_word =
        token.begin > 0 && !token.starts_line && text[token.begin - 1] != ' ' && text[token.begin - 1] != '\t';
    if (bytes_of(token, text) == "#" && is_behind_word) {
        return error("language.comment-blank", "found '#' without a blank before it, which starts no comment", span,
                     {"a comment starts with a blank, '#' and another blank"});
    }
    return error(
        "language.comment-blank", "found " + found + ", which is neither a comment nor a colour", span,
        {"a comment is written '# ...', with a blank behind the '#'", "a colour has 3, 4, 6 or 8 hexadecimal digits"});
}

Diagnostic explain_unit(const Token& token, std::string_view text, SourceSpan span) {
    const std::string_view bytes = bytes_of(token, text);
    std::size_t split = bytes.find_first_not_of("0123456789.");
    const bool has_exponent = split + 1 < bytes.size() && (bytes[split] == 'e' || bytes[split] == 'E') &&
                              std::string_view("0123456789+-").find(bytes[split + 1]) != std::string_view::npos;
    if (has_exponent) split = bytes.find_first_not_of("0123456789", split + 2);
    const std::string_view unit = bytes.substr(split);
    std::vector<std::string> hints;
    if (unit.size() > 1 && unit[0] == 'x' && unit.find_first_not_of("0123456789.", 1) == std::string_view::npos) {
        hints = {"a size takes blanks around its 'x': 210mm x 297mm"};
    } else {
        hints = did_you_mean(unit, {"mm", "cm", "m", "in", "pt", "px", "deg", "rad", "turn", "KB", "MB", "GB", "s"});
        if (hints.empty()) hints = {"the units are mm, cm, m, in, pt, px, deg, rad, turn, %, KB, MB, GB and s"};
    }
    return error("language.bad-unit", describe(token, text) + " is no number, for there is no unit " + in_quotes(unit),
                 span, hints);
}

std::optional<char32_t> hexadecimal(std::string_view digits) {
    if (digits.empty() || digits.size() > 6) return std::nullopt;
    char32_t value = 0;
    for (const char c : digits) {
        char32_t digit = 0;
        if (c >= '0' && c <= '9') {
            digit = static_cast<char32_t>(c - '0');
        } else if (c >= 'a' && c <= 'f') {
            digit = static_cast<char32_t>(c - 'a' + 10);
        } else if (c >= 'A' && c <= 'F') {
            digit = static_cast<char32_t>(c - 'A' + 10);
        } else {
            return std::nullopt;
        }
        value = value * 16 + digit;
    }
    return value;
}

}  // namespace

std::string in_quotes(std::string_view bytes) {
    std::string shown = "'";
    std::size_t i = 0;
    while (i < bytes.size() && i < longest_shown) {
        const unicode::Decoded decoded = unicode::decode(bytes, i);
        const bool is_control = decoded.code_point < 0x20 || (decoded.code_point >= 0x7F && decoded.code_point < 0xA0);
        shown += is_control || !decoded.valid ? std::string_view("?") : bytes.substr(i, decoded.length);
        i += decoded.length;
    }
    return shown + (i < bytes.size() ? "...'" : "'");
}

std::string describe(const Token& token, std::string_view text) {
    switch (token.kind) {
        case TokenKind::end_of_text:
            return "the end of the text";
        case TokenKind::end_of_line:
            return "the end of the line";
        case TokenKind::text:
            return "a text";
        default:
            break;
    }
    if (token.trouble == Trouble::stray_character) {
        const char32_t c = unicode::decode(text, token.begin).code_point;
        const bool is_seen = (c > 0x20 && c < 0x7F) || c == 0x00D7 || c == 0x00F7 || c == 0x00B0 || c == 0x2026 ||
                             (c >= 0x2018 && c <= 0x201E) || (c >= 0x2190 && c <= 0x22FF);
        return is_seen ? in_quotes(bytes_of(token, text)) : code_point_name(c);
    }
    if (token.trouble == Trouble::unterminated_text) return "a text without end";
    return in_quotes(bytes_of(token, text));
}

Diagnostic explain(const Token& token, std::string_view text, std::uint32_t file) {
    const SourceSpan span{file, token.begin, token.end};
    switch (token.trouble) {
        case Trouble::foreign_sign:
            return explain_foreign_sign(token, text, span);
        case Trouble::hash:
            return explain_hash(token, text, span);
        case Trouble::bad_unit:
            return explain_unit(token, text, span);
        case Trouble::unterminated_text:
            return error("language.unterminated-text", "this text has no closing '\"' on its line", span,
                         {"inside a text a quote is written \\\" and a line end \\n"});
        case Trouble::too_large:
            return error("language.number-too-large", "the number " + describe(token, text) + " is too large", span,
                         {"numbers go up to 1.7e308"});
        default:
            return explain_stray(token, text, span);
    }
}

Result<std::string> unescape(const Token& token, std::string_view text, std::uint32_t file) {
    const std::string_view bytes = text.substr(token.begin + 1, token.end - token.begin - 2);
    std::string result;
    result.reserve(bytes.size());
    for (std::size_t i = 0; i < bytes.size();) {
        const std::size_t escape = std::min(bytes.find('\\', i), bytes.size());
        result += bytes.substr(i, escape - i);
        i = escape;
        if (i == bytes.size()) break;

        const auto fail = [&](std::size_t length, std::string message) {
            const std::uint32_t begin = token.begin + 1 + static_cast<std::uint32_t>(i);
            return error(
                "language.bad-escape", std::move(message), {file, begin, begin + static_cast<std::uint32_t>(length)},
                {"the escapes are \\\", \\\\, \\n and \\u{...} with the number of a character, as in \\u{e9}"});
        };
        const unicode::Decoded next = unicode::decode(bytes, i + 1);  // a closed text never ends in its escape sign
        if (next.code_point == '"' || next.code_point == '\\') {
            result += static_cast<char>(next.code_point);
            i += 2;
        } else if (next.code_point == 'n') {
            result += '\n';
            i += 2;
        } else if (next.code_point == 'u') {
            const std::size_t close = bytes.substr(i, 12).find('}');
            if (i + 2 >= bytes.size() || bytes[i + 2] != '{' || close == std::string_view::npos) {
                return fail(2, "found '\\u' without a number in braces");
            }
            const std::optional<char32_t> code_point = hexadecimal(bytes.substr(i + 3, close - 3));
            const bool is_character = code_point && *code_point != 0 && *code_point <= 0x10FFFF &&
                                      !(*code_point >= 0xD800 && *code_point <= 0xDFFF);
            if (!is_character) return fail(close + 1, "there is no character " + in_quotes(bytes.substr(i, close + 1)));
            unicode::append_utf8(result, *code_point);
            i += close + 1;
        } else {
            return fail(1 + next.length, "there is no escape " + in_quotes(bytes.substr(i, 1 + next.length)));
        }
    }
    return result;
}

Colour colour_of(const Token& token, std::string_view text) {
    const std::string_view digits = text.substr(token.begin + 1, token.end - token.begin - 1);
    const std::size_t width = digits.size() <= 4 ? 1 : 2;
    const auto channel = [&](std::size_t index) {
        const std::optional<char32_t> value = hexadecimal(digits.substr(index * width, width));
        return static_cast<std::uint8_t>(value.value_or(0) * (width == 1 ? 17 : 1));
    };
    Colour colour{channel(0), channel(1), channel(2), 255};
    if (digits.size() == 4 || digits.size() == 8) colour.alpha = channel(3);
    return colour;
}

}  // namespace filigree
