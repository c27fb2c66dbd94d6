// The corners of an offset ring: which of them open a gap when their edges move, and what fills it.
//
// Rings have their polygon on the side of `perpendicular(direction)`, holes too. Moving the edges that way
// opens a gap at reflex corners (those of the outer ring, and the convex corners of holes). The gap is filled
// by edges of zero length that move like any other, each along its own normal, and every two neighbours then
// meet at a mitre: none for a mitre within the limit, one for a corner cut square, several for a rounded one.
// They touch the arc from outside, so that nothing of the result lies nearer than the distance.
#pragma once

#include <vector>

#include "plane/inset.h"

namespace filigree {

struct JoinRule {
    double least_mitre_sum2 = 0;  // mitre: least |n1 + n2|^2 of two unit normals that meet at a mitre
    double most_turn = 0;         // round: radians that two neighbours may turn; 0 where mitred
};
JoinRule join_rule(const InsetOptions& options, double distance);

// Whether the corner from direction `in` to direction `out` (unit vectors) opens a gap. One that runs back into
// itself counts: a slit's end must be kept away from, and a spike's end lies outside.
inline bool opens_gap(Vec in, Vec out) {
    const double turn = cross(in, out);
    return turn < 0 || (turn < 1e-12 && dot(in, out) < 0);
}

// Appends the normals that fill the gap at a corner; none where it opens none.
void append_fill(Vec in, Vec out, const JoinRule& rule, std::vector<Vec>& normals);

// How the corner between lines of unit normals a and b moves when both move by one; not for opposite normals.
inline Vec corner_velocity(Vec a, Vec b) {
    const Vec sum = a + b;
    return sum * (2 / dot(sum, sum));
}

}  // namespace filigree
