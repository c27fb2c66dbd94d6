// The level lines along which streamline_cut.h splits a shape: a scalar field, its levels, and the lines.
#pragma once

#include <functional>

#include "plane/edge_tree.h"
#include "plane/isolines.h"
#include "plane/streamline_cut.h"

namespace filigree {

// All in px relative to `origin`.
struct StreamlineLevels {
    std::function<double(Vec)> value;
    std::function<Vec(Vec)> gradient;
    std::vector<double> levels;    // increasing
    std::int32_t first_strip = 0;  // of what lies below the first level
    std::vector<Polyline> lines;
    bool is_too_fine = false;
};
StreamlineLevels streamline_levels(PolygonView shape, Point origin, const EdgeTree& border,
                                   const StreamlineCutOptions& options);

}  // namespace filigree
