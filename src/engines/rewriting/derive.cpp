#include "engines/rewriting/derive.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "engines/rewriting/decide.h"
#include "engines/rewriting/pattern.h"
#include "engines/rewriting/symbol_facts.h"

namespace filigree::rewriting {
namespace {

using Kind = StepPlan::Kind;

constexpr std::uint64_t too_many = UINT64_MAX / 2;

// What most symbols become most of the time, so that one look and one wide store do for each: short fixed images, and
// symbols that stay. Others are `slow`.
struct QuickTable {
    static constexpr std::size_t width = 32;
    static constexpr std::uint8_t slow = 255;

    std::array<std::array<Symbol, width>, max_symbols> images{};
    std::array<std::uint8_t, max_symbols> sizes;

    QuickTable(const StepPlan& plan, const Alphabet& alphabet) {
        sizes.fill(slow);
        for (std::size_t s = 0; s < plan.entries.size(); ++s) {
            const StepPlan::Entry& entry = plan.entries[s];
            const Role role = alphabet[static_cast<Symbol>(s)].role;
            if (role == Role::freeze || role == Role::ordinal) continue;
            if (entry.kind == Kind::keep) {
                images[s][0] = static_cast<Symbol>(s);
                sizes[s] = 1;
            }
            if (entry.kind != Kind::put || entry.image == StepPlan::decided) continue;
            const Image& image = plan.images[entry.image];
            if (image.is_kept || image.symbols.size() > width) continue;
            std::copy(image.symbols.begin(), image.symbols.end(), images[s].begin());
            sizes[s] = static_cast<std::uint8_t>(image.symbols.size());
        }
    }
};

// Counts what is put.
struct Counting {
    static constexpr bool is_quick = true;
    std::uint64_t symbols = 0;

    void put_quickly(const std::array<Symbol, QuickTable::width>&, std::uint8_t count) { symbols += count; }

    void put(const Symbol*, std::uint64_t count, std::size_t) { add(count); }
    void put_times(const Symbol*, std::uint64_t count, std::uint64_t times, std::size_t, std::uint32_t) {
        add(count != 0 && times > too_many / count ? too_many : count * times);
    }
    void copy_all(const Word& word, std::size_t) { add(word.size()); }
    void keep(const Word&, std::size_t, std::size_t freezes) { add(1 + freezes); }
    void repeat(Symbol, std::uint64_t count) { add(count); }
    void add(std::uint64_t count) { symbols = std::min(too_many, symbols + count); }
};

// Writes symbols alone; there must be room for a wide store behind the last.
struct Writing {
    static constexpr bool is_quick = true;
    Symbol* to = nullptr;

    void put_quickly(const std::array<Symbol, QuickTable::width>& symbols, std::uint8_t count) {
        std::memcpy(to, symbols.data(), QuickTable::width);
        to += count;
    }

    void put(const Symbol* symbols, std::uint64_t count, std::size_t) { to = std::copy_n(symbols, count, to); }
    void put_times(const Symbol* symbols, std::uint64_t count, std::uint64_t times, std::size_t, std::uint32_t) {
        for (; times > 0; --times) to = std::copy_n(symbols, count, to);
    }
    void copy_all(const Word& word, std::size_t) { to = std::copy(word.symbols.begin(), word.symbols.end(), to); }
    void keep(const Word& word, std::size_t place, std::size_t freezes) {
        *to++ = word.symbols[place];
        to = std::fill_n(to, freezes, Alphabet::freeze);
    }
    void repeat(Symbol symbol, std::uint64_t count) { to = std::fill_n(to, count, symbol); }
};

// Writes all columns that the old word has.
class WritingColumns {
public:
    static constexpr bool is_quick = false;

    WritingColumns(const Word& from, const Alphabet& alphabet, bool ages_by_lineage)
        : from_(from), alphabet_(alphabet), ages_by_lineage_(ages_by_lineage) {
        stays.assign(from.ages.size(), 0);
    }

