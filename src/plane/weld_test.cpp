#include "plane/weld.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "base/test_cases.h"
#include "plane/verify.h"

#include "plane/test_rings.h"

namespace filigree {
namespace {

constexpr std::int64_t px = std::int64_t{1} << 26;
constexpr double tolerance = 0x1p-22;  // px; 16 grid units

Ring ring_of(const Polygons& polygons, std::size_t i) {
    const RingView ring = polygons[i].outer();
    return {ring.begin(), ring.end()};
}
double perimeter(PolygonView polygon) {
    double sum = 0;
    for (std::size_t r = 0; r < polygon.ring_count(); ++r) {
        const RingView ring = polygon.ring(r);
        for (std::size_t i = 0; i < ring.size(); ++i)
            sum += length(to_px(ring[(i + 1) % ring.size()]) - to_px(ring[i]));
    }
    return sum;
}

// How often each directed edge occurs.
using EdgeCounts = std::map<std::pair<Point, Point>, int>;
EdgeCounts count_edges(const Polygons& polygons) {
    EdgeCounts counts;
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        for (std::size_t r = 0; r < polygons[i].ring_count(); ++r) {
            const RingView ring = polygons[i].ring(r);
            for (std::size_t k = 0; k < ring.size(); ++k) ++counts[{ring[k], ring[(k + 1) % ring.size()]}];
        }
    }
    return counts;
}

TEST(Weld, LeavesWhatNeedsNothing) {
    EXPECT_EQ(weld({}), Polygons());
    const Polygons squares = polygons_of({{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{9, 0}, {18, 0}, {18, 9}, {9, 9}}});
    EXPECT_EQ(weld(squares), squares);  // though smaller than the tolerance
    EXPECT_EQ(weld(squares, 1e9), squares);
    const Polygons strange =
        polygons_of({{}, {{-5, 5}}, {{0, 0}, {0, 0}, {7, 7}}, {{INT64_MIN, 0}, {INT64_MAX, INT64_MAX}, {0, 1}}});
    EXPECT_EQ(weld(strange), strange);
    EXPECT_EQ(weld(strange, static_cast<double>(NAN)), strange);
}

TEST(Weld, SharesABorderCutTwice) {
    const Polygons before =
        polygons_of({{{0, 0}, {4 * px, 0}, {4 * px, 9 * px}, {0, 9 * px}},
                     {{4 * px, 0}, {8 * px, 0}, {8 * px, 3 * px}, {4 * px + 1, 3 * px}},
                     {{4 * px + 1, 3 * px}, {8 * px, 3 * px}, {8 * px, 9 * px}, {4 * px, 9 * px}, {4 * px, 5 * px}}});
    const Polygons after = weld(before);
    EXPECT_EQ(ring_of(after, 0),
              (Ring{{0, 0}, {4 * px, 0}, {4 * px + 1, 3 * px}, {4 * px, 5 * px}, {4 * px, 9 * px}, {0, 9 * px}}));
    EXPECT_EQ(ring_of(after, 1), ring_of(before, 1));
    EXPECT_EQ(ring_of(after, 2), ring_of(before, 2));
}

TEST(Weld, InsertsInOrderBothWays) {
    const Ring row = {{0, 0}, {90, 0}, {90 * px, 0}, {45 * px, -9 * px}};
    Ring other = {{0, 0}, {90 * px, 0}, {50 * px, 9 * px}};
    std::vector<Ring> rings = {other};
    std::reverse(other.begin(), other.end());
    rings.push_back(other);
    for (std::int64_t i = 1; i < 90; ++i)
        rings.push_back({{i * px, i % 5 - 2}, {i * px + px / 2, -px}, {i * px - px / 2, -px}});
    const Polygons after = weld(polygons_of(rings));
    Ring expected = {{0, 0}};
    for (std::int64_t i = 1; i < 90; ++i) expected.push_back({i * px, i % 5 - 2});
    expected.push_back({90 * px, 0});
    expected.push_back({50 * px, 9 * px});
    EXPECT_EQ(ring_of(after, 0), expected);
    std::reverse(expected.begin(), expected.end());
    EXPECT_EQ(ring_of(after, 1), expected);
}

TEST(Weld, KeepsToItsTolerance) {
    const auto inserted = [](Point p, double within) {
        const Polygons after =
            weld(polygons_of({{{0, 0}, {100 * px, 0}, {0, 100 * px}}, {p, {60 * px, -px}, {40 * px, -px}}}), within);
        return after[0].point_count() == 4;
    };
    EXPECT_TRUE(inserted({50 * px, -16}, tolerance));
    EXPECT_FALSE(inserted({50 * px, -17}, tolerance));
    EXPECT_TRUE(inserted({50 * px, 0}, 0));
    EXPECT_FALSE(inserted({50 * px, -1}, 0));
    EXPECT_FALSE(inserted({-1, 0}, tolerance));    // beyond an end
    EXPECT_FALSE(inserted({10, -10}, tolerance));  // around a corner
    EXPECT_TRUE(inserted({10, 0}, tolerance));     // two cuts may come close
    EXPECT_FALSE(inserted({0, 0}, tolerance));     // an end
}

// A hole that touches an edge, and a polygon in the hole.
TEST(Weld, TakesHoles) {
    Polygons before;
    before.add_ring(Ring{{0, 0}, {8 * px, 0}, {8 * px, 8 * px}, {0, 8 * px}});
    before.add_ring(Ring{{4 * px, 0}, {2 * px, 4 * px}, {6 * px, 4 * px}});
    before.end_polygon();
    before.add_ring(Ring{{4 * px, 0}, {6 * px, 4 * px}, {5 * px, 4 * px}, {2 * px, 4 * px}});
    before.end_polygon();
    ASSERT_EQ(find_flaw(before[0]).value_or(""), "");
    const Polygons after = weld(before);
    EXPECT_EQ(find_flaw(after[0]).value_or(""), "");
    EXPECT_EQ(after.polygon_ends, before.polygon_ends);
    EXPECT_EQ(ring_of(after, 0), (Ring{{0, 0}, {4 * px, 0}, {8 * px, 0}, {8 * px, 8 * px}, {0, 8 * px}}));
    const RingView hole = after[0].ring(1);
    EXPECT_EQ(Ring(hole.begin(), hole.end()),
              (Ring{{4 * px, 0}, {2 * px, 4 * px}, {5 * px, 4 * px}, {6 * px, 4 * px}}));
}

// Vertices inserted may come within reach of others: the weld goes on until nothing changes.
TEST(Weld, IsDoneOnceOnCrowdedPoints) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed);
        const std::int64_t range = random.whole(4, 4000);
        std::vector<Ring> rings(static_cast<std::size_t>(random.whole(1, 20)));
        for (Ring& ring : rings) {
            ring.resize(static_cast<std::size_t>(random.whole(1, 6)));
            for (Point& p : ring) p = {random.whole(-range, range), random.whole(-20, 20)};
        }
        const Polygons once = weld(polygons_of(rings));
        ASSERT_EQ(weld(once), once) << "seed " << seed;
    }
}

