// The two halves of silhouette.h: rings that follow the pixels, and the outline that they stand for.
#pragma once

#include <span>
#include <vector>

#include "plane/grey_image.h"
#include "plane/path.h"

namespace filigree {

// Marching squares with linear interpolation on the blurred picture, which is white all around. Where dark and light
// meet crosswise, the mean of the four decides.
std::vector<std::vector<Vec>> dark_rings(const GreyImage& image, double threshold);

double ring_area(std::span<const Vec> ring);  // signed, px^2

// A ring without its stairs, as lines and cubics.
Path fitted_outline(std::vector<Vec> ring);

}  // namespace filigree