    void put(const Symbol* symbols, std::uint64_t count, std::size_t place) { put_times(symbols, count, 1, place, 0); }
    // `origin`: of what an n or ñ puts; 0 for other symbols.
    void put_times(const Symbol* symbols, std::uint64_t count, std::uint64_t times, std::size_t place,
                   std::uint32_t origin) {
        bool was_met = false;
        for (std::uint64_t i = 0; i < count * times; ++i) {
            const Symbol symbol = symbols[i % count];
            if (symbol == Alphabet::freeze) {
                out.symbols.push_back(symbol);
                continue;
            }
            const bool is_own = alphabet_[symbol].letter == letter_at(place);
            const bool inherits = is_own && !was_met;
            was_met = was_met || is_own;
            const bool is_follower = alphabet_[symbol].role == Role::follower;
            const std::uint32_t made_by = origin != 0 ? origin : 1;
            add(symbol, is_follower ? made_by : 0, child_key(), inherits ? age_at() + 1 : 1);
        }
        if (was_met) set_stays();
    }
    void copy_all(const Word& word, std::size_t place) {
        std::size_t other = 0;
        bool was_met = false;
        for (const Symbol symbol : word.symbols) {
            if (symbol == Alphabet::freeze) {
                out.symbols.push_back(symbol);
                continue;
            }
            const bool inherits = !was_met && alphabet_[symbol].letter == letter_at(place);
            was_met = was_met || inherits;
            add(symbol, word.origins.empty() ? 0 : word.origins[other], child_key(), inherits ? age_at() + 1 : 1);
            ++other;
        }
        set_stays();
    }
    void keep(const Word& word, std::size_t place, std::size_t freezes) {
        add(word.symbols[place], origin_at(), key_at(), age_at() + 1);
        out.symbols.insert(out.symbols.end(), freezes, Alphabet::freeze);
        set_stays();
    }
    // More of a run, behind its last member.
    void repeat(Symbol symbol, std::uint64_t count) {
        for (; count > 0; --count) add(symbol, 0, child_key(), 1);
    }

    // Which symbol of the old word comes next, counted without '='.
    void at(std::size_t index) {
        index_ = index;
        children_ = 0;
    }

    Word out;
    std::vector<std::uint8_t> stays;  // for each symbol of the old word: whether it could still stand where it stood

private:
    char32_t letter_at(std::size_t place) const { return alphabet_[from_.symbols[place]].letter; }
    std::uint32_t origin_at() const { return from_.origins.empty() ? 0 : from_.origins[index_]; }
    std::uint64_t key_at() const { return from_.keys.empty() ? 0 : from_.keys[index_]; }
    std::uint32_t age_at() const { return from_.ages.empty() ? 0 : from_.ages[index_]; }
    std::uint64_t child_key() { return from_.keys.empty() ? 0 : fold(key_at(), children_++); }
    void set_stays() {
        if (!stays.empty()) stays[index_] = 1;
    }
    void add(Symbol symbol, std::uint32_t origin, std::uint64_t key, std::uint32_t age) {
        out.symbols.push_back(symbol);
        if (!from_.origins.empty()) out.origins.push_back(origin);
        if (!from_.keys.empty()) out.keys.push_back(key);
        if (!from_.ages.empty()) out.ages.push_back(ages_by_lineage_ ? age : 1);
    }

    const Word& from_;
    const Alphabet& alphabet_;
    const bool ages_by_lineage_;
    std::size_t index_ = 0;
    std::uint64_t children_ = 0;
};

// Writes who puts each symbol, '=' left out.
struct Tracing {
    static constexpr bool is_quick = false;
    std::vector<std::uint32_t>& parents;
    std::size_t index = 0;

