#include "session/engines.h"

#include "engines/rewriting/edit_operators.h"
#include "engines/shape/match_words.h"
#include "engines/tangle/operators/operators.h"
#include "language/shape_forms.h"

namespace filigree {

std::span<const EngineInfo> engines() {
    static const std::vector<EngineInfo> all = [] {
        EngineInfo tangle{"tangle", "group grammars that split, outline and fill regions of the plane", {}};
        for (const tangle::Operator& op : tangle::operators()) tangle.operators.push_back(&op.description);
        EngineInfo rewriting{"rewriting", "string rewriting with symbols that program it", {}, "Edits"};
        for (const rewriting::EditOperator& op : rewriting::edit_operators()) {
            rewriting.operators.push_back(&op.description);
        }
        EngineInfo shape{
            "shape", "shape grammars of curves: rules apply wherever their left side can be seen", {}, "Forms"};
        for (const auto* forms :
             {&drawn_shapes(), &shape_transforms(), &shape_regions(), &rule_derivations(), &shape::match_words()}) {
            for (const OperatorDescription& form : *forms) shape.operators.push_back(&form);
        }
        return std::vector<EngineInfo>{tangle, rewriting, shape};
    }();
    return all;
}

std::span<const ExampleInfo> examples() {
    static const std::vector<ExampleInfo> all = {
#include "session/examples.inc"
    };
    return all;
}

}  // namespace filigree
