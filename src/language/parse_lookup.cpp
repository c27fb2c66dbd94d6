// Successors by what a picture or a table has: image wall L { 0..85 "T+b"; 86..170 "b" }.
#include <utility>

#include "language/parser.h"

namespace filigree {
namespace {

constexpr std::string_view image_example = "write it as in 'image wall L { 0..127 \"a\"; 128..255 \"b\" }'";
constexpr std::string_view data_example = "write it as in 'data heights { 0..1.5 \"a\", 1.5..9 \"b\" }'";

}  // namespace

// A word that is a value by itself, whatever sign stands behind it: the `over` of `image wall "a.png" over -5, 0, 9,
// 9`.
ExpressionPtr Parser::read_lone_word() {
    const std::optional<Name> word = read_name("a word");
    if (!word) return nullptr;
    return std::make_shared<const Expression>(Expression{word->span, NameReference{word->text}});
}

std::optional<WordLookup> Parser::read_lookup() {
    WordLookup lookup;
    lookup.is_image = accept_word("image");
    if (!lookup.is_image) take();
    const std::vector<std::string> hints = {std::string(lookup.is_image ? image_example : data_example)};
    std::optional<Name> map = read_name(lookup.is_image ? "the name of an image" : "the name of a table");
    if (!map) return std::nullopt;
    lookup.map = std::move(*map);
    if (lookup.is_image) {
        if (!at(TokenKind::name)) {
            fail_expected("language.missing-channel", "R, G, B, A or L", hints);
            return std::nullopt;
        }
        std::optional<Name> channel = read_name("a channel");
        if (!channel) return std::nullopt;
        lookup.channel = std::move(*channel);
    }
    if (!at(TokenKind::open_curly)) {
        fail_expected("language.missing-rows", "'{' and rows", hints);
        return std::nullopt;
    }
    const Token open = take();
    open_block_ = open;
    while (true) {
        while (accept(TokenKind::end_of_line) || accept(TokenKind::semicolon) || accept(TokenKind::comma)) {}
        if (at(TokenKind::end_of_text)) {
            fail_unclosed(open, peek());
            return std::nullopt;
        }
        if (at(TokenKind::close_curly)) {
            if (lookup.rows.empty()) {
                fail_expected("language.missing-rows", "a row", hints);
                return std::nullopt;
            }
            take();
            open_block_.reset();
            return lookup;
        }
        if (!read_lookup_row(lookup)) return std::nullopt;
    }
}

// 0..85 "T+b"
bool Parser::read_lookup_row(WordLookup& lookup) {
    WordLookupRow row;
    row.range = read_plain_range();
    if (!row.range) return false;
    std::optional<std::string> text = read_text("a word in quotes", row.text.span);
    if (!text) return false;
    row.text.text = std::move(*text);
    lookup.rows.push_back(std::move(row));
    const bool may_follow = at(TokenKind::end_of_line) || at(TokenKind::semicolon) || at(TokenKind::comma) ||
                            at(TokenKind::close_curly) || at(TokenKind::end_of_text);
    if (!may_follow) fail_expected("language.unexpected-token", "';' or '}'");
    return may_follow;
}

}  // namespace filigree
