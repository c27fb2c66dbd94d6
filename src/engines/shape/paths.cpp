#include "engines/shape/paths.h"

namespace filigree::shape {

std::string path_of_state(const Derivation& derivation, const Grammar& grammar, std::uint32_t state) {
    if (state == 0) return grammar.start_tag;
    const Step& step = derivation.steps[state - 1];
    return (step.number > 0 ? "step[" + std::to_string(step.number) : "apply[" + std::to_string(step.by_hand)) + "]/" +
           grammar.rules[step.rule].name;
}

}  // namespace filigree::shape
