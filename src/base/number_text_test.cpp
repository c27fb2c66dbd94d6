#include "base/number_text.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "base/random.h"
#include "base/test_cases.h"

namespace filigree {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::string fixed(double value, int decimals) {
    std::string out;
    append_fixed(out, value, decimals);
    return out;
}

TEST(NumberText, WritesTheShortestText) {
    EXPECT_EQ(to_text(0.0), "0");
    EXPECT_EQ(to_text(-0.0), "0");
    EXPECT_EQ(to_text(1.0), "1");
    EXPECT_EQ(to_text(-2.5), "-2.5");
    EXPECT_EQ(to_text(0.1), "0.1");
    EXPECT_EQ(to_text(0.1 + 0.2), "0.30000000000000004");
    EXPECT_EQ(to_text(100000.0), "100000");
    EXPECT_EQ(to_text(1e14), "100000000000000");
    EXPECT_EQ(to_text(999999999999999.0), "999999999999999");
    EXPECT_EQ(to_text(0.00001), "0.00001");
    EXPECT_EQ(to_text(0.000012345), "0.000012345");
    EXPECT_EQ(to_text(1e15), "1e15");
    EXPECT_EQ(to_text(-1e100), "-1e100");
    EXPECT_EQ(to_text(1e-6), "1e-6");
    EXPECT_EQ(to_text(1.5e-7), "1.5e-7");
    EXPECT_EQ(to_text(1234567890123456.0), "1234567890123456");
    EXPECT_EQ(to_text(5e-324), "5e-324");
    EXPECT_EQ(to_text(std::numeric_limits<double>::max()), "1.7976931348623157e308");
    EXPECT_EQ(to_text(infinity), "inf");
    EXPECT_EQ(to_text(-infinity), "-inf");
    EXPECT_EQ(to_text(std::numeric_limits<double>::quiet_NaN()), "nan");
    EXPECT_EQ(to_text(std::uint64_t{0}), "0");
    EXPECT_EQ(to_text(UINT64_MAX), "18446744073709551615");
}

TEST(NumberText, ReadsBackWhatItWrote) {
    for (std::uint64_t i = 1; i <= 20 * case_count(); ++i) {
        CaseRandom random(i);
        double value = std::bit_cast<double>(random.bits());
        if (i % 2 == 0) value = std::ldexp(random.between(-1, 1), static_cast<int>(random.below(100)) - 30);
        if (!std::isfinite(value)) continue;
        const std::string text = to_text(value);
        const auto read = parse_number(text);
        ASSERT_TRUE(read) << "case " << i << " " << text;
        ASSERT_EQ(*read, value) << "case " << i << " " << text;
        const double size = std::fabs(value);
        if (size >= 1e-5 && size < 1e15) {
            ASSERT_EQ(text.find('e'), std::string::npos) << "case " << i << " " << text;
        }
    }
}

TEST(NumberText, ReadsWholeTextsOnly) {
    EXPECT_EQ(parse_number("12"), 12.0);
    EXPECT_EQ(parse_number("+12"), 12.0);
    EXPECT_EQ(parse_number("-12.50"), -12.5);
    EXPECT_EQ(parse_number(".5"), 0.5);
    EXPECT_EQ(parse_number("5."), 5.0);
    EXPECT_EQ(parse_number("1e3"), 1000.0);
    EXPECT_EQ(parse_number("1E+3"), 1000.0);
    EXPECT_EQ(parse_number("1.5e-3"), 0.0015);
    EXPECT_EQ(parse_number("0005"), 5.0);
    EXPECT_EQ(parse_number("0e999999999999999999999"), 0.0);
    for (const char* text :
         {"",    " ",  "1 ",   " 1",  "+",    "-",   ".",        "e5",    "1e",    "1e+", "+-1",  "--1", "++1",
          "1,5", "1x", "0x10", "inf", "-inf", "nan", "infinity", "1e5.5", "1_000", "-.",  "1..2", "1'0"}) {
        EXPECT_FALSE(parse_number(text)) << text;
    }
    EXPECT_FALSE(parse_number(std::string_view("1\0", 2)));
}

TEST(NumberText, TellsTooLargeFromTooSmall) {
    EXPECT_FALSE(parse_number("1e309"));
    EXPECT_FALSE(parse_number("-1e400"));
    EXPECT_FALSE(parse_number("1e99999999999999999999"));
    EXPECT_FALSE(parse_number(std::string(400, '9')));
    EXPECT_FALSE(parse_number(std::string(400, '9') + "e-5"));
    EXPECT_FALSE(parse_number("0.001e400"));
    EXPECT_EQ(parse_number("1e-400"), 0.0);
    EXPECT_EQ(parse_number("-1e-400"), 0.0);
    EXPECT_EQ(parse_number("1e-99999999999999999999"), 0.0);
    EXPECT_EQ(parse_number("0." + std::string(400, '0') + "1"), 0.0);
    EXPECT_EQ(parse_number("0." + std::string(400, '0') + "1e5"), 0.0);
    EXPECT_EQ(parse_number("100e-400"), 0.0);
    EXPECT_EQ(parse_number("4.9406564584124654e-324"), 5e-324);
    EXPECT_EQ(parse_number("1e-310"), 1e-310);
    EXPECT_EQ(parse_number("1.7976931348623157e308"), std::numeric_limits<double>::max());
}

TEST(NumberText, FixedDropsTrailingZeros) {
    EXPECT_EQ(fixed(1.5, 2), "1.5");
    EXPECT_EQ(fixed(-0.001, 2), "0");
    EXPECT_EQ(fixed(0, 3), "0");
    EXPECT_EQ(fixed(-0.0, 3), "0");
    EXPECT_EQ(fixed(100, 2), "100");
    EXPECT_EQ(fixed(100, 0), "100");
    EXPECT_EQ(fixed(0.05, 2), "0.05");
    EXPECT_EQ(fixed(-0.05, 2), "-0.05");
    EXPECT_EQ(fixed(3.14159, 3), "3.142");
    EXPECT_EQ(fixed(0.999, 2), "1");
    EXPECT_EQ(fixed(9.995, 1), "10");
    EXPECT_EQ(fixed(1234567.891, 2), "1234567.89");
    EXPECT_EQ(fixed(0.1, 17), "0.10000000000000001");
    EXPECT_EQ(fixed(0.1, 40), "0.10000000000000001");
    EXPECT_EQ(fixed(12.7, -3), "13");
    std::string out = "M";
    append_fixed(out, 2.25, 1);
    EXPECT_EQ(out, "M2.3");
}

TEST(NumberText, FixedRoundsHalfAwayFromZeroByTheExactValue) {
    EXPECT_EQ(fixed(0.5, 0), "1");
    EXPECT_EQ(fixed(-0.5, 0), "-1");
    EXPECT_EQ(fixed(1.5, 0), "2");
    EXPECT_EQ(fixed(2.5, 0), "3");
    EXPECT_EQ(fixed(0.125, 2), "0.13");
    EXPECT_EQ(fixed(-0.375, 2), "-0.38");
    EXPECT_EQ(fixed(0.49999999999999994, 0), "0");
    EXPECT_EQ(fixed(1.005, 2), "1");     // in fact 1.00499999999999989...
    EXPECT_EQ(fixed(1.115, 2), "1.11");  // 1.115 * 100 rounds to a tie, the value lies below it
    EXPECT_EQ(fixed(8.345, 2), "8.35");  // 8.3450000000000006...
    EXPECT_EQ(fixed(2251799813685248.5, 0), "2251799813685249");
    EXPECT_EQ(fixed(1125899906842624.25, 1), "1125899906842624.3");
    EXPECT_EQ(fixed(-1125899906842624.25, 1), "-1125899906842624.3");
    EXPECT_EQ(fixed(4503599627370495.5, 0), "4503599627370496");
    EXPECT_EQ(fixed(9007199254740993.0, 5), "9007199254740992");
    EXPECT_EQ(fixed(1e22, 3), "10000000000000000000000");
    EXPECT_EQ(fixed(99999999999.99999, 4), "100000000000");
}

TEST(NumberText, FixedWritesAnythingAsANumber) {
    EXPECT_EQ(fixed(infinity, 2), "0");
    EXPECT_EQ(fixed(std::numeric_limits<double>::quiet_NaN(), 2), "0");
    EXPECT_EQ(fixed(std::numeric_limits<double>::max(), 17).size(), 309U);
    EXPECT_EQ(fixed(5e-324, 17), "0");
}

// An oracle in whole numbers: the binary value as a fraction, scaled, with its remainder compared to a half.
std::string fixed_oracle(double value, int decimals) {
    __extension__ typedef unsigned __int128 Wide;
    int exponent = 0;
    auto mantissa = static_cast<Wide>(std::ldexp(std::frexp(std::fabs(value), &exponent), 53));
    exponent -= 53;
    for (int i = 0; i < decimals; ++i) mantissa *= 10;
    Wide whole = 0;
    if (exponent >= 0) {
        whole = mantissa << exponent;
    } else if (exponent > -127) {
        const Wide one = Wide{1} << -exponent;
        whole = mantissa / one + (mantissa % one >= one / 2 ? 1 : 0);
    }
    std::string digits;
    for (int i = 0; i <= decimals || whole > 0; ++i, whole /= 10) {
        if (i == decimals && decimals > 0) digits.insert(0, 1, '.');
        digits.insert(0, 1, static_cast<char>('0' + static_cast<int>(whole % 10)));
    }
    if (digits.find('.') != std::string::npos) {
        while (digits.back() == '0') digits.pop_back();
        if (digits.back() == '.') digits.pop_back();
    }
    return digits != "0" && value < 0 ? "-" + digits : digits;
}

TEST(NumberText, FixedAgreesWithWholeNumbers) {
    for (std::uint64_t i = 1; i <= 20 * case_count(); ++i) {
        CaseRandom random(i);
        const int decimals = static_cast<int>(random.below(12));
        double value = std::ldexp(random.between(-1, 1), static_cast<int>(random.below(70)) - 20);
        // Near ties, where it matters.
        const double power = std::pow(10.0, decimals);
        if (i % 2 == 0 && std::fabs(value) < 1e5) value = (std::floor(value * power) + 0.5) / power;
        ASSERT_EQ(fixed(value, decimals), fixed_oracle(value, decimals))
            << "case " << i << " " << to_text(value) << " at " << decimals;
    }
}

TEST(NumberText, HexHasSixteenDigits) {
    EXPECT_EQ(to_hex(0), "0000000000000000");
    EXPECT_EQ(to_hex(UINT64_MAX), "ffffffffffffffff");
    EXPECT_EQ(to_hex(0x0123456789ABCDEF), "0123456789abcdef");
}

}  // namespace
}  // namespace filigree
