// Why a symbol of a word is what it is, and what the next iteration makes of it: for who asks why a rule did not apply.
//
// The derivation is made twice: once for the way from the symbol back to the axiom, once for what each on that way was
// and met. So it costs about two derivations and four bytes for each symbol of all words.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engines/rewriting/derive.h"
#include "engines/rewriting/rule_match.h"

namespace filigree::rewriting {

// What an iteration does with a symbol.
enum class Fate : std::uint8_t {
    rewritten,  // by a rule
    kept,       // no rule applies, or none of its successors has a weight
    asleep,     // '=' behind it
    resting,    // by a mask or a sleep
    at_rest,    // the iterations of its system are over
    counted,    // in a run that grows or shrinks
    inverted,   // it makes the run before it shrink, or has none
    repeated,   // it becomes the whole word
    drawn,      // letters at random
    recalled,   // those of an earlier draw
    grown,      // it becomes a subsystem's word
};

struct RuleTrial {
    const Rule* rule = nullptr;
    std::optional<Verdict> verdict;                      // none: it was not tried, since one before it applies
    std::u32string found;                                // no_left, no_right: what stands there
    std::vector<std::pair<std::string, double>> values;  // of the names in the condition that are numbers
    std::vector<double> weights;                         // of an applied rule with several successors
    std::optional<std::size_t> drawn;                    // which of them
};

// A symbol in one word, and what the iteration behind that does with it.
struct SymbolMoment {
    std::uint32_t iteration = 0;
    std::uint64_t index = 0;  // among the symbols that are no '=', from 0
    char32_t letter = 0;
    char32_t system = 0;      // the letter of the subsystem that rewrites it; 0: the document's own
    std::uint32_t turns = 0;  // for which it sleeps
    std::uint32_t clock = 0;  // the number of the next iteration, as its system counts
    Fate fate = Fate::kept;
    const Rule* rule = nullptr;          // rewritten: by which
    const Rest* rest = nullptr;          // resting: by which
    std::vector<RuleTrial> trials;       // all rules of its letter in their order; up to the applied one for ancestors
    std::optional<Derivation::Row> row;  // where they are rows: the one that serves, from 0
};

struct Explanation {
    std::vector<SymbolMoment> moments;   // from the axiom on; the last is the symbol itself
    std::optional<std::u32string> next;  // what the next iteration puts for it; none where that iteration fails
};

// Of the symbol with this index in the word after `steps` iterations. The rules are the grammar's.
Result<Explanation> explain(const Grammar& grammar, const DeriveOptions& options, std::uint64_t steps,
                            std::uint64_t index, const Job& job);

}  // namespace filigree::rewriting
