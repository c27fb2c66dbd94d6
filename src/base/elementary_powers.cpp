// Exponentials, logarithms, powers and roots. The polynomials are minimax fits made for the reduced ranges.
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/elementary.h"
#include "base/exact_sum.h"

namespace filigree::elementary {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double rounder = 0x1.8p52;  // adding and taking away this rounds to whole numbers

// ln 2: the high part has 42 bits, so that its product with any binary exponent is exact.
constexpr double ln2_high = 0x1.62e42fefa38p-1, ln2_low = 0x1.ef35793c7673p-45;
constexpr double log2_of_e = 0x1.71547652b82fep+0;

constexpr std::uint64_t mantissa_bits = (std::uint64_t{1} << 52) - 1;
constexpr std::uint64_t bits_of_one = std::uint64_t{1023} << 52;

// 2^exponent for -1022 <= exponent <= 1023.
double power_of_two(int exponent) { return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52); }

// A number above zero as mantissa 2^exponent, 1 <= mantissa < 2.
struct Parts {
    double mantissa = 1;
    int exponent = 0;
};
Parts parts_of(double x) {
    int exponent = -1023;
    if (x < 0x1p-1022) {
        x *= 0x1p54;
        exponent -= 54;
    }
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
    return {std::bit_cast<double>((bits & mantissa_bits) | bits_of_one), exponent + static_cast<int>(bits >> 52)};
}

