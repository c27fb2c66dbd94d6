// For tests alone: vectors, frames and rings at random.
#pragma once

#include <cstddef>
#include <vector>

#include "base/elementary.h"
#include "base/test_cases.h"
#include "space/vector.h"

namespace filigree {

inline Vec3 random_vector(CaseRandom& random, double reach) {  // in a cube
    const double x = random.between(-reach, reach), y = random.between(-reach, reach);
    return {x, y, random.between(-reach, reach)};
}

inline Frame3 random_frame(CaseRandom& random) {
    for (;;) {
        const Vec3 heading = random_vector(random, 1), other = random_vector(random, 1);
        if (length(heading) < 0.1 || length(cross(heading, other)) < 0.1) continue;
        const Vec3 up = unit(cross(heading, other));
        return {unit(heading), cross(up, unit(heading)), up};
    }
}

// A star-shaped ring in the frame's plane of left and up, mostly not convex, that runs from left to up.
inline std::vector<Vec3> random_star(CaseRandom& random, Vec3 middle, const Frame3& frame, double radius) {
    std::vector<Vec3> ring;
    const std::uint32_t count = 3 + random.below(9);
    for (std::uint32_t i = 0; i < count; ++i) {
        const elementary::CosSin turn = elementary::cos_sin_degrees(360.0 * i / count);
        const double reach = radius * random.between(0.2, 1);
        ring.push_back(middle + frame.left * (reach * turn.cos) + frame.up * (reach * turn.sin));
    }
    return ring;
}

}  // namespace filigree
