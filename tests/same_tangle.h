// For tests: the first difference between two derivations of one document, field by field; "" where there is none.
//
// What a tangle holds for the next derivation alone (Tangle::reads) is not compared, nor is how far the presets of
// the outer documents have come in what was embedded.
#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include "engines/tangle/tangle.h"
#include "formats/svg_write.h"
#include "session/embed.h"
#include "session/run.h"

namespace filigree {

class TangleComparison {
public:
    static std::string difference(const tangle::Tangle& a, const tangle::Tangle& b) {
        TangleComparison comparison;
        comparison.compare(a, b, "");
        return comparison.found_;
    }

private:
    template <class T>
    bool same(const T& a, const T& b, const std::string& what) {
        if (a == b) return true;
        if (found_.empty()) found_ = what;
        return false;
    }
    static bool same_state(const PresetState& a, const PresetState& b) { return a && b ? *a == *b : !a && !b; }

    void compare(const tangle::Tangle& a, const tangle::Tangle& b, const std::string& within) {
        same(a.is_prefix, b.is_prefix, within + "is_prefix");
        same(a.start_groups, b.start_groups, within + "start_groups");
        compare_choices(a.choices, b.choices, within + "choices");
        if (same(a.steps.size(), b.steps.size(), within + "number of steps")) {
            for (std::size_t s = 0; s < a.steps.size() && found_.empty(); ++s) {
                compare(a.steps[s], b.steps[s], within + "step " + std::to_string(s) + " ");
            }
        }
        if (same(a.groups.size(), b.groups.size(), within + "number of groups")) {
            for (std::size_t g = 0; g < a.groups.size() && found_.empty(); ++g) {
                compare(a.groups[g], b.groups[g], within + "group " + std::to_string(g) + " ");
            }
        }
        if (same(a.geometry.size(), b.geometry.size(), within + "number of geometries")) {
            for (std::size_t i = 0; i < a.geometry.size(); ++i) {
                same(*a.geometry[i] == *b.geometry[i], true, within + "geometry " + std::to_string(i));
            }
        }
        same(a.end_definition_choice, b.end_definition_choice, within + "end_definition_choice");
        same(a.end_start_choice, b.end_start_choice, within + "end_start_choice");
        if (same(a.leaf_choices.size(), b.leaf_choices.size(), within + "number of leaf_choices")) {
            for (std::size_t i = 0; i < a.leaf_choices.size(); ++i) {
                const tangle::LeafChoices &x = a.leaf_choices[i], &y = b.leaf_choices[i];
                same(x.group == y.group && x.first_choice == y.first_choice && x.end_choice == y.end_choice, true,
                     within + "leaf_choices " + std::to_string(i));
            }
        }
        if (!is_inside_) same(a.met, b.met, "met");
    }

    void compare(const tangle::Group& a, const tangle::Group& b, const std::string& within) {
        same(a.tag, b.tag, within + "tag");
        same(a.key, b.key, within + "key");
        same(a.producer, b.producer, within + "producer");
        same(a.port, b.port, within + "port");
        same(a.ordinal, b.ordinal, within + "ordinal");
        same(a.depth, b.depth, within + "depth");
        same(a.consumer, b.consumer, within + "consumer");
        same(a.environment, b.environment, within + "environment");
        same(a.picked, b.picked, within + "picked");
        same(a.numbers, b.numbers, within + "numbers");
        same(a.hidden, b.hidden, within + "hidden");
        same(a.seed.value, b.seed.value, within + "seed");
        if (!is_inside_) same(same_state(a.presets, b.presets), true, within + "presets");
        same(a.shapes, b.shapes, within + "shapes");
    }

    void compare(const tangle::Step& a, const tangle::Step& b, const std::string& within) {
        same(a.key, b.key, within + "key");
        same(a.rule, b.rule, within + "rule");
        // A document that is embedded may have been read anew, with its own operators.
        if (!is_inside_) same(a.op, b.op, within + "op");
        same(a.op->description.name, b.op->description.name, within + "operator");
        same(a.group, b.group, within + "group");
        same(a.first_output, b.first_output, within + "first_output");
        same(a.end_output, b.end_output, within + "end_output");
        same(a.geometry, b.geometry, within + "geometry");
        same(a.scatter, b.scatter, within + "scatter");
        same(a.first_choice, b.first_choice, within + "first_choice");
        same(a.end_choice, b.end_choice, within + "end_choice");
        if (same(a.arguments.values.size(), b.arguments.values.size(), within + "number of arguments")) {
            for (std::size_t i = 0; i < a.arguments.values.size(); ++i) {
                const ArgumentValue &x = a.arguments.values[i], &y = b.arguments.values[i];
                same(x.common == y.common && x.per_shape == y.per_shape, true,
                     within + "argument " + std::to_string(i));
            }
        }
        if (!same(a.embedded.size(), b.embedded.size(), within + "number of embedded")) return;
        for (std::size_t i = 0; i < a.embedded.size() && found_.empty(); ++i) {
            const std::string inside = within + "embedded " + std::to_string(i) + " ";
            if (!same(!a.embedded[i], !b.embedded[i], inside + "is there")) continue;
            if (a.embedded[i]) compare(*a.embedded[i], *b.embedded[i], inside);
        }
    }

    void compare(const Embedded& a, const Embedded& b, const std::string& within) {
        same(a.elements, b.elements, within + "elements");
        if (!found_.empty()) return;
        const EmbeddedTangle *x = tangle_in(a), *y = tangle_in(b);
        if (!same(!x, !y, within + "is a tangle")) return;
        if (x != nullptr) {
            same(x->root, y->root, within + "root");
            const bool was_inside = std::exchange(is_inside_, true);
            compare(x->tangle, y->tangle, within);
            is_inside_ = was_inside;
            compare_choices(x->picture.choices, y->picture.choices, within + "style choices");
        }
        same(to_svg(a.drawing, {}), to_svg(b.drawing, {}), within + "drawing");
    }

    void compare_choices(const Choices& a, const Choices& b, const std::string& within) {
        if (!same(a.size(), b.size(), within + " size")) return;
        same(a.name_table, b.name_table, within + " name_table");
        same(a.domain_table, b.domain_table, within + " domain_table");
        same(a.keys, b.keys, within + " keys");
        same(a.names, b.names, within + " names");
        same(a.values, b.values, within + " values");
        same(a.domains, b.domains, within + " domains");
        same(a.sources, b.sources, within + " sources");
    }

    std::string found_;
    bool is_inside_ = false;  // an embedded document
};

// The derivation, the styles' choices, and the drawing.
inline std::string difference(const Run& a, const Run& b) {
    std::string found = TangleComparison::difference(a.tangle, b.tangle);
    if (!found.empty()) return found;
    if (a.picture.choices.values != b.picture.choices.values || a.picture.choices.keys != b.picture.choices.keys) {
        return "style choices";
    }
    if (a.picture.met != b.picture.met) return "what styles have met";
    if (to_svg(a.drawing, {}) != to_svg(b.drawing, {})) return "svg";
    if (a.unmatched.size() != b.unmatched.size()) return "unmatched";
    return "";
}

}  // namespace filigree
