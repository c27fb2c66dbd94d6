#include "curves/element_grid.h"

#include <algorithm>
#include <cmath>

namespace filigree::curves {

ElementGrid::ElementGrid(std::span<const Element> elements) {
    Bounds all;
    double way = 0;
    for (const Element& e : elements) {
        const Bounds box = bounds_of(e);
        extend(all, box);
        way += box.max.x - box.min.x + (box.max.y - box.min.y);
    }
    if (elements.empty()) all = {{0, 0}, {1, 1}};
    const double count = static_cast<double>(elements.size()) + 1;
    const double width = all.max.x - all.min.x, height = all.max.y - all.min.y;
    // A cell for each element, but none so small that the elements together are in more than some 50 cells each.
    double size = std::max({std::sqrt(width * height / count), std::max(width, height) / count, way / (48 * count)});
    if (!(size > 1e-300)) size = 1;
    origin_ = all.min;
    cells_per_px_ = 1 / size;
    columns_ = static_cast<std::uint32_t>(width * cells_per_px_) + 1;
    rows_ = static_cast<std::uint32_t>(height * cells_per_px_) + 1;

    // Nodes of one cell stand side by side.
    std::vector<std::uint32_t> cells, cell_of, counts(std::size_t{columns_} * rows_ + 1, 0);
    std::vector<std::uint32_t> ends(elements.size());
    for (std::size_t i = 0; i < elements.size(); ++i) {
        find_cells(elements[i], 0, cells);
        cell_of.insert(cell_of.end(), cells.begin(), cells.end());
        ends[i] = static_cast<std::uint32_t>(cell_of.size());
        for (const std::uint32_t cell : cells) ++counts[cell + 1];
    }
    for (std::size_t cell = 1; cell < counts.size(); ++cell) counts[cell] += counts[cell - 1];
    first_.assign(counts.size() - 1, none);
    for (std::size_t cell = 0; cell < first_.size(); ++cell) {
        if (counts[cell] < counts[cell + 1]) first_[cell] = counts[cell];
    }
    nodes_.resize(cell_of.size());
    std::vector<std::uint32_t> place(counts.begin(), counts.end() - 1);
    for (std::size_t i = 0, at = 0; i < elements.size(); ++i) {
        for (; at < ends[i]; ++at) {
            const std::uint32_t node = place[cell_of[at]]++;
            nodes_[node] = {static_cast<std::uint32_t>(i), node + 1 < counts[cell_of[at] + 1] ? node + 1 : none};
        }
    }
}

void ElementGrid::find_cells(const Element& e, double reach, std::vector<std::uint32_t>& cells) const {
    cells.clear();
    const auto add = [&](const Bounds& box) {
        const Cell low = cell_at(box.min - Vec{reach, reach}), high = cell_at(box.max + Vec{reach, reach});
        for (std::uint32_t column = low.column; column <= high.column; ++column) {
            for (std::uint32_t row = low.row; row <= high.row; ++row) {
                cells.push_back(static_cast<std::uint32_t>(index_of({column, row})));
            }
        }
    };
    const Bounds box = bounds_of(e);
    const double span = std::max(box.max.x - box.min.x, box.max.y - box.min.y) * cells_per_px_;
    if (span <= 2) return add(box);  // they are in order already
    // By halves until each is small, or lies beyond the grid, whose outermost cells stand for all that is outside.
    constexpr int most_halvings = 20;
    const auto visit = [&](const auto& self, Interval on, int halvings) -> void {
        const Bounds part = bounds_of(piece_of(e, on));
        const Cell low = cell_at(part.min - Vec{reach, reach}), high = cell_at(part.max + Vec{reach, reach});
        if (halvings == most_halvings || (high.column - low.column <= 1 && high.row - low.row <= 1)) return add(part);
        const double middle = 0.5 * (on.from + on.to);
        self(self, {on.from, middle}, halvings + 1);
        self(self, {middle, on.to}, halvings + 1);
    };
    visit(visit, interval_of(e), 0);
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
}

std::vector<std::uint32_t> ElementGrid::found_along(const Element& e, double reach) const {
    std::vector<std::uint32_t> cells, found;
    find_cells(e, reach, cells);
    for (const std::uint32_t cell : cells) {
        for (std::uint32_t n = first_[cell]; n != none; n = nodes_[n].next) found.push_back(nodes_[n].number);
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

void ElementGrid::insert(std::uint32_t number, const Element& e) {
    std::vector<std::uint32_t> cells;
    find_cells(e, 0, cells);
    for (const std::uint32_t cell : cells) {
        std::uint32_t node = static_cast<std::uint32_t>(nodes_.size());
        if (free_.empty()) {
            nodes_.emplace_back();
        } else {
            node = free_.back();
            free_.pop_back();
        }
        nodes_[node] = {number, first_[cell]};
        first_[cell] = node;
    }
    ++insertions_;
}

void ElementGrid::remove(std::uint32_t number, const Element& e) {
    std::vector<std::uint32_t> cells;
    find_cells(e, 0, cells);
    for (const std::uint32_t cell : cells) {
        std::uint32_t* link = &first_[cell];
        while (*link != none && nodes_[*link].number != number) link = &nodes_[*link].next;
        if (*link == none) continue;
        const std::uint32_t node = *link;
        *link = nodes_[node].next;
        free_.push_back(node);
    }
}

}  // namespace filigree::curves
