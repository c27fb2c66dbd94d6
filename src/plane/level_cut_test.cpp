#include "plane/level_cut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/test_cases.h"
#include "plane/level_cut_test_laws.h"

namespace filigree {
namespace {

using namespace level_cut_shapes;

double strip_area(const LevelCut& cut, std::int32_t strip) {
    double sum = 0;
    for (std::size_t i = 0; i < cut.pieces.size(); ++i) sum += cut.strips[i] == strip ? area(cut.pieces[i]) : 0;
    return sum;
}

// ---- closed forms ----

TEST(LevelCut, NothingFromNothing) {
    EXPECT_TRUE(cut(PolygonView{}, lines(0, {0})).pieces.empty());
    EXPECT_EQ(level_range(PolygonView{}, {}, {}).high, 0);
    Polygons flat;  // fewer than three distinct points
    flat.points = {{0, 0}, {0, 0}, {5, 5}, {5, 5}};
    flat.end_ring();
    flat.end_polygon();
    EXPECT_TRUE(cut(flat[0], lines(0, {0})).pieces.empty());
}

TEST(LevelCut, LevelsOutsideTheShapeLeaveItWhole) {
    const Polygons square =
        polygon_of({{{0, 0}, {100, 0}, {100, 100}, {0, 100}}, {{10, 10}, {10, 20}, {20, 20}, {20, 10}}});
    for (const std::vector<double>& levels : {std::vector<double>{}, {-1}, {-3, -2, 0}, {100, 101}, {-5, 105}}) {
        const LevelCut result = cut(square[0], lines(0, levels));
        ASSERT_EQ(result.pieces, square);
        EXPECT_EQ(result.strips[0],
                  std::count_if(levels.begin(), levels.end(), [](double level) { return level <= 0; }));
    }
}

TEST(LevelCut, CornersAlongALevelStay) {
    // Neighbours below and above have them, too.
    const Polygons square =
        polygon_of({{{0, 0}, {30, 0}, {70, 0}, {100, 0}, {100, 100}, {60, 100}, {50, 100}, {0, 100}}});
    EXPECT_EQ(cut(square[0], lines(0, {0, 100})).pieces, square);
    EXPECT_EQ(cut(square[0], lines(180, {0, -100})).pieces, square);
    const LevelCut halves = cut(square[0], lines(0, {0, 50, 100}));
    ASSERT_EQ(halves.strips, (std::vector<std::int32_t>{1, 2}));
    EXPECT_EQ(halves.pieces[0].point_count(), 6u);
    EXPECT_EQ(halves.pieces[1].point_count(), 6u);
}

TEST(LevelCut, SquareIntoStrips) {
    const Polygons square = polygon_of({{{0, 0}, {100, 0}, {100, 100}, {0, 100}}});
    LevelFamily family = lines(0, {10, 30, 60});
    family.first_strip = -1;
    const LevelCut result = cut(square[0], family);
    ASSERT_EQ(result.strips, (std::vector<std::int32_t>{-1, 0, 1, 2}));
    const Polygons expected = polygon_of({{{0, 10}, {100, 10}, {100, 30}, {0, 30}}});
    EXPECT_EQ(area(result.pieces[0]), 1000);
    EXPECT_EQ(area(result.pieces[1]), 2000);
    EXPECT_EQ(area(result.pieces[2]), 3000);
    EXPECT_EQ(area(result.pieces[3]), 4000);
    EXPECT_TRUE(std::ranges::equal(result.pieces[1].outer(), expected[0].outer()));
}

TEST(LevelCut, TriangleStripsGrowLinearly) {
    const Polygons triangle = polygon_of({{{-100, 100}, {0, 0}, {100, 100}}});
    const LevelCut result = cut(triangle[0], lines(0, {10, 20, 30, 40, 50, 60, 70, 80, 90}));
    ASSERT_EQ(result.pieces.size(), 10u);
    for (std::int32_t k = 0; k < 10; ++k) EXPECT_NEAR(strip_area(result, k), 100.0 * (2 * k + 1), 1e-6);
}

TEST(LevelCut, ZigzagThroughASquare) {
    const Polygons square = polygon_of({{{0, 0}, {80, 0}, {80, 80}, {0, 80}}});
    LevelFamily family = lines(0, {40});
    family.profile = {10, {0, 10}};  // whole periods: half of 80 x 10 above the level line
    const LevelCut result = cut(square[0], family);
    ASSERT_EQ(result.pieces.size(), 2u);
    EXPECT_EQ(area(result.pieces[0]), 80 * 40 + 400);
    EXPECT_EQ(area(result.pieces[1]), 80 * 40 - 400);
    EXPECT_EQ(result.pieces[0].point_count(), 4u + 7u);
    expect_partition(square, family, result);
}

TEST(LevelCut, ArmsOfACombComeLeftToRight) {
    std::vector<Vec> comb{{0, 0}, {90, 0}};
    for (int tooth = 4; tooth >= 0; --tooth) {
        const double x = 20.0 * tooth;
        comb.push_back({x + 10, 50});
        comb.push_back({x, 50});
        if (tooth > 0) {
            comb.push_back({x, 10});
            comb.push_back({x - 10, 10});
        }
    }
    comb[1] = {90, 0};
    const Polygons shape = polygon_of({comb});
    const LevelCut result = cut(shape[0], lines(0, {10, 30}));
    ASSERT_EQ(result.strips, (std::vector<std::int32_t>{0, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2}));
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(bounds(result.pieces[1 + i]).min.x, snap({20.0 * static_cast<double>(i), 0}).x);
        EXPECT_EQ(area(result.pieces[1 + i]), 200);
    }
    // The notches' bottoms lie on the level: they are corners of the lowest piece.
    EXPECT_EQ(result.pieces[0].point_count(), 2u + 2 * 5);
    expect_partition(shape, lines(0, {10, 30}), result);
}

TEST(LevelCut, LevelsWithinTheToleranceAreOne) {
    const Polygons square = polygon_of({{{0, 0}, {100, 0}, {100, 100}, {0, 100}}});
    const LevelCut result = cut(square[0], lines(0, {-1e-7, 50, 50 + 1e-7, 50 + 2e-7, 100 - 1e-7, 100}));
    ASSERT_EQ(result.strips, (std::vector<std::int32_t>{1, 4}));
    EXPECT_EQ(area(result.pieces[0]), 5000);
    EXPECT_EQ(area(result.pieces[1]), 5000);
}

TEST(LevelCut, HolesGoToTheFaceAroundThem) {
    // A ring-shaped strip: two legs joined above and below, with a hole in either leg and one crossed.
    const Polygons shape = polygon_of({{{0, 0}, {100, 0}, {100, 100}, {0, 100}},
                                       {{30, 10}, {30, 90}, {70, 90}, {70, 10}},
                                       {{10, 45}, {10, 55}, {20, 55}, {20, 45}},
                                       {{80, 45}, {80, 55}, {90, 55}, {90, 45}},
                                       {{5, 15}, {5, 25}, {10, 25}, {10, 15}}});
    const LevelFamily family = lines(0, {20, 80});
    const LevelCut result = cut(shape[0], family);
    ASSERT_EQ(result.strips, (std::vector<std::int32_t>{0, 1, 1, 2}));
    for (const std::size_t leg : {1, 2}) {
        ASSERT_EQ(result.pieces[leg].ring_count(), 2u);
        EXPECT_EQ(area(result.pieces[leg]), 30 * 60 - 100 - (leg == 1 ? 25 : 0));
    }
    expect_partition(shape, family, result);
}

TEST(LevelCut, HolesOfManyFacesInOneStrip) {
    // Slanted teeth, whose ranges of u overlap, each with two holes in the strip that all of them share.
    Outline comb{{0, 0}, {1200, 0}};
    const int teeth = 60;
    for (int i = teeth - 1; i >= 0; --i) {
        const double x = 20.0 * i;
        for (const Vec p : {Vec{x + 10, 10}, Vec{x + 110, 110}, Vec{x + 100, 110}, Vec{x, 10}}) comb.push_back(p);
    }
    std::vector<Outline> outlines{comb};
    for (int i = 0; i < teeth; ++i) {
        for (const double y : {40.0, 80.0}) {
            const Vec p{20.0 * i + y - 10 + 4, y};
            outlines.push_back({p, p + Vec{1, 2}, p + Vec{2, 0}});
        }
    }
    const Polygons shape = polygon_of(outlines);
    const LevelFamily family = lines(0, {20, 100});
    const LevelCut result = cut(shape[0], family);
    ASSERT_EQ(result.pieces.size(), 1u + 2 * teeth);
    for (std::size_t i = 1; i <= teeth; ++i) EXPECT_EQ(area(result.pieces[i]), 10 * 80 - 2 * 2) << i;
    expect_partition(shape, family, result);
    // Few enough faces for the short search, but with overlapping ranges.
    const Polygons two =
        polygon_of({{{0, 0}, {60, 0}, {160, 100}, {130, 100}, {50, 20}, {40, 20}, {120, 100}, {100, 100}},
                    {{60, 50}, {61, 52}, {62, 50}},
                    {{85, 50}, {86, 52}, {87, 50}}});
    const LevelFamily above = lines(0, {25});
    const LevelCut legs = cut(two[0], above);
    ASSERT_EQ(legs.pieces.size(), 3u);
    EXPECT_EQ(legs.pieces[1].ring_count(), 2u);
    EXPECT_EQ(legs.pieces[2].ring_count(), 2u);
    expect_partition(two, above, legs);
}

TEST(LevelCut, TooManySamplesOrPointsCutNothing) {
    const Polygons wide = polygon_of({{{0, 0}, {1e6, 0}, {1e6, 100}, {0, 100}}});
    LevelFamily family = lines(0, {50});
    family.profile = {0.125, {0, 1}};  // 8 million breakpoints across the shape
    EXPECT_EQ(cut(wide[0], family).pieces, wide);
    const LevelRange range = level_range(wide[0], family.frame, family.profile);
    EXPECT_EQ(range.low, -1);
    EXPECT_EQ(range.high, 100);
    // 400,000 breakpoints on each of 4,000 levels: 3.2 thousand million points.
    family.profile = {2.5, {0, 0.001}};
    family.levels.clear();
    for (int k = 0; k < 4000; ++k) family.levels.push_back(1 + 0.02 * k);
    EXPECT_EQ(cut(wide[0], family).pieces, wide);
}

TEST(LevelCut, ManyHolesInManyStrips) {
    // 90 x 90 holes, each within a strip or across a level, in a comb whose teeth share strips.
    std::vector<Outline> outlines{
        {{0, 0}, {910, 0}, {910, 910}, {460, 910}, {460, 455}, {450, 455}, {450, 910}, {0, 910}}};
    for (int x = 0; x < 90; ++x) {
        for (int y = 0; y < 90 && x != 45; ++y) {  // the column of the notch stays empty
            const Vec p{5 + 10.0 * x, 5 + 10.0 * y};
            outlines.push_back({p, p + Vec{0, 4}, p + Vec{4, 4}, p + Vec{4, 0}});
        }
    }
    const Polygons shape = polygon_of(outlines);
    LevelFamily family = lines(3, {});
    for (int k = 0; k < 100; ++k) family.levels.push_back(9.7 * k - 40);
    const LevelCut result = cut(shape[0], family);
    EXPECT_NEAR(area(result.pieces), area(shape), 1e-9 * area(shape));
    EXPECT_NEAR(unmatched_length(result.pieces), perimeter(shape[0]), 1e-6);
    std::size_t holes = 0;
    for (std::size_t i = 0; i < result.pieces.size(); ++i) {
        holes += result.pieces[i].ring_count() - 1;
        EXPECT_EQ(find_flaw(result.pieces[i]).value_or(""), "");
    }
    EXPECT_GT(holes, 3000u);
}

TEST(LevelCut, FarFromTheOrigin) {
    const Vec far{1e9, -1e9};
    const Polygons square = polygon_of({{far, far + Vec{100, 0}, far + Vec{100, 100}, far + Vec{0, 100}}});
    const LevelCut result = cut(square[0], lines(30, {-20, 0, 20}, far + Vec{50, 50}));
    ASSERT_EQ(result.pieces.size(), 4u);
    EXPECT_NEAR(area(result.pieces), 1e4, 1e-5);
    EXPECT_NEAR(strip_area(result, 1), strip_area(result, 2), 1e-5);
    EXPECT_EQ(find_overlap(result.pieces).value_or(""), "");
    // A frame far away from the shape is less exact, but never wrong.
    const LevelCut distant = cut(square[0], lines(30, {-1366025403.784438, -1366025390.0}));
    EXPECT_NEAR(area(distant.pieces), 1e4, 1e-5);
}

TEST(LevelCut, WhatIsNoFamilyCutsNothing) {
    const Polygons square = polygon_of({{{0, 0}, {100, 0}, {100, 100}, {0, 100}}});
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    std::vector<LevelFamily> families(12, lines(0, {50}));
    families[0].levels = {10, nan, 20};
    families[1].levels = {10, 10};
    families[2].levels = {30, 20, 10};
    families[3].frame.direction = {0, 0};
    families[4].frame.direction = {nan, 1};
    families[5].frame.origin = {inf, 0};
    families[6].profile = {0, {1, 2}};
    families[7].profile = {nan, {1, 2}};
    families[8].profile = {1, {1, inf}};
    families[9].profile = {-1, {1, 2}};
    families[10].profile = {1, {nan}};
    families[11].frame.direction = {1e300, 1e300};
    for (std::size_t i = 0; i < families.size(); ++i) {
        const LevelCut result = cut(square[0], families[i]);
        EXPECT_EQ(result.pieces, square) << i;
        const LevelRange range = level_range(square[0], families[i].frame, families[i].profile);
        EXPECT_TRUE(std::isfinite(range.low) && std::isfinite(range.high)) << i;
    }
}

// Rings of random points break every convention; the cut must end all the same, with pieces in order.
TEST(LevelCut, EndsOnGarbage) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed + 9000000);
        const double side = random.coin() ? 1 : 30;
        std::vector<Outline> outlines(static_cast<std::size_t>(random.whole(1, 4)));
        for (Outline& outline : outlines) {
            for (int i = random.whole(0, 40); i > 0; --i) {
                outline.push_back({side * random.whole(-3, 3), side * random.whole(-3, 3)});
            }
        }
        const Polygons shape = polygon_of(outlines);
        if (shape.points.empty()) continue;
        LevelFamily family = lines(45 * random.whole(0, 7), {-60, -30, -3, -2, -1, 0, 1, 2, 3, 30, 60});
        family.profile = random_profile(random);
        const LevelCut result = cut(shape[0], family);
        EXPECT_TRUE(std::is_sorted(result.strips.begin(), result.strips.end()));
        for (std::size_t i = 0; i < result.pieces.size(); ++i) EXPECT_GE(result.pieces[i].outer().size(), 3u);
        if (testing::Test::HasFailure()) FAIL() << "seed " << seed;
    }
}

