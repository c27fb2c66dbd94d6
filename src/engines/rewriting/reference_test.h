// For tests alone: gdesign once more, slowly and obviously, as the other opinion on what a grammar means.
//
// A word is a list of units, each with all that is known of it; an iteration asks every unit, one by one, what becomes
// of it, and looks over the whole word whenever it must. Nothing is shared with the engine but the grammar as data, the
// roles of letters, expressions and the arithmetic of randomness.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/random.h"
#include "base/unicode.h"
#include "engines/rewriting/grammar.h"
#include "language/evaluate.h"

namespace filigree::rewriting::reference {

// The system that rewrites a unit, and the iteration that put the first of that system (0: it was there at the start).
struct Instance {
    std::uint32_t system = 0, born = 0;

    bool operator==(const Instance&) const = default;
};

struct Unit {
    char32_t letter = 0;
    std::uint32_t freezes = 0;  // '=' behind it
    std::uint32_t origin = 0;   // of an n-tilde
    bool is_inverter = false;
    Instance instance;
    Gait gait;
    std::uint64_t key = 0;
    std::uint32_t age = 1;
};
using Units = std::vector<Unit>;

enum class Outcome : std::uint8_t { fine, too_large, wrong };

struct State {
    struct Memory {
        Instance instance;
        char32_t letter = 0;
        std::u32string drawn;
    };
    struct Row {
        Instance instance;
        char32_t letter = 0;
        std::size_t row = 0;
        std::uint64_t left = 0;
        bool is_over = false;
    };

    std::uint64_t seed = 0;
    Key root;
    bool is_inner = false;    // of a subsystem that is put at once
    std::size_t most = 2000;  // units
    std::uint32_t system = 0;
    Gait around;  // of the unit in whose place the word will stand
    std::uint32_t iteration = 0;
    Units word;
    std::vector<Register> registers;
    std::vector<Memory> memories;
    std::vector<Row> rows;
};

inline bool contains(std::u32string_view letters, char32_t letter) {
    return letters.find(letter) != std::u32string_view::npos;
}

inline std::u32string text_of(const Units& word) {
    std::u32string text;
    for (const Unit& unit : word) text += unit.letter + std::u32string(unit.freezes, U'=');
    return text;
}

// A text as units, '=' being units of their own.
inline Units units_of(std::u32string_view text, const Grammar& grammar, Instance instance, const Gait& gait) {
    const Roles& roles = grammar.systems[instance.system].roles;
    Units units;
    bool is_behind_counter = false;
    for (const char32_t letter : text) {
        Unit unit;
        unit.letter = letter;
        unit.instance = instance;
        unit.gait = gait;
        if (letter != U'=') {
            unit.is_inverter = is_behind_counter && contains(roles.inverters, letter);
            is_behind_counter = roles.of(letter) == Role::counter;
            if (roles.of(letter) == Role::follower) unit.origin = 1;
        }
        units.push_back(unit);
    }
    return units;
}

// That of a system, put where another was.
inline Gait gait_of(const System& system, Gait gait) {
    if (system.gait.angle) gait.angle = system.gait.angle;
    if (system.gait.angle2) gait.angle2 = system.gait.angle2;
    if (system.gait.step) gait.step = system.gait.step;
    return gait;
}

// Every '=' goes to the unit before it; where there is none, it is dropped.
inline Units with_freezes_attached(const Units& flat) {
    Units word;
    for (const Unit& unit : flat) {
        if (unit.letter != U'=') {
            word.push_back(unit);
        } else if (!word.empty()) {
            ++word.back().freezes;
        }
    }
    return word;
}

// What is asked of expressions: at a unit of a word, or nowhere in it.
class Asking {
public:
    explicit Asking(const std::vector<Register>& registers) {
        for (const Register& known : registers) set(known.name, known.value);
    }
    Asking& knows(const std::string& name, double value) {
        set(name, value);
        return *this;
    }

