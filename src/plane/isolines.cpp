#include "plane/isolines.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace filigree {
namespace {

// Steps of the fine grid to one of the field's: so many that a chord across one of its cells keeps the tolerance where
// a line is bent as sharply as the field's grid can show.
std::uint32_t fineness_for(double step, double tolerance) {
    return static_cast<std::uint32_t>(std::clamp(std::ceil(std::sqrt(step / (16 * tolerance))), 2.0, 8.0));
}

// The surface at the nodes of a finer grid, and how many levels lie at or below each.
struct FineGrid {
    Vec low;
    double step = 1;
    std::uint32_t columns = 0, rows = 0;
    std::vector<double> values;
    std::vector<std::uint32_t> below;

    std::size_t index(std::uint32_t x, std::uint32_t y) const { return std::size_t{y} * columns + x; }
};

// B-spline weights at the parts of a step.
std::vector<std::array<double, 4>> weights_of(std::uint32_t fineness) {
    std::vector<std::array<double, 4>> weights;
    for (std::uint32_t k = 0; k < fineness; ++k) {
        const double t = static_cast<double>(k) / fineness, u = 1 - t;
        weights.push_back(
            {u * u * u / 6, (3 * t * t * t - 6 * t * t + 4) / 6, (3 * u * u * u - 6 * u * u + 4) / 6, t * t * t / 6});
    }
    return weights;
}

FineGrid refined(const GridField& field, std::span<const double> levels, std::uint32_t fineness) {
    const std::vector<std::array<double, 4>> weights = weights_of(fineness);
    const Grid& grid = field.grid;
    FineGrid fine;
    fine.low = grid.node(1, 1);
    fine.step = grid.step / fineness;
    fine.columns = (grid.columns - 3) * fineness + 1;
    fine.rows = (grid.rows - 3) * fineness + 1;
    fine.values.resize(std::size_t{fine.columns} * fine.rows);
    fine.below.resize(fine.values.size());
    std::vector<double> wide(std::size_t{fine.columns} * grid.rows);  // finer along the rows only
    for (std::uint32_t row = 0; row < grid.rows; ++row) {
        const double* const from = field.coefficients.data() + grid.index(0, row);
        double* const to = wide.data() + std::size_t{row} * fine.columns;
        for (std::uint32_t c = 0; c + 3 < grid.columns; ++c) {
            for (std::uint32_t k = 0; k < fineness; ++k) {
                const std::array<double, 4>& w = weights[k];
                to[c * fineness + k] = w[0] * from[c] + w[1] * from[c + 1] + w[2] * from[c + 2] + w[3] * from[c + 3];
            }
        }
        const double* const end = from + grid.columns - 3;
        to[fine.columns - 1] = (end[0] + 4 * end[1] + end[2]) / 6;
    }
    std::uint32_t level = 0;
    for (std::uint32_t y = 0; y < fine.rows; ++y) {
        const std::uint32_t row = std::min(y / fineness, grid.rows - 4);
        const std::array<double, 4> w =
            y / fineness == row ? weights[y % fineness] : std::array<double, 4>{0, 1.0 / 6, 4.0 / 6, 1.0 / 6};
        const double* const from = wide.data() + std::size_t{row} * fine.columns;
        double* const to = fine.values.data() + fine.index(0, y);
        for (std::size_t x = 0; x < fine.columns; ++x) {
            to[x] = w[0] * from[x] + w[1] * from[x + fine.columns] + w[2] * from[x + 2 * std::size_t{fine.columns}] +
                    w[3] * from[x + 3 * std::size_t{fine.columns}];
        }
        for (std::size_t x = 0; x < fine.columns; ++x) {
            const double value = to[x];
            while (level < levels.size() && levels[level] <= value) ++level;
            while (level > 0 && levels[level - 1] > value) --level;
            fine.below[fine.index(0, y) + x] = level;
        }
    }
    return fine;
}

// Sides of the fine grid's cells: 2 i from node i along the row, 2 i + 1 along the column.
struct Tracer {
    const FineGrid& fine;
    double value = 0;                    // of the level being traced
    std::uint32_t level = 0;             // its index
    std::vector<std::uint32_t> open_at;  // of each side: the level + 1 of a crossing not yet traced

