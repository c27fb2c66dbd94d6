#include "session/word_paths.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "engines/rewriting/edit_operators.h"
#include "engines/rewriting/spots.h"

namespace filigree {
namespace {

using rewriting::Grammar;
using rewriting::Macro;
using rewriting::Pattern;
using rewriting::Role;
using rewriting::Rule;
using rewriting::Successor;
using rewriting::System;

using Letters = std::set<char32_t>;

void add_letters(const std::vector<Pattern::Part>& parts, Letters& letters) {
    for (const Pattern::Part& part : parts) {
        letters.insert(part.letters.begin(), part.letters.end());
        add_letters(part.repeated, letters);
    }
}

class WordPathBuilder {
public:
    WordPathBuilder(const Grammar& grammar, PathGraph& graph) : grammar_(grammar), graph_(graph) {
        for (std::uint32_t s = 0; s < grammar.systems.size(); ++s) words_.push_back(letters_in_word(s));
    }

    std::vector<WordPathPlace> places;

    // The roots of the word of one system: of the letters of its axiom, or of its iterations.
    std::vector<std::uint32_t> add_word(std::uint32_t system) {
        if (grammar_.draws == rewriting::DrawMode::lineage) {
            Letters axiom;
            add_letters(grammar_.systems[system].axiom.parts, axiom);
            return nodes_of(system, axiom);
        }
        const auto [known, is_new] = iterations_.try_emplace(system, 0);
        if (!is_new) return {known->second};
        known->second = add_node({false, true, "iteration", {}, {"is_random"}}, {nullptr, system});
        const std::uint32_t node = known->second;
        std::vector<std::uint32_t> next;
        for (const auto& [owner, letter] : words_[system]) next.push_back(node_of(owner, letter));
        graph_.nodes[node].next = std::move(next);
        return {node};
    }

    // What edits choose, and what they put.
    std::vector<std::uint32_t> add_edits() {
        std::map<const rewriting::EditOperator*, int> met;
        std::vector<std::uint32_t> edits;
        for (const rewriting::WordEdit& edit : grammar_.edits) {
            const int number = ++met[edit.op];
            PathNode node{false, !edit.is_once, std::string(edit.op->description.name), {}, {"is_random", "scatter"}};
            if (number > 1) node.segment += "#" + std::to_string(number);
            for (std::size_t p = 0; p < edit.op->description.parameters.size(); ++p) {
                const bool varies = std::any_of(edit.by_token.begin(), edit.by_token.end(),
                                                [&](const auto& one) { return one.parameter == p; });
                if (!varies) node.parameters.emplace_back(edit.op->description.parameters[p].name);
            }
            edits.push_back(add_node(std::move(node), {nullptr, 0, 0, &edit}));
        }
        if (edits.empty() || grammar_.draws != rewriting::DrawMode::lineage) return edits;
        Letters known;
        for (const auto& [owner, letter] : words_[0]) known.insert(letter);
        for (const Rule& rule : grammar_.systems[0].rules) known.insert(rule.letter);
        for (const Macro& macro : grammar_.systems[0].macros) known.insert(macro.letter);
        const std::vector<std::uint32_t> put = nodes_of(0, known);
        for (const std::uint32_t edit : edits) graph_.nodes[edit].next = put;
        for (const auto& [owner, node] : nodes_) {
            std::vector<std::uint32_t>& next = graph_.nodes[node].next;
            next.insert(next.end(), edits.begin(), edits.end());
        }
        return edits;
    }

private:
    using Owned = std::pair<std::uint32_t, char32_t>;  // a letter and the system that rewrites it

    std::uint32_t add_node(PathNode node, WordPathPlace place) {
        graph_.nodes.push_back(std::move(node));
        place.grammar = &grammar_;
        places.push_back(place);
        return static_cast<std::uint32_t>(graph_.nodes.size() - 1);
    }
    std::vector<std::uint32_t> nodes_of(std::uint32_t system, const Letters& letters) {
        std::vector<std::uint32_t> nodes;
        for (const char32_t letter : letters) {
            if (letter != U'=') nodes.push_back(node_of(system, letter));
        }
        return nodes;
    }

    std::uint32_t node_of(std::uint32_t system, char32_t letter) {
        const auto [known, is_new] = nodes_.try_emplace({system, letter}, 0);
        if (!is_new) return known->second;
        PathNode node{false, true, rewriting::segment_of(letter), {}, {"is_random"}};
        for (const Rule& rule : grammar_.systems[system].rules) {
            if (rule.letter != letter) continue;
            if (rule.successors.size() > 1) add_once(node.parameters, "rule");
            for (const Successor& successor : rule.successors) {
                if (successor.kind == Successor::Kind::jump) add_once(node.parameters, "target");
            }
        }
        if (role_of(system, letter) == Role::macro) node.parameters.emplace_back("letters");
        const std::uint32_t index = known->second = add_node(std::move(node), {nullptr, system, letter});
        std::vector<std::uint32_t> next;
        if (grammar_.draws == rewriting::DrawMode::lineage) {
            for (const auto& [owner, put] : put_by(system, letter)) next.push_back(node_of(owner, put));
        }
        if (const auto inner = inner_system(system, letter); inner && !grammar_.systems[*inner].grows) {
            next.push_back(add_inner(*inner));
        }
        graph_.nodes[index].next = std::move(next);
        return index;
    }
    // What is behind `system`: once for each.
    std::uint32_t add_inner(std::uint32_t system) {
        const auto [known, is_new] = inner_.try_emplace(system, 0);
        if (!is_new) return known->second;
        const std::uint32_t node = add_node({false, false, "system", {}, {"is_random"}}, {nullptr, system});
        inner_[system] = node;
        std::vector<std::uint32_t> next = add_word(system);
        graph_.nodes[node].next = std::move(next);
        return node;
    }
    static void add_once(std::vector<std::string>& names, std::string_view name) {
        if (std::find(names.begin(), names.end(), name) == names.end()) names.emplace_back(name);
    }

