#include "plane/curve_families.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "plane/level_cut_test_laws.h"
#include "plane/verify.h"

namespace filigree {
namespace {

using namespace level_cut_shapes;

constexpr double fine = 0.001;

Polygons square() { return polygon_of({{{-100, -100}, {100, -100}, {100, 100}, {-100, 100}}}); }

FamilyCut cut_checked(const Polygons& shape, const CurveFamily& first, const CurveFamily* second = nullptr) {
    FamilyCut result = cut_by_families(shape[0], first, second);
    EXPECT_FALSE(result.too_large);
    EXPECT_NEAR(area(result.pieces), area(shape), 1e-9 * area(shape));
    EXPECT_NEAR(unmatched_length(result.pieces), perimeter(shape[0]), 1e-9 * perimeter(shape[0]));
    EXPECT_EQ(find_overlap(result.pieces).value_or(""), "");
    for (std::size_t i = 0; i < result.pieces.size(); ++i) EXPECT_EQ(find_flaw(result.pieces[i]).value_or(""), "");
    for (std::size_t i = 1; i < result.pieces.size(); ++i) {
        EXPECT_LE(std::pair(result.columns[i - 1], result.rows[i - 1]), std::pair(result.columns[i], result.rows[i]));
    }
    return result;
}

TEST(CurveFamilies, CirclesMakeNumberedRings) {
    const Circles circles{.centre = {0, 0}, .radii = {20, 50, 120}, .tolerance = fine};
    const FamilyCut rings = cut_checked(square(), circles);
    EXPECT_EQ(rings.columns, (std::vector<std::int32_t>{0, 1, 2, 3, 3, 3, 3}));
    EXPECT_NEAR(area(rings.pieces[0]), elementary::pi * 400, 1);
    EXPECT_NEAR(area(rings.pieces[1]), elementary::pi * 2100, 1);
    EXPECT_EQ(rings.pieces[1].ring_count(), 2U);
    // From outside, with the number of the strip inside the first circle.
    const FamilyCut arcs = cut_checked(square(), Circles{{-200, 0}, {150, 250}, 7, fine});
    EXPECT_EQ(arcs.columns, (std::vector<std::int32_t>{7, 8, 9}));
}

TEST(CurveFamilies, RaysMakeNumberedSectors) {
    const Rays rays{.centre = {0, 0}, .degrees = {10, 70, 130, 190, 250, 310}};
    const FamilyCut sectors = cut_checked(square(), rays);
    EXPECT_EQ(sectors.columns, (std::vector<std::int32_t>{0, 1, 2, 3, 4, 5}));
    EXPECT_NEAR(area(sectors.pieces[0]), area(sectors.pieces[3]), 1e-3);
    // Sector 1 lies between 70 and 130 degrees from x towards y.
    EXPECT_EQ(locate(sectors.pieces[1], snap({0, 50})), 1);
    // From a centre outside all rays that meet the square cross it.
    EXPECT_EQ(cut_checked(square(), Rays{.centre = {-200, 0}, .degrees = {-10, 0, 10, 90}}).columns,
              (std::vector<std::int32_t>{0, 1, 2, 3}));
    EXPECT_EQ(cut_checked(square(), Rays{.centre = {0, 0}}).columns, std::vector<std::int32_t>{0});
    EXPECT_EQ(cut_checked(square(), Rays{.centre = {0, 0}, .degrees = {45}}).pieces.size(), 1U);
}

TEST(CurveFamilies, ASpiralOfTwoArmsMakesTwoBands) {
    Outline disc;
    for (int i = 0; i < 400; ++i) disc.push_back(turn({100, 0}, 0.9 * i));
    const Polygons shape = polygon_of({disc});
    const Rays arms{.centre = {0, 0}, .degrees = {0, 180}, .curl = 360 / 20.0, .tolerance = fine};
    const FamilyCut bands = cut_checked(shape, arms);
    ASSERT_EQ(bands.columns, (std::vector<std::int32_t>{0, 1}));
    EXPECT_NEAR(area(bands.pieces[0]), area(bands.pieces[1]), 1);
    // Along any ray from the centre the bands take turns every 10 px.
    const PolygonView even = bands.pieces[0];
    for (double r = 5 + 10 * 0.25; r < 90; r += 10) {
        EXPECT_EQ(locate(even, snap(turn({r, 0}, 45))), -locate(even, snap(turn({r + 10, 0}, 45)))) << r;
    }
}

TEST(CurveFamilies, RingsAndSectorsTogetherAreFields) {
    const Circles circles{.centre = {0, 0}, .radii = {20, 50}, .tolerance = fine};
    const CurveFamily rays = Rays{.centre = {0, 0}, .degrees = {0, 90, 180, 270}, .curl = 0.5, .tolerance = fine};
    const FamilyCut fields = cut_checked(square(), circles, &rays);
    EXPECT_EQ(fields.columns, (std::vector<std::int32_t>{0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2}));
    EXPECT_EQ(fields.rows, (std::vector<std::int32_t>{0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3}));
}

TEST(CurveFamilies, ADrawnGraphBecomesAProfile) {
    // A bow over a slanted chord.
    std::vector<Polyline> lines(1);
    for (int i = 0; i <= 50; ++i) {
        const double x = i * 2.0;
        lines[0].points.push_back(Vec{7, 9} + turn({x, 10 * elementary::cos_sin(elementary::pi * x / 100).sin}, 33));
    }
    const auto curve = drawn_curve(lines);
    ASSERT_TRUE(curve.has_value());
    EXPECT_TRUE(curve->goes_on);
    EXPECT_NEAR(curve->period, 100, 1e-9);
    const auto profile = profile_of(*curve, 0.01);
    ASSERT_TRUE(profile.has_value());
    EXPECT_NEAR(profile->step * static_cast<double>(profile->samples.size()), 100, 1e-9);
    EXPECT_NEAR(profile_at(*profile, 150), 10, 0.02);
    EXPECT_EQ(profile->samples[0], 0);
}

TEST(CurveFamilies, WhatDoublesBackIsNoProfile) {
    const std::vector<Polyline> hook{{{{0, 0}, {60, 0}, {60, 20}, {40, 20}, {40, 10}, {80, 10}, {100, 0}}, false}};
    const auto curve = drawn_curve(hook);
    ASSERT_TRUE(curve.has_value());
    EXPECT_FALSE(profile_of(*curve, 0.01).has_value());
    const std::vector<Polyline> step{{{{0, 0}, {50, 0}, {50, 20}, {100, 20}, {100, 0}, {120, 0}}, false}};
    EXPECT_FALSE(profile_of(*drawn_curve(step), 0.01).has_value());
    const std::vector<Polyline> ring{{{{0, 0}, {9, 0}, {9, 9}}, true}};
    EXPECT_FALSE(profile_of(*drawn_curve(ring), 0.01).has_value());
    EXPECT_FALSE(drawn_curve({}).has_value());
    EXPECT_FALSE(drawn_curve(std::vector<Polyline>{{{{1, 1}, {1, 1}}, false}}).has_value());
    EXPECT_FALSE(drawn_curve(std::vector<Polyline>{{{{1, 1}, {1e300, 1}}, false}}).has_value());
}

TEST(CurveFamilies, CopiesOfAHookCutStripsAndEyes) {
    const std::vector<Polyline> hook{{{{0, 0}, {60, 0}, {60, 20}, {40, 20}, {40, -10}, {80, -10}, {100, 0}}, false}};
    const Copies copies{
        .curve = *drawn_curve(hook), .frame = {{3, 4}, {1, 0}}, .levels = {-60, 0, 60}, .first_strip = -2};
    const FamilyCut strips = cut_checked(square(), copies);
    EXPECT_EQ(std::set<std::int32_t>(strips.columns.begin(), strips.columns.end()),
              (std::set<std::int32_t>{-2, -1, 0, 1}));
    // Between the curves four strips, and the eyes that each copy closes with itself.
    EXPECT_GT(strips.pieces.size(), 8U);
}

TEST(CurveFamilies, CopiesOfAClosedCurveLieSideBySide) {
    const std::vector<Polyline> diamond{{{{0, 0}, {10, 5}, {0, 10}, {-10, 5}}, true}};
    const Copies copies{.curve = *drawn_curve(diamond), .frame = {{0, 0}, {1, 0}}, .levels = {-40, 0, 40}};
    const FamilyCut tiles = cut_checked(square(), copies);
    std::size_t diamonds = 0;
    for (std::size_t i = 0; i < tiles.pieces.size(); ++i) diamonds += std::fabs(area(tiles.pieces[i]) - 100) < 1e-3;
    EXPECT_EQ(diamonds, 27U);  // nine and two halves in each row
}

TEST(CurveFamilies, FamiliesThatAreTooLargeCutNothing) {
    Circles circles{.centre = {0, 0}, .tolerance = 1e-6};
    for (int i = 1; i < 5000; ++i) circles.radii.push_back(i * 0.01);
    const FamilyCut result = cut_by_families(square()[0], circles, nullptr);
    EXPECT_TRUE(result.too_large);
    EXPECT_EQ(result.pieces.size(), 1U);
}

TEST(CurveFamilies, RandomFamiliesPartitionRandomShapes) {
    for (std::uint64_t seed = 0; seed < case_count(200); ++seed) {
        CaseRandom random(seed);
        const Polygons shape =
            polygon_of(random.coin() ? wobbly_shape(random) : cell_shape(random, 6, 8, random.coin()));
        const Box box = bounds(shape);
        const Vec low = to_px(box.min), high = to_px(box.max);
        const Vec centre{random.between(low.x - 30, high.x + 30), random.between(low.y - 30, high.y + 30)};
        const auto family = [&]() -> CurveFamily {
            switch (random.whole(0, 2)) {
                case 0: {
                    Circles circles{.centre = centre};
                    double radius = 0;
                    for (int i = random.whole(1, 20); i > 0; --i)
                        circles.radii.push_back(radius += random.between(1, 20));
                    return circles;
                }
                case 1: {
                    Rays rays{.centre = centre, .curl = random.coin() ? random.between(-20, 20) : 0};
                    const int count = random.whole(1, 20);
                    for (int i = 0; i < count; ++i) rays.degrees.push_back(17 + 360.0 * i / count);
                    return rays;
                }
                default: {
                    Polyline line;
                    for (int i = random.whole(3, 9); i > 0; --i)
                        line.points.push_back({random.between(0, 40), random.between(0, 20)});
                    line.closed = random.coin();
                    Copies copies{*drawn_curve(std::vector{line}), {centre, turn({1, 0}, random.between(0, 360))}, {}};
                    double level = -100;
                    for (int i = random.whole(1, 20); i > 0; --i)
                        copies.levels.push_back(level += random.between(4, 30));
                    return copies;
                }
            }
        };
        const CurveFamily first = family(), second = family();
        const FamilyCut cut = cut_checked(shape, first, random.coin() ? &second : nullptr);
        EXPECT_EQ(cut.columns.size(), cut.pieces.size());
        if (testing::Test::HasFailure()) FAIL() << "seed " << seed;
    }
}

}  // namespace
}  // namespace filigree
