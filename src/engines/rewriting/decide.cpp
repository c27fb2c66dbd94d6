#include "engines/rewriting/decide.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engines/rewriting/pattern.h"
#include "engines/rewriting/rule_match.h"

namespace filigree::rewriting {
namespace {

constexpr std::uint32_t most_nested = 16;  // subsystems that put subsystems at once

class Planner {
public:
    Planner(Derivation& derivation, const Grammar& grammar, const DeriveOptions& options, const Job& job)
        : derivation_(derivation),
          grammar_(grammar),
          options_(options),
          job_(job),
          match_(derivation, grammar, options),
          registers_(derivation.registers) {}

    Result<StepPlan> run() {
        if (!match_.advance_rows()) return std::move(*match_.problem);
        const std::size_t known = derivation_.alphabet.size();
        plan_.entries.resize(known);
        candidates_.resize(known);
        rests_.resize(known);
        const std::array<bool, max_symbols> stands = symbols_in(derivation_.word, known);
        bool must_decide = false, may_rest = false;
        for (std::size_t s = 0; s < known; ++s) {
            if (!stands[s]) continue;
            if (!plan_symbol(static_cast<Symbol>(s))) return std::move(*match_.problem);
            may_rest = may_rest || plan_.entries[s].may_rest;
            must_decide = must_decide || plan_.entries[s].image == StepPlan::decided;
        }
        if (may_rest && !find_resting()) return std::move(*match_.problem);
        if (must_decide && !decide_all()) return std::move(*match_.problem);
        derivation_.registers = std::move(registers_);
        return std::move(plan_);
    }

private:
    using Kind = StepPlan::Kind;

    bool fail(Diagnostic problem) { return match_.fail(std::move(problem)); }

    // --- what becomes of a symbol ---

    bool plan_symbol(Symbol symbol) {
        const SymbolEntry entry = derivation_.alphabet[symbol];
        StepPlan::Entry& planned = plan_.entries[symbol];
        if (entry.role == Role::freeze || !match_.is_running(entry.scope)) return true;
        const System& system = match_.system_of(entry.scope);
        rests_[symbol] = match_.rests_of(entry.scope, entry.letter);
        planned.may_rest = !rests_[symbol].empty();
        switch (entry.role) {
            case Role::counter: {
                planned.kind = Kind::count;
                planned.gain = 1;
                for (const Gain& gain : system.gains)
                    planned.gain = gain.letter == entry.letter ? gain.by : planned.gain;
                return true;
            }
            case Role::inverter:
                planned.kind = Kind::invert;
                return true;
            case Role::self:
                planned.kind = Kind::repeat;
                return true;
            case Role::subsystem:
                if (!find_system(grammar_, entry.letter)) return true;
                [[fallthrough]];
            case Role::macro:
                planned.kind = Kind::put;
                planned.image = StepPlan::decided;
                return true;
            default:
                break;
        }
        candidates_[symbol] = match_.candidates(entry.scope, entry.letter);
        const std::vector<const Rule*>& rules = candidates_[symbol];
        if (rules.empty()) return true;
        planned.kind = entry.role == Role::ordinal    ? Kind::multiply
                       : entry.role == Role::follower ? Kind::follow
                                                      : Kind::put;
        const Rule& first = *rules.front();
        planned.image = StepPlan::decided;
        const bool is_certain = first.left.empty() && first.right.empty() && !first.condition &&
                                first.assignments.empty() && first.successors.size() == 1;
        if (!is_certain || !is_fixed(first.successors[0])) return true;
        const std::optional<std::uint32_t> image = image_of(first.successors[0], home_of(entry), 0, match_.names());
        if (!image) return false;
        planned.image = *image;
        return true;
    }

    static Home home_of(const SymbolEntry& entry) { return {entry.scope, entry.gait}; }
    static bool is_fixed(const Successor& successor) {
        return successor.kind == Successor::Kind::pattern && is_constant(successor.pattern);
    }

    std::uint32_t kept_image() {
        if (!kept_) kept_ = add_image({{}, true});
        return *kept_;
    }
    std::uint32_t add_image(Image image) {
        plan_.images.push_back(std::move(image));
        return static_cast<std::uint32_t>(plan_.images.size() - 1);
    }
    // `at`: where the document says them, for what goes wrong.
    std::optional<std::uint32_t> image_of_letters(const std::u32string& letters, const Roles& roles, Home home,
                                                  SourceSpan at) {
        return image_of_symbols(symbols_of(letters, roles, home, derivation_.alphabet), at);
    }
    std::optional<std::uint32_t> image_of_symbols(std::optional<std::vector<Symbol>> symbols, SourceSpan at) {
        if (!symbols) {
            fail(with_span({too_many_symbols()}, at).front());
            return std::nullopt;
        }
        return add_image({std::move(*symbols), false});
    }

