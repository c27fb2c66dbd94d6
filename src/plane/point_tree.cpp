#include "plane/point_tree.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace filigree {
namespace {

constexpr std::uint32_t most_in_cell = 12;    // different points; more make a grid
constexpr std::uint32_t few = 40;             // looked at one by one, whatever grids they are in
constexpr std::uint32_t points_per_cell = 3;  // on average; neighbours' common points come several times
constexpr double rounding = 0x1p-45;          // relative, far above what the few operations below can lose

std::uint32_t sort_and_unite(Point* points, std::uint32_t count) {
    if (count < 2) return count;
    if (count == 2) {
        if (points[1] < points[0]) std::swap(points[0], points[1]);
    } else {
        std::sort(points, points + count);
    }
    return static_cast<std::uint32_t>(std::unique(points, points + count) - points);
}

}  // namespace

struct PointTree::Query {
    Point a, b;
    Box around;
    double width = 0, height = 0;  // signed, from a to b
    double off_line = 0;           // at least the distance times the length
    double reach = 0;

    bool accepts(Point p) const {
        if (p.x < around.min.x || p.x > around.max.x || p.y < around.min.y || p.y > around.max.y) return false;
        const double x = static_cast<double>(p.x - a.x), y = static_cast<double>(p.y - a.y);
        const double left = width * y, right = height * x;
        return std::fabs(left - right) <= off_line + rounding * (std::fabs(left) + std::fabs(right));
    }
};

PointTree::PointTree(std::vector<Point> points) : points_(std::move(points)) {
    if (points_.empty()) return;
    std::vector<Point> given = std::move(points_);
    points_.clear();
    points_.reserve(given.size());
    sorted_.resize(given.size());
    build(given.data(), static_cast<std::uint32_t>(given.size()));
    sorted_ = {};
    cell_of_ = {};
    ends_ = {};
}

// Appends the points' grid and its cells, cell by cell, and returns its number.
std::uint32_t PointTree::build(Point* points, std::uint32_t count) {
    Box box;
    for (std::uint32_t i = 0; i < count; ++i) extend(box, points[i]);
    Grid grid;
    grid.origin = box.min;
    const auto width = static_cast<std::uint64_t>(box.max.x - box.min.x),
               height = static_cast<std::uint64_t>(box.max.y - box.min.y);
    const double wanted = std::max(4.0, static_cast<double>(count) / points_per_cell);
    const auto cells_at = [&](int shift) {
        return (static_cast<double>(width >> shift) + 1) * (static_cast<double>(height >> shift) + 1);
    };
    while (cells_at(grid.shift) > wanted) ++grid.shift;
    grid.columns = static_cast<std::uint32_t>(width >> grid.shift) + 1;
    grid.rows = static_cast<std::uint32_t>(height >> grid.shift) + 1;
    grid.first_cell = cells_.size();
    const std::size_t cell_count = std::size_t{grid.columns} * grid.rows;
    const auto number = static_cast<std::uint32_t>(grids_.size());
    grids_.push_back(grid);
    cells_.resize(grid.first_cell + cell_count + 1);

    if (cell_of_.size() < count) cell_of_.resize(count);
    ends_.assign(cell_count, 0);
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto column = static_cast<std::uint32_t>((points[i].x - grid.origin.x) >> grid.shift);
        const auto row = static_cast<std::uint32_t>((points[i].y - grid.origin.y) >> grid.shift);
        cell_of_[i] = row * grid.columns + column;
        ++ends_[cell_of_[i]];
    }
    std::uint32_t before = 0;
    for (std::uint32_t& end : ends_) before += std::exchange(end, before);
    for (std::uint32_t i = 0; i < count; ++i) sorted_[ends_[cell_of_[i]]++] = points[i];
    std::copy(sorted_.begin(), sorted_.begin() + count, points);
    std::vector<std::uint32_t> ends;  // the grids within use the buffer
    ends.swap(ends_);

    std::uint32_t begin = 0;
    for (std::size_t c = 0; c < cell_count; ++c) {
        const std::uint32_t different = sort_and_unite(points + begin, ends[c] - begin);
        cells_[grid.first_cell + c].begin = static_cast<std::uint32_t>(points_.size());
        if (different <= most_in_cell) {
            points_.insert(points_.end(), points + begin, points + begin + different);
        } else {
            const std::uint32_t inner = build(points + begin, different);
            cells_[grid.first_cell + c].grid = inner;
        }
        begin = ends[c];
    }
    cells_[grid.first_cell + cell_count].begin = static_cast<std::uint32_t>(points_.size());
    ends_.swap(ends);
    return number;
}

