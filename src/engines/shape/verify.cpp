#include "engines/shape/verify.h"

#include <algorithm>

#include "curves/maximal.h"

namespace filigree::shape {

std::vector<std::string> broken_invariants(const Derivation& derivation, const Grammar& grammar) {
    std::vector<std::string> broken;
    const auto& elements = derivation.design.elements;
    if (!(curves::merged(elements, grammar.tolerance) == derivation.design))
        broken.push_back("the design is not maximal");
    if (derivation.made_by.size() != elements.size()) broken.push_back("an element does not know its step");
    for (std::uint32_t s = 1; s <= derivation.steps.size(); ++s) {
        if (derivation.steps[s - 1].before >= s) {
            broken.push_back("step " + std::to_string(s) + " stands before the state that it changes");
            return broken;
        }
    }
    Derivation again = derivation;
    go_to(again, 0);
    if (!(again.design == grammar.start)) broken.push_back("the way back does not lead to the start");
    for (std::uint32_t state : way_to(derivation, derivation.state)) {
        if (state == 0) continue;
        for (const curves::Element& e : derivation.steps[state - 1].change.removed) {
            if (std::binary_search(again.design.elements.begin(), again.design.elements.end(), e,
                                   curves::comes_before)) {
                continue;
            }
            broken.push_back("step " + std::to_string(state) + " took away what was not there");
            break;
        }
        go_to(again, state);
    }
    if (!(again.design == derivation.design)) broken.push_back("the way forth leads to another design");
    if (again.made_by != derivation.made_by) broken.push_back("the way forth gives elements to other steps");
    return broken;
}

}  // namespace filigree::shape
