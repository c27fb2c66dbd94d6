// The invariants of derived designs, for `--verify`, tests and fuzzers.
#pragma once

#include <string>
#include <vector>

#include "engines/shape/derive.h"

namespace filigree::shape {

// What does not hold, in words: that the design is maximal, that every step took away what was there, that the way back
// to the start and forth again gives the same.
std::vector<std::string> broken_invariants(const Derivation& derivation, const Grammar& grammar);

}  // namespace filigree::shape
