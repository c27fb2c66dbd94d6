// The exact cut of a polygon with holes by polylines: the general way, for curves that are no family of levels.
//
// Curves may cross each other, themselves and the border, be open or closed, run along the border, lie wholly
// inside or miss the polygon. What of them bounds a piece on both sides cuts; loose ends cut nothing; an end within
// half a grid unit of a line touches it. Paper: gTangle, section 4.2 (split by arbitrary curves).
//
// Guarantees: the pieces partition the shape (both sides of a cut share all of its vertices, so the areas add up
// to the shape's to 1e-9) and are clean (polygon.h). Crossings on the shape's own edges depend on the edge and
// the curve alone: neighbours that are cut by one curve share their new vertices, too. The result depends on the
// geometry alone, not on the order of curves and rings, on their direction or on where they start: a ring starts
// at its least point, holes are in the order of theirs, pieces in the order of their least points.
// Refuses: a curve with a coordinate that is not finite or off the plane (point.h) cuts nothing; with more than
// 2^30 edges or 2^25 crossings the shape stays in one piece. The shape must be clean.
// Cost: O((edges + crossings) log edges) for curves that keep to their own place in the plane.
#pragma once

#include <span>

#include "plane/path.h"
#include "plane/polygon.h"

namespace filigree {

Polygons cut_by_curves(PolygonView shape, std::span<const Polyline> curves);

}  // namespace filigree
