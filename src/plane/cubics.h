// Paths of lines and cubic Beziers alone: what PDF and raster libraries draw.
#pragma once

#include "plane/path.h"

namespace filigree {

// The same path: quadratics are raised, exact but for rounding; arcs become cubics that are true to 1e-9 of their
// radius (arc.h), and degenerate ones their chord.
Path in_cubics(const Path& path);

}  // namespace filigree
