#include "plane/outline_field.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace filigree {
namespace {

// Sweeps over each grid, and how far each goes beyond its target.
constexpr int heat_sweeps = 12, fit_sweeps = 24;
constexpr double heat_eagerness = 1.2, fit_eagerness = 1.5;
constexpr double shortest_link = 0.05;  // of a step
constexpr double steepest = 1.15;       // the field against the plain distance, at most
constexpr double rounding = 0.06;
constexpr std::size_t few_nodes = 150;  // a grid of so many is solved from scratch

// A square grid's nodes and their four links, to the right, below, to the left and above. A link from a node inside
// to one outside ends where it meets the border; what is solved for is 0 there, and kept at 0 outside.
struct Links {
    const Grid& grid;
    const std::vector<double>& distances;
    std::array<std::size_t, 4> to{};  // steps from node to node, modulo 2^64

    Links(const Grid& on, const std::vector<double>& from) : grid(on), distances(from) {
        const std::size_t columns = on.columns;
        to = {1, columns, std::size_t{0} - 1, std::size_t{0} - columns};
    }
    bool is_inside(std::size_t node) const { return distances[node] > 0; }
    // A step over the length of the link.
    double weight(std::size_t node, std::size_t k) const {
        const double own = distances[node], other = distances[node + to[k]];
        return other > 0 ? 1 : 1 / std::max(own / (own - other), shortest_link);
    }
    template <class Visit>
    void each_inside(Visit visit) const {
        for (std::uint32_t row = 1; row + 1 < grid.rows; ++row) {
            for (std::uint32_t column = 1; column + 1 < grid.columns; ++column) {
                const std::size_t node = grid.index(column, row);
                if (is_inside(node)) visit(node);
            }
        }
    }
};

// Relaxes `value` towards the sum of its neighbours and `source`, times `inverse`; nodes outside have an inverse of 0
// and stay 0. Even nodes and odd ones take turns, so that the outcome has the symmetry of the shape.
void relax(std::vector<double>& value, const std::vector<double>& source, const std::vector<double>& inverse,
           const Grid& grid, int sweeps, double eagerness) {
    const std::size_t columns = grid.columns;
    struct Stretch {
        std::size_t begin = 0, end = 0;
    };
    std::vector<Stretch> inside(grid.rows);  // of each row: from the first node inside to the last
    for (std::size_t i = 0; i < inverse.size(); ++i) {
        if (inverse[i] == 0) continue;
        Stretch& stretch = inside[i / columns];
        if (stretch.end == 0) stretch.begin = i;
        stretch.end = i + 1;
    }
    for (std::size_t turn = 0; turn < 2 * static_cast<std::size_t>(sweeps); ++turn) {
        for (std::size_t row = 0; row < grid.rows; ++row) {
            const std::size_t first_of_turn = row * columns + 1 + (row + turn) % 2;
            for (std::size_t i = inside[row].begin + (inside[row].begin + first_of_turn) % 2; i < inside[row].end;
                 i += 2) {
                const double sum =
                    ((value[i - 1] + value[i + 1]) + (value[i - columns] + value[i + columns])) + source[i];
                value[i] += eagerness * (sum * inverse[i] - value[i]);
            }
        }
    }
}

// Heat lost by each place: 0 at the border, towards 1 far from it.
void lose_heat(const Links& links, double reach, int sweeps, std::vector<double>& loss) {
    const Grid& grid = links.grid;
    const double fading = grid.step * grid.step / (reach * reach);
    std::vector<double> source(grid.size(), 0.0), inverse(grid.size(), 0.0);
    links.each_inside([&](std::size_t node) {
        double sum = fading;
        for (std::size_t k = 0; k < 4; ++k) sum += links.weight(node, k);
        source[node] = fading;
        inverse[node] = 1 / sum;
    });
    relax(loss, source, inverse, grid, sweeps, heat_eagerness);
}

// The field whose gain along every link comes nearest to that of a unit step in the direction of the loss's gradient.
void fit(const Links& links, const std::vector<double>& loss, int sweeps, std::vector<double>& field) {
    const Grid& grid = links.grid;
    std::vector<double> source(grid.size(), 0.0), inverse(grid.size(), 0.0);
    links.each_inside([&](std::size_t node) {
        double sum = 0, gains = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            const double weight = links.weight(node, k);
            sum += weight;
            const auto square = [](double x) { return x * x; };
            // Squares are means over what lies around, so that the length does not vanish where a ridge is crossed: the
            // direction turns over gradually there, wherever the nodes happen to lie.
            const std::size_t along = links.to[k], across = links.to[(k + 1) % 4];
            const std::size_t next = node + along;
            const double rise = (loss[next] - loss[node]) * weight;
            const double before = loss[node] - loss[node - along];
            double length2 = 2 * square(rise) + (links.is_inside(node - along) ? square(before) : square(rise));
            const auto sideways = [&](std::size_t i) {
                return square(loss[i + across] - loss[i]) + square(loss[i] - loss[i - across]);
            };
            if (links.is_inside(next)) {
                const double after = loss[next + along] - loss[next];
                length2 += links.is_inside(next + along) ? square(after) : square(rise);
                length2 += sideways(node) + sideways(next);
            } else {
                length2 += square(rise) + 2 * sideways(node);
            }
            if (length2 > 0) gains += 2 * rise / std::sqrt(length2);
        }
        source[node] = -grid.step * gains;
        inverse[node] = 1 / sum;
    });
    relax(field, source, inverse, grid, sweeps, fit_eagerness);
}

