#include "plane/noise.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/test_cases.h"

namespace filigree {
namespace {

TEST(NoiseField, IsShorterThanOneSteadyAndCentred) {
    CaseRandom random(1);
    Vec sum;
    double squares = 0;
    constexpr int count = 20000;
    NoiseField field(7), other(8);
    double alike = 0;
    for (int i = 0; i < count; ++i) {
        const Vec p{random.between(-300, 300), random.between(-300, 300)};
        const Vec d{random.between(-1e-3, 1e-3), random.between(-1e-3, 1e-3)};
        const Vec value = field.at(p);
        ASSERT_LT(length(value), 1);
        ASSERT_LE(length(field.at(p + d) - value), 16 * length(d));
        sum = sum + value;
        squares += dot(value, value);
        alike += dot(value, other.at(p));
    }
    EXPECT_LT(length(sum) / count, 0.02);
    EXPECT_NEAR(std::sqrt(squares / count), 0.5, 0.05);
    EXPECT_LT(std::fabs(alike) / count, 0.01) << "seeds differ";
}

// The same place has the same noise, whatever was asked before, and crests are about a wavelength apart.
TEST(NoiseField, DependsOnThePlaceAlone) {
    NoiseField warm(3);
    int crossings = 0;
    double before = 0;
    for (int i = 0; i < 4000; ++i) {
        const Vec p{0.05 * i, 0.3};
        NoiseField fresh(3);
        const Vec value = warm.at(p);
        ASSERT_EQ(value, fresh.at(p));
        if (before * value.x < 0) ++crossings;
        before = value.x;
    }
    EXPECT_NEAR(crossings / 2.0, 200, 60);
    EXPECT_EQ(warm.at({1e300, 0}), Vec{});
    EXPECT_EQ(warm.at({NAN, 0}), Vec{});
}

TEST(NoiseField, HasTheSameBitsEverywhere) {
    NoiseField field(1);
    const Vec value = field.at({0.7, -1.3});
    EXPECT_EQ(value.x, 0x1.2e528a642c10cp-2);
    EXPECT_EQ(value.y, -0x1.92bd185ceff1dp-3);
    EXPECT_EQ(noise_along(5, 2.25), -0x1.ab6bdf6bdf6bep-3);
}

TEST(NoiseAlong, StaysWithinOneAndIsSteady) {
    double most = 0;
    for (int i = 0; i < 100000; ++i) {
        const double value = noise_along(9, i * 0.003), next = noise_along(9, i * 0.003 + 1e-4);
        ASSERT_LE(std::fabs(value), 1);
        ASSERT_LE(std::fabs(next - value), 8e-4);
        most = std::max(most, std::fabs(value));
    }
    EXPECT_GT(most, 0.6);
    EXPECT_EQ(noise_along(9, 4), 0) << "between gradients";
    EXPECT_EQ(noise_along(9, INFINITY), 0);
}

}  // namespace
}  // namespace filigree
