// fill: set the background colour of shapes (gTangle, section 4, decorative operators).
#include "engines/tangle/operators/operators.h"

namespace filigree::tangle {
namespace {

Result<OperatorOutput> run(const OperatorInput& input) {
    OperatorOutput output;
    output.groups.push_back({0, 0, {input.shapes.begin(), input.shapes.end()}});
    std::vector<Shape>& shapes = output.groups[0].shapes;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        shapes[i].fill = std::get<Colour>(input.arguments.value("colour", i).data);
    }
    return output;
}

}  // namespace

Operator fill_operator() {
    return {{.name = "fill",
             .help = "give shapes a background colour, which what is drawn inside keeps",
             .source = "gTangle, section 4",
             .parameters = {{.name = "colour",
                             .type = ParameterType::colour,
                             .help = "such as #a03020, or a name such as black",
                             .aliases = {"color"}}},
             .ports = {{"shapes", "the same shapes, coloured"}},
             .example = "fill(#e8d8b0) : petals -> gold",
             .shrinks = false},
            run};
}

}  // namespace filigree::tangle
