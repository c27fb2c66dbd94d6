// Laws of level cuts over many random shapes and families.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/test_cases.h"
#include "plane/level_cut_test_laws.h"

namespace filigree {
namespace {

using namespace level_cut_shapes;

Polygons moved(const Polygons& polygons, Point by) {
    Polygons result = polygons;
    for (Point& p : result.points) p = {p.x + by.x, p.y + by.y};
    return result;
}

TEST(LevelCutProperties, WobblyShapes) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed);
        const Polygons shape = polygon_of(wobbly_shape(random));
        const LevelFamily family = random_family(random, shape[0]);
        expect_partition(shape, family, cut(shape[0], family));
        if (testing::Test::HasFailure()) FAIL() << "seed " << seed;
    }
}

// Lattice shapes turned by nothing, 45 degrees or 0.1 rad, cut by lines and zigzags on the lattice: vertices
// and edges on levels everywhere, rings that touch.
TEST(LevelCutProperties, AlignedShapes) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed + 1000000);
        const double turns[] = {0, 45, 5.729577951308232, 90};
        const double degrees = turns[random.whole(0, 3)];
        const Polygons shape = polygon_of(cell_shape(random, random.whole(1, 9), 8, random.whole(0, 3) == 0), degrees);
        LevelFamily family = lines(degrees + 45 * random.whole(0, 7), {});
        switch (random.whole(0, 3)) {
            case 0:
                break;
            case 1:
                family.profile = {8, {0, 8}};
                break;
            case 2:
                family.profile = {4, {0, 2, 4, 2}};
                break;
            case 3:
                family.profile = {8, {0, 0, 8, 8}};
                break;
        }
        const double spacing = random.coin() ? 8 : 4 * std::sqrt(2);
        for (int k = -20; k <= 20; ++k) family.levels.push_back(k * spacing);
        expect_partition(shape, family, cut(shape[0], family));
        if (testing::Test::HasFailure()) FAIL() << "seed " << seed;
    }
}

TEST(LevelCutProperties, RingStartsAndOrderDoNotMatter) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed + 2000000);
        const bool aligned = random.coin();
        const Polygons shape = polygon_of(aligned ? cell_shape(random, 6, 8, false) : wobbly_shape(random));
        LevelFamily family = random_family(random, shape[0]);
        if (aligned) family = forty_strips(90 * random.whole(0, 3));
        std::vector<std::size_t> order(shape[0].ring_count());
        std::iota(order.begin(), order.end(), std::size_t{0});
        for (std::size_t i = order.size(); i > 1; --i) {
            std::swap(order[i - 1], order[random.index(i)]);
        }
        Polygons shuffled;
        for (const std::size_t r : order) {
            std::vector<Point> ring(shape[0].ring(r).begin(), shape[0].ring(r).end());
            std::rotate(ring.begin(), ring.begin() + random.whole(0, static_cast<int>(ring.size()) - 1), ring.end());
            shuffled.add_ring(ring);
        }
        shuffled.end_polygon();
        const LevelCut a = cut(shape[0], family), b = cut(shuffled[0], family);
        ASSERT_EQ(a.pieces, b.pieces) << "seed " << seed;
        ASSERT_EQ(a.strips, b.strips) << "seed " << seed;
    }
}

TEST(LevelCutProperties, WholeShiftsShiftThePieces) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed + 3000000);
        const Polygons shape = polygon_of(wobbly_shape(random));
        LevelFamily family = random_family(random, shape[0]);
        family.frame.origin =
            to_px(snap({std::floor(family.frame.origin.x * 64) / 64, std::floor(family.frame.origin.y * 64) / 64}));
        const Vec by{static_cast<double>(random.whole(-100000, 100000)),
                     static_cast<double>(random.whole(-100000, 100000))};
        const LevelCut here = cut(shape[0], family);
        family.frame.origin = family.frame.origin + by;
        const LevelCut there = cut(moved(shape, snap(by))[0], family);
        ASSERT_EQ(there.pieces, moved(here.pieces, snap(by))) << "seed " << seed;
        ASSERT_EQ(there.strips, here.strips) << "seed " << seed;
    }
}

