// The weld: neighbours that cut one border at different places get each other's vertices.
//
// Two branches of a derivation split a shared border independently, so one side's vertices lie inside the
// other side's edges (T-junctions). The weld inserts, into every edge, the vertices of all polygons that
// lie within `tolerance` of it, and goes on with the shorter edges until none has a vertex to take;
// afterwards neighbours share every edge exactly, which perturbation, shared-border plotting and adjacency
// stand on. Only drawing welds; derivations keep their own geometry.
//
// Guarantees: what becomes of an edge depends on its two ends and the set of all vertices alone, and is the
// reverse for the reversed edge; so the order of polygons and rings does not matter, and a second weld
// changes nothing. The tip of a needle thinner than the tolerance ends as edges that lie on each other.
#pragma once

#include "plane/polygon.h"

namespace filigree {

constexpr double weld_tolerance = 0x1p-22;  // px

// Polygons as given, in the same order, with more vertices; none is moved or removed. Only vertices that an
// edge's ends see at less than 45 degrees from it are inserted, so none beyond an end or just around a
// corner. Points off the plane (|x| > grid_limit) stay as they are and weld with nothing.
// O(points log points), also for points in clusters.
Polygons weld(const Polygons& polygons, double tolerance = weld_tolerance);

}  // namespace filigree
