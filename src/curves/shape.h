// Curved shapes: finite sets of elements, in maximal representation.
//
// A shape is maximal when no two of its elements that share a descriptor have a point in common, and where weights
// differ, no point is covered twice: the smallest set of elements that looks the same. Two shapes that look the same
// to within the tolerance have the same maximal elements to within the tolerance. Paper: section 2.2.
#pragma once

#include <vector>

#include "curves/element.h"

namespace filigree::curves {

struct Shape {
    // Each in normal form, or a piece of such an element, which keeps its kind however flat it is: else what a rule
    // took away and another puts back would not merge with it again. Sorted by comes_before.
    std::vector<Element> elements;

    bool operator==(const Shape&) const = default;
};

}  // namespace filigree::curves
