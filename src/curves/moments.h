// Where the curves of a shape lie on the whole: how long they are together, their centre of mass and their spread.
#pragma once

#include "curves/shape.h"

namespace filigree::curves {

// Integrals along the curves; of a shape that has none over its points, each counting one.
struct Moments {
    double length = 0;              // px
    Vec first;                      // of the place,
    double xx = 0, xy = 0, yy = 0;  // and of its products
};
Moments moments_of(const Shape& shape);

// The centre of mass. It goes where a similarity takes the shape, and stays where the shape's symmetries leave it.
Vec centroid_of(const Shape& shape);

}  // namespace filigree::curves
