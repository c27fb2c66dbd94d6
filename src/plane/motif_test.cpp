#include "plane/motif.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "base/test_cases.h"
#include "plane/transform.h"
#include "plane/verify.h"

namespace filigree {
namespace {

std::vector<Motif> all_motifs(std::uint64_t bits) {
    return {disc_motif(12),
            disc_motif(200),
            blob_motif(unit_circle(24), bits),
            blob_motif(unit_circle(64), mix(bits)),
            square_motif(),
            dash_motif(0.2, 8),
            dash_motif(5, 8),
            curve_motif(0.15, 8),
            curve_motif(0.01, 12),
            curve_motif(9, 8),
            ring_motif(0.1, 24),
            ring_motif(7, 24),
            ring_motif(0, 24)};
}

double largest_radius(const Motif& motif) {
    double largest = 0;
    for (const Vec p : motif.points) largest = std::max(largest, length(p));
    return largest;
}

TEST(Motif, AllAreCleanAtEverySizeAndInEveryDirection) {
    const std::uint64_t count = case_count(100);
    for (std::uint64_t seed = 0; seed < count; ++seed) {
        CaseRandom random(seed);
        for (const Motif& motif : all_motifs(seed)) {
            EXPECT_NEAR(largest_radius(motif), 1, 1e-12);
            const double radius = std::pow(10.0, random.between(-2, 4));
            const Vec at{random.between(-1e4, 1e4), random.between(-1e4, 1e4)};
            Polygons polygons;
            append(polygons, motif, {at, unit_at_degrees(random.between(0, 360)), radius});
            ASSERT_EQ(polygons.size(), 1U);
            EXPECT_EQ(find_flaw(polygons[0]), std::nullopt) << seed;
            for (const Point p : polygons.points) EXPECT_LE(length(to_px(p) - at), radius * (1 + 1e-9) + 1e-7);
        }
    }
}

TEST(Motif, BlobsAreRoundAndHaveTheirCentroidInTheMiddle) {
    for (std::uint64_t bits = 0; bits < 200; ++bits) {
        const Motif blob = blob_motif(unit_circle(48), mix(bits));
        double least = 1;
        for (const Vec p : blob.points) least = std::min(least, length(p));
        EXPECT_GT(least, 0.68);
        Polygons polygons;
        append(polygons, blob, {{5, 6}, {1, 0}, 10});
        EXPECT_NEAR(centroid(polygons[0]).x, 5, 1e-6);
        EXPECT_NEAR(centroid(polygons[0]).y, 6, 1e-6);
    }
    EXPECT_NE(blob_motif(unit_circle(48), 1).points, blob_motif(unit_circle(48), 2).points);
}

TEST(Motif, CirclesHaveAsManyCornersAsTheToleranceNeeds) {
    for (const double radius : {0.5, 3.0, 20.0, 400.0}) {
        for (const double tolerance : {0.01, 0.1, 1.0}) {
            const int corners = circle_corners(radius, tolerance);
            EXPECT_EQ(corners % 4, 0);
            const double off = radius * (1 - elementary::cos_sin_degrees(180.0 / corners).cos);
            EXPECT_LE(off, corners < 256 ? tolerance * 1.001 : 1e300);
            EXPECT_GT(off, corners > 12 ? tolerance / 3 : 0);
        }
    }
}

TEST(Motif, DrawnShapesFillTheirSmallestCircle) {
    const std::uint64_t count = case_count(300);
    for (std::uint64_t seed = 0; seed < count; ++seed) {
        CaseRandom random(seed);
        Polyline outline{{}, true};
        const std::uint32_t corners = random.below(20) + 3;
        const double size = std::pow(10.0, random.between(-3, 5));
        for (std::uint32_t i = 0; i < corners; ++i) {
            outline.points.push_back({size * random.between(3, 4), size * random.between(-7, -6)});
        }
        const Motif motif = drawn_motif({outline}, random.coin() ? FillRule::nonzero : FillRule::even_odd, 1e-3);
        ASSERT_FALSE(motif.points.empty());
        EXPECT_LE(largest_radius(motif), 1 + 1e-12);
        EXPECT_GT(largest_radius(motif), 0.999);
        // No smaller circle holds it: some points lie on it in every half plane.
        for (double angle = 0; angle < 360; angle += 15) {
            EXPECT_TRUE(std::any_of(motif.points.begin(), motif.points.end(),
                                    [&](Vec p) { return length(p) > 0.99 && dot(p, unit_at_degrees(angle)) > -0.05; }))
                << "seed " << seed;
        }
        Polygons polygons;
        append(polygons, motif,
               {{random.between(-99, 99), 3}, unit_at_degrees(random.between(0, 360)), random.between(0.05, 300)});
        for (std::size_t i = 0; i < polygons.size(); ++i) EXPECT_EQ(find_flaw(polygons[i]), std::nullopt) << seed;
        EXPECT_EQ(find_overlap(polygons), std::nullopt) << seed;
    }
}

TEST(Motif, AStarLiesInItsOwnMiddleAndHolesStay) {
    Polyline star{{}, true};
    for (int i = 0; i < 10; ++i)
        star.points.push_back(Vec{70, 30} + (i % 2 == 0 ? 20.0 : 8.0) * unit_at_degrees(36.0 * i - 90));
    const Motif motif = drawn_motif({star}, FillRule::nonzero, 1e-4);
    ASSERT_EQ(motif.points.size(), 10U);
    EXPECT_FALSE(motif.is_frail);
    std::size_t tips = 0;
    for (const Vec p : motif.points) {
        const double radius = length(p);
        tips += radius > 0.99;
        EXPECT_NEAR(radius, radius > 0.7 ? 1 : 0.4, 1e-6);
    }
    EXPECT_EQ(tips, 5U);

    const Polyline outside{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, true}, inside{{{4, 4}, {6, 4}, {6, 6}, {4, 6}}, true};
    const Motif frame = drawn_motif({outside, inside}, FillRule::even_odd, 1e-4);
    EXPECT_EQ(frame.ring_ends.size(), 2U);
    EXPECT_EQ(frame.polygon_ends.size(), 1U);
    Polygons polygons;
    append(polygons, frame, {{0, 0}, {0, 1}, std::sqrt(50.0)});
    EXPECT_NEAR(area(polygons), 96, 1e-4);
}

TEST(Motif, DetailsBelowTheToleranceAreLeftOut) {
    Polyline circle{{}, true};
    for (int i = 0; i < 5000; ++i) circle.points.push_back(100 * unit_at_degrees(360.0 * i / 5000));
    EXPECT_LT(drawn_motif({circle}, FillRule::nonzero, 0.01).points.size(), 60U);
    EXPECT_GT(drawn_motif({circle}, FillRule::nonzero, 1e-4).points.size(), 150U);
}

TEST(Motif, PartsThatTouchAreCleanedWhereTheyArePlaced) {
    // Two squares that meet at a corner, and two a hair apart.
    const Polyline first{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, true};
    for (const double off : {10.0, 10.00001}) {
        const Polyline second{{{off, off}, {20, off}, {20, 20}, {off, 20}}, true};
        const Motif motif = drawn_motif({first, second}, FillRule::nonzero, 1e-4);
        EXPECT_TRUE(motif.is_frail);
        for (double angle = 0; angle < 90; angle += 7) {
            Polygons polygons;
            append(polygons, motif, {{31, 17}, unit_at_degrees(angle), 0.3});
            for (std::size_t i = 0; i < polygons.size(); ++i) EXPECT_EQ(find_flaw(polygons[i]), std::nullopt);
            EXPECT_EQ(find_overlap(polygons), std::nullopt);
        }
    }
}

TEST(Motif, WhatEnclosesNothingIsEmpty) {
    EXPECT_TRUE(drawn_motif({}, FillRule::nonzero, 1e-3).points.empty());
    EXPECT_TRUE(drawn_motif({{{{0, 0}, {5, 5}}, true}}, FillRule::nonzero, 1e-3).points.empty());
    EXPECT_TRUE(drawn_motif({{{{3, 3}}, true}}, FillRule::nonzero, 1e-3).points.empty());
    EXPECT_TRUE(drawn_motif({{{{0, 0}, {1e300, 0}, {0, 1e300}}, true}}, FillRule::nonzero, 1e-3).points.empty());
}

}  // namespace
}  // namespace filigree
