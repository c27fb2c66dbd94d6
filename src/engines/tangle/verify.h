// The invariants of a tangle (engines/tangle/README.md numbers them), checked from the geometry alone.
#pragma once

#include <string>
#include <vector>

#include "engines/tangle/tangle.h"

namespace filigree::tangle {

struct Areas {
    double start = 0;   // px^2, of the starts
    double leaves = 0;  // px^2, of the leaves that partition them: without marks
};
Areas areas(const Tangle& tangle);

// The shapes of the leaves, as copies in order; marks are left out.
Polygons leaf_polygons(const Tangle& tangle);

// A sentence for each invariant that does not hold; none where all is well.
std::vector<std::string> broken_invariants(const Tangle& tangle);

}  // namespace filigree::tangle
