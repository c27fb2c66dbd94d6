// The symmetries of a left side: which transforms within a group carry it onto itself; and what they mean for rules.
//
// A match stands for all transforms that differ by a symmetry g of the left side. Where g changes the right side, a
// rule can be applied to the match in as many ways as there are different pictures: one of each coset of those
// symmetries that keep the right side, too.
#pragma once

#include <span>
#include <vector>

#include "curves/match.h"
#include "curves/shape.h"

namespace filigree::curves {

struct Symmetry {
    Transform by;
    bool is_reflected = false;
    std::vector<std::uint32_t> images;  // the element that each element is carried onto

    bool operator==(const Symmetry&) const = default;
};

// The identity first, then by angle, those that reflect last. Within the options' group, so for `similarity` the
// isometries; weights are equal whatever the options say. Of what turns freely about a point, such as a circle, the
// turns are left out.
std::vector<Symmetry> symmetries(const Shape& shape, const MatchOptions& options);

// Of the left side's symmetries those that make different pictures of the right side and the conditions; the identity
// first. All shapes are maximal.
std::vector<Symmetry> variants(std::span<const Symmetry> symmetries, const Shape& right,
                               std::span<const Shape> conditions, double tolerance);
// The transforms by which a rule can be applied to a match, one for each variant.
std::vector<Transform> applications(const Match& match, std::span<const Symmetry> variants);

}  // namespace filigree::curves
