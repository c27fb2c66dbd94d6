// Functions of the plane that are known at the nodes of a square grid, and smooth in between.
//
// Between nodes a field is a cubic B-spline surface: its second derivatives are continuous, so neither its level
// lines nor the curves that follow its gradient show the grid. Linear functions come out exactly. All coordinates are
// px relative to an origin that the caller chooses, usually the middle of a shape, so that a shape and its mirror
// image have mirrored grids.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "plane/point.h"

namespace filigree {

struct Grid {
    Vec low;          // px: the first node
    double step = 1;  // px
    std::uint32_t columns = 0, rows = 0;

    bool operator==(const Grid&) const = default;

    std::size_t size() const { return std::size_t{columns} * rows; }
    std::size_t index(std::uint32_t column, std::uint32_t row) const { return std::size_t{row} * columns + column; }
    Vec node(std::uint32_t column, std::uint32_t row) const {
        return {low.x + step * static_cast<double>(column), low.y + step * static_cast<double>(row)};
    }
};
// A grid around (0, 0) that covers `size` and a margin of at least so many steps on each side. Its steps are a multiple
// of 8, so that it can be halved three times.
Grid grid_over(Vec size, double step, std::uint32_t margin);

// A spline surface. `coefficients` as they come out of `spline_of`, one a node.
struct GridField {
    Grid grid;
    std::vector<double> coefficients;

    // Outside the grid: the value at the nearest place in it.
    double at(Vec p) const;
    struct Jet {
        double value = 0;
        Vec gradient;
    };
    Jet jet(Vec p) const;
};
// The field with (to fourth order of the step) the given values at the nodes.
GridField spline_of(const Grid& grid, const std::vector<double>& values);

}  // namespace filigree
