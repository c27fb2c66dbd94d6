#include "base/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include "base/test_cases.h"

namespace filigree {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::uint64_t all_bits = UINT64_MAX;

std::uint64_t folded(std::uint64_t seed, std::initializer_list<std::uint64_t> fields) {
    for (const std::uint64_t field : fields) seed = fold(seed, field);
    return seed;
}

TEST(Random, MixHasItsVectors) {
    EXPECT_EQ(mix(0), 16294208416658607535U);
    EXPECT_EQ(mix(1), 10451216379200822465U);
    static_assert(mix(0) == 16294208416658607535U);
}

TEST(Random, FoldedFieldsHaveTheirVectors) {
    EXPECT_EQ(folded(1, {0, 0, 0, 0}), 1671267003557561010U);
    EXPECT_EQ(folded(7, {82, 1, 0, 0}), 14689096794994787491U);
    EXPECT_EQ(folded(123456789, {83, 5, 42, 3}), 1425474958728985400U);
    EXPECT_EQ(to_unit(1671267003557561010U), 0.09059956580302231);
    EXPECT_EQ(to_unit(14689096794994787491U), 0.7962975328491604);
    EXPECT_EQ(to_whole(1671267003557561010U, 10), 0U);
    EXPECT_EQ(to_whole(14689096794994787491U, 10), 7U);
}

TEST(Random, AnAddressIsSeedKeyNameAndDraw) {
    const Key key{5};
    EXPECT_EQ(random_bits(7, key, std::uint64_t{3}, 2), folded(7, {5, 3, 2}));
    EXPECT_EQ(random_bits(7, key, "width"), folded(7, {5, hash_text("width"), 0}));
    EXPECT_EQ(child(key, 9).value, folded(5, {9}));
    EXPECT_EQ(child(key, "a"), child(key, hash_text("a")));
    std::set<std::uint64_t> seen;
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        for (std::uint64_t k = 0; k < 5; ++k) {
            for (std::uint64_t name = 0; name < 5; ++name) {
                for (std::uint64_t draw = 0; draw < 5; ++draw) seen.insert(random_bits(seed, Key{k}, name, draw));
            }
        }
    }
    EXPECT_EQ(seen.size(), 625U);
}

TEST(Random, TextHashesItsBytesAndLength) {
    EXPECT_EQ(hash_text(""), folded(0, {0}));
    EXPECT_EQ(hash_text("a"), folded(0, {0x61, 1}));
    EXPECT_EQ(hash_text("abcdefgh"), folded(0, {0x6867666564636261U, 8}));
    EXPECT_EQ(hash_text("abcdefghi"), folded(0, {0x6867666564636261U, 0x69, 9}));
    EXPECT_EQ(hash_text("\xFF"), folded(0, {0xFF, 1}));
    std::set<std::uint64_t> seen;
    for (std::size_t length = 0; length < 100; ++length) seen.insert(hash_text(std::string(length, '\0')));
    EXPECT_EQ(seen.size(), 100U);
}

TEST(Random, UnitAndWholeStayInRangeAndRise) {
    EXPECT_EQ(to_unit(0), 0);
    EXPECT_EQ(to_unit(all_bits), 1 - 0x1p-53);
    EXPECT_EQ(to_whole(all_bits, 0), 0U);
    EXPECT_EQ(to_whole(all_bits, 1), 0U);
    EXPECT_EQ(to_whole(all_bits, UINT32_MAX), UINT32_MAX - 1U);
    EXPECT_EQ(to_whole(0, UINT32_MAX), 0U);
    for (std::uint64_t i = 1; i <= case_count(); ++i) {
        CaseRandom random(i);
        std::uint64_t low = random.bits(), high = random.bits();
        if (low > high) std::swap(low, high);
        const auto count = static_cast<std::uint32_t>(random.bits());
        ASSERT_LE(to_unit(low), to_unit(high)) << "case " << i;
        ASSERT_LE(to_whole(low, count), to_whole(high, count)) << "case " << i;
        ASSERT_LE(to_normal(low), to_normal(high)) << "case " << i;
        ASSERT_LT(to_whole(high, std::max(count, 1U)), std::max(count, 1U)) << "case " << i;
    }
}

