// A word: what a derivation is made of, one byte a symbol.
//
// Beside the bytes stands of each ñ which n it came from, and columns that only some grammars need; each of these holds
// an entry for every symbol that is no '=', in the order of the word, or nothing at all.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "engines/rewriting/symbols.h"

namespace filigree::rewriting {

struct Word {
    std::vector<Symbol> symbols;
    std::vector<std::uint32_t> origins;  // of each ñ: which n it came from, from 1
    std::vector<std::uint64_t> keys;     // whom a symbol descends from: what it draws by
    std::vector<std::uint32_t> ages;     // in the mode of the grammar
    std::vector<std::uint32_t> spots;    // where a symbol stands as paths say (spots.h): where choices are asked about

    std::size_t size() const { return symbols.size(); }
};

// Which symbols stand in a word, of so many that may.
std::array<bool, max_symbols> symbols_in(const Word& word, std::size_t known);

std::string to_text(const Word& word, const Alphabet& alphabet);
std::u32string letters_of(const Word& word, const Alphabet& alphabet);

}  // namespace filigree::rewriting
