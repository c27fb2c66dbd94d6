// Words as texts of edit tokens: what the edits of words (word_edits.h) see as one piece.
//
// An axis letter with the modifiers and '=' that follow it is one token (`T++`, `P<=`): a turn that is torn apart turns
// something else. `~(0.9)`, the shrink, is one too. Every other symbol is a token with its '=', brackets included (Fig.
// 17 of Roncoroni and Crousse comes out in no other way). '=' with nothing before it is a token of its own.
//
// Words are UTF-32 without blanks. Any text has tokens: they lie side by side and make up the text. What looks like a
// shrink but has no factor above 0 is read symbol by symbol.
//
// The shrink `~(factor)` scales the steps that follow it, up to the end of its branch; one after another multiply.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace filigree::rewriting {

struct EditToken {
    std::uint32_t begin = 0;  // in code points
    std::uint32_t end = 0;    // one past the last

    bool operator==(const EditToken&) const = default;
};

// Half open, in tokens of one word.
struct TokenRange {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;

    bool operator==(const TokenRange&) const = default;
};

constexpr std::uint32_t no_token = UINT32_MAX;

bool is_axis_letter(char32_t symbol);    // P T D X Y Z
bool is_turn_modifier(char32_t symbol);  // + - < > ?
constexpr bool is_bracket(char32_t symbol) { return symbol == U'[' || symbol == U']'; }

std::vector<EditToken> edit_tokens(std::u32string_view word);

inline std::u32string_view token_text(std::u32string_view word, EditToken token) {
    return word.substr(token.begin, token.end - token.begin);
}
inline char32_t token_symbol(std::u32string_view word, EditToken token) { return word[token.begin]; }

// What stands in a range, which must lie inside the word.
std::u32string_view range_text(std::u32string_view word, const std::vector<EditToken>& tokens, TokenRange range);

// The factor of a token that is a shrink.
std::optional<double> shrink_factor(std::u32string_view token);

// For every token, the bracket that belongs to it; `no_token` for what is no bracket or has no partner.
std::vector<std::uint32_t> bracket_partners(std::u32string_view word, const std::vector<EditToken>& tokens);

// What is left of a text's brackets when pairs are struck out: so many `]`, then so many `[`. Two texts of one shape
// may stand for each other in any word without changing what its other brackets enclose.
struct BracketShape {
    std::uint64_t closing = 0;
    std::uint64_t opening = 0;

    bool operator==(const BracketShape&) const = default;
};
BracketShape bracket_shape(std::u32string_view text);
bool is_balanced(std::u32string_view text);

// The smallest range around `range` in which all brackets have their partners; none where one has no partner at all.
std::optional<TokenRange> balanced_range(std::u32string_view word, const std::vector<EditToken>& tokens,
                                         TokenRange range);

}  // namespace filigree::rewriting
