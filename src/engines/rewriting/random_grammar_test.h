// For tests alone: grammars of gdesign at random, and grammars as text for who must find out what is wrong with one.
//
// Each combines a few features over few letters, so that they meet: what freezes stands among what counts, what is
// copied holds what is drawn. Registers stay within 0..2, and few brackets and indexes are wrong.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/number_text.h"
#include "base/test_cases.h"
#include "engines/rewriting/grammar.h"
#include "engines/rewriting/pattern.h"
#include "language/parse.h"
#include "language/unparse.h"

namespace filigree::rewriting {

enum class Feature : std::uint8_t {
    freezes,
    counters,
    self,
    ordinals,
    stages,
    contexts,
    conditions,
    alternatives,
    loops,
    jumps,
    arrays,
    macros,
    instant_systems,
    growing_systems,
    assignments,
    repeats,
    freed_letters,
    rests,
};
constexpr std::size_t feature_count = 18;

inline std::string letter_text(char32_t letter) { return to_utf8(std::u32string(1, letter)); }

class RandomGrammar {
public:
    explicit RandomGrammar(CaseRandom& random) : random_(random) {
        for (std::uint32_t left = 2 + random_.below(4); left > 0;) {
            bool& chosen = features_[random_.index(feature_count)];
            if (!chosen) --left;
            chosen = true;
        }
    }

    bool has(Feature feature) const { return features_[static_cast<std::size_t>(feature)]; }

    Grammar made() {
        grammar_.draws = random_.coin() ? DrawMode::lineage : DrawMode::position;
        grammar_.ages = random_.coin() ? AgeMode::lineage : AgeMode::position;
        if (uses_registers()) {
            grammar_.registers = {{"ix", random_.below(3) * 1.0}, {"iy", random_.below(3) * 1.0}};
        }
        if (has(Feature::instant_systems)) add_system(U'A', false);
        if (has(Feature::growing_systems)) add_system(U'B', true);
        for (std::size_t s = 0; s < grammar_.systems.size(); ++s) choose_letters(s);
        if (has(Feature::arrays)) add_arrays();
        for (std::size_t s = 0; s < grammar_.systems.size(); ++s) fill(s);
        return grammar_;
    }

private:
    bool chance(std::uint32_t percent) { return random_.below(100) < percent; }
    bool chance(Feature feature, std::uint32_t percent) { return has(feature) && chance(percent); }
    bool uses_registers() const {
        return has(Feature::assignments) || has(Feature::arrays) || has(Feature::loops) || has(Feature::repeats);
    }
    std::string one_of(const std::vector<std::string>& texts) { return texts[random_.index(texts.size())]; }
    char32_t letter_in(const std::u32string& letters) { return letters[random_.index(letters.size())]; }
    static ExpressionPtr expression(const std::string& text) { return *parse_expression(text); }

    // Each system may hold those behind it, so that none holds itself.
    void add_system(char32_t letter, bool grows) {
        for (System& outer : grammar_.systems) outer.roles.subsystems += letter;
        grammar_.systems.emplace_back();
        grammar_.systems.back().letter = letter;
        grammar_.systems.back().grows = grows;
        Gait& gait = grammar_.systems.back().gait;
        if (chance(30)) gait.angle = random_.below(90);
        if (chance(30)) gait.angle2 = random_.below(90);
        if (chance(30)) gait.step = 1 + random_.below(9);
    }

    void choose_letters(std::size_t which) {
        System& system = grammar_.systems[which];
        if (has(Feature::freed_letters)) system.roles.free(letter_in(U"qgisn\u00F1"));
        std::u32string letters = U"aabbc";
        if (has(Feature::counters)) letters += U"qqg";
        if (has(Feature::self)) letters += U's';
        if (has(Feature::ordinals)) letters += U"nn\u00F1";
        if (has(Feature::jumps)) letters += U"rr";
        if (has(Feature::freed_letters)) letters += U"qn";
        if (has(Feature::macros)) {
            for (const char32_t letter : std::u32string_view(U"RS")) {
                if (chance(20)) continue;
                system.roles.macros += letter;
                letters += letter;
            }
        }
        letters += system.roles.subsystems;
        if (chance(Feature::growing_systems, 50) && which == 0) letters += system.roles.subsystems;
        letters_.push_back(letters);
    }

