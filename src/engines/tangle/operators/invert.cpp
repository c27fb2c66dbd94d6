// invert: swap ink and paper. What is drawn inside an inverted shape is white on black.
//
// The paper's grammars use it everywhere and define it nowhere. In the published pictures it blackens every
// second strip or field of a split (`invert(even)` here), and single shapes whole; plain `invert()` takes all.
#include "engines/tangle/operators/operators.h"

namespace filigree::tangle {
namespace {

enum Port { inverted_port, rest_port };

Result<OperatorOutput> run(const OperatorInput& input) {
    const std::string_view which = input.arguments.word("which");
    OperatorOutput output;
    output.groups = {{inverted_port, 0, {}}, {rest_port, 0, {}}};
    for (Shape shape : input.shapes) {
        const bool is_odd = ((shape.column ^ shape.row) & 1) != 0;  // the parity of column + row
        const bool is_taken = which == "all" || is_odd == (which == "odd");
        if (is_taken) shape.inked = !shape.inked;
        output.groups[is_taken ? inverted_port : rest_port].shapes.push_back(shape);
    }
    return output;
}

}  // namespace

Operator invert_operator() {
    return {{.name = "invert",
             .help = "swap ink and paper: black with white details, or back again",
             .source = "gTangle, supplemental grammars",
             .parameters = {{.name = "which",
                             .type = ParameterType::word,
                             .help = "all shapes, or every second strip or field of the split that made them",
                             .default_text = "all",
                             .words = {"all", "even", "odd"}}},
             .ports = {{"inverted", "the inverted shapes"}, {"rest", "those left as they are"}},
             .example = "invert(even) : strips -> dark, light",
             .shrinks = false},
            run};
}

}  // namespace filigree::tangle
