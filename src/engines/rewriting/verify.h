// The invariants of words and their drawings as functions, for --verify, tests and fuzzers.
#pragma once

#include <string>
#include <vector>

#include "engines/rewriting/derive.h"
#include "scene/drawing.h"

namespace filigree::rewriting {

// What does not hold, in words; empty where all does. Columns have an entry for every symbol that they speak of, every
// symbol is one of the alphabet's, and no '=' stands at the beginning.
std::vector<std::string> broken_invariants(const Derivation& derivation);

// Lines have two points or more; filled shapes are clean (plane/verify.h).
std::vector<std::string> broken_invariants(const Drawing& drawing);

}  // namespace filigree::rewriting
