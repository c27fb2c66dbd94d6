#include "plane/scatter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/test_cases.h"
#include "plane/inset_test_shapes.h"
#include "plane/test_rings.h"

namespace filigree {
namespace {

Polygons rectangle(Vec min, Vec max) {
    return test_shapes::one_polygon({{snap(min), snap({max.x, min.y}), snap(max), snap({min.x, max.y})}});
}

std::vector<ScatteredPoint> scattered(const Polygons& region, double spacing, double clearance = 0,
                                      std::uint64_t seed = 1) {
    ScatterOptions options;
    options.spacing = spacing;
    options.clearance = clearance;
    options.seed = seed;
    return scatter(region[0], options);
}

double distance_to_boundary(PolygonView shape, Vec p) {
    double least = 1e300;
    for (std::size_t r = 0; r < shape.ring_count(); ++r) {
        const RingView ring = shape.ring(r);
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Vec a = to_px(ring[i]);
            const Vec ab = to_px(ring[(i + 1) % ring.size()]) - a;
            double t = dot(p - a, ab) / dot(ab, ab);
            t = t < 0 ? 0 : t > 1 ? 1 : t;
            least = std::min(least, length(p - (a + ab * t)));
        }
    }
    return least;
}

double distance_to_points(const std::vector<ScatteredPoint>& points, Vec p) {
    double least = 1e300;
    for (const ScatteredPoint& other : points) least = std::min(least, length(other.at - p));
    return least;
}

TEST(Scatter, KeepsSpacingAndClearanceAndLeavesNoGap) {
    const std::uint64_t count = case_count(300);
    for (std::uint64_t seed = 0; seed < count && !::testing::Test::HasFailure(); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        CaseRandom random(seed);
        const Polygons region = test_shapes::wobbly_shape(random, 100, random.whole(8, 80), 6);
        const double spacing = random.between(6, 60);
        const double clearance = random.whole(0, 2) == 0 ? 0 : random.between(0, 12);
        const std::vector<ScatteredPoint> points = scattered(region, spacing, clearance, seed);
        for (std::size_t i = 0; i < points.size(); ++i) {
            EXPECT_EQ(locate(region[0], snap(points[i].at)), 1);
            EXPECT_GE(distance_to_boundary(region[0], points[i].at), clearance);
            for (std::size_t j = 0; j < i; ++j) EXPECT_GE(length(points[i].at - points[j].at), spacing);
            EXPECT_TRUE(i == 0 || points[i - 1].cell < points[i].cell);
        }
        for (int probe = 0; probe < 300; ++probe) {
            const double x = random.between(-120, 120);
            const double y = random.between(-120, 120);
            if (locate(region[0], snap({x, y})) < 1) continue;
            if (distance_to_boundary(region[0], {x, y}) < clearance + 1e-3) continue;
            EXPECT_LT(distance_to_points(points, {x, y}), spacing * (1 + 1e-3)) << x << ", " << y << " is free";
        }
    }
}

TEST(Scatter, DiscsOfTheClearanceDoNotTouchTheBorder) {
    CaseRandom random(4);
    const Polygons region = test_shapes::wobbly_shape(random, 100, 90, 6);
    for (const double clearance : {0.001, 1.0, 7.5}) {
        const std::vector<ScatteredPoint> points = scattered(region, 5, clearance);
        EXPECT_GT(points.size(), 10U);
        for (const ScatteredPoint& point : points) EXPECT_GT(distance_to_boundary(region[0], point.at), clearance);
    }
}

TEST(Scatter, IsAsDenseAsRandomPointsGet) {
    // Random discs that let no other in cover some 0.547 of the plane.
    const Polygons region = rectangle({-500, -500}, {500, 500});
    const std::vector<ScatteredPoint> points = scattered(region, 5);
    const double covered = static_cast<double>(points.size()) * elementary::pi * 2.5 * 2.5 / area(region);
    EXPECT_NEAR(covered, 0.547, 0.01);
}

TEST(Scatter, DoesNotDependOnWhereRingsStart) {
    CaseRandom random(9);
    const Polygons region = test_shapes::wobbly_shape(random, 100, 60, 6);
    const Polygons turned = with_rings_turned(region);
    const auto a = scattered(region, 4, 1);
    const auto b = scattered(turned, 4, 1);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].at, b[i].at);
        EXPECT_EQ(a[i].cell, b[i].cell);
    }
}

