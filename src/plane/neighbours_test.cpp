#include "plane/neighbours.h"

#include <gtest/gtest.h>

#include <set>

#include "base/test_cases.h"
#include "plane/level_cut.h"

namespace filigree {
namespace {

Polygons rectangle(double x, double y, double width, double height) {
    Polygons out;
    for (const Vec corner : {Vec{x, y}, Vec{x + width, y}, Vec{x + width, y + height}, Vec{x, y + height}}) {
        out.points.push_back(snap(corner));
    }
    out.end_ring();
    out.end_polygon();
    return out;
}

std::vector<std::uint32_t> row(const Neighbours& all, std::uint32_t polygon) {
    return {all.to.begin() + all.starts[polygon], all.to.begin() + all.starts[polygon + 1]};
}

// The same by brute force: edges on one line that overlap.
std::set<std::pair<std::uint32_t, std::uint32_t>> touching(const Polygons& polygons) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (std::uint32_t p = 0; p < polygons.size(); ++p) {
        for (std::uint32_t q = 0; q < polygons.size(); ++q) {
            if (p == q) continue;
            for (std::size_t i = 0; i < polygons[p].outer().size(); ++i) {
                const RingView one = polygons[p].outer(), other = polygons[q].outer();
                const Vec a = to_px(one[i]), b = to_px(one[(i + 1) % one.size()]);
                const Vec along = (b - a) * (1 / length(b - a));
                for (std::size_t k = 0; k < other.size(); ++k) {
                    const Vec c = to_px(other[k]), d = to_px(other[(k + 1) % other.size()]);
                    if (std::fabs(cross(along, c - a)) > 1e-5 || std::fabs(cross(along, d - a)) > 1e-5) continue;
                    const double low = std::max(0.0, std::min(dot(along, c - a), dot(along, d - a)));
                    const double high = std::min(length(b - a), std::max(dot(along, c - a), dot(along, d - a)));
                    if (high - low > 1e-3) pairs.emplace(p, q);
                }
            }
        }
    }
    return pairs;
}

TEST(Neighbours, ShareAStretchOfBorderAndNotACorner) {
    Polygons four;
    for (const Polygons& one : {rectangle(0, 0, 10, 10), rectangle(10, 0, 10, 10), rectangle(10, 10, 10, 10)}) {
        four.add_all(one);
    }
    const Neighbours found = neighbours(four);
    EXPECT_EQ(row(found, 0), (std::vector<std::uint32_t>{1}));
    EXPECT_EQ(row(found, 1), (std::vector<std::uint32_t>{0, 2}));
    EXPECT_EQ(row(found, 2), (std::vector<std::uint32_t>{1}));
}

TEST(Neighbours, NeedNotHaveTheSameVertices) {
    Polygons bricks = rectangle(0, 0, 40, 10);
    bricks.add_all(rectangle(0, 10, 15, 10));
    bricks.add_all(rectangle(15, 10, 25, 10));
    EXPECT_EQ(row(neighbours(bricks), 0), (std::vector<std::uint32_t>{1, 2}));
}

TEST(Neighbours, NoneOfNone) {
    EXPECT_EQ(neighbours(Polygons{}).starts.size(), 1u);
    EXPECT_TRUE(coloured(neighbours(Polygons{}), 3).empty());
}

// A square cut twice by lines in random directions.
Polygons random_pieces(CaseRandom& random) {
    Polygons pieces = rectangle(0, 0, 200, 150);
    for (int round = 0; round < 2; ++round) {
        Polygons finer;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            LevelFamily family;
            family.frame.origin = {100, 75};
            const double x = random.between(-1, 1), y = random.between(-1, 1);
            const double size = length({x, y});
            if (size < 0.1) continue;
            family.frame.direction = {x / size, y / size};
            for (double level = -120; level < 120; level += random.between(20, 60)) family.levels.push_back(level);
            finer.add_all(cut(pieces[i], family).pieces);
        }
        if (!finer.empty()) pieces = std::move(finer);
    }
    return pieces;
}

TEST(NeighboursProperty, AgreeWithEveryPairLookedAt) {
    for (std::uint64_t seed = 0; seed < case_count(100); ++seed) {
        CaseRandom random(seed);
        const Polygons pieces = random_pieces(random);
        const Neighbours found = neighbours(pieces);
        std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
        for (std::uint32_t p = 0; p < pieces.size(); ++p) {
            for (const std::uint32_t q : row(found, p)) pairs.emplace(p, q);
        }
        for (const auto& pair : touching(pieces)) EXPECT_TRUE(pairs.count(pair)) << "case " << seed;
        for (const auto& [p, q] : pairs) EXPECT_TRUE(pairs.count({q, p})) << "case " << seed;
    }
}

TEST(NeighboursProperty, SixColoursAlwaysSufficeAndFourNearlyAlways) {
    int alike_of_four = 0, borders = 0;
    for (std::uint64_t seed = 0; seed < case_count(1000); ++seed) {
        CaseRandom random(seed);
        const Polygons pieces = random_pieces(random);
        const Neighbours all = neighbours(pieces);
        const std::vector<std::uint32_t> six = coloured(all, 6), four = coloured(all, 4);
        ASSERT_EQ(six.size(), pieces.size());
        for (std::uint32_t p = 0; p < pieces.size(); ++p) {
            EXPECT_LT(four[p], 4u);
            for (const std::uint32_t q : row(all, p)) {
                EXPECT_NE(six[p], six[q]) << "case " << seed;
                alike_of_four += four[p] == four[q];
                ++borders;
            }
        }
    }
    EXPECT_LE(alike_of_four, borders / 1000);
}

}  // namespace
}  // namespace filigree
