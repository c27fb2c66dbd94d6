// The outlines of what is dark in a picture, as polygons with the corners and curves that its pixels stand for.
//
// Marching squares over the slightly blurred picture give rings that follow its pixels; each ring is then cut into as
// few straight stretches as stay within half a pixel of it (Imai and Iri's way, as Selinger's potrace does for
// bitmaps), each stretch becomes the line that fits its points best, and neighbouring lines meet in a corner or,
// where they turn gently, in a curve. So stairs vanish, what is straight is two points, and a corner that the blur
// took off comes back where its sides meet.
//
// Guarantee: px are pixels, the picture's top left corner is (0, 0). Rings are closed; those around dark turn from +x
// towards +y, those around light within turn against them; order: as a scan in rows meets them. The same picture
// gives the same bits. Measured on drawn shapes: where edges are smooth (antialiased), outlines lie within half a
// pixel of the true ones and corners within 0.8 px, mostly far nearer; where pixels are black or white, within 1 and
// 1.4 px. Two rings may touch or cross where the picture is as thin as that: fill them nonzero.
#pragma once

#include <vector>

#include "plane/grey_image.h"
#include "plane/path.h"

namespace filigree {

struct SilhouetteOptions {
    double threshold = 0.5;  // what is at least as dark is inside; taken as within 0.001 .. 1
    double least_area = 4;   // px^2: smaller specks are left out, dark ones as well as light ones
};
std::vector<Polyline> silhouette(const GreyImage& image, const SilhouetteOptions& options = {});

}  // namespace filigree
