#include "engines/rewriting/rule_match.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/number_text.h"
#include "engines/rewriting/turtle.h"

namespace filigree::rewriting {
namespace {

Value number(double value) { return Value{Quantity{value}, {}}; }

// For how many iterations a row of a letter serves; null where nothing says so.
const ExpressionPtr& loop_of(const System& system, const std::vector<const Rule*>& rules, std::size_t row) {
    const Rule& rule = *rules[row];
    if (rule.loop) return rule.loop;
    const auto loop = std::find_if(system.loops.rbegin(), system.loops.rend(), [&](const RowLoop& said) {
        return said.letter == rule.letter && said.first <= row + 1 && row + 1 <= said.last;
    });
    return loop == system.loops.rend() ? rule.loop : loop->length;
}
bool are_rows(const System& system, const std::vector<const Rule*>& rules) {
    for (std::size_t row = 0; row < rules.size(); ++row) {
        if (loop_of(system, rules, row)) return true;
    }
    return false;
}
bool looks_up(const Rule& rule) {
    return std::any_of(rule.successors.begin(), rule.successors.end(),
                       [](const Successor& successor) { return successor.kind == Successor::Kind::lookup; });
}
bool serves(const Rule& rule, std::uint32_t iteration) { return rule.first <= iteration && iteration <= rule.last; }

Diagnostic below_zero(std::string_view what, double value, SourceSpan at) {
    return error("rewriting.negative-number",
                 "expected 0 or more as " + std::string(what) + ", but this is " + filigree::to_text(value), at);
}

}  // namespace

std::optional<Diagnostic> wrong_weight(double value, SourceSpan at) {
    if (value < 0) return below_zero("a weight", value, at);
    return std::nullopt;
}
std::optional<Diagnostic> wrong_loop(double value, SourceSpan at) {
    if (value <= -0.5) return below_zero("the number of iterations of a row", value, at);
    return std::nullopt;
}

RuleMatcher::RuleMatcher(Derivation& derivation, const Grammar& grammar, const DeriveOptions& options)
    : derivation_(derivation), grammar_(grammar), options_(options), asked_(derivation.asked) {
    names_.outer = options.globals;
    for (const Register& known : derivation.registers) names_.names[known.name] = number(known.value);
    names_of_row_.outer = names_of_symbol_.outer = &names_;
    names_of_maps_.outer = &names_of_symbol_;
}

// --- rows ---

std::vector<const Rule*> RuleMatcher::rules_of(std::uint32_t scope, char32_t letter) const {
    std::vector<const Rule*> rules;
    for (const Rule& rule : system_of(scope).rules) {
        if (rule.letter == letter) rules.push_back(&rule);
    }
    return rules;
}

bool RuleMatcher::advance_rows() {
    for (std::uint32_t scope = 0; scope < derivation_.scopes.size(); ++scope) {
        if (!is_running(scope)) continue;
        std::u32string met;
        for (const Rule& rule : system_of(scope).rules) {
            if (met.find(rule.letter) != std::u32string::npos) continue;
            met += rule.letter;
            const std::vector<const Rule*> rules = rules_of(scope, rule.letter);
            if (!are_rows(system_of(scope), rules)) continue;
            const auto [at, is_new] = derivation_.rows.try_emplace({scope, rule.letter});
            if (!advance(at->second, is_new, scope, clock_of(scope), rules)) return false;
        }
    }
    return true;
}

// To the row that serves an iteration, the next of its system; `row.row` is behind the last where none does.
bool RuleMatcher::advance(Derivation::Row& row, bool is_new, std::uint32_t scope, std::uint32_t iteration,
                          const std::vector<const Rule*>& rules) {
    const auto count = static_cast<std::uint32_t>(rules.size());
    if (row.row == count) return true;
    if (!is_new) {
        if (--row.left > 0) return true;
        ++row.row;
    }
    // One round at most, so that rows that serve no iteration at all end.
    for (std::uint32_t tried = 0; tried <= count; ++tried) {
        if (row.row == count) {
            if (system_of(scope).after == AfterRows::identity) return true;
            if (system_of(scope).after == AfterRows::hold) {
                row.row = count - 1;
                row.left = UINT64_MAX;
                return true;
            }
            row.row = 0;
        }
        row.left = 1;
        if (const ExpressionPtr& loop = loop_of(system_of(scope), rules, row.row)) {
            const Result<double> times = value_of(loop, names_of_row(iteration, rules[row.row]->letter));
            if (!times) return fail(times.diagnostics().front());
            if (std::optional<Diagnostic> wrong = wrong_loop(*times, loop->span)) return fail(std::move(*wrong));
            row.left = *times >= 0.5 ? static_cast<std::uint64_t>(std::min(*times + 0.5, 1e18)) : 0;
        }
        if (row.left > 0) return true;
        ++row.row;
    }
    row.row = count;
    return true;
}

const Derivation::Row* RuleMatcher::row_of(std::uint32_t scope, char32_t letter) const {
    const auto row = derivation_.rows.find({scope, letter});
    return row == derivation_.rows.end() ? nullptr : &row->second;
}

std::vector<const Rule*> RuleMatcher::candidates(std::uint32_t scope, char32_t letter) const {
    std::vector<const Rule*> rules = rules_of(scope, letter);
    if (const Derivation::Row* row = row_of(scope, letter)) {
        if (row->row >= rules.size()) return {};
        rules = {rules[row->row]};
    }
    std::erase_if(rules, [&](const Rule* rule) { return !serves(*rule, clock_of(scope)); });
    return rules;
}

std::optional<const Rule*> RuleMatcher::first_rule(std::uint32_t scope, char32_t letter, std::uint32_t iteration) {
    std::vector<const Rule*> rules = rules_of(scope, letter);
    if (are_rows(system_of(scope), rules)) {
        Derivation::Row row;
        for (std::uint32_t t = 1; t <= iteration; ++t) {
            if (!advance(row, t == 1, scope, t, rules)) return std::nullopt;
        }
        if (row.row >= rules.size()) return nullptr;
        rules = {rules[row.row]};
    }
    const auto found =
        std::find_if(rules.begin(), rules.end(), [&](const Rule* rule) { return serves(*rule, iteration); });
    return found == rules.end() ? nullptr : *found;
}

// --- rests ---

std::vector<const Rest*> RuleMatcher::rests_of(std::uint32_t scope, char32_t letter) const {
    std::vector<const Rest*> rests;
    for (const Rest& rest : system_of(scope).rests) {
        const bool is_now = rest.first <= clock_of(scope) && clock_of(scope) <= rest.last;
        if (rest.letter == letter && is_now) rests.push_back(&rest);
    }
    return rests;
}

std::optional<const Rest*> RuleMatcher::rest_of(const std::vector<const Rest*>& rests, Standing symbol) {
    for (const Rest* rest : rests) {
        if (!rest->condition) return rest;
        const std::optional<bool> holds = does_hold(rest->condition, names_at(symbol));
        if (!holds) return std::nullopt;
        if (*holds != rest->is_until) return rest;
    }
    return nullptr;
}

// --- one rule and one symbol ---

std::optional<Verdict> RuleMatcher::verdict_of(const Rule& rule, Standing symbol) {
    const SymbolEntry& entry = derivation_.alphabet[derivation_.word.symbols[symbol.place]];
    if (const Derivation::Row* row = row_of(entry.scope, entry.letter)) {
        std::uint32_t before = 0;  // rows of the letter
        for (const Rule& other : system_of(entry.scope).rules) {
            if (&other == &rule) break;
            before += other.letter == rule.letter ? 1 : 0;
        }
        if (row->row != before) return Verdict::other_row;
    }
    if (!serves(rule, clock_of(entry.scope))) return Verdict::other_iteration;
    const std::u32string& ignored = system_of(entry.scope).ignored;
    if (!rule.left.empty() && !contexts().has_left(symbol.place, rule.left, ignored)) return Verdict::no_left;
    if (!rule.right.empty() && !contexts().has_right(symbol.place, rule.right, ignored)) return Verdict::no_right;
    if (looks_up(rule)) {
        const std::optional<bool> is_on_maps = look_up(rule, symbol);
        if (!is_on_maps) return std::nullopt;
        if (!*is_on_maps) return Verdict::off_map;
    }
    if (!rule.condition) return Verdict::applies;
    const std::optional<bool> holds = does_hold(rule.condition, names_for(rule, symbol));
    if (!holds) return std::nullopt;
    return *holds ? Verdict::applies : Verdict::does_not_hold;
}

const Contexts& RuleMatcher::contexts() {
    if (!contexts_) contexts_ = std::make_unique<Contexts>(derivation_.word, derivation_.alphabet);
    return *contexts_;
}

// --- maps ---

bool RuleMatcher::find_positions() {
    if (positions_) return true;
    Result<std::vector<Vec>> found =
        options_.positions ? options_.positions(derivation_)
                           : symbol_positions(derivation_.word, derivation_.alphabet, {}, options_.limits.elements);
    if (!found) return fail(found.diagnostics().front());
    positions_ = std::move(*found);
    return true;
}

std::optional<MapValue> RuleMatcher::value_looked_up(const Lookup& lookup, std::size_t index) const {
    const Map* map = find_named(grammar_.maps, lookup.map);
    return map == nullptr ? std::nullopt : value_at(*map, (*positions_)[index]);
}

// Names what all maps of a rule have there, the first last, so that it counts; false where one has nothing.
std::optional<bool> RuleMatcher::look_up(const Rule& rule, Standing symbol) {
    if (!find_positions()) return std::nullopt;
    if (named_maps_ != &rule) names_of_maps_.names.clear();
    named_maps_ = &rule;
    for (auto successor = rule.successors.rbegin(); successor != rule.successors.rend(); ++successor) {
        if (successor->kind != Successor::Kind::lookup) continue;
        const std::optional<MapValue> value = value_looked_up(successor->lookup, symbol.index);
        if (!value) return false;
        set_names(*value, names_of_maps_);
    }
    return true;
}

// --- values ---

Result<double> RuleMatcher::value_of(const ExpressionPtr& expression, const Scope& names) const {
    Evaluation at;
    at.document = options_.document;
    at.scope = &names;
    const Result<Value> value = evaluate(*expression, at);
    if (!value) return value.diagnostics();
    return as_number(*value);
}
std::optional<bool> RuleMatcher::does_hold(const ExpressionPtr& condition, const Scope& names) {
    Evaluation at;
    at.document = options_.document;
    at.scope = &names;
    const Result<Value> value = evaluate(*condition, at);
    const Result<bool> flag = value ? as_flag(*value) : Result<bool>(value.diagnostics());
    if (flag) return *flag;
    fail(flag.diagnostics().front());
    return std::nullopt;
}

const Scope& RuleMatcher::names_for(const Rule& rule, Standing symbol) {
    const Scope& names = names_at(symbol);
    return looks_up(rule) ? names_of_maps_ : names;
}
const Scope& RuleMatcher::names_at(Standing symbol) {
    if (symbol.index == named_) return names_of_symbol_;
    named_ = symbol.index;
    const Symbol number = derivation_.word.symbols[symbol.place];
    set(names_of_symbol_, Fact::t, [&] { return clock_of(derivation_.alphabet[number].scope); });
    set(names_of_symbol_, Fact::count, [&] { return facts().count(number); });
    for (std::size_t f = row_fact_count; f < fact_names.size(); ++f) {
        const auto fact = static_cast<Fact>(f);
        set(names_of_symbol_, fact, [&] { return facts().value(fact, symbol.index); });
    }
    return names_of_symbol_;
}
// What is known of all symbols of a letter in an iteration of its system.
const Scope& RuleMatcher::names_of_row(std::uint32_t iteration, char32_t letter) {
    set(names_of_row_, Fact::t, [&] { return iteration; });
    set(names_of_row_, Fact::count, [&] { return facts().count(letter); });
    return names_of_row_;
}
template <class Value>
void RuleMatcher::set(Scope& scope, Fact fact, Value value) {
    if (!has(asked_, fact)) return;
    const std::string_view name = fact_names[static_cast<std::size_t>(fact)];
    auto known = scope.names.find(name);
    if (known == scope.names.end()) known = scope.names.emplace(std::string(name), number(0)).first;
    known->second = number(static_cast<double>(value()));
}
const SymbolFacts& RuleMatcher::facts() {
    if (!facts_) facts_ = std::make_unique<SymbolFacts>(derivation_.word, derivation_.alphabet, asked_);
    return *facts_;
}

// --- draws ---

Key RuleMatcher::key_at(std::size_t index) const {
    const Word& word = derivation_.word;
    if (!word.keys.empty()) return Key{word.keys[index]};
    return child(child(options_.root, next_iteration()), index);
}

std::uint64_t RuleMatcher::bits_at(std::uint64_t seed, std::size_t index, std::uint64_t stream, std::uint64_t ordinal,
                                   std::uint64_t draw) const {
    const Word& word = derivation_.word;
    if (!word.keys.empty()) return random_bits(seed, Key{word.keys[index]}, stream, draw);
    // In a subsystem, places are those in its own word.
    if (options_.nested > 0) seed = fold(seed, options_.root.value);
    return fold(fold(fold(fold(seed, stream), next_iteration()), ordinal), draw);
}

std::optional<double> RuleMatcher::weight_of(const Successor& successor, const Scope& names) {
    if (!successor.weight) return 1;
    const Result<double> weight = value_of(successor.weight, names);
    if (!weight) {
        fail(weight.diagnostics().front());
        return std::nullopt;
    }
    if (std::optional<Diagnostic> wrong = wrong_weight(*weight, successor.weight->span)) {
        fail(std::move(*wrong));
        return std::nullopt;
    }
    return *weight;
}

std::optional<std::size_t> RuleMatcher::draw_successor(const Rule& rule, std::size_t index, const Scope& names,
                                                       RuleOf whose) {
    const std::size_t count = rule.successors.size();
    if (count == 1) return 0;
    weights_.resize(count);
    for (std::size_t s = 0; s < count; ++s) {
        const std::optional<double> weight = weight_of(rule.successors[s], names);
        if (!weight) return std::nullopt;
        weights_[s] = *weight;
    }
    const auto bits = [&](std::uint64_t seed) { return bits_at(seed, index, 0, index, 0); };
    if (!derivation_.choices) return raced(weights_, bits(options_.seed));
    const Result<std::size_t> chosen =
        derivation_.choices->successor(rule, weights_, whose == RuleOf::symbol ? "rule" : "target",
                                       {key_at(index), spot_at(index), times_chosen(index), names,
                                        [&](std::uint64_t seed, std::uint64_t) { return bits(seed); }});
    if (chosen) return *chosen;
    fail(chosen.diagnostics().front());
    return std::nullopt;
}

std::optional<std::u32string> RuleMatcher::draw_letters(const Macro& macro, std::size_t index, std::uint64_t ordinal) {
    const auto bits = [&](std::uint64_t seed, std::uint64_t draw) {
        return bits_at(seed, index, macro.letter, ordinal, draw);
    };
    if (!derivation_.choices) {
        return drawn_letters(macro, [&](std::uint64_t draw) { return bits(options_.seed, draw); });
    }
    Result<std::u32string> chosen =
        derivation_.choices->letters(macro, {key_at(index), spot_at(index), times_chosen(index), names_, bits});
    if (chosen) return std::move(*chosen);
    fail(chosen.diagnostics().front());
    return std::nullopt;
}

std::uint32_t RuleMatcher::times_chosen(std::size_t index) const {
    const auto known = derivation_.chosen.find(key_at(index).value);
    return known == derivation_.chosen.end() ? 0 : known->second;
}

Spot RuleMatcher::spot_at(std::size_t index) {
    if (!derivation_.choices || !derivation_.choices->needs_spots()) return Spots::root;
    const Word& word = derivation_.word;
    if (!word.keys.empty()) return word.spots[index];
    if (spots_.empty()) {
        Siblings siblings(derivation_.choices->spots());
        siblings.begin(derivation_.choices->spots().below(options_.spot, "iteration", next_iteration()));
        for (const Symbol symbol : word.symbols) {
            if (symbol != Alphabet::freeze) spots_.push_back(siblings.next(derivation_.alphabet[symbol].letter));
        }
    }
    return spots_[index];
}

}  // namespace filigree::rewriting
