#include "plane/region_raster.h"

#include <algorithm>
#include <cmath>

namespace filigree {

std::optional<RegionRaster> RegionRaster::of(PolygonView region, double cell, std::uint64_t most) {
    if (region.ring_count() == 0 || region.outer().size() < 3 || !(cell > 0)) return std::nullopt;
    const Box box = bounds(region);
    const Vec low = to_px(box.min), high = to_px(box.max);
    RegionRaster raster;
    raster.cell_ = cell;
    raster.left_ = std::floor(low.x / cell) - 1;
    raster.top_ = std::floor(low.y / cell) - 1;
    const double columns = std::floor(high.x / cell) + 2 - raster.left_;
    const double rows = std::floor(high.y / cell) + 2 - raster.top_;
    if (!(columns * rows <= static_cast<double>(std::min<std::uint64_t>(most, UINT32_MAX / 2)))) return std::nullopt;
    raster.columns_ = static_cast<std::uint32_t>(columns);
    raster.rows_ = static_cast<std::uint32_t>(rows);
    raster.border_.assign(static_cast<std::size_t>(raster.columns_) * raster.rows_, 0);
    raster.fill(region);
    raster.measure();
    return raster;
}

// Between every two crossings of a row's middle with the border, cells are in and out by turns.
void RegionRaster::fill(PolygonView region) {
    struct Rise {  // an edge taken downwards, whichever way it runs, so that its crossings come out alike
        Vec low, high;
        std::uint32_t first = 0, end = 0;  // rows whose middle it crosses
    };
    std::vector<Rise> rises;
    rises.reserve(region.point_count());
    std::vector<std::uint32_t> ends(rows_ + 1, 0);  // of each row's crossings
    for (std::size_t r = 0; r < region.ring_count(); ++r) {
        const RingView ring = region.ring(r);
        for (std::size_t i = 0, last = ring.size() - 1; i < ring.size(); last = i++) {
            Rise rise{to_px(ring[last]), to_px(ring[i]), 0, 0};
            if (rise.low.y > rise.high.y) std::swap(rise.low, rise.high);
            rise.first = static_cast<std::uint32_t>(std::ceil(row_of(rise.low.y) - 0.5));
            rise.end = static_cast<std::uint32_t>(std::ceil(row_of(rise.high.y) - 0.5));
            if (rise.first == rise.end) continue;
            for (std::uint32_t row = rise.first; row < rise.end; ++row) ++ends[row];
            rises.push_back(rise);
        }
    }
    std::uint32_t count = 0;
    for (std::uint32_t& end : ends) {
        const std::uint32_t own = end;
        end = count;
        count += own;
    }
    std::vector<double> crossings(count);
    for (const Rise& rise : rises) {
        const double slope = (rise.high.x - rise.low.x) / (rise.high.y - rise.low.y);
        for (std::uint32_t row = rise.first; row < rise.end; ++row) {
            const double x = rise.low.x + (at(0, row + 0.5).y - rise.low.y) * slope;
            crossings[ends[row]++] = column_of(x);
        }
    }
    std::uint32_t begin = 0;
    for (std::uint32_t row = 0; row < rows_; ++row) {
        const std::uint32_t end = ends[row];
        std::sort(crossings.begin() + begin, crossings.begin() + end);
        for (std::uint32_t i = begin; i + 1 < end; i += 2) {
            const double first = std::clamp(std::ceil(crossings[i] - 0.5), 1.0, columns_ - 1.0);
            const double past = std::clamp(std::ceil(crossings[i + 1] - 0.5), 1.0, columns_ - 1.0);
            if (!(first < past)) continue;
            const Run run{row * columns_ + static_cast<std::uint32_t>(first),
                          row * columns_ + static_cast<std::uint32_t>(past)};
            inside_count_ += run.end - run.begin;
            // Where holes are thinner than a cell, what lies on both sides of them is one run.
            if (!runs_.empty() && runs_.back().end == run.begin) {
                runs_.back().end = run.end;
            } else {
                runs_.push_back(run);
            }
            std::fill(border_.begin() + run.begin, border_.begin() + run.end, UINT16_MAX);
        }
        begin = end;
    }
}

// Once downwards and once upwards, each cell from its neighbours behind.
void RegionRaster::measure() {
    constexpr std::uint32_t most = UINT16_MAX;
    const auto nearer = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        const std::uint32_t straight = std::min<std::uint32_t>(border_[a], border_[b]) + step;
        const std::uint32_t across = std::min<std::uint32_t>(border_[c], border_[d]) + corner_step;
        return static_cast<std::uint16_t>(std::min({straight, across, most}));
    };
    for (const Run& run : runs_) {
        for (std::uint32_t i = run.begin; i < run.end; ++i) {
            const std::uint32_t above = i - columns_;
            border_[i] = nearer(i - 1, above, above - 1, above + 1);
        }
    }
    for (auto run = runs_.rbegin(); run != runs_.rend(); ++run) {
        for (std::uint32_t i = run->end; i-- > run->begin;) {
            const std::uint32_t below = i + columns_;
            border_[i] = std::min(border_[i], nearer(i + 1, below, below - 1, below + 1));
        }
    }
}

std::uint32_t RegionRaster::index_of(Vec p) const {
    const double x = std::floor(p.x / cell_) - left_, y = std::floor(p.y / cell_) - top_;
    if (!(x >= 0 && x < columns_ && y >= 0 && y < rows_)) return 0;  // a corner of the rim
    return static_cast<std::uint32_t>(y) * columns_ + static_cast<std::uint32_t>(x);
}

std::uint64_t RegionRaster::address(std::uint32_t index) const {
    const auto low = [](double v) { return static_cast<std::uint32_t>(static_cast<std::int64_t>(v)); };
    return static_cast<std::uint64_t>(low(top_ + row(index))) << 32 | low(left_ + column(index));
}

}  // namespace filigree
