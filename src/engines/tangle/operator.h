// What an operator of the tangle engine is: a description and a function from a group's shapes to new groups.
//
// An operator sees all shapes of one step at once and must not depend on anything but its input. It derives
// every new shape from the shape that it lies in by `piece_of`, which hands down ink and identity.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "base/executor.h"
#include "base/result.h"
#include "derivation/shape_source.h"
#include "engines/tangle/tangle.h"
#include "language/bind.h"
#include "language/description.h"

namespace filigree::tangle {

struct OperatorInput {
    const Tangle& tangle;           // for the geometry of the shapes
    std::span<const Shape> shapes;  // of one group
    const Arguments& arguments;
    std::uint32_t scatter = 0;         // what the operator's own randomness hangs on
    Key step;                          // of this step
    double resolution = 0.1;           // px: tolerance of curves
    std::uint64_t element_budget = 0;  // more new shapes than this are refused
    Executor& executor;
    const ShapeSource& forms;  // what arguments that are forms mean
};

struct OutputGroup {
    std::uint32_t port = 0;
    std::uint64_t local_key = 0;  // tells the groups of one port apart; stable when others come or go
    std::vector<Shape> shapes;
};
struct OperatorOutput {
    Polygons geometry;                // of the new shapes; Shape::geometry == none means "in here"
    std::vector<OutputGroup> groups;  // by port; empty ones are dropped
};

struct Operator {
    OperatorDescription description;
    Result<OperatorOutput> (*run)(const OperatorInput& input) = nullptr;  // null: the derivation runs it itself
    bool scatters = false;  // has randomness of its own, all of it from OperatorInput::scatter
    bool (*scatters_with)(const Arguments& arguments) = nullptr;  // whether it has, if not with all arguments
};

inline bool scatters(const Operator& op, const Arguments& arguments) {
    return op.scatters && (op.scatters_with == nullptr || op.scatters_with(arguments));
}

// A new shape inside `parent`, whose geometry is the `polygon`-th of the operator's output. `local` tells
// apart the pieces of one parent and stays when neighbours come or go.
inline Shape piece_of(const Shape& parent, Key step, std::uint64_t local, std::size_t polygon) {
    Shape piece = parent;
    piece.key = Key{fold(fold(step.value, parent.key.value), local)};
    piece.geometry = none;
    piece.polygon = static_cast<std::uint32_t>(polygon);
    piece.border_in_paper = parent.inked;
    piece.is_mark = parent.is_mark;
    return piece;
}

Diagnostic too_many_shapes(const OperatorInput& input);
// Whether things `spacing` (a parameter, px) apart must be far more than may be made: told before any is.
bool is_too_dense(const OperatorInput& input, std::string_view spacing);

// Runs `work` on every shape, in parallel and in batches, and joins what it adds: one output group a port.
// `work` adds polygons to `geometry` and the shapes of port p to `ports[p]`, and returns false to stop with
// `too_many_shapes`.
struct Batch {
    Polygons geometry;
    std::vector<std::vector<Shape>> ports;
    std::uint64_t added = 0;  // shapes so far
};
using ShapeWork = std::function<void(std::size_t index, const Shape& shape, PolygonView polygon, Batch& batch)>;
Result<OperatorOutput> for_each_shape(const OperatorInput& input, const ShapeWork& work);

}  // namespace filigree::tangle