// For mantissas near 1 + i/64: a near reciprocal of few bits and its negated logarithm, whose high part has no
// bits below 2^-42. From i = 27 on, both are for half the mantissa, so that logarithms near 1 do not cancel.
struct LogRow {
    double reciprocal, log_high, log_low;
};
constexpr int first_halved = 27;
constexpr LogRow log_rows[65] = {
    {0x1.000000p+0, 0x0.0p+0, 0x0.0p+0},
    {0x1.f80000p-1, 0x1.0205658930000p-6, 0x1.611d27c8e8417p-44},
    {0x1.f00000p-1, 0x1.0415d89e78000p-5, -0x1.dddc7f461c516p-44},
    {0x1.e90000p-1, 0x1.788595a358000p-5, -0x1.08b0d083b3a4cp-46},
    {0x1.e20000p-1, 0x1.eea31c0068000p-5, 0x1.c3dd83606d891p-44},
    {0x1.db0000p-1, 0x1.333d7f8184000p-4, -0x1.692b6a81b8848p-49},
    {0x1.d40000p-1, 0x1.700d30aeac000p-4, 0x1.c1e8da99ded32p-49},
    {0x1.ce0000p-1, 0x1.a4e7640b1c000p-4, -0x1.e42b6b94407c8p-47},
    {0x1.c70000p-1, 0x1.e3707ee304000p-4, 0x1.0f684e6766abdp-45},
    {0x1.c10000p-1, 0x1.0ce7ecdccc000p-3, 0x1.4652dabff5447p-46},
    {0x1.bb0000p-1, 0x1.28753bc11a000p-3, 0x1.7494e359302e6p-44},
    {0x1.b50000p-1, 0x1.4462b9dc9c000p-3, -0x1.84858a711b062p-44},
    {0x1.af0000p-1, 0x1.60b3100b0a000p-3, -0x1.71456c988f814p-44},
    {0x1.aa0000p-1, 0x1.7898d85444000p-3, 0x1.8e67be3dbaf3fp-44},
    {0x1.a40000p-1, 0x1.95a5adcf70000p-3, 0x1.7f22858a0ff6fp-47},
    {0x1.9f0000p-1, 0x1.ae2ca6f672000p-3, 0x1.7a8d5ae54f550p-44},
    {0x1.9a0000p-1, 0x1.c6ffbc6f00000p-3, 0x1.ee138d3a69d43p-44},
    {0x1.950000p-1, 0x1.e020cc6236000p-3, -0x1.52b00adb91424p-45},
    {0x1.900000p-1, 0x1.f991c6cb3c000p-3, -0x1.90d04cd7cc834p-44},
    {0x1.8b0000p-1, 0x1.09aa572e6c000p-2, 0x1.b50a1e1734342p-44},
    {0x1.860000p-1, 0x1.16b5ccbad0000p-2, -0x1.23299042d74bfp-44},
    {0x1.820000p-1, 0x1.214456d0ec000p-2, -0x1.caf0428b728a3p-44},
    {0x1.7d0000p-1, 0x1.2e9e2bce12000p-2, 0x1.4300c128d1dc2p-45},
    {0x1.790000p-1, 0x1.396ce359bc000p-2, -0x1.5839c5663663dp-47},
    {0x1.740000p-1, 0x1.4718dc271c000p-2, 0x1.06c18fb4c14c5p-44},
    {0x1.700000p-1, 0x1.522ae0738a000p-2, 0x1.ebe708164c759p-45},
    {0x1.6c0000p-1, 0x1.5d5bddf596000p-2, -0x1.a0b2a08a465dcp-47},
    {0x1.680000p+0, -0x1.5d1bdbf581000p-2, 0x1.8d6bdc9c7c238p-44},
    {0x1.640000p+0, -0x1.51aad872e0000p-2, 0x1.f4bd8db0a7cc1p-44},
    {0x1.600000p+0, -0x1.4618bc21c6000p-2, 0x1.3d82f484c84ccp-46},
    {0x1.5d0000p+0, -0x1.3d54fa5c1f000p-2, -0x1.c3e1cd9a395e3p-44},
    {0x1.590000p+0, -0x1.31871c9544000p-2, -0x1.84fab94cecfd9p-46},
    {0x1.550000p+0, -0x1.2596010df7000p-2, -0x1.8e7bc224ea3e3p-44},
    {0x1.520000p+0, -0x1.1c898c169a000p-2, 0x1.81410e5c62affp-44},
    {0x1.4e0000p+0, -0x1.1058bf9ae5000p-2, 0x1.4ab9d817d52cdp-44},
    {0x1.4b0000p+0, -0x1.071b85fcd6000p-2, 0x1.bcb8ba3e01a11p-44},
    {0x1.480000p+0, -0x1.fb9186d5e4000p-3, 0x1.d572aab993c87p-47},
    {0x1.440000p+0, -0x1.e27076e2b0000p-3, 0x1.a342c2af0003cp-44},
    {0x1.410000p+0, -0x1.cf6354e09c000p-3, -0x1.771239a07d55bp-45},
    {0x1.3e0000p+0, -0x1.bc286742d8000p-3, -0x1.9ac53f39d121cp-44},
    {0x1.3b0000p+0, -0x1.a8becfc882000p-3, -0x1.e3185cf21b9cfp-44},
    {0x1.380000p+0, -0x1.9525a9cf46000p-3, 0x1.297137d9f158fp-44},
    {0x1.350000p+0, -0x1.815c0a1436000p-3, 0x1.02a52f9201ce8p-44},
    {0x1.320000p+0, -0x1.6d60fe719e000p-3, 0x1.bc6e557134767p-44},
    {0x1.2f0000p+0, -0x1.59338d9982000p-3, -0x1.0ba68b7555d4ap-48},
    {0x1.2d0000p+0, -0x1.4ba36f39a6000p-3, 0x1.4354bb3f219e5p-44},
    {0x1.2a0000p+0, -0x1.371fc201e8000p-3, -0x1.ee8779b2d8abcp-44},
    {0x1.270000p+0, -0x1.2266f190a6000p-3, 0x1.4d20ab840e7f6p-45},
    {0x1.250000p+0, -0x1.1478584674000p-3, -0x1.563451027c750p-46},
    {0x1.220000p+0, -0x1.fec9131dc0000p-4, 0x1.54555d1ae6607p-44},
    {0x1.1f0000p+0, -0x1.d4313d66cc000p-4, 0x1.9454379135713p-45},
    {0x1.1d0000p+0, -0x1.b78c82bb10000p-4, 0x1.25ef7bc3987e7p-44},
    {0x1.1a0000p+0, -0x1.8c345d6318000p-4, -0x1.b20f5acb42a66p-44},
    {0x1.180000p+0, -0x1.6f0d28ae58000p-4, 0x1.4b4641b664613p-44},
    {0x1.160000p+0, -0x1.51b073f060000p-4, -0x1.83f69278e686ap-44},
    {0x1.130000p+0, -0x1.253f62f0a0000p-4, -0x1.416f8fb69a701p-44},
    {0x1.110000p+0, -0x1.0759835990000p-4, 0x1.b8ecfe4b59987p-44},
    {0x1.0f0000p+0, -0x1.d276b8adb0000p-5, -0x1.6a423c78a64b0p-46},
    {0x1.0d0000p+0, -0x1.95c830ec90000p-5, 0x1.c148297c5feb8p-45},
    {0x1.0a0000p+0, -0x1.39e87b9fe8000p-5, -0x1.eafd480ad9015p-44},
    {0x1.080000p+0, -0x1.f829b0e780000p-6, -0x1.980267c7e09e4p-45},
    {0x1.060000p+0, -0x1.7b91b07d60000p-6, 0x1.3b955b602ace4p-44},
    {0x1.040000p+0, -0x1.fc0a8b0fc0000p-7, -0x1.f1e7cf6d3a69cp-50},
    {0x1.020000p+0, -0x1.fe02a6b100000p-8, -0x1.9e23f0dda40e4p-46},
    {0x1.000000p+0, 0x0.0p+0, 0x0.0p+0},
};

