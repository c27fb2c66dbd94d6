// transform: move, turn and scale shapes within their own borders (gTangle, section 5.3, names it as what set grammars
// have and tangles lack).
//
// A shape stays inside where it was: what would leave it is cut off, and what it uncovers is the remainder, so that the
// pieces still partition the plane.
#include "plane/transform.h"
#include "engines/tangle/operators/operators.h"
#include "engines/tangle/orientation.h"
#include "plane/clean.h"

namespace filigree::tangle {
namespace {

enum Port { shapes_port, remainder_port };

Polygons transformed(PolygonView polygon, const Transform& by) {
    std::vector<Polyline> rings;
    for (std::size_t r = 0; r < polygon.ring_count(); ++r) {
        Polyline ring{{}, true};
        for (const Point& point : polygon.ring(r)) ring.points.push_back(apply(by, to_px(point)));
        rings.push_back(std::move(ring));
    }
    return clean(rings, FillRule::even_odd);
}

Result<OperatorOutput> run(const OperatorInput& input) {
    const Arguments& arguments = input.arguments;
    return for_each_shape(input, [&](std::size_t index, const Shape& shape, PolygonView polygon, Batch& batch) {
        const double turn = arguments.number("turn", index);
        const double scale = arguments.number("scale", index);
        const Vec centre = centroid(polygon);
        const Vec to = centre + std::get<Vec>(arguments.value("move", index).data);
        const Transform by = compose(
            translation(to), compose(rotation_degrees(turn), compose(scaling(scale, scale), translation(-1 * centre))));
        Polygons before;
        before.add(polygon);
        const Polygons moved = transformed(polygon, by);
        const auto add = [&](Port port, const Polygons& pieces) {
            for (std::size_t i = 0; i < pieces.size(); ++i) {
                Shape piece = piece_of(shape, input.step, fold(port, i), batch.geometry.size());
                if (port == shapes_port) piece.direction = turned_by(shape.direction, turn);
                batch.ports[port].push_back(piece);
                batch.geometry.add(pieces[i]);
            }
        };
        add(shapes_port, intersect(before, moved));
        add(remainder_port, subtract(before, moved));
    });
}

}  // namespace

Operator transform_operator() {
    return {
        {.name = "transform",
         .help = "move, turn and scale each shape about its centre, within its own border",
         .source = "gTangle, section 5.3",
         .parameters =
             {{.name = "move", .type = ParameterType::point, .help = "how far, as (x, y)", .default_text = "(0, 0)"},
              {.name = "turn",
               .type = ParameterType::angle,
               .help = "by how much, from x towards y",
               .default_text = "0",
               .low = -360000,
               .high = 360000},
              {.name = "scale",
               .type = ParameterType::real,
               .help = "how much larger",
               .default_text = "1",
               .low = 0.001,
               .high = 1000}},
         .ports = {{"shapes", "what lies inside the old border"}, {"remainder", "what it no longer covers"}},
         .example = "transform(turn: each(10..80), scale: 0.7) : quads -> tilted, gaps"},
        run};
}

}  // namespace filigree::tangle
