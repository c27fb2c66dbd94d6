// The points that edges take when they are welded (weld.h); inner part of weld and border_map.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plane/border_map.h"
#include "plane/point_tree.h"

namespace filigree {

struct EdgeInserts {
    std::vector<std::uint32_t> begins;  // of each edge in `points`, and one more
    std::vector<std::uint32_t> points;  // from the low end to the high one

    std::span<const std::uint32_t> of(std::uint32_t edge) const {
        return {points.data() + begins[edge], points.data() + begins[edge + 1]};
    }
};
EdgeInserts edge_inserts(const PointTree& tree, std::span<const BorderMap::Edge> edges, double tolerance);

}  // namespace filigree