    void add_arrays() {
        const auto way = [&] { return static_cast<OutOfRange>(random_.below(3)); };
        grammar_.arrays.push_back({"M", {3}, {}, way()});
        grammar_.arrays.push_back({"N", {3, 2 + random_.below(8) / 7}, {}, way()});
        for (Array& array : grammar_.arrays) {
            std::size_t count = 1;
            for (const std::uint32_t size : array.sizes) count *= size;
            while (array.cells.size() < count) array.cells.push_back(pattern(0, 3, true));
        }
    }

    // --- texts ---

    std::string text(std::size_t which, std::uint32_t most, bool may_repeat, std::uint32_t depth = 0) {
        std::string made;
        if (chance(Feature::freezes, 4)) made += '=';
        for (std::uint32_t left = random_.below(most + 1); left > 0; --left) {
            if (chance(Feature::contexts, 8)) made += one_of({"[", "]"});
            const bool is_bracketed = has(Feature::contexts) || has(Feature::conditions);
            if (is_bracketed && depth < 2 && chance(25)) {
                made += '[' + text(which, 2, may_repeat, depth + 1) + ']';
            } else if (may_repeat && chance(Feature::repeats, 30)) {
                made += repeat() + text(which, 2, depth < 2, depth + 2) + '}';
            } else if (chance(Feature::counters, 15)) {
                made += one_of({"qi", "qqi", "gi", "qqqi", "ggi", "qgi"});
            } else if (chance(10)) {
                made += one_of({"+", "i"});
            } else {
                made += letter_text(letter_in(letters_[which]));
            }
            if (chance(Feature::freezes, 25)) made += one_of({"=", "=", "==", "==="});
            if (chance(Feature::macros, 15)) made += '=';
        }
        return made;
    }
    std::string repeat() {
        if (is_in_axiom_) return one_of({"{2", "{", "{0", "{(3 - 1)"});
        return one_of({"{2", "{", "{0", "{3", "{$ix+", "{$iy+", "{(ix + iy - 1)", "{(iy)", "{(iy / 2)", "{(t - 1)",
                       "{(mod(index, 3))"});
    }
    Pattern pattern(std::size_t which, std::uint32_t most, bool may_repeat) {
        return *read_pattern(text(which, most, may_repeat), {});
    }
    std::u32string context(std::size_t which, bool may_branch) {
        std::u32string made;
        for (std::uint32_t left = 1 + random_.below(4) / 3; left > 0; --left) {
            if (may_branch && chance(40)) made += U'[' + context(which, chance(30)) + U']';
            if (chance(70)) made += chance(10) ? U'+' : letter_in(letters_[which]);
        }
        return made;
    }

    // --- systems ---

