// What becomes of the symbols whose successor hangs on more than the symbol itself, from left to right.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engines/rewriting/derive.h"

namespace filigree::rewriting {

// A successor as symbols, or what else becomes of a symbol.
struct Image {
    std::vector<Symbol> symbols;
    bool is_kept = false;  // the symbol stays as it is: no rule
};

// What an iteration makes of each symbol that is awake.
struct StepPlan {
    enum class Kind : std::uint8_t {
        keep,
        put,       // an image
        multiply,  // as many images as there are such symbols up to here
        follow,    // as many as the symbol's origin says
        repeat,    // the whole word
        count,     // a run, which grows
        invert,    // what makes it shrink
    };
    static constexpr std::uint32_t decided = UINT32_MAX;
    struct Entry {
        Kind kind = Kind::keep;
        std::uint32_t image = 0;  // put, multiply, follow: index into `images`, or `decided`: the next of `decisions`
        std::uint32_t gain = 0;   // count: by how much
        bool may_rest = false;    // some of these symbols may stay as they are, whatever the rest says
    };
    std::vector<Entry> entries;  // by symbol
    std::vector<Image> images;
    std::vector<std::uint32_t> decisions;  // images of the symbols to be decided that are awake, in the word's order
    std::vector<std::uint8_t> resting;     // by place: whether the symbol there rests; empty where none can

    bool rests(std::size_t place) const { return !resting.empty() && resting[place] != 0; }
};

// Plans the next iteration: advances rows, decides what must be decided, and makes what it assigns. The derivation's
// alphabet, scopes, rows, registers and memory go on; its word does not.
Result<StepPlan> plan_step(Derivation& derivation, const Grammar& grammar, const DeriveOptions& options,
                           const Job& job);

// Whether a symbol with so many '=' behind it sleeps. One '=' behind a macro asks for what it was before.
inline bool is_asleep(const SymbolEntry& symbol, std::size_t freezes) {
    return freezes > (symbol.role == Role::macro ? 1U : 0U);
}

// How many '=' stand behind the symbol at a place.
inline std::size_t freezes_behind(const std::vector<Symbol>& symbols, std::size_t place) {
    std::size_t count = 0;
    while (place + 1 + count < symbols.size() && symbols[place + 1 + count] == Alphabet::freeze) ++count;
    return count;
}

}  // namespace filigree::rewriting