// A convex polygon split again and again, each part on its own, from a point on one edge to a point on another:
// new vertices are rounded to the grid, and lie inside the edges of neighbours.
struct Partition {
    Ring start;
    std::vector<Ring> parts;
};
Partition random_partition(CaseRandom& random) {
    Partition partition;
    const Vec d = Vec{random.between(-1, 1), random.between(0.1, 1)} * random.between(50, 500);  // a rotated rectangle
    const Vec o{random.between(-1e4, 1e4), random.between(-1e4, 1e4)}, e = perpendicular(d) * random.between(0.5, 2);
    partition.start = {snap(o), snap(o + d), snap(o + d + e), snap(o + e)};
    std::vector<std::pair<Ring, int>> waiting = {{partition.start, random.whole(0, 8)}};
    const auto place_on = [&](const Ring& ring, std::size_t i) {
        const Vec a = to_px(ring[i]), b = to_px(ring[(i + 1) % ring.size()]);
        return snap(a + random.between(0.2, 0.8) * (b - a));
    };
    while (!waiting.empty()) {
        auto [ring, splits] = waiting.back();
        waiting.pop_back();
        if (splits == 0) {
            partition.parts.push_back(ring);
            continue;
        }
        // The longest edge and one across, so that parts stay fat.
        std::size_t first = 0;
        const auto edge_length = [&](std::size_t i) {
            return length(to_px(ring[(i + 1) % ring.size()]) - to_px(ring[i]));
        };
        for (std::size_t i = 1; i < ring.size(); ++i) {
            if (edge_length(i) > edge_length(first)) first = i;
        }
        std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(first), ring.end());
        const std::size_t across =
            ring.size() / 2 - static_cast<std::size_t>(ring.size() == 3 ? random.whole(-1, 0) : 0);
        const Point p = place_on(ring, 0), q = place_on(ring, across);
        Ring low = {p}, high = {q};
        low.insert(low.end(), ring.begin() + 1, ring.begin() + static_cast<std::ptrdiff_t>(across) + 1);
        low.push_back(q);
        high.insert(high.end(), ring.begin() + static_cast<std::ptrdiff_t>(across) + 1, ring.end());
        high.push_back(ring[0]);
        high.push_back(p);
        waiting.push_back({low, splits - 1});
        waiting.push_back({high, splits - 1 - random.whole(0, splits > 1 ? 1 : 0)});
    }
    return partition;
}

