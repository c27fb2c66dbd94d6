// The order of matches.
#pragma once

#include <tuple>
#include <vector>

#include "curves/match.h"

namespace filigree::curves {

// Where a match stands among others: by scale, the centroid's x and y, and the angle, all coarse, so that rounding does
// not decide; where these are equal by the exact values.
struct MatchRank {
    double scale = 0, x = 0, y = 0, angle = 0;
    bool is_reflected = false;
    double exact_scale = 0, exact_x = 0, exact_y = 0, exact_angle = 0;

    auto key() const { return std::tie(scale, x, y, angle, is_reflected, exact_scale, exact_x, exact_y, exact_angle); }
    bool operator<(const MatchRank& other) const { return key() < other.key(); }
};
MatchRank rank_of(const Match& match, double tolerance);

// Where the x axis is turned to by the linear part of a transform, in [0, 360).
double angle_of(const Transform& by);

// Sorts matches, and drops those that are there already: with the same transform to within some tolerances.
void put_in_order(std::vector<Match>& matches, double tolerance);

}  // namespace filigree::curves
