#include "plane/scatter_cells.h"

#include <algorithm>
#include <cmath>

namespace filigree {

namespace {

// Points keep so much farther off than asked, so that no rounding brings them nearer, px.
double safe_clearance(double clearance, const Box& box) {
    const double far = std::max({std::fabs(to_px(box.min).x), std::fabs(to_px(box.min).y), std::fabs(to_px(box.max).x),
                                 std::fabs(to_px(box.max).y)});
    return (clearance > 0 ? clearance : 0) * (1 + 1e-12) + 0x1p-24 + far * 0x1p-48;
}

}  // namespace

AllowedRegion::AllowedRegion(PolygonView region, double clearance)
    : tree_(edges_of(region, Point{0, 0})), clearance_(safe_clearance(clearance, bounds(region))) {
    const Box box = bounds(region);
    box_ = {to_px(box.min), to_px(box.max)};
}

bool AllowedRegion::holds(Vec p, double half_side) const {
    const EdgeTree::Place place = tree_.place(p, clearance_, clearance_ + 3 * half_side);
    return place.is_inside && place.distance >= clearance_;
}

Vec AllowedRegion::moved_to_allowed(Vec p, double half_side) const {
    const double sight = clearance_ + 3 * half_side;
    const EdgeTree::Place place = tree_.place(p, sight, sight);
    const Vec away = p - place.nearest;
    const double distance = length(away);
    if (!(distance > 0)) return p;
    const double rounding = 0x1p-28 + (std::fabs(p.x) + std::fabs(p.y)) * 1e-15;
    const double wanted = clearance_ * (1 + 1e-9) + rounding;
    return place.nearest + away * ((place.is_inside ? wanted : -wanted) / distance);
}

AllowedRegion::Part AllowedRegion::part_of_square(Vec centre, double half_side) const {
    const double half = half_side * 1.4142135623730952;
    if (centre.x + half_side < box_.min.x || centre.x - half_side > box_.max.x || centre.y + half_side < box_.min.y ||
        centre.y - half_side > box_.max.y) {
        return Part::none;
    }
    const double enough = clearance_ + half;
    // Looking as far as this, the boundary is in sight of every quarter of a square of `some`.
    const EdgeTree::Place place = tree_.place(centre, enough, clearance_ + 3.01 * half);
    const double distance = place.distance;
    if (!place.is_inside) return distance + clearance_ > half ? Part::none : Part::some;
    if (distance >= enough) return Part::all;
    return distance + half < clearance_ ? Part::none : Part::some;
}

ScatterCells::ScatterCells(const AllowedRegion& region, double spacing, std::uint64_t most)
    : side_(spacing * 0.7071067811865475), most_squares_(most), searches_left_(16 * most + 1'000'000) {
    const VecBox box = region.box();
    int level = 4;
    while (std::max(box.max.x - box.min.x, box.max.y - box.min.y) > side_ * std::ldexp(1.0, level)) ++level;
    const double top = side_ * std::ldexp(1.0, level);
    for (double row = std::floor(box.min.y / top); row * top <= box.max.y; ++row) {
        for (double column = std::floor(box.min.x / top); column * top <= box.max.x; ++column) {
            search(region, static_cast<std::int64_t>(column), static_cast<std::int64_t>(row), level, false);
        }
    }
    link_tiles();
}

// Squares of 2^level cells a side, counted in such squares.
void ScatterCells::search(const AllowedRegion& region, std::int64_t column, std::int64_t row, int level, bool is_free) {
    if (squares_.size() >= most_squares_ || searches_left_ == 0) {
        cut_short_ = true;
        return;
    }
    if (!is_free) {
        --searches_left_;
        const double half = side_ * std::ldexp(0.5, level);
        const Vec centre{(2 * static_cast<double>(column) + 1) * half, (2 * static_cast<double>(row) + 1) * half};
        const AllowedRegion::Part part = region.part_of_square(centre, half);
        if (part == AllowedRegion::Part::none) return;
        is_free = part == AllowedRegion::Part::all;
    }
    if (level == 0) {
        ScatterSquare square;
        square.tile = tile_at(column >> 4, row >> 4);
        square.cell = static_cast<std::uint8_t>((row & 15) << 4 | (column & 15));
        square.is_free = is_free;
        squares_.push_back(square);
        return;
    }
    for (int y = 0; y < 2; ++y) {
        for (int x = 0; x < 2; ++x) search(region, 2 * column + x, 2 * row + y, level - 1, is_free);
    }
}

// The search ends with one tile before it begins the next.
std::uint32_t ScatterCells::tile_at(std::int64_t column, std::int64_t row) {
    if (tiles_.empty() || tiles_.back().column != column || tiles_.back().row != row) {
        Tile& tile = tiles_.emplace_back();
        tile.column = column;
        tile.row = row;
    }
    return static_cast<std::uint32_t>(tiles_.size() - 1);
}

void ScatterCells::link_tiles() {
    struct Place {
        std::int64_t row, column;
        std::uint32_t tile;
        auto operator<=>(const Place&) const = default;
    };
    std::vector<Place> places;
    places.reserve(tiles_.size());
    for (std::uint32_t t = 0; t < tiles_.size(); ++t) places.push_back({tiles_[t].row, tiles_[t].column, t});
    std::sort(places.begin(), places.end());
    for (Tile& tile : tiles_) {
        for (int i = 0; i < 9; ++i) {
            const Place wanted{tile.row + i / 3 - 1, tile.column + i % 3 - 1, 0};
            const auto found = std::lower_bound(places.begin(), places.end(), wanted);
            const bool is_there = found != places.end() && found->row == wanted.row && found->column == wanted.column;
            tile.around[static_cast<std::size_t>(i)] = is_there ? found->tile : none;
        }
    }
}

void ScatterCells::fill(const ScatterSquare& s, Vec at) {
    Tile& tile = tiles_[s.tile];
    tile.filled[s.cell >> 4] = static_cast<std::uint16_t>(tile.filled[s.cell >> 4] | 1U << (s.cell & 15));
    tile.points[s.cell] = at;
}

}  // namespace filigree
