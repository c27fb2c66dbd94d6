// How far a turtle has turned about one axis: whole multiples of its angles, not a rotation that is multiplied up.
//
// Where both angles are simple parts of the full turn (30, 22.5, 25.7, 360/7), they are counted in units of
// 360/per_turn degrees, in whole numbers: twelve times 30 is no turn at all. Other angles are counted apart, and the
// products with their counts are exact before they are reduced. Directions have the symmetries of the square to the
// last bit.
#pragma once

#include <array>
#include <cstdint>

#include "base/elementary.h"

namespace filigree::rewriting {

struct TurnScale {
    std::uint32_t per_turn = 0;           // units of a full turn, a multiple of 4; 0: the angles have none in common
    std::array<std::int64_t, 2> units{};  // of angle and angle2, in [0, per_turn)
    std::array<double, 2> degrees{};      // of both, in (-360, 360)
};
TurnScale turn_scale(double angle, double angle2);  // degrees, finite

// Counterclockwise as seen against the axis.
struct Turn {
    std::array<std::int64_t, 2> counts{};  // units, in [0, per_turn), and 0; or how often each angle
    double rest = 0;                       // degrees of other turns, in (-360, 360)

    bool operator==(const Turn&) const = default;
    bool is_none() const { return (counts[0] | counts[1]) == 0 && rest == 0; }
};

inline void add_angle(Turn& turn, const TurnScale& scale, std::size_t which, int times) {  // 1 or -1 times
    if (scale.per_turn == 0) {
        turn.counts[which] += times;
        return;
    }
    std::int64_t& units = turn.counts[0];
    units += times * scale.units[which];
    if (units >= scale.per_turn) units -= scale.per_turn;
    if (units < 0) units += scale.per_turn;
}
void add_degrees(Turn& turn, double degrees);  // finite

elementary::CosSin direction_of_units(std::uint32_t units, std::uint32_t per_turn);  // units < per_turn
elementary::CosSin direction(const Turn& turn, const TurnScale& scale);

}  // namespace filigree::rewriting
