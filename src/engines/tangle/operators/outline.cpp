// outline: shrink the border by a distance; what is left inside and the band around it (gTangle, section 4.2).
#include "engines/tangle/operators/operators.h"
#include "plane/inset.h"

namespace filigree::tangle {
namespace {

enum Port { inner_port, outline_port };

Result<OperatorOutput> run(const OperatorInput& input) {
    const bool round = input.arguments.word("join") == "round";
    return for_each_shape(input, [&](std::size_t index, const Shape& shape, PolygonView polygon, Batch& batch) {
        InsetOptions options;
        options.distance = input.arguments.number("distance", index);
        options.join = round ? Join::round : Join::mitre;
        options.tolerance = input.resolution;
        const Inset result = inset(polygon, options);
        const auto add = [&](Port port, const Polygons& pieces) {
            for (std::size_t i = 0; i < pieces.size(); ++i) {
                const std::uint64_t local = fold(port, i);
                batch.ports[port].push_back(piece_of(shape, input.step, local, batch.geometry.size()));
                batch.geometry.add(pieces[i]);
            }
        };
        add(inner_port, result.inner);
        add(outline_port, without(polygon, result.inner));
    });
}

}  // namespace

Operator outline_operator() {
    return {{.name = "outline",
             .help = "shrink the border by a distance: the inside, and the band around it",
             .source = "gTangle, section 4.2",
             .parameters = {{.name = "distance",
                             .type = ParameterType::length,
                             .help = "width of the band",
                             .low = 0.001,
                             .high = 1e6},
                            {.name = "join",
                             .type = ParameterType::word,
                             .help = "how corners that point inwards are drawn",
                             .default_text = "mitre",
                             .words = {"mitre", "round"}}},
             .ports = {{"inner", "what is left inside: none, one or several shapes for each"},
                       {"outline", "the band around it"}},
             .example = "outline(12) : leaf -> inside, rim"},
            run};
}

}  // namespace filigree::tangle
