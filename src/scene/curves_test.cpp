#include "scene/curves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "base/elementary.h"
#include "base/test_cases.h"
#include "plane/verify.h"

namespace filigree {
namespace {

constexpr Colour ink{0, 0, 0, 255}, red{255, 0, 0, 255};
const Style outlined{red, ink, 2, Corner::mitre}, stroked{{}, ink, 2, Corner::round};
constexpr double tolerance = 0.01;

Path path_of(std::string_view data) {
    const Result<Path> path = parse_path_data(data);
    EXPECT_TRUE(path) << data;
    return path ? *path : Path{};
}
Drawing drawn(std::string_view data, const Style& style) {
    Drawing drawing;
    add_curve(drawing, path_of(data), style, Key{7}, tolerance);
    return drawing;
}
// The curves of the shapes, "" for one without.
std::vector<std::string> curves_of(const Drawing& drawing) {
    std::vector<std::string> curves;
    for (const DrawnShape& shape : drawing.shapes) {
        curves.push_back(has_curve(shape) ? to_path_data(drawing.curves[shape.curve]) : "");
    }
    return curves;
}
const Style& style_of(const Drawing& drawing, std::size_t shape) { return drawing.styles[drawing.shapes[shape].style]; }
double area_of(const Drawing& drawing, std::size_t shape) { return area(polygon_of(drawing, drawing.shapes[shape])); }

using Curves = std::vector<std::string>;

TEST(Curves, EachUnfilledSubpathIsALine) {
    const Drawing drawing = drawn("M0 0Q10 0 10 10M20 0A5 5 0 0 1 30 0A5 5 0 0 1 20 0Zl3 4", stroked);
    EXPECT_EQ(curves_of(drawing), (Curves{"M0 0Q10 0 10 10", "M20 0A5 5 0 0 1 30 0A5 5 0 0 1 20 0Z", "M20 0L23 4"}));
    ASSERT_EQ(drawing.styles.size(), 1U);
    EXPECT_TRUE(drawing.styles[0].is_open);
    ASSERT_EQ(drawing.geometry.size(), 1U);
    for (const DrawnShape& shape : drawing.shapes) {
        EXPECT_EQ(shape.key, Key{7});
        EXPECT_EQ(polygon_of(drawing, shape).ring_count(), 1U);
    }
    // One that closes comes back to where it began.
    const RingView circle = polygon_of(drawing, drawing.shapes[1]).outer();
    EXPECT_EQ(circle.front(), snap({20, 0}));
    EXPECT_EQ(circle.back(), circle.front());
    for (const Point p : circle) EXPECT_NEAR(length(to_px(p) - Vec{25, 0}), 5, tolerance);
    EXPECT_EQ(polygon_of(drawing, drawing.shapes[2]).outer().size(), 2U);
}

TEST(Curves, WhatHangsTogetherIsOneShape) {
    // A ring and, inside its hole, a disc; beside them a disc that is listed between.
    const std::string outer = "M0 0A50 50 0 0 1 100 0A50 50 0 0 1 0 0Z";
    const std::string hole = "M20 0A30 30 0 0 1 80 0A30 30 0 0 1 20 0Z";  // the same way round
    const std::string inner = "M40 0A10 10 0 0 0 60 0A10 10 0 0 0 40 0Z";
    const std::string beside = "M200 0C200 50 250 50 250 0Z";
    const Drawing drawing = drawn(outer + beside + inner + hole, outlined);
    const double pi = elementary::pi;
    Curves expected;
    for (std::size_t s = 0; s < drawing.shapes.size(); ++s) {
        EXPECT_EQ(style_of(drawing, s), outlined);
        EXPECT_FALSE(find_flaw(polygon_of(drawing, drawing.shapes[s])));
        const std::string curve = curves_of(drawing)[s];
        expected.push_back(curve);
        if (curve == outer + hole) {
            EXPECT_NEAR(area_of(drawing, s), pi * (2500 - 900), 5);
        } else if (curve == inner) {
            EXPECT_NEAR(area_of(drawing, s), pi * 100, 1);
        } else {
            EXPECT_EQ(curve, beside);
        }
    }
    EXPECT_EQ(expected.size(), 3U);
}

TEST(Curves, WhatDoesNotCloseIsNotFilled) {
    const Drawing drawing = drawn("M0 0C5 5 10 5 10 0M0 20C5 25 10 25 10 20Z", outlined);
    EXPECT_EQ(curves_of(drawing), (Curves{"M0 20C5 25 10 25 10 20Z", "M0 0C5 5 10 5 10 0"}));
    EXPECT_EQ(style_of(drawing, 0), outlined);
    EXPECT_TRUE(style_of(drawing, 1).is_open);
    // Neither has anything to fill.
    const Style filled{red, {}, 1, Corner::round};
    EXPECT_TRUE(drawn("M0 0C5 5 10 5 10 0M0 0L5 5Z", filled).shapes.empty());
    EXPECT_EQ(curves_of(drawn("M0 0L5 5Z", outlined)), (Curves{"M0 0L5 5Z"}));
}

TEST(Curves, WhereSubpathsCrossPolygonsAreFilledAndLinesDrawn) {
    const std::string eight = "M0 0C60 40 60-40 0 20C-40 40-40-40 0 0Z";
    const Drawing drawing = drawn(eight, outlined);
    const Curves curves = curves_of(drawing);
    ASSERT_GE(curves.size(), 3U);
    double sum = 0;
    for (std::size_t s = 0; s + 1 < curves.size(); ++s) {
        EXPECT_EQ(curves[s], "");
        EXPECT_EQ(style_of(drawing, s), (Style{red, {}, 2, Corner::mitre}));
        EXPECT_FALSE(find_flaw(polygon_of(drawing, drawing.shapes[s])));
        sum += area_of(drawing, s);
    }
    EXPECT_GT(sum, 100);
    EXPECT_EQ(curves.back(), eight);
    EXPECT_TRUE(style_of(drawing, curves.size() - 1).is_open);
    // By the even-odd rule, what is drawn twice holds nothing.
    const std::string square = "M0 0L9 0L9 9L0 9Z";
    EXPECT_EQ(curves_of(drawn(square + square, outlined)), (Curves{square, square}));
    EXPECT_TRUE(style_of(drawn(square + square, outlined), 0).is_open);
}

TEST(Curves, WhatCannotBeDrawnIsLeftOut) {
    EXPECT_TRUE(drawn("M0 0M5 5L5 5M1 1L1.000000001 1", stroked).shapes.empty());
    EXPECT_TRUE(drawn("M0 0L1e12 0M0 0Q1e300 0 1e11 5", stroked).shapes.empty());
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Drawing drawing;
    add_curve(drawing, {{Verb::move, Verb::line}, {{0, 0}, {nan, 0}}}, stroked, Key{1}, tolerance);
    add_curve(drawing, {{Verb::move, Verb::line}, {{0, 0}}}, stroked, Key{1}, tolerance);
    EXPECT_TRUE(drawing.shapes.empty());
    // A radius off the plane: the polygon speaks.
    add_curve(drawing, path_of("M0 0A3e9 3e9 0 0 1 100 0"), stroked, Key{1}, tolerance);
    EXPECT_EQ(curves_of(drawing), (Curves{""}));
    // Drawing without a move starts at the origin.
    Drawing other;
    add_curve(other, {{Verb::line}, {{4, 3}}}, stroked, Key{1}, tolerance);
    EXPECT_EQ(curves_of(other), (Curves{"M0 0L4 3"}));
}

TEST(Curves, StylesAreKeptOnce) {
    Drawing drawing;
    for (int i = 0; i < 4; ++i) {
        add_curve(drawing, path_of("M0 0L9 0L9 9Z"), outlined, Key{1}, tolerance);
        add_curve(drawing, path_of("M0 0L9 0L9 9Z"), stroked, Key{1}, tolerance);
    }
    EXPECT_EQ(drawing.styles.size(), 2U);
    EXPECT_EQ(drawing.shapes.size(), 8U);
    EXPECT_EQ(drawing.curves.size(), 8U);
}

// Rings of wavy curves inside each other, in a random order and turning either way: every second one begins a shape.
TEST(Curves, NestedOutlinesAreFoundWhole) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(200); ++seed) {
        CaseRandom random(seed);
        const std::uint32_t count = 1 + random.below(5);
        std::vector<std::string> outlines;
        for (std::uint32_t i = 0; i < count; ++i) {
            const double radius = 10 + 20 * i, sign = random.coin() ? 1 : -1;
            Path path;
            const auto at = [&](double turn, double r) {
                const elementary::CosSin to = elementary::cos_sin_degrees(sign * turn);
                return Vec{r * to.cos, r * to.sin};
            };
            path.verbs.push_back(Verb::move);
            path.points.push_back(at(0, radius));
            for (int k = 1; k <= 6; ++k) {
                path.verbs.push_back(Verb::quadratic);
                path.points.push_back(at(60 * k - 30, radius * random.between(0.95, 1.25)));
                path.points.push_back(at(60 * k, radius));
            }
            path.verbs.push_back(Verb::close);
            outlines.insert(outlines.begin() + random.below(i + 1), to_path_data(path));
        }
        std::string all;
        for (const std::string& outline : outlines) all += outline;
        const Drawing drawing = drawn(all, outlined);
        ASSERT_EQ(drawing.shapes.size(), (count + 1) / 2) << "seed " << seed;
        std::size_t length = 0;
        for (std::size_t s = 0; s < drawing.shapes.size(); ++s) {
            const PolygonView polygon = polygon_of(drawing, drawing.shapes[s]);
            ASSERT_FALSE(find_flaw(polygon)) << "seed " << seed;
            ASSERT_TRUE(has_curve(drawing.shapes[s])) << "seed " << seed;
            const std::vector<Polyline> lines = flatten(drawing.curves[drawing.shapes[s].curve], tolerance);
            ASSERT_EQ(lines.size(), polygon.ring_count()) << "seed " << seed;
            length += curves_of(drawing)[s].size();
        }
        EXPECT_EQ(length, all.size()) << "seed " << seed;
    }
}

}  // namespace
}  // namespace filigree
