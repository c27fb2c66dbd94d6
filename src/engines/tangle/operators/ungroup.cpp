// ungroup: every shape becomes a group of its own, so that each draws its own rule (gTangle, section 4.1).
#include "engines/tangle/operators/operators.h"

namespace filigree::tangle {
namespace {

Result<OperatorOutput> run(const OperatorInput& input) {
    OperatorOutput output;
    output.groups.reserve(input.shapes.size());
    for (const Shape& shape : input.shapes) output.groups.push_back({0, shape.key.value, {shape}});
    return output;
}

}  // namespace

Operator ungroup_operator() {
    return {{.name = "ungroup",
             .help = "make every shape a group of its own, so that each draws its own rule",
             .source = "gTangle, section 4.1",
             .ports = {{"shapes", "the same shapes, one a group"}},
             .example = "ungroup() : quads -> single_quads",
             .shrinks = false,
             .regroups = true},
            run};
}

}  // namespace filigree::tangle
