#include "engines/tangle/split_family.h"

#include <gtest/gtest.h>

namespace filigree::tangle {
namespace {

using Values = std::vector<double>;

PolarLayout disc(double radius) { return {.centre = {}, .reach = {0, radius}, .visible = {0, radius}}; }

TEST(SplitFamily, LevelsLieAroundTheMiddleAndLeaveSliversOut) {
    const SplitLevels exact = levels_in({{0, 100}, {0, 100}}, {30});
    EXPECT_EQ(exact.at, (Values{20, 50, 80}));
    EXPECT_EQ(exact.first_strip, -2);
    EXPECT_EQ(levels_in({{0, 100}, {0, 100}, false, true}, {30}).at.size(), 2U);
    EXPECT_EQ(levels_in({{0, 96}, {0, 96}}, {20}).at, (Values{8, 28, 48, 68, 88}));
    EXPECT_EQ(levels_in({{0, 88}, {0, 88}}, {20}).at, (Values{24, 44, 64}));
    EXPECT_TRUE(levels_in({{0, 100}, {0, 100}}, {1e-5}).too_many);
}

TEST(SplitFamily, RingsCountFromTheCentre) {
    EXPECT_EQ(ring_levels(disc(100), {30}).at, (Values{30, 60, 90}));
    EXPECT_EQ(ring_levels(disc(95), {30}).at, (Values{30, 60}));  // no sliver
    EXPECT_EQ(ring_levels(disc(100), {30, 10}).at, (Values{30, 40, 70, 80}));
    EXPECT_EQ(ring_levels(disc(100), {30}).first_strip, 0);
    PolarLayout far = disc(100);
    far.reach = far.visible = {50, 100};
    EXPECT_EQ(ring_levels(far, {30}).at, (Values{60, 90}));
    EXPECT_EQ(ring_levels(far, {30}).first_strip, 1);
    far = disc(100);
    far.fit = true;
    EXPECT_EQ(ring_levels(far, {24}).at, (Values{25, 50, 75}));
}

TEST(SplitFamily, RaysCloseUpEvenly) {
    PolarLayout layout = disc(100);
    layout.first_degrees = 10;
    const Rays rays = rays_of(layout, {31}, 50);  // 10.13 of them
    ASSERT_EQ(rays.degrees.size(), 10U);
    EXPECT_EQ(rays.degrees[0], 10);
    EXPECT_DOUBLE_EQ(rays.degrees[1], 46);
    EXPECT_EQ(rays_of(layout, {1e6}, 50).degrees, (Values{10, 190}));
    EXPECT_EQ(rays_of(layout, {30, 10}, 50).degrees.size(), 16U);
    EXPECT_EQ(rays_of(layout, {1, 1, 1}, 0).degrees.size(), 6U);
}

TEST(SplitFamily, SpiralsHaveTheOffsetsBetweenTheirArms) {
    const Rays two = spiral_of(disc(100), {10});
    EXPECT_EQ(two.degrees, (Values{0, 180}));
    EXPECT_EQ(two.curl, 18);
    const Rays three = spiral_of(disc(100), {10, 20, 10});
    EXPECT_EQ(three.degrees, (Values{0, 90, 270}));
    EXPECT_EQ(three.curl, 9);
    PolarLayout fitted = disc(105);
    fitted.fit = true;
    EXPECT_EQ(spiral_of(fitted, {10}).curl, 360 / 21.0);
}

}  // namespace
}  // namespace filigree::tangle
