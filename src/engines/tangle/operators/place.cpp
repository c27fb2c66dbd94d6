// place: spread shapes over a region, none overlapping, and what remains around them (gTangle, section 4.2).
//
// A first version of the paper's operator: a maximal Poisson distribution, without the relaxation that
// follows there. Objects keep inside the region's border.
#include <algorithm>

#include "base/elementary.h"
#include "engines/tangle/operators/operators.h"
#include "plane/inset.h"
#include "plane/scatter.h"

namespace filigree::tangle {
namespace {

enum Port { placed_port, remainder_port };

constexpr double least_gap = 0x1p-10;  // px: neighbours never touch, so the remainder keeps clean rings

// A closed outline of the given radius at a point. A blob waves inside the disc of that radius.
std::vector<Point> outline_of(std::string_view kind, Vec at, double radius, double resolution, std::uint64_t bits) {
    // A chord of a circle lies r (1 - cos(half its angle)) inside: about pi^2 r / (2 n^2) for n corners.
    const double flatness = std::min(resolution, radius / 8);
    const double wanted = std::ceil(elementary::pi * std::sqrt(radius / (2 * flatness)) / 4) * 4;
    const double count = std::clamp(wanted, 12.0, 256.0);
    std::vector<Point> ring;
    const double first_phase = 360 * to_unit(mix(bits ^ 1)), second_phase = 360 * to_unit(mix(bits ^ 2));
    for (double i = 0; i < count; ++i) {
        const double angle = 360 * i / count;
        double reach = radius;
        if (kind == "blob") {
            reach *= 0.9 + 0.065 * elementary::cos_sin_degrees(2 * angle + first_phase).cos +
                     0.035 * elementary::cos_sin_degrees(3 * angle + second_phase).cos;
        }
        const elementary::CosSin turn = elementary::cos_sin_degrees(angle);
        const Point corner = snap(at + Vec{reach * turn.cos, reach * turn.sin});
        if (ring.empty() || !(ring.back() == corner)) ring.push_back(corner);
    }
    return ring;
}

Result<OperatorOutput> run(const OperatorInput& input) {
    const Arguments& arguments = input.arguments;
    return for_each_shape(input, [&](std::size_t index, const Shape& shape, PolygonView polygon, Batch& batch) {
        const double spacing = arguments.number("spacing", index);
        const double largest = std::min(arguments.number("size", index), spacing) / 2 - least_gap;
        const double variation = arguments.number("variation", index);
        const std::uint64_t choice =
            random_bits(input.scatter, Key{fold(input.step.value, shape.key.value)}, "scatter");

        ScatterOptions options;
        options.spacing = spacing;
        options.clearance = largest + least_gap;
        options.seed = choice;
        options.limit = input.element_budget + 1 - std::min(input.element_budget, batch.added);
        const std::vector<ScatteredPoint> centres = scatter(polygon, options);

        // What is placed, and what remains, stands in no lattice.
        const auto add = [&](Port port, std::uint64_t local) {
            Shape piece = piece_of(shape, input.step, local, batch.geometry.size());
            piece.column = piece.row = 0;
            batch.ports[port].push_back(piece);
        };
        Polygons placed;
        for (const ScatteredPoint& centre : centres) {
            const std::uint64_t bits = random_bits(choice, Key{centre.cell}, "object");
            const double radius = largest * (1 - variation * to_unit(bits));
            const std::vector<Point> ring =
                outline_of(arguments.word("shape", index), centre.at, radius, input.resolution, bits);
            if (ring.size() < 3) continue;
            placed.add_ring(ring);
            placed.end_polygon();
            add(placed_port, fold(placed_port, centre.cell));
            batch.geometry.add(placed[placed.size() - 1]);
        }
        const Polygons remainder = without(polygon, placed);
        for (std::size_t i = 0; i < remainder.size(); ++i) {
            add(remainder_port, fold(remainder_port, i));
            batch.geometry.add(remainder[i]);
        }
    });
}

}  // namespace

Operator place_operator() {
    return {{.name = "place",
             .help = "spread shapes over a region, none overlapping; the region around them remains",
             .source = "gTangle, section 4.2",
             .parameters = {{.name = "shape",
                             .type = ParameterType::word,
                             .help = "what is placed: discs, or blobs that waver a little",
                             .default_text = "disc",
                             .words = {"disc", "blob"}},
                            {.name = "size",
                             .type = ParameterType::length,
                             .help = "diameter of the placed shapes",
                             .low = 0.1,
                             .high = 1e6},
                            {.name = "spacing",
                             .type = ParameterType::length,
                             .help = "least distance from centre to centre; shapes larger than that shrink to it",
                             .low = 0.1,
                             .high = 1e6,
                             .aliases = {"distance"}},
                            {.name = "variation",
                             .type = ParameterType::real,
                             .help = "how much smaller a shape may come out, as a part of its size",
                             .default_text = "0",
                             .low = 0,
                             .high = 0.9}},
             .ports = {{"placed", "the placed shapes"}, {"remainder", "the region without them"}},
             .example = "place(blob, size: 20, spacing: 25) : rim -> blobs, rest"},
            run,
            true};
}

}  // namespace filigree::tangle