    std::optional<double> number(const ExpressionPtr& expression) const {
        const Result<Value> value = asked(expression);
        if (!value) return std::nullopt;
        const Result<double> number = as_number(*value);
        return number ? std::optional(*number) : std::nullopt;
    }
    std::optional<bool> flag(const ExpressionPtr& expression) const {
        const Result<Value> value = asked(expression);
        if (!value) return std::nullopt;
        const Result<bool> flag = as_flag(*value);
        return flag ? std::optional(*flag) : std::nullopt;
    }

private:
    void set(const std::string& name, double value) { scope_.names[name].data = Quantity{value, 0, false}; }
    Result<Value> asked(const ExpressionPtr& expression) const {
        Evaluation evaluation;
        evaluation.scope = &scope_;
        return evaluate(*expression, evaluation);
    }

    Scope scope_;
};

// None where a number of repeats has no value.
inline std::optional<std::u32string> written_out(const std::vector<Pattern::Part>& parts, const Asking& asking,
                                                 std::size_t most) {
    std::u32string text;
    for (const Pattern::Part& part : parts) {
        if (!part.count) {
            text += part.letters;
            continue;
        }
        const std::optional<double> count = asking.number(part.count);
        if (!count) return std::nullopt;
        if (*count < 1) continue;
        const std::optional<std::u32string> once = written_out(part.repeated, asking, most);
        if (!once) return std::nullopt;
        for (double k = 1; k <= *count && text.size() <= most; ++k) text += *once;
    }
    return text;
}

Outcome step(State& state, const Grammar& grammar);

// The axiom of a system.
inline Outcome begin(State& state, const Grammar& grammar, std::uint64_t seed, Key root, std::uint32_t system = 0) {
    state.seed = seed;
    state.root = root;
    state.system = system;
    state.registers = grammar.registers;
    const auto text = written_out(grammar.systems[system].axiom.parts, Asking(state.registers), state.most);
    if (!text) return Outcome::wrong;
    const Gait gait = gait_of(grammar.systems[system], state.around);
    state.word = with_freezes_attached(units_of(*text, grammar, {system, 0}, gait));
    for (std::size_t i = 0; i < state.word.size(); ++i) state.word[i].key = fold(root.value, i);
    return state.word.size() > state.most ? Outcome::too_large : Outcome::fine;
}

// One iteration under way.
class Iteration {
public:
    Iteration(State& state, const Grammar& grammar)
        : state_(state), grammar_(grammar), old_(state.word), now_(state.iteration + 1) {}

    Outcome run() {
        advance_all_rows();
        std::vector<Change> changes;
        std::size_t size = 0;
        for (std::size_t p = 0; p < old_.size() && outcome_ == Outcome::fine; ++p) {
            changes.push_back(change_of(p));
            size += changes.back().put.size();
            if (size > state_.most) fail(Outcome::too_large);
        }
        if (outcome_ != Outcome::fine) return outcome_;
        Units flat;
        for (const Change& change : changes) flat.insert(flat.end(), change.put.begin(), change.put.end());
        Units made = with_freezes_attached(flat);
        if (grammar_.ages == AgeMode::position) set_ages_by_position(made, changes);
        for (const auto& [name, value] : assigned_) {
            for (Register& known : state_.registers) {
                if (known.name == name) known.value = value;
            }
        }
        state_.word = made;
        state_.iteration = now_;
        return Outcome::fine;
    }

private:
    struct Change {
        Units put;               // with units of '='
        bool is_copied = false;  // the unit itself is among them
    };

