// How far the nodes of a grid lie from a polygon's boundary: positive inside, negative outside.
//
// Exact up to rounding: each node asks a tree of the edges, bounded by what its neighbour found, some 50 to 100 ns
// a node.
#pragma once

#include <vector>

#include "plane/edge_tree.h"
#include "plane/grid_field.h"

namespace filigree {

// Of the grid's nodes, row by row, px. `border` holds the polygon's edges, relative to the grid's origin.
std::vector<double> signed_distances(const EdgeTree& border, const Grid& grid);

}  // namespace filigree
