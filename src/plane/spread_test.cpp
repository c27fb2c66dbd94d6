#include "plane/spread.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/test_cases.h"
#include "plane/edge_tree.h"
#include "plane/inset_test_shapes.h"
#include "plane/test_rings.h"

namespace filigree {
namespace {

Polygons rectangle(Vec min, Vec max) {
    return test_shapes::one_polygon({{snap(min), snap({max.x, min.y}), snap(max), snap({min.x, max.y})}});
}

SpreadOptions options_for(double spacing, std::uint64_t seed = 1) {
    SpreadOptions options;
    options.spacing = options.apart = spacing;
    options.clearance = 0.4 * spacing;
    options.least_clearance = 0.2 * spacing;
    options.seed = seed;
    return options;
}

double distance_to_others(const std::vector<SpreadPoint>& points, std::size_t i) {
    double least = 1e300;
    for (std::size_t j = 0; j < points.size(); ++j) {
        if (j != i) least = std::min(least, length(points[j].at - points[i].at));
    }
    return least;
}

struct Statistics {
    double mean = 0, deviation = 0;  // of the distances to the nearest neighbours
    double moment = 0;  // squared distance of a place from the nearest point, on an average, by the area of a point
};
Statistics of_distances(const Polygons& region, const std::vector<SpreadPoint>& points) {
    const auto count = static_cast<double>(points.size());
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double least = distance_to_others(points, i);
        sum += least;
        squares += least * least;
    }
    CaseRandom random(1);
    double moments = 0;
    int places = 0;
    for (; places < 4000;) {
        const Vec p{random.between(-200, 200), random.between(-200, 200)};
        if (locate(region[0], snap(p)) < 1) continue;
        double least = 1e300;
        for (const SpreadPoint& point : points) least = std::min(least, dot(point.at - p, point.at - p));
        moments += least;
        ++places;
    }
    const double mean = sum / count;
    return {mean, std::sqrt(std::max(squares / count - mean * mean, 0.0)), moments / places * count / area(region)};
}

TEST(Spread, PointsKeepApartAndInsideAndHaveKeys) {
    const std::uint64_t count = case_count(300);
    std::size_t points_in_all = 0, at_border = 0;
    for (std::uint64_t seed = 0; seed < count && !::testing::Test::HasFailure(); ++seed) {
        SCOPED_TRACE(seed);
        CaseRandom random(seed);
        const Polygons region = random.below(3) > 0
                                    ? test_shapes::wobbly_shape(random, 100, random.whole(8, 80), 6)
                                    : test_shapes::one_polygon({test_shapes::wild_ring(random, {3, 4}, 100, 16)});
        SpreadOptions options = options_for(random.between(4, 60), seed);
        if (random.coin()) options.clearance = options.least_clearance = 0;
        const std::vector<SpreadPoint> points = spread(region[0], options);
        const EdgeTree border(edges_of(region[0], Point{0, 0}));
        for (std::size_t i = 0; i < points.size(); ++i) {
            EXPECT_EQ(locate(region[0], snap(points[i].at)), 1);
            EXPECT_GE(distance_to_others(points, i), options.apart * (1 - 1e-9));
            EXPECT_TRUE(i == 0 || points[i - 1].cell < points[i].cell);
            ++points_in_all;
            const EdgeTree::Place place = border.place(points[i].at, 1e3, 1e3);
            at_border += place.distance < options.least_clearance;
        }
    }
    EXPECT_LE(at_border * 50, points_in_all);
}

TEST(Spread, LeavesNoRoomWhereAnotherWouldFitEasily) {
    CaseRandom random(8);
    const Polygons region = test_shapes::wobbly_shape(random, 100, 60, 4);
    const std::vector<SpreadPoint> points = spread(region[0], options_for(10));
    const EdgeTree border(edges_of(region[0], Point{0, 0}));
    for (int probe = 0; probe < 3000; ++probe) {
        const Vec p{random.between(-150, 150), random.between(-150, 150)};
        const EdgeTree::Place place = border.place(p, 1e3, 1e3);
        if (!place.is_inside || place.distance < 5) continue;
        double least = 1e300;
        for (const SpreadPoint& point : points) least = std::min(least, length(point.at - p));
        EXPECT_LT(least, 13) << p.x << ", " << p.y;
    }
}

TEST(Spread, RelaxingMakesDistancesEven) {
    CaseRandom random(5);
    const Polygons region = test_shapes::one_polygon({test_shapes::wobbly_ring(random, {10, 20}, 200, 400, 0.5, 0.02)});
    SpreadOptions options = options_for(10);
    const Statistics relaxed = of_distances(region, spread(region[0], options));
    options.rounds = 0;
    const Statistics thrown = of_distances(region, spread(region[0], options));
    EXPECT_GT(relaxed.mean, 10.7);
    EXPECT_LT(relaxed.mean, 12);
    EXPECT_LT(relaxed.deviation / relaxed.mean, thrown.deviation / thrown.mean);
    // A hexagonal lattice has 0.160, points thrown at random 0.318.
    EXPECT_LT(relaxed.moment, 0.174);
    EXPECT_GT(thrown.moment, 0.178);
}

TEST(Spread, LiesInTheMiddleOfBandsAndOfSmallRegions) {
    const std::vector<SpreadPoint> band = spread(rectangle({0, 0}, {400, 10})[0], options_for(15));
    EXPECT_GT(band.size(), 20U);
    for (const SpreadPoint& point : band) EXPECT_NEAR(point.at.y, 5, 0.8);
    const std::vector<SpreadPoint> one = spread(rectangle({10, 10}, {22, 20})[0], options_for(15));
    ASSERT_EQ(one.size(), 1U);
    EXPECT_NEAR(one[0].at.x, 16, 1e-9);
    EXPECT_NEAR(one[0].at.y, 15, 1e-9);
    EXPECT_EQ(spread(rectangle({3, 4}, {5, 6})[0], options_for(1e300)).size(), 0U);  // no room for the clearance
    SpreadOptions options = options_for(1e300);
    options.clearance = options.least_clearance = 0;
    EXPECT_EQ(spread(rectangle({3, 4}, {5, 6})[0], options).size(), 1U);
}

TEST(Spread, DoesNotDependOnWhereRingsStart) {
    const std::uint64_t count = case_count(40);
    for (std::uint64_t seed = 0; seed < count; ++seed) {
        CaseRandom random(seed);
        const Polygons region = test_shapes::wobbly_shape(random, 100, 60, 6);
        const Polygons turned = with_rings_turned(region);
        const auto a = spread(region[0], options_for(7, seed)), b = spread(turned[0], options_for(7, seed));
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t i = 0; i < a.size(); ++i) {
            EXPECT_EQ(a[i].at, b[i].at);
            EXPECT_EQ(a[i].cell, b[i].cell);
        }
    }
}