    bool is_above(std::size_t node) const { return fine.below[node] > level; }
    Vec crossing(std::size_t side) const {
        const std::size_t from = side / 2;
        const std::size_t to = from + (side % 2 == 0 ? 1 : fine.columns);
        const double a = fine.values[from], b = fine.values[to];
        const double t = std::clamp((value - a) / (b - a), 1e-6, 1 - 1e-6);
        const auto x = static_cast<double>(from % fine.columns), y = static_cast<double>(from / fine.columns);
        return side % 2 == 0 ? Vec{fine.low.x + fine.step * (x + t), fine.low.y + fine.step * y}
                             : Vec{fine.low.x + fine.step * x, fine.low.y + fine.step * (y + t)};
    }
    // The cell that a line with the higher side to its right enters through a side: by its low node, if there is one.
    static constexpr std::size_t no_cell = SIZE_MAX;
    std::size_t cell_after(std::size_t side) const {
        const std::size_t node = side / 2;
        if (side % 2 == 0) {
            if (is_above(node)) return node / fine.columns + 1 < fine.rows ? node : no_cell;
            return node >= fine.columns ? node - fine.columns : no_cell;
        }
        if (!is_above(node)) return node % fine.columns + 1 < fine.columns ? node : no_cell;
        return node % fine.columns > 0 ? node - 1 : no_cell;
    }
    // The side through which the line that came through `side` leaves the cell.
    std::size_t exit(std::size_t cell, std::size_t side) const {
        const std::array<std::size_t, 4> corners{cell, cell + 1, cell + 1 + fine.columns, cell + fine.columns};
        const std::array<std::size_t, 4> sides{2 * cell, 2 * corners[1] + 1, 2 * corners[3], 2 * cell + 1};
        std::array<bool, 4> above{};
        for (std::size_t i = 0; i < 4; ++i) above[i] = is_above(corners[i]);
        std::size_t entry = 0, crossed = 0, other = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            if (sides[i] == side) entry = i;
            if (above[i] == above[(i + 1) % 4]) continue;
            ++crossed;
            if (sides[i] != side) other = i;
        }
        if (crossed == 2) return sides[other];
        // A saddle: the corners on the centre's side of the level are joined.
        double middle = 0;
        for (const std::size_t corner : corners) middle += fine.values[corner];
        const bool joins_first = (middle / 4 >= value) == above[0];
        constexpr std::array<std::size_t, 4> around_second{1, 0, 3, 2}, around_first{3, 2, 1, 0};
        return sides[joins_first ? around_second[entry] : around_first[entry]];
    }
    Polyline trace(std::size_t first) {
        Polyline line;
        for (std::size_t side = first;;) {
            open_at[side] = 0;
            line.points.push_back(crossing(side));
            const std::size_t cell = cell_after(side);
            if (cell == no_cell) return line;
            side = exit(cell, side);
            if (open_at[side] != level + 1) {
                line.closed = side == first;
                return line;
            }
        }
    }
};

