// The search for subshapes under affine maps.
//
// A curve fixes no affine map, since any parabola can be stretched onto any other in many ways. What does are three
// points that stay what they are: registration points (registration.h), or what two of them make with the tangents
// there. A left side with fewer has infinitely many embeddings or none, and nothing is found.
#pragma once

#include <vector>

#include "curves/matches.h"
#include "curves/match_index.h"
#include "curves/shape.h"
#include "curves/symmetry.h"

namespace filigree::curves {

struct AffineMatches {
    Matches matches;
    bool is_indeterminate = false;  // the left side does not fix an affine map
};

// The left side must be a maximal shape. Matches that differ by an affine symmetry of it are one: the one that does not
// reflect, where there is one, and turns the x axis least.
AffineMatches find_affine_matches(const Shape& left, const MatchIndex& design, const MatchOptions& options);

// Whether a left side has what fixes an affine map.
bool fixes_affine_maps(const Shape& left, double tolerance);

// The affine maps that carry a shape onto itself, the identity first; that alone where it does not fix a map.
std::vector<Symmetry> affine_symmetries(const Shape& shape, const MatchOptions& options);

}  // namespace filigree::curves
