#include "engines/rewriting/turtle_turns.h"

#include <cmath>
#include <numeric>
#include <optional>

namespace filigree::rewriting {
namespace {

constexpr std::int64_t most_parts = 1 << 20;  // of a full turn
constexpr double most_degrees = 0x1p20;

// Units of a degree where angles have no common part.
constexpr int fine_bits = 92;
constexpr double fine = 0x1p92;

struct Fraction {  // of a full turn
    std::int64_t over = 0, under = 1;
};

// The simplest fraction whose nearest double in degrees is the angle: by continued fractions.
std::optional<Fraction> part_of_turn(double degrees) {
    const double size = std::fabs(degrees);
    double rest = size / 360;
    Fraction before{1, 0}, now{static_cast<std::int64_t>(rest), 1};
    while (true) {
        if (static_cast<double>(360 * now.over) / static_cast<double>(now.under) == size) {
            return Fraction{degrees < 0 ? -now.over : now.over, now.under};
        }
        const double left = rest - std::floor(rest);
        if (left <= 1.0 / most_parts) return std::nullopt;  // the next fraction would have more
        rest = 1 / left;
        const auto whole = static_cast<std::int64_t>(rest);
        const Fraction next{whole * now.over + before.over, whole * now.under + before.under};
        if (next.under > most_parts) return std::nullopt;
        before = now;
        now = next;
    }
}

double in_turn(double degrees) { return std::fabs(degrees) < 360 ? degrees : std::fmod(degrees, 360.0); }  // exact

// The units of a full turn in which all these angles are whole numbers; 0 where there are none so large.
std::uint32_t common_parts(const std::vector<Fraction>& parts) {
    std::int64_t per_turn = 4;
    for (const Fraction& part : parts) {
        per_turn = std::lcm(per_turn, part.under);
        if (per_turn > most_parts) return 0;
    }
    return static_cast<std::uint32_t>(per_turn);
}

// A direction's nearest axis, counted in quarter turns, and what it is from there, at most half a quarter.
template <class Whole>
struct FromAxis {
    int quarters = 0;
    Whole rest = 0;

    FromAxis(Whole amount, Whole quarter) : quarters(static_cast<int>(amount / quarter)), rest(amount % quarter) {
        if (2 * rest <= quarter) return;
        rest -= quarter;
        ++quarters;
    }
};

elementary::CosSin turned_by_quarters(elementary::CosSin from_axis, int quarters) {
    const auto [c, s] = from_axis;
    switch (quarters % 4) {
        case 0:
            return {c, s};
        case 1:
            return {0.0 - s, c};
        case 2:
            return {-c, 0.0 - s};
        default:
            return {s, -c};
    }
}

}  // namespace

TurnScale turn_scale(const std::vector<double>& angles) {
    TurnScale scale;
    std::vector<Fraction> parts;
    for (const double angle : angles) {
        // Before it is reduced: 450.1 less 360 is not quite 90.1.
        const auto part = part_of_turn(std::fabs(angle) < most_degrees ? angle : in_turn(angle));
        if (!part) break;
        parts.push_back(*part);
    }
    if (parts.size() == angles.size()) scale.per_turn = common_parts(parts);
    scale.full = scale.per_turn != 0 ? scale.per_turn : Int128{360} << fine_bits;
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const Int128 amount = scale.per_turn != 0
                                  ? Int128{parts[i].over % parts[i].under * (scale.per_turn / parts[i].under)}
                                  : static_cast<Int128>(in_turn(angles[i]) * fine);
        scale.amounts.push_back(amount < 0 ? amount + scale.full : amount);
    }
    return scale;
}

void add_degrees(Turn& turn, double degrees) { turn.rest = in_turn(turn.rest + in_turn(degrees)) + 0.0; }

elementary::CosSin direction_of_units(std::uint32_t units, std::uint32_t per_turn) {
    const FromAxis<std::int64_t> from(units, per_turn / 4);
    const double degrees = static_cast<double>(360 * from.rest) / per_turn;
    return turned_by_quarters(elementary::cos_sin_degrees(degrees), from.quarters);
}

elementary::CosSin direction(const Turn& turn, const TurnScale& scale) {
    if (turn.rest == 0) {
        if (scale.per_turn != 0) return direction_of_units(static_cast<std::uint32_t>(turn.amount), scale.per_turn);
        const FromAxis<Int128> from(turn.amount, scale.full / 4);
        return turned_by_quarters(elementary::cos_sin_degrees(static_cast<double>(from.rest) / fine), from.quarters);
    }
    const Int128 shortest = 2 * turn.amount > scale.full ? turn.amount - scale.full : turn.amount;
    const double degrees = scale.per_turn != 0 ? static_cast<double>(360 * shortest) / scale.per_turn
                                               : static_cast<double>(shortest) / fine;
    return elementary::cos_sin_degrees(degrees + turn.rest);
}

}  // namespace filigree::rewriting
