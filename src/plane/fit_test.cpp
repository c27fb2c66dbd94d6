#include "plane/fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/test_cases.h"
#include "plane/inset_test_shapes.h"
#include "plane/transform.h"

namespace filigree {
namespace {

Motif random_motif(CaseRandom& random) {
    switch (random.below(5)) {
        case 0:
            return disc_motif(16);
        case 1:
            return square_motif();
        case 2:
            return dash_motif(random.between(0.1, 0.5), 8);
        case 3: {
            Polyline star{{}, true};
            for (int i = 0; i < 10; ++i) star.points.push_back((i % 2 == 0 ? 20.0 : 7.0) * unit_at_degrees(36.0 * i));
            return drawn_motif({star}, FillRule::nonzero, 1e-3);
        }
        default:  // a C and a dot in its middle
            return drawn_motif({{{{0, 0}, {10, 0}, {10, 2}, {2, 2}, {2, 8}, {10, 8}, {10, 10}, {0, 10}}, true},
                                {{{5, 4}, {7, 4}, {7, 6}, {5, 6}}, true}},
                               FillRule::nonzero, 1e-3);
    }
}

// Every pair of edges, every corner: nothing shared with what is checked.
bool meet(const Polygons& a, const Polygons& b) {
    const auto edges = [](const Polygons& polygons) {
        std::vector<std::pair<Point, Point>> all;
        std::uint32_t first = 0;
        for (const std::uint32_t end : polygons.ring_ends) {
            for (std::uint32_t i = first; i < end; ++i) {
                all.emplace_back(polygons.points[i], polygons.points[i + 1 < end ? i + 1 : first]);
            }
            first = end;
        }
        return all;
    };
    for (const auto& [p, q] : edges(a)) {
        for (const auto& [r, s] : edges(b)) {
            if (orientation(p, q, r) * orientation(p, q, s) <= 0 && orientation(r, s, p) * orientation(r, s, q) <= 0) {
                return true;
            }
        }
    }
    const auto any_inside = [](const Polygons& points, const Polygons& polygons) {
        for (const Point p : points.points) {
            for (std::size_t i = 0; i < polygons.size(); ++i) {
                if (locate(polygons[i], p) >= 0) return true;
            }
        }
        return false;
    };
    return any_inside(a, b) || any_inside(b, a);
}

TEST(Fit, NothingOverlapsAndAllLiesInside) {
    const std::uint64_t count = case_count(150);
    std::size_t left = 0, shrunk = 0, dropped = 0;
    for (std::uint64_t seed = 0; seed < count && !::testing::Test::HasFailure(); ++seed) {
        SCOPED_TRACE(seed);
        CaseRandom random(seed);
        const Polygons region = test_shapes::wobbly_shape(random, 60, random.whole(8, 40), 5);
        const EdgeTree border(edges_of(region[0], Point{0, 0}));
        const Motif motif = random_motif(random);
        const double largest = random.between(4, 20);
        std::vector<Pose> poses;
        while (poses.size() < 30) {
            const Vec at{random.between(-80, 80), random.between(-80, 80)};
            if (locate(region[0], snap(at)) != 1) continue;
            poses.push_back({at, unit_at_degrees(random.between(0, 360)), largest * random.between(0.5, 1)});
        }
        const std::vector<Pose> before = poses;
        FitOptions options;
        options.border_counts = random.below(4) > 0;
        options.border_least = random.coin() ? 0.5 : 0;
        fit(poses, motif, border, options);
        std::vector<Polygons> objects;
        for (std::size_t i = 0; i < poses.size(); ++i) {
            EXPECT_LE(poses[i].radius, before[i].radius);
            EXPECT_EQ(poses[i].at, before[i].at);
            left += poses[i].radius > 0;
            dropped += poses[i].radius == 0;
            shrunk += poses[i].radius > 0 && poses[i].radius < before[i].radius;
            objects.emplace_back();
            if (poses[i].radius > 0) append(objects.back(), motif, poses[i]);
        }
        for (std::size_t i = 0; i < objects.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(meet(objects[i], objects[j])) << i << " " << j;
            if (!options.border_counts) continue;
            for (std::size_t r = 0; r < region[0].ring_count(); ++r) {
                Polygons ring;
                ring.add_ring(region[0].ring(r));
                for (const Point p : objects[i].points) EXPECT_EQ(locate(region[0], p), 1);
                for (const Point p : ring.points) {
                    for (std::size_t k = 0; k < objects[i].size(); ++k) EXPECT_EQ(locate(objects[i][k], p), -1);
                }
            }
        }
    }
    EXPECT_GT(left, 10 * count);
    EXPECT_GT(shrunk, 5 * count);
    EXPECT_GT(dropped, count / 10);
}

TEST(Fit, DiscsThatHaveRoomKeepTheirSizeAndOthersTakeAllThereIs) {
    const Polygons region =
        test_shapes::one_polygon({{snap({0, 0}), snap({100, 0}), snap({100, 100}), snap({0, 100})}});
    const EdgeTree border(edges_of(region[0], Point{0, 0}));
    std::vector<Pose> poses{{{20, 50}, {1, 0}, 10},
                            {{50, 50}, {1, 0}, 10},
                            {{62, 50}, {1, 0}, 10},
                            {{93, 50}, {1, 0}, 10},
                            {{50, 96}, {1, 0}, 10}};
    FitOptions options;
    options.gap = options.border_gap = 0.5;
    fit(poses, disc_motif(12), border, options);
    EXPECT_EQ(poses[0].radius, 10);
    EXPECT_NEAR(poses[1].radius + poses[2].radius, 11.5, 1e-6);
    EXPECT_NEAR(poses[3].radius, 6.5, 1e-6);
    EXPECT_EQ(poses[4].radius, 0);  // it would have to be smaller than half
}

TEST(Fit, LongMotifsMayLieSideBySide) {
    const Polygons region =
        test_shapes::one_polygon({{snap({0, 0}), snap({100, 0}), snap({100, 100}), snap({0, 100})}});
    const EdgeTree border(edges_of(region[0], Point{0, 0}));
    std::vector<Pose> poses{{{50, 50}, {1, 0}, 20}, {{50, 58.1}, {1, 0}, 20}, {{50, 4.5}, {1, 0}, 20}};
    fit(poses, dash_motif(0.2, 8), border, {});
    for (const Pose& pose : poses) EXPECT_EQ(pose.radius, 20);
    poses[1].direction = {0, 1};
    fit(poses, dash_motif(0.2, 8), border, {});
    EXPECT_LT(poses[1].radius, 20);
    EXPECT_GT(poses[1].radius, 5);
}

TEST(Fit, AHoleOfTheRegionInsideAnObjectCounts) {
    const Polygons region = test_shapes::one_polygon({{snap({0, 0}), snap({100, 0}), snap({100, 100}), snap({0, 100})},
                                                      {snap({54, 49}), snap({55, 49}), snap({55, 51})}});
    const EdgeTree border(edges_of(region[0], Point{0, 0}));
    for (const Motif& motif : {square_motif(), disc_motif(12)}) {
        std::vector<Pose> poses{{{50, 50}, {1, 0}, 20}};
        FitOptions options;
        options.border_least = 0;
        fit(poses, motif, border, options);
        EXPECT_LT(poses[0].radius, 4 * 1.42);
        EXPECT_GT(poses[0].radius, 3.9);
    }
}

}  // namespace
}  // namespace filigree
