// Random shapes for the tests and the benchmark of insets: wobbly discs, wild polygons, with holes or without.
#pragma once

#include <algorithm>
#include <vector>

#include "base/elementary.h"
#include "base/random.h"
#include "plane/polygon.h"

namespace filigree::test_shapes {

struct Draws {  // numbered random values of one test case
    std::uint64_t seed = 0;
    std::uint64_t count = 0;

    double unit() { return to_unit(random_bits(seed, Key{7}, 11, count++)); }
    double between(double low, double high) { return low + (high - low) * unit(); }
    int whole(int low, int high) {  // both included
        return low + static_cast<int>(
                         to_whole(random_bits(seed, Key{7}, 11, count++), static_cast<std::uint32_t>(high - low + 1)));
    }
};

// A disc whose radius changes smoothly around it, by up to `wobble` of it, and by up to `jitter` at random.
inline std::vector<Point> wobbly_ring(Draws& draws, Vec centre, double radius, int count, double wobble,
                                      double jitter) {
    double phase[3], size[3];
    for (int k = 0; k < 3; ++k) {
        phase[k] = draws.between(0, 6.28);
        size[k] = draws.between(0, wobble / 3);
    }
    std::vector<Point> ring;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * elementary::pi * i / count;
        double r = 1 + draws.between(-jitter, jitter);
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
inline std::vector<Point> wild_ring(Draws& draws, Vec centre, double radius, int count) {
    std::vector<Point> ring;
    for (int i = 0; i < count; ++i) {
        const double x = draws.between(-radius, radius);
        const double y = draws.between(-radius, radius);
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
inline Polygons wobbly_shape(Draws& draws, double radius, int count, int most_holes) {
    std::vector<std::vector<Point>> rings{wobbly_ring(draws, {0, 0}, radius, count, 0.5, 0.02)};
    const int holes = draws.whole(0, most_holes);
    std::vector<Vec> centres;
    for (int tries = 0; tries < 40 && static_cast<int>(centres.size()) < holes; ++tries) {
        const elementary::CosSin at = elementary::cos_sin(draws.between(0, 6.28));
        const Vec centre = Vec{at.cos, at.sin} * (radius * draws.between(0, 0.32));
        const double size = radius * 0.1;
        const bool is_free = std::all_of(centres.begin(), centres.end(),
                                         [&](Vec other) { return length(other - centre) > 2 * size * 1.4; });
        if (!is_free) continue;
        centres.push_back(centre);
        rings.push_back(wobbly_ring(draws, centre, size, draws.whole(5, 24), 0.3, 0.05));
    }
    return one_polygon(rings);
}

}  // namespace filigree::test_shapes