TEST(LevelCut, HugeFamiliesCostNothingOutsideTheShape) {
    const Polygons square = polygon_of({{{0, 0}, {10, 0}, {10, 10}, {0, 10}}});
    LevelFamily family = lines(0, {});
    for (int k = -500000; k <= 500000; ++k) family.levels.push_back(2 * k + 1);
    family.first_strip = -500001;
    std::size_t pieces = 0;
    for (int i = 0; i < 20000; ++i) pieces += cut(square[0], family).pieces.size();
    EXPECT_EQ(pieces, 20000u * 6);
    EXPECT_EQ(cut(square[0], family).strips.front(), -1);
}

TEST(LevelCut, RangeOfStraightAndBentCurves) {
    const Polygons square = polygon_of({{{0, 0}, {100, 0}, {100, 100}, {0, 100}}});
    const LevelRange across = level_range(square[0], {{50, 50}, turn({1, 0}, 45)}, {});
    EXPECT_NEAR(across.high, 50 * std::sqrt(2), 1e-12);
    EXPECT_NEAR(across.low, -50 * std::sqrt(2), 1e-12);
    // The profile's peaks lie inside the square's edges, not at its corners.
    const LevelRange waves = level_range(square[0], {}, {30, {0, 7, 0, -4}});
    EXPECT_DOUBLE_EQ(waves.high, 104);
    EXPECT_DOUBLE_EQ(waves.low, -7);
}

