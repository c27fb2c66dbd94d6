#include "plane/silhouette.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "plane/silhouette_rings.h"

namespace filigree {
namespace {

constexpr double curve_tolerance = 0.05;  // px

}  // namespace

std::vector<Polyline> silhouette(const GreyImage& image, const SilhouetteOptions& options) {
    std::vector<Polyline> outlines;
    for (std::vector<Vec>& ring : dark_rings(image, std::clamp(options.threshold, 0.001, 1.0))) {
        if (ring.size() < 3 || std::fabs(ring_area(ring)) < options.least_area) continue;
        for (Polyline& line : flatten(fitted_outline(std::move(ring)), curve_tolerance)) {
            if (line.points.size() >= 3) outlines.push_back(std::move(line));
        }
    }
    return outlines;
}

}  // namespace filigree
