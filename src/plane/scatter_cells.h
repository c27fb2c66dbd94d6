// The cells that a scatter throws into: squares of an absolute grid of the plane whose diagonal is the
// spacing, so that a cell holds at most one point and only 20 others matter to it. Kept in tiles of 16 by 16
// wherever the region reaches, found by halving squares against the region's boundary.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "plane/edge_tree.h"

namespace filigree {

// Where points may lie: inside the region and no nearer than a distance to its boundary.
class AllowedRegion {
public:
    AllowedRegion(PolygonView region, double clearance);

    // For a point in a square of `some`, given half its side.
    bool holds(Vec p, double half_side) const;
    // The point that is just far enough from the border point nearest to p; p itself where there is none near.
    // Another part of the border may still be too near to it.
    Vec moved_to_allowed(Vec p, double half_side) const;

    enum class Part { none, some, all };
    Part part_of_square(Vec centre, double half_side) const;  // `some` where in doubt

    VecBox box() const { return box_; }

private:
    EdgeTree tree_;
    VecBox box_;
    double clearance_;
};

struct ScatterSquare {  // a cell, or at some level a 2^-level part of its side
    std::uint32_t tile = 0;
    std::uint16_t x = 0, y = 0;  // of the part in the cell
    std::uint8_t cell = 0;       // in the tile: 16 * row + column
    bool is_free = false;        // all of it is allowed
};

class ScatterCells {
public:
    static constexpr std::uint32_t none = UINT32_MAX;

    // Finds the cells that the region reaches, but not many more than `most`.
    ScatterCells(const AllowedRegion& region, double spacing, std::uint64_t most);

    const std::vector<ScatterSquare>& squares() const { return squares_; }
    bool was_cut_short() const { return cut_short_; }
    double cell_side() const { return side_; }

    std::int64_t column(const ScatterSquare& s) const { return tiles_[s.tile].column * 16 + (s.cell & 15); }
    std::int64_t row(const ScatterSquare& s) const { return tiles_[s.tile].row * 16 + (s.cell >> 4); }
    std::uint64_t key(const ScatterSquare& s) const { return pack(column(s), row(s)); }
    static std::uint64_t pack(std::int64_t column, std::int64_t row) {  // ordered by rows, then columns
        const auto low = [](std::int64_t v) {
            return static_cast<std::uint64_t>(static_cast<std::uint32_t>(static_cast<std::uint64_t>(v) + 0x80000000U));
        };
        return low(row) << 32 | low(column);
    }

    bool is_filled(std::uint32_t tile, unsigned cell) const {
        return tiles_[tile].filled[cell >> 4] >> (cell & 15) & 1U;
    }
    void fill(const ScatterSquare& s, Vec at);
    Vec point(std::uint32_t tile, unsigned cell) const { return tiles_[tile].points[cell]; }
    std::uint32_t tile_count() const { return static_cast<std::uint32_t>(tiles_.size()); }

    // Calls visit(point) for those in the 20 cells around that may be nearer than the spacing to a point of this
    // cell, until one returns true; whether one did.
    template <class Visit>
    bool any_neighbour(const ScatterSquare& s, Visit visit) const;

private:
    struct Tile {
        std::int64_t column = 0, row = 0;
        std::array<std::uint32_t, 9> around;     // the tiles about it, itself in the middle
        std::array<std::uint16_t, 16> filled{};  // bits of rows
        std::array<Vec, 256> points;
    };

    void search(const AllowedRegion& region, std::int64_t column, std::int64_t row, int level, bool is_free);
    std::uint32_t tile_at(std::int64_t column, std::int64_t row);
    void link_tiles();

    double side_;
    std::uint64_t most_squares_;
    std::uint64_t searches_left_;
    bool cut_short_ = false;
    std::vector<Tile> tiles_;
    std::vector<ScatterSquare> squares_;
};

template <class Visit>
bool ScatterCells::any_neighbour(const ScatterSquare& s, Visit visit) const {
    const Tile& home = tiles_[s.tile];
    const int column = s.cell & 15;
    const int row = s.cell >> 4;
    for (int y = row - 2; y <= row + 2; ++y) {
        const std::uint32_t* tiles = &home.around[static_cast<std::size_t>(3 * ((y >> 4) + 1))];
        const auto line = static_cast<std::size_t>(y & 15);
        const auto filled = [&](std::size_t i) {
            return tiles[i] == none ? std::uint64_t{0} : std::uint64_t{tiles_[tiles[i]].filled[line]};
        };
        std::uint64_t bits = filled(1) << 16;
        if (column < 2) bits |= filled(0);
        if (column > 13) bits |= filled(2) << 32;
        // Five cells of the middle rows, three of the first and the last; a cell itself is never filled here.
        bits &= (y == row - 2 || y == row + 2 ? std::uint64_t{0b01110} : std::uint64_t{0b11111}) << (column + 14);
        for (; bits != 0; bits &= bits - 1) {
            const auto x = static_cast<std::size_t>(std::countr_zero(bits));
            if (visit(tiles_[tiles[x >> 4]].points[line << 4 | (x & 15)])) return true;
        }
    }
    return false;
}

}  // namespace filigree
