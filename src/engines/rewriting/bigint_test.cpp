#include "engines/rewriting/bigint.h"

#include <gtest/gtest.h>

#include "base/test_cases.h"

namespace filigree::rewriting {
namespace {

BigInt sum(BigInt a, const BigInt& b) {
    add(a, b);
    return a;
}
BigInt difference(BigInt a, const BigInt& b) {
    subtract(a, b);
    return a;
}
BigInt product(const BigInt& a, std::uint32_t b) {
    BigInt result;
    add_product(result, a, b);
    return result;
}
BigInt random_number(CaseRandom& random) {
    BigInt result;
    const std::uint32_t limbs = random.below(6);
    for (std::uint32_t i = 0; i < limbs; ++i) {
        const std::uint32_t special = random.below(4);
        result.limbs.push_back(special == 0   ? 0
                               : special == 1 ? UINT32_MAX
                                              : static_cast<std::uint32_t>(random.bits()));
    }
    while (!result.limbs.empty() && result.limbs.back() == 0) result.limbs.pop_back();
    return result;
}

TEST(BigInt, IsPrintedInDecimals) {
    EXPECT_EQ(to_text(BigInt()), "0");
    EXPECT_EQ(to_text(BigInt(7)), "7");
    EXPECT_EQ(to_text(BigInt(1'000'000'000)), "1000000000");
    EXPECT_EQ(to_text(BigInt(5'000'000'000'000'000'000U)), "5000000000000000000");
    EXPECT_EQ(to_text(BigInt(UINT64_MAX)), "18446744073709551615");
    EXPECT_EQ(to_text(sum(BigInt(UINT64_MAX), 1)), "18446744073709551616");
    BigInt power = 1;
    for (int i = 0; i < 200; ++i) power = product(power, 2);
    EXPECT_EQ(to_text(power), "1606938044258990275541962092341162602522202993782792835301376");
}

TEST(BigInt, FitsInto64BitsOrNot) {
    EXPECT_EQ(to_u64(BigInt()), 0U);
    EXPECT_EQ(to_u64(BigInt(UINT64_MAX)), UINT64_MAX);
    EXPECT_EQ(to_u64(sum(BigInt(UINT64_MAX), 1)), std::nullopt);
    EXPECT_EQ(to_u64(difference(sum(BigInt(UINT64_MAX), 1), 1)), UINT64_MAX);
}

TEST(BigInt, IsReadFromDecimalsAlone) {
    EXPECT_EQ(parse_bigint("0"), BigInt());
    EXPECT_EQ(parse_bigint("00042"), BigInt(42));
    for (const char* const wrong : {"", "-1", "+1", " 1", "1 ", "1e5", "0x1"})
        EXPECT_EQ(parse_bigint(wrong), std::nullopt);
}

TEST(BigInt, CountsAsSmallNumbersDo) {
    for (std::uint64_t c = first_seed(); c < first_seed() + case_count(); ++c) {
        CaseRandom random(c);
        const std::uint64_t a = random.bits() >> random.whole(2, 63), b = random.bits() >> random.whole(2, 63);
        const auto factor = static_cast<std::uint32_t>(random.bits());
        EXPECT_EQ(sum(a, b), BigInt(a + b));
        EXPECT_EQ(product(a >> 32, factor), BigInt((a >> 32) * factor));
        EXPECT_EQ(BigInt(a) <=> BigInt(b), a <=> b);
        EXPECT_EQ(to_text(BigInt(a)), std::to_string(a));
    }
}

TEST(BigInt, KeepsTheLawsOfNumbers) {
    for (std::uint64_t c = first_seed(); c < first_seed() + case_count(); ++c) {
        CaseRandom random(c);
        const BigInt a = random_number(random), b = random_number(random);
        const auto factor = static_cast<std::uint32_t>(random.bits() >> random.below(32));
        EXPECT_EQ(sum(a, b), sum(b, a));
        EXPECT_EQ(difference(sum(a, b), b), a);
        EXPECT_GE(sum(a, b), a);
        EXPECT_EQ(sum(a, b) == a, b == BigInt());
        EXPECT_EQ(product(sum(a, b), factor), sum(product(a, factor), product(b, factor)));
        EXPECT_EQ(product(a, 3), sum(a, sum(a, a)));
        EXPECT_EQ(parse_bigint(to_text(a)), a);
        BigInt itself = a;
        add_product(itself, itself, 2);
        EXPECT_EQ(itself, product(a, 3));
        add(itself, a);
        EXPECT_EQ(itself, product(a, 4));
    }
}

}  // namespace
}  // namespace filigree::rewriting
