// Whole numbers from 0 upwards without a limit: how long words are that nobody could write down, and places in them.
//
// No more than lengths need: they are added up, multiplied by small counts, compared and printed.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace filigree::rewriting {

struct BigInt {
    std::vector<std::uint32_t> limbs;  // to base 2^32, the least first, the last of them not 0; none is zero

    BigInt() = default;
    BigInt(std::uint64_t value);  // NOLINT(google-explicit-constructor): a number is a number

    bool operator==(const BigInt&) const = default;
    std::strong_ordering operator<=>(const BigInt& other) const;
};

void add(BigInt& to, const BigInt& value);
void add_product(BigInt& to, const BigInt& value, std::uint32_t factor);  // `to` and `value` may be the same
void subtract(BigInt& from, const BigInt& value);                         // value <= from

std::optional<std::uint64_t> to_u64(const BigInt& value);   // none where it is more than 64 bits
std::string to_text(const BigInt& value);                   // decimal
std::optional<BigInt> parse_bigint(std::string_view text);  // decimal digits, at least one, and nothing else

}  // namespace filigree::rewriting