    std::optional<std::uint32_t> image_of(const Successor& successor, Home home, std::size_t index,
                                          const Scope& names) {
        if (successor.kind == Successor::Kind::jump) return image_of_jump(successor, home, index, names);
        if (successor.kind == Successor::Kind::lookup) return image_of_lookup(successor.lookup, home, index, names);
        const Pattern* pattern = &successor.pattern;
        if (successor.kind == Successor::Kind::cell) pattern = cell_of(successor, names);
        if (pattern == nullptr) return std::nullopt;
        return image_of_pattern(*pattern, home, names, successor.span);
    }
    // What the target's first rule puts in that iteration; drawn among its successors by the symbol that jumps.
    std::optional<std::uint32_t> image_of_jump(const Successor& jump, Home home, std::size_t index,
                                               const Scope& names) {
        const std::optional<const Rule*> found = match_.first_rule(home.scope, jump.target, jump.target_iteration);
        if (!found) return std::nullopt;
        if (*found == nullptr) return kept_image();
        const Rule& target = **found;
        const std::optional<std::size_t> which =
            match_.draw_successor(target, index, names, RuleMatcher::RuleOf::target);
        if (!which) return std::nullopt;
        if (*which == target.successors.size()) return kept_image();
        const Successor& successor = target.successors[*which];
        if (successor.kind == Successor::Kind::jump) return kept_image();
        return image_of(successor, home, index, names);
    }

    std::optional<std::uint32_t> image_of_lookup(const Lookup& lookup, Home home, std::size_t index,
                                                 const Scope& names) {
        if (!match_.find_positions()) return std::nullopt;
        const std::optional<MapValue> value = match_.value_looked_up(lookup, index);
        if (!value) return kept_image();
        const double number = channel_of(*value, lookup.channel);
        const auto row = std::find_if(lookup.rows.begin(), lookup.rows.end(), [&](const Lookup::Row& some) {
            return some.low <= number && number <= some.high;
        });
        if (row == lookup.rows.end()) return kept_image();
        if (is_constant(row->pattern)) return image_of_pattern(row->pattern, home, names, row->span);
        Scope inner;
        inner.outer = &names;
        set_names(*value, inner);
        return image_of_pattern(row->pattern, home, inner, row->span);
    }

    // Fixed ones are made once an iteration.
    std::optional<std::uint32_t> image_of_pattern(const Pattern& pattern, Home home, const Scope& names,
                                                  SourceSpan at) {
        const bool is_fixed_one = is_constant(pattern);
        if (is_fixed_one) {
            const auto known = images_of_.find({home, &pattern});
            if (known != images_of_.end()) return known->second;
        }
        const Result<std::u32string> letters =
            expanded(pattern, options_.limits.elements,
                     [&](const ExpressionPtr& count) { return match_.value_of(count, names); });
        if (!letters) {
            fail(with_span(letters.diagnostics(), at).front());
            return std::nullopt;
        }
        const std::optional<std::uint32_t> image =
            image_of_letters(*letters, match_.system_of(home.scope).roles, home, at);
        if (image && is_fixed_one) images_of_[{home, &pattern}] = *image;
        return image;
    }

    static double back_inside(double index, double size, OutOfRange way) {
        switch (way) {
            case OutOfRange::wrap:
                return index - size * std::floor(index / size);
            case OutOfRange::clamp:
                return std::clamp(index, 0.0, size - 1);
            case OutOfRange::error:
                break;
        }
        return index;
    }
    const Pattern* cell_of(const Successor& successor, const Scope& names) {
        const Array* array = find_named(grammar_.arrays, successor.array);
        if (array == nullptr || array->sizes.size() != successor.indexes.size()) {
            fail(error("rewriting.unknown-array", "there is no array '" + successor.array + "' with so many indexes",
                       successor.span));
            return nullptr;
        }
        std::size_t cell = 0;
        for (std::size_t i = 0; i < successor.indexes.size(); ++i) {
            const Result<double> index = match_.value_of(successor.indexes[i], names);
            if (!index) {
                fail(index.diagnostics().front());
                return nullptr;
            }
            const double at = back_inside(*index, array->sizes[i], array->out_of_range);
            if (!(at >= 0 && at < array->sizes[i] && *index == std::floor(*index))) {
                fail(error("rewriting.index-out-of-range",
                           "index " + std::to_string(i + 1) + " of '" + array->name +
                               "' must be a whole number from 0 to " + std::to_string(array->sizes[i] - 1),
                           successor.span));
                return nullptr;
            }
            cell = cell * array->sizes[i] + static_cast<std::size_t>(at);
        }
        return &array->cells[cell];
    }

