// How the choices of one place of a derivation are made: what presets say there, from which seed its values are
// drawn, what is replayed, and where they are recorded.
//
// Of one parameter, presets are gone through as they go first (values_for): those of its k-th choice (`~k`) hold for
// what is evaluated, which is the first preset of the whole value whose condition holds, else the document's own
// expression. So a preset goes before the own expression, `set` before `default`, and `default` before the middle.
//
// A preset's condition and value know the document that says it: its units and its names, and what the step knows.
// Choices in the value are made where those of the own expression would be, under the same name; those in a
// condition under NAME?when (NAME?when#2 where an earlier preset of the parameter draws in its condition), which no
// document can name. An expression of a single shape's preset stands as if inside each(...).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "language/choices.h"
#include "language/evaluate.h"
#include "language/presets.h"

namespace filigree {

// What presets say of a single shape of a step: big_poly/2/outline.distance.
struct ShapeChoices {
    std::uint32_t shape = 0;              // index, from 0
    std::vector<std::uint32_t> accepted = {};  // at GROUP/SHAPE/RULE
    std::vector<std::uint32_t> above = {};     // at GROUP/SHAPE: its re-rolls and keeps
};

struct StepChoices {
    const Presets* presets = nullptr;              // null: none
    std::span<const std::uint32_t> accepted = {};  // at this node (presets.h), the one that goes first in front
    NodeSeed seed = {};                            // of this node, after re-rolls
    bool is_random = true;                         // at this node
    const Replay* replay = nullptr;
    ChoiceBuffer* record = nullptr;
    std::span<const ShapeChoices> shapes = {};
};

// Whether choices are random at a node: what the presets of the parameter `is_random` say, else true.
// `scope`: what is known there; its outermost names are replaced by those of the document that says the preset. Such
// a preset cannot choose: a choice in it takes its middle.
Result<bool> is_random_at(const Presets& presets, std::span<const std::uint32_t> accepted, const Scope& scope);

// The `set`s and, where nothing is random, the `default`s of a parameter at the node, the one that goes first in front.
std::vector<const Preset*> presets_in_force(const StepChoices& choices, std::string_view parameter);

// A parameter's value, and the preset that gives it; null: the own expression. Its units are those of the document that
// the expression stands in.
struct DecidedValue {
    Value value = {};
    const Preset* preset = nullptr;
};
// What presets give for a parameter, else the own expression's value; none where there is no expression either. An
// empty parameter is what a path without one means: let/NAME.
// `at`: the evaluation of the own expression (words, calls, wholeness, scope, site with key and name; the seed is set
// here). The name defaults to the parameter's.
// `of_presets`: the same for presets, where they know other names. `shape`: of the shape that `at` is for, if any.
// A preset's value is recorded as fixed where it made no choice: at the shape's key where it is evaluated for one.
Result<std::optional<DecidedValue>> decide(const StepChoices& choices, std::string_view parameter,
                                           const Expression* own, const Evaluation& at,
                                           const Evaluation* of_presets = nullptr, const ShapeChoices* shape = nullptr);

// What a preset gives for a parameter, or none where none says anything.
Result<std::optional<Value>> preset_value(const StepChoices& choices, std::string_view parameter, const Evaluation& at);

// The value of a parameter with an expression of its own: of settings (let, param) and rules (when, weight).
Result<Value> evaluate_with(const StepChoices& choices, std::string_view parameter, const Expression& own,
                            const Evaluation& at);

// The one choice that an algorithm's inner randomness hangs on: a whole number below 2^32.
Result<std::uint32_t> draw_scatter(const StepChoices& choices, Key step, const Scope& scope);

}  // namespace filigree
