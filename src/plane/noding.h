// Edges cut where they meet, so that afterwards any two share at most an end; inner part of clean.
//
// Crossings are rounded to the grid, which can bend an edge by about a grid unit over its neighbours; cutting
// is repeated until nothing meets. Every decision is exact, and a crossing comes out at the same point whatever
// the order and direction of the edges. Overlapping edges become one edge with the sum of their weights.
#pragma once

#include <cstdint>
#include <vector>

#include "plane/polygon.h"
#include "plane/ring_sweep.h"

namespace filigree {

// How far the winding numbers about two sets of rings change from below an edge to above it.
struct Winding {
    std::int32_t first = 0;
    std::int32_t second = 0;

    bool operator==(const Winding&) const = default;
};
constexpr Winding operator+(Winding a, Winding b) { return {a.first + b.first, a.second + b.second}; }
constexpr Winding operator-(Winding a) { return {-a.first, -a.second}; }

struct WeightedEdge {
    sweep::Segment at;
    Winding weight;
};

// The edges of a ring of which a turn counts as `weight`.
void append_edges(std::vector<WeightedEdge>& edges, RingView ring, Winding weight);

// With `parity`, weights count modulo 2. Edges without weight go. O((edges + meetings) log edges) for edges that
// keep to their own place in the plane.
void node_edges(std::vector<WeightedEdge>& edges, bool parity);

}  // namespace filigree
