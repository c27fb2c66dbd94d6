#include "plane/mosaic.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/test_cases.h"
#include "plane/inset_test_shapes.h"
#include "plane/verify.h"

namespace filigree {
namespace {

std::uint32_t nearest_site(const std::vector<Vec>& sites, Vec p) {
    std::uint32_t best = 0;
    for (std::uint32_t i = 1; i < sites.size(); ++i) {
        if (length(sites[i] - p) < length(sites[best] - p)) best = i;
    }
    return best;
}

void expect_cells(const Polygons& region, const std::vector<Vec>& sites, CaseRandom& random) {
    const Mosaic cells = mosaic(region[0], sites);
    ASSERT_EQ(cells.sites.size(), cells.pieces.size());
    EXPECT_NEAR(area(cells.pieces), area(region), 1e-9 * area(region));
    for (std::size_t i = 0; i < cells.pieces.size(); ++i) EXPECT_EQ(find_flaw(cells.pieces[i]), std::nullopt);
    EXPECT_EQ(find_overlap(cells.pieces), std::nullopt);
    const Box box = bounds(region);
    const Vec low = to_px(box.min), high = to_px(box.max);
    for (int probe = 0; probe < 200; ++probe) {
        const Vec p{random.between(low.x, high.x), random.between(low.y, high.y)};
        if (locate(region[0], snap(p)) != 1) continue;
        const double least = length(sites[nearest_site(sites, p)] - p);
        for (std::size_t i = 0; i < cells.pieces.size(); ++i) {
            if (locate(cells.pieces[i], snap(p)) != 1) continue;
            EXPECT_LT(length(sites[cells.sites[i]] - p), least + 1e-3);
        }
    }
}

TEST(Mosaic, EveryPlaceGoesToTheNearestSite) {
    const std::uint64_t count = case_count(100);
    for (std::uint64_t seed = 0; seed < count && !::testing::Test::HasFailure(); ++seed) {
        SCOPED_TRACE(seed);
        CaseRandom random(seed);
        const Polygons region = random.coin()
                                    ? test_shapes::wobbly_shape(random, 100, random.whole(8, 60), 6)
                                    : test_shapes::one_polygon({test_shapes::wild_ring(random, {3, 4}, 100, 12)});
        std::vector<Vec> sites;
        const std::uint32_t number = random.below(60) + 1;
        for (std::uint32_t i = 0; i < number; ++i)
            sites.push_back({random.between(-120, 120), random.between(-120, 120)});
        expect_cells(region, sites, random);
    }
}

TEST(Mosaic, LatticesWithManyEqualDistances) {
    CaseRandom random(4);
    const Polygons region = test_shapes::wobbly_shape(random, 100, 50, 5);
    std::vector<Vec> squares, honeycomb;
    for (int x = -12; x <= 12; ++x) {
        for (int y = -12; y <= 12; ++y) {
            squares.push_back({10.0 * x, 10.0 * y});
            honeycomb.push_back({12 * (x + 0.5 * (y & 1)), 12 * 0.8660254037844386 * y});
        }
    }
    expect_cells(region, squares, random);
    expect_cells(region, honeycomb, random);
}

TEST(Mosaic, OfASquareInFour) {
    const Polygons region =
        test_shapes::one_polygon({{snap({0, 0}), snap({100, 0}), snap({100, 100}), snap({0, 100})}});
    const Mosaic cells = mosaic(region[0], std::vector<Vec>{{25, 25}, {75, 25}, {25, 75}, {75, 75}});
    ASSERT_EQ(cells.pieces.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(area(cells.pieces[i]), 2500, 1e-2);
}

TEST(Mosaic, FewSites) {
    const Polygons region = test_shapes::one_polygon({{snap({0, 0}), snap({9, 0}), snap({0, 9})}});
    EXPECT_EQ(mosaic(region[0], {}).pieces, region);
    EXPECT_EQ(mosaic(region[0], std::vector<Vec>{{2, 2}}).pieces, region);
    const Mosaic equal = mosaic(region[0], std::vector<Vec>{{2, 2}, {2, 2}});
    EXPECT_EQ(equal.pieces.size(), 1U);
    EXPECT_EQ(equal.sites[0], 0U);
}

}  // namespace
}  // namespace filigree
