// stipple: cover shapes with marks, evenly or by a density (gTangle, section 4; Secord 2002, "Weighted Voronoi
// Stippling").
//
// The marks lie on top of the shapes, which stay whole: the partition does not change.
#include <algorithm>

#include "base/elementary.h"
#include "derivation/start_shapes.h"
#include "engines/tangle/density.h"
#include "engines/tangle/motifs.h"
#include "engines/tangle/operators/operators.h"
#include "plane/fit.h"
#include "plane/spread.h"

namespace filigree::tangle {
namespace {

enum Port { ground_port, dots_port };

constexpr double least_gap = 0x1p-10;  // px: between marks
constexpr unsigned relaxation_rounds = 4;
constexpr double least_part = 0.5;    // of its size: marks that would have to be smaller at the border are left out
constexpr double least_growth = 0.3;  // of its size: a mark where it is lightest, if marks grow

Motif motif_of_word(std::string_view mark, double radius, double stroke, double resolution) {
    const int corners = radius < 1 ? 8 : circle_corners(radius, resolution);
    const double width = stroke / (2 * radius);
    if (mark == "dash") return dash_motif(width, 8);
    if (mark == "curve") return curve_motif(width, 8);
    if (mark == "circle") return ring_motif(width, std::max(corners, 12));
    return disc_motif(corners);
}

Result<OperatorOutput> run(const OperatorInput& input) {
    const Arguments& arguments = input.arguments;
    if (is_too_dense(input, "spacing")) return too_many_shapes(input);
    Result<DrawnMotifs> drawn = DrawnMotifs::of(input, "mark", "size");
    if (!drawn) return drawn.diagnostics();
    const Result<Densities> densities = Densities::of(input, "density", "over");
    if (!densities) return densities.diagnostics();
    return for_each_shape(input, [&](std::size_t index, const Shape& shape, PolygonView polygon, Batch& batch) {
        batch.ports[ground_port].push_back(shape);
        const double spacing = arguments.number("spacing", index), margin = arguments.number("margin", index);
        const double radius = arguments.number("size", index) / 2, variation = arguments.number("variation", index);
        const bool grows = arguments.flag("grow", index);
        const double own = std::min(radius, spacing / 2);
        SpreadOptions options;
        options.spacing = spacing;
        options.density = densities->at(index, polygon, spacing);
        options.apart = options.density ? std::min(2 * radius + least_gap, spacing) : spacing;
        options.clearance = own + margin;
        options.least_clearance = least_part * own + margin;
        options.rounds = relaxation_rounds;
        options.seed = random_bits(input.scatter, Key{fold(input.step.value, shape.key.value)}, "scatter");
        options.limit = input.element_budget + 1 - std::min(input.element_budget, batch.added);
        const std::vector<SpreadPoint> places = spread(polygon, options);
        const EdgeTree border(edges_of(polygon, Point{0, 0}));

        std::vector<Pose> poses;
        poses.reserve(places.size());
        for (const SpreadPoint& place : places) {
            const std::uint64_t bits = random_bits(options.seed, Key{place.cell}, "size");
            double part = 1 - variation * to_unit(bits);
            if (grows && options.density) part *= std::max(std::sqrt(options.density(place.at)), least_growth);
            const Vec direction =
                copy_direction(arguments.value("rotation", index), shape, polygon, border, place.at, bits);
            poses.push_back({place.at, direction, radius * part});
        }
        const Motif motif = drawn->at(index) != nullptr
                                ? *drawn->at(index)
                                : motif_of_word(arguments.word("mark", index), radius,
                                                arguments.number("stroke", index), input.resolution);
        FitOptions fitting;
        fitting.gap = least_gap;
        fitting.border_gap = std::max(margin, least_gap);
        fitting.border_least = least_part;
        fit(poses, motif, border, fitting);

        for (std::size_t i = 0; i < poses.size(); ++i) {
            if (!(poses[i].radius > 0)) continue;
            const std::size_t first = batch.geometry.size();
            append(batch.geometry, motif, poses[i]);
            for (std::size_t p = first; p < batch.geometry.size(); ++p) {
                const std::uint64_t local = fold(dots_port, places[i].cell);
                Shape mark = piece_of(shape, input.step, p == first ? local : fold(local, p - first), p);
                mark.direction = poses[i].direction;
                mark.is_mark = true;
                mark.inked = !shape.inked;  // a mark is all ink on paper, all paper on ink
                batch.ports[dots_port].push_back(mark);
            }
        }
    });
}

}  // namespace

Operator stipple_operator() {
    return {
        {.name = "stipple",
         .aliases = {"stipling", "stippling"},
         .help = "cover shapes with dots, dashes or other marks; the shapes themselves stay whole below them",
         .source = "gTangle, section 4; Secord 2002",
         .parameters = {{.name = "spacing",
                         .type = ParameterType::length,
                         .help = "usual distance from mark to mark, where it is darkest",
                         .default_text = "5px",
                         .low = 0.1,
                         .high = 1e6},
                        {.name = "size",
                         .type = ParameterType::length,
                         .help = "diameter of the largest marks, or length of dashes and curves",
                         .default_text = "1.8px",
                         .low = 0.05,
                         .high = 1e6},
                        {.name = "margin",
                         .type = ParameterType::length,
                         .help = "how far the marks keep from the border",
                         .default_text = "1px",
                         .low = 0.001,
                         .high = 1e6},
                        {.name = "density",
                         .type = ParameterType::form,
                         .help = "how many marks there are: a number from 0 to 1, or one that changes over the shape",
                         .default_text = "1",
                         .low = 0,
                         .high = 1,
                         .forms = &density_forms()},
                        {.name = "mark",
                         .type = ParameterType::form,
                         .help = "what the marks are: dots, dashes, curves, circles, or a shape of any form",
                         .default_text = "dot",
                         .words = {"dot", "dash", "curve", "circle"},
                         .forms = &shape_forms()},
                        rotation_parameter(
                            "which way the marks lie: an angle, as the shape's own direction, each at random, or "
                            "along the nearest border",
                            "random"),
                        {.name = "stroke",
                         .type = ParameterType::length,
                         .help = "how thick dashes, curves and circles are drawn",
                         .default_text = "0.8px",
                         .low = 0.01,
                         .high = 1e6},
                        {.name = "variation",
                         .type = ParameterType::real,
                         .help = "how much smaller a mark may come out, as a part of its size",
                         .default_text = "0.2",
                         .low = 0,
                         .high = 0.9},
                        {.name = "grow",
                         .type = ParameterType::flag,
                         .help = "marks are larger, too, where they are denser",
                         .default_text = "false"},
                        {.name = "over",
                         .type = ParameterType::word,
                         .help = "what a density is laid over: the box of each shape, or that of the whole group",
                         .default_text = "shape",
                         .words = {"shape", "group"}}},
         .ports = {{"ground", "the shapes below the marks"}, {"dots", "the marks, which are no part of the area"}},
         .example = "stipple(4, size: 1.5, density: gradient(1, 0.1)) : petals -> dotted",
         .shrinks = false},
        run,
        true};
}

}  // namespace filigree::tangle
