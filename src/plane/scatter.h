// Points spread over a region like pebbles: random, none closer than a distance, no gap left where another
// would fit (maximal Poisson-disc sampling; gTangle, section 4.2, step 1 of the placement).
//
// Points are thrown into the squares of a grid of the whole plane, into those still open once more at half the
// size, and so on; where and in which turn is a matter of the seed and the square alone. So what a cell holds
// depends on what is near, and a border moved far away changes nothing here. Gaps that remain are narrower than
// 2^-12 of the spacing (or of the region, where that is smaller). Some 3 microseconds a point; memory grows with
// the number of points, and stays bounded by `limit` whatever the region.
#pragma once

#include <cstdint>
#include <vector>

#include "plane/polygon.h"

namespace filigree {

struct ScatterOptions {
    double spacing = 1;               // px, > 0 (else there are no points): least distance between two points
    double clearance = 0;             // px: least distance from the region's boundary; below 0 counts as 0
    std::uint64_t seed = 0;           // the one recorded choice, `scatter`
    std::uint64_t limit = 1'000'000;  // at most so many points; more is for the caller to report
};

struct ScatteredPoint {
    Vec at;                  // px
    std::uint64_t cell = 0;  // a local key: which cell of the scatter grid it was thrown in
};
// Ordered by cell (rows from the top, then columns). Deterministic; independent of where rings start.
std::vector<ScatteredPoint> scatter(PolygonView region, const ScatterOptions& options);

}  // namespace filigree
