// Deriving a word: in every iteration all symbols are rewritten at once, by what the word and the registers were before
// it (Roncoroni and Crousse, "Programming string-substitution rewriting systems").
//
// An iteration looks at the word three times. First come the symbols whose successor hangs on more than the symbol
// itself (contexts, conditions, draws, macros, subsystems): what becomes of them is decided from left to right
// (decide.h). Then the size of the new word is counted, so that one that is too large ends the run before any memory
// is asked for; then it is written (rewrite.h).
//
// Guarantees: iteration t makes S_t from S_(t-1) alone; a limit that is reached, or an error, leaves all as it was.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/job.h"
#include "base/limits.h"
#include "base/result.h"
#include "engines/rewriting/grammar.h"
#include "engines/rewriting/symbol_facts.h"
#include "engines/rewriting/word.h"
#include "engines/rewriting/word_choices.h"
#include "language/evaluate.h"
#include "plane/point.h"

namespace filigree::rewriting {

struct Derivation;

struct DeriveOptions {
    std::uint64_t seed = 0;
    Key root;  // folded into all lineages
    Limits limits;
    const Document* document = nullptr;  // of the expressions
    const Scope* globals = nullptr;      // likewise
    bool with_ages = false;
    // Where the symbols of a word stand, which lookups ask: symbol_positions (turtle.h) under the document's settings;
    // empty: under none.
    std::function<Result<std::vector<Vec>>(const Derivation&)> positions = {};
    std::shared_ptr<WordChoices> choices = {};  // of the derivation that is begun
    Spot spot = Spots::root;                    // below which this derivation stands
    std::uint32_t nested = 0;                   // subsystems around this derivation
    Gait around = {};                           // of the symbol in whose place this word will stand
};

// A derivation under way, as plain data: a copy goes on by itself.
struct Derivation {
    // The system that rewrites a symbol, and the iteration after which it began to.
    struct Scope {
        std::uint32_t system = 0, born = 0;
    };
    // Where the rows of a letter have come to (loops).
    struct Row {
        std::uint32_t row = 0;
        std::uint64_t left = 0;  // iterations for which it still serves
    };

    // By what choices are made, where there are presets, recorded choices, or some to be recorded; null: they are
    // drawn.
    std::shared_ptr<WordChoices> choices;
    FactSet asked{};  // what the grammar, and presets, ask of symbols
    Alphabet alphabet;
    std::vector<Scope> scopes;  // by SymbolEntry::scope; [0] is the outermost system
    Word word;
    std::uint32_t iteration = 0;
    std::vector<Register> registers;
    std::map<std::pair<std::uint32_t, char32_t>, std::u32string> recalled;  // by scope and macro
    std::map<std::pair<std::uint32_t, char32_t>, Row> rows;                 // by scope and letter
    std::map<std::uint64_t, std::uint32_t> chosen;  // how often symbols have chosen and stayed; by key
};

// The axiom, of the document's own system or of another.
Result<Derivation> begin(const Grammar& grammar, const DeriveOptions& options, std::uint32_t system = 0);

// One iteration more; what went wrong, if anything did. `parents`, where it is given, gets an entry for each symbol of
// the new word that is no '=': the index of the symbol that put it, counted likewise.
std::optional<Diagnostic> step(Derivation& derivation, const Grammar& grammar, const DeriveOptions& options,
                               const Job& job, std::vector<std::uint32_t>* parents = nullptr);

// A system's word after all its iterations.
Result<Derivation> derive_system(const Grammar& grammar, const DeriveOptions& options, std::uint32_t system,
                                 const Job& job);

// Counts ages and lineages from here on, where the grammar needs them and the word has none.
void begin_columns(Derivation& derivation, const Grammar& grammar, const DeriveOptions& options);

// From now on the rules are those of another grammar, whose letters have the same roles: rules of later iterations may
// change while a derivation is under way. What the word has not counted so far, ages and lineages, begins here;
// registers keep their values, new ones have those that they begin with.
void go_on_with(Derivation& derivation, const Grammar& grammar, const DeriveOptions& options);

// What letters that one system reads belong to.
struct Home {
    std::uint32_t scope = 0, gait = 0;  // as in SymbolEntry

    auto operator<=>(const Home&) const = default;
};

// The symbols of letters that one system reads: an inverter is known by what stands before it. None where there are
// too many symbols.
std::optional<std::vector<Symbol>> symbols_of(std::u32string_view letters, const Roles& roles, Home home,
                                              Alphabet& alphabet);

// The same of a word that was derived on its own: its symbols keep their gaits.
std::optional<std::vector<Symbol>> symbols_of(const Derivation& derived, const Roles& roles, std::uint32_t scope,
                                              Alphabet& alphabet);

}  // namespace filigree::rewriting
