#include "space/stroke_again.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

namespace filigree {
namespace {

constexpr std::size_t most_tests = 2000;  // for one stroke

using Stretch = std::array<Vec, 2>;

// Where a stretch runs inside a convex ring, in parts of its length; all of it for other rings.
std::array<double, 2> part_inside(const Stretch& stretch, std::span<const Vec> ring) {
    double turned = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec a = ring[i], b = ring[(i + 1) % ring.size()], c = ring[(i + 2) % ring.size()];
        const double turn = cross(b - a, c - b);
        if (turn * turned < 0) return {0, 1};
        if (turn != 0) turned = turn;
    }
    double enter = 0, leave = 1;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec along = ring[(i + 1) % ring.size()] - ring[i];
        const double from = cross(along, stretch[0] - ring[i]) * (turned < 0 ? -1 : 1);
        const double to = cross(along, stretch[1] - ring[i]) * (turned < 0 ? -1 : 1);
        if (from < 0 && to < 0) return {0, 0};
        if (from < 0) enter = std::max(enter, from / (from - to));
        if (to < 0) leave = std::min(leave, from / (from - to));
    }
    return {enter, leave};
}

class StrokeSearch {
public:
    StrokeSearch(const Pieces& pieces, std::span<const std::uint32_t> order, std::span<const Vec> places,
                 const PictureHulls& hulls, std::span<const double> strokes)
        : pieces_(pieces),
          order_(order),
          places_(places),
          hulls_(hulls),
          strokes_(strokes),
          grid_(hulls.boxes, order) {}

    std::vector<StrokeAgain> search() && {
        for (std::uint32_t place = 0; place < order_.size(); ++place) {
            const Piece& piece = pieces_.pieces[order_[place]];
            if (piece.is_line) continue;
            for (std::uint32_t i = 0; i < piece.count; ++i) {
                const double width = strokes_[piece.first + i];
                if (width > 0) search_behind(place, stretch_of(piece, i), width);
            }
        }
        std::vector<std::uint32_t> by_place(found_.size());
        std::iota(by_place.begin(), by_place.end(), 0U);
        std::sort(by_place.begin(), by_place.end(), [&](std::uint32_t a, std::uint32_t b) {
            return std::tie(found_[a].place, a) < std::tie(found_[b].place, b);
        });
        std::vector<StrokeAgain> sorted;
        sorted.reserve(found_.size());
        for (const std::uint32_t i : by_place) sorted.push_back(std::move(found_[i]));
        return sorted;
    }

private:
    // What is still to be seen of a stretch, and behind which place it has to be painted again.
    struct Rest {
        double from = 0, to = 1;
        std::uint32_t again = no_piece;
    };

    Stretch stretch_of(const Piece& piece, std::uint32_t corner) const {
        return {places_[piece.first + corner], places_[piece.first + (corner + 1 < piece.count ? corner + 1 : 0)]};
    }

    void search_behind(std::uint32_t place, const Stretch& edge, double width) {
        if (!find_later(place, edge, width)) return;
        rests_ = {{}};
        for (const std::uint32_t later : later_) {
            const std::uint32_t other = order_[later];
            next_.clear();
            for (const Rest& rest : rests_) hold_against(rest, edge, width, later, other);
            std::swap(rests_, next_);
            if (rests_.empty()) return;
        }
        for (const Rest& rest : rests_) {
            if (rest.again != no_piece) add(order_[place], rest, edge);
        }
    }

    // Places behind one that may have something beside an edge, unless there are too many.
    bool find_later(std::uint32_t place, const Stretch& edge, double width) {
        later_.clear();
        const PictureBox box = box_of(band_along(edge, width));
        const bool are_few = grid_.visit_between(box, place, no_piece, [&](std::uint32_t other) {
            if (overlap(box, hulls_.boxes[order_[other]])) later_.push_back(other);
            return later_.size() <= most_tests;
        });
        std::sort(later_.begin(), later_.end());
        later_.erase(std::unique(later_.begin(), later_.end()), later_.end());
        return are_few;
    }

    // Without its ends, which all that goes on from them touches.
    std::span<const Vec> band_along(const Stretch& edge, double width) {
        band_.clear();
        add_band(band_, edge[0], edge[1], width, width / 2, width / 2);
        return band_;
    }

    void hold_against(Rest rest, const Stretch& edge, double width, std::uint32_t place, std::uint32_t other) {
        const Vec along = edge[1] - edge[0];
        const Stretch seen = {edge[0] + along * rest.from, edge[0] + along * rest.to};
        if (are_apart(band_along(seen, width), hulls_[other])) {
            next_.push_back(rest);
        } else if (are_apart(seen, hulls_[other])) {
            const bool covers = !pieces_.pieces[other].is_line;
            if (covers && strokes_along(pieces_.pieces[other], seen)) return;
            if (covers) rest.again = place;
            next_.push_back(rest);
        } else {
            const auto [enter, leave] = part_inside(seen, hulls_[other]);
            const double part = rest.to - rest.from, least = picture_slack / length(along);
            if (enter * part > least) next_.push_back({rest.from, rest.from + enter * part, rest.again});
            if ((1 - leave) * part > least) next_.push_back({rest.from + leave * part, rest.to, rest.again});
        }
    }

    bool strokes_along(const Piece& piece, const Stretch& edge) const {
        for (std::uint32_t i = 0; i < piece.count; ++i) {
            if (strokes_[piece.first + i] <= 0) continue;
            const Stretch own = stretch_of(piece, i);
            const double along = length(own[1] - own[0]);
            if (!(along > 0)) continue;
            const Vec direction = (own[1] - own[0]) * (1 / along);
            const auto is_on = [&](Vec p) {
                const double at = dot(p - own[0], direction), beside = std::fabs(cross(direction, p - own[0]));
                return at >= -picture_slack && at <= along + picture_slack && beside <= picture_slack;
            };
            if (is_on(edge[0]) && is_on(edge[1])) return true;
        }
        return false;
    }

    // Edges that follow one another become one line.
    void add(std::uint32_t piece, const Rest& rest, const Stretch& edge) {
        const Vec along = edge[1] - edge[0];
        const Vec from = rest.from == 0 ? edge[0] : edge[0] + along * rest.from;
        const Vec to = rest.to == 1 ? edge[1] : edge[0] + along * rest.to;
        if (!found_.empty() && found_.back().piece == piece && found_.back().place == rest.again &&
            found_.back().line.back() == from) {
            found_.back().line.push_back(to);
        } else {
            found_.push_back({rest.again, piece, {from, to}});
        }
    }

    const Pieces& pieces_;
    const std::span<const std::uint32_t> order_;
    const std::span<const Vec> places_;
    const PictureHulls& hulls_;
    const std::span<const double> strokes_;
    const OrderGrid grid_;
    std::vector<StrokeAgain> found_;
    std::vector<Vec> band_;
    std::vector<std::uint32_t> later_;
    std::vector<Rest> rests_, next_;
};

}  // namespace

std::vector<StrokeAgain> strokes_again(const Pieces& pieces, std::span<const std::uint32_t> order,
                                       std::span<const Vec> places, const PictureHulls& hulls,
                                       std::span<const double> strokes) {
    return StrokeSearch(pieces, order, places, hulls, strokes).search();
}

}  // namespace filigree
