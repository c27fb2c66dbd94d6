// Trigonometry and its inverses. The polynomials are minimax fits made for the reduced ranges.
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/elementary.h"
#include "base/exact_sum.h"

namespace filigree::elementary {

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double greatest_angle = 1e9;

// Adding and taking away this rounds to whole numbers, whose lowest bits then stand in the mantissa.
constexpr double rounder = 0x1.8p52;

// pi/2 in pieces of 23 bits, so that their products with whole numbers below 2^30 are exact, with what is
// left after three and after four of them.
constexpr double half_pi_1 = 0x1.921fb4p+0, half_pi_2 = 0x1.4442dp-24, half_pi_3 = 0x1.84698p-48,
                 half_pi_4 = 0x1.3198ap-69;
constexpr double half_pi_after_3 = 0x1.3198a2e037073p-69, half_pi_after_4 = 0x1.701b839a25205p-92;
constexpr double two_over_pi = 0x1.45f306dc9c883p-1;
constexpr ExactSum half_pi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
constexpr ExactSum whole_pi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};

constexpr double radians_per_degree = 0x1.1df46a2529d39p-6;
constexpr double radians_per_degree_high = 0x1.1df46ap-6, radians_per_degree_low = 0x1.294e9c8ae0ec6p-33;

// An angle less a whole number of quarter turns: within about +-pi/4.
struct Reduced {
    ExactSum angle;
    std::uint64_t quarters = 0;  // the lowest two bits count
};

// Near a multiple of pi/2 almost all digits cancel, and the fourth piece is needed.
[[gnu::noinline]] ExactSum reduce_closely(double rest, double count) {
    const ExactSum third = two_sum(rest, -(count * half_pi_3));
    const ExactSum fourth = two_sum(third.high, -(count * half_pi_4));
    return fast_two_sum(fourth.high, (third.low + fourth.low) - count * half_pi_after_4);
}

inline Reduced reduce(double radians) {
    const double shifted = radians * two_over_pi + rounder;
    const double count = shifted - rounder;
    const std::uint64_t quarters = std::bit_cast<std::uint64_t>(shifted);
    const double rest = (radians - count * half_pi_1) - count * half_pi_2;  // exact
    if (std::fabs(rest) < 0x1p-16 && count != 0) return {reduce_closely(rest, count), quarters};
    const ExactSum third = fast_two_sum(count * half_pi_3, count * half_pi_after_3);
    const ExactSum angle = fast_two_sum(rest, -third.high);
    return {{angle.high, angle.low - third.low}, quarters};
}

struct ExactCosSin {
    ExactSum cos, sin;  // not normalised: `low` may reach a tenth of `high`
};

inline ExactCosSin cos_sin_reduced(ExactSum angle) {
    const double r = angle.high;
    const double z = r * r;
    const double s = -0x1.5555555555548p-3 +
                     z * (0x1.111111110f7cap-7 +
                          z * (-0x1.a01a019bfd1a3p-13 +
                               z * (0x1.71de3567132edp-19 + z * (-0x1.ae5e59f59fe1dp-26 + z * 0x1.5d8fa301d55a7p-33))));
    const double c = 0x1.555555555554cp-5 +
                     z * (-0x1.6c16c16c1517ep-10 +
                          z * (0x1.a01a019cb1bf4p-16 + z * (-0x1.27e4f809f172fp-22 +
                                                            z * (0x1.1ee9ebe983a11p-29 + z * -0x1.8fae9c87de471p-37))));
    const double half = 0.5 * z;
    const double rest = 1 - half;
    return {{rest, ((1 - rest) - half) + (z * z * c - r * angle.low)}, {r, r * z * s + angle.low * rest}};
}

inline CosSin turned(double cos, double sin, std::uint64_t quarters) {
    const bool is_odd = (quarters & 1) != 0;
    const double x = is_odd ? sin : cos;
    const double y = is_odd ? cos : sin;
    // Flipping sign bits rather than branching: quarters are as good as random.
    const std::uint64_t x_sign = ((quarters + 1) & 2) << 62, y_sign = (quarters & 2) << 62;
    return {std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) ^ x_sign),
            std::bit_cast<double>(std::bit_cast<std::uint64_t>(y) ^ y_sign)};
}