    void put(const Symbol* symbols, std::uint64_t count, std::size_t place) { put_times(symbols, count, 1, place, 0); }
    void put_times(const Symbol* symbols, std::uint64_t count, std::uint64_t times, std::size_t, std::uint32_t) {
        add(static_cast<std::uint64_t>(std::count_if(symbols, symbols + count, is_no_freeze)) * times);
    }
    void copy_all(const Word& word, std::size_t) {
        add(static_cast<std::uint64_t>(std::count_if(word.symbols.begin(), word.symbols.end(), is_no_freeze)));
    }
    void keep(const Word&, std::size_t, std::size_t) { add(1); }
    void repeat(Symbol, std::uint64_t count) { add(count); }

private:
    static bool is_no_freeze(Symbol symbol) { return symbol != Alphabet::freeze; }
    void add(std::uint64_t count) { parents.insert(parents.end(), count, static_cast<std::uint32_t>(index)); }
};

template <class Out>
void tell_place(Out&, std::size_t) {}
void tell_place(WritingColumns& out, std::size_t index) { out.at(index); }
void tell_place(Tracing& out, std::size_t index) { out.index = index; }

// Rewrites the whole word. q and g: only the last of a run can be frozen, which ends the run and holds it.
template <class Out>
void rewrite(const Word& word, const Alphabet& alphabet, const StepPlan& plan, const QuickTable& quick, Out& out) {
    const std::vector<Symbol>& symbols = word.symbols;
    const bool has_freezes = std::find(symbols.begin(), symbols.end(), Alphabet::freeze) != symbols.end();
    std::size_t decided = 0, index = 0;
    std::uint32_t ordinal = 0;
    for (std::size_t place = 0; place < symbols.size(); ++index) {
        const Symbol symbol = symbols[place];
        if constexpr (Out::is_quick) {
            const std::uint8_t size = quick.sizes[symbol];
            const bool is_awake = !has_freezes || place + 1 == symbols.size() || symbols[place + 1] != Alphabet::freeze;
            if (size != QuickTable::slow && is_awake) {
                out.put_quickly(quick.images[symbol], size);
                ++place;
                continue;
            }
        }
        const StepPlan::Entry& entry = plan.entries[symbol];
        tell_place(out, index);
        const std::size_t freezes = has_freezes ? freezes_behind(symbols, place) : 0;
        if (alphabet[symbol].role == Role::ordinal) ++ordinal;
        const bool stays = is_asleep(alphabet[symbol], freezes) || (entry.kind == Kind::keep && freezes > 0);
        if (stays && entry.kind != Kind::count) {
            out.keep(word, place, freezes - 1);
            place += 1 + freezes;
            continue;
        }
        const auto put_image = [&](std::uint64_t times, std::uint32_t origin) {
            const Image& image =
                plan.images[entry.image == StepPlan::decided ? plan.decisions[decided++] : entry.image];
            if (image.is_kept) {
                out.keep(word, place, 0);
            } else if (times == 1 && origin == 0) {
                out.put(image.symbols.data(), image.symbols.size(), place);
            } else {
                out.put_times(image.symbols.data(), image.symbols.size(), times, place, origin);
            }
        };
        switch (entry.kind) {
            case Kind::keep:
            case Kind::invert:  // one without a run before it
                out.keep(word, place, 0);
                break;
            case Kind::put:
                put_image(1, 0);
                place += freezes;  // of a macro
                break;
            case Kind::multiply:
                put_image(ordinal, ordinal);
                break;
            case Kind::follow: {
                const std::uint32_t origin = word.origins.empty() ? 1 : word.origins[index];
                put_image(origin, origin);
                break;
            }
            case Kind::repeat:
                out.copy_all(word, place);
                break;
            case Kind::count: {
                // The run, to the first frozen member; then perhaps its inverter.
                std::size_t length = 1, behind = place;
                std::size_t held = freezes;
                while (held == 0 && behind + 1 < symbols.size() && symbols[behind + 1] == symbol) {
                    ++behind;
                    ++length;
                    held = freezes_behind(symbols, behind);
                }
                const std::size_t after = behind + 1 + held;
                const bool has_inverter = after < symbols.size() && plan.entries[symbols[after]].kind == Kind::invert &&
                                          alphabet[symbols[after]].scope == alphabet[symbol].scope;
                const bool sleeps = has_inverter && freezes_behind(symbols, after) > 0;
                const bool shrinks = held == 0 && has_inverter && !sleeps;
                const std::uint64_t gain = entry.gain;
                const std::uint64_t kept = shrinks ? length - std::min<std::uint64_t>(length, gain) : length;
                for (std::uint64_t k = 0; k < kept; ++k) {
                    tell_place(out, index + k);
                    out.keep(word, place + k, k + 1 == length && held > 0 ? held - 1 : 0);
                }
                if (held == 0 && !shrinks) out.repeat(symbol, gain);
                index += length - 1;
                place = after - 1;
                break;
            }
        }
        ++place;
    }
}

// Whether a symbol is as old as the place that it holds ("whenever a symbol maintains in the same position").
void set_ages_by_position(const Word& from, const Alphabet& alphabet, const std::vector<std::uint8_t>& stays,
                          Word& to) {
    std::size_t old_place = 0, place = 0;
    for (std::size_t index = 0; index < to.ages.size() && index < from.ages.size(); ++index, ++old_place, ++place) {
        while (from.symbols[old_place] == Alphabet::freeze) ++old_place;
        while (to.symbols[place] == Alphabet::freeze) ++place;
        const bool is_alike = alphabet[from.symbols[old_place]].letter == alphabet[to.symbols[place]].letter;
        if (stays[index] != 0 && is_alike) to.ages[index] = from.ages[index] + 1;
    }
}

// '=' behind nothing.
void drop_leading_freezes(std::vector<Symbol>& symbols) {
    const auto first =
        std::find_if(symbols.begin(), symbols.end(), [](Symbol symbol) { return symbol != Alphabet::freeze; });
    symbols.erase(symbols.begin(), first);
}

Word rewritten(const Word& word, const Alphabet& alphabet, const StepPlan& plan, const QuickTable& quick,
               std::uint64_t symbols, AgeMode mode) {
    if (word.origins.empty() && word.keys.empty() && word.ages.empty()) {
        Word made;
        made.symbols.resize(symbols + QuickTable::width);
        Writing writing{made.symbols.data()};
        rewrite(word, alphabet, plan, quick, writing);
        made.symbols.resize(symbols);
        return made;
    }
    WritingColumns writing(word, alphabet, mode == AgeMode::lineage);
    writing.out.symbols.reserve(symbols);
    rewrite(word, alphabet, plan, quick, writing);
    if (!word.ages.empty() && mode == AgeMode::position)
        set_ages_by_position(word, alphabet, writing.stays, writing.out);
    return std::move(writing.out);
}

std::optional<Diagnostic> too_large(std::uint64_t symbols, const Word& like, std::uint32_t iteration,
                                    const Limits& limits) {
    const std::uint64_t each =
        1 + (like.origins.empty() ? 0 : 4) + (like.keys.empty() ? 0 : 8) + (like.ages.empty() ? 0 : 4);
    const std::string of_iteration = "iteration " + std::to_string(iteration) + " would make a word of ";
    const std::string count = symbols >= too_many ? "too many to count" : std::to_string(symbols);
    if (symbols > limits.elements) {
        return fault(Fault::limit, "limit.elements",
                     of_iteration + count + " symbols, where " + std::to_string(limits.elements) + " are allowed");
    }
    if (symbols * each > limits.memory_bytes) {
        return fault(Fault::limit, "limit.memory", of_iteration + count + " symbols, which takes too much memory");
    }
    return std::nullopt;
}

bool mentions(const std::vector<Pattern::Part>& parts, const std::u32string& letters) {
    return std::any_of(parts.begin(), parts.end(), [&](const Pattern::Part& part) {
        return part.letters.find_first_of(letters) != std::u32string::npos || mentions(part.repeated, letters);
    });
}

// Whether a symbol with an origin may arise, in any system.
bool has_followers(const Grammar& grammar) {
    std::u32string letters;
    for (const System& system : grammar.systems) letters += system.roles.followers;
    const auto is_met = [&](const Pattern& pattern) { return mentions(pattern.parts, letters); };
    if (letters.empty()) return false;
    for (const Array& array : grammar.arrays) {
        if (std::any_of(array.cells.begin(), array.cells.end(), is_met)) return true;
    }
    for (const System& system : grammar.systems) {
        if (is_met(system.axiom)) return true;
        for (const Rule& rule : system.rules) {
            for (const Successor& successor : rule.successors) {
                if (is_met(successor.pattern)) return true;
            }
        }
    }
    return false;
}

bool draws(const Grammar& grammar) {
    return std::any_of(grammar.systems.begin(), grammar.systems.end(), [](const System& system) {
        const bool has_alternatives = std::any_of(system.rules.begin(), system.rules.end(),
                                                  [](const Rule& rule) { return rule.successors.size() > 1; });
        return has_alternatives || !system.macros.empty();
    });
}

}  // namespace

std::optional<std::vector<Symbol>> symbols_of(std::u32string_view letters, const Roles& roles, std::uint32_t scope,
                                              Alphabet& alphabet) {
    std::vector<Symbol> symbols;
    symbols.reserve(letters.size());
    bool is_behind_run = false;
    for (const char32_t letter : letters) {
        Role role = roles.of(letter);
        if (is_behind_run && roles.inverters.find(letter) != std::u32string::npos) role = Role::inverter;
        const std::optional<Symbol> symbol = alphabet.number_of({letter, role, scope});
        if (!symbol) return std::nullopt;
        symbols.push_back(*symbol);
        if (role != Role::freeze) is_behind_run = role == Role::counter;
    }
    return symbols;
}

Result<Derivation> begin(const Grammar& grammar, const DeriveOptions& options, std::uint32_t which) {
    const System& system = grammar.systems[which];
    Derivation derivation;
    derivation.scopes.push_back({which, 0});
    derivation.registers = grammar.registers;
    Scope names;
    names.outer = options.globals;
    for (const Register& known : grammar.registers) names.names[known.name] = Value{Quantity{known.value}, {}};
    Evaluation at;
    at.document = options.document;
    at.scope = &names;
    const Result<std::u32string> axiom =
        expanded(system.axiom, options.limits.elements, [&](const ExpressionPtr& count) -> Result<double> {
            const Result<Value> value = evaluate(*count, at);
            if (!value) return value.diagnostics();
            return as_number(*value);
        });
    if (!axiom) return axiom.diagnostics();
    std::optional<std::vector<Symbol>> symbols = symbols_of(*axiom, system.roles, 0, derivation.alphabet);
    if (!symbols) return too_many_symbols();
    drop_leading_freezes(*symbols);
    Word& word = derivation.word;
    word.symbols = std::move(*symbols);
    const bool with_origins = has_followers(grammar);
    const bool with_keys = draws(grammar) && grammar.draws == DrawMode::lineage;
    const bool with_ages = options.with_ages || has(facts_asked(grammar), Fact::age);
    std::uint64_t index = 0;
    for (const Symbol symbol : word.symbols) {
        if (symbol == Alphabet::freeze) continue;
        const bool is_follower = derivation.alphabet[symbol].role == Role::follower;
        if (with_origins) word.origins.push_back(is_follower ? 1 : 0);
        if (with_keys) word.keys.push_back(fold(options.root.value, index));
        if (with_ages) word.ages.push_back(1);
        ++index;
    }
    return derivation;
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
    const QuickTable quick(*plan, next.alphabet);
    Counting counting;
    rewrite(next.word, next.alphabet, *plan, quick, counting);
    if (std::optional<Diagnostic> problem = too_large(counting.symbols, next.word, next.iteration, options.limits)) {
        return give_up(std::move(*problem));
    }
    if (is_cancelled(job)) return give_up(cancelled_diagnostic());
    Word made = rewritten(next.word, next.alphabet, *plan, quick, counting.symbols, grammar.ages);
    drop_leading_freezes(made.symbols);
    if (parents != nullptr) {
        parents->clear();
        Tracing tracing{*parents};
        rewrite(next.word, next.alphabet, *plan, quick, tracing);
    }
    next.word = std::move(made);
    derivation = std::move(next);
    return std::nullopt;
}

}  // namespace filigree::rewriting
