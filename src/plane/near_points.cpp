#include "plane/near_points.h"

#include <algorithm>
#include <cmath>

namespace filigree {

NearPoints::NearPoints(std::span<const Vec> points, double reach) : starts_(points.size() + 1, 0) {
    if (points.empty()) return;
    Vec low = points[0], high = points[0];
    for (const Vec p : points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const Vec size = high - low;
    // Not many more squares than points, however small the reach.
    double side = std::max(reach, 0x1p-30);
    const double most = 4 * static_cast<double>(points.size()) + 64;
    while ((std::floor(size.x / side) + 1) * (std::floor(size.y / side) + 1) > most) side *= 2;
    const auto columns = static_cast<std::int64_t>(size.x / side) + 1;
    const auto rows = static_cast<std::int64_t>(size.y / side) + 1;
    const auto square_of = [&](Vec p) {
        const auto column = static_cast<std::int64_t>((p.x - low.x) / side);
        const auto row = static_cast<std::int64_t>((p.y - low.y) / side);
        return row * columns + column;
    };
    std::vector<std::uint32_t> begins(static_cast<std::size_t>(columns * rows + 1), 0);
    std::vector<std::int64_t> squares(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        squares[i] = square_of(points[i]);
        ++begins[static_cast<std::size_t>(squares[i] + 1)];
    }
    for (std::size_t s = 1; s < begins.size(); ++s) begins[s] += begins[s - 1];
    std::vector<std::uint32_t> members(points.size()), next(begins.begin(), begins.end() - 1);
    for (std::uint32_t i = 0; i < points.size(); ++i) members[next[static_cast<std::size_t>(squares[i])]++] = i;

    near_.reserve(points.size() * 8);
    const double reach2 = reach * reach * (1 + 1e-12);
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        const std::int64_t column = squares[i] % columns, row = squares[i] / columns;
        const std::size_t first = near_.size();
        for (std::int64_t y = std::max<std::int64_t>(row - 1, 0); y <= std::min(row + 1, rows - 1); ++y) {
            const std::int64_t left = y * columns + std::max<std::int64_t>(column - 1, 0);
            const std::int64_t right = y * columns + std::min(column + 1, columns - 1);
            for (std::uint32_t m = begins[static_cast<std::size_t>(left)];
                 m < begins[static_cast<std::size_t>(right + 1)]; ++m) {
                const Vec between = points[members[m]] - points[i];
                if (members[m] != i && dot(between, between) <= reach2) near_.push_back(members[m]);
            }
        }
        std::sort(near_.begin() + static_cast<std::ptrdiff_t>(first), near_.end());
        starts_[i + 1] = static_cast<std::uint32_t>(near_.size());
    }
}

}  // namespace filigree
