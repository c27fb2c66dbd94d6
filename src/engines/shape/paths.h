// Paths of steps as people read them: step[3]/slide of the third automatic step, apply[2]/slide of the second by hand.
#pragma once

#include <cstdint>
#include <string>

#include "engines/shape/derive.h"

namespace filigree::shape {

// Of the step that leads to a state; of the start its tag.
std::string path_of_state(const Derivation& derivation, const Grammar& grammar, std::uint32_t state);

}  // namespace filigree::shape
