// The word of the next iteration, in two passes: how large it is, so that one that is too large is never made; then its
// symbols.
//
// Long words without columns go by chunks of symbols (rewrite_chunks.h), all else symbol by symbol (rewrite_symbols.h):
// the symbols are the same.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engines/rewriting/rewrite_chunks.h"
#include "engines/rewriting/rewrite_symbols.h"

namespace filigree::rewriting {

constexpr std::size_t chunks_pay_from = 1 << 13;  // symbols of a word

struct Measured {
    std::uint64_t symbols = 0;             // of the new word; from `too_many` on they are not counted
    std::uint64_t followers = 0;           // among them
    std::optional<ChunkTable> table;       // none: symbol by symbol
    std::vector<ChunkTable::Code> chunks;  // of the word, from its start; the rest goes symbol by symbol
};

Measured measure(const Rewriting& in, std::size_t chunks_from = chunks_pay_from);

// What was measured.
Word rewrite(const Rewriting& in, const Measured& measured, AgeMode mode);

// For each symbol of the new word that is no '=' the index of the symbol that puts it, counted likewise.
std::vector<std::uint32_t> parents_of(const Rewriting& in);

}  // namespace filigree::rewriting
