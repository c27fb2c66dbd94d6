#include "plane/transform.h"

#include <gtest/gtest.h>

namespace filigree {
namespace {

void expect_near(Vec a, Vec b) {
    EXPECT_NEAR(a.x, b.x, 1e-14);
    EXPECT_NEAR(a.y, b.y, 1e-14);
}

TEST(Transform, AppliesAsSvgWritesIt) {
    EXPECT_EQ(apply({1, 2, 3, 4, 5, 6}, {10, 100}), (Vec{315, 426}));
    EXPECT_EQ(apply({}, {3, 4}), (Vec{3, 4}));
    EXPECT_EQ(apply(translation({5, 6}), {1, 2}), (Vec{6, 8}));
    EXPECT_EQ(apply(scaling(2, -3), {1, 2}), (Vec{2, -6}));
}

TEST(Transform, TurnsFromXToY) {
    EXPECT_EQ(apply(rotation_degrees(90), {1, 0}), (Vec{0, 1}));
    EXPECT_EQ(apply(rotation_degrees(-90), {0, 1}), (Vec{1, 0}));
    EXPECT_EQ(rotation_degrees(360), Transform{});
    expect_near(apply(rotation_degrees(30), {2, 0}), {1.7320508075688772, 1});
    EXPECT_TRUE(is_similarity(compose(rotation_degrees(33), scaling(-2, 2))));
    EXPECT_FALSE(is_similarity(scaling(2, 3)));
}

TEST(Transform, Skews) {
    expect_near(apply(skew_degrees(45, 0), {0, 1}), {1, 1});
    expect_near(apply(skew_degrees(0, 60), {1, 0}), {1, 1.7320508075688772});
    EXPECT_EQ(skew_degrees(0, 0), Transform{});
}

TEST(Transform, ComposesInnerFirst) {
    const Transform outer{1, 2, 3, 4, 5, 6}, inner{-2, 1, 0, 3, 7, 1};
    const Vec p{11, 13};
    EXPECT_EQ(apply(compose(outer, inner), p), apply(outer, apply(inner, p)));
    EXPECT_EQ(determinant(compose(outer, inner)), determinant(outer) * determinant(inner));
    EXPECT_EQ(compose(outer, {}), outer);
    EXPECT_EQ(compose({}, outer), outer);
}

}  // namespace
}  // namespace filigree
