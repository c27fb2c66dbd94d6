// Paths as people read them: big_poly/outline/in/regular_split/quads[3].
#pragma once

#include <cstdint>
#include <string>

#include "engines/tangle/grammar.h"
#include "engines/tangle/tangle.h"

namespace filigree::tangle {

// "quads[3]", "quads[3]/2" for a shape picked out of it. Hidden groups are "_".
std::string segment_of_group(const Tangle& tangle, const Grammar& grammar, std::uint32_t group);
std::string path_of_group(const Tangle& tangle, const Grammar& grammar, std::uint32_t group);
// The path of the group that it expanded, and the rule.
std::string path_of_step(const Tangle& tangle, const Grammar& grammar, std::uint32_t step);
// Where the document that grows in one shape of an `embed` step begins.
std::string path_of_embedded(const Tangle& tangle, const Grammar& grammar, std::uint32_t step, std::size_t shape);

}  // namespace filigree::tangle
