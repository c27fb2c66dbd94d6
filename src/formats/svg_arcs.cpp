#include "formats/svg_arcs.h"

#include <cmath>
#include <utility>

#include "base/elementary.h"
#include "formats/svg_path_data.h"

namespace filigree {
namespace {

constexpr int most_pieces = 8;
constexpr double most_off = 1.5;  // units: rounding an end alone moves it by 0.7

class ArcRounder {
public:
    ArcRounder(const CentreArc& arc, double rotation, Vec to, int decimals)
        : arc_(arc),
          to_(to),
          decimals_(decimals),
          rx_(length(arc.across)),
          ry_(length(arc.along)),
          rotation_(rotation) {
        for (int i = 0; i < decimals; ++i) unit_ /= 10;
    }

    // None where a piece would lie off.
    std::optional<std::vector<RoundedArc>> pieces(int count, Point at) const {
        std::vector<RoundedArc> pieces;
        for (int i = 0; i < count; ++i) {
            const std::optional<RoundedArc> next = piece(i, count, at);
            if (!next) return std::nullopt;
            pieces.push_back(*next);
            at = next->to;
        }
        return pieces;
    }

private:
    std::optional<RoundedArc> piece(int i, int count, Point from) const {
        RoundedArc piece;
        piece.rx = std::llround(rx_ / unit_);
        piece.ry = std::llround(ry_ / unit_);
        piece.rotation = piece.rx == piece.ry ? 0 : rotation_;
        piece.is_large = std::fabs(arc_.turn) > count * elementary::pi;
        piece.is_sweep = arc_.turn > 0;
        const Vec to = i + 1 == count ? to_ : point_at(arc_, (i + 1.0) / count);
        const Point on_grid = snap(to);
        piece.to = {rounded_coordinate(on_grid.x, decimals_), rounded_coordinate(on_grid.y, decimals_)};
        if (is_near(piece, i, count, from)) return piece;
        // Half a turn is what radii come to that do not reach.
        RoundedArc half = piece;
        --half.rx;
        --half.ry;
        if (half.rx > 0 && half.ry > 0 && is_near(half, i, count, from)) return half;
        return std::nullopt;
    }

    bool is_near(const RoundedArc& piece, int i, int count, Point at) const {
        const Vec from = px(at), to = px(piece.to);
        const Vec shape[2] = {{static_cast<double>(piece.rx) * unit_, static_cast<double>(piece.ry) * unit_},
                              {piece.rotation, (piece.is_large ? 1.0 : 0.0) + (piece.is_sweep ? 2.0 : 0.0)}};
        const CentreArc comes = centre_arc(from, shape, to);
        for (const double part : {0.25, 0.5, 0.75}) {
            const Vec wanted = point_at(arc_, (i + part) / count);
            const Vec found = comes.is_line ? from + part * (to - from) : point_at(comes, part);
            if (!(length(found - wanted) <= most_off * unit_)) return false;
        }
        return true;
    }
    Vec px(Point units) const { return {static_cast<double>(units.x) * unit_, static_cast<double>(units.y) * unit_}; }

    const CentreArc& arc_;
    const Vec to_;
    const int decimals_;
    double unit_ = 1;  // px
    const double rx_, ry_;
    const double rotation_;  // degrees
};

}  // namespace

std::optional<std::vector<RoundedArc>> rounded_arcs(const CentreArc& arc, double rotation, Vec to, Point at,
                                                    int decimals) {
    const ArcRounder rounder(arc, std::fmod(rotation, 360), to, decimals);
    std::optional<std::vector<RoundedArc>> pieces;
    for (int count = 1; count <= most_pieces && !pieces; count *= 2) pieces = rounder.pieces(count, at);
    return pieces;
}

}  // namespace filigree
