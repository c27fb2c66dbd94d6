// What the expressions of rules may ask of a symbol: when it is, where it stands, how old it is, and what is around it
// (Roncoroni and Crousse, "Editing": age, distance, density, homogeneity).
//
// A symbol's own branch is all between the innermost brackets around it, with the branches in that; without brackets
// around it, the whole word. A bracket belongs to the branch in which its pair stands. Objects are as in
// word_attributes.h. All symbols of a letter are counted alike, whichever system rewrites them.
//
// Linear: a word is walked once for all its symbols, and only for what the grammar asks.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "engines/rewriting/grammar.h"
#include "engines/rewriting/word.h"

namespace filigree::rewriting {

enum class Fact : std::uint8_t {
    t,            // the iteration being made, counted by the symbol's system
    count,        // how many symbols of its letter there are
    index,        // its place among all symbols that are no '=', from 0
    age,          // in the mode of the grammar
    depth,        // brackets around it
    distance,     // objects on the way from the root to it
    density,      // objects in its own branch
    homogeneity,  // there, the sum of squared shares of letters: 1 where all objects are alike; 0 without any
};
constexpr std::array<std::string_view, 8> fact_names = {"t",     "count",    "index",   "age",
                                                        "depth", "distance", "density", "homogeneity"};
// The first of them, which the number of iterations of a row may ask: all symbols of a letter share its rows.
constexpr std::size_t row_fact_count = 2;

using FactSet = std::array<bool, fact_names.size()>;
inline bool has(const FactSet& set, Fact fact) { return set[static_cast<std::size_t>(fact)]; }

// What the grammar's expressions ask.
FactSet facts_asked(const Grammar& grammar);
// With what one more expression asks, which may be null.
void add_facts(FactSet& asked, const ExpressionPtr& expression);

class SymbolFacts {
public:
    // Both must outlive this.
    SymbolFacts(const Word& word, const Alphabet& alphabet, const FactSet& asked);

    // Of the symbol with this index: a fact from `index` on that was asked.
    double value(Fact fact, std::size_t index) const;
    // How many there are of a letter; of that of a symbol.
    std::uint64_t count(char32_t letter) const;
    std::uint64_t count(Symbol symbol) const { return counts_[symbol]; }

private:
    struct Branch {
        std::uint64_t objects = 0;
        double homogeneity = 0;
    };
    void walk(const FactSet& asked);
    void walk_branches();

    const Word& word_;
    const Alphabet& alphabet_;
    std::vector<std::uint32_t> depths_, distances_;
    std::vector<std::uint32_t> branch_of_;  // in branches_
    std::vector<Branch> branches_;
    std::array<std::uint64_t, max_symbols> counts_{};  // by symbol, of all with its letter
};

}  // namespace filigree::rewriting
