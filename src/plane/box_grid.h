// A uniform grid over boxes: which of them overlap a box, in time proportional to the answer.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plane/point.h"

namespace filigree {

class BoxGrid {
public:
    // Cells are chosen so that their number is near the number of boxes. Empty boxes are never found.
    explicit BoxGrid(std::span<const Box> boxes);

    // Appends the indices of all boxes that overlap `box` (borders count), ascending, each once.
    void find(const Box& box, std::vector<std::uint32_t>& found) const;

private:
    std::vector<Box> boxes_;
    Box extent_;
    std::int64_t cell_size_ = 1;
    std::int64_t columns_ = 0, rows_ = 0;
    std::vector<std::uint32_t> cell_starts_;  // compressed rows: one past the end of the cell before
    std::vector<std::uint32_t> cell_boxes_;
};

}  // namespace filigree
