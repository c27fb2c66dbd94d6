// A uniform grid over elements that come and go: which of them lie near a place.
//
// An element is listed in the cells that the boxes of its short pieces overlap, so a long line is in the cells along
// it, not in all of its box. Cells are chosen so that elements and their lengths fill them evenly; what comes later and
// lies outside is in the cells of the border.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "curves/element.h"

namespace filigree::curves {

class ElementGrid {
public:
    ElementGrid() = default;
    // Element i is listed under the number i.
    explicit ElementGrid(std::span<const Element> elements);

    void insert(std::uint32_t number, const Element& e);
    void remove(std::uint32_t number, const Element& e);  // one that was inserted so
    // How many elements came since the cells were chosen; with many of them new cells are better.
    std::size_t insertions() const { return insertions_; }

    // Calls visit(number) for all that come within `reach` of a place along x and y, and for some that do not; of
    // large reaches more than once.
    template <class Visit>
    void visit_near(Vec place, double reach, Visit&& visit) const {
        if (first_.empty()) return;
        const Cell low = cell_at(place - Vec{reach, reach}), high = cell_at(place + Vec{reach, reach});
        for (std::uint32_t column = low.column; column <= high.column; ++column) {
            for (std::uint32_t row = low.row; row <= high.row; ++row) {
                for (std::uint32_t n = first_[index_of({column, row})]; n != none; n = nodes_[n].next) {
                    visit(nodes_[n].number);
                }
            }
        }
    }

    // All that come within `reach` of an element along x and y, and some that do not; ascending, each once.
    std::vector<std::uint32_t> found_along(const Element& e, double reach) const;

    // Asks the memory for what visit_near(place, ...) will read first.
    void fetch(Vec place) const {
        if (!first_.empty()) __builtin_prefetch(&first_[index_of(cell_at(place))]);
    }

private:
    static constexpr std::uint32_t none = UINT32_MAX;
    struct Cell {
        std::uint32_t column = 0, row = 0;
    };
    struct Node {
        std::uint32_t number = 0, next = none;
    };

    Cell cell_at(Vec place) const {
        const auto along = [](double at, std::uint32_t count) {
            return at > 0 ? static_cast<std::uint32_t>(at < count - 1 ? at : count - 1) : 0U;
        };
        return {along((place.x - origin_.x) * cells_per_px_, columns_),
                along((place.y - origin_.y) * cells_per_px_, rows_)};
    }
    std::size_t index_of(Cell cell) const { return std::size_t{cell.column} * rows_ + cell.row; }
    // The cells that come within `reach` of the boxes of an element's pieces, ascending, each once.
    void find_cells(const Element& e, double reach, std::vector<std::uint32_t>& cells) const;

    Vec origin_;
    double cells_per_px_ = 1;
    std::uint32_t columns_ = 1, rows_ = 1;
    // Of each cell, into nodes_. Column by column, since the elements of a shape are sorted by x: what is near in the
    // plane is then near in memory.
    std::vector<std::uint32_t> first_;
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> free_;  // nodes that are in no list
    std::size_t insertions_ = 0;
};

}  // namespace filigree::curves