std::uint32_t PointTree::index_of(Point p) const {
    if (grids_.empty()) return none;
    const auto offset = [](std::int64_t at, std::int64_t from) {  // below 0 is far above; also off the plane
        return static_cast<std::uint64_t>(at) - static_cast<std::uint64_t>(from);
    };
    for (std::uint32_t number = 0;;) {
        const Grid& grid = grids_[number];
        const std::uint64_t column = offset(p.x, grid.origin.x) >> grid.shift;
        const std::uint64_t row = offset(p.y, grid.origin.y) >> grid.shift;
        if (column >= grid.columns || row >= grid.rows) return none;
        const std::size_t c = grid.first_cell + row * grid.columns + column;
        if (cells_[c].grid != none) {
            number = cells_[c].grid;
            continue;
        }
        for (std::uint32_t i = cells_[c].begin; i < cells_[c + 1].begin; ++i) {
            if (points_[i] == p) return i;
        }
        return none;
    }
}

void PointTree::find_near(Point a, Point b, double distance, std::vector<std::uint32_t>& found) const {
    if (grids_.empty()) return;
    Query query;
    query.a = a;
    query.b = b;
    query.width = static_cast<double>(b.x - a.x);
    query.height = static_cast<double>(b.y - a.y);
    // No vertex is farther from another than 2^58, so that much room is as good as more.
    const double room = std::min(distance, 0x1p58) + 1;
    const std::int64_t reach = static_cast<std::int64_t>(room) + 1;
    query.reach = static_cast<double>(reach);
    query.around = {{std::min(a.x, b.x) - reach, std::min(a.y, b.y) - reach},
                    {std::max(a.x, b.x) + reach, std::max(a.y, b.y) + reach}};
    query.off_line = room * (std::fabs(query.width) + std::fabs(query.height));
    find(0, query, found);
}

void PointTree::find(std::uint32_t number, const Query& query, std::vector<std::uint32_t>& found) const {
    const Grid& grid = grids_[number];
    const auto column_of = [&](std::int64_t x) { return (x - grid.origin.x) >> grid.shift; };
    const auto row_of = [&](std::int64_t y) { return (y - grid.origin.y) >> grid.shift; };
    const std::int64_t first_column = std::max<std::int64_t>(0, column_of(query.around.min.x));
    const std::int64_t last_column = std::min<std::int64_t>(grid.columns - 1, column_of(query.around.max.x));
    const std::int64_t first_row = std::max<std::int64_t>(0, row_of(query.around.min.y));
    const std::int64_t last_row = std::min<std::int64_t>(grid.rows - 1, row_of(query.around.max.y));
    if (first_column > last_column || first_row > last_row) return;
    if (last_row - first_row < 2 || last_column - first_column < 2) {
        for (std::int64_t row = first_row; row <= last_row; ++row) {
            find_in_row(grid, row, first_column, last_column, query, found);
        }
        return;
    }
    // Of each row only the cells that the line comes near to. Where it spans rows it is not level.
    const double size = std::ldexp(1.0, grid.shift);
    const double slope = query.height != 0 ? query.width / query.height : 0;
    const double margin = query.reach + 1 + rounding * std::fabs(query.width);
    const double low_y = std::min(0.0, query.height), high_y = std::max(0.0, query.height);
    const double to_x = static_cast<double>(query.a.x - grid.origin.x),
                 to_y = static_cast<double>(grid.origin.y - query.a.y);
    const double lost = rounding * (std::fabs(to_x) + std::fabs(to_y));
    for (std::int64_t row = first_row; row <= last_row; ++row) {
        const double below = to_y + static_cast<double>(row) * size - query.reach - lost;
        const double above = below + size + 2 * (query.reach + lost);
        double from = to_x + std::clamp(below, low_y, high_y) * slope;
        double to = to_x + std::clamp(above, low_y, high_y) * slope;
        if (query.height == 0) to = to_x + query.width;
        if (from > to) std::swap(from, to);
        from = std::floor((from - margin - lost) / size);
        to = std::floor((to + margin + lost) / size);
        const double least = static_cast<double>(first_column), most = static_cast<double>(last_column);
        if (from > most || to < least) continue;
        find_in_row(grid, row, static_cast<std::int64_t>(std::max(from, least)),
                    static_cast<std::int64_t>(std::min(to, most)), query, found);
    }
}

