#include "engines/rewriting/turtle_turns.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "engines/rewriting/turtle_cases.h"

namespace filigree::rewriting {
namespace {

using elementary::CosSin;

bool are_same(CosSin a, CosSin b) {
    return std::bit_cast<std::uint64_t>(a.cos) == std::bit_cast<std::uint64_t>(b.cos) &&
           std::bit_cast<std::uint64_t>(a.sin) == std::bit_cast<std::uint64_t>(b.sin);
}

Turn times(const TurnScale& scale, std::size_t which, int count) {
    const Int128 once = scale.amounts[which], amount = count < 0 ? scale.opposite(once) : once;
    Turn turn;
    for (int i = 0; i < std::abs(count); ++i) add_amount(turn, scale, amount);
    return turn;
}

TEST(TurtleTurns, SimpleAnglesArePartsOfATurn) {
    EXPECT_EQ(turn_scale({30, 30}).per_turn, 12U);
    EXPECT_EQ(turn_scale({30, 45}).per_turn, 24U);
    EXPECT_EQ(turn_scale({25.7, 0}).per_turn, 3600U);
    EXPECT_EQ(turn_scale({360.0 / 7, 90}).per_turn, 28U);
    EXPECT_EQ(turn_scale({0, 0}).per_turn, 4U);
    EXPECT_EQ(turn_scale({450.1, 450.1}).per_turn, 3600U);
    EXPECT_EQ(turn_scale({-60, 60}).amounts[0], 10);
    EXPECT_EQ(turn_scale({-60, 60}).amounts[1], 2);
    EXPECT_EQ(turn_scale({137.50776405003785, 90}).per_turn, 0U) << "the golden angle is no simple part";
    EXPECT_EQ(turn_scale({1e300, 90}).per_turn, turn_scale({std::fmod(1e300, 360.0), 90}).per_turn);
    EXPECT_EQ(turn_scale({1e-300, 90}).per_turn, 0U);
}

TEST(TurtleTurns, EveryPartIsFound) {
    for (std::uint64_t i = first_seed(); i < first_seed() + case_count(); ++i) {
        CaseRandom random(i);
        const std::uint32_t parts = 1 + random.below(1 << 18);
        const double angle = 360.0 * random.below(parts) / parts;
        const TurnScale scale = turn_scale({angle, 0});
        ASSERT_NE(scale.per_turn, 0U) << angle;
        EXPECT_EQ(360 * static_cast<double>(scale.amounts[0]) / scale.per_turn, angle);
        EXPECT_EQ(4ULL * parts % scale.per_turn, 0U) << angle << " of " << parts;
    }
}

TEST(TurtleTurns, FullTurnsAreNone) {
    EXPECT_EQ(times(turn_scale({30, 0}), 0, 12), Turn{});
    EXPECT_EQ(times(turn_scale({360.0 / 7, 0}), 0, -7), Turn{});
    EXPECT_EQ(times(turn_scale({25.7, 0}), 0, 3600), Turn{});
    Turn turn;
    add_degrees(turn, 100);
    add_degrees(turn, 300);
    EXPECT_EQ(turn.rest, 40);
    add_degrees(turn, -400);
    EXPECT_EQ(turn, Turn{});
}

TEST(TurtleTurns, DirectionsHaveTheSymmetriesOfTheSquare) {
    for (const std::uint32_t parts : {4U, 12U, 16U, 28U, 64U, 3600U, 1000004U}) {
        const std::uint32_t step = parts > 5000 ? 997 : 1;
        for (std::uint32_t units = 0; units < parts; units += step) {
            const CosSin here = direction_of_units(units, parts);
            EXPECT_TRUE(are_same(direction_of_units((units + parts / 4) % parts, parts), {0.0 - here.sin, here.cos}));
            EXPECT_TRUE(are_same(direction_of_units((parts - units) % parts, parts), {here.cos, 0.0 - here.sin}));
            EXPECT_TRUE(are_same(direction_of_units(units * 3, parts * 3), here)) << "however it is written";
            const long double angle = 2 * std::acos(-1.0L) * units / parts;
            EXPECT_NEAR(here.cos, static_cast<double>(std::cos(angle)), 2e-16);
            EXPECT_NEAR(here.sin, static_cast<double>(std::sin(angle)), 2e-16);
        }
    }
    EXPECT_TRUE(are_same(direction_of_units(2, 12), {0.5, direction_of_units(2, 12).sin}));
}

TEST(TurtleTurns, NothingDrifts) {
    const double golden = 137.50776405003785;
    const TurnScale scale = turn_scale({golden, 90});
    ASSERT_EQ(scale.per_turn, 0U);
    const Turn turn = times(scale, 0, 1000003);
    const long double exact = std::fmod(static_cast<long double>(golden) * 1000003, 360.0L) * std::acos(-1.0L) / 180;
    EXPECT_NEAR(direction(turn, scale).cos, static_cast<double>(std::cos(exact)), 3e-13);
    EXPECT_NEAR(direction(turn, scale).sin, static_cast<double>(std::sin(exact)), 3e-13);
    const CosSin back = direction(times(scale, 0, -1000003), scale);
    EXPECT_TRUE(are_same(back, {direction(turn, scale).cos, -direction(turn, scale).sin}));
}

// However many angles there are, and whether or not they have a part in common.
TEST(TurtleTurns, OppositeTurnsCancel) {
    for (std::uint64_t i = first_seed(); i < first_seed() + case_count(); ++i) {
        CaseRandom random(i);
        std::vector<double> angles;
        for (std::uint32_t left = 1 + random.below(8); left > 0; --left) angles.push_back(random_angle(random));
        const TurnScale scale = turn_scale(angles);
        std::vector<Int128> amounts;
        Turn turn;
        double degrees = 0;
        for (int k = 0; k < 40; ++k) {
            const std::size_t which = random.index(angles.size());
            const bool is_back = random.coin();
            degrees += is_back ? -angles[which] : angles[which];
            amounts.push_back(is_back ? scale.opposite(scale.amounts[which]) : scale.amounts[which]);
            add_amount(turn, scale, amounts.back());
        }
        const CosSin wanted = elementary::cos_sin_degrees(degrees), here = direction(turn, scale);
        ASSERT_NEAR(here.cos, wanted.cos, 1e-12);
        ASSERT_NEAR(here.sin, wanted.sin, 1e-12);
        while (!amounts.empty()) {
            const std::size_t which = random.index(amounts.size());
            add_amount(turn, scale, scale.opposite(amounts[which]));
            amounts.erase(amounts.begin() + static_cast<std::ptrdiff_t>(which));
        }
        ASSERT_EQ(turn, Turn{});
    }
}

TEST(TurtleTurns, OtherDegreesAreAdded) {
    const TurnScale scale = turn_scale({30, 0});
    Turn turn = times(scale, 0, 5);
    add_degrees(turn, -105);
    EXPECT_TRUE(are_same(direction(turn, scale), elementary::cos_sin_degrees(45)));
}

}  // namespace
}  // namespace filigree::rewriting
