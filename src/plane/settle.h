// Points pushed a little until they keep apart and off a border; the last step of `spread`.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plane/edge_tree.h"
#include "plane/region_raster.h"

namespace filigree {

struct SettleOptions {
    double apart = 0;      // px: least distance of two points
    double clearance = 0;  // px: distance from the border, where there is room
    double even = 0;       // px: below this distance points push each other gently, before all else
};
// Moves the points, all at once in every round, and tells which may stay: those inside that keep apart from all
// others that stay. `border` is the region's, with coordinates as they are.
std::vector<std::uint8_t> settle(std::span<Vec> points, const RegionRaster& raster, const EdgeTree& border,
                                 const SettleOptions& options);

}  // namespace filigree
