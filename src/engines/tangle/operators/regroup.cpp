// regroup: share the shapes of a group out among n groups (gTangle, section 4.1).
//
// By lattice, the class of a shape is (column + row) mod n: stripes for a plain split, a chessboard or
// diagonals for a dual one. By id it is the paper's s mod k, which looks like a chessboard only where the
// number of columns happens to suit. The other ways look at the shapes themselves.
#include <algorithm>
#include <numeric>

#include "engines/tangle/operators/operators.h"
#include "plane/neighbours.h"

namespace filigree::tangle {
namespace {

using Classes = std::vector<std::uint32_t>;  // of each shape, from 0

std::uint32_t class_of(std::int64_t number, std::int64_t count) {
    const std::int64_t rest = number % count;
    return static_cast<std::uint32_t>(rest < 0 ? rest + count : rest);
}

// Neighbours in different classes, as a map is coloured.
Classes by_colour(const OperatorInput& input, std::uint32_t count) {
    Polygons all;
    for (const Shape& shape : input.shapes) all.add(input.tangle.polygon(shape));
    return coloured(neighbours(all), count);
}

// The smallest shapes first, equally many in each class.
Classes by_area(const OperatorInput& input, std::uint32_t count) {
    std::vector<double> areas;
    for (const Shape& shape : input.shapes) areas.push_back(area(input.tangle.polygon(shape)));
    std::vector<std::uint32_t> order(areas.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return std::pair(areas[a], a) < std::pair(areas[b], b); });
    Classes out(areas.size());
    for (std::size_t rank = 0; rank < order.size(); ++rank) {
        out[order[rank]] = static_cast<std::uint32_t>(rank * count / order.size());
    }
    return out;
}

// Rings of equal width around the middle of the group.
Classes by_distance(const OperatorInput& input, std::uint32_t count) {
    std::vector<Vec> centres;
    Box box;
    for (const Shape& shape : input.shapes) {
        const PolygonView polygon = input.tangle.polygon(shape);
        centres.push_back(centroid(polygon));
        extend(box, bounds(polygon).min);
        extend(box, bounds(polygon).max);
    }
    const Vec middle = 0.5 * (to_px(box.min) + to_px(box.max));
    double farthest = 0;
    for (const Vec centre : centres) farthest = std::max(farthest, length(centre - middle));
    Classes out;
    for (const Vec centre : centres) {
        const double place = farthest > 0 ? length(centre - middle) / farthest * count : 0;
        out.push_back(std::min(count - 1, static_cast<std::uint32_t>(place)));
    }
    return out;
}

bool is_random(const Arguments& arguments) { return arguments.word("by") == "random"; }

Classes classes_of(const OperatorInput& input, std::uint32_t count) {
    const std::string_view by = input.arguments.word("by");
    if (by == "colour") return by_colour(input, count);
    if (by == "area") return by_area(input, count);
    if (by == "distance") return by_distance(input, count);
    Classes out;
    for (std::size_t i = 0; i < input.shapes.size(); ++i) {
        const Shape& shape = input.shapes[i];
        if (by == "random") {
            const double drawn = to_unit(random_bits(input.scatter, shape.key, "regroup"));
            out.push_back(std::min(count - 1, static_cast<std::uint32_t>(drawn * count)));
        } else {
            const std::int64_t number =
                by == "id" ? static_cast<std::int64_t>(i) : std::int64_t{shape.column} + shape.row;
            out.push_back(class_of(number, count));
        }
    }
    return out;
}

Result<OperatorOutput> run(const OperatorInput& input) {
    const auto count = static_cast<std::uint32_t>(input.arguments.number("groups"));
    OperatorOutput output;
    for (std::uint32_t k = 0; k < count; ++k) output.groups.push_back({0, k, {}});
    const Classes classes = classes_of(input, count);
    for (std::size_t i = 0; i < classes.size(); ++i) output.groups[classes[i]].shapes.push_back(input.shapes[i]);
    return output;
}

}  // namespace

Operator regroup_operator() {
    return {{.name = "regroup",
             .help = "share the shapes out among a number of groups, which then draw rules of their own",
             .source = "gTangle, section 4.1",
             .parameters = {{.name = "groups",
                             .type = ParameterType::whole,
                             .help = "how many groups; 2 after a dual split is a chessboard",
                             .low = 1,
                             .high = 1000},
                            {.name = "by",
                             .type = ParameterType::word,
                             .help = "what decides: the place in the split's lattice, the shape's id, neighbours "
                                     "apart as on a map (four groups nearly always suffice), size, distance from "
                                     "the middle, or chance",
                             .default_text = "lattice",
                             .words = {"lattice", "id", "colour", "area", "distance", "random"}}},
             .ports = {{"shapes", "the same shapes, in as many groups"}},
             .example = "regroup(2) : quads -> fields",
             .shrinks = false,
             .regroups = true},
            run,
            true,
            is_random};
}

}  // namespace filigree::tangle
