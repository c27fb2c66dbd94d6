#include "language/choice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/random.h"
#include "base/test_cases.h"
#include "language/text_evaluation.h"

namespace filigree {
namespace {

double uniform(std::uint64_t seed, std::uint64_t draw) { return to_unit(random_bits(seed, Key{77}, "test", draw)); }

double share_below(double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); }

TEST(Choices, TheNormalShareAgreesWithTheComplementaryErrorFunction) {
    for (double z = -37; z <= 9; z += 0.0137) {
        const double expected = share_below(z);
        EXPECT_NEAR(normal_share_below(z), expected, 1e-300 + 4e-13 * expected) << z;
    }
    EXPECT_EQ(normal_share_below(0), 0.5);
    EXPECT_EQ(normal_share_below(-INFINITY), 0);
    EXPECT_EQ(normal_share_below(INFINITY), 1);
}

TEST(Choices, EveryDrawLiesInItsDomain) {
    for (std::uint64_t seed = 1; seed <= case_count(3000); ++seed) {
        const double scale = std::exp(uniform(seed, 0) * 40 - 20);
        const double low = (uniform(seed, 1) - 0.5) * scale;
        const double high = low + uniform(seed, 2) * scale;
        const double mean = low + (uniform(seed, 3) * 40 - 20) * (high - low);
        const double deviation = uniform(seed, 4) < 0.1 ? 0 : (high - low) * std::exp(uniform(seed, 5) * 10 - 6);
        for (const std::uint64_t bits : {std::uint64_t{0}, UINT64_MAX, mix(seed), mix(~seed)}) {
            const double between = draw_between(low, high, bits);
            const double normal = draw_normal_between(mean, deviation, low, high, bits);
            const double whole = draw_whole(std::ceil(low), std::ceil(high), bits);
            ASSERT_TRUE(between >= low && between <= high) << seed;
            ASSERT_TRUE(normal >= low && normal <= high) << seed;
            ASSERT_TRUE(whole >= std::ceil(low) && whole <= std::ceil(high) && whole == std::floor(whole)) << seed;
        }
    }
    EXPECT_EQ(draw_whole(3, 3, UINT64_MAX), 3);
    EXPECT_GE(draw_whole(0, 0x1p53, UINT64_MAX), 0x1p53 - 1);
    EXPECT_EQ(draw_between(2, 2, 5), 2);
}

TEST(Choices, ValuesFollowTheBits) {
    for (std::uint64_t seed = 1; seed <= case_count(300); ++seed) {
        std::vector<std::uint64_t> bits;
        for (std::uint64_t i = 0; i < 40; ++i) bits.push_back(mix(seed * 1000 + i));
        std::sort(bits.begin(), bits.end());
        const double mean = uniform(seed, 0) * 60 - 30, low = uniform(seed, 1) * 20 - 10;
        const double high = low + uniform(seed, 2) * 10;
        for (std::size_t i = 1; i < bits.size(); ++i) {
            ASSERT_LE(draw_between(low, high, bits[i - 1]), draw_between(low, high, bits[i])) << seed;
            ASSERT_LE(draw_whole(-7, 90, bits[i - 1]), draw_whole(-7, 90, bits[i])) << seed;
            ASSERT_LE(draw_normal_between(mean, 1, low, high, bits[i - 1]),
                      draw_normal_between(mean, 1, low, high, bits[i]))
                << seed;
        }
    }
}

// Narrowing a range keeps the quantile of every draw.
TEST(Choices, NarrowingMovesAValueAndKeepsItsQuantile) {
    for (std::uint64_t seed = 1; seed <= case_count(2000); ++seed) {
        const std::uint64_t bits = mix(seed);
        const double unit = to_unit(bits);
        const double low = uniform(seed, 1) * 10 - 5, high = low + 0.01 + uniform(seed, 2) * 5;
        EXPECT_NEAR((draw_between(low, high, bits) - low) / (high - low), unit, 1e-12) << seed;
        const double z = draw_normal_between(0, 1, low, high, bits);
        // Shares of the side where they are small, so that the check itself is precise.
        const double sign = low > 0 ? -1 : 1;
        const double from = share_below(sign * low), to = share_below(sign * high);
        EXPECT_NEAR((share_below(sign * z) - from) / (to - from), unit, 1e-6) << seed << " " << low << ".." << high;
        const double whole = draw_whole(10, 29, bits);
        EXPECT_LE(std::fabs((whole - 10 + 0.5) / 20 - unit), 0.5 / 20 + 1e-9) << seed;
    }
}

TEST(Choices, AFarTailIsExponential) {
    double sum = 0;
    const int count = 4000;
    for (int i = 0; i < count; ++i) sum += draw_normal_between(0, 1, 10, 20, mix(static_cast<std::uint64_t>(i))) - 10;
    EXPECT_NEAR(sum / count, 0.1, 0.006);  // the mean excess over 10 deviations is 0.098
    for (std::uint64_t i = 0; i < 100; ++i) {
        EXPECT_NEAR(draw_normal_between(0, 1, -20, -10, ~mix(i)), -draw_normal_between(0, 1, 10, 20, mix(i)), 1e-9);
    }
}

// --- one_of -----------------------------------------------------------------------------------------------------

std::string drawn(const std::string& text, std::uint64_t seed) {
    Evaluation at;
    at.words = {"line", "wave", "zigzag", "circ"};
    at.site = {seed, Key{3}, "curve"};
    return evaluated(text, at);
}

TEST(OneOf, AnotherAlternativeChangesOnlyTheDrawsThatItWins) {
    int won = 0;
    for (std::uint64_t seed = 1; seed <= case_count(1000); ++seed) {
        const std::string before = drawn("one_of(line, wave: 2, 30, 40)", seed);
        for (const std::string& text :
             {std::string("one_of(line, wave: 2, 30, 40, circ)"), std::string("one_of(circ, line, wave: 2, 30, 40)"),
              std::string("one_of(30, wave: 2, circ, line, 40)")}) {
            const std::string after = drawn(text, seed);
            if (after != "circ") {
                ASSERT_EQ(after, before) << seed << " " << text;
            } else {
                ++won;
            }
        }
        const std::string appended = drawn("one_of(line, wave: 2, 30, 40, 50)", seed);
        if (appended != "50") {
            ASSERT_EQ(appended, before) << seed;
        }
        // More weight for one changes only draws that it wins now.
        const std::string heavier = drawn("one_of(line, wave: 3, 30, 40)", seed);
        if (heavier != "wave") {
            ASSERT_EQ(heavier, before) << seed;
        }
    }
    EXPECT_GT(won, 0);
}

double chi_square(const std::string& text, const std::map<std::string, double>& shares, std::uint64_t count) {
    std::map<std::string, double> seen;
    for (std::uint64_t seed = 0; seed < count; ++seed) seen[drawn(text, mix(seed))] += 1;
    double sum = 0, all = 0;
    for (const auto& [name, share] : shares) {
        const double expected = share * static_cast<double>(count);
        sum += (seen[name] - expected) * (seen[name] - expected) / expected;
        all += seen[name];
    }
    EXPECT_EQ(all, static_cast<double>(count)) << text;
    return sum;
}

// 99.9% points of chi-square: 10.83, 13.82, 16.27 for 1, 2, 3 degrees of freedom. The seeds are fixed.
TEST(OneOf, DrawsByWeight) {
    EXPECT_LT(chi_square("one_of(line: 3, wave: 1)", {{"line", 0.75}, {"wave", 0.25}}, 20000), 10.83);
    EXPECT_LT(chi_square("one_of(line, wave, zigzag)", {{"line", 1. / 3}, {"wave", 1. / 3}, {"zigzag", 1. / 3}}, 20000),
              13.82);
    EXPECT_LT(chi_square("one_of(1: 1, 2: 2, 3: 3, 4: 4)", {{"1", .1}, {"2", .2}, {"3", .3}, {"4", .4}}, 20000), 16.27);
    EXPECT_LT(chi_square("one_of(line, line, wave)", {{"line", 2. / 3}, {"wave", 1. / 3}}, 20000), 10.83);
    EXPECT_LT(chi_square("one_of([5, 6])", {{"5", .5}, {"6", .5}}, 20000), 10.83);
    EXPECT_LT(chi_square("floor((0..4))", {{"0", .25}, {"1", .25}, {"2", .25}, {"3", .25}}, 20000), 16.27);
    EXPECT_LT(chi_square("normal(0, 1) < 0 ? 1 : 2", {{"1", .5}, {"2", .5}}, 20000), 10.83);
    EXPECT_LT(chi_square("(normal(5, 2) in 5..6) < 5.4885 ? 1 : 2", {{"1", .5}, {"2", .5}}, 20000), 10.83);
}

TEST(OneOf, ManyCandidatesHaveKeysOfTheirOwn) {
    std::vector<Value> values;
    for (int i = 0; i < 500; ++i) {
        values.push_back({Symbol{"w" + std::to_string(i % 250)}, {}});
        values.push_back({std::string("w" + std::to_string(i)), {}});
        values.push_back(number_value(i % 7));
    }
    std::vector<Key> keys = candidate_keys(values);
    std::sort(keys.begin(), keys.end());
    EXPECT_EQ(std::unique(keys.begin(), keys.end()), keys.end());
}

}  // namespace
}  // namespace filigree
