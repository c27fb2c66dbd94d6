#include "engines/rewriting/explain.h"

#include <algorithm>

#include "engines/rewriting/decide.h"
#include "language/walk.h"

namespace filigree::rewriting {
namespace {

// Where a symbol stands; none where there are not so many.
std::optional<Standing> find_symbol(const Word& word, std::uint64_t index) {
    std::uint64_t met = 0;
    for (std::size_t place = 0; place < word.size(); ++place) {
        if (word.symbols[place] == Alphabet::freeze) continue;
        if (met++ == index) return Standing{place, static_cast<std::size_t>(index)};
    }
    return std::nullopt;
}

std::vector<std::pair<std::string, double>> values_in(const Expression& condition, const Scope& names) {
    std::vector<std::pair<std::string, double>> values;
    for (const NameInExpression& name : names_in(condition)) {
        const bool is_known =
            std::any_of(values.begin(), values.end(), [&](const auto& known) { return known.first == name.text; });
        const Value* value = is_known ? nullptr : names.find(name.text);
        if (value == nullptr) continue;
        if (const auto* quantity = std::get_if<Quantity>(&value->data)) values.emplace_back(name.text, quantity->value);
    }
    return values;
}

// A rule that is tried, with all that its verdict hangs on.
std::optional<RuleTrial> trial_of(const Rule& rule, Standing symbol, std::uint32_t scope, RuleMatcher& match) {
    RuleTrial trial;
    trial.rule = &rule;
    trial.verdict = match.verdict_of(rule, symbol);
    if (!trial.verdict) return std::nullopt;
    const std::u32string& ignored = match.system_of(scope).ignored;
    if (trial.verdict == Verdict::no_left) {
        const std::size_t wanted = rule.left.size();
        trial.found = match.contexts().letters_left(symbol.place, wanted, ignored);
    } else if (trial.verdict == Verdict::no_right) {
        const std::size_t wanted = rule.right.size();
        const bool asks_for_branches = rule.right.find(U'[') != std::u32string::npos;
        trial.found = asks_for_branches ? match.contexts().letters_behind(symbol.place, wanted)
                                        : match.contexts().letters_right(symbol.place, wanted, ignored);
    } else if (trial.verdict == Verdict::applies || trial.verdict == Verdict::does_not_hold) {
        if (rule.condition) trial.values = values_in(*rule.condition, match.names_for(rule, symbol));
    }
    if (trial.verdict != Verdict::applies || rule.successors.size() == 1) return trial;
    const Scope& names = match.names_for(rule, symbol);
    for (const Successor& successor : rule.successors) {
        const std::optional<double> weight = match.weight_of(successor, names);
        if (!weight) return std::nullopt;
        trial.weights.push_back(*weight);
    }
    trial.drawn = match.draw_successor(rule, symbol.index, names);
    return trial;
}

Fate fate_of_role(const SymbolEntry& entry, std::size_t freezes, const Derivation& derivation) {
    switch (entry.role) {
        case Role::counter:
            return Fate::counted;
        case Role::inverter:
            return Fate::inverted;
        case Role::self:
            return Fate::repeated;
        case Role::macro:
            return freezes > 0 && derivation.recalled.contains({entry.scope, entry.letter}) ? Fate::recalled
                                                                                            : Fate::drawn;
        case Role::subsystem:
            return Fate::grown;
        default:
            return Fate::kept;
    }
}

// The derivation comes out as it went in.
Result<SymbolMoment> moment_of(Derivation& derivation, const Grammar& grammar, const DeriveOptions& options,
                               std::uint64_t index, bool is_last) {
    const Standing symbol = *find_symbol(derivation.word, index);
    const SymbolEntry& entry = derivation.alphabet[derivation.word.symbols[symbol.place]];
    const std::size_t freezes = freezes_behind(derivation.word.symbols, symbol.place);
    const auto rows = derivation.rows;
    RuleMatcher match(derivation, grammar, options);
    const bool has_advanced = match.advance_rows();
    SymbolMoment moment;
    moment.iteration = derivation.iteration;
    moment.index = index;
    moment.letter = entry.letter;
    moment.system = match.system_of(entry.scope).letter;
    moment.turns = static_cast<std::uint32_t>(entry.role == Role::macro && freezes > 0 ? freezes - 1 : freezes);
    moment.clock = match.clock_of(entry.scope);
    moment.fate = moment.turns > 0                 ? Fate::asleep
                  : !match.is_running(entry.scope) ? Fate::at_rest
                                                   : fate_of_role(entry, freezes, derivation);
    const bool is_awake = moment.fate != Fate::asleep && moment.fate != Fate::at_rest;
    if (has_advanced && is_awake) {
        const std::optional<const Rest*> rest = match.rest_of(match.rests_of(entry.scope, entry.letter), symbol);
        if (rest) moment.rest = *rest;
        if (moment.rest != nullptr) moment.fate = Fate::resting;
    }
    if (match.problem) return std::move(*match.problem);
    const bool may_be_rewritten = moment.fate == Fate::kept;
    if (may_be_rewritten || is_last) {
        if (const Derivation::Row* row = match.row_of(entry.scope, entry.letter)) moment.row = *row;
        for (const Rule* rule : match.rules_of(entry.scope, entry.letter)) {
            if (moment.rule != nullptr && !is_last) break;
            if (moment.rule != nullptr) {
                moment.trials.push_back({rule, std::nullopt, {}, {}, {}, {}});
                continue;
            }
            std::optional<RuleTrial> trial = trial_of(*rule, symbol, entry.scope, match);
            if (!trial) break;
            if (trial->verdict == Verdict::applies) moment.rule = rule;
            moment.trials.push_back(std::move(*trial));
        }
    }
    derivation.rows = rows;
    if (match.problem && may_be_rewritten) return std::move(*match.problem);
    if (moment.rule == nullptr) return moment;
    const RuleTrial& applied = *std::find_if(moment.trials.begin(), moment.trials.end(),
                                             [&](const RuleTrial& trial) { return trial.rule == moment.rule; });
    if (!may_be_rewritten || applied.drawn == moment.rule->successors.size()) {
        moment.rule = nullptr;  // it would apply, but nothing comes of it
    } else {
        moment.fate = Fate::rewritten;
    }
    return moment;
}

Diagnostic too_much_memory() {
    return fault(Fault::limit, "limit.memory", "to explain a symbol of words as large as these takes too much memory");
}

}  // namespace

Result<Explanation> explain(const Grammar& grammar, const DeriveOptions& options, std::uint64_t steps,
                            std::uint64_t index, const Job& job) {
    Result<Derivation> derivation = begin(grammar, options);
    if (!derivation) return derivation.diagnostics();
    std::vector<std::vector<std::uint32_t>> parents;
    std::uint64_t traced = 0;
    for (std::uint64_t t = 0; t < steps; ++t) {
        if (is_cancelled(job)) return cancelled_diagnostic();
        std::optional<Diagnostic> problem = step(*derivation, grammar, options, job, &parents.emplace_back());
        if (problem) return std::move(*problem);
        traced += parents.back().size() * sizeof(std::uint32_t);
        if (traced > options.limits.memory_bytes) return too_much_memory();
    }
    if (!find_symbol(derivation->word, index)) {
        const auto freezes =
            std::count(derivation->word.symbols.begin(), derivation->word.symbols.end(), Alphabet::freeze);
        const std::uint64_t count = derivation->word.size() - static_cast<std::uint64_t>(freezes);
        return fault(Fault::usage, "rewriting.no-such-position",
                     "this word has " + std::to_string(count) + " symbols that are no '=', so there is none at " +
                         std::to_string(index) + ", counted from 0");
    }
    std::vector<std::uint64_t> way = {index};  // from the symbol back
    for (std::uint64_t t = steps; t > 0; --t) way.push_back(parents[t - 1][way.back()]);
    std::reverse(way.begin(), way.end());

    Explanation explanation;
    derivation = begin(grammar, options);
    for (std::uint64_t t = 0; t <= steps; ++t) {
        if (is_cancelled(job)) return cancelled_diagnostic();
        Result<SymbolMoment> moment = moment_of(*derivation, grammar, options, way[t], t == steps);
        if (!moment) return moment.diagnostics();
        explanation.moments.push_back(std::move(*moment));
        std::vector<std::uint32_t> children;
        const std::optional<Diagnostic> problem =
            step(*derivation, grammar, options, job, t == steps ? &children : nullptr);
        if (t < steps || problem) continue;
        std::u32string letters;
        std::size_t other = 0;
        bool is_own = false;
        for (const Symbol symbol : derivation->word.symbols) {
            if (symbol != Alphabet::freeze) is_own = children[other++] == index;
            if (is_own) letters += derivation->alphabet[symbol].letter;
        }
        explanation.next = std::move(letters);
    }
    return explanation;
}

}  // namespace filigree::rewriting
