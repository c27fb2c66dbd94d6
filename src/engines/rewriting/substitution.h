// Deterministic context-free rewriting (D0L) on plain tables: every symbol of a word becomes its image.
//
// The fast path of the engine: one byte a symbol, written as fast as memory takes it. A step is two passes, sizes and
// symbols, so that a word is refused by its exact length before memory is asked for, and that memory is asked for once.
// Several steps at once are one step of a greater substitution, whose images are blocks that lie in the cache.
// Guarantee: the same bytes for every executor and every way of taking the same steps.
// Words that are too long to be written down are read by way of implicit_word.h.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/executor.h"
#include "base/result.h"
#include "engines/rewriting/bigint.h"
#include "engines/rewriting/byte_word.h"

namespace filigree::rewriting {

std::vector<std::vector<std::uint8_t>> images_of_themselves();

struct Substitution {
    // The word that each symbol becomes, which may be empty; a symbol that is given none stays as it is.
    std::vector<std::vector<std::uint8_t>> images = images_of_themselves();
};

std::span<const std::uint8_t> image_of(const Substitution& substitution, std::uint8_t symbol);

// One step. At most `most_symbols` come out, else the reason is `limit.elements` (or `limit.memory` where the system
// has too little). The memory of `reuse` is taken for the result where it suffices; it must not hold `word`.
Result<ByteWord> apply(const Substitution& substitution, std::span<const std::uint8_t> word, std::uint64_t most_symbols,
                       Executor& executor, ByteWord reuse = {});

// `steps` steps at once: the same bytes as one after another, and refused where one of those words would be. Costs what
// the last word costs to write where words grow exponentially; where they grow slowly, some passes of that size, and
// some three times its memory meanwhile.
Result<ByteWord> power(const Substitution& substitution, std::span<const std::uint8_t> word, std::uint64_t steps,
                       std::uint64_t most_symbols, Executor& executor, ByteWord reuse = {});

// --- without expanding: each O(steps x what the images of the symbols that can arise hold) ---------------------------

std::array<BigInt, 256> lengths_of_symbols(const Substitution& substitution, std::uint64_t steps);
BigInt length_of_word(const Substitution& substitution, std::span<const std::uint8_t> word, std::uint64_t steps);
std::array<BigInt, 256> counts_of_symbols(const Substitution& substitution, std::span<const std::uint8_t> word,
                                          std::uint64_t steps);

// --- for who builds on it --------------------------------------------------------------------------------------------

// The symbols of the word and of all words that come from it, in increasing order.
std::vector<std::uint8_t> symbols_from(const Substitution& substitution, std::span<const std::uint8_t> word);

// How often each symbol stands in the images of `symbols`, as places in `symbols`, which must be all that can arise.
struct Occurrence {
    std::uint32_t symbol = 0;
    std::uint32_t count = 0;
};
std::vector<std::vector<Occurrence>> occurrences(const Substitution& substitution,
                                                 std::span<const std::uint8_t> symbols);

// How many of `steps` steps to take at once so that the images of these symbols stay within `most` bytes together, at
// each of these steps; at least 1 where there are any.
std::uint64_t steps_within(const Substitution& substitution, std::span<const std::uint8_t> symbols, std::uint64_t steps,
                           std::uint64_t most);

// The substitution that does `steps` steps at once, for these symbols alone.
Substitution iterated(const Substitution& substitution, std::span<const std::uint8_t> symbols, std::uint64_t steps);

}  // namespace filigree::rewriting