// ---- degenerate inputs ----

class DegenerateCut : public testing::TestWithParam<double> {};  // degrees by which shape and lines are turned

void expect_degenerate(const std::vector<Outline>& outlines, double degrees, double whole) {
    const Polygons shape = polygon_of(outlines, degrees);
    const LevelFamily family = forty_strips(degrees);
    const LevelCut result = cut(shape[0], family);
    EXPECT_NEAR(area(result.pieces), whole, 1e-9 * whole + 1e-6);
    EXPECT_NEAR(area(result.pieces), area(shape), 1e-9 * whole);
    for (std::size_t i = 0; i < result.pieces.size(); ++i) EXPECT_GT(area(result.pieces[i]), 1e-6) << i;
    EXPECT_EQ(find_overlap(result.pieces).value_or(""), "");
    for (std::size_t i = 0; i < result.pieces.size(); ++i) EXPECT_EQ(find_flaw(result.pieces[i]).value_or(""), "") << i;
}

TEST_P(DegenerateCut, SquareWithEdgesOnLines) {
    expect_degenerate({{{0, 0}, {100, 0}, {100, 100}, {0, 100}}}, GetParam(), 1e4);
    expect_partition(
        polygon_of({{{0, 0}, {100, 0}, {100, 100}, {0, 100}}}, GetParam()), forty_strips(GetParam()),
        cut(polygon_of({{{0, 0}, {100, 0}, {100, 100}, {0, 100}}}, GetParam())[0], forty_strips(GetParam())));
}

