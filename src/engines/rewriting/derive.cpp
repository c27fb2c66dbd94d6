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
    const std::uint64_t each = 1 + (like.keys.empty() ? 0 : 8) + (like.ages.empty() ? 0 : 4);
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
    std::uint64_t index = 0;
    for (const Symbol symbol : word.symbols) {
        if (symbol == Alphabet::freeze) continue;
        if (with_keys) word.keys.push_back(fold(options.root.value, index));
        if (with_ages) word.ages.push_back(1);
        ++index;
    }
}

Result<Derivation> begin(const Grammar& grammar, const DeriveOptions& options, std::uint32_t which) {
    const System& system = grammar.systems[which];
    Derivation derivation;
    derivation.asked = facts_asked(grammar);
    derivation.scopes.push_back({which, 0});
    derivation.registers = grammar.registers;
    Scope names;
    names.outer = options.globals;
    for (const Register& known : grammar.registers) names.names[known.name] = Value{Quantity{known.value}, {}};
    const Result<std::u32string> axiom = put_text(system.axiom, options.document, names, options.limits.elements);
    if (!axiom) return axiom.diagnostics();
    const Home home{0, derivation.alphabet.number_of(within(system.gait, options.around))};
    std::optional<std::vector<Symbol>> symbols = symbols_of(*axiom, system.roles, home, derivation.alphabet);
    if (!symbols) return too_many_symbols();
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
    derivation.asked = facts_asked(grammar);
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
    next.word = std::move(made);
    derivation = std::move(next);
    return std::nullopt;
}

}  // namespace filigree::rewriting
