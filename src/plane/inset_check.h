// What holds of every accepted inset, whichever way it was made.
#pragma once

#include <span>

#include "plane/edge_tree.h"

namespace filigree {

// How much nearer than the distance the result may lie, px: rounding to the grid, and of doubles for shapes
// of millions of px.
double inset_slack(double distance, const Box& shape_box);

// Whether no two edges of the rings meet, except neighbours at their common point. Exact.
bool are_simple_and_apart(std::span<const RingView> rings, Point origin);

// Whether no edge of the rings comes nearer than `reach` to the boundary, or crosses it.
bool keep_away(std::span<const RingView> rings, Point origin, const EdgeTree& boundary, double reach);

}  // namespace filigree
