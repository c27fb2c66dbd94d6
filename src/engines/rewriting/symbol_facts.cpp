#include "engines/rewriting/symbol_facts.h"

#include <algorithm>
#include <utility>

#include "engines/rewriting/word_attributes.h"
#include "language/walk.h"

namespace filigree::rewriting {
namespace {

class Asking {
public:
    FactSet asked{};

    void look_at(const ExpressionPtr& expression) { add_facts(asked, expression); }
    void look_at(const std::vector<Pattern::Part>& parts) {
        for (const Pattern::Part& part : parts) {
            look_at(part.count);
            look_at(part.repeated);
        }
    }
    void look_at(const Rule& rule) {
        look_at(rule.loop);
        look_at(rule.condition);
        for (const Assignment& assignment : rule.assignments) look_at(assignment.value);
        for (const Successor& successor : rule.successors) {
            look_at(successor.weight);
            look_at(successor.pattern.parts);
            for (const ExpressionPtr& index : successor.indexes) look_at(index);
            for (const Lookup::Row& row : successor.lookup.rows) look_at(row.pattern.parts);
        }
    }
};

// How many there are of each symbol in a branch and, once they are closed, in the branches in it.
class BranchCounts {
public:
    void add(Symbol symbol) {
        if (counts_[symbol]++ == 0) met_.push_back(symbol);
    }
    void open() {
        outer_.emplace_back();
        for (const Symbol symbol : met_) outer_.back().emplace_back(symbol, std::exchange(counts_[symbol], 0));
        met_.clear();
    }
    void close() {
        for (const auto& [symbol, count] : outer_.back()) {
            if (counts_[symbol] == 0) met_.push_back(symbol);
            counts_[symbol] += count;
        }
        outer_.pop_back();
    }
    std::uint64_t all() const {
        std::uint64_t sum = 0;
        for (const Symbol symbol : met_) sum += counts_[symbol];
        return sum;
    }
    double homogeneity() const {
        const auto objects = static_cast<double>(all());
        double squares = 0;  // a whole number up to 2^53 for the words that limits let through, so exact in any order
        for (const Symbol symbol : met_)
            squares += static_cast<double>(counts_[symbol]) * static_cast<double>(counts_[symbol]);
        return objects > 0 ? squares / (objects * objects) : 0;
    }

private:
    std::array<std::uint64_t, max_symbols> counts_{};
    std::vector<Symbol> met_;
    std::vector<std::vector<std::pair<Symbol, std::uint64_t>>> outer_;
};

}  // namespace

void add_facts(FactSet& asked, const ExpressionPtr& expression) {
    if (!expression) return;
    for (const NameInExpression& name : names_in(*expression)) {
        const auto known = std::find(fact_names.begin(), fact_names.end(), name.text);
        if (known != fact_names.end()) asked[static_cast<std::size_t>(known - fact_names.begin())] = true;
    }
}

FactSet facts_asked(const Grammar& grammar) {
    Asking asking;
    for (const Array& array : grammar.arrays) {
        for (const Pattern& cell : array.cells) asking.look_at(cell.parts);
    }
    for (const System& system : grammar.systems) {
        for (const Rule& rule : system.rules) asking.look_at(rule);
        for (const Rest& rest : system.rests) asking.look_at(rest.condition);
        for (const RowLoop& loop : system.loops) asking.look_at(loop.length);
    }
    return asking.asked;
}

SymbolFacts::SymbolFacts(const Word& word, const Alphabet& alphabet, const FactSet& asked)
    : word_(word), alphabet_(alphabet) {
    if (has(asked, Fact::count)) {
        std::array<std::uint64_t, max_symbols> own{};
        for (const Symbol symbol : word.symbols) ++own[symbol];
        for (std::size_t s = 0; s < alphabet.size(); ++s) {
            counts_[s] = 0;
            for (std::size_t other = 0; other < alphabet.size(); ++other) {
                const bool are_alike =
                    alphabet[static_cast<Symbol>(s)].letter == alphabet[static_cast<Symbol>(other)].letter;
                counts_[s] += are_alike ? own[other] : 0;
            }
        }
    }
    if (has(asked, Fact::depth) || has(asked, Fact::distance)) walk(asked);
    if (has(asked, Fact::density) || has(asked, Fact::homogeneity)) walk_branches();
}

void SymbolFacts::walk(const FactSet& asked) {
    WordWalk walk;
    for (const Symbol symbol : word_.symbols) {
        if (symbol == Alphabet::freeze) continue;
        const char32_t letter = alphabet_[symbol].letter;
        const WordWalk::Place place = walk.next(letter, is_object(letter));
        if (has(asked, Fact::depth)) depths_.push_back(place.depth);
        if (has(asked, Fact::distance)) distances_.push_back(place.distance);
    }
}

void SymbolFacts::walk_branches() {
    // The same letter of two systems counts as one symbol.
    std::array<Symbol, max_symbols> first_alike{};
    std::array<bool, max_symbols> are_objects{};
    for (std::size_t s = 0; s < alphabet_.size(); ++s) {
        const char32_t letter = alphabet_[static_cast<Symbol>(s)].letter;
        std::size_t first = 0;
        while (alphabet_[static_cast<Symbol>(first)].letter != letter) ++first;
        first_alike[s] = static_cast<Symbol>(first);
        are_objects[s] = is_object(letter);
    }
    BranchCounts counts;
    std::vector<std::uint32_t> open = {0};
    branches_.resize(1);
    const auto close = [&] {
        branches_[open.back()] = {counts.all(), counts.homogeneity()};
        open.pop_back();
        if (!open.empty()) counts.close();
    };
    for (const Symbol symbol : word_.symbols) {
        if (symbol == Alphabet::freeze) continue;
        const char32_t letter = alphabet_[symbol].letter;
        if (letter == U']' && open.size() > 1) close();
        branch_of_.push_back(open.back());
        if (are_objects[symbol]) counts.add(first_alike[symbol]);
        if (letter != U'[') continue;
        open.push_back(static_cast<std::uint32_t>(branches_.size()));
        branches_.emplace_back();
        counts.open();
    }
    while (!open.empty()) close();
}

double SymbolFacts::value(Fact fact, std::size_t index) const {
    switch (fact) {
        case Fact::index:
            return static_cast<double>(index);
        case Fact::age:
            return word_.ages[index];
        case Fact::depth:
            return depths_[index];
        case Fact::distance:
            return distances_[index];
        case Fact::density:
            return static_cast<double>(branches_[branch_of_[index]].objects);
        case Fact::homogeneity:
            return branches_[branch_of_[index]].homogeneity;
        default:
            return 0;
    }
}

std::uint64_t SymbolFacts::count(char32_t letter) const {
    for (std::size_t s = 0; s < alphabet_.size(); ++s) {
        if (alphabet_[static_cast<Symbol>(s)].letter == letter) return counts_[s];
    }
    return 0;
}

}  // namespace filigree::rewriting
