// A region as cells of a raster: those whose centres lie inside it, and how far each is from the border.
//
// The raster is laid out from the origin of the plane, not from the region, so that a border that is moved far away
// changes no cell here. Guarantee: the same bits wherever rings start and in whatever order they come. Cost: the
// cells of the region's box (two numbers each), and the crossings of its border with the rows; some 5 ns a cell.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "plane/polygon.h"

namespace filigree {

class RegionRaster {
public:
    // Distances on the raster are sums of steps: to a neighbour in the row or column, and across a corner. They are
    // up to 6 % longer than straight ones.
    static constexpr std::uint16_t step = 12, corner_step = 17;

    struct Run {  // inside cells of one row: indices begin, begin + 1, .. end - 1
        std::uint32_t begin = 0, end = 0;
    };

    // Nothing where the box would take more than `most` cells.
    static std::optional<RegionRaster> of(PolygonView region, double cell, std::uint64_t most);

    double cell() const { return cell_; }  // px
    std::uint32_t columns() const { return columns_; }
    std::uint32_t size() const { return static_cast<std::uint32_t>(border_.size()); }
    std::uint64_t inside_count() const { return inside_count_; }
    const std::vector<Run>& runs() const { return runs_; }  // by rows, then columns

    bool is_inside(std::uint32_t index) const { return border_[index] != 0; }
    // To the nearest cell outside, in steps; 0 outside.
    std::uint16_t border(std::uint32_t index) const { return border_[index]; }
    // From a cell's centre to the border, px; about half a cell more or less.
    double border_distance(std::uint32_t index) const { return (border_[index] / double{step} - 0.5) * cell_; }

    // Columns and rows are counted from the least of the raster; those on its rim are outside the region.
    std::uint32_t column(std::uint32_t index) const { return index % columns_; }
    std::uint32_t row(std::uint32_t index) const { return index / columns_; }
    Vec centre(std::uint32_t index) const { return at(column(index) + 0.5, row(index) + 0.5); }
    Vec at(double column, double row) const { return {(left_ + column) * cell_, (top_ + row) * cell_}; }
    double column_of(double x) const { return x / cell_ - left_; }
    double row_of(double y) const { return y / cell_ - top_; }
    // The cell that holds a point; an outside one for points off the raster.
    std::uint32_t index_of(Vec p) const;
    // What tells a cell apart from all others of the plane.
    std::uint64_t address(std::uint32_t index) const;

private:
    RegionRaster() = default;
    void fill(PolygonView region);
    void measure();

    double cell_ = 1;
    double left_ = 0, top_ = 0;  // whole numbers: the first column and row, counted from the origin of the plane
    std::uint32_t columns_ = 0, rows_ = 0;
    std::uint64_t inside_count_ = 0;
    std::vector<Run> runs_;
    std::vector<std::uint16_t> border_;
};

}  // namespace filigree