TEST(Scatter, MovingAFarBorderChangesNothingHere) {
    const auto a = scattered(rectangle({0, 0}, {400, 400}), 5, 1, 77);
    const auto b = scattered(rectangle({0, -30}, {900, 400}), 5, 1, 77);
    const auto in_the_middle = [](const std::vector<ScatteredPoint>& points) {
        std::vector<ScatteredPoint> some;
        for (const ScatteredPoint& p : points) {
            if (p.at.x > 20 && p.at.x < 340 && p.at.y > 60 && p.at.y < 380) some.push_back(p);
        }
        return some;
    };
    const auto some_a = in_the_middle(a);
    const auto some_b = in_the_middle(b);
    ASSERT_GT(some_a.size(), 2000U);
    ASSERT_EQ(some_a.size(), some_b.size());
    for (std::size_t i = 0; i < some_a.size(); ++i) {
        EXPECT_EQ(some_a[i].at, some_b[i].at);
        EXPECT_EQ(some_a[i].cell, some_b[i].cell);
    }
}

TEST(Scatter, AnotherSeedGivesOtherPoints) {
    const Polygons region = rectangle({0, 0}, {100, 100});
    const auto a = scattered(region, 5, 0, 1);
    const auto b = scattered(region, 5, 0, 2);
    std::size_t same = 0;
    for (const ScatteredPoint& p : a) same += distance_to_points(b, p.at) < 1e-9;
    EXPECT_EQ(same, 0U);
    const auto again = scattered(region, 5, 0, 1);
    ASSERT_EQ(again.size(), a.size());
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(again[i].at, a[i].at);
}

TEST(Scatter, FindsRoomInSmallAndThinRegions) {
    EXPECT_EQ(scattered(rectangle({3, 4}, {5, 6}), 1e9).size(), 1U);
    EXPECT_EQ(scattered(rectangle({3, 4}, {5, 6}), 1e300).size(), 1U);
    EXPECT_EQ(scattered(rectangle({3, 4}, {5, 6}), 10, 0.999).size(), 1U);
    EXPECT_TRUE(scattered(rectangle({3, 4}, {5, 6}), 10, 1.0).empty());
    const auto line = scattered(rectangle({0, 0}, {1000, 0.01}), 10);
    EXPECT_GE(line.size(), 51U);  // gaps are below twice the spacing
    EXPECT_LE(line.size(), 101U);
}

TEST(Scatter, OddOptionsAreHarmless) {
    const Polygons region = rectangle({0, 0}, {10, 10});
    EXPECT_TRUE(scattered(region, 0).empty());
    EXPECT_TRUE(scattered(region, -1).empty());
    EXPECT_TRUE(scattered(region, std::nan("")).empty());
    EXPECT_TRUE(scattered(region, 1, 1e300).empty());
    EXPECT_TRUE(scattered(region, 1, std::numeric_limits<double>::infinity()).empty());
    EXPECT_FALSE(scattered(region, 1, std::nan("")).empty());
    EXPECT_FALSE(scattered(region, 1, -5).empty());
    EXPECT_TRUE(scatter(PolygonView{}, {}).empty());
}

TEST(Scatter, StopsAtTheLimit) {
    ScatterOptions options;
    options.limit = 1000;
    for (const double spacing : {1.0, 1e-3, 1e-12}) {
        options.spacing = spacing;
        EXPECT_EQ(scatter(rectangle({-0x1p20, -0x1p20}, {0x1p20, 0x1p20})[0], options).size(), 1000U);
        EXPECT_EQ(scatter(rectangle({0, 0}, {0x1p20, 0x1p-20})[0], options).size(), 1000U);
    }
    options.spacing = 1;
    options.limit = 0;
    EXPECT_TRUE(scatter(rectangle({0, 0}, {10, 10})[0], options).empty());
    options.limit = UINT64_MAX;
    EXPECT_FALSE(scatter(rectangle({0, 0}, {10, 10})[0], options).empty());
}

TEST(Scatter, RegionsOfThousandsOfHoles) {
    CaseRandom random(5);
    std::vector<std::vector<Point>> rings{{snap({0, 0}), snap({1000, 0}), snap({1000, 1000}), snap({0, 1000})}};
    for (int i = 0; i < 2500; ++i) {
        const Vec centre{20.0 * (i % 50) + 10, 20.0 * (i / 50) + 10};
        rings.push_back(test_shapes::wobbly_ring(random, centre, random.between(3, 8), 16, 0.1, 0));
    }
    const Polygons region = test_shapes::one_polygon(rings);
    const auto points = scattered(region, 4, 0.5);
    EXPECT_GT(points.size(), 10000U);
    for (std::size_t i = 0; i < points.size(); i += 500) {
        EXPECT_EQ(locate(region[0], snap(points[i].at)), 1);
        EXPECT_GT(distance_to_boundary(region[0], points[i].at), 0.5);
    }
}

}  // namespace
}  // namespace filigree
