// The search for subshapes: every way in which a left side, moved within a group, lies on a design.
//
// Elements need not be elements of the design: each has to lie on one, so parts of curves match that nobody drew as
// such. A curve of the left side fixes the transform by itself (frame.h), the one with the fewest possible carriers in
// the design is tried on each of them, and all other elements are then looked up where the transform says. Paper:
// section 3.1; there the user is asked, here all matches are found.
#pragma once

#include <span>

#include "curves/match_index.h"
#include "curves/matches.h"
#include "curves/shape.h"
#include "curves/symmetry.h"

namespace filigree::curves {

// The left side must be a maximal shape. Where nothing fixes a transform there are families instead of matches; what of
// them has no room to move is a match all the same.
Matches find_matches(const Shape& left, const MatchIndex& design, const MatchOptions& options);
// The same for who has the left side's symmetries under these options already.
Matches find_matches(const Shape& left, const MatchIndex& design, const MatchOptions& options,
                     std::span<const Symmetry> symmetries);

}  // namespace filigree::curves
