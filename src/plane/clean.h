// From outlines as people draw them to clean polygons, and polygon booleans.
//
// Everything from outside passes through `clean` once: self-crossing, touching and duplicated outlines,
// zero-width spikes and repeated points come out as polygons that keep polygon.h's conventions. After that
// every operator is closed over clean polygons. The booleans are for rare use (overlapping starts); splits
// and insets have their own, far faster ways.
//
// How: edges are cut where they meet (noding.h), a sweep finds the winding number of every face, and the
// boundary is traced (overlay.h). All decisions are exact; a crossing is rounded to the grid, which moves a
// boundary by about 2^-26 px and is the only error. Guarantees: no ring visits a point twice, repeats a
// point, or has a point on a straight line between its neighbours; rings cross nowhere and share no edge (they
// may touch at points). Each ring starts at its highest point (lowest y, then lowest x), and polygons and the
// holes of each come in the order of these points. The result depends on the outlines as directed curves
// alone, not on their order or first points. Cost: O((edges + crossings) log edges) for outlines as people draw
// them; a million points without crossings take about a second.
#pragma once

#include <vector>

#include "plane/path.h"
#include "plane/polygon.h"

namespace filigree {

enum class FillRule { nonzero, even_odd };

// The area that the polylines enclose together by the rule; open polylines are taken as closed. Pieces
// thinner than the grid vanish. An outline with a point that is not finite or off the plane (point.h) is left
// out whole.
Polygons clean(const std::vector<Polyline>& outlines, FillRule rule);
Polygons clean(const std::vector<std::vector<Point>>& rings, FillRule rule);

// Either may overlap itself: a point is in it where the winding number is not zero.
Polygons unite(const Polygons& a, const Polygons& b);
Polygons subtract(const Polygons& a, const Polygons& b);
Polygons intersect(const Polygons& a, const Polygons& b);

}  // namespace filigree
