// Parts of the plane that rules want void.
#pragma once

#include <span>
#include <vector>

#include "curves/element.h"
#include "plane/transform.h"

namespace filigree::shape {

// The points inside a closed polygon, by the even-odd rule; its border is outside.
struct Region {
    std::vector<Vec> corners;  // px
    double error = 0;          // px: how far the polygon may lie off the curves that it stands for
};

Region transformed(const Region& region, const Transform& by);
curves::Bounds bounds_of(const Region& region);

// Whether an element has a point inside that lies deeper than `depth` px, and than the region's error. Curves are
// tried at 256 places and where their chords cross the border.
bool reaches_into(const curves::Element& element, const Region& region, double depth);

}  // namespace filigree::shape
