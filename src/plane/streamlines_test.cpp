#include "plane/streamlines.h"

#include <gtest/gtest.h>

#include "plane/boundary_field.h"
#include "plane/distance_field.h"
#include "plane/streamline_test_shapes.h"

namespace filigree {
namespace {

using namespace test_shapes;

TEST(BoundaryField, ReproducesLinearFunctionsInShapesWithHoles) {
    for (std::uint64_t seed = 0; seed < case_count(200); ++seed) {
        CaseRandom random(seed);
        const Polygons shape = random_region(random, 50);
        const BorderSamples border = sampled_border(shape[0], {}, 3);
        ASSERT_EQ(border.ring_ends.size(), shape[0].ring_count());
        std::vector<Vec> vectors;
        for (const Vec p : border.points) vectors.push_back({1 + 2 * p.x - p.y, 0.5 * p.y - 7});
        for (int i = 0; i < 20; ++i) {
            const Vec p{random.between(-60, 60), random.between(-60, 60)};
            if (locate(shape[0], snap(p)) <= 0) continue;
            const Vec value = mean_value(border, vectors, p);
            EXPECT_NEAR(value.x, 1 + 2 * p.x - p.y, 1e-6) << seed;
            EXPECT_NEAR(value.y, 0.5 * p.y - 7, 1e-6) << seed;
        }
        EXPECT_NEAR(length(mean_value(border, vectors, border.points[1]) - vectors[1]), 0, 1e-9);
        const Vec between = 0.5 * (border.points[1] + border.points[2]);
        EXPECT_NEAR(length(mean_value(border, vectors, between) - 0.5 * (vectors[1] + vectors[2])), 0, 1e-6);
    }
}

TEST(BoundaryField, SamplesDoNotDependOnWhereRingsStart) {
    const Polygons shape =
        one_polygon({regular_ring({0, 0}, 60, 40), regular_ring({20, 0}, 10, 12), regular_ring({-20, 0}, 9, 12)});
    Polygons turned;
    for (const std::size_t r : {0, 2, 1}) {
        std::vector<Point> ring(shape[0].ring(r).begin(), shape[0].ring(r).end());
        std::rotate(ring.begin(), ring.begin() + 5, ring.end());
        turned.add_ring(ring);
    }
    turned.end_polygon();
    EXPECT_EQ(sampled_border(shape[0], {}, 4).points, sampled_border(turned[0], {}, 4).points);
}

struct Traced {
    Polygons shape;
    GridField distances;
    std::vector<Polyline> lines;
};
Traced trace(CaseRandom& random, double separation, int kind) {
    Traced traced{random_region(random, 60), {}, {}};
    const Box box = bounds(traced.shape[0]);
    const Point origin{box.min.x + (box.max.x - box.min.x) / 2, box.min.y + (box.max.y - box.min.y) / 2};
    const EdgeTree border(edges_of(traced.shape[0], origin));
    const Grid grid = grid_over(to_px(box.max, box.min), 0.75 * separation, 4);
    const std::vector<double> distances = signed_distances(border, grid);
    traced.distances = spline_of(grid, distances);
    const BorderSamples samples = sampled_border(traced.shape[0], origin, separation);
    std::vector<Vec> vectors = samples.tangents;
    if (kind == 1) {
        for (Vec& v : vectors) v = {0.8, 0.6};
    } else if (kind == 2) {
        for (std::size_t i = 0; i < vectors.size(); ++i) vectors[i] = perpendicular(samples.points[i] - Vec{9, 4});
    }
    const DirectionField field = direction_field(samples, vectors, grid, distances);
    StreamlineOptions options;
    options.separation = separation;
    options.follows_border = kind == 0;
    traced.lines = streamlines([&](Vec p) { return field.at(p); }, traced.distances, {}, options);
    return traced;
}

// How far along its line each point is from the nearer end; closed lines have none.
std::vector<double> from_the_ends(const Polyline& line) {
    std::vector<double> ways(line.points.size(), 1e300);
    if (line.closed) return ways;
    double way = 0;
    for (std::size_t i = 0; i < ways.size(); ++i) {
        if (i > 0) way += length(line.points[i] - line.points[i - 1]);
        ways[i] = way;
    }
    for (double& own : ways) own = std::min(own, way - own);
    return ways;
}

TEST(Streamlines, KeepTheirDistanceAndLeaveNoGaps) {
    std::uint64_t pairs = 0, places = 0, wide = 0, lines = 0;
    for (std::uint64_t seed = 0; seed < case_count(150); ++seed) {
        SCOPED_TRACE(seed);
        CaseRandom random(seed);
        const double d = random.between(4, 12);
        const Traced traced = trace(random, d, static_cast<int>(seed % 3));
        lines += traced.lines.size();
        std::vector<std::vector<double>> ways;
        for (const Polyline& line : traced.lines) ways.push_back(from_the_ends(line));
        for (std::size_t a = 0; a < traced.lines.size(); ++a) {
            for (std::size_t b = 0; b < a; ++b) {
                for (std::size_t i = 0; i < ways[a].size(); ++i) {
                    if (ways[a][i] < 3 * d) continue;
                    for (std::size_t j = 0; j < ways[b].size(); ++j) {
                        if (ways[b][j] < 3 * d) continue;
                        ++pairs;
                        ASSERT_GT(length(traced.lines[a].points[i] - traced.lines[b].points[j]), 0.2 * d);
                    }
                }
            }
        }
        for (int i = 0; i < 60; ++i) {
            const Vec p{random.between(-60, 60), random.between(-60, 60)};
            if (traced.distances.at(p) < d) continue;
            ++places;
            double nearest = 1e300;
            for (const Polyline& line : traced.lines) {
                for (const Vec q : line.points) nearest = std::min(nearest, length(q - p));
            }
            wide += nearest > 1.5 * d;
        }
    }
    EXPECT_GT(lines, 500U);
    EXPECT_GT(pairs, 10000U);
    EXPECT_GT(places, 300U);
    RecordProperty("wide", static_cast<int>(wide));
    EXPECT_LT(static_cast<double>(wide), 0.03 * static_cast<double>(places));
}

TEST(Streamlines, AreComplete) {
    for (std::uint64_t seed = 0; seed < case_count(150); ++seed) {
        SCOPED_TRACE(seed);
        CaseRandom random(seed);
        const double d = random.between(4, 12);
        const Traced traced = trace(random, d, static_cast<int>(seed % 3));
        for (const Polyline& line : traced.lines) {
            if (line.closed) continue;
            for (const bool is_front : {true, false}) {
                const auto from_end = [&](std::size_t i) {
                    return line.points[is_front ? i : line.points.size() - 1 - i];
                };
                bool is_complete = false;  // it crosses the border, or ends on a point of another line
                for (std::size_t i = 0; i < 6 && i < line.points.size(); ++i) {
                    is_complete = is_complete || traced.distances.at(from_end(i)) < 0;
                }
                for (const Polyline& other : traced.lines) {
                    const auto own = &other == &line ? 2 : 1;  // a spiral may end on itself
                    is_complete =
                        is_complete || std::count(other.points.begin(), other.points.end(), from_end(0)) >= own;
                }
                EXPECT_TRUE(is_complete) << from_end(0).x << " " << from_end(0).y;
            }
        }
    }
}

TEST(Streamlines, AreTheSameEveryTime) {
    CaseRandom first(5), second(5);
    EXPECT_EQ(trace(first, 6, 0).lines, trace(second, 6, 0).lines);
}

TEST(Streamlines, OfARotationAreClosedCircles) {
    const Polygons disc = one_polygon({regular_ring({0, 0}, 80, 300)});
    const Grid grid = grid_over({160, 160}, 6, 4);
    const GridField distances = spline_of(grid, signed_distances(EdgeTree(edges_of(disc[0], {})), grid));
    StreamlineOptions options;
    options.separation = 8;
    options.follows_border = true;
    const std::vector<Polyline> lines = streamlines([](Vec p) { return perpendicular(p); }, distances, {}, options);
    EXPECT_GE(lines.size(), 8U);
    EXPECT_LE(lines.size(), 11U);
    for (const Polyline& line : lines) {
        EXPECT_TRUE(line.closed);
        const double radius = length(line.points.front());
        for (const Vec p : line.points) EXPECT_NEAR(length(p), radius, 0.15);
    }
}

}  // namespace
}  // namespace filigree