// log(x) for finite x > 0, with a relative error of about 2^-66.
ExactSum exact_log(double x) {
    const Parts parts = parts_of(x);
    double mantissa = parts.mantissa;
    int exponent = parts.exponent;
    const auto row_index = ((std::bit_cast<std::uint64_t>(mantissa) & mantissa_bits) + (std::uint64_t{1} << 45)) >> 46;
    if (row_index >= first_halved) {
        mantissa *= 0.5;
        ++exponent;
    }
    const LogRow& row = log_rows[row_index];
    const double mantissa_high = without_low_bits(mantissa, 12);  // its product with the reciprocal is exact
    const ExactSum r = two_sum(mantissa_high * row.reciprocal - 1, (mantissa - mantissa_high) * row.reciprocal);

    // log(1 + r) = r - r^2 / 2 + r^3 p(r), |r| < 0.0098
    const double p =
        0x1.5555555555555p-2 +
        r.high * (-0x1.00000000000afp-2 +
                  r.high * (0x1.9999999999e0ep-3 +
                            r.high * (-0x1.5555553999523p-3 +
                                      r.high * (0x1.249248f5a74c9p-3 +
                                                r.high * (-0x1.0008d0095b2e6p-3 + r.high * 0x1.c7310e52e23f2p-4)))));
    const ExactSum square = two_product(r.high, r.high);
    const double base = exponent * ln2_high + row.log_high;  // exact
    const ExactSum first = fast_two_sum(base, r.high);
    const ExactSum second = fast_two_sum(first.high, -0.5 * square.high);
    const double low = (first.low + second.low) + (r.low - 0.5 * square.low - r.high * r.low) +
                       (exponent * ln2_low + row.log_low) + square.high * r.high * p;
    return fast_two_sum(second.high, low);
}