    // --- subsystems ---

    // The axiom of a system that grows, as symbols of a scope of its own: once an iteration, and only where one is put.
    std::optional<std::uint32_t> begun(std::uint32_t system, Symbol symbol) {
        const auto known = begun_.find(symbol);
        if (known != begun_.end()) return known->second;
        const SymbolEntry entry = derivation_.alphabet[symbol];
        const auto next = static_cast<std::uint32_t>(derivation_.scopes.size());
        const auto [scope, is_new] = begun_scopes_.try_emplace({entry.scope, system}, next);
        if (is_new) derivation_.scopes.push_back({system, match_.next_iteration()});
        const std::optional<std::uint32_t> image =
            image_of_pattern(grammar_.systems[system].axiom, {scope->second, gait_within(system, entry)},
                             match_.names(), grammar_.systems[system].axiom_span);
        if (image) begun_.emplace(symbol, *image);
        return image;
    }

    std::uint32_t gait_within(std::uint32_t system, const SymbolEntry& entry) {
        Alphabet& alphabet = derivation_.alphabet;
        return alphabet.number_of(within(grammar_.systems[system].gait, alphabet.gaits()[entry.gait]));
    }

    // The word of a system after all its iterations, as symbols of the system that puts it.
    std::optional<std::uint32_t> grown(std::uint32_t system, const SymbolEntry& entry, std::size_t index) {
        const SourceSpan axiom = grammar_.systems[system].axiom_span;
        if (options_.nested >= most_nested) {
            fail(error("rewriting.endless-subsystem", "a subsystem puts itself, without an end", axiom));
            return std::nullopt;
        }
        DeriveOptions options = options_;
        ++options.nested;
        options.choices = derivation_.choices;
        // Beside the keys of the letters that are put in the symbol's place.
        options.root = child(match_.key_at(index), "system");
        if (derivation_.choices && derivation_.choices->needs_spots()) {
            options.spot = derivation_.choices->spots().below(match_.spot_at(index), "system");
        }
        options.around = derivation_.alphabet.gaits()[entry.gait];
        const Result<Derivation> inner = derive_system(grammar_, options, system, job_);
        if (!inner) {
            fail(inner.diagnostics().front());
            return std::nullopt;
        }
        return image_of_symbols(
            symbols_of(*inner, match_.system_of(entry.scope).roles, entry.scope, derivation_.alphabet), axiom);
    }

    // --- decisions ---

    bool find_resting() {
        const std::vector<Symbol>& symbols = derivation_.word.symbols;
        plan_.resting.resize(symbols.size());
        for (std::size_t place = 0, index = 0; place < symbols.size(); ++place) {
            if (symbols[place] == Alphabet::freeze) continue;
            const std::vector<const Rest*>& rests = rests_[symbols[place]];
            std::optional<const Rest*> rest = nullptr;
            if (!rests.empty()) rest = match_.rest_of(rests, {place, index});
            if (!rest) return false;
            plan_.resting[place] = *rest != nullptr ? 1 : 0;
            ++index;
        }
        return true;
    }

    Diagnostic too_many_elements(std::uint64_t least) const {
        return fault(Fault::limit, "limit.elements",
                     "iteration " + std::to_string(match_.next_iteration()) + " would make a word of " +
                         std::to_string(least) + " symbols and more, where " +
                         std::to_string(options_.limits.elements) + " are allowed");
    }

    bool decide_all() {
        const Word& word = derivation_.word;
        const std::vector<Symbol>& symbols = word.symbols;
        std::size_t index = 0;
        std::uint64_t least = 0, seen = 0;  // symbols of the new word
        for (std::size_t place = 0; place < symbols.size(); ++index) {
            const Symbol symbol = symbols[place];
            const std::size_t freezes = freezes_behind(symbols, place);
            const StepPlan::Entry& entry = plan_.entries[symbol];
            const bool is_awake = !is_asleep(derivation_.alphabet[symbol], freezes) && !plan_.rests(place);
            if (entry.image == StepPlan::decided && is_awake) {
                const std::optional<std::uint32_t> image = decide(symbol, place, index, freezes > 0);
                if (!image) return false;
                plan_.decisions.push_back(*image);
                least += plan_.images[*image].symbols.size();
                // Counted along the way, since what is decided is also held until the word is counted.
                if (least > options_.limits.elements) return fail(too_many_elements(least));
            }
            if ((++seen & 0xFFFF) == 0 && is_cancelled(job_)) return fail(cancelled_diagnostic());
            place += 1 + freezes;
        }
        return true;
    }

