// What expressions may ask of a step and of a shape: the names of language/names.h, with their values.
#pragma once

#include <cstdint>

#include "engines/tangle/tangle.h"
#include "language/evaluate.h"

namespace filigree::tangle {

// For `when`, `weight` and arguments: area, width and height as means over the group, count, depth, group (its
// number among the groups of one output, from 1, so that edits elsewhere do not change it).
Scope step_scope(const Tangle& tangle, std::uint32_t group, const Scope& globals);

// For each(...): index (the shape's number from 1), x, y (of the centroid), i, j.
Scope shape_scope(const Tangle& tangle, const Shape& shape, std::uint32_t number);

// For styles: the same, and the shape's own area, width and height, depth, group.
Scope style_scope(const Tangle& tangle, std::uint32_t group, std::size_t index);

}  // namespace filigree::tangle
