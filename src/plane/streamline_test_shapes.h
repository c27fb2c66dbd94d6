// Random regions for the tests and the benchmark of streamline cuts.
#pragma once

#include "plane/inset_test_shapes.h"

namespace filigree::test_shapes {

// A wobbly shape with up to three holes, or a wild one without; about `radius` px.
inline Polygons random_region(CaseRandom& random, double radius) {
    if (random.below(4) == 0) {
        const std::vector<Point> ring = wild_ring(random, {0, 0}, radius, random.whole(4, 14));
        if (ring.size() >= 4) return one_polygon({ring});
    }
    return wobbly_shape(random, radius, random.whole(8, 120), 3);
}

inline Polygons rectangle(double width, double height) {
    return one_polygon({{snap({0, 0}), snap({width, 0}), snap({width, height}), snap({0, height})}});
}

inline std::vector<Point> regular_ring(Vec centre, double radius, int count) {
    std::vector<Point> ring;
    for (int i = 0; i < count; ++i) {
        const elementary::CosSin at = elementary::cos_sin_degrees(360.0 * i / count);
        ring.push_back(snap(centre + radius * Vec{at.cos, at.sin}));
    }
    return ring;
}

}  // namespace filigree::test_shapes
