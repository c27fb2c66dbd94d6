// voronoi: part shapes into the cells of points spread over them, like cracked mud or a honeycomb.
#include <algorithm>
#include <atomic>
#include <cmath>

#include "engines/tangle/operators/operators.h"
#include "plane/mosaic.h"
#include "plane/scatter_cells.h"
#include "plane/spread.h"

namespace filigree::tangle {
namespace {

constexpr double least_apart = 0.6;  // of the spacing

struct Sites {
    std::vector<Vec> at;
    std::vector<std::uint64_t> cells;
    std::vector<std::int32_t> columns, rows;  // of a lattice
    bool too_many = false;
};

Sites spread_sites(PolygonView polygon, double spacing, unsigned rounds, std::uint64_t seed, std::uint64_t limit) {
    SpreadOptions options;
    options.spacing = spacing;
    options.apart = least_apart * spacing;
    options.rounds = rounds;
    options.seed = seed;
    options.limit = limit;
    Sites sites;
    for (const SpreadPoint& point : spread(polygon, options)) {
        sites.at.push_back(point.at);
        sites.cells.push_back(point.cell);
    }
    return sites;
}

// Of equilateral triangles about the origin of the page, so that the honeycomb runs on through neighbours.
Sites lattice_sites(PolygonView polygon, double spacing, std::uint64_t limit) {
    const double row_height = spacing * 0.8660254037844386;
    const Box box = bounds(polygon);
    const Vec low = to_px(box.min), high = to_px(box.max);
    const double first_row = std::floor(low.y / row_height) - 1, last_row = std::ceil(high.y / row_height) + 1;
    const double columns = (high.x - low.x) / spacing + 4;
    Sites sites;
    sites.too_many =
        !((last_row - first_row) * columns < static_cast<double>(std::min<std::uint64_t>(limit, 1U << 24)) * 4 + 64);
    if (sites.too_many) return sites;
    for (double row = first_row; row <= last_row; ++row) {
        const double shift = std::fmod(row, 2) == 0 ? 0 : 0.5;
        const double last = std::ceil(high.x / spacing) + 1;
        for (double column = std::floor(low.x / spacing) - 1; column <= last; ++column) {
            sites.at.push_back({(column + shift) * spacing, row * row_height});
            sites.columns.push_back(static_cast<std::int32_t>(column));
            sites.rows.push_back(static_cast<std::int32_t>(row));
            sites.cells.push_back(
                ScatterCells::pack(static_cast<std::int64_t>(column), static_cast<std::int64_t>(row)));
        }
    }
    return sites;
}

Result<OperatorOutput> run(const OperatorInput& input) {
    const Arguments& arguments = input.arguments;
    if (is_too_dense(input, "spacing")) return too_many_shapes(input);
    std::atomic<bool> too_many = false;
    Result<OperatorOutput> output =
        for_each_shape(input, [&](std::size_t index, const Shape& shape, PolygonView polygon, Batch& batch) {
            const double spacing = arguments.number("spacing", index);
            const std::string_view kind = arguments.word("sites", index);
            const auto rounds = static_cast<unsigned>(arguments.number("relax", index));
            const std::uint64_t limit = input.element_budget + 1 - std::min(input.element_budget, batch.added);
            const std::uint64_t seed =
                random_bits(input.scatter, Key{fold(input.step.value, shape.key.value)}, "scatter");
            const Sites sites = kind == "lattice"
                                    ? lattice_sites(polygon, spacing, limit)
                                    : spread_sites(polygon, spacing, kind == "random" ? 0 : rounds, seed, limit);
            if (sites.too_many) too_many = true;
            if (too_many) return;
            const Mosaic cells = mosaic(polygon, sites.at);
            std::vector<std::uint32_t> pieces_of(std::max<std::size_t>(sites.at.size(), 1), 0);
            for (std::size_t i = 0; i < cells.pieces.size(); ++i) {
                const std::uint32_t site = cells.sites[i];
                const std::uint64_t local = fold(sites.at.empty() ? 0 : sites.cells[site], pieces_of[site]++);
                Shape piece = piece_of(shape, input.step, local, batch.geometry.size());
                piece.column = sites.columns.empty() ? 0 : sites.columns[site];
                piece.row = sites.rows.empty() ? 0 : sites.rows[site];
                batch.geometry.add(cells.pieces[i]);
                batch.ports[0].push_back(piece);
            }
        });
    if (too_many) return too_many_shapes(input);
    return output;
}

bool has_random_sites(const Arguments& arguments) { return arguments.word("sites") != "lattice"; }

}  // namespace

Operator voronoi_operator() {
    return {{.name = "voronoi",
             .help = "part into cells around points: every place goes to the nearest",
             .source = "Du, Faber and Gunzburger 1999",
             .parameters = {{.name = "spacing",
                             .type = ParameterType::length,
                             .help = "usual distance of the points, and so the width of the cells",
                             .low = 0.1,
                             .high = 1e6,
                             .aliases = {"distance"}},
                            {.name = "sites",
                             .type = ParameterType::word,
                             .help = "how the points lie: evened out, as they were thrown, or as a honeycomb",
                             .default_text = "relaxed",
                             .words = {"relaxed", "random", "lattice"}},
                            {.name = "relax",
                             .type = ParameterType::whole,
                             .help = "how often points that are evened out move to the middle of their cells",
                             .default_text = "3",
                             .low = 1,
                             .high = 100}},
             .ports = {{"cells", "the cells"}},
             .example = "voronoi(18) : rim -> stones"},
            run,
            true,
            has_random_sites};
}

}  // namespace filigree::tangle
