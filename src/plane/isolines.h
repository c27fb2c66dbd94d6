// The level lines of a smooth field, as polylines.
//
// Marching squares over the spline surface at a part of the grid's step; lines come out as the curves that they
// are, without a trace of the grid, and are thinned to a tolerance. Each line is closed or ends at the border of the
// grid. Lines never cross or touch: one passes between nodes, never through them. Order: by level, then by where the
// scan from the grid's low corner meets them. Cost: some 5 ns a node of the fine grid and 50 ns a crossing.
#pragma once

#include <span>
#include <vector>

#include "plane/grid_field.h"
#include "plane/path.h"

namespace filigree {

struct Isoline {
    std::uint32_t level = 0;  // index into the levels
    Polyline line;            // px, relative as the grid is; higher values lie to the right of its direction
};
// `levels` must increase.
std::vector<Isoline> isolines(const GridField& field, std::span<const double> levels, double tolerance);

// A polyline without the points that lie within the tolerance of the straight way between those around them.
Polyline thinned(const Polyline& line, double tolerance);

}  // namespace filigree
