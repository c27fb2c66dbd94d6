#include "plane/spread.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/random.h"
#include "plane/edge_tree.h"
#include "plane/geodesic_cells.h"
#include "plane/inner_point.h"
#include "plane/scatter.h"
#include "plane/scatter_cells.h"
#include "plane/settle.h"

namespace filigree {

namespace {

// Darts keep this part of the spacing apart. Once they are relaxed, nearest neighbours are then some 1.1 spacings
// apart, and few pairs have to be pushed.
constexpr double dart_spacing = 0.9;
constexpr double cells_to_spacing = 4.7;
constexpr double evenness = 1.25;  // of the spacing: nearer ones are pushed apart gently once they are relaxed
constexpr double coarsest = 3;     // cells to the spacing: with fewer there is nothing to relax
constexpr std::uint64_t most_cells = std::uint64_t{1} << 25;
constexpr std::size_t few = 16;  // points: so few are relaxed again if some had to be left out
constexpr int most_attempts = 6;
constexpr double least_density = 1.0 / 256;  // there are no points where it is less

// Narrow and small regions take a finer raster, by powers of two, so that a small edit seldom changes it.
double cell_size(PolygonView region, double spacing) {
    std::int64_t perimeter = 0;  // on the grid: the order of the edges does not matter
    for (std::size_t r = 0; r < region.ring_count(); ++r) {
        const RingView ring = region.ring(r);
        for (std::size_t i = 0, last = ring.size() - 1; i < ring.size(); last = i++) {
            const Vec along{static_cast<double>(ring[i].x - ring[last].x),
                            static_cast<double>(ring[i].y - ring[last].y)};
            perimeter += std::llround(length(along));
        }
    }
    const double all = area(region);
    const double width = 2 * all / std::max(static_cast<double>(perimeter) / grid_per_px, 0x1p-26);
    const double wanted = std::max({std::min(width / 4, std::sqrt(all) / 8), spacing / 1024, 0x1p-20});
    double cell = spacing / cells_to_spacing;
    while (cell > wanted) cell /= 2;
    return cell;
}

struct Darts {
    std::vector<Vec> at;
    std::vector<std::uint64_t> cells;
};

class Thrower {
public:
    // `grid`: px, the spacing that keys are laid out for, whatever the size of the region.
    Thrower(const RegionRaster& raster, const SpreadOptions& options, double grid, const std::vector<float>& densities)
        : raster_(raster),
          options_(options),
          densities_(densities),
          grid_(dart_spacing * grid * 0.7071),  // no square of this side holds two darts
          spacing_(dart_spacing * options.spacing) {}

    // Cells take their turns in so many classes, drawn for each by itself, and then by rows; one that is nearer to a
    // dart than it may be takes none.
    Darts run() {
        constexpr unsigned class_bits = 8;
        const std::uint64_t base = fold(options_.seed, hash_text("order"));
        std::vector<std::uint32_t> open;
        std::vector<std::uint8_t> classes;
        open.reserve(raster_.inside_count());
        classes.reserve(raster_.inside_count());
        std::array<std::uint32_t, (1U << class_bits) + 1> starts{};
        for (const RegionRaster::Run& run : raster_.runs()) {
            const std::uint64_t first = raster_.address(run.begin);
            for (std::uint32_t cell = run.begin; cell < run.end; ++cell) {
                if (raster_.border_distance(cell) < options_.least_clearance) continue;
                if (!densities_.empty() && densities_[cell] < least_density) continue;
                const std::uint64_t address =
                    (first & ~std::uint64_t{UINT32_MAX}) | static_cast<std::uint32_t>(first + (cell - run.begin));
                const auto own = static_cast<std::uint8_t>(mix(base ^ address) >> (64 - class_bits));
                open.push_back(cell);
                classes.push_back(own);
                ++starts[own + 1U];
            }
        }
        for (std::size_t c = 1; c < starts.size(); ++c) starts[c] += starts[c - 1];
        std::vector<std::uint32_t> turns(open.size());
        for (std::size_t i = 0; i < open.size(); ++i) turns[starts[classes[i]]++] = open[i];

        taken_.assign(raster_.size(), 0);
        Darts darts;
        for (const std::uint32_t cell : turns) {
            if (taken_[cell] != 0) continue;
            if (darts.at.size() == options_.limit) break;
            const Vec at = raster_.centre(cell);
            darts.at.push_back(at);
            darts.cells.push_back(ScatterCells::pack(static_cast<std::int64_t>(std::floor(at.x / grid_)),
                                                     static_cast<std::int64_t>(std::floor(at.y / grid_))));
            take(cell, densities_.empty() ? spacing_ : spacing_ / std::sqrt(densities_[cell]));
        }
        return darts;
    }

private:
    void take(std::uint32_t cell, double reach) {
        const double radius = reach / raster_.cell();
        const std::int64_t columns = raster_.columns(), rows = raster_.size() / raster_.columns();
        const std::int64_t column = raster_.column(cell), row = raster_.row(cell);
        const auto rings = static_cast<std::int64_t>(std::min(std::ceil(radius) - 1, static_cast<double>(rows)));
        for (std::int64_t y = -rings; y <= rings; ++y) {
            if (row + y < 0 || row + y >= rows) continue;
            const double half = std::sqrt(radius * radius - static_cast<double>(y * y));
            const auto reached = static_cast<std::int64_t>(std::min(std::ceil(half) - 1, static_cast<double>(columns)));
            const std::int64_t first = std::max<std::int64_t>(column - reached, 0);
            const std::int64_t last = std::min(column + reached, columns - 1);
            const auto begin = taken_.begin() + (row + y) * columns;
            std::fill(begin + first, begin + last + 1, std::uint8_t{1});
        }
    }

