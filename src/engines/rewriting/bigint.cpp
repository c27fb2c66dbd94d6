#include "engines/rewriting/bigint.h"

#include <algorithm>

namespace filigree::rewriting {
namespace {

void trim(BigInt& value) {
    while (!value.limbs.empty() && value.limbs.back() == 0) value.limbs.pop_back();
}

void multiply(BigInt& value, std::uint32_t factor, std::uint32_t carry) {
    std::uint64_t rest = carry;
    for (std::uint32_t& limb : value.limbs) {
        rest += std::uint64_t{limb} * factor;
        limb = static_cast<std::uint32_t>(rest);
        rest >>= 32;
    }
    if (rest != 0) value.limbs.push_back(static_cast<std::uint32_t>(rest));
    trim(value);
}

// What remains; the value becomes the quotient.
std::uint32_t divide(BigInt& value, std::uint32_t divisor) {
    std::uint64_t rest = 0;
    for (std::size_t i = value.limbs.size(); i-- > 0;) {
        rest = rest << 32 | value.limbs[i];
        value.limbs[i] = static_cast<std::uint32_t>(rest / divisor);
        rest %= divisor;
    }
    trim(value);
    return static_cast<std::uint32_t>(rest);
}

constexpr std::uint32_t billion = 1'000'000'000;

}  // namespace

BigInt::BigInt(std::uint64_t value) {
    for (; value != 0; value >>= 32) limbs.push_back(static_cast<std::uint32_t>(value));
}

std::strong_ordering BigInt::operator<=>(const BigInt& other) const {
    if (limbs.size() != other.limbs.size()) return limbs.size() <=> other.limbs.size();
    for (std::size_t i = limbs.size(); i-- > 0;) {
        if (limbs[i] != other.limbs[i]) return limbs[i] <=> other.limbs[i];
    }
    return std::strong_ordering::equal;
}

void add(BigInt& to, const BigInt& value) { add_product(to, value, 1); }

void add_product(BigInt& to, const BigInt& value, std::uint32_t factor) {
    if (factor == 0) return;
    const std::size_t count = value.limbs.size();
    if (to.limbs.size() < count) to.limbs.resize(count);
    std::uint64_t rest = 0;
    for (std::size_t i = 0; i < to.limbs.size() && (i < count || rest != 0); ++i) {
        rest += to.limbs[i] + (i < count ? std::uint64_t{value.limbs[i]} * factor : 0);
        to.limbs[i] = static_cast<std::uint32_t>(rest);
        rest >>= 32;
    }
    if (rest != 0) to.limbs.push_back(static_cast<std::uint32_t>(rest));
}

void subtract(BigInt& from, const BigInt& value) {
    std::uint64_t borrow = 0;
    for (std::size_t i = 0; i < from.limbs.size() && (i < value.limbs.size() || borrow != 0); ++i) {
        const std::uint64_t taken = borrow + (i < value.limbs.size() ? value.limbs[i] : 0);
        borrow = from.limbs[i] < taken ? 1 : 0;
        from.limbs[i] -= static_cast<std::uint32_t>(taken);
    }
    trim(from);
}

std::optional<std::uint64_t> to_u64(const BigInt& value) {
    if (value.limbs.size() > 2) return std::nullopt;
    std::uint64_t result = 0;
    for (std::size_t i = value.limbs.size(); i-- > 0;) result = result << 32 | value.limbs[i];
    return result;
}

std::string to_text(const BigInt& value) {
    std::string backwards;
    for (BigInt rest = value; !rest.limbs.empty();) {
        std::uint32_t digits = divide(rest, billion);
        for (int i = 0; i < 9; ++i, digits /= 10) backwards += static_cast<char>('0' + digits % 10);
    }
    while (!backwards.empty() && backwards.back() == '0') backwards.pop_back();
    if (backwards.empty()) return "0";
    return {backwards.rbegin(), backwards.rend()};
}

std::optional<BigInt> parse_bigint(std::string_view text) {
    if (text.empty()) return std::nullopt;
    BigInt result;
    for (const char c : text) {
        if (c < '0' || c > '9') return std::nullopt;
        multiply(result, 10, static_cast<std::uint32_t>(c - '0'));
    }
    return result;
}

}  // namespace filigree::rewriting
