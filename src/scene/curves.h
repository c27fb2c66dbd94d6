// Drawn shapes that know the curve that they were flattened from (DrawnShape::curve).
#pragma once

#include "plane/path.h"
#include "scene/drawing.h"

namespace filigree {

// Whether all points and radii lie on the plane (point.h), as those of a drawing's curves do.
bool is_on_plane(const Path& path);

// Adds what a path draws, with its polygons flattened to `tolerance` px; all shapes have the key.
//
// What is not filled is lines: one shape a subpath, open even where the subpath closes; then the polygon's ring ends
// at the point where it began, and the curve closes. So are subpaths that do not close, whatever the style says. What
// the subpaths that close enclose is filled by the even-odd rule, as all formats paint: one shape for each part that
// hangs together, with its holes, its curve those subpaths. Only where subpaths cross themselves or each other no
// shape is bounded by whole ones: there polygons alone are filled, and the strokes are lines over them.
//
// A subpath that comes to less than two points on the grid, or leaves the plane, is left out.
void add_curve(Drawing& drawing, const Path& path, const Style& style, Key key, double tolerance);

}  // namespace filigree
