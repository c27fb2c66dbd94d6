#include "base/elementary.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include "base/random.h"
#include "base/test_cases.h"

namespace filigree::elementary {
namespace {

static_assert(LDBL_MANT_DIG >= 64, "the oracle needs more digits than what it checks");

constexpr double infinity = std::numeric_limits<double>::infinity();
const double not_a_number = std::numeric_limits<double>::quiet_NaN();
const long double long_pi = std::acos(-1.0L);

double unit_in_last_place(double value) {
    const double size = std::fabs(value);
    if (size < 0x1p-1021) return 0x1p-1074;
    int exponent = 0;
    std::frexp(size, &exponent);
    return std::ldexp(1.0, exponent - 53);
}

double ulps_off(double got, long double wanted) {
    if (std::isnan(got) || std::isnan(wanted)) return std::isnan(got) && std::isnan(wanted) ? 0 : infinity;
    const double rounded = static_cast<double>(wanted);
    if (std::isinf(got) || std::isinf(rounded)) return got == rounded ? 0 : infinity;
    return static_cast<double>(std::fabs((got - wanted) / unit_in_last_place(rounded)));
}

// Draws `points` arguments from `draw`, and checks that `ours` is within `limit` ulp of `oracle`.
template <class Draw, class Ours, class Oracle>
void expect_close(const char* name, double limit, Draw draw, Ours ours, Oracle oracle) {
    double worst = 0, worst_x = 0;
    std::uint64_t worst_case = 0;
    const std::uint64_t points = 30 * case_count();
    for (std::uint64_t i = 1; i <= points; ++i) {
        CaseRandom random(i);
        const double x = draw(random);
        const double off = ulps_off(ours(x), oracle(static_cast<long double>(x)));
        if (!(off <= worst)) {
            worst = off;
            worst_x = x;
            worst_case = i;
        }
    }
    EXPECT_LE(worst, limit) << name << " case " << worst_case << " x = " << to_text(worst_x);
    ::testing::Test::RecordProperty(name, std::to_string(worst));
}

auto uniform(double low, double high) {
    return [=](CaseRandom& random) { return random.between(low, high); };
}
// Uniform in the exponent, of either sign.
auto any_size(int least_exponent, int greatest_exponent) {
    return [=](CaseRandom& random) {
        const double mantissa = random.between(1, 2) * (random.below(2) == 0 ? 1 : -1);
        return std::ldexp(mantissa, least_exponent + static_cast<int>(random.below(static_cast<std::uint32_t>(
                                                         greatest_exponent - least_exponent))));
    };
}
auto near_to(double centre, int least_exponent) {
    return [=](CaseRandom& random) {
        const double size = std::ldexp(
            random.between(0.5, 1), -static_cast<int>(random.below(static_cast<std::uint32_t>(-least_exponent))) - 2);
        return centre + (random.below(2) == 0 ? size : -size);
    };
}
// The doubles nearest to multiples of pi/2, where reduction cancels most.
double near_quarter_turn(CaseRandom& random) {
    const std::uint64_t count = random.below(636'000'000) >> random.below(29);
    return static_cast<double>(static_cast<long double>(count) * (long_pi / 2)) * (random.below(2) == 0 ? 1 : -1);
}

double sine(double x) { return cos_sin(x).sin; }
double cosine(double x) { return cos_sin(x).cos; }
long double long_sin(long double x) { return std::sin(x); }
long double long_cos(long double x) { return std::cos(x); }
long double long_tan(long double x) { return std::tan(x); }

TEST(Elementary, CosSinIsAccurate) {
    expect_close("sin_small", 1, uniform(-0.8, 0.8), sine, long_sin);
    expect_close("cos_small", 1, uniform(-0.8, 0.8), cosine, long_cos);
    expect_close("sin_usual", 1, uniform(-10, 10), sine, long_sin);
    expect_close("cos_usual", 1, uniform(-10, 10), cosine, long_cos);
    expect_close("sin_any", 1, any_size(-1000, 29), sine, long_sin);
    expect_close("cos_any", 1, any_size(-1000, 29), cosine, long_cos);
    expect_close("sin_hard", 1, near_quarter_turn, sine, long_sin);
    expect_close("cos_hard", 1, near_quarter_turn, cosine, long_cos);
}

TEST(Elementary, CosSinKnowsItsRange) {
    EXPECT_EQ(cos_sin(0).cos, 1);
    EXPECT_EQ(cos_sin(0).sin, 0);
    EXPECT_LE(ulps_off(sine(1e9), std::sin(1e9L)), 1);
    EXPECT_LE(ulps_off(cosine(-1e9), std::cos(-1e9L)), 1);
    for (const double x : {1.1e9, -1.1e9, 1e300, infinity, -infinity, not_a_number}) {
        EXPECT_TRUE(std::isnan(cos_sin(x).cos));
        EXPECT_TRUE(std::isnan(cos_sin(x).sin));
        EXPECT_TRUE(std::isnan(elementary::tan(x)));
    }
    EXPECT_EQ(sine(5e-324), 5e-324);
    EXPECT_EQ(elementary::tan(5e-324), 5e-324);
}

TEST(Elementary, CosSinLiesOnTheCircle) {
    for (std::uint64_t i = 1; i <= 10 * case_count(); ++i) {
        CaseRandom random(i);
        const double x = any_size(-40, 29)(random);
        const CosSin at = cos_sin(x), opposite = cos_sin(-x);
        ASSERT_NEAR(at.cos * at.cos + at.sin * at.sin, 1, 4e-16) << "case " << i;
        ASSERT_EQ(opposite.cos, at.cos) << "case " << i;
        ASSERT_EQ(opposite.sin, -at.sin) << "case " << i;
        ASSERT_LE(std::fabs(at.cos), 1) << "case " << i;
        ASSERT_LE(std::fabs(at.sin), 1) << "case " << i;
    }
}

TEST(Elementary, DegreesAreExactWhereTheyCanBe) {
    constexpr std::array<CosSin, 4> quarter_turns = {CosSin{1, 0}, CosSin{0, 1}, CosSin{-1, 0}, CosSin{0, -1}};
    for (int k = -4000; k <= 4000; ++k) {
        const CosSin at = cos_sin_degrees(90.0 * k);
        const CosSin& wanted = quarter_turns[static_cast<std::size_t>(k & 3)];
        ASSERT_EQ(at.cos, wanted.cos) << k;
        ASSERT_EQ(at.sin, wanted.sin) << k;
        ASSERT_FALSE(std::signbit(at.cos) && at.cos == 0) << k;
        ASSERT_FALSE(std::signbit(at.sin) && at.sin == 0) << k;
    }
    for (int k = -100; k <= 100; ++k) {
        const double turns = 360.0 * k;
        EXPECT_EQ(cos_sin_degrees(60 + turns).cos, 0.5);
        EXPECT_EQ(cos_sin_degrees(120 + turns).cos, -0.5);
        EXPECT_EQ(cos_sin_degrees(240 + turns).cos, -0.5);
        EXPECT_EQ(cos_sin_degrees(300 + turns).cos, 0.5);
        EXPECT_EQ(cos_sin_degrees(30 + turns).sin, 0.5);
        EXPECT_EQ(cos_sin_degrees(150 + turns).sin, 0.5);
        EXPECT_EQ(cos_sin_degrees(210 + turns).sin, -0.5);
        EXPECT_EQ(cos_sin_degrees(330 + turns).sin, -0.5);
        EXPECT_EQ(cos_sin_degrees(45 + turns).cos, cos_sin_degrees(45 + turns).sin);
        EXPECT_EQ(cos_sin_degrees(135 + turns).cos, -cos_sin_degrees(135 + turns).sin);
    }
    EXPECT_EQ(cos_sin_degrees(45).cos, std::sqrt(0.5));
    EXPECT_EQ(cos_sin_degrees(90e12).cos, 1);
    EXPECT_EQ(cos_sin_degrees(90e12 + 90).sin, 1);
    EXPECT_EQ(cos_sin_degrees(0x1p1023).cos, cos_sin_degrees(std::fmod(0x1p1023, 360)).cos);
    for (const double x : {infinity, -infinity, not_a_number}) EXPECT_TRUE(std::isnan(cos_sin_degrees(x).sin));
}

// The angle less whole quarter turns, exactly, so that the oracle's own rounding stays small near the axes.
long double degrees_oracle(long double degrees, int quarters_ahead) {
    const long double quarters = std::nearbyint(degrees / 90);
    const long double rest = (degrees - 90 * quarters) * long_pi / 180;
    switch ((static_cast<std::int64_t>(quarters) + quarters_ahead) & 3) {
        case 0:
            return std::sin(rest);
        case 1:
            return std::cos(rest);
        case 2:
            return -std::sin(rest);
        default:
            return -std::cos(rest);
    }
}

TEST(Elementary, DegreesAreAccurate) {
    const auto sine_of = [](double x) { return cos_sin_degrees(x).sin; };
    const auto cosine_of = [](double x) { return cos_sin_degrees(x).cos; };
    const auto long_sine_of = [](long double x) { return degrees_oracle(x, 0); };
    const auto long_cosine_of = [](long double x) { return degrees_oracle(x, 1); };
    expect_close("sin_degrees", 1, uniform(-720, 720), sine_of, long_sine_of);
    expect_close("cos_degrees", 1, uniform(-720, 720), cosine_of, long_cosine_of);
    expect_close("sin_degrees_any", 1, any_size(-60, 40), sine_of, long_sine_of);
    expect_close("cos_degrees_any", 1, any_size(-60, 40), cosine_of, long_cosine_of);
    const auto whole = [](CaseRandom& random) { return static_cast<double>(random.below(1'000'000)) - 500'000; };
    expect_close("sin_degrees_whole", 1, whole, sine_of, long_sine_of);
    expect_close("cos_degrees_whole", 1, whole, cosine_of, long_cosine_of);
    EXPECT_LE(ulps_off(sine_of(1e-310), 1e-310L * long_pi / 180), 1);
}

TEST(Elementary, TangentIsAccurate) {
    expect_close("tan_usual", 1.5, uniform(-10, 10), elementary::tan, long_tan);
    expect_close("tan_any", 1.5, any_size(-1000, 29), elementary::tan, long_tan);
    expect_close("tan_hard", 1.5, near_quarter_turn, elementary::tan, long_tan);
}

TEST(Elementary, ArcTangentIsAccurate) {
    const auto oracle = [](long double x) { return std::atan(x); };
    expect_close("atan_usual", 1.5, uniform(-3, 3), elementary::atan, oracle);
    expect_close("atan_any", 1.5, any_size(-1070, 1023), elementary::atan, oracle);
    for (int i = 0; i <= 40; ++i) {  // where its pieces meet
        const double edge = (i + 0.5) / 16;
        for (const double x : {edge, std::nextafter(edge, 0), 1 / edge, 0.0625, std::nextafter(0.0625, 0)}) {
            EXPECT_LE(ulps_off(elementary::atan(x), std::atan(static_cast<long double>(x))), 1.5) << to_text(x);
        }
    }
    EXPECT_EQ(elementary::atan(infinity), pi / 2);
    EXPECT_EQ(elementary::atan(-infinity), -pi / 2);
    EXPECT_EQ(elementary::atan(1), pi / 4);
    EXPECT_EQ(elementary::atan(0), 0);
    EXPECT_TRUE(std::isnan(elementary::atan(not_a_number)));
}

TEST(Elementary, ArcTangentOfTwoIsAccurate) {
    for (std::uint64_t i = 1; i <= 30 * case_count(); ++i) {
        CaseRandom random(i);
        const int width = i % 2 == 0 ? 4 : 1000;
        const double y = any_size(-width, width)(random), x = any_size(-width, width)(random);
        const double angle = elementary::atan2(y, x);
        ASSERT_LE(ulps_off(angle, std::atan2(static_cast<long double>(y), static_cast<long double>(x))), 1.5)
            << "case " << i << ": " << to_text(y) << ", " << to_text(x);
        ASSERT_EQ(elementary::atan2(-y, x), -angle) << "case " << i;
        ASSERT_LE(std::fabs(angle), pi) << "case " << i;
    }
    for (const double tiny : {5e-324, 3e-320, 1e-308, 1e-290}) {
        EXPECT_EQ(elementary::atan2(tiny, tiny), pi / 4);
        EXPECT_EQ(elementary::atan2(tiny, -tiny), 3 * pi / 4);
    }
    constexpr double small = 9 * 0x1p-1074, larger = 25 * 0x1p-1074;
    EXPECT_LE(ulps_off(elementary::atan2(small, larger), std::atan2(9.0L, 25.0L)), 0.6);
    EXPECT_EQ(elementary::atan2(1.7e308, 1.7e308), pi / 4);
    EXPECT_LE(ulps_off(elementary::atan2(1.2e308, 1.7e308), std::atan2(1.2e308L, 1.7e308L)), 1.5);
}

TEST(Elementary, ArcTangentOfTwoHasItsEdgeCases) {
    EXPECT_EQ(elementary::atan2(0, 0), 0);
    EXPECT_EQ(elementary::atan2(0, 1), 0);
    EXPECT_EQ(elementary::atan2(0, -1), pi);
    EXPECT_EQ(elementary::atan2(-0.0, -1), pi);
    EXPECT_EQ(elementary::atan2(1, 0), pi / 2);
    EXPECT_EQ(elementary::atan2(-1, 0), -pi / 2);
    EXPECT_EQ(elementary::atan2(1, -1), 3 * pi / 4);
    EXPECT_EQ(elementary::atan2(infinity, infinity), pi / 4);
    EXPECT_EQ(elementary::atan2(infinity, -infinity), 3 * pi / 4);
    EXPECT_EQ(elementary::atan2(-infinity, 5), -pi / 2);
    EXPECT_EQ(elementary::atan2(5, infinity), 0);
    EXPECT_EQ(elementary::atan2(5, -infinity), pi);
    EXPECT_TRUE(std::isnan(elementary::atan2(not_a_number, 1)));
    EXPECT_TRUE(std::isnan(elementary::atan2(1, not_a_number)));
}

TEST(Elementary, ArcSineAndArcCosineAreAccurate) {
    const auto long_asin = [](long double x) { return std::asin(x); };
    const auto long_acos = [](long double x) { return std::acos(x); };
    for (const auto& [name, sign] : {std::pair{"at_1", 1.0}, std::pair{"at_-1", -1.0}}) {
        const auto near_end = [end = sign](CaseRandom& random) {
            return end * (1 - std::ldexp(random.between(0.5, 1), -static_cast<int>(random.below(53))));
        };
        expect_close((std::string("asin_") + name).c_str(), 1.5, near_end, elementary::asin, long_asin);
        expect_close((std::string("acos_") + name).c_str(), 1.5, near_end, elementary::acos, long_acos);
    }
    expect_close("asin", 1.5, uniform(-1, 1), elementary::asin, long_asin);
    expect_close("acos", 1.5, uniform(-1, 1), elementary::acos, long_acos);
    expect_close("asin_any", 1.5, any_size(-1070, -1), elementary::asin, long_asin);
    expect_close("acos_any", 1.5, any_size(-1070, -1), elementary::acos, long_acos);
    EXPECT_EQ(elementary::asin(0), 0);
    EXPECT_EQ(elementary::asin(1), pi / 2);
    EXPECT_EQ(elementary::asin(-1), -pi / 2);
    EXPECT_EQ(elementary::acos(1), 0);
    EXPECT_EQ(elementary::acos(0), pi / 2);
    EXPECT_EQ(elementary::acos(-1), pi);
    for (const double x : {1.0000000000000002, -1.0000000000000002, infinity, not_a_number}) {
        EXPECT_TRUE(std::isnan(elementary::asin(x)));
        EXPECT_TRUE(std::isnan(elementary::acos(x)));
    }
}

TEST(Elementary, ExponentialIsAccurate) {
    const auto oracle = [](long double x) { return std::exp(x); };
    expect_close("exp_usual", 1, uniform(-1, 1), elementary::exp, oracle);
    expect_close("exp_any", 1, uniform(-708, 709.78), elementary::exp, oracle);
    expect_close("exp_tiny_results", 1.1, uniform(-746, -700), elementary::exp, oracle);
    expect_close("exp_tiny", 1, any_size(-1070, 0), elementary::exp, oracle);
    EXPECT_EQ(elementary::exp(0), 1);
    EXPECT_EQ(elementary::exp(709.8), infinity);
    EXPECT_LT(elementary::exp(709.782712893383), infinity);
    EXPECT_EQ(elementary::exp(infinity), infinity);
    EXPECT_EQ(elementary::exp(-746), 0);
    EXPECT_EQ(elementary::exp(-infinity), 0);
    EXPECT_TRUE(std::isnan(elementary::exp(not_a_number)));
}

TEST(Elementary, LogarithmIsAccurate) {
    const auto oracle = [](long double x) { return std::log(x); };
    const auto any = [](CaseRandom& random) { return std::fabs(any_size(-1074, 1023)(random)); };
    expect_close("log_any", 0.501, any, elementary::log, oracle);
    expect_close("log_usual", 0.501, uniform(0.25, 4), elementary::log, oracle);
    expect_close("log_at_1", 0.501, near_to(1, -50), elementary::log, oracle);
    EXPECT_EQ(elementary::log(1), 0);
    EXPECT_EQ(elementary::log(0), -infinity);
    EXPECT_EQ(elementary::log(-0.0), -infinity);
    EXPECT_EQ(elementary::log(infinity), infinity);
    EXPECT_TRUE(std::isnan(elementary::log(-1)));
    EXPECT_TRUE(std::isnan(elementary::log(not_a_number)));
    EXPECT_LE(ulps_off(elementary::log(5e-324), std::log(4.94065645841246544177e-324L)), 0.501);
    EXPECT_LE(ulps_off(elementary::log(DBL_MAX), std::log(static_cast<long double>(DBL_MAX))), 0.501);
}

TEST(Elementary, PowerIsAccurate) {
    for (const double exponent : {2.0, 3.0, 0.5, -1.0, -2.5, 10.0, 100.0, 0.1, 1e-5, 1 / 3.0, 1e8}) {
        const double reach = std::fmin(700, 700 / std::fabs(exponent));
        expect_close(("power_" + to_text(exponent)).c_str(), 1,
                     [=](CaseRandom& random) { return std::exp(random.between(-reach, reach)); },
                     [=](double x) { return power(x, exponent); },
                     [=](long double x) { return std::pow(x, static_cast<long double>(exponent)); });
    }
    for (std::uint64_t i = 1; i <= 30 * case_count(); ++i) {
        CaseRandom random(i);
        const double base = std::fabs(any_size(-1000, 1000)(random));
        const double reach = 745 / std::fabs(std::log(base));
        const double exponent = random.between(-reach, reach);
        const long double wanted = std::pow(static_cast<long double>(base), static_cast<long double>(exponent));
        ASSERT_LE(ulps_off(power(base, exponent), wanted), 1.1)
            << "case " << i << ": " << to_text(base) << ", " << to_text(exponent);
    }
}

TEST(Elementary, WholePowersOfWholeNumbersAreExact) {
    for (std::uint64_t base = 2; base <= 3000; ++base) {
        std::uint64_t product = 1;
        for (int exponent = 1; product <= (std::uint64_t{1} << 53) / base; ++exponent) {
            product *= base;
            const double wanted = static_cast<double>(product);
            ASSERT_EQ(power(static_cast<double>(base), exponent), wanted) << base << "^" << exponent;
            ASSERT_EQ(power(-static_cast<double>(base), exponent), exponent % 2 == 0 ? wanted : -wanted);
            if (exponent == 2) {
                ASSERT_EQ(power(wanted, 0.5), static_cast<double>(base));
            }
            if (exponent == 3) {
                ASSERT_EQ(elementary::cbrt(wanted), static_cast<double>(base));
            }
        }
    }
    for (int k = -1074; k <= 1023; ++k) ASSERT_EQ(power(2, k), std::ldexp(1.0, k)) << k;
}

TEST(Elementary, PowerHasTheEdgeCasesOfTheStandard) {
    const double values[] = {0.0,
                             -0.0,
                             1,
                             -1,
                             2,
                             -2,
                             0.5,
                             -0.5,
                             3,
                             -3,
                             1.5,
                             -1.5,
                             1e10,
                             1e300,
                             -1e300,
                             1e-300,
                             5e-324,
                             -5e-324,
                             1e19,
                             9007199254740993.0,
                             4503599627370497.5,
                             infinity,
                             -infinity,
                             not_a_number};
    for (const double base : values) {
        for (const double exponent : values) {
            const double wanted = std::pow(base, exponent), got = power(base, exponent);
            const std::string what = to_text(base) + (std::signbit(base) ? " (-) ^ " : " ^ ") + to_text(exponent);
            if (std::isnan(wanted) || std::isinf(wanted) || wanted == 0) {
                EXPECT_EQ(std::isnan(got), std::isnan(wanted)) << what;
                if (!std::isnan(wanted)) {
                    EXPECT_EQ(got, wanted) << what;
                }
            } else {
                EXPECT_LE(ulps_off(got, wanted), 1.1) << what;
            }
            if (!std::isnan(wanted)) {
                EXPECT_EQ(std::signbit(got), std::signbit(wanted)) << what;
            }
        }
    }
}

TEST(Elementary, CubeRootIsAccurate) {
    const auto oracle = [](long double x) { return std::cbrt(x); };
    expect_close("cbrt_usual", 0.501, uniform(-8, 8), elementary::cbrt, oracle);
    expect_close("cbrt_any", 0.501, any_size(-1074, 1023), elementary::cbrt, oracle);
    EXPECT_EQ(elementary::cbrt(0), 0);
    EXPECT_EQ(elementary::cbrt(-27), -3);
    EXPECT_EQ(elementary::cbrt(infinity), infinity);
    EXPECT_EQ(elementary::cbrt(-infinity), -infinity);
    EXPECT_TRUE(std::isnan(elementary::cbrt(not_a_number)));
    for (std::uint64_t i = 1; i <= case_count(); ++i) {
        const double root = static_cast<double>(mix(i) >> 47);
        ASSERT_EQ(elementary::cbrt(root * root * root), root) << "case " << i;
    }
}

// Far steps never turn back; what lies closer together than rounding errors may.
template <class Function>
void expect_rising(const char* name, double from, double to, Function function) {
    const int steps = 20'000;
    double last = function(from);
    for (int i = 1; i <= steps; ++i) {
        const double x = from + (to - from) * i / steps;
        const double value = function(x);
        ASSERT_GE(value, last) << name << " at " << to_text(x);
        last = value;
    }
}

TEST(Elementary, FunctionsRiseWhereTheyShould) {
    expect_rising("sin", -pi / 2, pi / 2, sine);
    expect_rising("-cos", 0, pi, [](double x) { return -cosine(x); });
    expect_rising("tan", -1.57, 1.57, elementary::tan);
    expect_rising("sin degrees", -90, 90, [](double x) { return cos_sin_degrees(x).sin; });
    expect_rising("atan", -5, 5, elementary::atan);
    expect_rising("atan2", -pi + 1e-9, pi, [](double x) { return elementary::atan2(std::sin(x), std::cos(x)); });
    expect_rising("asin", -1, 1, elementary::asin);
    expect_rising("-acos", -1, 1, [](double x) { return -elementary::acos(x); });
    expect_rising("exp", -745, 709, elementary::exp);
    expect_rising("log", 1e-300, 10, elementary::log);
    expect_rising("power", 1e-300, 10, [](double x) { return power(x, 1.7); });
    expect_rising("cbrt", -10, 10, elementary::cbrt);
}

TEST(Elementary, InversesGoBack) {
    for (std::uint64_t i = 1; i <= 10 * case_count(); ++i) {
        CaseRandom random(i);
        const double angle = random.between(-pi, pi), length = random.between(0.01, 100);
        const CosSin at = cos_sin(angle);
        ASSERT_NEAR(elementary::atan2(length * at.sin, length * at.cos), angle, 2e-15) << "case " << i;
        const double x = std::fabs(any_size(-1000, 1000)(random));
        ASSERT_NEAR(elementary::exp(elementary::log(x)) / x, 1, 1e-13) << "case " << i;
        const double root = elementary::cbrt(x);
        ASSERT_NEAR(root * root * root / x, 1, 1e-15) << "case " << i;
    }
}

// The bits themselves, so that a change of compiler, options or library shows.
TEST(Elementary, BitsNeverChange) {
    std::uint64_t hash = 0;
    const auto add = [&](double value) { hash = fold(hash, std::bit_cast<std::uint64_t>(value)); };
    for (std::uint64_t i = 1; i <= 1000; ++i) {
        std::uint64_t drawn = 0;  // not by CaseRandom, for the recorded hash must not change with it
        const auto between = [&](double low, double high) {
            return low + (high - low) * to_unit(random_bits(i, Key{}, std::uint64_t{0}, ++drawn));
        };
        const double angle = between(-100, 100), far = between(-1e9, 1e9);
        const double unit = between(-1, 1), positive = between(0.001, 50);
        add(cos_sin(angle).cos);
        add(cos_sin(far).sin);
        add(cos_sin_degrees(angle).sin);
        add(elementary::tan(angle));
        add(elementary::atan(angle));
        add(elementary::atan2(angle, positive));
        add(elementary::asin(unit));
        add(elementary::acos(unit));
        add(elementary::exp(angle));
        add(elementary::log(positive));
        add(power(positive, unit * 9));
        add(elementary::cbrt(angle));
    }
    EXPECT_EQ(to_hex(hash), "74ac67c7cb893dd2");
}

}  // namespace
}  // namespace filigree::elementary
