#include "engines/shape/paths.h"

#include <cmath>

#include "base/number_text.h"
#include "language/quantity.h"

namespace filigree::shape {

std::string path_of_state(const Derivation& derivation, const Grammar& grammar, std::uint32_t state) {
    if (state == 0) return grammar.start_tag;
    const Step& step = derivation.steps[state - 1];
    return (step.number > 0 ? "step[" + std::to_string(step.number) : "apply[" + std::to_string(step.by_hand)) + "]/" +
           grammar.rules[step.rule].name;
}

std::string place_text(Vec place, const Document& document) {
    const auto in_unit = [&](double px) { return to_text(std::round(from_px(px, unit_of(document)) * 1000) / 1000); };
    return "(" + in_unit(place.x) + ", " + in_unit(place.y) + ")";
}

}  // namespace filigree::shape
