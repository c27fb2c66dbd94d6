// style TAG, TAG [when CONDITION] { property: value; ... }
#include <utility>

#include "language/parser.h"
#include "language/token_text.h"

namespace filigree {

std::optional<StyleStatement> Parser::read_style() {
    StyleStatement style;
    do {
        if (at(TokenKind::star, LexMode::tag)) {
            style.tags.push_back({"*", span_of(take(LexMode::tag))});
            continue;
        }
        std::optional<Name> tag = read_tag(style.tags.empty() ? "behind 'style'" : "behind ','");
        if (!tag) return std::nullopt;
        style.tags.push_back(std::move(*tag));
    } while (accept(TokenKind::comma));
    if (accept_word("when")) {
        style.condition = read_expression();
        if (!style.condition) return std::nullopt;
    }
    if (!at(TokenKind::open_curly)) {
        const std::string wanted = style.condition ? "'{' and properties" : "',', 'when' or '{' and properties";
        fail_behind_value("language.missing-brace", wanted, {"a style is written 'style leaf { fill: black }'"});
        return std::nullopt;
    }
    if (!read_style_block(style)) return std::nullopt;
    return style;
}

bool Parser::read_style_block(StyleStatement& style) {
    open_block_ = take();
    while (true) {
        skip_statement_ends();
        if (accept(TokenKind::close_curly)) break;
        if (at(TokenKind::end_of_text)) {
            fail_unclosed(*open_block_, peek());
            return false;
        }
        std::optional<StyleProperty> property = read_property();
        if (!property) return false;
        style.properties.push_back(std::move(*property));
    }
    open_block_.reset();
    return true;
}

std::optional<StyleProperty> Parser::read_property() {
    const Token first = peek(LexMode::property);
    // A line that is no property was meant to stand behind the block, if nothing ends the block later.
    const auto fail_here = [&](std::string_view code, std::string_view wanted, std::vector<std::string> hints) {
        const Token found = ahead_;
        const bool is_open = found.kind != TokenKind::invalid && !behind_block(open_block_->begin);
        if (is_open) {
            fail_unclosed(*open_block_, found);
            failed_at_ = first;
        } else {
            fail_behind_value(code, wanted, std::move(hints));
        }
        return std::nullopt;
    };
    const std::vector<std::string> hints = {"a property is written 'name: value', as in 'fill: black'"};
    if (!at(TokenKind::name, LexMode::property)) return fail_here("language.missing-name", "a property or '}'", hints);
    std::optional<Name> name = read_name("a property", LexMode::property);
    if (!name) return std::nullopt;
    if (!accept(TokenKind::colon)) return fail_here("language.missing-colon", "':' and a value", hints);
    ExpressionPtr value = read_expression();
    if (!value) return std::nullopt;
    const bool is_end = at(TokenKind::end_of_line) || at(TokenKind::semicolon) || at(TokenKind::close_curly);
    if (!is_end) return fail_here("language.unexpected-token", "';', a new line or '}'", {});
    return StyleProperty{std::move(*name), std::move(value)};
}

}  // namespace filigree
