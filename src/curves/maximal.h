// The maximal representation of a shape: whatever lies together on one curve is one element.
//
// Elements that share a descriptor and overlap or touch become one, with the outermost ends; arcs that go all round
// become the whole circle. Where elements of different weight overlap, the heavier one is seen and the lighter one is
// cut: on each descriptor the weight is a function of the position, and the shape shows the greatest. Paper: sections
// 2.2 and 3.2, figures 3 and 7.
//
// The order in which elements are given does not matter, to the last bit; nor, to within the tolerance, into which
// pieces curves are cut. A maximal shape is its own maximal shape, to the last bit. O(n log n).
#pragma once

#include <vector>

#include "curves/ambiguity.h"
#include "curves/shape.h"

namespace filigree::curves {

// Of elements as they are drawn: they come into normal form once pieces have been put together.
Shape maximal(std::vector<Element> elements, double tolerance, Ambiguities* ambiguities = nullptr);

// Of elements that are in normal form already, or pieces of such, which keep their kind.
Shape merged(std::vector<Element> elements, double tolerance, Ambiguities* ambiguities = nullptr);

}  // namespace filigree::curves
