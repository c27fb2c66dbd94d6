#include "plane/point_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "base/test_cases.h"

namespace filigree {
namespace {

std::vector<Point> find_near(const PointTree& tree, Point a, Point b, double distance) {
    std::vector<std::uint32_t> numbers;
    tree.find_near(a, b, distance, numbers);
    std::vector<Point> found;
    for (const std::uint32_t i : numbers) found.push_back(tree.points()[i]);
    std::sort(found.begin(), found.end());
    return found;
}

double distance_to_segment(Point p, Point a, Point b) {
    const Vec d{static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y)};
    const Vec to{static_cast<double>(p.x - a.x), static_cast<double>(p.y - a.y)};
    const double t = dot(d, d) > 0 ? std::clamp(dot(to, d) / dot(d, d), 0.0, 1.0) : 0;
    return length(to - t * d);
}

TEST(PointTree, HoldsEachPointOnce) {
    EXPECT_TRUE(find_near(PointTree({}), {0, 0}, {5, 5}, 10).empty());
    const PointTree same(std::vector<Point>(1000, Point{3, 3}));
    EXPECT_EQ(find_near(same, {3, 3}, {3, 3}, 0), (std::vector<Point>{{3, 3}}));
    EXPECT_TRUE(find_near(same, {30, 3}, {30, 30}, 1).empty());
}

TEST(PointTree, TakesTheWholePlane) {
    const std::int64_t m = grid_limit;
    const PointTree tree({{-m, -m}, {m, m}, {0, 0}, {-m, m}});
    EXPECT_EQ(find_near(tree, {-m, -m}, {m, m}, 1), (std::vector<Point>{{-m, -m}, {0, 0}, {m, m}}));
    EXPECT_EQ(find_near(tree, {0, 0}, {1, 0}, INFINITY).size(), 4u);
}

TEST(PointTree, FindsAllThatAreNear) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed);
        const std::int64_t range = std::int64_t{1} << random.whole(3, 30);
        const auto place = [&] { return Point{random.whole(-range, range), random.whole(-range, range)}; };
        std::vector<Point> points(static_cast<std::size_t>(random.whole(0, 300)));
        for (Point& p : points) {
            p = place();
            if (random.whole(0, 1) == 0) p = {p.x / 1000, p.y / 1000};  // a cluster
        }
        const PointTree tree(points);
        std::sort(points.begin(), points.end());
        points.erase(std::unique(points.begin(), points.end()), points.end());
        for (int query = 0; query < 5; ++query) {
            const Point a = place(), b = place();
            const double distance =
                static_cast<double>(random.whole(0, range)) / static_cast<double>(random.whole(1, 100));
            const std::vector<Point> found = find_near(tree, a, b, distance);
            ASSERT_TRUE(std::adjacent_find(found.begin(), found.end()) == found.end()) << "seed " << seed;
            for (const Point p : points) {
                const double off = distance_to_segment(p, a, b);
                const bool is_found = std::binary_search(found.begin(), found.end(), p);
                if (off < distance * 0.999 - 1e-3) {
                    ASSERT_TRUE(is_found) << "seed " << seed;
                }
                if (off > 3 * (distance + 3)) {
                    ASSERT_FALSE(is_found) << "seed " << seed;
                }
            }
        }
    }
}

TEST(PointTree, KnowsItsPoints) {
    const PointTree tree({{3, 4}, {900, -7}, {3, 4}, {0, 0}});
    for (std::uint32_t i = 0; i < tree.points().size(); ++i) EXPECT_EQ(tree.index_of(tree.points()[i]), i);
    EXPECT_EQ(tree.index_of({3, 5}), PointTree::none);
    EXPECT_EQ(tree.index_of({INT64_MIN, INT64_MAX}), PointTree::none);
    EXPECT_EQ(PointTree({}).index_of({0, 0}), PointTree::none);
}

// Also across the borders of cells and of the grids in them.
TEST(PointTree, FindsAllPairs) {
    std::size_t in_all = 0;
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed);
        const std::int64_t range = std::int64_t{1} << random.whole(6, 30), distance = random.whole(0, 64);
        std::vector<Point> points(static_cast<std::size_t>(random.whole(0, 300)));
        for (Point& p : points) {
            p = {random.whole(-range, range), random.whole(-range, range)};
            if (random.whole(0, 2) == 0) p = {p.x / 1000, p.y / 1000};
            if (random.whole(0, 2) == 0) {
                p = points[random.index(points.size())];
                p = {p.x + random.whole(-70, 70), p.y + random.whole(-70, 70)};
            }
        }
        const PointTree tree(points);
        std::vector<PointTree::Pair> pairs;
        tree.find_pairs(static_cast<double>(distance), pairs);
        std::set<std::pair<std::uint32_t, std::uint32_t>> found;
        for (const PointTree::Pair& pair : pairs) found.emplace(std::min(pair.a, pair.b), std::max(pair.a, pair.b));
        for (std::uint32_t i = 0; i < tree.points().size(); ++i) {
            ASSERT_FALSE(found.contains({i, i})) << "seed " << seed;
            for (std::uint32_t j = i + 1; j < tree.points().size(); ++j) {
                const Point a = tree.points()[i], b = tree.points()[j];
                const bool is_near = std::abs(b.x - a.x) <= distance && std::abs(b.y - a.y) <= distance;
                ASSERT_EQ(found.contains({i, j}), is_near) << "seed " << seed;
                in_all += is_near ? 1 : 0;
            }
        }
    }
    EXPECT_GT(in_all, case_count());
}

}  // namespace
}  // namespace filigree
