#include "language/quantity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/test_cases.h"
#include "language/text_evaluation.h"

namespace filigree {
namespace {

double any_real(CaseRandom& random) { return random.between(-10, 10); }
Quantity any_quantity(CaseRandom& random) {
    Quantity out{any_real(random), 0, false};
    const std::uint32_t kind = random.below(6);
    if (kind == 5) out.is_angle = true;
    if (kind > 0 && kind < 5) out.length_power = static_cast<std::int8_t>(static_cast<int>(kind) - 2);
    return out;
}
Unit any_unit(CaseRandom& random) {
    constexpr Unit units[] = {Unit::mm, Unit::cm, Unit::m, Unit::inch, Unit::pt, Unit::px};
    return units[random.below(6)];
}

bool same(const std::optional<Quantity>& a, const std::optional<Quantity>& b) {
    if (a.has_value() != b.has_value()) return false;
    if (!a) return true;
    const double scale = std::max(std::fabs(a->value), std::fabs(b->value));
    return same_dimension(*a, *b) && std::fabs(a->value - b->value) <= 1e-9 * scale;
}

TEST(Quantities, FollowTheLawsOfAlgebra) {
    for (std::uint64_t seed = 1; seed <= case_count(5000); ++seed) {
        CaseRandom random(seed);
        const Quantity a = any_quantity(random), b = any_quantity(random), c = any_quantity(random);
        const Unit unit = any_unit(random);
        EXPECT_TRUE(same(multiplied(a, b), multiplied(b, a))) << seed;
        const auto ab = multiplied(a, b), bc = multiplied(b, c);
        if (ab && bc) {
            const auto left = multiplied(*ab, c), right = multiplied(a, *bc);
            if (left && right) {
                EXPECT_TRUE(same(left, right)) << seed;
            }
        }
        if (ab && b.value != 0) {
            const auto back = divided(*ab, b);
            if (back) {
                EXPECT_TRUE(same(back, a)) << seed;
            }
        }
        const auto ratio = divided(a, a);
        ASSERT_TRUE(ratio) << seed;
        EXPECT_TRUE(is_bare(*ratio)) << seed;
        // Adapting is symmetric, gives one dimension, changes nothing that has it already, and twice is once.
        const auto pair = adapted(a, unit, b, unit), swapped = adapted(b, unit, a, unit);
        ASSERT_EQ(pair.has_value(), swapped.has_value()) << seed;
        EXPECT_EQ(pair.has_value(), same_dimension(a, b) || is_bare(a) || is_bare(b)) << seed;
        if (!pair) continue;
        EXPECT_TRUE(same_dimension(pair->first, pair->second)) << seed;
        EXPECT_EQ(pair->first, swapped->second) << seed;
        EXPECT_EQ(pair->second, swapped->first) << seed;
        if (same_dimension(a, b)) {
            EXPECT_EQ(pair->first, a) << seed;
        }
        const auto again = adapted(pair->first, Unit::m, pair->second, Unit::m);
        EXPECT_EQ(again->first, pair->first) << seed;
        // Distribution over a sum of adapted quantities.
        Quantity sum = pair->first;
        sum.value += pair->second.value;
        const auto first = multiplied(c, pair->first), second = multiplied(c, pair->second), both = multiplied(c, sum);
        if (first && second && both) {
            EXPECT_NEAR(first->value + second->value, both->value,
                        1e-9 * (std::fabs(first->value) + std::fabs(second->value)))
                << seed;
        }
    }
}

TEST(Quantities, UnitsConvertBothWays) {
    for (std::uint64_t seed = 1; seed <= case_count(1000); ++seed) {
        CaseRandom random(seed);
        const Unit unit = any_unit(random);
        const double value = any_real(random);
        EXPECT_NEAR(from_px(to_px(value, unit), unit), value, 1e-14 * std::fabs(value)) << seed;
        const Quantity bare{value, 0, false};
        const auto area = adapted(bare, unit, Quantity{0, 2, false});
        EXPECT_NEAR(area->value, value * px_per(unit) * px_per(unit), 1e-13 * std::fabs(area->value)) << seed;
    }
    EXPECT_EQ(to_px(25.4, Unit::mm), 96);
    EXPECT_EQ(to_px(2.54, Unit::cm), 96);
    EXPECT_EQ(to_px(72, Unit::pt), 96);
    EXPECT_EQ(quantity_of({1, Unit::turn}), (Quantity{360, 0, true}));
    EXPECT_EQ(quantity_of({50, Unit::percent}), (Quantity{0.5, 0, false}));
    EXPECT_EQ(quantity_of({2, Unit::megabyte}), (Quantity{2e6, 0, false}));
}

TEST(Values, AreShownAsADocumentWouldWriteThem) {
    EXPECT_EQ(to_text(number_value(0.1)), "0.1");
    EXPECT_EQ(to_text(Value{Quantity{30, 0, true}, {}}), "30deg");
    EXPECT_EQ(to_text(Value{std::string("a\"\\\n\x01"), {}}), "\"a\\\"\\\\\\n\\u{01}\"");
    EXPECT_EQ(to_text(Value{Vec{1, -2}, {}}), "(1, -2)");
    EXPECT_EQ(to_text(Value{ValueList{{number_value(1), Value{Symbol{"keep"}, {}}}}, {}}), "[1, keep]");
    const Value call{SymbolicCall{"turn", {{"", number_value(30), {}}, {"by", Value{true, {}}, {}}}}, {}};
    EXPECT_EQ(to_text(call), "turn(30, by: true)");
    EXPECT_EQ(kind_of(call), "a call");
    EXPECT_TRUE(call == call);
    // Written and read again, a value is the same.
    for (const std::string_view text : {"25", "30deg", "\"a\\\"\\\\\\n\\u{7f}\"", "#a03020", "[1, [2, 3]]", "(1, 2)"}) {
        const Result<Value> value = evaluate(*expression_of(text), {});
        ASSERT_TRUE(value) << text;
        const Result<Value> again = evaluate(*expression_of(to_text(*value)), {});
        ASSERT_TRUE(again) << to_text(*value);
        EXPECT_TRUE(*value == *again) << text;
    }
}

}  // namespace
}  // namespace filigree
