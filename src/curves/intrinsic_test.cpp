#include "curves/intrinsic.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/test_cases.h"
#include "curves/along.h"

namespace filigree::curves {
namespace {

void expect_coefficients(const Curvature& found, double A, double B, double C, double D) {
    EXPECT_DOUBLE_EQ(found.A, A);
    EXPECT_DOUBLE_EQ(found.B, B);
    EXPECT_DOUBLE_EQ(found.C, C);
    EXPECT_DOUBLE_EQ(found.D, D);
}

TEST(Intrinsic, ComparesTwoArcsOfDifferentSize) {
    const Curvature first = curvature_of(parabola_element({0, 0}, {1, 0}, {2, 1}));
    const Curvature second = curvature_of(parabola_element({3, 0}, {3, 2}, {1, 4}));
    expect_coefficients(first, 4, 0, 4, 4);
    expect_coefficients(second, 16, 0, 16, 16);
    const auto map = intrinsic_map(first, second);
    ASSERT_TRUE(map);
    EXPECT_DOUBLE_EQ(std::fabs(map->lambda), 0.5);
    EXPECT_DOUBLE_EQ(map->mu[0], 1);
    EXPECT_DOUBLE_EQ(map->mu[1], -1);
    EXPECT_DOUBLE_EQ(map->nu[0], 0);
    EXPECT_DOUBLE_EQ(map->nu[1], 0);
}

TEST(Intrinsic, ComparesPartsOfOneParabola) {
    const Curvature first = curvature_of(parabola_element({-3, 3}, {0, -6}, {3, 3}));
    const Curvature second = curvature_of(parabola_element({1, 1}, {3, -1}, {5, 5}));
    expect_coefficients(first, 1296, -1296, 360, 216);
    expect_coefficients(second, 256, -128, 32, 64);
    const auto map = intrinsic_map(first, second);
    ASSERT_TRUE(map);
    EXPECT_DOUBLE_EQ(std::fabs(map->lambda), 1);
    EXPECT_DOUBLE_EQ(map->mu[0], 1.5);
    EXPECT_DOUBLE_EQ(map->nu[0], -0.5);
    EXPECT_DOUBLE_EQ(map->mu[1], -1.5);
    EXPECT_DOUBLE_EQ(map->nu[1], 1);
}

TEST(Intrinsic, ComparesAMirroredPart) {
    const Element whole = parabola_element({0, 0}, {1, 0}, {2, 1});
    // z -> 2.5 e^(30 degrees i) conj z + 4 - i.
    const Vec m = unit_at_degrees(30) * 2.5;
    const Element part = piece_of(whole, {1.0 / 3, 4.0 / 3}), moved = transformed(part, {m.x, m.y, m.y, -m.x, 4, -1});
    const Vec expected[] = {{5.582265, -0.407229}, {8.163995, 0.121083}, {11.995725, -1.515668}};
    for (std::size_t i = 0; i < 3; ++i) EXPECT_LT(length(moved.at[i] - expected[i]), 1e-6);
    const Curvature first = curvature_of(whole), second = curvature_of(moved);
    EXPECT_NEAR(second.D, -25, 1e-12);
    const auto map = intrinsic_map(first, second);
    ASSERT_TRUE(map);
    EXPECT_NEAR(std::fabs(map->lambda), 0.4, 1e-12);
    EXPECT_NEAR(std::fabs(map->mu[0]), 1, 1e-12);
    EXPECT_NEAR(map->nu[0], -1.0 / 3, 1e-12);
    EXPECT_NEAR(map->nu[1], -1.0 / 3, 1e-12);
    EXPECT_TRUE(along(whole, part, 1e-9));
    EXPECT_FALSE(misfit(whole, part, 0.1));
}

// The maps that the page tells for the first two vectors lay one descriptor onto the other.
TEST(Intrinsic, MapsAreThoseOfThePlane) {
    const Element small = parabola_element({0, 0}, {1, 0}, {2, 1}), large = parabola_element({3, 0}, {3, 2}, {1, 4});
    EXPECT_TRUE(along(small, transformed(large, {0, -0.5, 0.5, 0, 0, 1.5}), 1e-12));
    EXPECT_TRUE(along(small, transformed(large, {0, -0.5, -0.5, 0, 0, 1.5}), 1e-12));
    const Element flower = parabola_element({-3, 3}, {0, -6}, {3, 3}),
                  petal = parabola_element({1, 1}, {3, -1}, {5, 5});
    EXPECT_TRUE(along(flower, transformed(petal, translation({-2, -2})), 1e-12));
    EXPECT_TRUE(along(flower, transformed(petal, {-1, 0, 0, 1, 2, -2}), 1e-12));
    EXPECT_FALSE(along(flower, petal, 1e-3));
}

TEST(Intrinsic, KnowsNoMapOfLines) {
    const Curvature curve = curvature_of(parabola_element({0, 0}, {1, 0}, {2, 1}));
    EXPECT_FALSE(intrinsic_map(curve, curvature_of(parabola_element({0, 0}, {1, 1}, {2, 2}))));
    EXPECT_FALSE(intrinsic_map(curvature_of(parabola_element({0, 0}, {1, 1}, {3, 3})), curve));
}

TEST(Intrinsic, SatisfiesEquationFourForAllParameters) {
    for (std::uint64_t n = 0; n < case_count(1000); ++n) {
        CaseRandom random(first_seed() + n);
        const auto point = [&] { return Vec{random.between(-10, 10), random.between(-10, 10)}; };
        const Curvature first = curvature_of(parabola_element(point(), point(), point()));
        const Curvature second = curvature_of(parabola_element(point(), point(), point()));
        if (std::fabs(first.D) < 1 || std::fabs(second.D) < 1 || first.A < 1 || second.A < 1) continue;
        EXPECT_NEAR(first.B * first.B - 4 * first.A * first.C, -4 * first.D * first.D, 1e-8 * first.A * first.C);
        const auto map = intrinsic_map(first, second);
        ASSERT_TRUE(map);
        for (std::size_t branch = 0; branch < 2; ++branch) {
            for (const double t : {-0.5, 0.0, 0.3, 1.0, 1.7}) {
                const double own = curvature_at(first, t);
                const double other = curvature_at(second, map->mu[branch] * t + map->nu[branch]) / map->lambda;
                EXPECT_NEAR(own, other, 1e-6 * std::fabs(own)) << n;
            }
        }
    }
}

}  // namespace
}  // namespace filigree::curves
