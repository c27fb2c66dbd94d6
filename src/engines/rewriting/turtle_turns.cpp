#include "engines/rewriting/turtle_turns.h"

#include <cmath>
#include <numeric>
#include <optional>

#include "base/exact_sum.h"

namespace filigree::rewriting {
namespace {

constexpr std::int64_t most_parts = 1 << 20;  // of a full turn
constexpr double most_degrees = 0x1p20;

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

}  // namespace

TurnScale turn_scale(double angle, double angle2) {
    TurnScale scale;
    scale.degrees = {in_turn(angle), in_turn(angle2)};
    std::int64_t per_turn = 4;
    std::array<Fraction, 2> parts;
    for (const std::size_t i : {0U, 1U}) {
        // Before it is reduced: 450.1 less 360 is not quite 90.1.
        const double whole = i == 0 ? angle : angle2;
        const auto part = part_of_turn(std::fabs(whole) < most_degrees ? whole : scale.degrees[i]);
        if (!part) return scale;
        parts[i] = *part;
        per_turn = std::lcm(per_turn, part->under);
        if (per_turn > most_parts) return scale;
    }
    scale.per_turn = static_cast<std::uint32_t>(per_turn);
    for (const std::size_t i : {0U, 1U}) {
        const std::int64_t units = parts[i].over % parts[i].under * (per_turn / parts[i].under);
        scale.units[i] = units < 0 ? units + per_turn : units;
    }
    return scale;
}

void add_degrees(Turn& turn, double degrees) { turn.rest = in_turn(turn.rest + in_turn(degrees)) + 0.0; }

elementary::CosSin direction_of_units(std::uint32_t units, std::uint32_t per_turn) {
    const std::int64_t quarter = per_turn / 4;
    std::int64_t quarters = units / quarter, rest = units % quarter;
    if (2 * rest > quarter) {
        rest -= quarter;
        ++quarters;
    }
    const auto [c, s] = elementary::cos_sin_degrees(static_cast<double>(360 * rest) / per_turn);
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

elementary::CosSin direction(const Turn& turn, const TurnScale& scale) {
    if (scale.per_turn != 0) {
        const auto units = static_cast<std::uint32_t>(turn.counts[0]);
        if (turn.rest == 0) return direction_of_units(units, scale.per_turn);
        const std::int64_t shortest = 2 * turn.counts[0] > scale.per_turn ? turn.counts[0] - scale.per_turn : units;
        return elementary::cos_sin_degrees(static_cast<double>(360 * shortest) / scale.per_turn + turn.rest);
    }
    const ExactSum first = two_product(static_cast<double>(turn.counts[0]), scale.degrees[0]);
    const ExactSum second = two_product(static_cast<double>(turn.counts[1]), scale.degrees[1]);
    const double near = in_turn(in_turn(first.high) + in_turn(second.high)) + turn.rest;
    return elementary::cos_sin_degrees(near + (first.low + second.low));
}

}  // namespace filigree::rewriting
