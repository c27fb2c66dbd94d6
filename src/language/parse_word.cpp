// Names, tags and texts.
#include "base/unicode.h"
#include "language/parser.h"
#include "language/token_text.h"

namespace filigree {

// A bound on names also bounds the time of bringing them into normal form, which is not linear.
std::optional<std::string> Parser::normal_name(const Token& token) {
    if (token.end - token.begin > max_name_bytes) {
        fail(token, error("language.long-name", "this name has more than 1000 bytes", span_of(token)));
        return std::nullopt;
    }
    return unicode::normalise(bytes_of(token));
}

std::optional<Name> Parser::read_name(std::string_view wanted, LexMode mode) {
    if (!at(TokenKind::name, mode)) {
        const bool has_digit = ahead_.kind == TokenKind::number || ahead_.trouble == Trouble::bad_unit;
        if (has_digit) {
            fail(ahead_, error("language.missing-name",
                               "expected " + std::string(wanted) + ", found " + describe(ahead_, text_),
                               span_of(ahead_), {"a name starts with a letter or '_'"}));
        } else {
            fail_expected("language.missing-name", wanted);
        }
        return std::nullopt;
    }
    const Token token = take(mode);
    std::optional<std::string> name = normal_name(token);
    if (!name) return std::nullopt;
    return Name{std::move(*name), span_of(token)};
}

bool Parser::is_tag(const Token& token, std::string_view place) {
    const std::string_view bytes = bytes_of(token);
    if (token.kind == TokenKind::name && bytes == "_") {
        fail(token, error("language.bad-tag", "'_' drops an output, it is no tag", span_of(token)));
    } else if (token.kind == TokenKind::name && bytes.find_first_not_of("0123456789") == std::string_view::npos) {
        fail(token,
             error("language.bad-tag", describe(token, text_) + " is no tag, for it has only digits", span_of(token),
                   {"a tag has a letter or '_' as well, as in '_" + in_quotes(bytes).substr(1)}));
    } else if (token.kind == TokenKind::text) {
        fail_expected("language.missing-tag", "a tag " + std::string(place), {"tags are written without quotes"});
    } else if (token.kind == TokenKind::less) {
        fail_expected("language.missing-tag", "a tag " + std::string(place),
                      {"only the tags behind the arrow may stand in '<' and '>'"});
    } else if (token.kind != TokenKind::name) {
        fail_expected("language.missing-tag", "a tag " + std::string(place));
    }
    return !has_failed_;
}

std::optional<Name> Parser::read_tag(std::string_view place) {
    const Token token = peek(LexMode::tag);
    if (!is_tag(token, place)) return std::nullopt;
    return read_name("a tag", LexMode::tag);
}

std::optional<std::string> Parser::read_text(std::string_view wanted, SourceSpan& span) {
    if (!at(TokenKind::text)) {
        fail_expected("language.missing-text", wanted);
        return std::nullopt;
    }
    const Token token = take();
    span = span_of(token);
    Result<std::string> text = unescape(token, text_, file_);
    if (!text) {
        fail(token, text.diagnostics().front());
        return std::nullopt;
    }
    return std::move(*text);
}

}  // namespace filigree
