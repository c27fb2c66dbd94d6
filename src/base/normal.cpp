// The inverse of the standard normal distribution.
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "base/elementary.h"
#include "base/random.h"

namespace filigree {

namespace {

template <std::size_t N>
double polynomial(const double (&coefficients)[N], double x) {
    double sum = coefficients[N - 1];
    for (std::size_t i = N - 1; i > 0; --i) sum = sum * x + coefficients[i - 1];
    return sum;
}

// Rational fits in q^2 about 1/32, where q = 1/2 - p, and in s = sqrt(-2 log p) about 7/4 and 4; each is off
// by less than 5e-15 of its value.
constexpr double centre_over[] = {0x1.4c23268ad7047p+1,  -0x1.7d46239b92e9cp+4, 0x1.1c0188641d4b4p+6,
                                  -0x1.286d5e444fe4fp+6, 0x1.0bb6a5d9dcfaep+4,  0x1.29b7ad5dd3a79p+0};
constexpr double centre_under[] = {1, -0x1.4b57253737b1fp+3, 0x1.248c68bb0ed32p+5, -0x1.91675f69843ebp+5,
                                   0x1.4f73d1b443073p+4};
constexpr double near_tail_over[] = {0x1.91da5c1add103p-1,  0x1.2feb83bb4bd4cp+1, 0x1.17fd3810b6f6ap+1,
                                     0x1.a8caae7c69aaep-1,  0x1.020bb9234b170p-3, 0x1.22dec0aa2486dp-8,
                                     -0x1.c10f3950fe172p-13};
constexpr double near_tail_under[] = {
    1, 0x1.61681f8d80279p+0, 0x1.4e16c3b32a7a8p-1, 0x1.df17450369ab1p-4, 0x1.3a7824373b9d3p-8, -0x1.c0983c2cd17acp-13};
constexpr double far_tail_over[] = {0x1.b35a47ecc4b29p+1, 0x1.001c4c73a7b63p+2, 0x1.d8b6866b94fecp+0,
                                    0x1.b10042003db42p-2, 0x1.9878d8a83b063p-5, 0x1.6f0eec032107fp-9,
                                    0x1.d752ba41be8d2p-15};
constexpr double far_tail_under[] = {1,
                                     0x1.b5ce8e59a7e30p-1,
                                     0x1.1793d7559bd4ap-2,
                                     0x1.468f33fe5f2a4p-5,
                                     0x1.51b676c9b892ep-9,
                                     0x1.d743788598f7dp-15,
                                     0x1.b8a11630376d3p-35};

// The deviate above which `p` of the distribution lies, for 0 < p <= 1/2.
double deviate_above(double p) {
    if (p >= 0.25) {
        const double q = 0.5 - p;
        const double x = q * q - 0.03125;
        return q * polynomial(centre_over, x) / polynomial(centre_under, x);
    }
    const double s = std::sqrt(-2 * elementary::log(p));
    if (s < 3.25) return polynomial(near_tail_over, s - 1.75) / polynomial(near_tail_under, s - 1.75);
    return polynomial(far_tail_over, s - 4) / polynomial(far_tail_under, s - 4);
}

}  // namespace

double to_normal(std::uint64_t bits) {
    // Both halves share one function, so that the result is exactly symmetric.
    constexpr std::uint64_t top = std::uint64_t{1} << 53;
    std::uint64_t n = bits >> 11;
    const bool is_lower = n < top / 2;
    if (!is_lower) n = top - 1 - n;
    // Outside the tails neighbours of 53 bits lie closer together than rounding errors, which would break
    // monotonicity: there 16 of them share one value.
    constexpr std::uint64_t tail = std::uint64_t{1} << 45;
    const double steps = n < tail ? static_cast<double>(n) + 0.5 : static_cast<double>((n | 15) - 7);
    const double deviate = deviate_above(steps * 0x1p-53);
    return is_lower ? -deviate : deviate;
}

}  // namespace filigree
