// invert: swap ink and paper. What is drawn inside an inverted shape is white on black. The paper's grammars
// use it everywhere and define it nowhere; this is how their pictures look.
#include "engines/tangle/operators/operators.h"

namespace filigree::tangle {
namespace {

Result<OperatorOutput> run(const OperatorInput& input) {
    OperatorOutput output;
    output.groups.push_back({0, 0, {input.shapes.begin(), input.shapes.end()}});
    for (Shape& shape : output.groups[0].shapes) shape.inked = !shape.inked;
    return output;
}

}  // namespace

Operator invert_operator() {
    return {{.name = "invert",
             .help = "swap ink and paper: black with white details, or back again",
             .source = "gTangle, supplemental grammars",
             .ports = {{"shapes", "the same shapes, inverted"}},
             .example = "invert() : remainder -> dark",
             .shrinks = false},
            run};
}

}  // namespace filigree::tangle