    void fail(Outcome outcome) {
        if (outcome_ == Outcome::fine) outcome_ = outcome;
    }
    const System& system_of(Instance instance) const { return grammar_.systems[instance.system]; }
    // The number of the iteration being made as the unit's own system counts.
    std::uint32_t clock(Instance instance) const { return now_ - instance.born; }
    bool is_over(Instance instance) const {
        const bool is_grown = !(instance == Instance{state_.system, 0});
        return is_grown && clock(instance) > system_of(instance).iterations;
    }
    // Those that draw something: all but axis letters and signs.
    static bool is_object(const Unit& unit) {
        return !contains(U"PTDXYZ", unit.letter) && unicode::is_letter(unit.letter);
    }
    std::size_t count_of(char32_t letter) const {
        std::size_t count = 0;
        for (const Unit& unit : old_) count += unit.letter == letter ? 1 : 0;
        return count;
    }
    // Of all units of a letter.
    Asking asking(std::uint32_t iteration, char32_t letter) const {
        return Asking(state_.registers).knows("t", iteration).knows("count", static_cast<double>(count_of(letter)));
    }
    Asking asking(std::size_t p) const {
        // The open brackets before it, the innermost behind; closed branches count for nothing on the way to it.
        std::vector<std::size_t> open;
        std::vector<bool> is_on_the_way(p, true);
        for (std::size_t i = 0; i < p; ++i) {
            if (old_[i].letter == U'[') open.push_back(i);
            if (old_[i].letter != U']' || open.empty()) continue;
            for (std::size_t k = open.back(); k <= i; ++k) is_on_the_way[k] = false;
            open.pop_back();
        }
        if (old_[p].letter == U']' && !open.empty()) {
            for (std::size_t k = open.back(); k < p; ++k) is_on_the_way[k] = false;
            open.pop_back();
        }
        std::size_t distance = 0;
        for (std::size_t i = 0; i < p; ++i) distance += is_on_the_way[i] && is_object(old_[i]) ? 1 : 0;
        const std::size_t begin = open.empty() ? 0 : open.back() + 1;
        const std::size_t end = open.empty() ? old_.size() : partner(open.back()).value_or(old_.size());
        std::map<char32_t, double> counts;
        double objects = 0, squares = 0;
        for (std::size_t i = begin; i < end; ++i) {
            if (!is_object(old_[i])) continue;
            ++counts[old_[i].letter];
            ++objects;
        }
        for (const auto& [letter, count] : counts) squares += count * count;
        return asking(clock(old_[p].instance), old_[p].letter)
            .knows("age", old_[p].age)
            .knows("index", static_cast<double>(p))
            .knows("depth", static_cast<double>(open.size()))
            .knows("distance", static_cast<double>(distance))
            .knows("density", objects)
            .knows("homogeneity", objects > 0 ? squares / (objects * objects) : 0);
    }

    // --- rows ---

    std::vector<const Rule*> rules_of(Instance instance, char32_t letter) const {
        std::vector<const Rule*> rules;
        for (const Rule& rule : system_of(instance).rules) {
            if (rule.letter == letter) rules.push_back(&rule);
        }
        return rules;
    }
    // Of the k-th rule, from 0.
    ExpressionPtr loop_of(Instance instance, char32_t letter, std::size_t k) const {
        const Rule* rule = rules_of(instance, letter)[k];
        if (rule->loop) return rule->loop;
        ExpressionPtr length;
        for (const RowLoop& loop : system_of(instance).loops) {
            if (loop.letter == letter && loop.first <= k + 1 && k + 1 <= loop.last) length = loop.length;
        }
        return length;
    }
    bool has_rows(Instance instance, char32_t letter) const {
        bool has = false;
        for (std::size_t k = 0; k < rules_of(instance, letter).size(); ++k) {
            has = has || loop_of(instance, letter, k);
        }
        return has;
    }
    State::Row& row_of(Instance instance, char32_t letter) {
        for (State::Row& row : state_.rows) {
            if (row.instance == instance && row.letter == letter) return row;
        }
        state_.rows.push_back(before_rows(instance, letter));
        return state_.rows.back();
    }
    static State::Row before_rows(Instance instance, char32_t letter) {
        return {instance, letter, std::numeric_limits<std::size_t>::max(), 0, false};
    }
    void advance_all_rows() {
        std::vector<Instance> instances = {{state_.system, 0}};
        for (const Unit& unit : old_) {
            bool is_known = false;
            for (const Instance known : instances) is_known = is_known || known == unit.instance;
            if (!is_known) instances.push_back(unit.instance);
        }
        for (const Instance instance : instances) {
            std::u32string done;
            for (const Rule& rule : system_of(instance).rules) {
                if (contains(done, rule.letter) || !has_rows(instance, rule.letter)) continue;
                done += rule.letter;
                if (!is_over(instance)) advance(row_of(instance, rule.letter), clock(instance));
            }
        }
    }
    // To the row that serves the next iteration of the instance, which is said.
    void advance(State::Row& row, std::uint32_t iteration) {
        const std::vector<const Rule*> rules = rules_of(row.instance, row.letter);
        const AfterRows after = system_of(row.instance).after;
        for (std::size_t tries = 0; row.left == 0 && !row.is_over; ++tries) {
            ++row.row;
            if (row.row == rules.size() && after == AfterRows::cycle) row.row = 0;
            if (row.row == rules.size() && after == AfterRows::hold) {
                row.row = rules.size() - 1;
                row.left = std::numeric_limits<std::uint64_t>::max();
                break;
            }
            if (row.row == rules.size() || tries > rules.size()) {
                row.is_over = true;
                break;
            }
            double length = 1;
            if (const ExpressionPtr loop = loop_of(row.instance, row.letter, row.row)) {
                const auto asked = asking(iteration, row.letter).number(loop);
                if (!asked || *asked < 0) return fail(Outcome::wrong);
                length = *asked;
            }
            row.left = length >= 1 ? static_cast<std::uint64_t>(length) : 0;
        }
        if (!row.is_over) --row.left;
    }

