#include "space/rejoin.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace filigree {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
// px: neighbours overlap by less, as their common edge is rounded.
constexpr double slack = 1e-6;
constexpr std::size_t most_tests = 2000;  // for one part

struct PictureBox {  // px
    Vec min{inf, inf}, max{-inf, -inf};
};

PictureBox box_of(std::span<const Vec> points) {
    PictureBox box;
    for (const Vec p : points) {
        box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
        box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
    }
    return box;
}

bool overlap(const PictureBox& a, const PictureBox& b) {
    return a.max.x > b.min.x + slack && b.max.x > a.min.x + slack && a.max.y > b.min.y + slack &&
           b.max.y > a.min.y + slack;
}

// The band that a line covers, but not its caps. An end that was cut is drawn in: what lies beyond the cut is not in
// the line's way, though its corners reach there.
void add_band(std::vector<Vec>& hull, std::span<const PieceCorner> corners, std::span<const Vec> places, double width) {
    for (std::size_t i = 1; i < places.size(); ++i) {
        const double stretch = length(places[i] - places[i - 1]);
        const Vec along = stretch > 0 ? (places[i] - places[i - 1]) * (1 / stretch) : Vec{1, 0};
        const Vec across = perpendicular(along) * (width / 2), in = along * std::min(width, stretch / 2);
        const Vec from = corners[i - 1].edge == no_edge ? places[i - 1] + in : places[i - 1];
        const Vec to = corners[i].edge == no_edge ? places[i] - in : places[i];
        hull.insert(hull.end(), {from - across, to - across, to + across, from + across});
    }
}

// Whether across some edge of `a`'s ring the hulls of both lie beside each other.
bool are_parted_across_edges(std::span<const Vec> a, std::span<const Vec> b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Vec from = a[i], along = a[i + 1 < a.size() ? i + 1 : 0] - from;
        const double edge = length(along);
        if (!(edge > slack)) continue;
        const Vec across = perpendicular(along) * (1 / edge);
        double a_min = inf, a_max = -inf, b_min = inf, b_max = -inf;
        for (const Vec p : a) {
            a_min = std::min(a_min, dot(across, p - from));
            a_max = std::max(a_max, dot(across, p - from));
        }
        for (const Vec p : b) {
            b_min = std::min(b_min, dot(across, p - from));
            b_max = std::max(b_max, dot(across, p - from));
        }
        if (b_min >= a_max - slack || b_max <= a_min + slack) return true;
    }
    return false;
}

// Which places in the order have something at each cell of the picture.
class OrderGrid {
public:
    OrderGrid(const std::vector<PictureBox>& boxes, std::span<const std::uint32_t> order) {
        PictureBox all;
        Vec mean;
        for (const std::uint32_t piece : order) {
            const PictureBox& box = boxes[piece];
            all.min = {std::min(all.min.x, box.min.x), std::min(all.min.y, box.min.y)};
            all.max = {std::max(all.max.x, box.max.x), std::max(all.max.y, box.max.y)};
            mean = mean + (box.max - box.min) * (1 / static_cast<double>(order.size()));
        }
        origin_ = all.min;
        const Vec size = all.max - all.min;
        const double cells = std::sqrt(static_cast<double>(order.size()));
        cell_ = {std::max({mean.x, size.x / cells, slack}), std::max({mean.y, size.y / cells, slack})};
        columns_ = static_cast<std::size_t>(size.x / cell_.x) + 1;
        rows_ = static_cast<std::size_t>(size.y / cell_.y) + 1;
        cells_.resize(columns_ * rows_);
        for (std::uint32_t place = 0; place < order.size(); ++place) {
            visit_cells(boxes[order[place]], [&](std::vector<std::uint32_t>& cell) {
                cell.push_back(place);
                return true;
            });
        }
    }

    void add(const PictureBox& box, std::uint32_t place) {
        visit_cells(box, [&](std::vector<std::uint32_t>& cell) {
            const auto at = std::lower_bound(cell.begin(), cell.end(), place);
            if (at == cell.end() || *at != place) cell.insert(at, place);
            return true;
        });
    }

    // Whether `holds` of all places between two, and there are not too many.
    template <class Holds>
    bool all_between(const PictureBox& box, std::uint32_t first, std::uint32_t last, const Holds& holds) {
        std::size_t tests = 0;
        return visit_cells(box, [&](std::vector<std::uint32_t>& cell) {
            for (auto at = std::upper_bound(cell.begin(), cell.end(), first); at != cell.end() && *at < last; ++at) {
                if (++tests > most_tests || !holds(*at)) return false;
            }
            return true;
        });
    }

private:
    template <class Visit>
    bool visit_cells(const PictureBox& box, const Visit& visit) {
        const std::size_t right = index(box.max.x - origin_.x, cell_.x, columns_);
        const std::size_t bottom = index(box.max.y - origin_.y, cell_.y, rows_);
        for (std::size_t row = index(box.min.y - origin_.y, cell_.y, rows_); row <= bottom; ++row) {
            for (std::size_t column = index(box.min.x - origin_.x, cell_.x, columns_); column <= right; ++column) {
                if (!visit(cells_[row * columns_ + column])) return false;
            }
        }
        return true;
    }
    static std::size_t index(double offset, double cell, std::size_t count) {
        return static_cast<std::size_t>(std::clamp(offset / cell, 0.0, static_cast<double>(count - 1)));
    }