// All crossings of sides by levels, as sides, those of each level together in the order of the grid.
struct Crossings {
    std::vector<std::size_t> sides;
    std::vector<std::size_t> ends;  // of each level
};
Crossings find_crossings(const FineGrid& fine, std::size_t level_count) {
    struct Crossing {
        std::uint32_t level = 0;
        std::size_t side = 0;
    };
    std::vector<Crossing> found;
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::size_t side) {
        for (std::uint32_t level = std::min(a, b); level < std::max(a, b); ++level) found.push_back({level, side});
    };
    for (std::uint32_t y = 0; y < fine.rows; ++y) {
        const std::size_t first = fine.index(0, y);
        const bool has_next_row = y + 1 < fine.rows;
        for (std::size_t node = first; node < first + fine.columns; ++node) {
            const std::uint32_t own = fine.below[node];
            if (node + 1 < first + fine.columns && fine.below[node + 1] != own)
                add(own, fine.below[node + 1], 2 * node);
            if (has_next_row && fine.below[node + fine.columns] != own) {
                add(own, fine.below[node + fine.columns], 2 * node + 1);
            }
        }
    }
    Crossings crossings{std::vector<std::size_t>(found.size()), std::vector<std::size_t>(level_count, 0)};
    for (const Crossing& crossing : found) ++crossings.ends[crossing.level];
    std::vector<std::size_t> next(level_count);
    std::size_t sum = 0;
    for (std::size_t level = 0; level < level_count; ++level) {
        next[level] = sum;
        sum += crossings.ends[level];
        crossings.ends[level] = sum;
    }
    for (const Crossing& crossing : found) crossings.sides[next[crossing.level]++] = crossing.side;
    return crossings;
}

}  // namespace

Polyline thinned(const Polyline& line, double tolerance) {
    constexpr std::size_t longest = 12;  // points that one chord may replace
    const std::vector<Vec>& points = line.points;
    const std::size_t count = points.size() + (line.closed ? 1 : 0);
    if (points.size() < 4) return line;
    const auto at = [&](std::size_t i) { return points[i == points.size() ? 0 : i]; };
    const auto is_straight = [&](std::size_t from, std::size_t to) {
        const Vec along = at(to) - at(from);
        const double length2 = dot(along, along);
        for (std::size_t i = from + 1; i < to; ++i) {
            const Vec p = at(i) - at(from);
            const double s = dot(p, along), c = cross(along, p);
            if (s < 0 || s > length2 || c * c > tolerance * tolerance * length2) return false;
        }
        return true;
    };
    Polyline thin{{points[0]}, line.closed};
    // A closed line keeps at least a triangle.
    const std::size_t reach = line.closed ? std::min(longest, points.size() / 3) : longest;
    for (std::size_t from = 0; from + 1 < count;) {
        std::size_t to = from + 1;
        while (to + 1 < count && to + 1 - from <= reach && is_straight(from, to + 1)) ++to;
        if (to < points.size()) thin.points.push_back(points[to]);
        from = to;
    }
    return thin;
}

std::vector<Isoline> isolines(const GridField& field, std::span<const double> levels, double tolerance) {
    std::vector<Isoline> lines;
    if (levels.empty() || field.grid.columns < 4 || field.grid.rows < 4) return lines;
    const FineGrid fine = refined(field, levels, fineness_for(field.grid.step, std::max(tolerance, 1e-6)));
    const Crossings crossings = find_crossings(fine, levels.size());
    Tracer tracer{fine, 0, 0, std::vector<std::uint32_t>(2 * fine.values.size(), 0)};
    for (std::uint32_t level = 0; level < levels.size(); ++level) {
        const std::span<const std::size_t> sides(crossings.sides.data() + (level == 0 ? 0 : crossings.ends[level - 1]),
                                                 crossings.sides.data() + crossings.ends[level]);
        tracer.level = level;
        tracer.value = levels[level];
        for (const std::size_t side : sides) tracer.open_at[side] = level + 1;
        const auto trace = [&](std::size_t side) {
            Polyline line = tracer.trace(side);
            if (line.points.size() >= 2) lines.push_back({level, thinned(line, tolerance)});
        };
        // Open lines first, from where they enter the grid.
        for (const std::size_t side : sides) {
            const std::size_t x = side / 2 % fine.columns, y = side / 2 / fine.columns;
            const bool at_border = side % 2 == 0 ? y == 0 || y + 1 == fine.rows : x == 0 || x + 1 == fine.columns;
            if (at_border && tracer.open_at[side] == level + 1 && tracer.cell_after(side) != Tracer::no_cell) {
                trace(side);
            }
        }
        for (const std::size_t side : sides) {
            if (tracer.open_at[side] == level + 1) trace(side);
        }
    }
    return lines;
}

}  // namespace filigree