TEST(Spread, MovingAFarBorderChangesNothingHere) {
    const auto a = spread(rectangle({0, 0}, {400, 400})[0], options_for(5, 77));
    const auto b = spread(rectangle({0, -30}, {900, 400})[0], options_for(5, 77));
    const auto in_the_middle = [](const std::vector<SpreadPoint>& points) {
        std::vector<SpreadPoint> some;
        for (const SpreadPoint& p : points) {
            if (p.at.x > 5 && p.at.x < 300 && p.at.y > 100 && p.at.y < 395) some.push_back(p);
        }
        return some;
    };
    const auto some_a = in_the_middle(a), some_b = in_the_middle(b);
    ASSERT_GT(some_a.size(), 2000U);
    ASSERT_EQ(some_a.size(), some_b.size());
    for (std::size_t i = 0; i < some_a.size(); ++i) {
        EXPECT_EQ(some_a[i].at, some_b[i].at);
        EXPECT_EQ(some_a[i].cell, some_b[i].cell);
    }
}

TEST(Spread, ADensityDrawsPoints) {
    SpreadOptions options = options_for(4);
    options.apart = 1;
    options.clearance = options.least_clearance = 0;
    options.rounds = 4;
    const Polygons region = rectangle({0, 0}, {400, 200});
    const auto count_in = [&](const std::vector<SpreadPoint>& points, double low, double high) {
        return static_cast<double>(std::count_if(points.begin(), points.end(),
                                                 [&](const SpreadPoint& p) { return p.at.x >= low && p.at.x < high; }));
    };
    const double full = static_cast<double>(spread(region[0], options).size());
    options.density = [](Vec p) { return p.x < 200 ? 0.25 : 1.0; };
    const auto halves = spread(region[0], options);
    EXPECT_NEAR(count_in(halves, 0, 200) / full, 0.125, 0.02);
    EXPECT_NEAR(count_in(halves, 200, 400) / full, 0.5, 0.05);
    options.density = [](Vec p) { return p.x / 400; };
    const auto gradient = spread(region[0], options);
    for (double x = 100; x < 400; x += 100) {
        EXPECT_NEAR(count_in(gradient, x, x + 100) / (full / 4), (x + 50) / 400, 0.12) << x;
    }
    options.density = [](Vec) { return 0.0; };
    EXPECT_TRUE(spread(region[0], options).empty());
}

TEST(Spread, OddOptionsAreHarmless) {
    const Polygons region = rectangle({0, 0}, {10, 10});
    for (const double spacing : {0.0, -1.0, std::nan("")}) EXPECT_TRUE(spread(region[0], options_for(spacing)).empty());
    EXPECT_TRUE(spread(PolygonView{}, options_for(3)).empty());
    SpreadOptions options = options_for(3);
    options.limit = 0;
    EXPECT_TRUE(spread(region[0], options).empty());
    options.limit = 4;
    EXPECT_EQ(spread(region[0], options).size(), 4U);
    options = options_for(1e-9);
    options.limit = 100;  // far too many for a raster
    EXPECT_EQ(spread(region[0], options).size(), 100U);
    options = options_for(3);
    options.clearance = options.least_clearance = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(spread(region[0], options).empty());
    EXPECT_FALSE(spread(rectangle({0, 0}, {1000, 0.01})[0],
                        [] {
                            SpreadOptions thin = options_for(10);
                            thin.clearance = thin.least_clearance = 0;
                            return thin;
                        }())
                     .empty());
}

TEST(Spread, RegionsOfThousandsOfHoles) {
    CaseRandom random(5);
    std::vector<std::vector<Point>> rings{{snap({0, 0}), snap({1000, 0}), snap({1000, 1000}), snap({0, 1000})}};
    for (int i = 0; i < 2500; ++i) {
        const Vec centre{20.0 * (i % 50) + 10, 20.0 * (i / 50) + 10};
        rings.push_back(test_shapes::wobbly_ring(random, centre, random.between(3, 8), 16, 0.1, 0));
    }
    const Polygons region = test_shapes::one_polygon(rings);
    const auto points = spread(region[0], options_for(4));
    EXPECT_GT(points.size(), 10000U);
    for (std::size_t i = 0; i < points.size(); i += 500) EXPECT_EQ(locate(region[0], snap(points[i].at)), 1);
}

}  // namespace
}  // namespace filigree
