// The parts of a line that lie inside polygons: how open lines are cut off at a border.
#pragma once

#include "plane/edge_tree.h"
#include "plane/polygon.h"

namespace filigree {

// Adds each part, from border to border, as a polygon of one ring that is no ring: two points or more, not closed. The
// border's edges are relative to the grid's origin, px; what is inside them is told by the even-odd rule. Cuts are
// rounded to the grid. Parts that come to less than two points there are left out.
void add_parts_inside(Polygons& to, RingView line, const EdgeTree& border);

}  // namespace filigree