    const RegionRaster& raster_;
    const SpreadOptions& options_;
    const std::vector<float>& densities_;
    double grid_, spacing_;
    std::vector<std::uint8_t> taken_;
};

// Where the region is so small, or so large, that there is nothing to relax.
std::vector<SpreadPoint> only_scattered(PolygonView region, const SpreadOptions& options) {
    ScatterOptions scattered;
    scattered.spacing = std::max(options.apart, options.spacing * dart_spacing);
    scattered.clearance = options.clearance;
    scattered.seed = options.seed;
    scattered.limit = options.limit;
    std::vector<ScatteredPoint> found = scatter(region, scattered);
    if (found.empty() && options.least_clearance < options.clearance) {
        scattered.clearance = options.least_clearance;
        found = scatter(region, scattered);
    }
    std::vector<SpreadPoint> points;
    for (const ScatteredPoint& point : found) {
        const double density = options.density ? options.density(point.at) : 1;
        if (to_unit(random_bits(options.seed, Key{point.cell}, "density")) < density) {
            points.push_back({point.at, point.cell});
        }
    }
    return points;
}

// Leaves the others out; whether there were any.
bool keep_only(Darts& darts, const std::vector<std::uint8_t>& stays) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < stays.size(); ++i) {
        if (!stays[i]) continue;
        darts.at[kept] = darts.at[i];
        darts.cells[kept] = darts.cells[i];
        ++kept;
    }
    darts.at.resize(kept);
    darts.cells.resize(kept);
    return kept < stays.size();
}

// One point alone goes to the middle.
Vec middle(PolygonView region, const EdgeTree& border, double clearance) {
    const Vec centre = centroid(region);
    const double reach = std::max(clearance, 0x1p-10);
    const EdgeTree::Place place = border.place(centre, reach, reach);
    return place.is_inside && place.distance >= reach ? centre : inner_point(region);
}

}  // namespace

std::vector<SpreadPoint> spread(PolygonView region, const SpreadOptions& options) {
    if (!(options.spacing > 0) || options.limit == 0 || region.ring_count() == 0 || region.outer().size() < 3) {
        return {};
    }
    const Box box = bounds(region);
    SpreadOptions own = options;
    own.spacing = std::clamp(options.spacing, 0x1p-20, std::max(2 * length(to_px(box.max) - to_px(box.min)), 0x1p-19));
    const double cell = cell_size(region, own.spacing);
    std::optional<RegionRaster> raster = RegionRaster::of(region, cell, most_cells);
    if (!raster) raster = RegionRaster::of(region, own.spacing / coarsest, most_cells);
    if (!raster || options.rounds == 0) return only_scattered(region, own);

    std::vector<float> densities;
    std::vector<std::uint16_t> weights;
    if (own.density) {
        densities.resize(raster->size(), 0);
        weights.resize(raster->size(), 0);
        for (const RegionRaster::Run& run : raster->runs()) {
            for (std::uint32_t i = run.begin; i < run.end; ++i) {
                const double density = std::clamp(own.density(raster->centre(i)), 0.0, 1.0);
                densities[i] = static_cast<float>(density);
                // Centroidal cells are as dense as the root of their weights.
                weights[i] = static_cast<std::uint16_t>(density * density * UINT16_MAX);
            }
        }
    }
    Darts darts = Thrower(*raster, own, std::clamp(options.spacing, 0x1p-20, 0x1p40), densities).run();
    const EdgeTree border(edges_of(region, Point{0, 0}));
    const SettleOptions settled{own.apart, own.clearance, own.density ? 0 : own.spacing * evenness};
    GeodesicCells cells(*raster, weights);
    for (int attempt = 0;; ++attempt) {
        if (darts.at.size() == 1 && !own.density) {
            darts.at[0] = middle(region, border, own.clearance);
            break;
        }
        cells.relax(darts.at, {own.rounds, 0.02 * own.spacing});
        const std::vector<std::uint8_t> stays = settle(darts.at, *raster, border, settled);
        // Where few are left, they share the room of those that had to go.
        const bool is_small = darts.at.size() <= few;
        if (!keep_only(darts, stays) || !is_small || attempt == most_attempts) break;
    }

    std::vector<SpreadPoint> points;
    points.reserve(darts.at.size());
    for (std::size_t i = 0; i < darts.at.size(); ++i) points.push_back({darts.at[i], darts.cells[i]});
    std::sort(points.begin(), points.end(), [](const SpreadPoint& a, const SpreadPoint& b) { return a.cell < b.cell; });
    return points;
}

}  // namespace filigree