    void fill(std::size_t which) {
        System& system = grammar_.systems[which];
        is_in_axiom_ = true;
        do {
            system.axiom = pattern(which, which == 0 ? 7 : 4, true);
        } while (system.axiom.parts.empty());
        is_in_axiom_ = false;
        system.iterations = random_.below(5);
        system.after = static_cast<AfterRows>(random_.below(3));
        system.recalls_last = random_.coin();
        if (chance(Feature::contexts, 40)) system.ignored = chance(50) ? U"+" : chance(50) ? U"b" : U"+c";
        if (chance(Feature::counters, 40)) system.gains.push_back({U'q', random_.below(4)});
        if (chance(Feature::counters, 40)) system.gains.push_back({U'g', random_.below(4)});
        for (const char32_t letter : system.roles.macros) add_macro(system, letter, which);
        std::u32string letters = letters_[which];
        std::sort(letters.begin(), letters.end());
        letters.erase(std::unique(letters.begin(), letters.end()), letters.end());
        for (const char32_t letter : letters + U"+i") {
            const Role role = system.roles.of(letter);
            const bool may = role == Role::ordinary || role == Role::ordinal || role == Role::follower;
            const bool is_rare = letter == U'c' || letter == U'+' || letter == U'i';
            if (may && chance(is_rare ? 20 : 85)) add_rules(system, letter, which);
            if (chance(Feature::rests, 35)) add_rest(system, letter);
            if (chance(Feature::loops, 25)) add_row_loop(system, letter);
        }
    }
    void add_rest(System& system, char32_t letter) {
        Rest rest;
        rest.letter = letter;
        if (chance(40)) rest.first = 1 + random_.below(4);
        if (chance(40)) rest.last = rest.first + random_.below(3);
        rest.is_until = random_.coin();
        if (rest.is_until || chance(70)) rest.condition = expression(condition());
        system.rests.push_back(rest);
    }
    void add_row_loop(System& system, char32_t letter) {
        RowLoop loop;
        loop.letter = letter;
        if (chance(40)) loop.first = 1 + random_.below(3);
        if (chance(40)) loop.last = loop.first + random_.below(2);
        loop.length = expression(row_length());
        system.loops.push_back(loop);
    }
    void add_macro(System& system, char32_t letter, std::size_t which) {
        Macro macro;
        macro.letter = letter;
        macro.low = random_.below(3);
        macro.high = macro.low + random_.below(3);
        macro.is_unique = chance(25);
        for (std::uint32_t left = 1 + random_.below(4); left > 0; --left) macro.letters += letter_in(letters_[which]);
        if (chance(Feature::counters, 50)) macro.letters += U"qi";
        if (chance(20)) macro.letters += U'=';
        system.macros.push_back(macro);
    }

