// Random shapes for the tests and the benchmark of insets: wobbly discs, wild polygons, with holes or without.
#pragma once

#include <algorithm>
#include <vector>

#include "base/elementary.h"
#include "base/test_cases.h"
#include "plane/polygon.h"

namespace filigree::test_shapes {

// A disc whose radius changes smoothly around it, by up to `wobble` of it, and by up to `jitter` at random.
inline std::vector<Point> wobbly_ring(CaseRandom& random, Vec centre, double radius, int count, double wobble,
                                      double jitter) {
    double phase[3], size[3];
    for (int k = 0; k < 3; ++k) {
        phase[k] = random.between(0, 6.28);
        size[k] = random.between(0, wobble / 3);
    }
    std::vector<Point> ring;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * elementary::pi * i / count;
        double r = 1 + random.between(-jitter, jitter);
        for (int k = 0; k < 3; ++k) r += size[k] * elementary::cos_sin((2 * k + 2) * angle + phase[k]).cos;
        const elementary::CosSin at = elementary::cos_sin(angle);
        ring.push_back(snap(centre + Vec{at.cos, at.sin} * (radius * r)));
    }
    return ring;
}

inline bool cross_properly(Point a, Point b, Point c, Point d) {
    return orientation(a, b, c) * orientation(a, b, d) <= 0 && orientation(c, d, a) * orientation(c, d, b) <= 0;
}

// Random points joined in random order and untangled: thin arms, sharp corners, deep bays. Empty if that failed.
inline std::vector<Point> wild_ring(CaseRandom& random, Vec centre, double radius, int count) {
    std::vector<Point> ring;
    for (int i = 0; i < count; ++i) {
        const double x = random.between(-radius, radius);
        const double y = random.between(-radius, radius);
        ring.push_back(snap(centre + Vec{x, y}));
    }
    const auto n = static_cast<std::size_t>(count);
    for (int round = 0; round < 200; ++round) {
        bool crossed = false;
        for (std::size_t i = 0; i + 2 < n; ++i) {
            for (std::size_t j = i + 2; j < n; ++j) {
                if (i == 0 && j == n - 1) continue;
                if (!cross_properly(ring[i], ring[i + 1], ring[j], ring[(j + 1) % n])) continue;
                std::reverse(ring.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                             ring.begin() + static_cast<std::ptrdiff_t>(j) + 1);
                crossed = true;
            }
        }
        if (crossed) continue;
        if (doubled_area(ring) < 0) std::reverse(ring.begin(), ring.end());
        return ring;
    }
    return {};
}

inline Polygons one_polygon(const std::vector<std::vector<Point>>& rings) {
    Polygons shape;
    for (std::size_t r = 0; r < rings.size(); ++r) {
        std::vector<Point> ring = rings[r];
        if ((doubled_area(ring) > 0) != (r == 0)) std::reverse(ring.begin(), ring.end());
        shape.add_ring(ring);
    }
    shape.end_polygon();
    return shape;
}

// A wobbly disc of some `radius` with up to `most_holes` wobbly holes that keep apart.
inline Polygons wobbly_shape(CaseRandom& random, double radius, int count, int most_holes) {
    std::vector<std::vector<Point>> rings{wobbly_ring(random, {0, 0}, radius, count, 0.5, 0.02)};
    const int holes = random.whole(0, most_holes);
    std::vector<Vec> centres;
    for (int tries = 0; tries < 40 && static_cast<int>(centres.size()) < holes; ++tries) {
        const elementary::CosSin at = elementary::cos_sin(random.between(0, 6.28));
        const Vec centre = Vec{at.cos, at.sin} * (radius * random.between(0, 0.32));
        const double size = radius * 0.1;
        const bool is_free = std::all_of(centres.begin(), centres.end(),
                                         [&](Vec other) { return length(other - centre) > 2 * size * 1.4; });
        if (!is_free) continue;
        centres.push_back(centre);
        rings.push_back(wobbly_ring(random, centre, size, random.whole(5, 24), 0.3, 0.05));
    }
    return one_polygon(rings);
}

}  // namespace filigree::test_shapes
