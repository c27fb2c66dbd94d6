#include "plane/distance_field.h"

#include <algorithm>
#include <cmath>

namespace filigree {

std::vector<double> signed_distances(const EdgeTree& border, const Grid& grid) {
    std::vector<double> distances(grid.size());
    const double everywhere =
        grid.step * static_cast<double>(grid.columns + grid.rows) + std::fabs(grid.low.x) + std::fabs(grid.low.y);
    // The nearest places that the nodes before found bound where the next one has to look.
    std::vector<Vec> above(grid.columns);
    Vec last;
    for (std::uint32_t row = 0; row < grid.rows; ++row) {
        for (std::uint32_t i = 0; i < grid.columns; ++i) {
            // To and fro, so that each node lies beside the one before it.
            const std::uint32_t column = row % 2 == 0 ? i : grid.columns - 1 - i;
            const Vec p = grid.node(column, row);
            double reach2 = everywhere * everywhere;
            if (row > 0 || i > 0) reach2 = std::min(reach2, dot(p - last, p - last));
            if (row > 0) reach2 = std::min(reach2, dot(p - above[column], p - above[column]));
            const double reach = std::sqrt(reach2) * (1 + 1e-9) + 1e-9;
            const EdgeTree::Place place = border.place(p, reach, reach);
            distances[grid.index(column, row)] = place.is_inside ? place.distance : -place.distance;
            last = above[column] = place.nearest;
        }
    }
    return distances;
}

}  // namespace filigree