    // --- contexts ---

    // The bracket that belongs to the one at `p`, looking one way; none where there is none.
    std::optional<std::size_t> partner(std::size_t p) const {
        const bool looks_right = old_[p].letter == U'[';
        int open = 0;
        for (std::size_t i = p; i < old_.size(); looks_right ? ++i : --i) {  // below 0 wraps to beyond the end
            if (old_[i].letter == U'[') ++open;
            if (old_[i].letter == U']') --open;
            if (open == 0) return i;
        }
        return std::nullopt;
    }
    bool has_left(std::size_t p, std::u32string_view pattern, std::u32string_view ignored) const {
        if (pattern.empty()) return true;
        for (std::size_t i = p; i-- > 0;) {
            const char32_t letter = old_[i].letter;
            if (letter == U']') {
                const std::optional<std::size_t> open = partner(i);
                if (!open) return false;
                i = *open;
                continue;
            }
            if (letter == U'[' || contains(ignored, letter)) continue;
            return letter == pattern.back() && has_left(i, pattern.substr(0, pattern.size() - 1), ignored);
        }
        return false;
    }
    // From p on.
    bool has_right(std::size_t p, std::u32string_view pattern, std::u32string_view ignored) const {
        if (pattern.empty()) return true;
        if (p >= old_.size()) return false;
        const char32_t letter = old_[p].letter;
        if (letter != U'[' && letter != U']' && contains(ignored, letter)) return has_right(p + 1, pattern, ignored);
        if (letter == U']') return false;
        if (letter == U'[') {
            const std::optional<std::size_t> close = partner(p);
            if (!close) return false;
            if (pattern[0] != U'[') return has_right(*close + 1, pattern, ignored);
            std::size_t end = 0;
            int open = 0;
            do {
                open += pattern[end] == U'[' ? 1 : pattern[end] == U']' ? -1 : 0;
                ++end;
            } while (open > 0);
            return has_right(p + 1, pattern.substr(1, end - 2), ignored) &&
                   has_right(*close + 1, pattern.substr(end), ignored);
        }
        return letter == pattern[0] && has_right(p + 1, pattern.substr(1), ignored);
    }

    // --- rules ---

