// Where two elements lie on one descriptor: the stretches that they have in common, what is left of one beside others,
// and the one that they make together. Paper: section 3.2, figures 3, 7 and 8.
//
// Positions are measured on the longer of the two, since the shorter knows its descriptor less well. Ends are taken
// over as they are, so that what was exact stays exact, unless they lie noticeably off the curve that they end.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "curves/ambiguity.h"
#include "curves/element.h"

namespace filigree::curves {

// A stretch of an element's own parameter interval; `first` and `last` are its ends in the plane.
struct Stretch {
    Interval on;
    Vec first, last;
};

// At most two: an arc may meet another at both of its ends.
struct Stretches {
    std::array<Stretch, 2> all{};
    std::size_t count = 0;
    bool has_all = false;  // of the other element, whose stretches these are

    std::span<const Stretch> span() const& { return {all.data(), count}; }
    std::span<const Stretch> span() && = delete;  // it would outlive what it shows
};

// The stretches of `e` that `other` covers, longer than the tolerance, in order; of a point the point. Weights do not
// matter.
Stretches covered(const Element& e, const Element& other, double tolerance, Ambiguities* ambiguities = nullptr);

// What two elements have in common, as pieces of the longer one or as the shorter one itself. The weight is the lesser.
std::vector<Element> common(const Element& a, const Element& b, double tolerance, Ambiguities* ambiguities = nullptr);

// What is left of `e` where it is not covered; no rest is shorter than the tolerance. Stretches in any order.
std::vector<Element> uncovered(const Element& e, std::vector<Stretch> stretches, double tolerance,
                               Ambiguities* ambiguities = nullptr);

// Two elements that share a descriptor and touch or overlap, as one; of equal weight. Nothing where they do not.
std::optional<Element> joined(const Element& a, const Element& b, double tolerance);
// Notes where they are not one for little.
void note_nearly_joined(const Element& a, const Element& b, double tolerance, Ambiguities& ambiguities);

}  // namespace filigree::curves
