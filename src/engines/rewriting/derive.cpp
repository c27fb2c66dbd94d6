#include "engines/rewriting/derive.h"

#include <algorithm>

#include "engines/rewriting/decide.h"
#include "engines/rewriting/pattern.h"
#include "engines/rewriting/rewrite.h"

namespace filigree::rewriting {
namespace {

// '=' behind nothing.
void drop_leading_freezes(std::vector<Symbol>& symbols) {
    const auto first =
        std::find_if(symbols.begin(), symbols.end(), [](Symbol symbol) { return symbol != Alphabet::freeze; });
    symbols.erase(symbols.begin(), first);
}

std::optional<Diagnostic> too_large(const Measured& measured, const Word& like, std::uint32_t iteration,
                                    const Limits& limits) {
    const std::uint64_t symbols = measured.symbols;
    // A spot stands in the word, and among all spots.
    const std::uint64_t each =
        1 + (like.keys.empty() ? 0 : 8) + (like.ages.empty() ? 0 : 4) + (like.spots.empty() ? 0 : 4 + 16);
    const std::string of_iteration = "iteration " + std::to_string(iteration) + " would make a word of ";
    const std::string count = symbols >= too_many ? "too many to count" : std::to_string(symbols);
    if (symbols > limits.elements) {
        return fault(Fault::limit, "limit.elements",
                     of_iteration + count + " symbols, where " + std::to_string(limits.elements) + " are allowed");
    }
    if (symbols * each + measured.followers * 4 > limits.memory_bytes) {
        return fault(Fault::limit, "limit.memory", of_iteration + count + " symbols, which takes too much memory");
    }
    return std::nullopt;
}

bool draws(const Grammar& grammar) {
    return std::any_of(grammar.systems.begin(), grammar.systems.end(), [](const System& system) {
        const bool has_alternatives = std::any_of(system.rules.begin(), system.rules.end(),
                                                  [](const Rule& rule) { return rule.successors.size() > 1; });
        return has_alternatives || !system.macros.empty();
    });
}

// Of letters that come one by one.
class SymbolReader {
public:
    SymbolReader(const Roles& roles, Alphabet& alphabet) : roles_(roles), alphabet_(alphabet) {}

    std::vector<Symbol> symbols;

