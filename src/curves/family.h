// Infinitely many matches at once: a left side that too little fixes, such as one line, parallel lines, lines through
// one point, or arcs about one centre, can be slid, turned or grown on the design and still lies on it.
//
// A family says which way it goes and how far, and names members that one would choose: with an end on an end, in the
// middle, as large as may be, as large as it was drawn. Paper: section 2.3 leaves such shapes to the user.
#pragma once

#include <cstdint>
#include <vector>

#include "curves/match.h"

namespace filigree::curves {

enum class FamilyKind : std::uint8_t {
    slide,             // along a direction
    turn,              // about a centre
    growth,            // about a centre
    slide_and_growth,  // a line on a line
    turn_and_growth,   // a point on a point
};

// How much room a part has on its carrier. Slides: px along the direction from the centre; turns: degrees about it;
// growth: px from it, along the part's own line.
struct Room {
    double from = 0, to = 0;   // where the part lies under the family's first transform, from <= to
    double low = 0, high = 0;  // where its carrier does

    bool operator==(const Room&) const = default;
};

struct Family {
    FamilyKind kind = FamilyKind::slide;
    Transform by;  // the member with no slide, no turn and a growth of 1, which need not lie on the design itself
    bool is_reflected = false;
    Vec centre;       // of turns and growth, in the design; slides are told from here
    Vec along{1, 0};  // of slides, a unit
    Interval moves;   // slides, px, and turns, degrees; where growth is free as well, those at the largest growth
    Interval growth{1, 1};
    bool turns_freely = false;            // all the way round
    std::vector<Room> rooms;              // of what bounds it
    std::vector<std::uint32_t> carriers;  // the slot of the design on which each left element lies
    std::vector<Match> members;           // some to choose from, in order

    bool operator==(const Family&) const = default;
};

// The member with a slide or turn, and a growth.
Transform member_of(const Family& family, double move, double growth);
// By how much it can be slid at a growth: a line on a line has the less room the larger it is.
Interval moves_at(const Family& family, double growth);

}  // namespace filigree::curves