    std::optional<std::uint32_t> decide(Symbol symbol, std::size_t place, std::size_t index, bool recalls) {
        const SymbolEntry entry = derivation_.alphabet[symbol];
        if (entry.role == Role::macro) return decide_macro(entry, index, recalls);
        if (entry.role == Role::subsystem) {
            const std::uint32_t system = *find_system(grammar_, entry.letter);
            if (grammar_.systems[system].grows) return begun(system, symbol);
            return grown(system, entry, index);
        }
        for (const Rule* rule : candidates_[symbol]) {
            const std::optional<Verdict> verdict = match_.verdict_of(*rule, {place, index});
            if (!verdict) return std::nullopt;
            if (*verdict != Verdict::applies) continue;
            const Scope& names = match_.names_for(*rule, {place, index});
            const std::optional<std::size_t> which = match_.draw_successor(*rule, index, names);
            if (!which) return std::nullopt;
            if (*which == rule->successors.size()) return kept_image();
            if (!assign(*rule, names)) return std::nullopt;
            const std::optional<std::uint32_t> image = image_of(rule->successors[*which], home_of(entry), index, names);
            const bool stays = image && plan_.images[*image].is_kept;
            if (stays && derivation_.choices) ++derivation_.chosen[match_.key_at(index).value];
            return image;
        }
        return kept_image();
    }

    // Registers as they are before the iteration; assignments are made behind it, from left to right.
    bool assign(const Rule& rule, const Scope& names) {
        for (const Assignment& assignment : rule.assignments) {
            const Result<double> value = match_.value_of(assignment.value, names);
            if (!value) return fail(value.diagnostics().front());
            Register* known = find_named(registers_, assignment.name);
            if (known == nullptr) {
                return fail(error("rewriting.unknown-register", "there is no register '" + assignment.name + "'",
                                  assignment.value->span));
            }
            known->value = *value;
        }
        return true;
    }

    std::optional<std::uint32_t> decide_macro(const SymbolEntry& entry, std::size_t index, bool recalls) {
        const System& system = match_.system_of(entry.scope);
        const auto macro = std::find_if(system.macros.begin(), system.macros.end(),
                                        [&](const Macro& known) { return known.letter == entry.letter; });
        if (macro == system.macros.end()) return kept_image();
        const auto known = derivation_.recalled.find({entry.scope, entry.letter});
        if (recalls && known != derivation_.recalled.end()) {
            return image_of_letters(known->second, system.roles, home_of(entry), {});
        }
        const std::uint64_t ordinal = drawn_[{entry.scope, entry.letter}]++;
        const std::optional<std::u32string> letters = match_.draw_letters(*macro, index, ordinal);
        if (!letters) return std::nullopt;
        if (known == derivation_.recalled.end() || system.recalls_last) {
            derivation_.recalled[{entry.scope, entry.letter}] = *letters;
        }
        return image_of_letters(*letters, system.roles, home_of(entry), {});
    }

    Derivation& derivation_;
    const Grammar& grammar_;
    const DeriveOptions& options_;
    const Job& job_;
    RuleMatcher match_;
    StepPlan plan_;
    std::vector<Register> registers_;                                     // behind the iteration
    std::vector<std::vector<const Rule*>> candidates_;                    // by symbol
    std::vector<std::vector<const Rest*>> rests_;                         // likewise
    std::map<std::pair<Home, const Pattern*>, std::uint32_t> images_of_;  // of fixed patterns
    std::map<Symbol, std::uint32_t> begun_;  // images of axioms, by the symbol that they are put for
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> begun_scopes_;  // by outer scope and system
    std::optional<std::uint32_t> kept_;
    std::map<std::pair<std::uint32_t, char32_t>, std::uint64_t> drawn_;  // so far in this iteration
};

}  // namespace

Result<StepPlan> plan_step(Derivation& derivation, const Grammar& grammar, const DeriveOptions& options,
                           const Job& job) {
    return Planner(derivation, grammar, options, job).run();
}

}  // namespace filigree::rewriting
