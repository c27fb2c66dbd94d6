// Numbers to text and back without the locale.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace filigree {

// The shortest text that reads back as the same double; "0" for -0; never an exponent for 1e-5 <= |x| < 1e15;
// "1e-7" beyond. What is no number is "nan", "inf" or "-inf", which parse_number refuses.
std::string to_text(double value);
std::string to_text(std::uint64_t value);

// The whole text as a finite number (digits, sign, point, exponent); none for anything else. What is too small
// for a double is 0, what is too large is none.
std::optional<double> parse_number(std::string_view text);

// Rounds half away from zero, by the exact value, to `decimals` places (0 to 17) and writes without trailing
// zeros: 1.50 -> "1.5", -0.001 -> "0". What is not finite becomes "0", so that a drawing stays readable.
void append_fixed(std::string& out, double value, int decimals);

// 16 lower-case hexadecimal digits.
std::string to_hex(std::uint64_t value);

}  // namespace filigree
