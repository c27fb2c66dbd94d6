// Centroidal relaxation of sites inside a region with bays and holes (gTangle, section 4.2: geodesic centroidal
// Voronoi diagrams; Lloyd's algorithm on a raster).
//
// Every inside cell of a raster goes to the site that is nearest on a way inside the region, found by one spread
// from all sites at once; then each site moves towards the centroid of its cells, and so on. A centroid outside its
// own cells (in a bend, around a hole) is replaced by the middle of the longest way through them. What a site does
// depends on the sites next to it alone, and small moves are not made, so that changes far away fade out. Sums are
// whole numbers: the same bits everywhere. Cost: about 20 ns a cell and round.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "plane/region_raster.h"

namespace filigree {

struct RelaxOptions {
    unsigned rounds = 8;    // at most; it ends where no site moves any more
    double least_move = 0;  // px: shorter moves are not made
};

class GeodesicCells {
public:
    static constexpr std::uint32_t none = UINT32_MAX;

    // `weights` of the raster's cells draw sites towards them; none: all the same. Both must outlive this.
    explicit GeodesicCells(const RegionRaster& raster, std::span<const std::uint16_t> weights = {});

    // Gives every cell to the nearest site. Sites outside the region have no cells.
    void assign(std::span<const Vec> sites);
    // Of each cell of the raster: its site, or none. Outside the region it says nothing.
    const std::vector<std::uint32_t>& owners() const { return owners_; }

    // Moves the sites, which must lie inside the region.
    void relax(std::span<Vec> sites, const RelaxOptions& options);

private:
    struct Sum {
        std::int64_t weight = 0, x = 0, y = 0;
    };
    // A list that keeps its room: what is once made is never filled with zeros again.
    struct Cells {
        std::vector<std::uint32_t> room;
        std::size_t count = 0;

        // Where up to `more` can be put behind them.
        std::uint32_t* end_with_room_for(std::size_t more) {
            if (room.size() < count + more) room.resize(2 * (count + more));
            return room.data() + count;
        }
        void end_at(const std::uint32_t* end) { count = static_cast<std::size_t>(end - room.data()); }
    };
    void spread();
    void sum_up(std::size_t count);
    Vec moved(std::uint32_t site, Vec from, double eagerness);
    Vec middle_of_cells(std::uint32_t site, Vec from);
    std::uint32_t farthest_from(std::uint32_t start, std::uint32_t site, std::vector<std::uint32_t>& way);

    const RegionRaster& raster_;
    std::span<const std::uint16_t> weights_;
    std::array<std::uint32_t, 8> around_;  // neighbours' indices less one's own, modulo 2^32
    std::vector<std::uint32_t> owners_;
    std::vector<std::uint16_t> distances_;  // 0 outside, so that nothing ever spreads there
    std::array<Cells, 32> waiting_;         // by their distance modulo 32
    std::vector<Sum> sums_;
    std::vector<std::uint32_t> steps_;  // of farthest_from, one a cell, 0 while it has not come there
};

}  // namespace filigree