    Vec origin_, cell_;
    std::size_t columns_ = 1, rows_ = 1;
    std::vector<std::vector<std::uint32_t>> cells_;  // places in rising order
};

class Rejoiner {
public:
    Rejoiner(const Pieces& pieces, std::span<const std::uint32_t> order, std::span<const Vec> places,
             std::span<const double> widths)
        : pieces_(pieces), order_(order.begin(), order.end()), place_of_(pieces.pieces.size(), no_piece) {
        for (std::uint32_t i = 0; i < pieces.pieces.size(); ++i) {
            const Piece& piece = pieces.pieces[i];
            const std::span<const Vec> at = places.subspan(piece.first, piece.count);
            if (piece.is_line) {
                add_band(hulls_, corners_of(pieces, i), at, widths[i]);
            } else {
                hulls_.insert(hulls_.end(), at.begin(), at.end());
            }
            hull_ends_.push_back(hulls_.size());
            boxes_.push_back(box_of(hull(i)));
        }
        grid_.emplace(boxes_, order);
        for (std::uint32_t place = 0; place < order_.size(); ++place) place_of_[order_[place]] = place;
    }

    std::vector<std::uint32_t> rejoin() && {
        const std::vector<std::uint32_t> first_part = first_parts();
        for (auto parent = static_cast<std::uint32_t>(pieces_.pieces.size()); parent-- > 0;) {
            if (first_part[parent] == no_piece) continue;
            parts_.clear();
            for (std::uint32_t part = first_part[parent]; part != no_piece; part = next_part_[part]) {
                parts_.push_back(part);
            }
            join(parent);
        }
        std::erase(order_, no_piece);
        return std::move(order_);
    }

private:
    std::span<const Vec> hull(std::uint32_t piece) const {
        const std::size_t first = piece == 0 ? 0 : hull_ends_[piece - 1];
        return {hulls_.data() + first, hulls_.data() + hull_ends_[piece]};
    }

    // Of each parent, in chains.
    std::vector<std::uint32_t> first_parts() {
        std::vector<std::uint32_t> first(pieces_.pieces.size(), no_piece);
        next_part_.assign(pieces_.pieces.size(), no_piece);
        for (auto i = static_cast<std::uint32_t>(pieces_.pieces.size()); i-- > 0;) {
            const std::uint32_t parent = pieces_.pieces[i].parent;
            if (parent == no_piece) continue;
            next_part_[i] = first[parent];
            first[parent] = i;
        }
        return first;
    }

    bool may_overlap(std::uint32_t a, std::uint32_t b) const {
        if (!overlap(boxes_[a], boxes_[b])) return false;
        return !are_parted_across_edges(hull(a), hull(b)) && !are_parted_across_edges(hull(b), hull(a));
    }

    bool may_move(std::uint32_t part, std::uint32_t place) {
        const auto [first, last] = std::minmax(place, place_of_[part]);
        return grid_->all_between(boxes_[part], first, last, [&](std::uint32_t between) {
            const std::uint32_t other = order_[between];
            return other == no_piece || pieces_.pieces[other].parent == pieces_.pieces[part].parent ||
                   !may_overlap(part, other);
        });
    }

    void join(std::uint32_t parent) {
        std::uint32_t earliest = no_piece, latest = 0;
        for (const std::uint32_t part : parts_) {
            if (place_of_[part] == no_piece) return;
            earliest = std::min(earliest, place_of_[part]);
            latest = std::max(latest, place_of_[part]);
        }
        for (const std::uint32_t place : {earliest, latest}) {
            const auto may = [&](std::uint32_t part) { return may_move(part, place); };
            if (!std::all_of(parts_.begin(), parts_.end(), may)) continue;
            for (const std::uint32_t part : parts_) {
                order_[place_of_[part]] = no_piece;
                place_of_[part] = no_piece;
            }
            order_[place] = parent;
            place_of_[parent] = place;
            grid_->add(boxes_[parent], place);
            return;
        }
    }

    const Pieces& pieces_;
    std::vector<Vec> hulls_;  // points whose hulls are what the pieces cover
    std::vector<std::size_t> hull_ends_;
    std::vector<PictureBox> boxes_;
    std::vector<std::uint32_t> order_;     // no_piece where a part was
    std::vector<std::uint32_t> place_of_;  // of what is in the order
    std::vector<std::uint32_t> next_part_;
    std::vector<std::uint32_t> parts_;
    std::optional<OrderGrid> grid_;
};

}  // namespace

std::vector<std::uint32_t> rejoined(const Pieces& pieces, std::span<const std::uint32_t> order,
                                    std::span<const Vec> places, std::span<const double> widths) {
    if (order.empty()) return {};
    return Rejoiner(pieces, order, places, widths).rejoin();
}

}  // namespace filigree
