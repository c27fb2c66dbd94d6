// Placed shapes made smaller until none overlaps another or comes out of the region (gTangle, section 4.2: "scaled
// where they overlap").
//
// Guarantee: fitted objects keep `gap` from each other and, where the border counts, `border_gap` from the region's
// border, all of them inside; checked on their outlines exactly but for roundings far below the gap. Every object
// shrinks about its own place and only for what is near it. Cost: under a microsecond for round motifs; for others a
// look at the edges of those neighbours whose circles overlap.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plane/edge_tree.h"
#include "plane/motif.h"

namespace filigree {

struct FitOptions {
    double gap = 0x1p-10;         // px, > 0: between objects
    double border_gap = 0x1p-10;  // px, > 0: to the border
    bool border_counts = true;    // false: objects may reach out of the region
    double border_least = 0.5;    // of its radius: an object that would have to be smaller at the border is left out
    double neighbour_least = 0;   // and among its neighbours
};

// Shrinks the radii; 0 for an object that is left out. `border` is the region's, with coordinates as they are;
// objects must lie inside the region with their `at`.
void fit(std::span<Pose> objects, const Motif& motif, const EdgeTree& border, const FitOptions& options);

}  // namespace filigree
