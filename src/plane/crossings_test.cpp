#include "plane/crossings.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/elementary.h"
#include "base/test_cases.h"
#include "plane/verify.h"

namespace filigree {
namespace {

std::vector<DirectedLink> ring_links(std::uint32_t first, std::uint32_t count) {
    std::vector<DirectedLink> links;
    for (std::uint32_t i = 0; i < count; ++i) links.push_back({first + i, first + (i + 1) % count});
    return links;
}

std::vector<std::uint32_t> found_in(const std::vector<DirectedLink>& links, const std::vector<Point>& at) {
    std::vector<std::uint32_t> found;
    CrossingFinder().find(links, at, found);
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

TEST(Crossings, TellCleanFromCrossing) {
    EXPECT_TRUE(found_in(ring_links(0, 4), {{0, 0}, {9, 0}, {9, 9}, {0, 9}}).empty());
    EXPECT_EQ(found_in(ring_links(0, 4), {{0, 0}, {9, 9}, {9, 0}, {0, 9}}), (std::vector<std::uint32_t>{0, 1, 2, 3}));
    EXPECT_FALSE(found_in(ring_links(0, 4), {{0, 0}, {9, 0}, {9, 9}, {4, 0}}).empty()) << "a vertex on an edge";
    EXPECT_FALSE(found_in(ring_links(0, 4), {{0, 0}, {9, 0}, {5, 0}, {0, 9}}).empty()) << "back on the same way";
    EXPECT_TRUE(found_in(ring_links(0, 4), {{0, 0}, {5, 0}, {9, 0}, {0, 9}}).empty()) << "straight on";
    EXPECT_TRUE(found_in({{0, 1}, {1, 2}, {2, 1}, {1, 0}}, {{0, 0}, {5, 0}, {9, 0}}).empty()) << "a needle";
    EXPECT_TRUE(found_in({}, {}).empty());
}

// Two triangles that share a vertex, by the way in which they lie there.
TEST(Crossings, LookAtTheOrderAroundAVertex) {
    const std::vector<DirectedLink> both = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {3, 4}, {4, 0}};
    EXPECT_TRUE(found_in(both, {{0, 0}, {9, -3}, {9, 3}, {-9, 3}, {-9, -3}}).empty());
    EXPECT_TRUE(found_in(both, {{0, 0}, {9, 1}, {9, 3}, {9, -3}, {9, -1}}).empty());
    EXPECT_FALSE(found_in(both, {{0, 0}, {9, -3}, {9, 3}, {20, -3}, {20, 5}}).empty()) << "one over the other";
    EXPECT_FALSE(found_in(both, {{0, 0}, {9, -3}, {9, 3}, {5, -1}, {5, 1}}).empty()) << "one inside the other";
    const std::vector<DirectedLink> hole = {{0, 1}, {1, 2}, {2, 0}, {0, 4}, {4, 3}, {3, 0}};
    EXPECT_TRUE(found_in(hole, {{0, 0}, {9, -3}, {9, 3}, {5, -1}, {5, 1}}).empty());
    EXPECT_FALSE(found_in(hole, {{0, 0}, {9, -3}, {9, 3}, {-5, 1}, {-5, -1}}).empty()) << "a hole outside";
}

// Where nothing is found in a ring that turns the right way, it is clean; star-shaped rings are.
TEST(Crossings, AgreeWithTheInvariants) {
    std::uint64_t crossing = 0;
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed);
        const auto count = random.whole(3U, 60U);
        const double shake = random.between(0, 0.8);
        Polygons polygon;
        for (std::uint32_t i = 0; i < count; ++i) {
            const elementary::CosSin turn = elementary::cos_sin(2 * elementary::pi * i / count);
            const double radius = random.between(50, 100);
            const Vec off{random.between(-100, 100), random.between(-100, 100)};
            polygon.points.push_back(snap(radius * Vec{turn.cos, turn.sin} + shake * off));
        }
        polygon.end_ring();
        polygon.end_polygon();
        const bool is_clean = found_in(ring_links(0, count), polygon.points).empty() && area(polygon) > 0;
        const std::string flaw = find_flaw(polygon[0]).value_or("");
        if (!is_clean) ++crossing;
        if (is_clean) {
            ASSERT_EQ(flaw, "") << "seed " << seed;
        }
        if (flaw.empty()) {
            ASSERT_TRUE(is_clean) << "seed " << seed;
        }
    }
    if (case_count() >= 100) {
        EXPECT_GT(crossing, case_count() / 10);
        EXPECT_LT(crossing, case_count() * 9 / 10);
    }
}

}  // namespace
}  // namespace filigree
