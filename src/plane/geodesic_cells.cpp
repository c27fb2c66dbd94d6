#include "plane/geodesic_cells.h"

#include <algorithm>
#include <cmath>

namespace filigree {

namespace {

// Sites first move farther than to the centroid, as they would in the next rounds anyway.
constexpr double first_eagerness = 1.6;

}  // namespace

GeodesicCells::GeodesicCells(const RegionRaster& raster, std::span<const std::uint16_t> weights)
    : raster_(raster), weights_(weights), owners_(raster.size(), none), distances_(raster.size(), 0) {
    const std::uint32_t row = raster.columns();
    around_ = {0U - 1, 1, 0U - row, row, 0U - row - 1, 0U - row + 1, row - 1, row + 1};
}

void GeodesicCells::assign(std::span<const Vec> sites) {
    for (const RegionRaster::Run& run : raster_.runs()) {
        std::fill(distances_.begin() + run.begin, distances_.begin() + run.end, std::uint16_t{UINT16_MAX});
        std::fill(owners_.begin() + run.begin, owners_.begin() + run.end, none);
    }
    for (std::uint32_t site = 0; site < sites.size(); ++site) {
        const std::uint32_t home = raster_.index_of(sites[site]);
        if (!raster_.is_inside(home)) continue;
        // The cells next to a site by their true distances, so that its place within its own counts.
        const double columns_to = sites[site].x / raster_.cell(), rows_to = sites[site].y / raster_.cell();
        const double x = columns_to - std::floor(columns_to) - 0.5, y = rows_to - std::floor(rows_to) - 0.5;
        const auto start = [&](std::uint32_t cell, double column, double row) {
            const double far = std::sqrt((column - x) * (column - x) + (row - y) * (row - y));
            const auto distance = static_cast<std::uint16_t>(far * RegionRaster::step + 1);
            if (distance >= distances_[cell]) return;
            distances_[cell] = distance;
            owners_[cell] = site;
            Cells& waiting = waiting_[distance % 32];
            *waiting.end_with_room_for(1) = cell;
            ++waiting.count;
        };
        start(home, 0, 0);
        constexpr std::array<int, 8> columns{-1, 1, 0, 0, -1, 1, -1, 1}, rows{0, 0, -1, 1, -1, -1, 1, 1};
        for (std::size_t k = 0; k < 8; ++k) start(home + around_[k], columns[k], rows[k]);
    }
    spread();
}

void GeodesicCells::spread() {
    constexpr std::uint32_t farthest = UINT16_MAX - 64;
    std::uint16_t* const distances = distances_.data();
    std::uint32_t* const owners = owners_.data();
    const std::array<std::uint32_t, 8> around = around_;
    std::uint32_t idle = 0;
    for (std::uint32_t distance = 0; idle < 32 && distance < farthest; ++distance) {
        Cells& now = waiting_[distance % 32];
        idle = now.count == 0 ? idle + 1 : 0;
        if (now.count == 0) continue;
        // Room for whatever may come, so that nothing is asked where something is put.
        Cells& straight = waiting_[(distance + RegionRaster::step) % 32];
        Cells& across = waiting_[(distance + RegionRaster::corner_step) % 32];
        std::uint32_t* straight_end = straight.end_with_room_for(4 * now.count);
        std::uint32_t* across_end = across.end_with_room_for(4 * now.count);
        const auto straight_way = static_cast<std::uint16_t>(distance + RegionRaster::step);
        const auto across_way = static_cast<std::uint16_t>(distance + RegionRaster::corner_step);
        for (const std::uint32_t cell : std::span(now.room).first(now.count)) {
            if (distances[cell] != distance) continue;
            const std::uint32_t site = owners[cell];
            for (std::size_t k = 0; k < 4; ++k) {
                const std::uint32_t next = cell + around[k];
                if (distances[next] <= straight_way) continue;
                distances[next] = straight_way;
                owners[next] = site;
                *straight_end++ = next;
            }
            for (std::size_t k = 4; k < 8; ++k) {
                const std::uint32_t next = cell + around[k];
                if (distances[next] <= across_way) continue;
                distances[next] = across_way;
                owners[next] = site;
                *across_end++ = next;
            }
        }
        straight.end_at(straight_end);
        across.end_at(across_end);
        now.count = 0;
    }
    for (Cells& left : waiting_) left.count = 0;
}

void GeodesicCells::sum_up(std::size_t count) {
    sums_.assign(count, {});
    for (const RegionRaster::Run& run : raster_.runs()) {
        const std::int64_t row = raster_.row(run.begin);
        std::int64_t column = raster_.column(run.begin);
        for (std::uint32_t cell = run.begin; cell < run.end; ++cell, ++column) {
            if (owners_[cell] == none) continue;
            Sum& sum = sums_[owners_[cell]];
            const std::int64_t weight = weights_.empty() ? 1 : weights_[cell];
            sum.weight += weight;
            sum.x += weight * column;
            sum.y += weight * row;
        }
    }
}

void GeodesicCells::relax(std::span<Vec> sites, const RelaxOptions& options) {
    for (unsigned round = 0; round < options.rounds; ++round) {
        assign(sites);
        sum_up(sites.size());
        const double eagerness = round + 1 < options.rounds ? first_eagerness : 1;
        bool any_moved = false;
        for (std::uint32_t site = 0; site < sites.size(); ++site) {
            if (sums_[site].weight == 0) continue;
            const Vec to = moved(site, sites[site], eagerness);
            if (length(to - sites[site]) <= options.least_move) continue;
            sites[site] = to;
            any_moved = true;
        }
        if (!any_moved) return;
    }
}

Vec GeodesicCells::moved(std::uint32_t site, Vec from, double eagerness) {
    const Sum& sum = sums_[site];
    // In whole 256ths of a cell, so that it does not matter where columns and rows are counted from.
    const auto mean = [&](std::int64_t of) {
        const Int128 parts = (static_cast<Int128>(of) * 512 + sum.weight) / (static_cast<Int128>(sum.weight) * 2);
        return static_cast<double>(static_cast<std::int64_t>(parts)) / 256 + 0.5;
    };
    const Vec centre = raster_.at(mean(sum.x), mean(sum.y));
    const auto is_own = [&](Vec p) {
        const std::uint32_t cell = raster_.index_of(p);
        return raster_.is_inside(cell) && owners_[cell] == site;
    };
    const Vec beyond = from + (centre - from) * eagerness;
    if (is_own(beyond)) return beyond;
    return is_own(centre) ? centre : middle_of_cells(site, from);
}

// The cell farthest from `start` on a way through cells of one site; `way` gets all that were visited, by distance.
std::uint32_t GeodesicCells::farthest_from(std::uint32_t start, std::uint32_t site, std::vector<std::uint32_t>& way) {
    way.assign(1, start);
    steps_[start] = 1;
    for (std::size_t i = 0; i < way.size(); ++i) {
        for (const std::uint32_t offset : around_) {
            const std::uint32_t next = way[i] + offset;
            if (!raster_.is_inside(next) || owners_[next] != site || steps_[next] != 0) continue;
            steps_[next] = steps_[way[i]] + 1;
            way.push_back(next);
        }
    }
    return way.back();
}

// Of a bent cell: half way between its two ends, and well between its sides.
Vec GeodesicCells::middle_of_cells(std::uint32_t site, Vec from) {
    const std::uint32_t home = raster_.index_of(from);
    if (!raster_.is_inside(home) || owners_[home] != site) return from;
    steps_.resize(raster_.size(), 0);
    std::vector<std::uint32_t> way, way_back;
    const auto forget = [&](const std::vector<std::uint32_t>& cells) {
        for (const std::uint32_t cell : cells) steps_[cell] = 0;
    };
    const std::uint32_t one_end = farthest_from(home, site, way);
    forget(way);
    const std::uint32_t other_end = farthest_from(one_end, site, way);
    std::vector<std::uint32_t> to_one(way.size());
    for (std::size_t i = 0; i < way.size(); ++i) to_one[i] = steps_[way[i]];
    forget(way);
    farthest_from(other_end, site, way_back);
    std::uint32_t best = home;
    std::int64_t least = INT64_MAX;
    for (std::size_t i = 0; i < way.size(); ++i) {
        const std::int64_t farther = std::max(to_one[i], steps_[way[i]]);
        const std::int64_t cost = farther * RegionRaster::step - raster_.border(way[i]);
        if (cost < least || (cost == least && way[i] < best)) {
            least = cost;
            best = way[i];
        }
    }
    forget(way_back);
    return raster_.centre(best);
}

}  // namespace filigree
