#include "plane/box_grid.h"

#include <algorithm>
#include <cmath>

namespace filigree {
namespace {

bool holds_nothing(const Box& box) { return box.min.x > box.max.x || box.min.y > box.max.y; }

// Boxes may span all 64 bits, so distances are unsigned.
std::uint64_t distance_between(std::int64_t low, std::int64_t high) {
    return static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low);
}

std::int64_t cell_along(std::int64_t origin, std::int64_t at, std::int64_t cell_size) {
    return static_cast<std::int64_t>(distance_between(origin, at) / static_cast<std::uint64_t>(cell_size));
}

// The size for which `count` square cells fill the extent.
std::int64_t first_cell_size(const Box& extent, std::size_t count) {
    const double width = static_cast<double>(distance_between(extent.min.x, extent.max.x));
    const double height = static_cast<double>(distance_between(extent.min.y, extent.max.y));
    const double n = static_cast<double>(count);
    const double size = std::max(std::sqrt(width * (height / n)), std::max(width, height) / n);
    return std::max(static_cast<std::int64_t>(std::min(size, 0x1p62)), std::int64_t{1});
}

}  // namespace

BoxGrid::BoxGrid(std::span<const Box> boxes) : boxes_(boxes.begin(), boxes.end()) {
    std::size_t count = 0;
    for (const Box& box : boxes_) {
        if (holds_nothing(box)) continue;
        extend(extent_, box.min);
        extend(extent_, box.max);
        ++count;
    }
    if (count == 0) return;

    // Large boxes lie in many cells: cells grow until all lists together are linear in the boxes.
    const auto column = [&](std::int64_t x) { return cell_along(extent_.min.x, x, cell_size_); };
    const auto row = [&](std::int64_t y) { return cell_along(extent_.min.y, y, cell_size_); };
    const std::uint64_t most_entries = 8 * static_cast<std::uint64_t>(count) + 64;
    for (cell_size_ = first_cell_size(extent_, count);; cell_size_ *= 2) {
        columns_ = column(extent_.max.x) + 1;
        rows_ = row(extent_.max.y) + 1;
        if (static_cast<double>(columns_) * static_cast<double>(rows_) <= 4 * static_cast<double>(count) + 16) {
            std::uint64_t entries = 0;
            for (const Box& box : boxes_) {
                if (holds_nothing(box)) continue;
                entries += static_cast<std::uint64_t>((column(box.max.x) - column(box.min.x) + 1) *
                                                      (row(box.max.y) - row(box.min.y) + 1));
                if (entries > most_entries) break;
            }
            if (entries <= most_entries) break;
        }
        if (cell_size_ > INT64_MAX / 2) break;  // four cells at most
    }

    const auto for_each_cell = [&](const Box& box, auto&& visit) {
        if (holds_nothing(box)) return;
        const std::int64_t last_column = column(box.max.x), last_row = row(box.max.y);
        for (std::int64_t r = row(box.min.y); r <= last_row; ++r) {
            for (std::int64_t c = column(box.min.x); c <= last_column; ++c) {
                visit(static_cast<std::size_t>(r * columns_ + c));
            }
        }
    };
    cell_starts_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
    for (const Box& box : boxes_) for_each_cell(box, [&](std::size_t cell) { ++cell_starts_[cell + 1]; });
    for (std::size_t i = 1; i < cell_starts_.size(); ++i) cell_starts_[i] += cell_starts_[i - 1];
    cell_boxes_.resize(cell_starts_.back());
    std::vector<std::uint32_t> next(cell_starts_.begin(), cell_starts_.end() - 1);
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
        for_each_cell(boxes_[i], [&](std::size_t cell) { cell_boxes_[next[cell]++] = static_cast<std::uint32_t>(i); });
    }
}

void BoxGrid::find(const Box& box, std::vector<std::uint32_t>& found) const {
    if (cell_starts_.empty() || holds_nothing(box) || !overlaps(box, extent_)) return;
    const auto column = [&](std::int64_t x) {
        return cell_along(extent_.min.x, std::clamp(x, extent_.min.x, extent_.max.x), cell_size_);
    };
    const auto row = [&](std::int64_t y) {
        return cell_along(extent_.min.y, std::clamp(y, extent_.min.y, extent_.max.y), cell_size_);
    };
    const std::int64_t first_column = column(box.min.x), last_column = column(box.max.x);
    const std::int64_t first_row = row(box.min.y), last_row = row(box.max.y);
    const std::size_t before = found.size();
    for (std::int64_t r = first_row; r <= last_row; ++r) {
        for (std::int64_t c = first_column; c <= last_column; ++c) {
            const std::size_t cell = static_cast<std::size_t>(r * columns_ + c);
            for (std::uint32_t k = cell_starts_[cell]; k < cell_starts_[cell + 1]; ++k) {
                const Box& candidate = boxes_[cell_boxes_[k]];
                if (!overlaps(candidate, box)) continue;
                // Each once: in the first of the cells that both lie in.
                if (std::max(column(candidate.min.x), first_column) != c) continue;
                if (std::max(row(candidate.min.y), first_row) != r) continue;
                found.push_back(cell_boxes_[k]);
            }
        }
    }
    std::sort(found.begin() + static_cast<std::ptrdiff_t>(before), found.end());
}

}  // namespace filigree