    // Null where none applies.
    const Rule* rule_for(std::size_t p) {
        const Unit& unit = old_[p];
        const std::u32string& ignored = system_of(unit.instance).ignored;
        const std::vector<const Rule*> rules = rules_of(unit.instance, unit.letter);
        for (std::size_t k = 0; k < rules.size(); ++k) {
            const Rule& rule = *rules[k];
            if (has_rows(unit.instance, unit.letter)) {
                const State::Row& row = row_of(unit.instance, unit.letter);
                if (row.is_over || row.row != k) continue;
            }
            if (clock(unit.instance) < rule.first || clock(unit.instance) > rule.last) continue;
            if (!has_left(p, rule.left, ignored) || !has_right(p + 1, rule.right, ignored)) continue;
            if (rule.condition) {
                const std::optional<bool> holds = asking(p).flag(rule.condition);
                if (!holds) fail(Outcome::wrong);
                if (!holds || !*holds) continue;
            }
            return &rule;
        }
        return nullptr;
    }
    std::uint64_t bits_at(std::size_t p, std::uint64_t stream, std::uint64_t ordinal, std::uint64_t draw) const {
        if (grammar_.draws == DrawMode::lineage) return random_bits(state_.seed, Key{old_[p].key}, stream, draw);
        const std::uint64_t seed = state_.is_inner ? fold(state_.seed, state_.root.value) : state_.seed;
        return fold(fold(fold(fold(seed, stream), now_), ordinal), draw);
    }
    // Null where no weight is above zero.
    const Successor* drawn_from(const Rule& rule, std::size_t p) {
        const Successor* winner = nullptr;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < rule.successors.size(); ++k) {
            const Successor& successor = rule.successors[k];
            std::optional<double> weight = 1;
            if (successor.weight) weight = asking(p).number(successor.weight);
            if (!weight || *weight < 0) {
                fail(Outcome::wrong);
                return nullptr;
            }
            const double time = race_time(fold(bits_at(p, 0, p, 0), k), *weight);
            if (time < least) {
                least = time;
                winner = &successor;
            }
        }
        return winner;
    }
    // None where a jump finds nothing. It takes what the first rule of that iteration puts, whatever its letter must
    // stand between elsewhere, and does not go on to another.
    std::optional<std::u32string> text_put(const Successor& successor, std::size_t p, bool may_jump = true) {
        switch (successor.kind) {
            case Successor::Kind::pattern:
                return written(successor.pattern, p);
            case Successor::Kind::cell:
                return cell(successor, p);
            case Successor::Kind::lookup:  // not known here
            case Successor::Kind::jump:
                break;
        }
        if (!may_jump) return std::nullopt;
        const Instance instance = old_[p].instance;
        const std::vector<const Rule*> rules = rules_of(instance, successor.target);
        State::Row row = before_rows(instance, successor.target);
        if (has_rows(instance, successor.target)) {
            for (std::uint32_t i = 1; i <= successor.target_iteration; ++i) advance(row, i);
        }
        for (std::size_t k = 0; k < rules.size(); ++k) {
            if (has_rows(instance, successor.target) && (row.is_over || row.row != k)) continue;
            if (successor.target_iteration < rules[k]->first || successor.target_iteration > rules[k]->last) continue;
            const Successor* taken = drawn_from(*rules[k], p);
            return taken == nullptr ? std::nullopt : text_put(*taken, p, false);
        }
        return std::nullopt;
    }
    std::optional<std::u32string> written(const Pattern& pattern, std::size_t p) {
        std::optional<std::u32string> text = written_out(pattern.parts, asking(p), state_.most);
        if (!text) fail(Outcome::wrong);
        return text;
    }
    std::optional<std::u32string> cell(const Successor& successor, std::size_t p) {
        for (const Array& array : grammar_.arrays) {
            if (array.name != successor.array) continue;
            std::size_t place = 0;
            for (std::size_t k = 0; k < array.sizes.size(); ++k) {
                const std::optional<double> index = asking(p).number(successor.indexes[k]);
                double at = index.value_or(-1);
                if (array.out_of_range == OutOfRange::wrap) {
                    while (at < 0) at += array.sizes[k];
                    while (at >= array.sizes[k]) at -= array.sizes[k];
                } else if (array.out_of_range == OutOfRange::clamp) {
                    at = at < 0 ? 0 : at >= array.sizes[k] ? array.sizes[k] - 1.0 : at;
                }
                if (!index || at < 0 || at >= array.sizes[k] || *index != std::floor(*index)) {
                    fail(Outcome::wrong);
                    return std::nullopt;
                }
                place = place * array.sizes[k] + static_cast<std::size_t>(at);
            }
            return written(array.cells[place], p);
        }
        fail(Outcome::wrong);
        return std::nullopt;
    }

    // --- what becomes of a unit ---

    Change copied(std::size_t p) const {
        Unit unit = old_[p];
        ++unit.age;
        const std::uint32_t left = unit.freezes > 0 ? unit.freezes - 1 : 0;
        unit.freezes = 0;
        Change change{{unit}, true};
        Unit freeze;
        freeze.letter = U'=';
        change.put.insert(change.put.end(), left, freeze);
        return change;
    }
    // Its children in its place, `times` times over.
    Change replaced(std::size_t p, const Units& children, std::size_t times = 1) {
        Change change;
        if (children.size() * times > state_.most) fail(Outcome::too_large);
        if (outcome_ != Outcome::fine) return change;
        std::uint64_t child = 0;
        bool has_heir = false;
        for (std::size_t k = 0; k < times; ++k) {
            for (Unit unit : children) {
                unit.age = 1;
                if (unit.letter != U'=') unit.key = fold(old_[p].key, child++);
                if (unit.letter == old_[p].letter && !has_heir) {
                    unit.age = old_[p].age + 1;
                    has_heir = true;
                }
                change.put.push_back(unit);
            }
        }
        return change;
    }