TEST_P(DegenerateCut, CombWithEdgesOnLines) {
    const Outline comb{{0, 0},   {100, 0}, {100, 50}, {80, 50}, {80, 20}, {60, 20},
                       {60, 50}, {40, 50}, {40, 20},  {20, 20}, {20, 50}, {0, 50}};
    expect_degenerate({comb}, GetParam(), 5000 - 2 * 600);
    expect_partition(polygon_of({comb}, GetParam()), forty_strips(GetParam()),
                     cut(polygon_of({comb}, GetParam())[0], forty_strips(GetParam())));
}

TEST_P(DegenerateCut, DuplicateVertices) {
    expect_degenerate(
        {{{0, 0}, {0, 0}, {100, 0}, {100, 0}, {100, 0}, {100, 100}, {0, 100}, {0, 100}, {0, 50}, {0, 50}, {0, 0}}},
        GetParam(), 1e4);
}

TEST_P(DegenerateCut, JitterBelowTheTolerance) {
    CaseRandom random(5);
    Outline outline;
    const Vec corners[] = {{0, 0}, {100, 0}, {100, 100}, {0, 100}};
    for (std::size_t side = 0; side < 4; ++side) {
        for (int i = 0; i < 10; ++i) {
            const Vec p = corners[side] + (corners[(side + 1) % 4] - corners[side]) * (i / 10.0);
            outline.push_back(p + Vec{random.between(-1e-7, 1e-7), random.between(-1e-7, 1e-7)});
        }
    }
    const Polygons shape = polygon_of({outline}, GetParam());
    const LevelCut result = cut(shape[0], forty_strips(GetParam()));
    EXPECT_EQ(result.pieces.size(), 10u);  // no slivers along the sides
    expect_partition(shape, forty_strips(GetParam()), result);
}

