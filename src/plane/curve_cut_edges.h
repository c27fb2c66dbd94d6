// The edges of a shape and of curves, cut where they meet; inner part of cut_by_curves.
//
// Crossings are rounded to the grid, which bends an edge by about a grid unit; an edge that passes another's end by
// half a unit is led through it. Edges that were cut are tested again until nothing meets. Every decision is exact,
// and a crossing depends on the two edges alone, whatever their order and direction. Unlike noding.h it keeps what
// every edge is a part of, does not look twice at edges that stayed whole, and keeps the areas along the shape's own
// edges.
#pragma once

#include <cstdint>
#include <vector>

#include "plane/edge_tree.h"
#include "plane/polygon.h"

namespace filigree {

struct CutEdge {
    static constexpr std::uint32_t on_curve = UINT32_MAX;

    Point from, to;                 // of a shape's edge, in the direction of its ring
    std::uint32_t side = on_curve;  // which edge of the shape this is a part of
    bool is_new = true;             // not yet tested against the others
};

// Afterwards any two edges are equal (in either direction), share an end, or have nothing in common. False: there were
// too many crossings, or they did not come to an end. `origin` lies among the edges.
bool cut_where_they_meet(std::vector<CutEdge>& edges, Point origin);

}  // namespace filigree
