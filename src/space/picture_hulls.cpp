#include "space/picture_hulls.h"

#include <cmath>

namespace filigree {
namespace {

struct Extent {
    double min = std::numeric_limits<double>::infinity(), max = -std::numeric_limits<double>::infinity();
};

Extent along_normal(std::span<const Vec> points, Vec from, Vec normal) {
    Extent extent;
    for (const Vec p : points) {
        const double at = dot(normal, p - from);
        extent.min = std::min(extent.min, at);
        extent.max = std::max(extent.max, at);
    }
    return extent;
}

bool are_parted_across_edges(std::span<const Vec> a, std::span<const Vec> b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Vec along = a[i + 1 < a.size() ? i + 1 : 0] - a[i];
        const double edge = length(along);
        if (!(edge > picture_slack)) continue;
        const Vec normal = perpendicular(along) * (1 / edge);
        const Extent of_a = along_normal(a, a[i], normal), of_b = along_normal(b, a[i], normal);
        if (of_b.min >= of_a.max - picture_slack || of_b.max <= of_a.min + picture_slack) return true;
    }
    return false;
}

}  // namespace

PictureBox box_of(std::span<const Vec> points) {
    PictureBox box;
    for (const Vec p : points) {
        box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
        box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
    }
    return box;
}

bool overlap(const PictureBox& a, const PictureBox& b) {
    return a.max.x > b.min.x + picture_slack && b.max.x > a.min.x + picture_slack &&
           a.max.y > b.min.y + picture_slack && b.max.y > a.min.y + picture_slack;
}

bool are_apart(std::span<const Vec> a, std::span<const Vec> b) {
    return are_parted_across_edges(a, b) || are_parted_across_edges(b, a);
}

void add_band(std::vector<Vec>& points, Vec from, Vec to, double width, double less_before, double less_behind) {
    const double stretch = length(to - from);
    const Vec along = stretch > 0 ? (to - from) * (1 / stretch) : Vec{1, 0};
    const Vec across = perpendicular(along) * (width / 2);
    const Vec first = from + along * std::min(less_before, stretch / 2);
    const Vec last = to - along * std::min(less_behind, stretch / 2);
    points.insert(points.end(), {first - across, last - across, last + across, first + across});
}

PictureHulls picture_hulls(const Pieces& pieces, std::span<const Vec> places, std::span<const double> widths,
                           CutEnds ends) {
    PictureHulls hulls;
    for (std::uint32_t i = 0; i < pieces.pieces.size(); ++i) {
        const Piece& piece = pieces.pieces[i];
        const std::span<const Vec> at = places.subspan(piece.first, piece.count);
        if (piece.is_line) {
            const std::span<const PieceCorner> corners = corners_of(pieces, i);
            const auto less_at = [&](std::size_t k) {
                return ends == CutEnds::shorter && corners[k].edge == no_edge ? widths[i] : 0;
            };
            for (std::size_t k = 1; k < at.size(); ++k) {
                add_band(hulls.points, at[k - 1], at[k], widths[i], less_at(k - 1), less_at(k));
            }
        } else {
            hulls.points.insert(hulls.points.end(), at.begin(), at.end());
        }
        hulls.ends.push_back(hulls.points.size());
        hulls.boxes.push_back(box_of(hulls[i]));
    }
    return hulls;
}

OrderGrid::OrderGrid(const std::vector<PictureBox>& boxes, std::span<const std::uint32_t> order) {
    PictureBox all;
    Vec mean;
    for (const std::uint32_t piece : order) {
        const PictureBox& box = boxes[piece];
        all.min = {std::min(all.min.x, box.min.x), std::min(all.min.y, box.min.y)};
        all.max = {std::max(all.max.x, box.max.x), std::max(all.max.y, box.max.y)};
        mean = mean + (box.max - box.min) * (1 / static_cast<double>(order.size()));
    }
    if (order.empty()) all = {{}, {}};
    origin_ = all.min;
    const Vec size = all.max - all.min;
    const double side = std::sqrt(static_cast<double>(std::max<std::size_t>(order.size(), 1)));
    cell_ = {std::max({mean.x, size.x / side, picture_slack}), std::max({mean.y, size.y / side, picture_slack})};
    columns_ = static_cast<std::size_t>(size.x / cell_.x) + 1;
    rows_ = static_cast<std::size_t>(size.y / cell_.y) + 1;
    cells_.resize(columns_ * rows_);
    for (std::uint32_t place = 0; place < order.size(); ++place) add(boxes[order[place]], place);
}

void OrderGrid::add(const PictureBox& box, std::uint32_t place) {
    const CellRange range = cells_of(box);
    for (std::size_t row = range.top; row <= range.bottom; ++row) {
        for (std::size_t column = range.left; column <= range.right; ++column) {
            std::vector<std::uint32_t>& cell = cells_[row * columns_ + column];
            const auto at = std::lower_bound(cell.begin(), cell.end(), place);
            if (at == cell.end() || *at != place) cell.insert(at, place);
        }
    }
}

OrderGrid::CellRange OrderGrid::cells_of(const PictureBox& box) const {
    const auto index = [](double offset, double cell, std::size_t count) {
        return static_cast<std::size_t>(std::clamp(offset / cell, 0.0, static_cast<double>(count - 1)));
    };
    return {index(box.min.x - origin_.x, cell_.x, columns_), index(box.max.x - origin_.x, cell_.x, columns_),
            index(box.min.y - origin_.y, cell_.y, rows_), index(box.max.y - origin_.y, cell_.y, rows_)};
}

}  // namespace filigree
