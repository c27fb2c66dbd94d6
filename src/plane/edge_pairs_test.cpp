#include "plane/edge_pairs.h"

#include <gtest/gtest.h>

#include <set>

#include "base/test_cases.h"

namespace filigree {
namespace {

struct Segment {
    Point a, b;
};

bool do_meet(const Segment& s, const Segment& t) {
    const int c = orientation(s.a, s.b, t.a), d = orientation(s.a, s.b, t.b);
    const int a = orientation(t.a, t.b, s.a), b = orientation(t.a, t.b, s.b);
    Box box, other;
    for (const Point p : {s.a, s.b}) extend(box, p);
    for (const Point p : {t.a, t.b}) extend(other, p);
    return overlaps(box, other) && c * d <= 0 && a * b <= 0;
}

// One goes on from the other within a quadrant, so that they have that one point in common.
bool go_on(const Segment& s, const Segment& t) {
    const auto is_between = [](Point a, Point middle, Point b) {
        const auto in_order = [](std::int64_t x, std::int64_t y, std::int64_t z) {
            return (x <= y && y <= z) || (x >= y && y >= z);
        };
        return in_order(a.x, middle.x, b.x) && in_order(a.y, middle.y, b.y) && a != middle && b != middle;
    };
    return (s.b == t.a && is_between(s.a, s.b, t.b)) || (s.a == t.b && is_between(s.b, s.a, t.a));
}

// Against all pairs, over walks on a coarse grid with many touching, equal and empty edges, in rings and pieces.
TEST(EdgePairs, FindAllThatMeet) {
    EdgePairs pairs;
    std::uint64_t met = 0, visited = 0, all = 0;
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed);
        const int step = random.whole(1, 30);
        const double turns = random.between(0, 1);
        std::vector<Segment> edges;
        Point at{0, 0};
        Point way{1, 1};
        for (int i = random.whole(0, 90); i > 0; --i) {
            if (random.between(0, 1) < turns) way = {random.whole(-1, 1), random.whole(-1, 1)};
            const Point next{at.x + way.x * random.whole(0, step), at.y + way.y * random.whole(0, step)};
            edges.push_back(random.below(2) == 0 ? Segment{at, next} : Segment{next, at});
            at = random.below(12) == 0 ? Point{random.whole(-step, step), random.whole(-step, step)} : next;
        }
        pairs.clear();
        for (const Segment& edge : edges) pairs.add(edge.a, edge.b);
        std::set<std::pair<std::uint32_t, std::uint32_t>> found;
        pairs.for_each([&](std::uint32_t i, std::uint32_t j) {
            EXPECT_LT(i, j);
            EXPECT_TRUE(found.emplace(i, j).second) << "twice";
        });
        for (std::uint32_t i = 0; i < edges.size(); ++i) {
            for (std::uint32_t j = i + 1; j < edges.size(); ++j) {
                ++all;
                if (!do_meet(edges[i], edges[j])) continue;
                ++met;
                const Segment reversed{edges[j].b, edges[j].a};
                if (found.contains({i, j}) || go_on(edges[i], edges[j]) || go_on(edges[i], reversed)) continue;
                ADD_FAILURE() << "seed " << seed << ": " << i << " and " << j;
            }
        }
        visited += found.size();
    }
    EXPECT_GT(met, 0U);
    EXPECT_LT(visited, all / 2);
}

// A smooth outline of many edges is hardly searched.
TEST(EdgePairs, AWalkInOneQuadrantHasNone) {
    EdgePairs pairs;
    for (int i = 0; i < 1000; ++i) pairs.add({i * 3, i * i}, {i * 3 + 3, (i + 1) * (i + 1)});
    std::size_t found = 0;
    pairs.for_each([&](std::uint32_t, std::uint32_t) { ++found; });
    EXPECT_EQ(found, 0U);
}

}  // namespace
}  // namespace filigree
