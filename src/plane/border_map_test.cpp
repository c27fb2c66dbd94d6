#include "plane/border_map.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/test_cases.h"
#include "plane/test_rings.h"
#include "plane/weld.h"

namespace filigree {
namespace {

TEST(BorderMap, HasEveryVertexAndEdgeOnce) {
    const Polygons squares =
        polygons_of({{{0, 0}, {90, 0}, {90, 90}, {0, 90}}, {{90, 0}, {180, 0}, {180, 90}, {90, 90}}});
    const BorderMap map = border_map(squares);
    EXPECT_EQ(map.vertices.size(), 6U);
    EXPECT_EQ(map.edges.size(), 7U);
    ASSERT_EQ(map.sides.size(), 8U);
    for (std::size_t i = 0; i < 8; ++i) {
        const std::size_t next = i % 4 == 3 ? i - 3 : i + 1;
        EXPECT_EQ(map.vertices[map.start_of(map.sides[i])], squares.points[i]);
        EXPECT_EQ(map.vertices[map.end_of(map.sides[i])], squares.points[next]);
    }
    EXPECT_EQ(map.sides[1] ^ 1, map.sides[7]) << "one edge both ways";
    for (const BorderMap::Edge& edge : map.edges) EXPECT_LT(map.vertices[edge.low], map.vertices[edge.high]);
    const EdgesAtVertices around = edges_at_vertices(map);
    for (std::uint32_t v = 0; v < map.vertices.size(); ++v) {
        EXPECT_EQ(around.of(v).size(), map.vertices[v].x == 90 ? 3U : 2U);
        for (const std::uint32_t e : around.of(v)) EXPECT_TRUE(map.edges[e].low == v || map.edges[e].high == v);
    }
    EXPECT_EQ(map.sides_of(1)[0], map.sides[4]);
    EXPECT_TRUE(border_map({}).vertices.empty());
}

TEST(BorderMap, MergesWhatIsCloseTogether) {
    const Polygons almost =
        polygons_of({{{0, 0}, {900, 0}, {903, 900}, {0, 900}}, {{900, 3}, {1800, 0}, {1800, 900}, {900, 900}}});
    EXPECT_EQ(border_map(almost).vertices.size(), 8U);
    const BorderMap map = border_map(almost, 5 / grid_per_px);
    EXPECT_EQ(map.vertices.size(), 6U);
    EXPECT_EQ(map.edges.size(), 7U);
    EXPECT_TRUE(std::find(map.vertices.begin(), map.vertices.end(), Point{900, 0}) != map.vertices.end());
    EXPECT_TRUE(std::find(map.vertices.begin(), map.vertices.end(), Point{900, 900}) != map.vertices.end());
    const BorderMap folded = border_map(polygons_of({{{0, 0}, {4, 0}, {500, 500}}}), 5 / grid_per_px);
    EXPECT_EQ(folded.edges.size(), 1U);
    EXPECT_EQ(folded.sides[0], BorderMap::none);
    EXPECT_EQ(folded.sides[1], folded.sides[2] ^ 1);
}

// The same edges, numbered otherwise.
TEST(BorderMap, WeldsInOne) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed);
        const std::int64_t range = random.whole(40, 4000);
        std::vector<Ring> rings(static_cast<std::size_t>(random.whole(0, 20)));
        for (Ring& ring : rings) {
            ring.resize(static_cast<std::size_t>(random.whole(1, 6)));
            for (Point& p : ring) p = {random.whole(-range, range), random.whole(-20, 20)};
        }
        const double merge_within = random.whole(0, 4) / grid_per_px;
        const BorderMap one = welded_border_map(polygons_of(rings), merge_within);
        const BorderMap two = border_map(weld(polygons_of(rings)), merge_within);
        ASSERT_EQ(one.vertices.size(), two.vertices.size()) << "seed " << seed;
        ASSERT_EQ(one.edges.size(), two.edges.size()) << "seed " << seed;
        ASSERT_EQ(one.polygon_ends, two.polygon_ends) << "seed " << seed;
        const auto starts = [](const BorderMap& map) {
            std::vector<std::vector<Point>> all;
            std::size_t begin = 0;
            for (const std::uint32_t end : map.ring_ends) {
                all.emplace_back();
                for (std::size_t s = begin; s < end; ++s) {
                    if (map.sides[s] != BorderMap::none) all.back().push_back(map.vertices[map.start_of(map.sides[s])]);
                }
                begin = end;
            }
            return all;
        };
        ASSERT_EQ(starts(one), starts(two)) << "seed " << seed;
    }
}

// Many edges at one vertex, each of two triangles.
TEST(BorderMap, TakesStars) {
    std::vector<Ring> rings;
    constexpr int count = 60;
    for (std::int64_t i = 0; i < count; ++i) {
        const auto rim = [](std::int64_t k) { return Point{1000 + 10 * k, k * k}; };
        rings.push_back({{0, 0}, rim(i), rim(i + 1)});
    }
    const BorderMap map = border_map(polygons_of(rings));
    EXPECT_EQ(map.vertices.size(), count + 2U);
    EXPECT_EQ(map.edges.size(), 2U * count + 1);
}

}  // namespace
}  // namespace filigree
