// Which points are near each point: a grid over them, built once.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plane/point.h"

namespace filigree {

class NearPoints {
public:
    // Finds those no farther than `reach` px from each other.
    NearPoints(std::span<const Vec> points, double reach);

    // Of a point, ascending, without itself. Some may be a little farther.
    std::span<const std::uint32_t> of(std::size_t point) const {
        return {near_.data() + starts_[point], near_.data() + starts_[point + 1]};
    }

private:
    std::vector<std::uint32_t> starts_, near_;
};

}  // namespace filigree