    // Whether a mask, or a sleep that is not over, holds it.
    bool rests(std::size_t p) {
        for (const Rest& rest : system_of(old_[p].instance).rests) {
            const std::uint32_t now = clock(old_[p].instance);
            if (rest.letter != old_[p].letter || now < rest.first || now > rest.last) continue;
            if (!rest.condition) return true;
            const std::optional<bool> holds = asking(p).flag(rest.condition);
            if (!holds) {
                fail(Outcome::wrong);
                return true;
            }
            if (rest.is_until ? !*holds : *holds) return true;
        }
        return false;
    }
    Change untouched(std::size_t p) const {
        Change change = copied(p);
        Unit freeze;
        freeze.letter = U'=';
        if (old_[p].freezes > 0) change.put.push_back(freeze);
        return change;
    }

    Change change_of(std::size_t p) {
        const Unit& unit = old_[p];
        const Role role = system_of(unit.instance).roles.of(unit.letter);
        if (is_over(unit.instance)) return copied(p);
        if (role == Role::counter) return counted(p);
        if (unit.freezes > (role == Role::macro ? 1U : 0U)) return copied(p);
        if (rests(p)) return untouched(p);
        if (unit.is_inverter) return copied(p);
        if (role == Role::self) return repeated(p);
        if (role == Role::macro) return replaced(p, units_of(macro_text(p), grammar_, unit.instance, unit.gait));
        if (role == Role::subsystem) return of_subsystem(p);
        return rewritten(p, role);
    }
    Change rewritten(std::size_t p, Role role) {
        const Unit& unit = old_[p];
        const Rule* rule = rule_for(p);
        if (rule == nullptr) return copied(p);
        const Successor* successor = drawn_from(*rule, p);
        if (successor == nullptr) return copied(p);
        for (const Assignment& assignment : rule->assignments) {
            const std::optional<double> value = asking(p).number(assignment.value);
            if (!value) fail(Outcome::wrong);
            if (value) assigned_.emplace_back(assignment.name, *value);
        }
        const std::optional<std::u32string> text = text_put(*successor, p);
        if (!text) return copied(p);
        Units children = units_of(*text, grammar_, unit.instance, unit.gait);
        std::uint32_t times = 1, origin = 1;
        if (role == Role::follower) times = origin = unit.origin;
        if (role == Role::ordinal) {
            times = 0;
            for (std::size_t i = 0; i <= p; ++i) {
                const Roles& roles = system_of(old_[i].instance).roles;
                if (old_[i].letter == unit.letter && roles.of(unit.letter) == role) ++times;
            }
            origin = times;
        }
        for (Unit& child : children) {
            if (child.origin > 0) child.origin = origin;
        }
        return replaced(p, children, times);
    }
    Change repeated(std::size_t p) {
        Units whole;
        for (Unit unit : old_) {
            Unit freeze;
            freeze.letter = U'=';
            const std::uint32_t freezes = std::exchange(unit.freezes, 0);
            whole.push_back(unit);
            whole.insert(whole.end(), freezes, freeze);
        }
        return replaced(p, whole);
    }

    bool is_in_one_run(std::size_t left) {  // with its right neighbour
        if (left + 1 >= old_.size()) return false;
        const Unit &a = old_[left], &b = old_[left + 1];
        return a.letter == b.letter && a.instance == b.instance && a.freezes == 0 && !rests(left);
    }
    Change counted(std::size_t p) {
        std::size_t first = p, last = p;
        while (first > 0 && is_in_one_run(first - 1)) --first;
        while (is_in_one_run(last)) ++last;
        if (old_[last].freezes > 0 || rests(last)) return copied(p);
        std::uint32_t gain = 1;
        for (const Gain& said : system_of(old_[p].instance).gains) {
            if (said.letter == old_[p].letter) gain = said.by;
        }
        const bool shrinks = last + 1 < old_.size() && old_[last + 1].is_inverter && old_[last + 1].freezes == 0 &&
                             !rests(last + 1) && old_[last + 1].instance == old_[p].instance;
        if (shrinks) return last - p < gain ? Change{} : copied(p);
        Change change = copied(p);
        if (p != last) return change;
        if (gain > state_.most) {
            fail(Outcome::too_large);
            return change;
        }
        for (std::uint32_t k = 0; k < gain; ++k) {
            Unit unit = old_[p];
            unit.key = fold(old_[p].key, k);
            unit.age = 1;
            change.put.push_back(unit);
        }
        return change;
    }

