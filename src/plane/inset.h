// Insets: the part of a polygon that is farther than a distance from its boundary.
//
// Edges move inwards; those that turn over are collapsed in the order of their events. The result is
// checked (simple, inside, and nowhere nearer than the distance), and where the check fails the shape takes
// the slow, general way through a polygon clipping library. Reflex corners (convex ones of holes) are mitred up
// to a limit, or rounded; rounded corners stay outside the arc. Paper: gTangle, section 4.2 (geometric outline).
//
// Guarantees: inner polygons keep polygon.h's conventions, and none of their edges comes nearer than the
// distance less 5e-7 px to the boundary (less half the distance, where that is smaller). Cost: O(n log n) for
// shapes of even detail; some 20 microseconds for 100 vertices.
#pragma once

#include "plane/polygon.h"

namespace filigree {

enum class Join { mitre, round };

struct InsetOptions {
    double distance = 1;  // px, > 0; below 2^-20, or not a number, counts as 2^-20
    Join join = Join::mitre;
    double mitre_limit = 4;   // of the distance, 1 to 1000; longer corners are cut off square
    double tolerance = 0.25;  // px: how far a rounded corner's polyline may lie from its arc
};

struct Inset {
    Polygons inner;                 // none where the shape vanishes, several where it falls apart
    bool took_general_way = false;  // through the clipping library
};
Inset inset(PolygonView shape, const InsetOptions& options);

// The shape without the inner polygons, which must lie inside it and not touch its boundary: the band of an
// outline, or what remains around placed shapes. Built from the rings, without a boolean.
Polygons without(PolygonView shape, const Polygons& inner);

}  // namespace filigree
