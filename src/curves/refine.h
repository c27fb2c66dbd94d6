// The transform under which parts fit their carriers best: an ill-conditioned one, found from a single shallow arc, is
// mended by all the others.
#pragma once

#include <span>

#include "curves/match.h"

namespace filigree::curves {

struct Pairing {
    const Element* part = nullptr;     // of the left side
    const Element* carrier = nullptr;  // of the design
};

// Gauss-Newton steps within the group (with it a reflecting transform stays one) on the distances of the parts'
// points from the carriers' descriptors, and on what sticks out beyond the carriers' ends. What the pairs leave free
// stays as it is.
Transform refined(const Transform& start, MatchGroup group, std::span<const Pairing> pairs);

}  // namespace filigree::curves
