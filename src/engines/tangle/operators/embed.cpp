// embed: another document grows inside every shape (docs/language.md, "Documents inside documents").
//
// The derivation runs it itself (embed_step.h), since it needs the documents that were opened.
#include "engines/tangle/operators/operators.h"

namespace filigree::tangle {

Operator embed_operator() {
    return {{.name = "embed",
             .help = "grow another document inside every shape; its parameters are given by name",
             .source = "Gothic window tracery, section 3",
             .parameters = {{.name = "document",
                             .type = ParameterType::any,
                             .help = "a system of this document, or a file in quotes"}},
             .ports = {{"ground", "the shapes themselves, below what grows in them"}},
             .example = "embed(\"knot.fil\", spacing: 8) : medallion",
             .shrinks = false},
            nullptr};
}

}  // namespace filigree::tangle
