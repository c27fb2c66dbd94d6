// Points spread evenly over a region: where objects, stipples and cells of a mosaic go (gTangle, section 4.2;
// Secord 2002 with a density).
//
// Darts are thrown into a raster of the region until no other fits (as scatter does, only coarser and far faster),
// relaxed there to the centroids of their geodesic cells, and then settled: pushed apart and off the border as far as
// they should keep. A point that cannot keep apart from another is left out. Guarantees: `apart` holds for every two
// points; points lie inside the region; nothing depends on where rings start, and little on what is far away: keys
// are cells of a grid of the whole plane. Cost: about 3 microseconds a point where points are many.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "plane/polygon.h"

namespace filigree {

struct SpreadOptions {
    double spacing = 1;               // px, > 0: usual distance of neighbours; where there is a density, at density 1
    double apart = 0;                 // px: least distance of any two points, no more than the spacing
    double clearance = 0;             // px: points keep so far from the border where they can,
    double least_clearance = 0;       // px: and about so far everywhere
    unsigned rounds = 3;              // of relaxation, at most; 0: none
    std::uint64_t seed = 0;           // the one recorded choice, `scatter`
    std::uint64_t limit = 1'000'000;  // at most so many points; more is for the caller to report
    // How dense at a place, 0 to 1: the distance of neighbours is the spacing over the root of it. None: 1.
    std::function<double(Vec)> density = {};
};

struct SpreadPoint {
    Vec at;                  // px
    std::uint64_t cell = 0;  // a local key: which cell of a grid of the plane it started in
};
// Ordered by cell.
std::vector<SpreadPoint> spread(PolygonView region, const SpreadOptions& options);

}  // namespace filigree
