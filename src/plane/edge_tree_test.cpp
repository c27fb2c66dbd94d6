#include "plane/edge_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "base/test_cases.h"
#include "plane/inset_test_shapes.h"

namespace filigree {
namespace {

TEST(EdgeTree, AnswersAsLookingAtEveryEdgeDoes) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        CaseRandom random(seed);
        const Polygons shape = test_shapes::wobbly_shape(random, 100, random.whole(3, 300), 12);
        const std::vector<Edge> edges = edges_of(shape[0], Point{});
        ASSERT_EQ(edges.size(), shape[0].point_count());
        const EdgeTree tree(edges);
        for (int i = 0; i < 50; ++i) {
            const double x = random.between(-130, 130);
            const double y = random.between(-130, 130);
            const Point on_grid = snap({x, y});
            const Vec p = to_px(on_grid);
            double least2 = 1e300;
            for (const Edge& e : edges) least2 = std::min(least2, squared_distance(e, p));
            const double least = std::sqrt(least2);
            const bool is_inside = locate(shape[0], on_grid) > 0;

            EXPECT_EQ(tree.is_inside(p), is_inside);
            EXPECT_FALSE(tree.is_any_nearer(p, least * (1 - 1e-12)));
            EXPECT_TRUE(tree.is_any_nearer(p, least * (1 + 1e-12)));
            for (const double reach : {least * 0.9, least * 1.1, 500.0}) {
                const EdgeTree::Place place = tree.place(p, reach, 2 * reach);
                EXPECT_EQ(place.distance, reach > least ? least : reach);
                EXPECT_EQ(place.is_inside, is_inside);
                EXPECT_NEAR(length(place.nearest - p), least, 1e-9);
            }
            const VecBox box = around(p, random.between(0, 40));
            std::vector<std::uint32_t> found, expected;
            tree.any(box, [&](std::uint32_t e) {
                if (overlaps(around(edges[e], 0), box)) found.push_back(e);
                return false;
            });
            for (std::uint32_t e = 0; e < edges.size(); ++e) {
                if (overlaps(around(edges[e], 0), box)) expected.push_back(e);
            }
            EXPECT_EQ(found, expected);
        }
    }
}

TEST(EdgeTree, FindsPairsOfEdges) {
    CaseRandom random(2);
    const Polygons shape = test_shapes::wobbly_shape(random, 100, 333, 12);
    const EdgeTree tree(edges_of(shape[0], Point{}));
    const std::span<const Edge> edges = tree.edges();
    std::size_t found = 0, expected = 0;
    for (std::uint32_t first = 0; first < edges.size(); first += 4) {
        const auto few = edges.subspan(first, std::min<std::size_t>(4, edges.size() - first));
        tree.any_near(few, 3, first, [&](std::size_t k, std::uint32_t e) {
            found += e > first + k && overlaps(around(few[k], 3), around(edges[e], 0));
            return false;
        });
    }
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
        for (std::uint32_t j = i + 1; j < edges.size(); ++j)
            expected += overlaps(around(edges[i], 3), around(edges[j], 0));
    }
    EXPECT_EQ(found, expected);
}

TEST(EdgeTree, EmptyAndSmall) {
    const EdgeTree none(std::vector<Edge>{});
    EXPECT_FALSE(none.is_inside({0, 0}));
    EXPECT_FALSE(none.is_any_nearer({0, 0}, 1e9));
    EXPECT_EQ(none.place({0, 0}, 7, 9).distance, 7);
    const EdgeTree one(std::vector<Edge>{{{0, 0}, {1, 0}}});
    EXPECT_TRUE(one.is_any_nearer({0.5, 1}, 1.001));
    EXPECT_FALSE(one.is_any_nearer({0.5, 1}, 1));
    EXPECT_EQ(one.place({4, 4}, 100, 100).distance, 5);
}

TEST(EdgeTree, CornersTellTheSide) {
    // An arrow head: its tip is convex, its notch reflex.
    const Polygons shape = test_shapes::one_polygon({{snap({0, 0}), snap({10, 0}), snap({5, 2}), snap({5, 9})}});
    const EdgeTree tree(edges_of(shape[0], Point{}));
    EXPECT_FALSE(tree.place({-1, -1}, 5, 5).is_inside);
    EXPECT_FALSE(tree.place({5, 10}, 5, 5).is_inside);
    EXPECT_TRUE(tree.place({4.9, 1.95}, 5, 5).is_inside);
    EXPECT_EQ(tree.place({-3, -4}, 9, 9).distance, 5);
}

}  // namespace
}  // namespace filigree
