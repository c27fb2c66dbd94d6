// A point well inside a polygon: where a mark or a label goes, and what a piece is told apart by.
//
// `inner_point` is the centre of a large inscribed circle: where that can be found in bounded time its radius is
// within a hundredth of the greatest. `quick_inner_point` is just somewhere inside. Both depend on the geometry
// alone, not on where rings start or in what order they come. Of slivers thinner than the grid they give a point of
// the border.
// Cost: O(n) to build a tree of the n edges and O(log n) for each of at most some thousand tries; O(n) for the quick
// one.
#pragma once

#include "plane/polygon.h"

namespace filigree {

Vec inner_point(PolygonView shape);        // px
Vec quick_inner_point(PolygonView shape);  // px

}  // namespace filigree
