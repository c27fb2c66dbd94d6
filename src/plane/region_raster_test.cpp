#include "plane/region_raster.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/test_cases.h"
#include "plane/edge_tree.h"
#include "plane/inset_test_shapes.h"
#include "plane/test_rings.h"

namespace filigree {
namespace {

TEST(RegionRaster, HoldsTheCellsWhoseMiddlesLieInside) {
    const std::uint64_t count = case_count(300);
    for (std::uint64_t seed = 0; seed < count; ++seed) {
        SCOPED_TRACE(seed);
        CaseRandom random(seed);
        const Polygons region = test_shapes::wobbly_shape(random, 40, random.whole(5, 80), 6);
        const auto raster = RegionRaster::of(region[0], random.between(0.7, 9), 1U << 20);
        ASSERT_TRUE(raster);
        std::uint64_t inside = 0;
        for (std::uint32_t i = 0; i < raster->size(); ++i) {
            inside += raster->is_inside(i);
            EXPECT_EQ(raster->is_inside(i), locate(region[0], snap(raster->centre(i))) == 1) << i;
            EXPECT_EQ(raster->index_of(raster->centre(i)), i);
        }
        EXPECT_EQ(inside, raster->inside_count());
        std::uint64_t in_runs = 0;
        for (const RegionRaster::Run& run : raster->runs()) in_runs += run.end - run.begin;
        EXPECT_EQ(inside, in_runs);
    }
}

TEST(RegionRaster, KnowsHowFarTheBorderIs) {
    CaseRandom random(3);
    const Polygons region = test_shapes::wobbly_shape(random, 100, 200, 6);
    const auto raster = RegionRaster::of(region[0], 2, 1U << 20);
    const EdgeTree border(edges_of(region[0], Point{0, 0}));
    for (const RegionRaster::Run& run : raster->runs()) {
        for (std::uint32_t i = run.begin; i < run.end; ++i) {
            const double distance = border.place(raster->centre(i), 1e3, 1e3).distance;
            EXPECT_NEAR(raster->border_distance(i), distance, 2 + 0.07 * distance);
        }
    }
}

TEST(RegionRaster, DoesNotDependOnRingsOrOnWhatIsFarAway) {
    CaseRandom random(9);
    const Polygons region = test_shapes::wobbly_shape(random, 100, 60, 6);
    const Polygons turned = with_rings_turned(region);
    const auto a = RegionRaster::of(region[0], 3, 1U << 20), b = RegionRaster::of(turned[0], 3, 1U << 20);
    for (std::uint32_t i = 0; i < a->size(); ++i) EXPECT_EQ(a->border(i), b->border(i));

    const auto square = [](Vec low, Vec high) {
        return test_shapes::one_polygon({{snap(low), snap({high.x, low.y}), snap(high), snap({low.x, high.y})}});
    };
    const Polygons small = square({-10, -10}, {50, 50}), large = square({-300, -10}, {50, 70});
    const auto c = RegionRaster::of(small[0], 3, 1U << 20), d = RegionRaster::of(large[0], 3, 1U << 20);
    for (double x = 0; x < 45; x += 1.3) {
        const std::uint32_t i = c->index_of({x, 20}), j = d->index_of({x, 20});
        EXPECT_EQ(c->address(i), d->address(j));
        EXPECT_EQ(c->centre(i), d->centre(j));
    }
}

TEST(RegionRaster, RefusesWhatIsTooLarge) {
    const Polygons region = test_shapes::one_polygon({{snap({0, 0}), snap({100, 0}), snap({0, 100})}});
    EXPECT_TRUE(RegionRaster::of(region[0], 10, 200));
    EXPECT_FALSE(RegionRaster::of(region[0], 1, 200));
    EXPECT_FALSE(RegionRaster::of(region[0], 1e-300, UINT64_MAX));
    EXPECT_FALSE(RegionRaster::of(region[0], 0, 200));
    EXPECT_FALSE(RegionRaster::of(PolygonView{}, 1, 200));
}

}  // namespace
}  // namespace filigree