TEST_P(DegenerateCut, SpikeOfNoWidth) {
    const Polygons shape =
        polygon_of({{{0, 0}, {100, 0}, {100, 100}, {50, 100}, {50, 150}, {50, 100}, {0, 100}}}, GetParam());
    const LevelCut result = cut(shape[0], forty_strips(GetParam()));
    EXPECT_NEAR(area(result.pieces), 1e4, 1e-5);
    EXPECT_NEAR(area(result.pieces), area(shape), 1e-5);
    EXPECT_EQ(result.pieces.size(), 10u);
}

TEST_P(DegenerateCut, HoleTouchesTheOuterRing) {
    expect_degenerate({{{0, 0}, {100, 0}, {100, 100}, {0, 100}}, {{0, 50}, {10, 65}, {20, 50}, {10, 35}}}, GetParam(),
                      1e4 - 300);
    expect_degenerate({{{0, 0}, {50, 0}, {100, 0}, {100, 100}, {0, 100}}, {{50, 0}, {35, 10}, {50, 20}, {65, 10}}},
                      GetParam(), 1e4 - 300);
    expect_degenerate({{{0, 0}, {100, 0}, {100, 100}, {0, 100}}, {{0, 0}, {10, 20}, {20, 10}}}, GetParam(), 1e4 - 150);
}

TEST_P(DegenerateCut, TouchesPinchNoPiece) {
    // A hole that hangs from a level by one corner, and one that stands on it, at the same point.
    const std::vector<Outline> outlines{{{0, 0}, {100, 0}, {100, 100}, {0, 100}},
                                        {{50, 50}, {55, 44}, {45, 44}},
                                        {{50, 50}, {45, 56}, {55, 56}},
                                        {{20, 50}, {25, 44}, {15, 44}}};
    const Polygons shape = polygon_of(outlines, GetParam());
    const LevelCut result = cut(shape[0], forty_strips(GetParam()));
    ASSERT_EQ(result.pieces.size(), 10u);
    EXPECT_EQ(result.pieces[4].ring_count(), 3u);
    EXPECT_EQ(result.pieces[5].ring_count(), 2u);
    for (std::size_t i = 0; i < 10; ++i) {
        for (std::size_t r = 0; r < result.pieces[i].ring_count(); ++r) {
            std::vector<Point> ring(result.pieces[i].ring(r).begin(), result.pieces[i].ring(r).end());
            std::sort(ring.begin(), ring.end());
            EXPECT_EQ(std::adjacent_find(ring.begin(), ring.end()), ring.end());
        }
    }
    expect_partition(shape, forty_strips(GetParam()), result);
}

INSTANTIATE_TEST_SUITE_P(Turned, DegenerateCut, testing::Values(0, 45, 5.729577951308232));

}  // namespace
}  // namespace filigree
