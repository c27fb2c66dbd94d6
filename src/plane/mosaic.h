// A region parted into the Voronoi cells of sites: every place goes to the nearest site.
//
// Guarantee: an exact partition (curve_cut.h). Where the region is not convex a cell may come in several pieces. Cost:
// O(n log n) for the cells, and the cut.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plane/polygon.h"

namespace filigree {

struct Mosaic {
    Polygons pieces;                   // in the order of their least points
    std::vector<std::uint32_t> sites;  // of each piece
};
// Sites may lie outside the region; of several in one place the first counts. Without sites it stays whole, for site 0.
Mosaic mosaic(PolygonView region, std::span<const Vec> sites);

}  // namespace filigree
