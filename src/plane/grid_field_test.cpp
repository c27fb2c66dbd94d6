// Splines over grids, distances at their nodes, and level lines.
#include "plane/grid_field.h"

#include <gtest/gtest.h>

#include "plane/distance_field.h"
#include "plane/isolines.h"
#include "plane/outline_field.h"
#include "plane/streamline_test_shapes.h"
#include "plane/strip_field.h"

namespace filigree {
namespace {

using namespace test_shapes;

template <class F>
GridField field_of(const Grid& grid, const F& f) {
    std::vector<double> values;
    for (std::uint32_t row = 0; row < grid.rows; ++row) {
        for (std::uint32_t column = 0; column < grid.columns; ++column) values.push_back(f(grid.node(column, row)));
    }
    return spline_of(grid, values);
}

TEST(GridField, IsExactForLinearFunctions) {
    const GridField field = field_of(grid_over({40, 25}, 1.7, 3), [](Vec p) { return 3 + 0.4 * p.x - 1.1 * p.y; });
    CaseRandom random(1);
    for (int i = 0; i < 200; ++i) {
        const Vec p{random.between(-20, 20), random.between(-12, 12)};
        EXPECT_NEAR(field.at(p), 3 + 0.4 * p.x - 1.1 * p.y, 1e-12);
        EXPECT_NEAR(field.jet(p).gradient.x, 0.4, 1e-12);
        EXPECT_NEAR(field.jet(p).gradient.y, -1.1, 1e-12);
        EXPECT_EQ(field.jet(p).value, field.at(p));
    }
}

TEST(GridField, GradientIsThatOfTheValue) {
    const GridField field = field_of(grid_over({40, 40}, 2, 3), [](Vec p) { return 0.01 * p.x * p.x * p.y + p.y; });
    CaseRandom random(2);
    for (int i = 0; i < 200; ++i) {
        const Vec p{random.between(-18, 18), random.between(-18, 18)};
        constexpr double h = 1e-5;
        EXPECT_NEAR(field.jet(p).gradient.x, (field.at(p + Vec{h, 0}) - field.at(p - Vec{h, 0})) / (2 * h), 1e-5);
        EXPECT_NEAR(field.jet(p).gradient.y, (field.at(p + Vec{0, h}) - field.at(p - Vec{0, h})) / (2 * h), 1e-5);
    }
}

TEST(DistanceField, IsTheDistanceOfEachNode) {
    for (std::uint64_t seed = 0; seed < case_count(100); ++seed) {
        CaseRandom random(seed);
        const Polygons shape = random_region(random, 40);
        const std::vector<Edge> edges = edges_of(shape[0], {});
        const EdgeTree border(edges);
        const Grid grid = grid_over({120, 120}, 7.3, 2);
        const std::vector<double> distances = signed_distances(border, grid);
        for (std::uint32_t row = 0; row < grid.rows; ++row) {
            for (std::uint32_t column = 0; column < grid.columns; ++column) {
                const Vec p = grid.node(column, row);
                double least = 1e300;
                for (const Edge& edge : edges) least = std::min(least, squared_distance(edge, p));
                const double found = distances[grid.index(column, row)];
                ASSERT_NEAR(std::fabs(found), std::sqrt(least), 1e-9) << seed;
                if (least > 1e-9) {
                    ASSERT_EQ(found > 0, locate(shape[0], snap(p)) > 0) << seed;
                }
            }
        }
    }
}

TEST(Isolines, FollowTheLevelsWithoutTheGrid) {
    const GridField field = field_of(grid_over({100, 100}, 4, 3), [](Vec p) { return length(p); });
    const std::vector<double> levels{20, 30.5, 43};
    const std::vector<Isoline> lines = isolines(field, levels, 0.02);
    ASSERT_EQ(lines.size(), 3U);
    for (const Isoline& line : lines) {
        EXPECT_TRUE(line.line.closed);
        EXPECT_LT(line.line.points.size(), 250U);
        double turned = 0;
        for (std::size_t i = 0; i < line.line.points.size(); ++i) {
            const Vec a = line.line.points[i], b = line.line.points[(i + 1) % line.line.points.size()];
            EXPECT_NEAR(length(a), levels[line.level], 0.03);
            EXPECT_NEAR(length(0.5 * (a + b)), levels[line.level], 0.05);
            turned += cross(a, b);
        }
        EXPECT_LT(turned, 0);  // the higher side is on the right of the way
    }
}

TEST(Isolines, EndAtTheBorderOrClose) {
    for (std::uint64_t seed = 0; seed < case_count(200); ++seed) {
        CaseRandom random(seed);
        const Grid grid = grid_over({30, 30}, 1.9, 2);
        const GridField field = field_of(grid, [&](Vec) { return random.between(0, 10); });
        std::vector<double> levels;
        for (double level = random.between(0, 3); level < 10; level += random.between(0.05, 2)) levels.push_back(level);
        const Vec low = grid.node(1, 1), high = grid.node(grid.columns - 2, grid.rows - 2);
        for (const Isoline& line : isolines(field, levels, 0.001)) {
            for (const Vec p : line.line.points) ASSERT_NEAR(field.at(p), levels[line.level], 0.35) << seed;
            if (line.line.closed) continue;
            for (const Vec end : {line.line.points.front(), line.line.points.back()}) {
                const double inside =
                    std::min(std::min(end.x - low.x, high.x - end.x), std::min(end.y - low.y, high.y - end.y));
                ASSERT_NEAR(inside, 0, 1e-9) << seed;
            }
        }
    }
}

TEST(OutlineField, OfADiscIsItsDistance) {
    const Polygons disc = one_polygon({regular_ring({0, 0}, 60, 400)});
    const EdgeTree border(edges_of(disc[0], {}));
    const Grid grid = grid_over({120, 120}, 3, 3);
    const GridField field = outline_field(grid, signed_distances(border, grid), 18);
    for (double r = 6; r < 60; r += 3) EXPECT_NEAR(field.at({r * 0.6, r * 0.8}), 60 - r, 0.02 * (60 - r) + 0.1) << r;
}

TEST(OutlineField, KeepsCloseToUnitSlopeBesideStraightWalls) {
    const Polygons bar = rectangle(200, 60);
    const EdgeTree border(edges_of(bar[0], snap({100, 30})));
    const Grid grid = grid_over({200, 60}, 3, 3);
    const GridField field = outline_field(grid, signed_distances(border, grid), 18);
    for (double y = 0; y < 24; y += 2) EXPECT_NEAR(field.at({0, y - 30}), y, 0.12 * y + 0.1) << y;
}

TEST(StripField, OfARectangleIsItsLength) {
    const Polygons bar = rectangle(200, 60);
    const EdgeTree border(edges_of(bar[0], snap({100, 30})));
    const StripField field = strip_field(border, {200, 60}, 12000, 1);
    const double sign = field.along.at({50, 0}) > 0 ? 1 : -1;
    for (double x = -99; x < 100; x += 9) {
        for (double y = -29; y < 30; y += 7) EXPECT_NEAR(sign * field.along.at({x, y}), x, 0.3) << x << " " << y;
    }
    EXPECT_NEAR(field.low, -100, 0.6);
    EXPECT_NEAR(field.high, 100, 0.6);
}

TEST(StripField, LevelLinesOfARingGoFromWallToWall) {
    const Polygons ring = one_polygon({regular_ring({0, 0}, 60, 200), regular_ring({0, 0}, 30, 100)});
    const EdgeTree border(edges_of(ring[0], {}));
    const StripField field = strip_field(border, {120, 120}, area(ring[0]), 1);
    // Away from both ends the gradient runs round the ring.
    const Vec end = field.along.jet({0, 45}).gradient;
    EXPECT_LT(std::fabs(end.y), 0.2 * std::fabs(end.x));
}

}  // namespace
}  // namespace filigree
