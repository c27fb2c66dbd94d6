// Complete streamlines at equal distances over a shape (gTangle, section 4.2; Jobard and Lefer 1997).
//
// Lines follow a field of directions both ways from seeds beside the lines that are there already. A line ends at the
// border, closes, or, where it comes too near to another, bends into it and ends on one of its points: so every line
// is complete, and what they cut is a drawing of strips that split and merge. All choices go by order: seeds beside the
// first line come first, what they leave empty is looked for row by row. The same input gives the same lines, to
// the last bit.
//
// Bounds, for the separation d: a seed keeps d (0.97 of it) from every other line, and a line keeps d/5 from every
// other except within 3 d of where one of the two ends; nearly every inside point that is d from the border has a line
// within 1.5 d (what is left are places where the field vanishes, winds up into a spiral, or is too narrow for a line).
#pragma once

#include <functional>
#include <vector>

#include "plane/grid_field.h"
#include "plane/path.h"

namespace filigree {

struct StreamlineOptions {
    double separation = 1;          // px, > 0
    bool follows_border = false;    // the border counts as a line: the field runs along it
    bool merges = true;             // else a line that comes too near just ends
    bool climbs = false;            // the directions are slopes of some 1: a line goes straight over ridges, where they
                                    // vanish, and ends on summits
    double tolerance = 0.025;       // px: of the polylines
    std::size_t limit = 1'000'000;  // steps in all
};
// `direction`: any length but 0 counts, 0 is no direction. `distances`: signed, from the border, on a grid over the
// shape; coordinates are relative as the grid's. `first_seeds` are tried before all others.
std::vector<Polyline> streamlines(const std::function<Vec(Vec)>& direction, const GridField& distances,
                                  const std::vector<Vec>& first_seeds, const StreamlineOptions& options);

}  // namespace filigree
