// Everything that a search for subshapes finds.
#pragma once

#include <vector>

#include "curves/family.h"
#include "curves/match.h"

namespace filigree::curves {

// Matches that differ by a symmetry of the left side are one. In order of scale, then of the centroid (x, then y), then
// of the angle, each to within rounding.
struct Matches {
    std::vector<Match> found;
    std::vector<Match> near_misses;  // those that fail by less than ten tolerances
    std::vector<Family> families;    // where too little fixes the left side; in the order of their first members
    bool is_complete = true;         // false where the limit was reached or the job was cancelled

    bool operator==(const Matches&) const = default;
};

}  // namespace filigree::curves