bool lies_on_rim(const Ring& rim, Point p) {
    for (std::size_t i = 0; i < rim.size(); ++i) {
        const Vec a = to_px(rim[i]), d = to_px(rim[(i + 1) % rim.size()]) - a, to = to_px(p) - a;
        if (std::fabs(cross(d, to)) <= 1e-6 * length(d)) return true;
    }
    return false;
}

TEST(Weld, MakesPartitionsOfPartitionsWithTJunctions) {
    std::size_t inserted = 0;
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed);
        const Partition partition = random_partition(random);
        const Polygons before = polygons_of(partition.parts);
        const Polygons after = weld(before, tolerance);
        inserted += after.points.size() - before.points.size();

        ASSERT_EQ(after.size(), before.size());
        for (std::size_t i = 0; i < after.size(); ++i) {
            ASSERT_EQ(find_flaw(after[i]).value_or(""), "") << "seed " << seed;
            ASSERT_LE(std::fabs(area(after[i]) - area(before[i])), tolerance * perimeter(before[i])) << "seed " << seed;
            const Ring given = ring_of(before, i), grown = ring_of(after, i);
            auto at = grown.begin();
            for (const Point p : given) {
                at = std::find(at, grown.end(), p);
                ASSERT_TRUE(at != grown.end()) << "seed " << seed;
            }
        }
        ASSERT_EQ(find_overlap(after).value_or(""), "") << "seed " << seed;

        // Each directed edge occurs once, and its reverse once, but for the rim, which is a closed ring.
        const EdgeCounts counts = count_edges(after);
        std::map<Point, int> balance;
        double rim_length = 0;
        for (const auto& [edge, count] : counts) {
            ASSERT_EQ(count, 1) << "seed " << seed;
            if (counts.contains({edge.second, edge.first})) continue;
            ASSERT_TRUE(lies_on_rim(partition.start, edge.first) && lies_on_rim(partition.start, edge.second))
                << "seed " << seed;
            rim_length += length(to_px(edge.second) - to_px(edge.first));
            ++balance[edge.first];
            --balance[edge.second];
        }
        for (const auto& [at, sum] : balance) ASSERT_EQ(sum, 0) << "seed " << seed;
        const Polygons start = polygons_of({partition.start});
        ASSERT_NEAR(rim_length, perimeter(start[0]), 1e-5) << "seed " << seed;
        // Shared exactly, so the areas add up but for the rim's rounding.
        ASSERT_NEAR(area(after), area(start), 1e-7 * rim_length) << "seed " << seed;

        ASSERT_EQ(weld(after, tolerance), after) << "seed " << seed;

        std::vector<std::size_t> order(before.size());
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
        for (std::size_t i = order.size(); i > 1; --i) {
            std::swap(order[i - 1], order[random.index(i)]);
        }
        Polygons shuffled, expected;
        for (const std::size_t i : order) {
            shuffled.add(before[i]);
            expected.add(after[i]);
        }
        ASSERT_EQ(weld(shuffled, tolerance), expected) << "seed " << seed;
    }
    if (case_count() >= 100) {
        EXPECT_GT(inserted, 10 * case_count());
    }
}

}  // namespace
}  // namespace filigree