struct Solution {
    std::vector<double> loss, field;  // 0 outside
};

Solution solve(const Grid& grid, const std::vector<double>& distances, double reach) {
    const Links links(grid, distances);
    Solution solution{std::vector<double>(grid.size(), 0.0), std::vector<double>(grid.size(), 0.0)};
    const auto nearby = [&](double distance) { return std::min(1.0, distance / reach); };
    if (grid.size() <= few_nodes || grid.columns % 2 == 0 || grid.rows % 2 == 0) {
        links.each_inside([&](std::size_t node) {
            solution.loss[node] = nearby(distances[node]);
            solution.field[node] = distances[node];
        });
        lose_heat(links, reach, 4 * heat_sweeps, solution.loss);
        fit(links, solution.loss, 4 * fit_sweeps, solution.field);
        return solution;
    }
    // From every other node: what the solution there differs by from the plain distance.
    Grid coarse = grid;
    coarse.step *= 2;
    coarse.columns = grid.columns / 2 + 1;
    coarse.rows = grid.rows / 2 + 1;
    std::vector<double> every_other(coarse.size());
    for (std::uint32_t row = 0; row < coarse.rows; ++row) {
        for (std::uint32_t column = 0; column < coarse.columns; ++column) {
            every_other[coarse.index(column, row)] = distances[grid.index(2 * column, 2 * row)];
        }
    }
    Solution rough = solve(coarse, every_other, reach);
    for (std::size_t i = 0; i < coarse.size(); ++i) {
        if (!(every_other[i] > 0)) continue;
        rough.loss[i] -= nearby(every_other[i]);
        rough.field[i] -= every_other[i];
    }
    links.each_inside([&](std::size_t node) {
        const auto column = static_cast<std::uint32_t>(node % grid.columns);
        const auto row = static_cast<std::uint32_t>(node / grid.columns);
        const std::size_t a = coarse.index(column / 2, row / 2), b = coarse.index((column + 1) / 2, row / 2);
        const std::size_t c = coarse.index(column / 2, (row + 1) / 2);
        const std::size_t d = coarse.index((column + 1) / 2, (row + 1) / 2);
        const auto mean = [&](const std::vector<double>& of) { return ((of[a] + of[d]) + (of[b] + of[c])) / 4; };
        solution.loss[node] = nearby(distances[node]) + mean(rough.loss);
        solution.field[node] = distances[node] + mean(rough.field);
    });
    lose_heat(links, reach, heat_sweeps, solution.loss);
    fit(links, solution.loss, fit_sweeps, solution.field);
    return solution;
}

}  // namespace

GridField outline_field(const Grid& grid, const std::vector<double>& distances, double reach) {
    if (!(reach > 0)) return spline_of(grid, distances);
    std::vector<double> field = solve(grid, distances, reach).field;
    for (std::size_t i = 0; i < field.size(); ++i) {
        const double distance = distances[i];
        if (distance > 0) {
            // The lesser of both, without a kink: beside inward corners the fit climbs too steeply.
            const double highest = steepest * distance, bend = rounding * distance;
            const double over = field[i] - highest;
            field[i] = (field[i] + highest - std::sqrt(over * over + bend * bend)) / 2;
        } else {
            field[i] = distance;
        }
    }
    return spline_of(grid, field);
}

}  // namespace filigree