    // --- what a letter may become ---

    Role role_of(std::uint32_t system, char32_t letter) const { return grammar_.systems[system].roles.of(letter); }
    std::optional<std::uint32_t> inner_system(std::uint32_t system, char32_t letter) const {
        return role_of(system, letter) == Role::subsystem ? find_system(grammar_, letter) : std::nullopt;
    }

    void add_successor(const Successor& successor, std::uint32_t system, bool may_jump, Letters& letters) const {
        switch (successor.kind) {
            case Successor::Kind::pattern:
                return add_letters(successor.pattern.parts, letters);
            case Successor::Kind::cell:
                if (const auto* array = find_named(grammar_.arrays, successor.array)) {
                    for (const Pattern& cell : array->cells) add_letters(cell.parts, letters);
                }
                return;
            case Successor::Kind::lookup:
                for (const auto& row : successor.lookup.rows) add_letters(row.pattern.parts, letters);
                return;
            case Successor::Kind::jump:
                if (may_jump) add_rules(system, successor.target, false, letters);
                return;
        }
    }
    void add_rules(std::uint32_t system, char32_t letter, bool may_jump, Letters& letters) const {
        for (const Rule& rule : grammar_.systems[system].rules) {
            if (rule.letter != letter) continue;
            for (const Successor& successor : rule.successors) add_successor(successor, system, may_jump, letters);
        }
    }
    // Without what the whole word has: `s` puts that.
    std::set<Owned> put_directly(std::uint32_t system, char32_t letter) const {
        Letters letters;
        add_rules(system, letter, true, letters);
        for (const Macro& macro : grammar_.systems[system].macros) {
            if (macro.letter == letter) letters.insert(macro.letters.begin(), macro.letters.end());
        }
        if (role_of(system, letter) == Role::counter) letters.insert(letter);
        std::set<Owned> put;
        for (const char32_t one : letters) put.emplace(system, one);
        const std::optional<std::uint32_t> inner = inner_system(system, letter);
        if (inner && grammar_.systems[*inner].grows) {
            Letters axiom;
            add_letters(grammar_.systems[*inner].axiom.parts, axiom);
            for (const char32_t one : axiom) put.emplace(*inner, one);
        }
        std::erase_if(put, [](const Owned& one) { return one.second == U'='; });
        return put;
    }
    std::set<Owned> put_by(std::uint32_t system, char32_t letter) const {
        std::set<Owned> put = put_directly(system, letter);
        if (role_of(system, letter) == Role::self) {
            put = words_[0];
            put.insert(words_[system].begin(), words_[system].end());
        }
        const std::optional<std::uint32_t> inner = inner_system(system, letter);
        if (inner && !grammar_.systems[*inner].grows) {
            for (const Owned& one : words_[*inner]) put.emplace(system, one.second);
        }
        return put;
    }
    // All that may stand in the word of a system. What a subsystem puts at once are letters of who puts it.
    std::set<Owned> letters_in_word(std::uint32_t system) const {
        std::set<Owned> found;
        std::vector<Owned> open;
        const auto reach = [&](const Owned& one) {
            if (one.second != U'=' && found.insert(one).second) open.push_back(one);
        };
        Letters axiom;
        add_letters(grammar_.systems[system].axiom.parts, axiom);
        for (const char32_t letter : axiom) reach({system, letter});
        std::set<std::uint32_t> put_at_once;
        while (!open.empty()) {
            const auto [owner, letter] = open.back();
            open.pop_back();
            for (const Owned& put : put_directly(owner, letter)) reach(put);
            const std::optional<std::uint32_t> inner = inner_system(owner, letter);
            if (!inner || grammar_.systems[*inner].grows || !put_at_once.insert(*inner).second) continue;
            // By its own rules and by those of whom it is put for: more than can be.
            for (const Rule& rule : grammar_.systems[*inner].rules) {
                reach({owner, rule.letter});
                for (const Owned& put : put_directly(*inner, rule.letter)) reach({owner, put.second});
            }
            Letters begun;
            add_letters(grammar_.systems[*inner].axiom.parts, begun);
            for (const char32_t one : begun) reach({owner, one});
            for (const Macro& macro : grammar_.systems[*inner].macros) {
                for (const char32_t one : macro.letters) reach({owner, one});
            }
        }
        return found;
    }

    const Grammar& grammar_;
    PathGraph& graph_;
    std::vector<std::set<Owned>> words_;  // by system
    std::map<Owned, std::uint32_t> nodes_;
    std::map<std::uint32_t, std::uint32_t> inner_, iterations_;  // nodes by system
};

}  // namespace

std::vector<WordPathPlace> add_word_nodes(const Grammar& grammar, PathGraph& graph, std::vector<std::uint32_t>& roots) {
    WordPathBuilder builder(grammar, graph);
    for (const std::uint32_t root : builder.add_word(0)) roots.push_back(root);
    for (const std::uint32_t edit : builder.add_edits()) roots.push_back(edit);
    return std::move(builder.places);
}

}  // namespace filigree