// atan(i / 16)
constexpr ExactSum atan_of_sixteenths[17] = {
    {0x0.0p+0, 0x0.0p+0},
    {0x1.ff55bb72cfdeap-5, -0x1.c934d86d23f1dp-60},
    {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
    {0x1.7b97b4bce5b02p-3, 0x1.347b0b4f881cap-58},
    {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
    {0x1.362773707ebccp-2, -0x1.963a544b672d8p-57},
    {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
    {0x1.a64eec3cc23fdp-2, -0x1.24dec1b50b7ffp-56},
    {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
    {0x1.0657e94db30d0p-1, -0x1.d5b495f6349e6p-56},
    {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
    {0x1.345f01cce37bbp-1, 0x1.1021137c71102p-55},
    {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
    {0x1.5d58987169b18p-1, 0x1.0028e4bc5e7cap-57},
    {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
    {0x1.819d0b7158a4dp-1, -0x1.bf76229d3b917p-56},
    {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55},
};

// atan(num / den) for 0 <= num <= den, den finite and above zero.
ExactSum atan_of_ratio(double num, double den) {
    const double ratio = num / den;
    double t = ratio;
    ExactSum base;
    if (ratio >= 0x1p-4) {
        // With c = i/16 near the ratio: atan(ratio) = atan(c) + atan((num - c den) / (den + c num)).
        if (den > 0x1p1000) {
            num *= 0x1p-100;
            den *= 0x1p-100;
        } else if (den < 0x1p-900) {
            num *= 0x1p200;
            den *= 0x1p200;
        }
        const int i = static_cast<int>(ratio * 16 + 0.5);
        const double c = i * 0x1p-4;
        const double den_high = without_low_bits(den, 5);  // its product with c is exact
        t = ((num - c * den_high) - c * (den - den_high)) / (den + c * num);
        base = atan_of_sixteenths[i];
    }
    const double z = t * t;
    const double p = -0x1.5555555555536p-2 +
                     z * (0x1.9999999962642p-3 +
                          z * (-0x1.2492482710eccp-3 + z * (0x1.c718796371501p-4 + z * -0x1.70bf39a7a6b03p-4)));
    const ExactSum sum = fast_two_sum(base.high, t);
    return fast_two_sum(sum.high, sum.low + (base.low + t * z * p));
}

ExactSum difference(ExactSum a, ExactSum b) {
    const ExactSum sum = two_sum(a.high, -b.high);
    return fast_two_sum(sum.high, sum.low + (a.low - b.low));
}

// The angle of (x, |y|), for finite numbers that are not both zero.
ExactSum angle_of(double y, double x) {
    const double height = std::fabs(y), width = std::fabs(x);
    const ExactSum steep =
        height > width ? difference(half_pi, atan_of_ratio(width, height)) : atan_of_ratio(height, width);
    return x < 0 ? difference(whole_pi, steep) : steep;
}

// sqrt(1 - x^2) for |x| <= 1.
ExactSum other_leg(double x) {
    const ExactSum square = two_product(x, x);
    const ExactSum rest = two_sum(1, -square.high);
    const double root = std::sqrt(rest.high);
    if (root == 0) return {0, 0};
    const ExactSum check = two_product(root, root);
    return {root, (((rest.high - check.high) - check.low) + (rest.low - square.low)) / (2 * root)};
}

}  // namespace

CosSin cos_sin(double radians) {
    if (!(std::fabs(radians) <= greatest_angle)) return {not_a_number, not_a_number};
    const Reduced reduced = reduce(radians);
    const ExactCosSin exact = cos_sin_reduced(reduced.angle);
    return turned(exact.cos.high + exact.cos.low, exact.sin.high + exact.sin.low, reduced.quarters);
}

CosSin cos_sin_degrees(double degrees) {
    if (!(std::fabs(degrees) <= greatest_angle)) {
        if (!std::isfinite(degrees)) return {not_a_number, not_a_number};
        degrees = std::fmod(degrees, 360.0);  // exact
    }
    const double shifted = degrees * (1.0 / 90) + rounder;
    const std::uint64_t quarters = std::bit_cast<std::uint64_t>(shifted);
    const double rest = degrees - 90 * (shifted - rounder);  // exact
    const double size = std::fabs(rest);
    if (size == 45) return turned(0x1.6a09e667f3bcdp-1, std::copysign(0x1.6a09e667f3bcdp-1, rest), quarters);

    const double rest_high = without_low_bits(rest, 27);
    const double product = rest * radians_per_degree;
    const double error =
        ((rest_high * radians_per_degree_high - product) + (rest - rest_high) * radians_per_degree_high) +
        rest * radians_per_degree_low;
    const ExactCosSin exact = cos_sin_reduced({product, error});
    const double sin = size == 30 ? std::copysign(0.5, rest) : exact.sin.high + exact.sin.low;
    const CosSin result = turned(exact.cos.high + exact.cos.low, sin, quarters);
    return {result.cos + 0.0, result.sin + 0.0};  // no -0
}

double tan(double radians) {
    if (!(std::fabs(radians) <= greatest_angle)) return not_a_number;
    const Reduced reduced = reduce(radians);
    const ExactCosSin exact = cos_sin_reduced(reduced.angle);
    ExactSum over = fast_two_sum(exact.sin.high, exact.sin.low);
    ExactSum under = fast_two_sum(exact.cos.high, exact.cos.low);
    if ((reduced.quarters & 1) != 0) {
        const ExactSum sin = over;
        over = {-under.high, -under.low};
        under = sin;
    }
    const double ratio = over.high / under.high;
    if (std::fabs(ratio) < 0x1p-400) return ratio;  // too small for the product's error, and the angle itself
    const ExactSum product = two_product(ratio, under.high);
    const double rest = ((over.high - product.high) - product.low) + (over.low - ratio * under.low);
    return ratio + rest / under.high;
}

double atan(double x) {
    if (std::isnan(x)) return x;
    if (x == 0) return 0;
    if (std::isinf(x)) return std::copysign(half_pi.high, x);
    return std::copysign(angle_of(x, 1).high, x);
}

double atan2(double y, double x) {
    if (std::isnan(x) || std::isnan(y)) return not_a_number;
    if (std::isinf(x) || std::isinf(y)) {
        y = std::isinf(y) ? std::copysign(1.0, y) : 0;
        x = std::isinf(x) ? std::copysign(1.0, x) : 0;
    }
    if (y == 0) return x < 0 ? pi : 0;
    return std::copysign(angle_of(y, x).high, y);
}

double asin(double x) {
    if (!(std::fabs(x) <= 1)) return not_a_number;
    if (std::fabs(x) < 0x1p-30) return x + 0.0;
    const double sine = std::fabs(x);
    const ExactSum cosine = other_leg(x);
    const ExactSum angle = angle_of(sine, cosine.high);
    return std::copysign(angle.high + (angle.low - sine * cosine.low), x);
}

double acos(double x) {
    if (!(std::fabs(x) <= 1)) return not_a_number;
    if (x == 1) return 0;
    const ExactSum sine = other_leg(x);
    const ExactSum angle = angle_of(sine.high, x);
    return angle.high + (angle.low + x * sine.low);
}

}  // namespace filigree::elementary
