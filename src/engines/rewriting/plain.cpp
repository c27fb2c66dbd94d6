#include "engines/rewriting/plain.h"

#include <algorithm>

#include "engines/rewriting/pattern.h"

namespace filigree::rewriting {
namespace {

constexpr std::uint64_t max_image = 1'000'000;  // symbols of one; longer ones are put one by one

bool is_plain(const Rule& rule) {
    return rule.left.empty() && rule.right.empty() && rule.first == 1 && rule.last == every_iteration && !rule.loop &&
           !rule.condition && rule.assignments.empty() && rule.successors.size() == 1 &&
           rule.successors[0].kind == Successor::Kind::pattern && is_constant(rule.successors[0].pattern);
}

// A letter that its rule, if any, rewrites alike every time.
bool is_plain(const SymbolEntry& entry) { return entry.scope == 0 && entry.role == Role::ordinary; }

}  // namespace

std::optional<Substitution> plain_substitution(Derivation& derivation, const Grammar& grammar) {
    const Word& word = derivation.word;
    if (!word.origins.empty() || !word.keys.empty() || !word.ages.empty()) return std::nullopt;
    if (!grammar.edits.empty()) return std::nullopt;
    const System& system = grammar.systems[derivation.scopes[0].system];
    if (!system.rests.empty() || !system.loops.empty()) return std::nullopt;
    if (!std::all_of(system.rules.begin(), system.rules.end(), [](const Rule& rule) { return is_plain(rule); })) {
        return std::nullopt;
    }
    Substitution substitution;
    // Images bring symbols whose images bring others.
    for (std::size_t s = Alphabet::freeze + 1; s < derivation.alphabet.size(); ++s) {
        const auto symbol = static_cast<Symbol>(s);
        const SymbolEntry entry = derivation.alphabet[symbol];
        if (!is_plain(entry)) return std::nullopt;
        const auto rule = std::find_if(system.rules.begin(), system.rules.end(),
                                       [&](const Rule& known) { return known.letter == entry.letter; });
        if (rule == system.rules.end()) continue;
        const Result<std::u32string> letters = expanded(rule->successors[0].pattern, max_image, {});
        if (!letters) return std::nullopt;
        const auto image = symbols_of(*letters, system.roles, {0, entry.gait}, derivation.alphabet);
        if (!image || std::find(image->begin(), image->end(), Alphabet::freeze) != image->end()) return std::nullopt;
        substitution.images[s] = *image;
    }
    if (std::find(word.symbols.begin(), word.symbols.end(), Alphabet::freeze) != word.symbols.end()) {
        return std::nullopt;
    }
    return substitution;
}

std::optional<Diagnostic> step_plainly(Derivation& derivation, const Substitution& substitution, std::uint64_t steps,
                                       const Limits& limits, Executor& executor) {
    const std::uint64_t most = std::min(limits.elements, limits.memory_bytes);
    const Result<ByteWord> made = power(substitution, derivation.word.symbols, steps, most, executor);
    if (!made) return made.diagnostics().front();
    derivation.word.symbols.assign(made->symbols().begin(), made->symbols().end());
    derivation.iteration += static_cast<std::uint32_t>(steps);
    return std::nullopt;
}

}  // namespace filigree::rewriting
