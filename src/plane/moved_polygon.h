// Polygons whose points were moved and rounded to the grid, made clean again; inner part of placing and repeating.
#pragma once

#include <vector>

#include "plane/polygon.h"

namespace filigree {

// Takes repeated points out of a ring, and the spikes without width that rounding leaves, also where it closes.
void tidy_ring(std::vector<Point>& points);

// Adds a polygon given by its moved rings, turned round where the move reflects, without what has collapsed: rings with
// fewer than three points, or without area of their sign. Where that is the outer one nothing is added: false.
bool add_moved(Polygons& to, PolygonView moved, bool is_reflected);
// The same of an open line: without repeated points; false where less than two points are left.
bool add_moved_line(Polygons& to, RingView moved);

}  // namespace filigree
