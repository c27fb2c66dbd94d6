// The moving front of a ring: its edges advance side by side, and those that shrink to nothing are taken out
// in the order of their times. The fast way of an inset.
//
// The front does not see parts of itself, or other rings, that it runs into. So the caller checks: every
// event must lie as far from all rings as its time says, and the final ring must too, and be simple.
#pragma once

#include <span>
#include <vector>

#include "plane/offset_corner.h"

namespace filigree {

struct FrontEvent {
    Vec at;           // where an edge shrank to nothing
    double time = 0;  // the distance by then
};

struct Front {
    std::vector<Vec> ring;           // at the full distance; empty where it vanished
    std::vector<FrontEvent> events;  // those up to the distance, in order
};

// `ring` has at least three points, no two equal in a row, and its polygon at the left of its edges (seen
// with y upwards). O(n log n).
Front advance_front(std::span<const Vec> ring, double distance, const JoinRule& rule);

}  // namespace filigree