    bool read(char32_t letter, Home home) {
        Role role = roles_.of(letter);
        if (is_behind_run_ && roles_.inverters.find(letter) != std::u32string::npos) role = Role::inverter;
        const std::optional<Symbol> symbol = alphabet_.number_of({letter, role, home.scope, home.gait});
        if (!symbol) return false;
        symbols.push_back(*symbol);
        if (role != Role::freeze) is_behind_run_ = role == Role::counter;
        return true;
    }

private:
    const Roles& roles_;
    Alphabet& alphabet_;
    bool is_behind_run_ = false;
};

FactSet all_facts_asked(const Grammar& grammar, const WordChoices* choices) {
    FactSet asked = facts_asked(grammar);
    if (choices == nullptr) return asked;
    const FactSet by_presets = choices->facts_asked();
    for (std::size_t f = 0; f < asked.size(); ++f) asked[f] = asked[f] || by_presets[f];
    return asked;
}

// What stays keeps its key and its spot, all else stands below what has put it.
void set_spots(const Word& from, const std::vector<std::uint32_t>& parents, const Alphabet& alphabet, Spots& spots,
               Word& to) {
    to.spots.reserve(to.keys.size());
    Siblings siblings(spots);
    std::size_t index = 0;
    for (const Symbol symbol : to.symbols) {
        if (symbol == Alphabet::freeze) continue;
        const std::uint32_t parent = parents[index];
        if (index == 0 || parents[index - 1] != parent) siblings.begin(from.spots[parent]);
        const bool stays = to.keys[index] == from.keys[parent];
        to.spots.push_back(stays ? from.spots[parent] : siblings.next(alphabet[symbol].letter));
        ++index;
    }
}

}  // namespace

std::optional<std::vector<Symbol>> symbols_of(std::u32string_view letters, const Roles& roles, Home home,
                                              Alphabet& alphabet) {
    SymbolReader reader(roles, alphabet);
    reader.symbols.reserve(letters.size());
    for (const char32_t letter : letters) {
        if (!reader.read(letter, home)) return std::nullopt;
    }
    return std::move(reader.symbols);
}

std::optional<std::vector<Symbol>> symbols_of(const Derivation& derived, const Roles& roles, std::uint32_t scope,
                                              Alphabet& alphabet) {
    std::vector<std::uint32_t> gaits;  // by their numbers there
    for (const Gait& gait : derived.alphabet.gaits()) gaits.push_back(alphabet.number_of(gait));
    SymbolReader reader(roles, alphabet);
    reader.symbols.reserve(derived.word.size());
    for (const Symbol symbol : derived.word.symbols) {
        const SymbolEntry& entry = derived.alphabet[symbol];
        if (!reader.read(entry.letter, {scope, gaits[entry.gait]})) return std::nullopt;
    }
    return std::move(reader.symbols);
}

void begin_columns(Derivation& derivation, const Grammar& grammar, const DeriveOptions& options) {
    Word& word = derivation.word;
    const bool with_keys = word.keys.empty() && draws(grammar) && grammar.draws == DrawMode::lineage;
    const bool with_ages = word.ages.empty() && (options.with_ages || has(derivation.asked, Fact::age));
    const bool with_spots = with_keys && derivation.choices && derivation.choices->needs_spots();
    std::optional<Siblings> siblings;
    if (with_spots) siblings.emplace(derivation.choices->spots()).begin(options.spot);
    std::uint64_t index = 0;
    for (const Symbol symbol : word.symbols) {
        if (symbol == Alphabet::freeze) continue;
        if (with_keys) word.keys.push_back(fold(options.root.value, index));
        if (with_spots) word.spots.push_back(siblings->next(derivation.alphabet[symbol].letter));
        if (with_ages) word.ages.push_back(1);
        ++index;
    }
}

Result<Derivation> begin(const Grammar& grammar, const DeriveOptions& options, std::uint32_t which) {
    const System& system = grammar.systems[which];
    Derivation derivation;
    derivation.choices = options.choices;
    derivation.asked = all_facts_asked(grammar, options.choices.get());
    derivation.scopes.push_back({which, 0});
    derivation.registers = grammar.registers;
    Scope names;
    names.outer = options.globals;
    for (const Register& known : grammar.registers) names.names[known.name] = Value{Quantity{known.value}, {}};
    const Result<std::u32string> axiom = put_text(system.axiom, options.document, names, options.limits.elements);
    if (!axiom) return with_span(axiom.diagnostics(), system.axiom_span);
    const Home home{0, derivation.alphabet.number_of(within(system.gait, options.around))};
    std::optional<std::vector<Symbol>> symbols = symbols_of(*axiom, system.roles, home, derivation.alphabet);
    if (!symbols) return with_span({too_many_symbols()}, system.axiom_span);
    drop_leading_freezes(*symbols);
    Word& word = derivation.word;
    word.symbols = std::move(*symbols);
    for (const Symbol symbol : word.symbols) {
        if (derivation.alphabet[symbol].role == Role::follower) word.origins.push_back(1);
    }
    begin_columns(derivation, grammar, options);
    return derivation;
}

Result<Derivation> derive_system(const Grammar& grammar, const DeriveOptions& options, std::uint32_t system,
                                 const Job& job) {
    Result<Derivation> derivation = begin(grammar, options, system);
    for (std::uint32_t t = 0; derivation && t < grammar.systems[system].iterations; ++t) {
        if (std::optional<Diagnostic> problem = step(*derivation, grammar, options, job)) return std::move(*problem);
    }
    return derivation;
}

void go_on_with(Derivation& derivation, const Grammar& grammar, const DeriveOptions& options) {
    derivation.asked = all_facts_asked(grammar, derivation.choices.get());
    std::vector<Register> registers = grammar.registers;
    for (Register& known : registers) {
        if (const Register* before = find_named(derivation.registers, known.name)) known.value = before->value;
    }
    derivation.registers = std::move(registers);
    begin_columns(derivation, grammar, options);
}

std::optional<Diagnostic> step(Derivation& derivation, const Grammar& grammar, const DeriveOptions& options,
                               const Job& job, std::vector<std::uint32_t>* parents) {
    // All but the word is copied, so that an error can leave it as it was.
    Word word = std::move(derivation.word);
    Derivation next = derivation;
    next.word = std::move(word);
    const auto give_up = [&](Diagnostic problem) {
        derivation.word = std::move(next.word);
        return std::optional(std::move(problem));
    };
    const Result<StepPlan> plan = plan_step(next, grammar, options, job);
    if (!plan) return give_up(plan.diagnostics().front());
    ++next.iteration;
    const Rewriting rewriting(next.word, next.alphabet, *plan);
    const Measured measured = measure(rewriting);
    if (std::optional<Diagnostic> problem = too_large(measured, next.word, next.iteration, options.limits)) {
        return give_up(std::move(*problem));
    }
    if (is_cancelled(job)) return give_up(cancelled_diagnostic());
    Word made = rewrite(rewriting, measured, grammar.ages);
    drop_leading_freezes(made.symbols);
    if (parents != nullptr) *parents = parents_of(rewriting);
    if (!next.word.spots.empty()) {
        set_spots(next.word, parents_of(rewriting), next.alphabet, next.choices->spots(), made);
    }
    next.word = std::move(made);
    derivation = std::move(next);
    return std::nullopt;
}

}  // namespace filigree::rewriting
