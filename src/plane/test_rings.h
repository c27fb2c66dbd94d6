// For tests alone: polygons from rings, and the same polygons told from other points on.
#pragma once

#include <algorithm>
#include <vector>

#include "plane/polygon.h"

namespace filigree {

using Ring = std::vector<Point>;

// One polygon a ring.
inline Polygons polygons_of(const std::vector<Ring>& rings) {
    Polygons polygons;
    for (const Ring& ring : rings) {
        polygons.add_ring(ring);
        polygons.end_polygon();
    }
    return polygons;
}

// Every ring begins at its third point.
inline Polygons with_rings_turned(Polygons polygons) {
    std::size_t first = 0;
    for (const std::uint32_t end : polygons.ring_ends) {
        std::rotate(polygons.points.begin() + static_cast<std::ptrdiff_t>(first),
                    polygons.points.begin() + static_cast<std::ptrdiff_t>(first + 2), polygons.points.begin() + end);
        first = end;
    }
    return polygons;
}

}  // namespace filigree
