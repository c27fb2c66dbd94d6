// Where closed chains of directed edges wind wrongly: the one search behind `find_flaw` and `find_overlap`.
//
// The winding number of a place counts how often the edges turn around it (from +x towards +y is positive).
// Whatever breaks a polygon's shape shows in it: where edges cross, three values follow one another around
// the crossing, so one of them is neither 0 nor 1; a hole outside or in a hole makes -1, an overlap 2.
//
// Guarantees: what is reported is so (winding numbers are exact), and has room for a disc of the given
// diameter. What has room for a disc that touches an edge somewhere between its ends is found. Edges that lie
// on each other within rounding are never reported.
// Method: boxes are halved until few edges reach one; there, a disc rolls along both sides of each edge, and
// each stretch in which it touches no other edge is one place to count at. Cost: O(n log n) for edges spread
// out or in clusters; quadratic only for many long edges that lie aslant
// and close together or meet at one vertex.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "plane/polygon.h"

namespace filigree {

// Places between grid points: 16 to a grid unit, so that a disc's centre never has to lie on an edge.
constexpr std::int64_t fine_per_grid = 16;
struct FinePoint {
    std::int64_t x = 0, y = 0;

    bool operator==(const FinePoint&) const = default;
};
constexpr FinePoint to_fine(Point p) { return {p.x * fine_per_grid, p.y * fine_per_grid}; }
Vec to_px(FinePoint p);

struct DirectedEdge {
    Point from, to;
};

struct WindingRange {
    int least = 0, most = 1;  // the right values
    double tolerance = 0;     // px: diameter of the disc; below 2^-29 px, or 2^-43 of the extent, it counts as that
    std::optional<double> longest_run;  // px: edges lying exactly on each other for longer are wrong, too
};

struct WindingFlaw {
    FinePoint at;
    bool is_run = false;  // edges lie on each other here; otherwise the winding number is wrong
};
// The edges must form closed chains and lie on the plane (|x| <= grid_limit). The flaw found depends on the
// order of the edges, whether there is one does not.
std::optional<WindingFlaw> find_wrong_winding(std::span<const DirectedEdge> edges, const WindingRange& range);

// How often a ring turns around a place. Exact; linear in the points.
int winding(RingView ring, FinePoint at);

}  // namespace filigree
