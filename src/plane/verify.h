// The invariants of plane geometry as functions: tests, fuzzers, `--verify` and benchmarks call them.
//
// They share no code with what they check. Vertices are rounded to the grid (2^-26 px), which moves edges a
// little: a crossing or an overlap counts only where it is wider than `tolerance` px, that is, where the
// wrongly covered place has room for a disc of that diameter. Edges that lie on each other exactly (a spike,
// a corridor of no width, a hole along the outer ring) count where they do so for more than 1024 tolerances:
// the sides of a needle may coincide by rounding for a short way. All else is exact.
// Touching is no flaw: rings at points, polygons along borders. Cost: O(n log n); see winding_check.h.
#pragma once

#include <optional>
#include <string>

#include "plane/polygon.h"

namespace filigree {

constexpr double verify_tolerance = 0x1p-20;  // px

// A sentence on the first broken convention of polygon.h (no rings, too few points, a point off the plane,
// repeated points, wrong orientation, a ring that crosses itself or another ring or runs along one, a hole
// outside), or none.
std::optional<std::string> find_flaw(PolygonView polygon, double tolerance = verify_tolerance);

// Two polygons whose interiors overlap by more than the tolerance, as "polygons 3 and 7 overlap near (x, y)".
// The polygons must be without flaws themselves; rings of the wrong orientation are taken as turned round.
std::optional<std::string> find_overlap(const Polygons& polygons, double tolerance = verify_tolerance);

}  // namespace filigree