TEST(Random, WholeNumbersAreEven) {
    const std::uint32_t sides = 6;
    std::vector<double> counts(sides);
    const double rolls = 60'000;
    for (std::uint64_t i = 0; i < 60'000; ++i) {
        ++counts[to_whole(random_bits(1, Key{i}, "die"), sides)];
    }
    double chi_squared = 0;
    for (const double count : counts)
        chi_squared += (count - rolls / sides) * (count - rolls / sides) / (rolls / sides);
    EXPECT_LT(chi_squared, 20.5);  // 0.1 % of fair dice
}

TEST(Random, NormalInvertsTheDistribution) {
    for (std::uint64_t i = 1; i <= 20 * case_count(); ++i) {
        CaseRandom random(i);
        const std::uint64_t n = random.bits() >> 11 >> random.below(53);
        const double deviate = to_normal(n << 11);
        // One of Newton's steps in long double from our value to the true one.
        const long double p = (static_cast<long double>(n) + 0.5L) * 0x1p-53L;
        const bool is_upper = p > 0.5L;
        const long double q = is_upper ? 1 - p : p;
        const long double z = is_upper ? deviate : -static_cast<long double>(deviate);
        const long double density = std::exp(-z * z / 2) / std::sqrt(2 * std::acos(-1.0L));
        const long double step = (std::erfc(z / std::sqrt(2.0L)) / 2 - q) / density;
        // Outside the tails 16 neighbours share a value.
        ASSERT_LT(std::fabs(step), 2e-14L * std::max(1.0L, std::fabs(z)) + (q < 0x1p-8L ? 0 : 8 * 0x1p-53L / density))
            << "case " << i << " n " << n;
    }
}

TEST(Random, NormalIsSymmetricAndBounded) {
    EXPECT_EQ(to_normal(0), -to_normal(all_bits));
    EXPECT_NEAR(to_normal(all_bits), 8.2, 0.1);
    for (std::uint64_t i = 1; i <= case_count(); ++i) ASSERT_EQ(to_normal(mix(i)), -to_normal(~mix(i))) << "case " << i;
}

TEST(Random, NormalNeverTurnsBack) {
    // Neighbours, where rounding errors could show, at random places of random size and where the fits meet.
    std::vector<std::uint64_t> starts;
    for (const double p : {0.25, 0.005085569, 0.00390625, 0.0013, 0.5})
        starts.push_back(static_cast<std::uint64_t>(p * 0x1p53));
    for (std::uint64_t i = 1; i <= case_count() / 5; ++i) starts.push_back(mix(i) >> 12 >> (i % 40));
    for (const std::uint64_t start : starts) {
        const std::uint64_t first = start < 500 ? 0 : start - 500;
        double last = to_normal(first << 11);
        for (std::uint64_t n = first + 1; n < first + 1000; ++n) {
            const double deviate = to_normal(n << 11);
            ASSERT_GE(deviate, last) << n;
            last = deviate;
        }
    }
}

TEST(Random, NormalHasItsMoments) {
    double sum = 0, squares = 0, fourth = 0;
    const int count = 100'000;
    for (std::uint64_t i = 0; i < count; ++i) {
        const double x = to_normal(random_bits(3, Key{i}, "normal"));
        sum += x;
        squares += x * x;
        fourth += x * x * x * x;
    }
    EXPECT_NEAR(sum / count, 0, 0.015);
    EXPECT_NEAR(squares / count, 1, 0.02);
    EXPECT_NEAR(fourth / count, 3, 0.15);
}

// The bits themselves, so that a change of compiler, options or library shows.
TEST(Random, BitsNeverChange) {
    std::uint64_t hash = 0;
    for (std::uint64_t i = 1; i <= 1000; ++i) {
        hash = fold(hash, std::bit_cast<std::uint64_t>(to_normal(mix(i))));
        hash = fold(hash, std::bit_cast<std::uint64_t>(to_normal(mix(i) >> (i % 60))));
        hash = fold(hash, std::bit_cast<std::uint64_t>(race_time(mix(i), 0.1 * static_cast<double>(i))));
    }
    for (const std::uint32_t index : permutation(1, Key{2}, "order", 100)) hash = fold(hash, index);
    EXPECT_EQ(to_hex(hash), "cba95bfe9318b13c");
    EXPECT_EQ(to_hex(hash_text("spacing")), "116916162cde7d54");
}

