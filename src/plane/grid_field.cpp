#include "plane/grid_field.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace filigree {
namespace {

// Where a coordinate lies among the nodes: the spline there is a sum over the nodes first - 1 .. first + 2.
struct Place {
    std::uint32_t first = 0;
    double part = 0;  // from that node to the next, in [0, 1]
};
Place place_of(double x, double low, double step, std::uint32_t count) {
    const double at = std::clamp((x - low) / step, 1.0, static_cast<double>(count) - 2.0);
    const auto first = std::min(static_cast<std::uint32_t>(at), count - 3);
    return {first, at - static_cast<double>(first)};
}

std::array<double, 4> weights(double t) {
    const double s = 1 - t;
    return {s * s * s / 6, (3 * t * t * t - 6 * t * t + 4) / 6, (3 * s * s * s - 6 * s * s + 4) / 6, t * t * t / 6};
}
std::array<double, 4> slopes(double t) {
    const double s = 1 - t;
    return {-s * s / 2, (3 * t * t - 4 * t) / 2, (-3 * s * s + 4 * s) / 2, t * t / 2};
}

}  // namespace

Grid grid_over(Vec size, double step, std::uint32_t margin) {
    const auto count = [&](double extent) {
        const auto steps =
            static_cast<std::uint32_t>(std::ceil(std::max(extent, 0.0) / step)) + 2 * std::max(margin, 2U);
        return (steps + 7) / 8 * 8 + 1;
    };
    Grid grid{{}, step, count(size.x), count(size.y)};
    grid.low = {-0.5 * step * static_cast<double>(grid.columns - 1), -0.5 * step * static_cast<double>(grid.rows - 1)};
    return grid;
}

double GridField::at(Vec p) const {
    const Place x = place_of(p.x, grid.low.x, grid.step, grid.columns);
    const Place y = place_of(p.y, grid.low.y, grid.step, grid.rows);
    const std::array<double, 4> wx = weights(x.part), wy = weights(y.part);
    double sum = 0;
    for (std::uint32_t j = 0; j < 4; ++j) {
        const double* const row = coefficients.data() + grid.index(x.first - 1, y.first - 1 + j);
        sum += wy[j] * (wx[0] * row[0] + wx[1] * row[1] + wx[2] * row[2] + wx[3] * row[3]);
    }
    return sum;
}

GridField::Jet GridField::jet(Vec p) const {
    const Place x = place_of(p.x, grid.low.x, grid.step, grid.columns);
    const Place y = place_of(p.y, grid.low.y, grid.step, grid.rows);
    const std::array<double, 4> wx = weights(x.part), wy = weights(y.part);
    const std::array<double, 4> sx = slopes(x.part), sy = slopes(y.part);
    Jet jet;
    for (std::uint32_t j = 0; j < 4; ++j) {
        const double* const row = coefficients.data() + grid.index(x.first - 1, y.first - 1 + j);
        const double across = wx[0] * row[0] + wx[1] * row[1] + wx[2] * row[2] + wx[3] * row[3];
        const double slope = sx[0] * row[0] + sx[1] * row[1] + sx[2] * row[2] + sx[3] * row[3];
        jet.value += wy[j] * across;
        jet.gradient.x += wy[j] * slope;
        jet.gradient.y += sy[j] * across;
    }
    jet.gradient = (1 / grid.step) * jet.gradient;
    return jet;
}

GridField spline_of(const Grid& grid, const std::vector<double>& values) {
    GridField field{grid, values};
    const std::uint32_t columns = grid.columns;
    for (std::uint32_t row = 1; row + 1 < grid.rows; ++row) {
        for (std::uint32_t column = 1; column + 1 < columns; ++column) {
            const double* const v = values.data() + grid.index(column, row);
            const double around = (v[-1] + v[1]) + (*(v - columns) + v[columns]);
            field.coefficients[grid.index(column, row)] = v[0] - (around - 4 * v[0]) / 6;
        }
    }
    return field;
}

}  // namespace filigree
