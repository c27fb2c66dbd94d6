// place: spread shapes over a region, none overlapping, and what remains around them (gTangle, section 4.2).
#include <algorithm>

#include "derivation/start_shapes.h"
#include "engines/tangle/motifs.h"
#include "engines/tangle/operators/operators.h"
#include "plane/carve.h"
#include "plane/fit.h"
#include "plane/spread.h"

namespace filigree::tangle {
namespace {

enum Port { placed_port, remainder_port };

constexpr double least_gap = 0x1p-10;  // px: neighbours never touch, so the remainder keeps clean rings
constexpr unsigned relaxation_rounds = 3;
constexpr double least_inside = 0.6;  // of its radius: how near to the border an object outside may be cut by it

enum class Border { inside, touch, clip };

struct Wish {
    std::string_view word;  // empty for a drawn motif
    const Motif* drawn = nullptr;
    double radius = 0, spacing = 0, variation = 0, least = 0, resolution = 0;
    bool is_relaxed = true;
    Border border = Border::inside;
    std::uint64_t choice = 0;
};

Wish wish_of(const OperatorInput& input, const DrawnMotifs& drawn, std::size_t index, const Shape& shape) {
    const Arguments& arguments = input.arguments;
    Wish wish;
    wish.drawn = drawn.at(index);
    if (wish.drawn == nullptr) wish.word = arguments.word("shape", index);
    wish.spacing = arguments.number("spacing", index);
    wish.radius = std::max(arguments.number("size", index) - least_gap, least_gap) / 2;
    wish.variation = arguments.number("variation", index);
    wish.least = arguments.number("least", index);
    wish.resolution = input.resolution;
    wish.is_relaxed = arguments.flag("relax", index);
    const std::string_view border = arguments.word("border", index);
    wish.border = border == "clip" ? Border::clip : border == "touch" ? Border::touch : Border::inside;
    wish.choice = random_bits(input.scatter, Key{fold(input.step.value, shape.key.value)}, "scatter");
    return wish;
}

// Where objects are cut by the border, they lie as if it were not there: spread over all of the box and beyond, as
// long as that is not much more than the region.
std::vector<SpreadPoint> places_all_over(PolygonView polygon, const Wish& wish, SpreadOptions options) {
    constexpr double most = 12;  // times the region's own area
    const Box box = bounds(polygon);
    const Vec low = to_px(box.min), high = to_px(box.max);
    const double rim = 2 * wish.spacing + wish.radius;
    const Vec size = high - low + Vec{2 * rim, 2 * rim};
    if (size.x * size.y > most * (area(polygon) + wish.spacing * wish.spacing)) return spread(polygon, options);
    Polygons around;
    around.points = {snap({low.x - rim, low.y - rim}), snap({high.x + rim, low.y - rim}),
                     snap({high.x + rim, high.y + rim}), snap({low.x - rim, high.y + rim})};
    around.end_ring();
    around.end_polygon();
    options.limit = std::min(options.limit, UINT64_MAX / 16) * 16;
    return spread(around[0], options);
}

std::vector<SpreadPoint> places_in(PolygonView polygon, const EdgeTree& border, const Wish& wish, std::uint64_t limit) {
    SpreadOptions options;
    options.spacing = options.apart = wish.spacing;
    options.rounds = wish.is_relaxed ? relaxation_rounds : 0;
    options.seed = wish.choice;
    options.limit = limit;
    if (wish.border == Border::clip) {
        std::vector<SpreadPoint> places = places_all_over(polygon, wish, options);
        // Objects of which little lies inside would only leave slivers.
        std::erase_if(places, [&](const SpreadPoint& place) {
            const double reach = least_inside * std::min(wish.radius, wish.spacing / 2);
            return !border.is_any_nearer(place.at, reach) && !border.is_inside(place.at);
        });
        return places;
    }
    if (wish.border == Border::inside) {
        // Large motifs shrink to their neighbours, and so may stand as near to the border as to them.
        const double own = std::min(wish.radius, wish.spacing / 2);
        options.clearance = own + least_gap;
        options.least_clearance = own * wish.least;
    }
    return spread(polygon, options);
}

Motif motif_for_fit(const Wish& wish) {
    if (wish.drawn != nullptr) return *wish.drawn;
    return wish.word == "square" ? square_motif() : disc_motif(12);
}

// The outlines of all objects that are left; `owners` gets the object of each polygon.
Polygons outlines_of(const Wish& wish, const std::vector<Pose>& poses, const std::vector<std::uint64_t>& bits,
                     const Motif& motif, std::vector<std::uint32_t>& owners) {
    Polygons objects;
    const bool is_blob = wish.word == "blob";
    std::vector<Vec> circle;
    int corners = 0;
    Motif round;
    for (std::uint32_t i = 0; i < poses.size(); ++i) {
        if (!(poses[i].radius > 0)) continue;
        if (!motif.is_round || wish.drawn != nullptr) {
            append(objects, motif, poses[i]);
        } else {
            const int wanted = circle_corners(poses[i].radius, wish.resolution);
            if (wanted != corners) {
                corners = wanted;
                circle = unit_circle(std::max(corners * 3 / 2, 24));
                round = disc_motif(corners);
            }
            append(objects, is_blob ? blob_motif(circle, bits[i]) : round, poses[i]);
        }
        owners.resize(objects.size(), i);
    }
    return objects;
}

Result<OperatorOutput> run(const OperatorInput& input) {
    const Arguments& arguments = input.arguments;
    if (is_too_dense(input, "spacing")) return too_many_shapes(input);
    const Result<DrawnMotifs> drawn = DrawnMotifs::of(input, "shape", "size");
    if (!drawn) return drawn.diagnostics();
    return for_each_shape(input, [&](std::size_t index, const Shape& shape, PolygonView polygon, Batch& batch) {
        const Wish wish = wish_of(input, *drawn, index, shape);
        const std::uint64_t limit = input.element_budget + 1 - std::min(input.element_budget, batch.added);
        const EdgeTree border(edges_of(polygon, Point{0, 0}));
        const std::vector<SpreadPoint> places = places_in(polygon, border, wish, limit);

        std::vector<Pose> poses;
        std::vector<std::uint64_t> bits;
        poses.reserve(places.size());
        bits.reserve(places.size());
        for (const SpreadPoint& place : places) {
            bits.push_back(random_bits(wish.choice, Key{place.cell}, "object"));
            const double radius = wish.radius * (1 - wish.variation * to_unit(bits.back()));
            const Vec direction =
                copy_direction(arguments.value("rotation", index), shape, polygon, border, place.at, bits.back());
            poses.push_back({place.at, direction, radius});
        }
        const Motif motif = motif_for_fit(wish);
        FitOptions fitting;
        fitting.gap = fitting.border_gap = least_gap;
        fitting.border_counts = wish.border != Border::clip;
        fitting.border_least = wish.least;
        fit(poses, motif, border, fitting);

        std::vector<std::uint32_t> owners;
        const Polygons objects = outlines_of(wish, poses, bits, motif, owners);
        const Carving carving = carve(polygon, border, objects, owners, wish.border == Border::clip);

        // What is placed, and what remains, stands in no lattice.
        const auto add = [&](Port port, std::uint64_t local, PolygonView piece_polygon, Vec direction) {
            Shape piece = piece_of(shape, input.step, local, batch.geometry.size());
            piece.column = piece.row = 0;
            piece.direction = direction;
            batch.ports[port].push_back(piece);
            batch.geometry.add(piece_polygon);
        };
        // Of the pieces of one object, the first has the object's key.
        std::uint64_t part = 0;
        const auto count_parts = [&](const std::vector<std::uint32_t>& objects_of, std::size_t i) {
            part = i > 0 && objects_of[i - 1] == objects_of[i] ? part + 1 : 0;
        };
        for (std::size_t i = 0; i < carving.placed.size(); ++i) {
            count_parts(carving.owners, i);
            const std::uint32_t object = carving.owners[i];
            const std::uint64_t local = fold(placed_port, places[object].cell);
            add(placed_port, part == 0 ? local : fold(local, part), carving.placed[i], poses[object].direction);
        }
        for (std::size_t i = 0; i < carving.remainder.size(); ++i) {
            count_parts(carving.enclosing, i);
            const std::uint32_t object = carving.enclosing[i];
            const std::uint64_t local = fold(remainder_port, part);
            add(remainder_port, object == Carving::none ? local : fold(local, places[object].cell),
                carving.remainder[i], shape.direction);
        }
    });
}

}  // namespace

Operator place_operator() {
    return {
        {.name = "place",
         .help = "spread shapes over a region, none overlapping; the region around them remains",
         .source = "gTangle, section 4.2",
         .parameters =
             {{.name = "shape",
               .type = ParameterType::form,
               .help = "what is placed: blobs that waver a little, discs, squares, or a shape of any form",
               .default_text = "blob",
               .words = {"blob", "disc", "circ", "square"},
               .forms = &shape_forms()},
              {.name = "size",
               .type = ParameterType::length,
               .help = "largest diameter of the placed shapes",
               .low = 0.1,
               .high = 1e6},
              {.name = "spacing",
               .type = ParameterType::length,
               .help = "least distance from centre to centre; most are a little farther apart. Shapes larger than that "
                       "shrink where they would overlap",
               .low = 0.1,
               .high = 1e6,
               .aliases = {"distance"}},
              {.name = "variation",
               .type = ParameterType::real,
               .help = "how much smaller a shape may come out, as a part of its size",
               .default_text = "0",
               .low = 0,
               .high = 0.9},
              rotation_parameter("which way the shapes lie: an angle, as the region's own direction, each at random, "
                                 "or along the nearest border",
                                 "keep"),
              {.name = "border",
               .type = ParameterType::word,
               .help = "shapes at the border: moved inside, or shrunk where they stand until they fit, or cut by it",
               .default_text = "inside",
               .words = {"inside", "touch", "clip"}},
              {.name = "relax",
               .type = ParameterType::flag,
               .help = "even out the distances; without it, shapes lie as they were thrown",
               .default_text = "true"},
              {.name = "least",
               .type = ParameterType::real,
               .help = "shapes that would have to shrink below this part of their size at the border are left out",
               .default_text = "0.5",
               .low = 0.01,
               .high = 1}},
         .ports = {{"placed", "the placed shapes"}, {"remainder", "the region without them"}},
         .example = "place(blob, size: 20, spacing: 25) : rim -> blobs, rest"},
        run,
        true};
}

}  // namespace filigree::tangle
