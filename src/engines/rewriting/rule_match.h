// Which rule applies to a symbol in the next iteration of a derivation, and which of its successors is drawn: asked by
// who rewrites (decide.h) and by who explains (explain.h).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "engines/rewriting/contexts.h"
#include "engines/rewriting/derive.h"

namespace filigree::rewriting {

// What keeps a rule from being applied.
enum class Verdict : std::uint8_t {
    applies,
    other_iteration,  // it does not serve this one
    other_row,        // another rule of the letter does, or none any more
    no_left,          // what it must stand between is not there
    no_right,
    off_map,        // a map that it looks at has nothing there
    does_not_hold,  // its condition
};

// A symbol of the word.
struct Standing {
    std::size_t place = 0;  // in Word::symbols
    std::size_t index = 0;  // among those that are no '='
};

// What is wrong with the value of a weight, and with that of a loop, which is rounded; nothing where it is 0 or more.
std::optional<Diagnostic> wrong_weight(double value, SourceSpan at);
std::optional<Diagnostic> wrong_loop(double value, SourceSpan at);

class RuleMatcher {
public:
    // All must outlive this; the derivation's word and registers must stay as they are. Rows are advanced in it.
    RuleMatcher(Derivation& derivation, const Grammar& grammar, const DeriveOptions& options);

    // The first thing that went wrong. Functions that say so by an empty value or `false` leave it here.
    std::optional<Diagnostic> problem;
    bool fail(Diagnostic diagnostic) {
        problem = std::move(diagnostic);
        return false;
    }

    std::uint32_t next_iteration() const { return derivation_.iteration + 1; }
    const System& system_of(std::uint32_t scope) const { return grammar_.systems[derivation_.scopes[scope].system]; }
    std::uint32_t clock_of(std::uint32_t scope) const { return next_iteration() - derivation_.scopes[scope].born; }
    // A subsystem that grows stops after its own iterations.
    bool is_running(std::uint32_t scope) const { return scope == 0 || clock_of(scope) <= system_of(scope).iterations; }

    // All rows to those that serve the next iteration: once, before anything is asked.
    bool advance_rows();
    // The rules of a letter in their order; those that serve the next iteration.
    std::vector<const Rule*> rules_of(std::uint32_t scope, char32_t letter) const;
    std::vector<const Rule*> candidates(std::uint32_t scope, char32_t letter) const;
    // The first rule of a letter that serves any iteration of its system, wherever its letter must stand elsewhere;
    // null where none does, none where something went wrong.
    std::optional<const Rule*> first_rule(std::uint32_t scope, char32_t letter, std::uint32_t iteration);

    // What may let symbols of a letter rest in the next iteration; the first of these that lets one rest, null where
    // none does.
    std::vector<const Rest*> rests_of(std::uint32_t scope, char32_t letter) const;
    std::optional<const Rest*> rest_of(const std::vector<const Rest*>& rests, Standing symbol);

    // Of a rule of this symbol's letter, whether or not it is a candidate.
    std::optional<Verdict> verdict_of(const Rule& rule, Standing symbol);
    // Where the rows of a letter have come to; null where its rules are no rows.
    const Derivation::Row* row_of(std::uint32_t scope, char32_t letter) const;
    const Contexts& contexts();

    // What the expressions of a rule may name where a symbol stands, of those that the last verdict was of. Of two maps
    // with the same names the first is meant.
    const Scope& names_for(const Rule& rule, Standing symbol);
    const Scope& names() const { return names_; }  // registers and the document's
    Result<double> value_of(const ExpressionPtr& expression, const Scope& names) const;

    // What a map has where a symbol stands, if anything. Positions are found once, and only here.
    bool find_positions();
    std::optional<MapValue> value_looked_up(const Lookup& lookup, std::size_t index) const;

    // A symbol's own key, whatever the seed. By lineage: who it is. By position: where it stands and when.
    Key key_at(std::size_t index) const;
    std::optional<double> weight_of(const Successor& successor, const Scope& names);
    // Which of a rule's successors is taken: the number behind the last where none is. The rule may be that of another
    // symbol, which a jump goes to.
    enum class RuleOf : std::uint8_t { symbol, target };
    std::optional<std::size_t> draw_successor(const Rule& rule, std::size_t index, const Scope& names,
                                              RuleOf whose = RuleOf::symbol);
    // `ordinal`: of the macro among those of its letter that are drawn in this iteration.
    std::optional<std::u32string> draw_letters(const Macro& macro, std::size_t index, std::uint64_t ordinal);
    // Where a symbol stands as paths say; nowhere where nobody asks.
    Spot spot_at(std::size_t index);

private:
    bool advance(Derivation::Row& row, bool is_new, std::uint32_t scope, std::uint32_t iteration,
                 const std::vector<const Rule*>& rules);
    const Scope& names_of_row(std::uint32_t iteration, char32_t letter);
    const Scope& names_at(Standing symbol);
    std::optional<bool> look_up(const Rule& rule, Standing symbol);
    std::optional<bool> does_hold(const ExpressionPtr& condition, const Scope& names);
    template <class Value>
    void set(Scope& scope, Fact fact, Value value);
    const SymbolFacts& facts();
    // Random bits. By lineage: of who a symbol is and what for. By position: of where it stands and when.
    std::uint64_t bits_at(std::uint64_t seed, std::size_t index, std::uint64_t stream, std::uint64_t ordinal,
                          std::uint64_t draw) const;
    std::uint32_t times_chosen(std::size_t index) const;

    Derivation& derivation_;
    const Grammar& grammar_;
    const DeriveOptions& options_;
    Scope names_, names_of_symbol_, names_of_row_, names_of_maps_;
    std::size_t named_ = SIZE_MAX;      // whose names the symbol's are,
    const Rule* named_maps_ = nullptr;  // and the maps'
    const FactSet& asked_;
    std::unique_ptr<SymbolFacts> facts_;
    std::unique_ptr<Contexts> contexts_;
    std::optional<std::vector<Vec>> positions_;  // of the symbols that are no '='
    std::vector<double> weights_;                // of successors that race
    std::vector<Spot> spots_;                    // likewise, where they go by place
};

}  // namespace filigree::rewriting
