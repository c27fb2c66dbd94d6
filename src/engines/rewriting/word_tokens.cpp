#include "engines/rewriting/word_tokens.h"

#include <algorithm>

#include "base/number_text.h"

namespace filigree::rewriting {
namespace {

bool is_of_number(char32_t c) {
    return (c >= U'0' && c <= U'9') || c == U'.' || c == U'+' || c == U'-' || c == U'e' || c == U'E';
}

struct Shrink {
    std::size_t end = 0;  // behind the bracket
    double factor = 0;
};

// A shrink that begins at a '~'. Looks no further than a '~' could stand, so that a text is read once.
std::optional<Shrink> shrink_at(std::u32string_view text, std::size_t at) {
    if (at + 1 >= text.size() || text[at + 1] != U'(') return std::nullopt;
    std::string number;
    std::size_t end = at + 2;
    for (; end < text.size() && is_of_number(text[end]); ++end) number += static_cast<char>(text[end]);
    if (end == text.size() || text[end] != U')') return std::nullopt;
    const std::optional<double> factor = parse_number(number);
    if (!factor || !(*factor > 0)) return std::nullopt;
    return Shrink{end + 1, *factor};
}

}  // namespace

bool is_axis_letter(char32_t symbol) {
    return symbol == U'P' || symbol == U'T' || symbol == U'D' || symbol == U'X' || symbol == U'Y' || symbol == U'Z';
}

bool is_turn_modifier(char32_t symbol) {
    return symbol == U'+' || symbol == U'-' || symbol == U'<' || symbol == U'>' || symbol == U'?';
}

std::vector<EditToken> edit_tokens(std::u32string_view word) {
    std::vector<EditToken> tokens;
    tokens.reserve(word.size());
    for (std::size_t at = 0; at < word.size();) {
        const std::size_t begin = at;
        const bool has_modifiers = is_axis_letter(word[at]);
        const std::optional<Shrink> shrink = word[at] == U'~' ? shrink_at(word, at) : std::nullopt;
        at = shrink ? shrink->end : at + 1;
        while (at < word.size() && (word[at] == U'=' || (has_modifiers && is_turn_modifier(word[at])))) ++at;
        tokens.push_back({static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(at)});
    }
    return tokens;
}

std::u32string_view range_text(std::u32string_view word, const std::vector<EditToken>& tokens, TokenRange range) {
    if (range.begin >= range.end) return {};
    return token_text(word, {tokens[range.begin].begin, tokens[range.end - 1].end});
}

std::optional<double> shrink_factor(std::u32string_view token) {
    if (token.empty() || token.front() != U'~') return std::nullopt;
    const std::optional<Shrink> shrink = shrink_at(token, 0);
    if (!shrink || token.find_first_not_of(U'=', shrink->end) != std::u32string_view::npos) return std::nullopt;
    return shrink->factor;
}

std::vector<std::uint32_t> bracket_partners(std::u32string_view word, const std::vector<EditToken>& tokens) {
    std::vector<std::uint32_t> partners(tokens.size(), no_token);
    std::vector<std::uint32_t> open;
    for (std::uint32_t i = 0; i < tokens.size(); ++i) {
        const char32_t symbol = token_symbol(word, tokens[i]);
        if (symbol == U'[') open.push_back(i);
        if (symbol != U']' || open.empty()) continue;
        partners[i] = open.back();
        partners[open.back()] = i;
        open.pop_back();
    }
    return partners;
}

BracketShape bracket_shape(std::u32string_view text) {
    BracketShape shape;
    for (const char32_t c : text) {
        if (c == U'[') {
            ++shape.opening;
        } else if (c == U']' && shape.opening > 0) {
            --shape.opening;
        } else if (c == U']') {
            ++shape.closing;
        }
    }
    return shape;
}

bool is_balanced(std::u32string_view text) { return bracket_shape(text) == BracketShape{}; }

std::optional<TokenRange> balanced_range(std::u32string_view word, const std::vector<EditToken>& tokens,
                                         TokenRange range) {
    const std::vector<std::uint32_t> partners = bracket_partners(word, tokens);
    std::uint32_t seen_begin = range.begin;
    std::uint32_t seen_end = range.begin;
    while (seen_begin > range.begin || seen_end < range.end) {
        const std::uint32_t i = seen_end < range.end ? seen_end++ : --seen_begin;
        if (!is_bracket(token_symbol(word, tokens[i]))) continue;
        if (partners[i] == no_token) return std::nullopt;
        range.begin = std::min(range.begin, partners[i]);
        range.end = std::max(range.end, partners[i] + 1);
    }
    return range;
}

}  // namespace filigree::rewriting