    void add_rules(System& system, char32_t letter, std::size_t which) {
        const bool has_rows = chance(Feature::loops, 60);
        const bool varies = has_rows || has(Feature::stages) || has(Feature::contexts) || has(Feature::conditions);
        for (std::uint32_t left = 1 + (varies ? random_.below(4) : 0); left > 0; --left) {
            Rule rule = random_rule(which, letter);
            if (has_rows && (left == 1 || chance(85))) rule.loop = expression(row_length());
            system.rules.push_back(rule);
        }
    }
    // Where a jump leads to an iteration, it must be known which row serves that.
    std::string row_length() {
        if (has(Feature::jumps)) return one_of({"1", "2", "1", "3", "0"});
        return one_of(
            {"1", "2", "1", "3", "ix", "iy", "ix + iy", "max(1 - ix, 0)", "5 - t", "t", "count", "mod(count + t, 3)"});
    }
    Rule random_rule(std::size_t which, char32_t letter) {
        Rule rule;
        rule.letter = letter;
        if (chance(Feature::stages, 60)) {
            rule.first = 1 + random_.below(5);
            rule.last = chance(40) ? rule.first : rule.first + random_.below(4);
        }
        if (chance(Feature::contexts, 40)) rule.left = context(which, false);
        if (chance(Feature::contexts, 40)) rule.right = context(which, true);
        if (chance(Feature::conditions, 60)) rule.condition = expression(condition());
        if (chance(Feature::assignments, 60)) {
            rule.assignments.push_back({random_.coin() ? "ix" : "iy", expression(assigned())});
            if (chance(20)) rule.assignments.push_back({"ix", expression(assigned())});
        }
        const std::uint32_t count = chance(Feature::alternatives, 60) ? 2 + random_.below(2) : 1;
        for (std::uint32_t k = 0; k < count; ++k) {
            rule.successors.push_back(successor(which, letter));
            rule.successors.back().name = std::to_string(rule.successors.size());
            if (count > 1 && chance(60)) rule.successors.back().weight = expression(weight());
        }
        return rule;
    }
    std::string condition() {
        return one_of({"t < 3", "t > 1", "mod(index, 2) == 0", "index < 3", "depth > 0", "depth == 0", "age > 2",
                       "mod(t + index, 2) == 1 && depth < 2", uses_registers() ? "ix == 1" : "true",
                       uses_registers() ? "ix <= iy" : "t == 2", "distance > 2", "mod(distance, 2) == 0", "density < 3",
                       "density > distance + 1", "homogeneity < 0.5", "homogeneity == 1", "count > 2",
                       "index + 1 < count", "age * density > 4"});
    }
    std::string assigned() {
        return one_of({"mod(ix + 1, 3)", "2 - iy", "mod(index, 3)", "mod(t + depth, 3)", "iy", "0", "1",
                       "mod(count, 3)", "mod(density + distance, 3)", "mod(age, 3)"});
    }
    std::string weight() {
        return one_of({"2", "0.5", "0", "max(2 - t, 0)", "5 - t", "t", "depth + 1", "mod(index, 2) + 0.1",
                       uses_registers() ? "ix + 0.25" : "3", "age", "homogeneity", "distance", "density / count"});
    }
    Successor successor(std::size_t which, char32_t letter) {
        Successor made;
        if (has(Feature::jumps) && (letter == U'r' ? chance(70) : chance(8))) {
            made.kind = Successor::Kind::jump;
            made.target = letter_in(U"aabbcnrd");
            made.target_iteration = 1 + random_.below(4);
        } else if (chance(Feature::arrays, 50)) {
            const Array& array = grammar_.arrays[random_.index(grammar_.arrays.size())];
            made.kind = Successor::Kind::cell;
            made.array = array.name;
            for (std::size_t k = 0; k < array.sizes.size(); ++k) {
                made.indexes.push_back(expression(
                    array.out_of_range != OutOfRange::error && chance(60)
                        ? one_of({"t", "index - count", "4 - density", "age", "t - 5"})
                    : k == 0 ? one_of({"ix", "iy", "mod(index + ix, 3)", "mod(t, 3)", "2"})
                             : one_of({"mod(iy, 2)", "mod(index, 2)", "1", "mod(depth + t, 2)", "iy", "iy / 2"})));
            }
        } else {
            made.pattern = pattern(which, 4, true);
        }
        return made;
    }

