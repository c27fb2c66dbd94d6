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
    std::vector<Element> elements;  // each in normal form; sorted by comes_before

    bool operator==(const Shape&) const = default;
};

}  // namespace filigree::curves
