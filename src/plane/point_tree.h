// A set of points, arranged so that those near a segment are found fast.
//
// Grids in grids: a cell that holds too many points is a grid of its own, fitted to them, so clusters of any
// density cost little extra. A short segment among evenly spread points looks at a few cells, a long one at the
// cells along it.
#pragma once

#include <cstdint>
#include <vector>

#include "plane/point.h"

namespace filigree {

class PointTree {
public:
    static constexpr std::uint32_t none = UINT32_MAX;

    // Equal points count once. All must lie on the plane (|x| <= grid_limit).
    explicit PointTree(std::vector<Point> points);

    // Each point once, near ones mostly near each other. What is found are their numbers here.
    const std::vector<Point>& points() const { return points_; }
    std::uint32_t index_of(Point p) const;  // none where it is not there

    // Appends all points within `distance` grid units of the segment (and a few that are a little farther).
    void find_near(Point a, Point b, double distance, std::vector<std::uint32_t>& found) const;

    // Appends all pairs of points that are no more than `distance` grid units apart in x and in y, some twice. Fast
    // where they are few.
    struct Pair {
        std::uint32_t a = 0, b = 0;
    };
    void find_pairs(double distance, std::vector<Pair>& found) const;

private:
    struct Cell {
        std::uint32_t begin = 0;    // its points; they end where those of the next cell begin
        std::uint32_t grid = none;  // those are in this grid instead
    };
    struct Grid {
        Point origin;
        int shift = 0;  // cells are 2^shift wide
        std::uint32_t columns = 1, rows = 1;
        std::size_t first_cell = 0;  // row by row, and one more that ends the last
    };
    struct Query;

    std::uint32_t build(Point* points, std::uint32_t count);
    void find(std::uint32_t grid, const Query& query, std::vector<std::uint32_t>& found) const;
    void find_in_row(const Grid& grid, std::int64_t row, std::int64_t first, std::int64_t last, const Query& query,
                     std::vector<std::uint32_t>& found) const;
    void find_pairs_of_cell(const Cell* cell, Box inside, std::int64_t distance, std::vector<Pair>& found) const;

    std::vector<Point> points_;
    std::vector<Point> sorted_;                  // while it is built
    std::vector<std::uint32_t> cell_of_, ends_;  // likewise
    std::vector<Grid> grids_;                    // [0] holds all, if there are points
    std::vector<Cell> cells_;
};

}  // namespace filigree