TEST(Random, RaceTimesAreFiniteForWeightsAboveZero) {
    EXPECT_EQ(race_time(5, 0), infinity);
    EXPECT_EQ(race_time(5, -1), infinity);
    EXPECT_EQ(race_time(5, std::numeric_limits<double>::quiet_NaN()), infinity);
    EXPECT_EQ(race_time(all_bits, 1), 0);
    EXPECT_NEAR(race_time(0, 1), 53 * std::log(2), 1e-12);
    EXPECT_NEAR(race_time(0, 4), 53 * std::log(2) / 4, 1e-12);
    EXPECT_GT(race_time(1000, 1), race_time(2'000'000, 1));
}

std::vector<Key> candidate_keys(std::size_t count) {
    std::vector<Key> keys(count);
    for (std::size_t i = 0; i < count; ++i) keys[i] = child(Key{1}, i);
    return keys;
}

TEST(Random, RaceFollowsTheWeights) {
    const std::vector<Key> keys = candidate_keys(4);
    const std::vector<double> weights = {1, 0, 2, 5};
    std::vector<double> wins(4);
    const int races = 40'000;
    for (std::uint64_t i = 0; i < races; ++i) ++wins[race(9, Key{i}, "rule", keys, weights)];
    EXPECT_EQ(wins[1], 0);
    EXPECT_NEAR(wins[0] / races, 1.0 / 8, 0.008);
    EXPECT_NEAR(wins[2] / races, 2.0 / 8, 0.01);
    EXPECT_NEAR(wins[3] / races, 5.0 / 8, 0.011);
}

TEST(Random, OneMoreCandidateChangesOnlyWhatItWins) {
    const std::vector<Key> keys = candidate_keys(6);
    for (std::uint64_t i = 1; i <= case_count(); ++i) {
        CaseRandom random(i);
        std::vector<double> weights(6);
        for (double& weight : weights) weight = random.between(0, 3);
        const std::size_t before = race(i, Key{2}, "rule", std::span(keys).first(5), std::span(weights).first(5));
        const std::size_t after = race(i, Key{2}, "rule", keys, weights);
        ASSERT_TRUE(after == before || after == 5) << "case " << i;
        // The order of candidates does not matter, only their keys.
        std::vector<Key> reversed_keys(keys.rbegin(), keys.rend());
        std::vector<double> reversed_weights(weights.rbegin(), weights.rend());
        ASSERT_EQ(race(i, Key{2}, "rule", reversed_keys, reversed_weights), 5 - after) << "case " << i;
    }
}

TEST(Random, RaceWithoutWeightsHasNoWinner) {
    const std::vector<Key> keys = candidate_keys(3);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(race(1, Key{}, "x", keys, std::vector<double>{0, -1, nan}), 3U);
    EXPECT_EQ(race(1, Key{}, "x", {}, {}), 0U);
    EXPECT_EQ(race(1, Key{}, "x", keys, std::vector<double>{}), 3U);
    EXPECT_EQ(race(1, Key{}, "x", keys, std::vector<double>{0, 1e-320, 0}), 1U);
    EXPECT_EQ(race(1, Key{}, "x", keys, std::vector<double>{0, infinity, infinity}), 1U);
}

TEST(Random, EqualTimesGoToTheEarlierCandidate) {
    const std::vector<Key> twins = {Key{4}, Key{4}};
    for (std::uint64_t seed = 0; seed < 20; ++seed)
        EXPECT_EQ(race(seed, Key{}, "x", twins, std::vector<double>{1, 1}), 0U);
}

TEST(Random, PermutationsArePermutations) {
    for (const std::uint32_t count : {0U, 1U, 2U, 3U, 100U, 1000U}) {
        std::vector<std::uint32_t> order = permutation(8, Key{3}, "order", count);
        EXPECT_EQ(order, permutation(8, Key{3}, "order", count));
        std::sort(order.begin(), order.end());
        std::vector<std::uint32_t> all(count);
        std::iota(all.begin(), all.end(), 0U);
        EXPECT_EQ(order, all);
    }
    EXPECT_NE(permutation(8, Key{3}, "order", 100), permutation(9, Key{3}, "order", 100));
}

TEST(Random, PermutationsAreEven) {
    std::vector<double> counts(6);
    const int trials = 30'000;
    for (std::uint64_t i = 0; i < trials; ++i) {
        const std::vector<std::uint32_t> order = permutation(i, Key{}, "order", 3);
        ++counts[order[0] * 2 + (order[1] > order[2] ? 1 : 0)];
    }
    for (const double count : counts) EXPECT_NEAR(count / trials, 1.0 / 6, 0.01);
}

}  // namespace
}  // namespace filigree
