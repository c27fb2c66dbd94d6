#include "base/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <system_error>

#include "base/exact_sum.h"

namespace filigree {

namespace {

constexpr int most_decimals = 17;
constexpr double powers_of_ten[most_decimals + 1] = {1e0, 1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,
                                                     1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// 1e+05 -> 1e5
std::string without_exponent_padding(std::string_view text) {
    const std::size_t e = text.find('e');
    std::string out(text.substr(0, e + 1));
    std::size_t i = e + 1;
    if (text[i] == '-') out += '-';
    ++i;  // to_chars always writes the sign
    while (i + 1 < text.size() && text[i] == '0') ++i;
    out += text.substr(i);
    return out;
}

// Rounds a decimal text with at least `decimals` places after its point, half up in magnitude.
std::string rounded_decimal(std::string text, std::size_t decimals) {
    const std::size_t cut = text.find('.') + 1 + decimals;
    const bool is_up = cut < text.size() && text[cut] >= '5';
    text.resize(cut);
    if (is_up) {
        std::size_t i = text.size();
        while (i > 0) {
            --i;
            if (text[i] == '.') continue;
            if (text[i] != '9') {
                ++text[i];
                return text;
            }
            text[i] = '0';
        }
        text.insert(text.begin(), '1');
    }
    return text;
}

void append_without_trailing_zeros(std::string& out, std::string_view text) {
    if (text.find('.') != std::string_view::npos) {
        while (text.back() == '0') text.remove_suffix(1);
        if (text.back() == '.') text.remove_suffix(1);
    }
    out += text;
}

// Whether a number too large or too small for a double, written as from_chars accepts it, is too small.
bool is_underflow(std::string_view text) {
    const std::size_t e = std::min(text.find_first_of("eE"), text.size());
    const std::string_view digits = text.substr(0, e);
    const std::size_t point = std::min(digits.find('.'), digits.size());
    const std::size_t first = digits.find_first_of("123456789");
    const double lead = static_cast<double>(point) - static_cast<double>(first);
    double exponent = 0;
    for (std::size_t i = e + 1; i < text.size(); ++i) {
        if (is_digit(text[i])) exponent = std::min(exponent * 10 + (text[i] - '0'), 1e18);
    }
    const bool is_negative = e + 1 < text.size() && text[e + 1] == '-';
    return lead + (is_negative ? -exponent : exponent) < 0;
}

}  // namespace

std::string to_text(double value) {
    if (value == 0) return "0";
    if (std::isnan(value)) return "nan";
    if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
    const double magnitude = std::fabs(value);
    char fixed[400];
    const char* const fixed_end =
        std::to_chars(std::begin(fixed), std::end(fixed), value, std::chars_format::fixed).ptr;
    const std::string_view fixed_text(fixed, static_cast<std::size_t>(fixed_end - fixed));
    if (magnitude >= 1e-5 && magnitude < 1e15) return std::string(fixed_text);

    char scientific[40];
    const char* const end =
        std::to_chars(std::begin(scientific), std::end(scientific), value, std::chars_format::scientific).ptr;
    std::string text = without_exponent_padding({scientific, static_cast<std::size_t>(end - scientific)});
    return text.size() < fixed_text.size() ? text : std::string(fixed_text);
}

std::string to_text(std::uint64_t value) {
    char buffer[24];
    return std::string(buffer, std::to_chars(std::begin(buffer), std::end(buffer), value).ptr);
}

std::optional<double> parse_number(std::string_view text) {
    bool is_negative = false;
    if (!text.empty() && (text[0] == '+' || text[0] == '-')) {
        is_negative = text[0] == '-';
        text.remove_prefix(1);
    }
    // from_chars would also read "inf" and "nan".
    if (text.empty() || !(is_digit(text[0]) || text[0] == '.')) return std::nullopt;
    double value = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end != text.data() + text.size()) return std::nullopt;
    if (fault == std::errc::result_out_of_range) {
        if (!is_underflow(text)) return std::nullopt;
        value = 0;
    } else if (fault != std::errc() || !std::isfinite(value)) {
        return std::nullopt;
    }
    return is_negative ? -value : value;
}

void append_fixed(std::string& out, double value, int decimals) {
    if (!std::isfinite(value)) {
        out += '0';
        return;
    }
    decimals = std::clamp(decimals, 0, most_decimals);
    const double magnitude = std::fabs(value);
    const double factor = powers_of_ten[decimals];
    const double scaled = magnitude * factor;
    if (scaled < 0x1p52) {
        auto digits = static_cast<std::uint64_t>(scaled);
        const double rest = scaled - static_cast<double>(digits);
        // Only a tie can come from rounding the product: then its error tells on which side the value lies.
        if (rest > 0.5 || (rest == 0.5 && two_product(magnitude, factor).low >= 0)) ++digits;
        if (digits == 0) {
            out += '0';
            return;
        }
        while (decimals > 0 && digits % 10 == 0) {
            digits /= 10;
            --decimals;
        }
        char buffer[40];
        char* const end = std::to_chars(std::begin(buffer), std::end(buffer), digits).ptr;
        const int count = static_cast<int>(end - buffer);
        if (value < 0) out += '-';
        if (count > decimals) {
            out.append(buffer, static_cast<std::size_t>(count - decimals));
        } else {
            out += '0';
        }
        if (decimals > 0) {
            out += '.';
            out.append(static_cast<std::size_t>(std::max(0, decimals - count)), '0');
            const int kept = std::min(count, decimals);
            out.append(end - kept, static_cast<std::size_t>(kept));
        }
        return;
    }
    // From 2^52 / 10^17 on a double has at most 57 binary, so 57 decimal, places: 60 write it exactly.
    char buffer[400];
    const char* const end =
        std::to_chars(std::begin(buffer), std::end(buffer), magnitude, std::chars_format::fixed, 60).ptr;
    if (value < 0) out += '-';
    append_without_trailing_zeros(out, rounded_decimal(std::string(buffer, static_cast<std::size_t>(end - buffer)),
                                                       static_cast<std::size_t>(decimals)));
}

std::string to_hex(std::uint64_t value) {
    constexpr char digits[] = "0123456789abcdef";
    std::string text(16, '0');
    for (int i = 15; i >= 0; --i, value >>= 4) text[static_cast<std::size_t>(i)] = digits[value & 15];
    return text;
}

}  // namespace filigree
