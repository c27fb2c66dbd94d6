// How far a turtle has turned about one axis: whole multiples of its angles, not a rotation that is multiplied up.
//
// Where all angles are simple parts of the full turn (30, 22.5, 25.7, 360/7), they are counted in units of
// 360/per_turn degrees, in whole numbers: twelve times 30 is no turn at all. Else they are counted in units so fine
// that every angle of 2^-40 degrees and more is a whole number of them; smaller ones are rounded to that. Either way
// nothing is rounded as turns add up. Directions have the symmetries of the square to the last bit.
#pragma once

#include <cstdint>
#include <vector>

#include "base/elementary.h"
#include "plane/point.h"

namespace filigree::rewriting {

struct TurnScale {
    std::uint32_t per_turn = 0;   // units of a full turn, a multiple of 4; 0: the angles have none in common
    Int128 full = 0;              // units of a full turn, whichever they are
    std::vector<Int128> amounts;  // of the angles, counterclockwise, in [0, full)

    Int128 opposite(Int128 amount) const { return amount == 0 ? 0 : full - amount; }
};
TurnScale turn_scale(const std::vector<double>& angles);  // degrees, finite

// Counterclockwise as seen against the axis.
struct Turn {
    Int128 amount = 0;  // in [0, full)
    double rest = 0;    // degrees of other turns, in (-360, 360)

    bool operator==(const Turn&) const = default;
    bool is_none() const { return amount == 0 && rest == 0; }
};

inline void add_amount(Turn& turn, const TurnScale& scale, Int128 amount) {  // in [0, full)
    turn.amount += amount;
    if (turn.amount >= scale.full) turn.amount -= scale.full;
}
void add_degrees(Turn& turn, double degrees);  // finite

elementary::CosSin direction_of_units(std::uint32_t units, std::uint32_t per_turn);  // units < per_turn
elementary::CosSin direction(const Turn& turn, const TurnScale& scale);

}  // namespace filigree::rewriting
