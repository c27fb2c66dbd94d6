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
};

Region transformed(const Region& region, const Transform& by);
curves::Bounds bounds_of(const Region& region);

// Whether an element has a point inside that lies deeper than `depth` px. Curves are followed in 64 pieces.
bool reaches_into(const curves::Element& element, const Region& region, double depth);

}  // namespace filigree::shape
