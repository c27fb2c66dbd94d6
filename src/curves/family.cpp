#include "curves/family.h"

#include <algorithm>

#include "curves/similarity.h"

namespace filigree::curves {

Transform member_of(const Family& family, double move, double growth) {
    const bool turns = family.kind == FamilyKind::turn || family.kind == FamilyKind::turn_and_growth;
    const Vec to = family.centre + (turns ? Vec{} : family.along * move);
    const Vec turn = turns ? unit_at_degrees(move) : Vec{1, 0};
    return compose(to_transform(carrying(family.centre, to, turn * growth, false)), family.by);
}

Interval moves_at(const Family& family, double growth) {
    if (family.kind != FamilyKind::slide_and_growth) return family.moves;
    Interval moves{-1e300, 1e300};
    for (const Room& room : family.rooms) {
        moves.from = std::max(moves.from, room.low - growth * room.from);
        moves.to = std::min(moves.to, room.high - growth * room.to);
    }
    return moves;
}

}  // namespace filigree::curves
