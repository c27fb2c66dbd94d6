// The convex polygons that the straight lines of a shape enclose, and how a polygon is stretched onto another.
//
// They serve rules whose left side stands for every polygon of so many corners, as those of Stiny's ice-ray lattices
// do: "Ice-ray: a note on the generation of Chinese lattice designs" (1977).
#pragma once

#include <cstdint>
#include <vector>

#include "curves/shape.h"

namespace filigree::curves {

struct Face {
    std::vector<Vec> corners;  // px, turning from +x towards +y, from the least (x, then y) on; none is straight
};

// The convex faces of the arrangement of the lines, in the order of their first corners. Lines meet where they come
// within the tolerance of each other. A face with an end of a line, or a curve, inside is none.
std::vector<Face> convex_faces(const Shape& shape, double tolerance);

double area_of(const std::vector<Vec>& corners);  // px^2, positive where they turn from +x towards +y

// Where a point of one convex polygon comes to lie when it is stretched onto another with as many corners: by
// Wachspress's coordinates, which keep the sides straight and divide them evenly. Points outside go with the nearest
// side's line. `from` must turn as faces do.
Vec stretched(Vec p, const std::vector<Vec>& from, const std::vector<Vec>& to);

}  // namespace filigree::curves
