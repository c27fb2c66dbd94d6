#include "plane/symmetry.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "base/elementary.h"
#include "plane/moved_polygon.h"

namespace filigree {
namespace {

// How far from its reflection a point may lie that stands on the mirror but for rounding, grid units.
constexpr double reach = 4;

Vec in_units(Point p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }

bool is_on_plane(Point p) { return std::abs(p.x) <= grid_limit && std::abs(p.y) <= grid_limit; }

Transform map_of(const TileOperation& op, Vec tile) {
    const double across = tile.x / tile.y;
    return {0.5 * op.xx, 0.5 * op.yx / across,  0.5 * op.xy * across,
            0.5 * op.yy, op.dx * (tile.x / 12), op.dy * (tile.y / 12)};
}

// Numbers 0 .. N-1 turn, N .. 2N-1 flip before they turn.
std::vector<Transform> rosette_maps(const SymmetryGroup& group) {
    std::vector<Transform> maps;
    for (const bool flips : {false, true}) {
        if (flips && !group.has_mirrors) break;
        for (std::uint32_t k = 0; k < group.turns; ++k) {
            const Transform turn = rotation_degrees(360.0 * k / group.turns);
            maps.push_back(flips ? compose(turn, scaling(-1, 1)) : turn);
        }
    }
    return maps;
}

// The sector of a disc, or all of it.
std::vector<Point> sector(double first_angle, double angle, double radius, double tolerance) {
    std::vector<Point> ring;
    if (angle < 180) ring.push_back({});
    const double arc = angle * (elementary::pi / 180);
    const double wanted = std::ceil(arc / std::sqrt(8 * std::clamp(tolerance / radius, 1e-9, 0.1)));
    const int steps = std::max(angle < 180 ? 1 : 4, static_cast<int>(wanted));
    for (int i = 0; i < steps + (angle < 360 ? 1 : 0); ++i) {
        const elementary::CosSin at = elementary::cos_sin_degrees(first_angle + angle * i / steps);
        ring.push_back(snap(radius * Vec{at.cos, at.sin}));
    }
    tidy_ring(ring);
    return ring;
}

}  // namespace

Symmetry::Symmetry(SymmetryGroup group, Point tile) : group_(std::move(group)), tile_(tile) {
    if (is_rosette(group_)) maps_ = rosette_maps(group_);
    for (const TileOperation& op : group_.operations) maps_.push_back(map_of(op, in_units(tile_)));
    for (std::uint32_t k = 0; k < operation_count(); ++k) {
        if (reflects(k)) reflections_.push_back(k);
    }
}

Transform Symmetry::transform(const Copy& copy) const {
    Transform map = maps_[copy.operation];
    map.e = (map.e + static_cast<double>(copy.column * tile_.x)) / grid_per_px;
    map.f = (map.f + static_cast<double>(copy.row * tile_.y)) / grid_per_px;
    return map;
}

Copy Symmetry::composed_turns(const Copy& outer, const Copy& inner) const {
    const std::uint32_t n = group_.turns;
    const bool outer_flips = outer.operation >= n, inner_flips = inner.operation >= n;
    const std::uint32_t first = inner.operation % n;
    const std::uint32_t turn = outer.operation % n + (outer_flips ? n - first : first);
    return {turn % n + (outer_flips != inner_flips ? n : 0), outer.column + inner.column, outer.row + inner.row};
}

Copy Symmetry::composed(const Copy& outer, const Copy& inner) const {
    if (is_rosette(group_)) return composed_turns(outer, inner);
    // Whole tiles are added at the end: the outer operation takes them to whole and half ones.
    const TileOperation& o = group_.operations[outer.operation];
    TileOperation op = compose(o, group_.operations[inner.operation]);
    const std::int64_t dx = op.dx + 6 * (o.xx * inner.column + o.xy * inner.row);
    const std::int64_t dy = op.dy + 6 * (o.yx * inner.column + o.yy * inner.row);
    const auto tiles = [](std::int64_t twelfths) { return (twelfths - ((twelfths % 12) + 12) % 12) / 12; };
    op.dx = static_cast<int>(dx - 12 * tiles(dx));
    op.dy = static_cast<int>(dy - 12 * tiles(dy));
    const auto found = std::find(group_.operations.begin(), group_.operations.end(), op);
    return {static_cast<std::uint32_t>(found - group_.operations.begin()), outer.column + tiles(dx),
            outer.row + tiles(dy)};
}

std::vector<Copy> Symmetry::copies_here(Point p) const {
    std::vector<Copy> here;
    const bool by_tiles = !is_rosette(group_);
    const Vec tile = in_units(tile_), at = in_units(p);
    for (const std::uint32_t k : reflections_) {
        Vec away = apply(maps_[k], at) - at;
        Copy mirror{k, 0, 0};
        if (by_tiles) {
            const double columns = std::floor(0.5 - away.x / tile.x), rows = std::floor(0.5 - away.y / tile.y);
            away = {away.x + columns * tile.x, away.y + rows * tile.y};
            if (std::fabs(away.x) > reach || std::fabs(away.y) > reach) continue;
            mirror.column = static_cast<std::int64_t>(columns);
            mirror.row = static_cast<std::int64_t>(rows);
        }
        if (std::fabs(away.x) <= reach && std::fabs(away.y) <= reach) here.push_back(mirror);
    }
    // Where mirrors cross, what they make together.
    const std::size_t mirrors = here.size();
    for (std::size_t done = 0; done < here.size() && mirrors > 1 && here.size() < operation_count(); ++done) {
        for (std::size_t m = 0; m < mirrors; ++m) {
            const Copy both = composed(here[m], here[done]);
            if (both == Copy{} || std::find(here.begin(), here.end(), both) != here.end()) continue;
            here.push_back(both);
        }
    }
    return here;
}

Point Symmetry::image(std::uint32_t operation, Point p) const {
    const Vec to = apply(maps_[operation], in_units(p));
    return {std::llround(to.x), std::llround(to.y)};
}

Point Symmetry::image(std::uint32_t operation, Point p, const std::vector<Copy>& here) const {
    // Of the copies that put the point there the first one decides, for all of them.
    Copy first{operation, 0, 0};
    for (const Copy& other : here) {
        const Copy same = composed({operation, 0, 0}, other);
        if (same.operation < first.operation) first = same;
    }
    const Point at = image(first.operation, p);
    return {at.x + first.column * tile_.x, at.y + first.row * tile_.y};
}

Polygons domain_of(const Symmetry& symmetry, double radius, double tolerance) {
    const SymmetryGroup& group = symmetry.group();
    std::vector<Point> ring;
    if (is_rosette(group)) {
        const double angle = (group.has_mirrors ? 180.0 : 360.0) / group.turns;
        ring = sector(group.has_mirrors ? -90 : -90 - angle / 2, angle, radius, tolerance);
    }
    for (const TilePoint& corner : group.domain) {
        ring.push_back({corner.x * symmetry.tile().x / 12, corner.y * symmetry.tile().y / 12});
    }
    Polygons domain;
    domain.add_ring(ring);
    domain.end_polygon();
    return domain;
}

SymmetryImages::SymmetryImages(const Symmetry& symmetry, const Polygons& motif, std::vector<bool> is_line)
    : symmetry_(symmetry), motif_(motif), is_line_(std::move(is_line)) {
    for (std::size_t i = 0; i < motif.points.size(); ++i) {
        std::vector<Copy> here = symmetry.copies_here(motif.points[i]);
        if (!here.empty()) at_mirrors_.push_back({i, std::move(here)});
    }
}

Polygons SymmetryImages::under(std::uint32_t operation) const {
    Polygons moved = motif_;
    const bool is_reflected = symmetry_.reflects(operation);
    for (Point& point : moved.points) point = symmetry_.image(operation, point);
    for (const AtMirror& at : at_mirrors_) {
        moved.points[at.point] = symmetry_.image(operation, motif_.points[at.point], at.here);
    }
    Polygons images;
    images.points.reserve(moved.points.size());
    images.ring_ends.reserve(moved.ring_ends.size());
    images.polygon_ends.reserve(moved.polygon_ends.size());
    for (std::size_t i = 0; i < moved.size(); ++i) {
        const Box box = bounds(moved[i]);
        const bool is_kept = !is_empty(box) && is_on_plane(box.min) && is_on_plane(box.max);
        const bool is_line = !is_line_.empty() && is_line_[i];
        const bool is_added =
            is_kept && (is_line ? add_moved_line(images, moved[i].outer()) : add_moved(images, moved[i], is_reflected));
        if (!is_added) images.end_polygon();
    }
    return images;
}

}  // namespace filigree
