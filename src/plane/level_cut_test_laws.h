// The laws that every level cut obeys, as checks for the tests.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "plane/level_cut_test_shapes.h"
#include "plane/verify.h"

namespace filigree::level_cut_shapes {

inline LevelFamily lines(double degrees, std::vector<double> levels, Vec origin = {}) {
    LevelFamily family;
    family.frame = {origin, turn({1, 0}, degrees)};
    family.levels = std::move(levels);
    return family;
}

inline LevelFamily forty_strips(double degrees) {
    LevelFamily family = lines(degrees, {});
    for (int k = -20; k <= 20; ++k) family.levels.push_back(10.0 * k);
    return family;
}

inline double edge_length(Point a, Point b) { return length(to_px({b.x - a.x, b.y - a.y})); }

inline double perimeter(PolygonView shape) {
    double sum = 0;
    for (std::size_t r = 0; r < shape.ring_count(); ++r) {
        const RingView ring = shape.ring(r);
        for (std::size_t i = 0; i < ring.size(); ++i) sum += edge_length(ring[i], ring[(i + 1) % ring.size()]);
    }
    return sum;
}

// The length of the edges without a partner in the other direction: for a conforming partition, the shape's
// perimeter.
inline double unmatched_length(const Polygons& pieces) {
    struct Edge {
        Point a, b;
        int direction = 0;
    };
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (std::size_t r = 0; r < pieces[i].ring_count(); ++r) {
            const RingView ring = pieces[i].ring(r);
            for (std::size_t k = 0; k < ring.size(); ++k) {
                const Point a = ring[k], b = ring[(k + 1) % ring.size()];
                edges.push_back(a < b ? Edge{a, b, 1} : Edge{b, a, -1});
            }
        }
    }
    std::sort(edges.begin(), edges.end(),
              [](const Edge& e, const Edge& f) { return e.a != f.a ? e.a < f.a : e.b < f.b; });
    double sum = 0;
    for (std::size_t i = 0; i < edges.size();) {
        int total = 0;
        std::size_t end = i;
        for (; end < edges.size() && edges[end].a == edges[i].a && edges[end].b == edges[i].b; ++end)
            total += edges[end].direction;
        sum += std::abs(total) * edge_length(edges[i].a, edges[i].b);
        i = end;
    }
    return sum;
}

inline double profile_at(const Profile& profile, double u) {
    if (profile.samples.empty()) return 0;
    const auto n = static_cast<std::int64_t>(profile.samples.size());
    const auto k = static_cast<std::int64_t>(std::floor(u / profile.step));
    const auto sample = [&](std::int64_t i) { return profile.samples[static_cast<std::size_t>(((i % n) + n) % n)]; };
    const double t = u / profile.step - static_cast<double>(k);
    return sample(k) + t * (sample(k + 1) - sample(k));
}
inline double greatest_slope(const Profile& profile) {
    double slope = 0;
    for (std::size_t i = 0; i < profile.samples.size(); ++i) {
        const double next = profile.samples[(i + 1) % profile.samples.size()];
        slope = std::max(slope, std::fabs(next - profile.samples[i]) / profile.step);
    }
    return slope;
}

inline void expect_partition(const Polygons& shape, const LevelFamily& family, const LevelCut& cut) {
    const double whole = area(shape);
    ASSERT_EQ(cut.pieces.size(), cut.strips.size());
    EXPECT_NEAR(area(cut.pieces), whole, 1e-9 * whole);
    EXPECT_NEAR(unmatched_length(cut.pieces), perimeter(shape[0]), 1e-9 * perimeter(shape[0]));
    EXPECT_TRUE(std::is_sorted(cut.strips.begin(), cut.strips.end()));
    const double slack = 0x1p-19 * (1 + greatest_slope(family.profile));
    for (std::size_t i = 0; i < cut.pieces.size(); ++i) {
        const PolygonView piece = cut.pieces[i];
        EXPECT_EQ(find_flaw(piece).value_or(""), "") << "piece " << i;
        const std::int64_t k = std::int64_t{cut.strips[i]} - family.first_strip;
        ASSERT_GE(k, 0);
        ASSERT_LE(k, static_cast<std::int64_t>(family.levels.size()));
        const double inf = std::numeric_limits<double>::infinity();
        const double low = k == 0 ? -inf : family.levels[static_cast<std::size_t>(k) - 1];
        const double high =
            k == static_cast<std::int64_t>(family.levels.size()) ? inf : family.levels[static_cast<std::size_t>(k)];
        for (std::size_t r = 0; r < piece.ring_count(); ++r) {
            const RingView ring = piece.ring(r);
            EXPECT_EQ(*std::min_element(ring.begin(), ring.end()), ring[0]);
            for (const Point p : ring) {
                const Vec at = to_frame(family.frame, to_px(p));
                const double phi = at.y - profile_at(family.profile, at.x);
                ASSERT_GE(phi, low - slack);
                ASSERT_LE(phi, high + slack);
            }
        }
    }
    EXPECT_EQ(find_overlap(cut.pieces).value_or(""), "");
}

}  // namespace filigree::level_cut_shapes
