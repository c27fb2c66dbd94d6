// A drawing repeated by a symmetry group over a canvas: seamless tiles, filled pages, rosettes.
//
// Guarantees: the painting order is the same in every tile (all copies of one operation, row by row, then those of the
// next over them), and copies in different tiles are equal on the grid, so what crosses one edge of a canvas that is
// exactly a tile comes in at the opposite one. Copies of the group's domain neither overlap nor leave gaps
// (symmetry.h); mirrored shapes keep their orientation. Curves are moved as doubles, so that those in different tiles
// are equal but for rounding. A shape keeps its key in the copy that is the motif itself; in every other one it has a
// key of its own, which does not depend on what else is shown.
#pragma once

#include <cstdint>
#include <string>

#include "base/job.h"
#include "base/limits.h"
#include "base/result.h"
#include "plane/symmetry.h"
#include "scene/drawing.h"

namespace filigree {

struct RepeatOptions {
    Canvas canvas;                   // of the result; shapes that lie outside it with all of their pen are left out
    const Polygons* clip = nullptr;  // what lies outside is cut off, and cuts are stroked
    std::uint64_t most_copies = 200'000;
    std::uint64_t most_shapes = Limits{}.elements;
    Job job;
};

// Each copy is a child of the root, with the motif's groups in it; its path stands before theirs. Styles and pens
// stay. Above the limits, and where the job is cancelled: Fault::limit.
Result<Drawing> repeated(const Drawing& motif, const Symmetry& symmetry, const RepeatOptions& options);

// What a shape of the motif is called in a copy.
Key key_of_copy(Key shape, const Copy& copy);
// "p4m/3", and with its tile, unless that is the middle one, "p4m/3/1,-2": operation, column, row.
std::string path_of_copy(const Symmetry& symmetry, const Copy& copy);

// The box of all the copies in the middle tile: of a rosette, of all there are.
Box bounds_of_copies(const Symmetry& symmetry, const Polygons& motif);

}  // namespace filigree
