// The symmetry groups of ornament by name: the 17 wallpaper groups, and the rosettes cN and dN.
//
// A wallpaper group is given over its tile, an upright rectangle by whose sides it repeats. Measured in tiles its
// operations and its domain are whole numbers of halves and twelfths, so that closure, orders and partition are exact
// at every size. The origin is a centre of rotation of the highest order (on a mirror, or on a glide's axis, where
// nothing turns). Hexagonal groups need a tile sqrt(3) times as high as wide, which holds two of their cells; the tile
// of cm and cmm holds two as well. One group may come in two settings: p1m1 has upright mirrors, p11m level ones.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "plane/point.h"

namespace filigree {

enum class Lattice : std::uint8_t { none, rectangular, square, hexagonal };  // none: a rosette

// In tiles: x' = (xx x + xy y) / 2 + dx / 12, y' = (yx x + yy y) / 2 + dy / 12.
struct TileOperation {
    int xx = 2, xy = 0, yx = 0, yy = 2;
    int dx = 0, dy = 0;  // of a group: 0..11

    bool operator==(const TileOperation&) const = default;
};
constexpr TileOperation compose(const TileOperation& outer, const TileOperation& inner) {
    const auto& o = outer;
    const auto& i = inner;
    return {(o.xx * i.xx + o.xy * i.yx) / 2,        (o.xx * i.xy + o.xy * i.yy) / 2,
            (o.yx * i.xx + o.yy * i.yx) / 2,        (o.yx * i.xy + o.yy * i.yy) / 2,
            (o.xx * i.dx + o.xy * i.dy) / 2 + o.dx, (o.yx * i.dx + o.yy * i.dy) / 2 + o.dy};
}
constexpr bool is_reflection(const TileOperation& op) { return op.xx * op.yy < op.xy * op.yx; }  // or a glide

struct TilePoint {  // twelfths of a tile from the origin
    int x = 0, y = 0;
};

struct SymmetryGroup {
    std::string name;  // "p4m", "d6": the short one
    Lattice lattice = Lattice::none;
    std::vector<TileOperation> operations;  // of a wallpaper group: one for each copy in a tile, the identity first
    std::vector<TilePoint> domain;          // likewise: a polygon whose copies cover the plane once, turning positively
    std::uint32_t turns = 1;                // of a rosette: N
    bool has_mirrors = false;               // of a rosette: dN; one mirror is upright
};
inline bool is_rosette(const SymmetryGroup& group) { return group.lattice == Lattice::none; }

constexpr std::uint32_t most_turns = 1000;

// By its short name, its full one (p4mm, c2mm) or the older ones (pmm2). An error names the nearest.
Result<SymmetryGroup> find_symmetry(std::string_view name, SourceSpan span = {});
// The short names of the wallpaper groups.
const std::vector<std::string_view>& wallpaper_names();

// The tile of a wallpaper group nearest to one of so many px, in grid units: even ones, and such that all corners of
// the domain and its copies lie on the grid. The width counts; a height that the group cannot have is replaced, with a
// warning. One that is off by up to a hundredth is kept, and the group is stretched by that little: tiles of whole
// pixels need it.
Result<Point> fit_tile(const SymmetryGroup& group, Vec px, SourceSpan span = {});
// The least tile about the origin that holds the box, but at least 1 px wide.
Point tile_around(const SymmetryGroup& group, const Box& box);

}  // namespace filigree