// Two cuts one after the other, the second across the first: the pieces of different first pieces still
// share all vertices.
TEST(LevelCutProperties, DualSplitsConform) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed + 4000000);
        const bool aligned = random.whole(0, 2) == 0;
        const Polygons shape = polygon_of(aligned ? cell_shape(random, 6, 8, random.coin()) : wobbly_shape(random));
        LevelFamily family = random_family(random, shape[0]);
        if (aligned) {
            family = forty_strips(45 * random.whole(0, 7));
            if (random.coin()) family.profile = {10, {0, 10}};
        }
        LevelFamily second = family;
        second.frame = turned(family.frame);
        if (!aligned) {
            second.levels.clear();
            add_levels(random, second, level_range(shape[0], second.frame, second.profile));
        }
        const LevelCut first = cut(shape[0], family);
        Polygons pieces;
        for (std::size_t i = 0; i < first.pieces.size(); ++i) pieces.add_all(cut(first.pieces[i], second).pieces);
        EXPECT_NEAR(area(pieces), area(shape), 1e-9 * area(shape));
        EXPECT_NEAR(unmatched_length(pieces), perimeter(shape[0]), 1e-9 * perimeter(shape[0]));
        for (std::size_t i = 0; i < pieces.size(); ++i)
            EXPECT_EQ(find_flaw(pieces[i]).value_or(""), "") << "piece " << i;
        EXPECT_EQ(find_overlap(pieces).value_or(""), "");
        if (testing::Test::HasFailure()) FAIL() << "seed " << seed;
    }
}

// Any family cuts the pieces of any other: neighbours that share a border get the same points on it.
TEST(LevelCutProperties, NeighboursConform) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed + 5000000);
        const Polygons shape = polygon_of(wobbly_shape(random));
        const LevelCut first = cut(shape[0], random_family(random, shape[0]));
        const LevelFamily second = random_family(random, shape[0]);
        Polygons pieces;
        for (std::size_t i = 0; i < first.pieces.size(); ++i) pieces.add_all(cut(first.pieces[i], second).pieces);
        EXPECT_NEAR(area(pieces), area(shape), 1e-9 * area(shape));
        EXPECT_NEAR(unmatched_length(pieces), perimeter(shape[0]), 1e-9 * perimeter(shape[0]));
        if (testing::Test::HasFailure()) FAIL() << "seed " << seed;
    }
}

TEST(LevelCutProperties, TheSameFamilyAgainChangesNothing) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed + 6000000);
        const Polygons shape = polygon_of(wobbly_shape(random));
        const LevelFamily family = random_family(random, shape[0]);
        const LevelCut once = cut(shape[0], family);
        for (std::size_t i = 0; i < once.pieces.size(); ++i) {
            const LevelCut again = cut(once.pieces[i], family);
            EXPECT_EQ(again.pieces.size(), 1u) << "piece " << i;
            EXPECT_NEAR(area(again.pieces), area(once.pieces[i]), 1e-9 * area(shape));
        }
        if (testing::Test::HasFailure()) FAIL() << "seed " << seed;
    }
}

// Levels closer than the tolerance, and steep curves: areas still add up.
TEST(LevelCutProperties, DenseLevelsAndSteepCurves) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed + 10000000);
        const Polygons shape = polygon_of(wobbly_shape(random));
        LevelFamily family = random_family(random, shape[0]);
        family.profile = {random.between(0.3, 3), {}};
        for (int i = random.whole(1, 20); i > 0; --i) family.profile.samples.push_back(random.between(-60, 60));
        std::vector<double> levels;
        for (const double level : family.levels) {
            levels.push_back(level);
            for (int i = random.whole(0, 2); i > 0; --i) levels.push_back(levels.back() + random.between(1e-9, 1e-5));
        }
        family.levels = levels;
        std::sort(family.levels.begin(), family.levels.end());
        const LevelCut result = cut(shape[0], family);
        EXPECT_NEAR(area(result.pieces), area(shape), 1e-8 * area(shape)) << "seed " << seed;
        for (std::size_t i = 0; i < result.pieces.size(); ++i) ASSERT_GT(doubled_area(result.pieces[i].outer()), 0);
        if (testing::Test::HasFailure()) FAIL() << "seed " << seed;
    }
}

TEST(LevelCutProperties, RangeIsWhereLevelsCut) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed + 7000000);
        const Polygons shape = polygon_of(wobbly_shape(random));
        LevelFamily family = random_family(random, shape[0]);
        const LevelRange range = level_range(shape[0], family.frame, family.profile);
        family.levels = {range.low - 1e-5, range.high + 1e-5};
        EXPECT_EQ(cut(shape[0], family).pieces.size(), 1u) << "seed " << seed;
        family.levels = {range.low + 1e-3, range.high - 1e-3};
        const LevelCut ends = cut(shape[0], family);
        ASSERT_GE(ends.pieces.size(), 3u) << "seed " << seed;
        EXPECT_EQ(ends.strips.back() - ends.strips.front(), 2) << "seed " << seed;
    }
}

}  // namespace
}  // namespace filigree
