// stipple: cover shapes with dots at blue-noise distances (gTangle, section 4; Secord 2002).
//
// A first version: a maximal Poisson distribution without relaxation. The dots are marks on top of the
// shapes, which stay whole: the partition does not change.
#include <algorithm>

#include "base/elementary.h"
#include "engines/tangle/operators/operators.h"
#include "plane/scatter.h"

namespace filigree::tangle {
namespace {

enum Port { ground_port, dots_port };

Result<OperatorOutput> run(const OperatorInput& input) {
    const Arguments& arguments = input.arguments;
    return for_each_shape(input, [&](std::size_t index, const Shape& shape, PolygonView polygon, Batch& batch) {
        batch.ports[ground_port].push_back(shape);
        const double spacing = arguments.number("spacing", index);
        const double radius = std::min(arguments.number("size", index), spacing) / 2;
        ScatterOptions options;
        options.spacing = spacing;
        options.clearance = radius + arguments.number("margin", index);
        options.seed = random_bits(input.scatter, Key{fold(input.step.value, shape.key.value)}, "scatter");
        options.limit = input.element_budget + 1 - std::min(input.element_budget, batch.added);
        for (const ScatteredPoint& centre : scatter(polygon, options)) {
            const double own = radius * (0.8 + 0.2 * to_unit(random_bits(options.seed, Key{centre.cell}, "size")));
            constexpr int corners = 8;
            for (int i = 0; i < corners; ++i) {
                const elementary::CosSin turn = elementary::cos_sin_degrees(360.0 * i / corners);
                batch.geometry.points.push_back(snap(centre.at + own * Vec{turn.cos, turn.sin}));
            }
            batch.geometry.end_ring();
            batch.geometry.end_polygon();
            Shape dot = piece_of(shape, input.step, fold(dots_port, centre.cell), batch.geometry.size() - 1);
            dot.is_mark = true;
            dot.inked = !shape.inked;  // a dot is all ink on paper, all paper on ink
            batch.ports[dots_port].push_back(dot);
        }
    });
}

}  // namespace

Operator stipple_operator() {
    return {
        {.name = "stipple",
         .aliases = {"stipling", "stippling"},
         .help = "cover shapes with dots; the shapes themselves stay whole below them",
         .source = "gTangle, section 4",
         .parameters = {{.name = "spacing",
                         .type = ParameterType::length,
                         .help = "least distance from dot to dot",
                         .default_text = "5px",
                         .low = 0.1,
                         .high = 1e6},
                        {.name = "size",
                         .type = ParameterType::length,
                         .help = "diameter of the largest dots",
                         .default_text = "1.8px",
                         .low = 0.05,
                         .high = 1e6},
                        {.name = "margin",
                         .type = ParameterType::length,
                         .help = "how far the dots keep from the border",
                         .default_text = "1px",
                         .low = 0.001,
                         .high = 1e6}},
         .ports = {{"ground", "the shapes below the dots"}, {"dots", "the dots, marks that are no part of the area"}},
         .example = "stipple(4, size: 1.5) : petals -> dotted",
         .shrinks = false},
        run,
        true};
}

}  // namespace filigree::tangle
