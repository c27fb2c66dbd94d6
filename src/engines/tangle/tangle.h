// A tangle: what a group grammar derives, as plain data (gTangle, section 3).
//
// A shape is S = <type, group, id; boundary, orientation>. Type and group are its Group's tag and number, its
// id is its place in Group::shapes. A step expands one group by one rule; each output of the step is one new
// group over all matched shapes (several for the grouping operators). Steps only add: a group that a step
// has expanded stays, so the tangle holds its own history, and the leaves are the groups without a step.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/colour.h"
#include "base/random.h"
#include "derivation/embedding.h"
#include "language/bind.h"
#include "language/choices.h"
#include "language/presets.h"
#include "plane/polygon.h"

namespace filigree::tangle {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

struct Shape {
    Key key;
    Vec direction{1, 0};           // unit: its orientation
    std::uint32_t geometry = 0;    // index into Tangle::geometry
    std::uint32_t polygon = 0;     // index into that
    std::int32_t column = 0;       // lattice place i: its strip in the split that made it
    std::int32_t row = 0;          // lattice place j: its strip in the second family of a dual split
    bool inked = false;            // black with white details, instead of white with black ones
    bool border_in_paper = false;  // its border was drawn inside an inked shape, so in white
    bool is_mark = false;          // a decoration on top of the partition, no part of it
    std::optional<Colour> fill;    // set by the operator fill

    bool operator==(const Shape&) const = default;
};

struct Group {
    std::uint32_t tag = 0;  // index into Grammar::tags
    Key key;
    std::uint32_t producer = none;     // the step that made it; none for a start
    std::uint32_t port = 0;            // of that step
    std::uint32_t ordinal = 0;         // among the groups of that port, from 1; 0 where a port gives only one
    std::uint32_t depth = 0;           // steps from the start
    std::uint32_t consumer = none;     // the step that expanded it; none for a leaf
    std::uint32_t environment = none;  // the macro step whose parameters its rules may use; none outside macros
    // Where an `apply` names single shapes, each is a group of its own beside the rest of its group.
    std::uint32_t picked = 0;            // the number that its one shape had, from 1; 0 for a group that is not picked
    std::vector<std::uint32_t> numbers;  // of the shapes that are left, from 1; empty: all are, in order
    bool hidden = false;                 // its tag is `_`: it keeps its place and is not drawn
    NodeSeed seed;                       // what is drawn for it, after the re-rolls on the way
    PresetState presets;                 // on their way here
    std::vector<Shape> shapes;

    std::uint32_t number_of(std::size_t shape) const {
        return numbers.empty() ? static_cast<std::uint32_t>(shape + 1) : numbers[shape];
    }
};

struct Operator;
struct Reads;

struct Step {
    Key key;
    std::uint32_t rule = 0;                          // index into Grammar::rules
    const Operator* op = nullptr;                    // of that rule; only to be compared
    std::uint32_t group = 0;                         // the group it expanded
    std::uint32_t first_output = 0, end_output = 0;  // groups it made
    std::uint32_t geometry = none;                   // index into Tangle::geometry of what it made; none for nothing
    std::uint32_t scatter = 0;                       // what the operator's own randomness hangs on
    std::size_t first_choice = 0, end_choice = 0;    // of Tangle::choices: the rule's and the arguments'
    Arguments arguments;
    std::vector<std::shared_ptr<const Embedded>> embedded;  // of `embed`: one a shape, null where there is none
};

// Choices that led to no step: a leaf whose rules' conditions did not hold.
struct LeafChoices {
    std::uint32_t group = 0;
    std::size_t first_choice = 0, end_choice = 0;  // of Tangle::choices
};

struct Tangle {
    std::vector<std::shared_ptr<const Polygons>> geometry;  // [0]: the starts; then of steps that made any
    std::vector<Group> groups;                              // by number; the starts first
    std::vector<Step> steps;                                // in the order of their groups
    std::uint32_t start_groups = 0;
    bool is_prefix = false;  // whether it ended before all groups were expanded, as was asked for

    Choices choices;                        // all that were made, in the order of the steps
    std::size_t end_definition_choice = 0;  // those of params and lets come first,
    std::size_t end_start_choice = 0;       // then those of starts
    std::vector<LeafChoices> leaf_choices;  // by group
    std::vector<std::uint8_t> met;          // of each preset in force: whether it met something
    std::shared_ptr<const Reads> reads;     // what the steps could read: for the next derivation (reuse.h)

    PolygonView polygon(const Shape& shape) const { return (*geometry[shape.geometry])[shape.polygon]; }
};

}  // namespace filigree::tangle
