// The lexer: from a byte offset to the next token, in the mode that the parser asks for.
//
// It keeps no state, so the parser may read the same place again in another mode: `in` after `->` is a tag,
// `0_medium_poly` is one tag there and a wrong number elsewhere. What cannot be a token comes out as one of
// kind `invalid` that says why (token_text.h words it); every token but the end takes at least one byte.
//
// Blanks and comments are skipped: `#` at the start of a line or behind a blank, if a blank or the line's end
// follows, and any run of two or more `#` at the start of a line. A carriage return counts as a blank.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "language/expression.h"

namespace filigree {

enum class LexMode : std::uint8_t {
    value,     // numbers, names, colours and texts
    tag,       // a run of letters, digits and '_' is one token, whatever it starts with
    property,  // a name may go on behind a '-': stroke-width
    path,      // what stands together without blanks is one token, up to what ends a path: quads[1,3]/outline.distance
};

enum class TokenKind : std::uint8_t {
    end_of_text,
    end_of_line,
    number,
    name,
    path,
    text,
    colour,
    arrow,
    range,
    question,
    colon,
    comma,
    semicolon,
    dot,
    assign,
    equal,
    unequal,
    less,
    less_equal,
    greater,
    greater_equal,
    both,
    either,
    invert,
    plus,
    minus,
    star,
    slash,
    meet,
    open_round,
    close_round,
    open_square,
    close_square,
    open_curly,
    close_curly,
    invalid,
};

enum class Trouble : std::uint8_t {
    none,
    stray_character,    // one that is no part of the language
    foreign_sign,       // % ^ | : an operator elsewhere, not here
    unterminated_text,  // a quote without its partner on the line
    hash,               // '#' that starts neither a colour nor a comment
    bad_unit,           // 5x: letters behind a number that are no unit
    too_large,          // a number beyond 1.8e308
};

struct Token {
    TokenKind kind = TokenKind::end_of_text;
    Trouble trouble = Trouble::none;
    Unit unit = Unit::none;    // of a number
    bool starts_line = false;  // nothing but blanks before it on its line
    std::uint32_t begin = 0, end = 0;
    double number = 0;  // before its unit
};

// The first token at or behind `offset`, which must lie between two tokens of `text` (valid UTF-8 of less than
// 4 GiB). Line ends are skipped like blanks where `lines_go_on`. Time: linear in what is passed over.
Token read_token(std::string_view text, std::uint32_t offset, LexMode mode, bool lines_go_on);

// Where the text proper starts: behind a byte order mark.
std::uint32_t text_start(std::string_view text);

// The unit with this spelling: mm, in, deg, %, KB, ...
std::optional<Unit> unit_named(std::string_view spelling);

}  // namespace filigree
