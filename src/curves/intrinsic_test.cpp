#include "curves/intrinsic.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/test_cases.h"

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
