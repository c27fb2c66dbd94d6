#include "space/convex_parts.h"

#include <gtest/gtest.h>

#include "space/mesh.h"
#include "space/space_cases.h"

namespace filigree {
namespace {

std::vector<std::vector<Vec3>> rings_of(const ConvexParts& parts, const std::vector<Vec3>& ring) {
    std::vector<std::vector<Vec3>> rings;
    std::uint32_t begin = 0;
    for (const std::uint32_t end : parts.ends) {
        rings.emplace_back();
        for (; begin < end; ++begin) rings.back().push_back(ring[parts.corners[begin]]);
    }
    return rings;
}

TEST(ConvexParts, CoverStarsWithoutOverlap) {
    std::size_t parted = 0;
    for (std::uint64_t number = 0; number < case_count(); ++number) {
        SCOPED_TRACE(number);
        CaseRandom random(number);
        const Frame3 frame = random_frame(random);
        const std::vector<Vec3> ring = random_star(random, random_vector(random, 100), frame, random.between(0.01, 50));
        const ConvexParts parts = convex_parts(ring, 1e-9);
        EXPECT_TRUE(parts.is_whole);
        const double all = length(doubled_area(ring));
        double sum = 0;
        for (const std::vector<Vec3>& part : rings_of(parts, ring)) {
            const Vec3 area = doubled_area(part);
            EXPECT_GT(dot(area, frame.heading), 0);
            sum += length(area);
            for (std::size_t i = 0; i < part.size(); ++i) {
                const Vec3 a = part[i], b = part[(i + 1) % part.size()], c = part[(i + 2) % part.size()];
                EXPECT_GE(dot(cross(b - a, c - b), frame.heading), -1e-6 * all) << "convex";
            }
        }
        EXPECT_NEAR(sum, all, 1e-7 * all) << "parts of one direction that add up do not overlap";
        parted += parts.ends.size() > 1 ? 1 : 0;
    }
    EXPECT_GT(parted, case_count() / 2);
}

TEST(ConvexParts, KnowWhatIsConvexAndFlat) {
    const std::vector<Vec3> square = {{0, 0, 5}, {2, 0, 5}, {2, 2, 5}, {0, 2, 5}};
    EXPECT_EQ(convex_parts(square, 0).corners, (std::vector<std::uint32_t>{0, 1, 2, 3}));
    std::vector<Vec3> bent = square;
    bent[2].z = 5.5;
    EXPECT_EQ(convex_parts(bent, 1).ends.size(), 1U);
    EXPECT_EQ(convex_parts(bent, 0.01).ends.size(), 2U);
    EXPECT_FALSE(convex_parts(bent, 0.01).is_whole);
    const std::vector<Vec3> in_line = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
    EXPECT_EQ(convex_parts(in_line, 0).ends.size(), 1U);
}

TEST(ConvexParts, EndWhereTheyAreCancelled) {
    std::vector<Vec3> comb;  // teeth upwards
    for (int i = 0; i < 2000; ++i) comb.push_back({-i / 2.0, i % 2 == 0 ? 0.0 : 9.0, 0});
    comb.push_back({-1000, -1, 0});
    comb.push_back({0, -1, 0});
    EXPECT_EQ(convex_parts(comb, 0).ends.size(), 2000U);
    const std::atomic<bool> is_cancelled = true;
    EXPECT_LT(convex_parts(comb, 0, {&is_cancelled, {}}).ends.size(), 300U);
}

TEST(ConvexParts, EndForWhatIsNoPolygon) {
    const auto at = [](double turn) {
        const elementary::CosSin to = elementary::cos_sin_degrees(turn);
        return Vec3{to.cos, to.sin, 0};
    };
    EXPECT_FALSE(convex_parts(std::vector{at(0), at(144), at(288), at(72), at(216)}, 0).is_whole) << "a pentagram";
    EXPECT_TRUE(convex_parts(std::vector{at(0), at(0), at(0)}, 0).ends.empty());
    EXPECT_TRUE(convex_parts(std::vector{at(0), at(90)}, 0).ends.empty());
    const ConvexParts spike =
        convex_parts(std::vector<Vec3>{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {2, 5, 0}, {2, 2, 0}, {0, 2, 0}}, 0);
    double area = 0;
    for (const auto& part : rings_of(spike, {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {2, 5, 0}, {2, 2, 0}, {0, 2, 0}})) {
        area += length(doubled_area(part)) / 2;
    }
    EXPECT_EQ(area, 4);
}

}  // namespace
}  // namespace filigree