    // --- macros ---

    std::u32string macro_text(std::size_t p) {
        const Unit& unit = old_[p];
        State::Memory* memory = nullptr;
        for (State::Memory& known : state_.memories) {
            if (known.instance == unit.instance && known.letter == unit.letter) memory = &known;
        }
        if (unit.freezes == 1 && memory != nullptr) return memory->drawn;
        std::uint64_t ordinal = 0;
        for (const auto& [instance, letter] : drawn_) {
            if (instance == unit.instance && letter == unit.letter) ++ordinal;
        }
        drawn_.emplace_back(unit.instance, unit.letter);
        const std::u32string text = drawn_text(p, ordinal);
        if (memory == nullptr) {
            state_.memories.push_back({unit.instance, unit.letter, text});
        } else if (system_of(unit.instance).recalls_last) {
            memory->drawn = text;
        }
        return text;
    }
    std::u32string drawn_text(std::size_t p, std::uint64_t ordinal) const {
        std::u32string text;
        for (const Macro& macro : system_of(old_[p].instance).macros) {
            if (macro.letter != old_[p].letter) continue;
            const auto draw = [&](std::uint64_t number, std::size_t count) {
                return to_whole(bits_at(p, macro.letter, ordinal, number), static_cast<std::uint32_t>(count));
            };
            const std::uint64_t length = macro.low + draw(0, macro.high - macro.low + 1);
            for (std::uint64_t k = 1; k <= length; ++k) {
                text += macro.letters[draw(macro.is_unique ? 1 : k, macro.letters.size())];
            }
        }
        return text;
    }

    // --- subsystems ---

    Change of_subsystem(std::size_t p) {
        const Unit& unit = old_[p];
        std::uint32_t which = 0;
        for (std::uint32_t k = 1; k < grammar_.systems.size(); ++k) {
            if (grammar_.systems[k].letter == unit.letter) which = k;
        }
        const System& inner = grammar_.systems[which];
        if (inner.grows) {
            const std::optional<std::u32string> axiom =
                written_out(inner.axiom.parts, Asking(state_.registers), state_.most);
            if (!axiom) fail(Outcome::wrong);
            if (!axiom) return {};
            return replaced(p, units_of(*axiom, grammar_, {which, now_}, gait_of(inner, unit.gait)));
        }
        const bool has_key = grammar_.draws == DrawMode::lineage;
        const Key own = has_key ? Key{unit.key} : child(child(state_.root, now_), p);
        State state;
        state.is_inner = true;
        state.most = state_.most;
        state.around = unit.gait;
        fail(begin(state, grammar_, state_.seed, child(own, "system"), which));
        while (outcome_ == Outcome::fine && state.iteration < inner.iterations) fail(step(state, grammar_));
        Units children = units_of(text_of(state.word), grammar_, unit.instance, {});
        std::size_t of = 0;
        for (Unit& child : children) {
            if (child.letter != U'=') child.gait = state.word[of++].gait;
        }
        return replaced(p, children);
    }

    // --- ages ---

    void set_ages_by_position(Units& made, const std::vector<Change>& changes) const {
        for (std::size_t p = 0; p < made.size(); ++p) {
            made[p].age = 1;
            if (p >= old_.size() || made[p].letter != old_[p].letter) continue;
            bool has_own = changes[p].is_copied;
            for (const Unit& put : changes[p].put) has_own = has_own || put.letter == old_[p].letter;
            if (has_own) made[p].age = old_[p].age + 1;
        }
    }

    State& state_;
    const Grammar& grammar_;
    const Units old_;
    const std::uint32_t now_;
    std::vector<std::pair<Instance, char32_t>> drawn_;  // macros, in this iteration
    std::vector<std::pair<std::string, double>> assigned_;
    Outcome outcome_ = Outcome::fine;
};

// One iteration more. Of an outcome that is not fine, the state is of no use any more.
inline Outcome step(State& state, const Grammar& grammar) { return Iteration(state, grammar).run(); }

}  // namespace filigree::rewriting::reference
