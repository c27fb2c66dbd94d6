// Steps and places as people read them: step[3]/slide of the third automatic step, apply[2]/slide of the second by
// hand; (3, -2.5) in the document's unit.
#pragma once

#include <cstdint>
#include <string>

#include "engines/shape/derive.h"

namespace filigree::shape {

// Of the step that leads to a state; of the start its tag.
std::string path_of_state(const Derivation& derivation, const Grammar& grammar, std::uint32_t state);

// Of a place in px, to a thousandth of the unit.
std::string place_text(Vec place, const Document& document);

}  // namespace filigree::shape
