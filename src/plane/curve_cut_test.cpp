#include "plane/curve_cut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "plane/level_cut_test_laws.h"
#include "plane/verify.h"

namespace filigree {
namespace {

using namespace level_cut_shapes;

Polygons square(double side = 100) { return polygon_of({{{0, 0}, {side, 0}, {side, side}, {0, side}}}); }
Polygons square_with_hole() {
    return polygon_of({{{0, 0}, {100, 0}, {100, 100}, {0, 100}}, {{40, 40}, {40, 60}, {60, 60}, {60, 40}}});
}
Polyline open(std::vector<Vec> points) { return {std::move(points), false}; }
Polyline closed(std::vector<Vec> points) { return {std::move(points), true}; }

std::vector<double> areas_of(const Polygons& pieces) {
    std::vector<double> areas;
    for (std::size_t i = 0; i < pieces.size(); ++i) areas.push_back(area(pieces[i]));
    return areas;
}

// The pieces, checked: clean, apart, conforming, their areas add up.
Polygons cut_checked(const Polygons& shape, const std::vector<Polyline>& curves) {
    const Polygons pieces = cut_by_curves(shape[0], curves);
    EXPECT_NEAR(area(pieces), area(shape), 1e-9 * area(shape));
    for (std::size_t i = 0; i < pieces.size(); ++i) EXPECT_EQ(find_flaw(pieces[i]).value_or(""), "") << "piece " << i;
    EXPECT_EQ(find_overlap(pieces).value_or(""), "");
    EXPECT_NEAR(unmatched_length(pieces), perimeter(shape[0]), 1e-9 * perimeter(shape[0]));
    return pieces;
}

TEST(CurveCut, NothingMeansOnePiece) {
    const Polygons shape = square_with_hole();
    const std::vector<std::vector<Polyline>> cases{
        {},
        {open({})},
        {open({{50, 20}})},
        {closed({{50, 20}, {50, 20}})},
        {open({{200, 0}, {200, 100}})},              // beside it
        {open({{-20, 20}, {30, 20}})},               // a loose end that crosses the border
        {open({{10, 20}, {30, 20}, {30, 80}})},      // inside
        {open({{-20, 10}, {10, -20}, {-20, -20}})},  // past a corner
        {closed({{45, 45}, {55, 45}, {55, 55}})},    // in the hole
    };
    for (const std::vector<Polyline>& curves : cases) EXPECT_EQ(cut_checked(shape, curves), shape);
}

TEST(CurveCut, AnEmptyShapeHasNoPieces) { EXPECT_TRUE(cut_by_curves({}, std::vector{open({{0, 0}, {1, 1}})}).empty()); }

TEST(CurveCut, WhatRunsAlongTheBorderLeavesNoTrace) {
    const Polygons shape = square_with_hole();
    EXPECT_EQ(cut_checked(shape, {closed({{0, 0}, {100, 0}, {100, 100}, {0, 100}})}), shape);
    EXPECT_EQ(cut_checked(shape, {open({{20, 0}, {70, 0}, {120, 0}})}), shape);
    EXPECT_EQ(cut_checked(shape, {open({{40, 45}, {40, 52}, {45, 52}})}), shape);
}

TEST(CurveCut, ALineMakesTwo) {
    const Polygons pieces = cut_checked(square(), {open({{-10, 30}, {110, 30}})});
    EXPECT_EQ(pieces, [] {
        Polygons expected = polygon_of({{{0, 0}, {100, 0}, {100, 30}, {0, 30}}});
        expected.add_all(polygon_of({{{0, 30}, {100, 30}, {100, 100}, {0, 100}}}));
        return expected;
    }());
}

TEST(CurveCut, ACurveMayEndOnTheBorderAndPassThroughVertices) {
    EXPECT_EQ(areas_of(cut_checked(square(), {open({{0, 0}, {100, 100}})})), (std::vector<double>{5000, 5000}));
    EXPECT_EQ(areas_of(cut_checked(square(), {open({{0, 30}, {50, 60}, {100, 30}})})),
              (std::vector<double>{4500, 5500}));
    EXPECT_EQ(cut_checked(square(), {open({{0, 30}, {50, 60}, {99, 30}})}), square());
    EXPECT_EQ(cut_checked(square_with_hole(), {open({{50, 50}, {50, -10}})}), square_with_hole());
    EXPECT_EQ(areas_of(cut_checked(square_with_hole(), {open({{50, 110}, {50, -10}})})),
              (std::vector<double>{4800, 4800}));
}

TEST(CurveCut, AClosedCurveInsideCutsOutADisc) {
    const Polyline ring = closed({{20, 20}, {30, 20}, {30, 30}, {20, 30}});
    const Polygons pieces = cut_checked(square(), {ring});
    ASSERT_EQ(areas_of(pieces), (std::vector<double>{9900, 100}));
    EXPECT_EQ(pieces[0].ring_count(), 2U);
    // With a tail, turned round, drawn as an open curve with both ends loose: all the same.
    EXPECT_EQ(cut_checked(square(), {closed({{30, 20}, {20, 20}, {20, 30}, {30, 30}})}), pieces);
    EXPECT_EQ(cut_checked(square(), {open({{5, 20}, {30, 20}, {30, 30}, {20, 30}, {20, 5}})}), pieces);
    // Around the hole, and around a ring around it.
    const Polygons around = cut_checked(square_with_hole(), {closed({{30, 30}, {70, 30}, {70, 70}, {30, 70}}),
                                                             closed({{20, 20}, {80, 20}, {80, 80}, {20, 80}})});
    EXPECT_EQ(areas_of(around), (std::vector<double>{6400, 2000, 1200}));
    for (std::size_t i = 0; i < around.size(); ++i) EXPECT_EQ(around[i].ring_count(), 2U);
}

TEST(CurveCut, ABridgeBetweenTwoRingsCutsNothing) {
    const Polyline left = closed({{10, 40}, {30, 40}, {30, 60}, {10, 60}});
    const Polyline right = closed({{70, 40}, {90, 40}, {90, 60}, {70, 60}});
    const Polygons apart = cut_checked(square(), {left, right});
    ASSERT_EQ(areas_of(apart), (std::vector<double>{9200, 400, 400}));
    EXPECT_EQ(cut_checked(square(), {left, right, open({{20, 50}, {80, 50}})}).size(), 3U);
    EXPECT_EQ(cut_checked(square(), {left, right, open({{30, 40}, {70, 40}})}), apart);
    // A ring that hangs on the border by one line is still a disc.
    EXPECT_EQ(areas_of(cut_checked(square(), {left, open({{10, 40}, {0, 40}})})), (std::vector<double>{9600, 400}));
}

TEST(CurveCut, CurvesMayCrossEachOtherAndThemselves) {
    EXPECT_EQ(areas_of(cut_checked(square(), {open({{50, -10}, {50, 110}}), open({{-10, 50}, {110, 50}})})),
              (std::vector<double>{2500, 2500, 2500, 2500}));
    // A loop whose ends go out through two borders.
    EXPECT_EQ(areas_of(cut_checked(square(), {open({{-10, 20}, {80, 20}, {80, 50}, {20, 50}, {20, -10}})})),
              (std::vector<double>{400, 7800, 1800}));
    // A figure of eight: two discs in a square with two holes that touch.
    const Polygons eight = cut_checked(square(), {closed({{20, 20}, {80, 80}, {80, 20}, {20, 80}})});
    ASSERT_EQ(areas_of(eight), (std::vector<double>{8200, 900, 900}));
    EXPECT_EQ(eight[0].ring_count(), 3U);
}

TEST(CurveCut, DuplicatedCurvesCutOnce) {
    const Polyline line = open({{-10, 30}, {45, 70}, {110, 30}}), back = open({{110, 30}, {45, 70}, {-10, 30}});
    const Polygons once = cut_checked(square(), {line});
    EXPECT_EQ(once.size(), 2U);
    EXPECT_EQ(cut_checked(square(), {line, line, back}), once);
    // There and back again.
    EXPECT_EQ(cut_checked(square(), {open({{-10, 30}, {45, 70}, {110, 30}, {45, 70}, {-10, 30}})}), once);
}

TEST(CurveCut, CurvesOffThePlaneAreLeftOut) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    const Polyline line = open({{-10, 30}, {110, 30}});
    for (const double bad : {nan, inf, -inf, 0x1p31, -1e300}) {
        EXPECT_EQ(cut_checked(square(), {open({{-10, 50}, {50, bad}, {110, 50}}), open({{bad, 50}, {110, 50}})}),
                  square());
        EXPECT_EQ(cut_checked(square(), {closed({{-10, 50}, {50, bad}, {110, 50}}), line}).size(), 2U);
    }
    // As far as the plane goes.
    EXPECT_EQ(cut_checked(square(), {open({{-0x1p30, 30}, {0x1p30, 30}})}), cut_checked(square(), {line}));
}

TEST(CurveCut, NeedlesComeOutClean) {
    // Lines through one point of the border at ever smaller angles, and needles beside the border.
    for (double rise = 1e-9; rise < 10; rise *= 7) {
        const Polygons pieces = cut_checked(square(), {open({{0, 0}, {100, rise}}), open({{0, rise}, {100, 0}}),
                                                       open({{0, 100 - rise}, {120, 100 - rise}})});
        EXPECT_GE(pieces.size(), 1U);
    }
    // Many lines through one point off the grid.
    std::vector<Polyline> fan;
    for (int i = 0; i < 60; ++i) {
        const Vec d = turn({200, 0}, 3 * i + 0.123);
        fan.push_back(open({Vec{50.1, 49.7} - d, Vec{50.1, 49.7} + d}));
    }
    EXPECT_GE(cut_checked(square(), fan).size(), 120U);
}

TEST(CurveCut, HolesMayTouchTheBorder) {
    const Polygons touching = polygon_of({{{0, 0}, {100, 0}, {100, 100}, {0, 100}}, {{0, 50}, {50, 75}, {50, 25}}});
    EXPECT_EQ(areas_of(cut_checked(touching, {open({{50, 50}, {120, 50}})})), (std::vector<double>{4375, 4375}));
    EXPECT_EQ(areas_of(cut_checked(touching, {open({{0, 50}, {50, 50}})})), (std::vector<double>{8750}));
    EXPECT_EQ(areas_of(cut_checked(touching, {open({{50, 75}, {100, 75}}), open({{-9, 50}, {100, 50}})})),
              (std::vector<double>{4375, 3125, 1250}));
}

}  // namespace
}  // namespace filigree