    CaseRandom& random_;
    std::array<bool, feature_count> features_ = {};
    std::vector<std::u32string> letters_;  // by system, the likelier ones more often
    bool is_in_axiom_ = false;             // where only registers are known
    Grammar grammar_;
};

// --- as text ---

inline std::string described(const std::vector<Pattern::Part>& parts) {
    std::string text;
    for (const Pattern::Part& part : parts) {
        text += part.count ? "{(" + unparse(part.count) + ")" + described(part.repeated) + "}" : to_utf8(part.letters);
    }
    return text;
}
inline std::string described(const Rule& rule) {
    std::string text = rule.left.empty() ? "" : to_utf8(rule.left) + " < ";
    text += letter_text(rule.letter);
    if (!rule.right.empty()) text += " > " + to_utf8(rule.right);
    if (rule.first > 1 || rule.last != every_iteration) {
        text += "@" + std::to_string(rule.first) + ".." + std::to_string(rule.last);
    }
    for (const Successor& successor : rule.successors) {
        text += &successor == &rule.successors.front() ? " -> " : ", ";
        switch (successor.kind) {
            case Successor::Kind::pattern:
                text += '"' + described(successor.pattern.parts) + '"';
                break;
            case Successor::Kind::jump:
                text += "goto " + letter_text(successor.target) + "@" + std::to_string(successor.target_iteration);
                break;
            case Successor::Kind::cell:
                text += successor.array;
                for (const ExpressionPtr& index : successor.indexes) text += "[" + unparse(index) + "]";
                break;
            case Successor::Kind::lookup:  // none at random
                break;
        }
        if (successor.weight) text += " * " + unparse(successor.weight);
    }
    if (rule.loop) text += " loop " + unparse(rule.loop);
    if (rule.condition) text += " when " + unparse(rule.condition);
    for (const Assignment& assignment : rule.assignments) {
        text += " { " + assignment.name + " = " + unparse(assignment.value) + " }";
    }
    return text;
}
inline std::string described(const System& system) {
    const auto number = [](std::uint64_t value) { return std::to_string(value); };
    const auto index = [](auto value) { return static_cast<std::size_t>(value); };
    constexpr std::string_view after[] = {"identity", "hold", "cycle"};
    std::string text =
        "axiom \"" + described(system.axiom.parts) + "\" after " + std::string(after[index(system.after)]);
    text += (system.recalls_last ? " memory last" : "") + std::string(system.grows ? " mode grow" : "");
    text += " iterations " + number(system.iterations) + "\n";
    const Roles usual;
    for (const auto& [mine, theirs] :
         {std::pair(&system.roles.counters, &usual.counters), std::pair(&system.roles.inverters, &usual.inverters),
          std::pair(&system.roles.selves, &usual.selves), std::pair(&system.roles.ordinals, &usual.ordinals),
          std::pair(&system.roles.followers, &usual.followers)}) {
        if (*mine != *theirs)
            text += "of " + to_utf8(*theirs) + " only these keep their role: " + to_utf8(*mine) + "\n";
    }
    for (const auto& [name, value] :
         {std::pair("angle ", &system.gait.angle), std::pair("angle2 ", &system.gait.angle2),
          std::pair("step ", &system.gait.step)}) {
        if (*value) text += name + filigree::to_text(**value) + "\n";
    }
    if (!system.ignored.empty()) text += "ignore " + to_utf8(system.ignored) + "\n";
    for (const Gain& gain : system.gains) text += "gain " + letter_text(gain.letter) + " " + number(gain.by) + "\n";
    for (const Macro& macro : system.macros) {
        text += letter_text(macro.letter) + " = random " + number(macro.low) + ".." + number(macro.high) + " \"" +
                to_utf8(macro.letters) + "\"" + (macro.is_unique ? " unique\n" : "\n");
    }
    for (const Rule& rule : system.rules) text += described(rule) + "\n";
    for (const RowLoop& loop : system.loops) {
        text += "loop " + letter_text(loop.letter) + "@" + number(loop.first) + ".." + number(loop.last) + " " +
                unparse(loop.length) + "\n";
    }
    for (const Rest& rest : system.rests) {
        text += (rest.is_until ? "sleep " : "mask ") + letter_text(rest.letter) + "@" + number(rest.first) + ".." +
                number(rest.last);
        if (rest.condition) text += (rest.is_until ? " until " : " when ") + unparse(rest.condition);
        text += "\n";
    }
    return text;
}
inline std::string described(const Grammar& grammar) {
    std::string text = grammar.draws == DrawMode::position ? "random position\n" : "random lineage\n";
    text += grammar.ages == AgeMode::position ? "ages position\n" : "ages lineage\n";
    for (const Register& known : grammar.registers)
        text += "register " + known.name + " " + filigree::to_text(known.value) + "\n";
    for (const Array& array : grammar.arrays) {
        text += "array " + array.name;
        for (const std::uint32_t size : array.sizes) text += " [" + std::to_string(size) + "]";
        constexpr std::string_view ways[] = {"", " wrap", " clamp"};
        text += ways[static_cast<std::size_t>(array.out_of_range)];
        for (const Pattern& cell : array.cells) text += " \"" + described(cell.parts) + "\"";
        text += "\n";
    }
    for (const System& system : grammar.systems) {
        const bool is_inner = system.letter != 0;
        text += is_inner ? "system " + letter_text(system.letter) + " {\n" : "";
        text += described(system) + (is_inner ? "}\n" : "");
    }
    return text;
}

}  // namespace filigree::rewriting
