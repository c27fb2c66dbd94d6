// For tests alone: words of edit tokens at random, balanced or not, and as UTF-8.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/test_cases.h"
#include "base/unicode.h"
#include "engines/rewriting/word_tokens.h"

namespace filigree::rewriting {

inline std::string utf8(std::u32string_view text) {
    std::string out;
    for (const char32_t c : text) unicode::append_utf8(out, c);
    return out;
}
inline std::u32string utf32(std::string_view text) {
    std::u32string out;
    for (std::size_t at = 0; at < text.size();) {
        const unicode::Decoded decoded = unicode::decode(text, at);
        out += decoded.code_point;
        at += decoded.length;
    }
    return out;
}

inline std::vector<std::u32string> texts_of(std::u32string_view word) {
    std::vector<std::u32string> texts;
    for (const EditToken token : edit_tokens(word)) texts.emplace_back(token_text(word, token));
    return texts;
}

inline std::u32string_view one_of(CaseRandom& random, const std::vector<std::u32string_view>& texts) {
    return texts[random.index(texts.size())];
}

// Balanced, of up to `most` pieces that stay tokens wherever they stand: no bare modifiers, no leading '='.
inline std::u32string random_word(CaseRandom& random, std::uint32_t most) {
    static const std::vector<std::u32string_view> pieces = {
        U"a", U"a", U"b", U"b", U"c",   U"F",  U"\u00F1", U"a=", U"b==", U"T+", U"P<",     U"D--", U"X",
        U"Y", U"Z", U"T", U"|", U"T+=", U"X?", U"[",      U"[",  U"]",   U"]",  U"~(0.5)", U"~",   U"[="};
    std::u32string word;
    int depth = 0;
    for (std::uint32_t left = random.below(most + 1); left > 0; --left) {
        const std::u32string_view piece = one_of(random, pieces);
        if (piece.front() == U']' && depth == 0) continue;
        depth += piece.front() == U'[' ? 1 : piece.front() == U']' ? -1 : 0;
        word += piece;
    }
    word.append(static_cast<std::size_t>(depth), U']');
    return word;
}

// Anything: stray brackets, bare modifiers, halves of shrinks, code points that are none.
inline std::u32string random_garbage(CaseRandom& random, std::uint32_t most) {
    static const std::u32string_view symbols = U"aabbc[[]]]==+-<>?TPDXYZ~(()0.5e \u00F1\U0001F300";
    std::u32string word;
    for (std::uint32_t left = random.below(most + 1); left > 0; --left) {
        word += random.below(50) == 0 ? static_cast<char32_t>(random.bits()) : symbols[random.index(symbols.size())];
    }
    return word;
}

// Both brackets of every pair lie in it, or none.
inline TokenRange random_balanced_range(CaseRandom& random, std::u32string_view word) {
    const std::vector<EditToken> tokens = edit_tokens(word);
    const auto count = static_cast<std::uint32_t>(tokens.size());
    const std::uint32_t begin = random.below(count + 1);
    const TokenRange range = {begin, begin + random.below(std::min(count - begin, 9U) + 1)};
    return balanced_range(word, tokens, range).value();
}

}  // namespace filigree::rewriting