void PointTree::find_in_row(const Grid& grid, std::int64_t row, std::int64_t first, std::int64_t last,
                            const Query& query, std::vector<std::uint32_t>& found) const {
    const std::size_t row_cell = grid.first_cell + static_cast<std::size_t>(row) * grid.columns;
    const auto look_at = [&](std::uint32_t begin, std::uint32_t end) {
        for (std::uint32_t i = begin; i < end; ++i) {
            if (query.accepts(points_[i])) found.push_back(i);
        }
    };
    const std::size_t begin = row_cell + static_cast<std::size_t>(first);
    const std::size_t end = row_cell + static_cast<std::size_t>(last) + 1;
    if (cells_[end].begin - cells_[begin].begin <= few) return look_at(cells_[begin].begin, cells_[end].begin);
    for (std::size_t c = begin; c < end; ++c) {
        if (cells_[c].grid != none) {
            find(cells_[c].grid, query, found);
        } else {
            look_at(cells_[c].begin, cells_[c + 1].begin);
        }
    }
}

void PointTree::find_pairs(double distance, std::vector<Pair>& found) const {
    const auto reach = static_cast<std::int64_t>(std::min(distance, 0x1p58));
    for (const Grid& grid : grids_) {
        const std::int64_t size = std::int64_t{1} << grid.shift;
        const Cell* cell = &cells_[grid.first_cell];
        for (std::int64_t row = 0; row < grid.rows; ++row) {
            for (std::int64_t column = 0; column < grid.columns; ++column, ++cell) {
                if (cell->grid != none || cell->begin == cell[1].begin) continue;
                const Point low{grid.origin.x + column * size, grid.origin.y + row * size};
                const Box inside{{low.x + reach, low.y + reach}, {low.x + size - reach, low.y + size - reach}};
                find_pairs_of_cell(cell, inside, reach, found);
            }
        }
    }
}

// Points `inside` have no others near them but those of the cell.
void PointTree::find_pairs_of_cell(const Cell* cell, Box inside, std::int64_t distance,
                                   std::vector<Pair>& found) const {
    std::vector<std::uint32_t> near;
    for (std::uint32_t i = cell->begin; i < cell[1].begin; ++i) {
        const Point p = points_[i];
        if (inside.min.x <= p.x && p.x < inside.max.x && inside.min.y <= p.y && p.y < inside.max.y) {
            for (std::uint32_t j = i + 1; j < cell[1].begin && points_[j].x - p.x <= distance; ++j) {
                if (std::abs(points_[j].y - p.y) <= distance) found.push_back({i, j});
            }
        } else {
            near.clear();
            find_near(p, p, static_cast<double>(distance), near);
            for (const std::uint32_t j : near) {
                const bool is_near =
                    std::abs(points_[j].x - p.x) <= distance && std::abs(points_[j].y - p.y) <= distance;
                if (j != i && is_near) found.push_back({i, j});
            }
        }
    }
}

}  // namespace filigree
