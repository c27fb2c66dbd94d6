// A double and the rounding error beside it: sums and products that lose nothing.
//
// Each holds for results far from overflow and underflow, in round-to-nearest, without contraction: `high` is
// the rounded result and high + low the exact one (Knuth's and Dekker's error-free transformations).
#pragma once

#include <bit>
#include <cstdint>

namespace filigree {

struct ExactSum {
    double high = 0;
    double low = 0;
};

constexpr ExactSum two_sum(double a, double b) {
    const double sum = a + b;
    const double b_part = sum - a;
    return {sum, (a - (sum - b_part)) + (b - b_part)};
}

// Where |a| >= |b| or a is zero.
constexpr ExactSum fast_two_sum(double a, double b) {
    const double sum = a + b;
    return {sum, b - (sum - a)};
}

// The value without its `bits` lowest bits; the rest of it is exact too.
constexpr double without_low_bits(double value, int bits) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) & (~std::uint64_t{0} << bits));
}

constexpr ExactSum two_product(double a, double b) {
    constexpr double splitter = 0x1p27 + 1;
    const double a_scaled = splitter * a, b_scaled = splitter * b;
    const double a_high = a_scaled - (a_scaled - a), a_low = a - a_high;
    const double b_high = b_scaled - (b_scaled - b), b_low = b - b_high;
    const double product = a * b;
    return {product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

}  // namespace filigree
