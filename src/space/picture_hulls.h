// What pieces cover in the picture, and which of them lie near each other there; inner part of rejoin and
// stroke_again.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "plane/point.h"
#include "space/painters_order.h"

namespace filigree {

// px: neighbours overlap by less, as their common edge is rounded.
constexpr double picture_slack = 1e-6;

struct PictureBox {  // px
    Vec min{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    Vec max{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
};
PictureBox box_of(std::span<const Vec> points);
bool overlap(const PictureBox& a, const PictureBox& b);  // by more than the slack

// Whether the hulls of two rings lie beside each other, parted along an edge of one. Exact for convex rings; else some
// that do may be missed.
bool are_apart(std::span<const Vec> a, std::span<const Vec> b);

// The band that a line covers, but not its caps; shorter by some px at either end, at most by half.
void add_band(std::vector<Vec>& points, Vec from, Vec to, double width, double less_before, double less_behind);

// Of all pieces, by their numbers: points whose hulls they cover, and the boxes of these.
struct PictureHulls {
    std::vector<Vec> points;
    std::vector<std::size_t> ends;
    std::vector<PictureBox> boxes;

    std::span<const Vec> operator[](std::uint32_t piece) const {
        return {points.data() + (piece == 0 ? 0 : ends[piece - 1]), points.data() + ends[piece]};
    }
};
// `places` has where each of Pieces::corners lies in the picture, `widths` how wide each line is there. Ends of lines
// that were cut may be taken as shorter by this width: what lies beyond the cut is not in the line's way, though its
// corners reach there.
enum class CutEnds : std::uint8_t { whole, shorter };
PictureHulls picture_hulls(const Pieces& pieces, std::span<const Vec> places, std::span<const double> widths,
                           CutEnds ends);

// Which places of an order have something at each cell of the picture.
class OrderGrid {
public:
    OrderGrid(const std::vector<PictureBox>& boxes, std::span<const std::uint32_t> order);

    void add(const PictureBox& box, std::uint32_t place);

    // Visits the places behind `first` and before `end` that may have something in the box, some more than once, while
    // the visitor returns true; returns whether it always did.
    template <class Visit>
    bool visit_between(const PictureBox& box, std::uint32_t first, std::uint32_t end, const Visit& visit) const {
        const CellRange range = cells_of(box);
        for (std::size_t row = range.top; row <= range.bottom; ++row) {
            for (std::size_t column = range.left; column <= range.right; ++column) {
                const std::vector<std::uint32_t>& cell = cells_[row * columns_ + column];
                for (auto at = std::upper_bound(cell.begin(), cell.end(), first); at != cell.end() && *at < end; ++at) {
                    if (!visit(*at)) return false;
                }
            }
        }
        return true;
    }

private:
    struct CellRange {
        std::size_t left, right, top, bottom;
    };
    CellRange cells_of(const PictureBox& box) const;

    Vec origin_, cell_;
    std::size_t columns_ = 1, rows_ = 1;
    std::vector<std::vector<std::uint32_t>> cells_;  // places in rising order
};

}  // namespace filigree
