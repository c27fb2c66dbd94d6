// The boundary of a region given by winding numbers over noded edges; inner part of clean.
#pragma once

#include <vector>

#include "plane/noding.h"

namespace filigree {

enum class Region {
    first,       // where the first winding number is not zero
    first_odd,   // where it is odd
    either,      // where one of both is not zero
    both,        // where both are not zero
    only_first,  // where the first is not zero and the second is
};

// Rings around the region, outers positive and holes negative as polygon.h has them. Edges must be distinct and
// share ends at most (noding.h). Each ring visits a vertex once;
// where the region is pinched, rings touch.
std::vector<std::vector<Point>> boundary(std::vector<WeightedEdge> edges, Region region);

}  // namespace filigree
