#include "engines/rewriting/word.h"

#include <algorithm>
#include <cstring>

#include "base/unicode.h"

namespace filigree::rewriting {

// Most stand near the start; the others are looked for one by one while there are few, which goes many times as fast.
std::array<bool, max_symbols> symbols_in(const Word& word, std::size_t known) {
    constexpr std::size_t start = 1 << 14;
    constexpr std::ptrdiff_t few = 8;
    std::array<bool, max_symbols> stands{};
    const std::vector<Symbol>& symbols = word.symbols;
    const std::size_t seen = std::min(start, symbols.size());
    std::for_each_n(symbols.begin(), seen, [&](Symbol symbol) { stands[symbol] = true; });
    const std::size_t left = symbols.size() - seen;
    if (left == 0) return stands;
    if (std::count(stands.begin(), stands.begin() + known, false) > few) {
        for (const Symbol symbol : symbols) stands[symbol] = true;
        return stands;
    }
    for (std::size_t s = 0; s < known; ++s) {
        if (!stands[s]) stands[s] = std::memchr(&symbols[seen], static_cast<int>(s), left) != nullptr;
    }
    return stands;
}

std::string to_text(const Word& word, const Alphabet& alphabet) {
    std::vector<std::string> texts(alphabet.size());
    for (std::size_t s = 0; s < texts.size(); ++s) {
        unicode::append_utf8(texts[s], alphabet[static_cast<Symbol>(s)].letter);
    }
    std::string text;
    const bool are_bytes = std::all_of(texts.begin(), texts.end(), [](const std::string& t) { return t.size() == 1; });
    if (are_bytes) {
        text.resize(word.size());
        std::transform(word.symbols.begin(), word.symbols.end(), text.begin(),
                       [&](Symbol symbol) { return texts[symbol][0]; });
        return text;
    }
    text.reserve(word.size());
    for (const Symbol symbol : word.symbols) text += texts[symbol];
    return text;
}

std::u32string letters_of(const Word& word, const Alphabet& alphabet) {
    std::u32string letters;
    letters.reserve(word.size());
    for (const Symbol symbol : word.symbols) letters += alphabet[symbol].letter;
    return letters;
}

}  // namespace filigree::rewriting