// exp(x.high + x.low) for |x.high| < 1000.
double exp_of_sum(ExactSum x) {
    const double count = (x.high * log2_of_e + rounder) - rounder;
    const ExactSum r = fast_two_sum(x.high - count * ln2_high, x.low - count * ln2_low);
    // exp(r) = 1 + r + r^2 p(r), |r| < 0.35
    const double h = r.high;
    const double p =
        0.5 + h * (0x1.555555555555bp-3 +
                   h * (0x1.5555555555502p-5 +
                        h * (0x1.111111110ec1ap-7 +
                             h * (0x1.6c16c16c30789p-10 +
                                  h * (0x1.a01a01b398ca7p-13 +
                                       h * (0x1.a01a0135f92cfp-16 +
                                            h * (0x1.71ddefdcf2de3p-19 +
                                                 h * (0x1.27e5b4fad22b7p-22 +
                                                      h * (0x1.af6c607dc27edp-26 + h * 0x1.1e3ccb5a931f1p-29)))))))));
    const ExactSum sum = fast_two_sum(1, h);
    const double value = sum.high + (sum.low + (h * h * p + r.low * sum.high));
    // In two steps: the result may lie where a single power of two does not reach.
    const int exponent = static_cast<int>(count);
    const int half = exponent / 2;
    return value * power_of_two(half) * power_of_two(exponent - half);
}

bool is_whole(double x) { return std::floor(x) == x; }
bool is_odd(double x) { return is_whole(x) && std::fabs(x) < 0x1p53 && !is_whole(x * 0.5); }

// base^exponent for base > 0 and finite, exponent finite.
double power_of_positive(double base, double exponent) {
    const ExactSum log = exact_log(base);
    const double estimate = log.high * exponent;
    if (estimate > 720) return infinity;
    if (estimate < -760) return 0;
    if (std::fabs(estimate) < 0x1p-60) return 1;
    const ExactSum product = two_product(log.high, exponent);
    return exp_of_sum({product.high, product.low + log.low * exponent});
}

}  // namespace

double exp(double x) {
    if (std::isnan(x)) return x;
    if (x > 720) return infinity;
    if (x < -760) return 0;
    return exp_of_sum({x, 0});
}

double log(double x) {
    if (x == 0) return -infinity;
    if (!(x > 0)) return not_a_number;
    if (std::isinf(x)) return x;
    return exact_log(x).high;
}

double power(double base, double exponent) {
    if (exponent == 0 || base == 1) return 1;
    if (std::isnan(base) || std::isnan(exponent)) return not_a_number;
    const double size = std::fabs(base);
    if (std::isinf(exponent)) {
        if (size == 1) return 1;
        return (size > 1) == (exponent > 0) ? infinity : 0;
    }
    if (base < 0 && std::isfinite(base) && !is_whole(exponent)) return not_a_number;
    double result = 0;
    if (size == 0 || std::isinf(size)) {
        result = (size == 0) == (exponent < 0) ? infinity : 0;
    } else {
        result = size == 1 ? 1 : power_of_positive(size, exponent);
    }
    return std::signbit(base) && is_odd(exponent) ? -result : result;
}

double cbrt(double x) {
    if (x == 0 || !std::isfinite(x)) return x + 0.0;
    const Parts parts = parts_of(std::fabs(x));
    // |x| = v 8^third with 1 <= v < 8
    const int third = (parts.exponent + 3000) / 3 - 1000;
    const double v = parts.mantissa * power_of_two(parts.exponent - 3 * third);
    const double guess = 0x1.412cbc851800ep-1 +
                         v * (0x1.cbf963bf3fa0bp-2 +
                              v * (-0x1.57244241520aep-4 + v * (0x1.3a0a490fbdc31p-7 + v * -0x1.c515ad85d5ee9p-12)));
    // Two of Halley's steps, each of which triples the digits; between them the root is rounded to 26 bits, so
    // that the second one knows the rest exactly, and roots of cubes come out whole.
    const double cube = guess * guess * guess;
    const double near = guess * (cube + 2 * v) / (2 * cube + v);
    const double root = (near + 0x1p27) - 0x1p27;
    const ExactSum exact_cube = two_product(root * root, root);
    const double rest = (v - exact_cube.high) - exact_cube.low;
    const double result = root + root * rest / (2 * exact_cube.high + v);
    return std::copysign(result * power_of_two(third), x);
}

}  // namespace filigree::elementary
