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
#include "language/bind.h"
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
    std::uint32_t producer = none;  // the step that made it; none for a start
    std::uint32_t port = 0;         // of that step
    std::uint32_t ordinal = 0;      // among the groups of that port, from 1; 0 where a port gives only one
    std::uint32_t depth = 0;        // steps from the start
    std::uint32_t consumer = none;  // the step that expanded it; none for a leaf
    bool hidden = false;            // its tag is `_`: it keeps its place and is not drawn
    std::vector<Shape> shapes;
};

struct Step {
    Key key;
    std::uint32_t rule = 0;                          // index into Grammar::rules
    std::uint32_t group = 0;                         // the group it expanded
    std::uint32_t first_output = 0, end_output = 0;  // groups it made
    Arguments arguments;
};

struct Tangle {
    std::vector<std::shared_ptr<const Polygons>> geometry;  // [0]: the starts; then of steps that made any
    std::vector<Group> groups;                              // by number; the starts first
    std::vector<Step> steps;                                // in the order of their groups
    std::uint32_t start_groups = 0;

    PolygonView polygon(const Shape& shape) const { return (*geometry[shape.geometry])[shape.polygon]; }
};

}  // namespace filigree::tangle
