// Where a shape's curves lie as a whole: their length, their middle and how far they spread about it.
#pragma once

#include "curves/shape.h"

namespace filigree::curves {

// Of the length along the curves; of a shape that has none, of its points, each counting one. Equal curves have equal
// moments to within rounding, however they were moved.
struct Moments {
    double length = 0;
    Vec middle;
    double along_x = 0, along_y = 0;  // px: the root of the mean square of the distance from the middle
    double spread = 0;                // both together
};
Moments moments_of(const Shape& shape);

bool has_curves(const Shape& shape);

// The centre of mass. It goes where a similarity takes the shape, and stays where the shape's symmetries leave it.
inline Vec centroid_of(const Shape& shape) { return moments_of(shape).middle; }

}  // namespace filigree::curves
