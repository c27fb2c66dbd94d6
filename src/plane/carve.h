// A region parted into the shapes placed in it and what remains around them.
//
// Guarantee: placed pieces and remainder partition the region and are clean (polygon.h). Objects inside become holes
// of the remainder as they are, without a boolean; only those that cross the border are cut. Cost: O(n log n) in all
// points, whatever the number of holes.
#pragma once

#include <cstdint>
#include <vector>

#include "plane/edge_tree.h"
#include "plane/polygon.h"

namespace filigree {

struct Carving {
    static constexpr std::uint32_t none = UINT32_MAX;

    Polygons placed;
    std::vector<std::uint32_t> owners;  // of each placed piece: its object; pieces of one lie side by side
    Polygons remainder;
    std::vector<std::uint32_t> enclosing;  // of each piece of the remainder: the object whose hole it fills, or none
};

// `objects` are clean, disjoint and apart; polygons of one object have the same number in `owners`, ascending.
// `border` is the region's, with coordinates as they are. Where `may_cross` is false, all objects must lie inside and
// keep off the border; else those that lie outside are left out.
Carving carve(PolygonView region, const EdgeTree& border, const Polygons& objects,
              const std::vector<std::uint32_t>& owners, bool may_cross);

}  // namespace filigree
