#include "plane/near_points.h"

#include <gtest/gtest.h>

#include "base/test_cases.h"

namespace filigree {
namespace {

TEST(NearPoints, FindsAllThatAreNear) {
    const std::uint64_t count = case_count(300);
    for (std::uint64_t seed = 0; seed < count; ++seed) {
        CaseRandom random(seed);
        std::vector<Vec> points;
        const std::size_t number = random.index(60);
        const double width = random.between(0.01, 100), height = random.coin() ? 0 : random.between(0.01, 100);
        for (std::size_t i = 0; i < number; ++i) {
            points.push_back({random.between(-width, width), random.between(-height, height)});
        }
        const double reach = random.coin() ? random.between(0, 200) : random.between(0, 5);
        const NearPoints near(points, reach);
        for (std::size_t i = 0; i < number; ++i) {
            std::vector<std::uint32_t> expected;
            for (std::uint32_t j = 0; j < number; ++j) {
                if (j != i && length(points[j] - points[i]) <= reach) expected.push_back(j);
            }
            const std::vector<std::uint32_t> found(near.of(i).begin(), near.of(i).end());
            EXPECT_EQ(found, expected) << "seed " << seed;
        }
    }
}

TEST(NearPoints, AreFewWhereTheReachIsTiny) {
    const std::vector<Vec> points{{0, 0}, {1e6, 1e6}, {1e6, 1e6}};
    const NearPoints near(points, 0);
    EXPECT_TRUE(near.of(0).empty());
    ASSERT_EQ(near.of(1).size(), 1U);
    EXPECT_EQ(near.of(1)[0], 2U);
}

}  // namespace
}  // namespace filigree
