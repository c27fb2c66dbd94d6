// What a plane engine grows from: the built-in shapes, path data and SVG files as clean, tagged polygons.
//
// Starts may overlap in the document; here they do not: by default a later one covers the earlier ones
// (`overlap: top`), with `union` it swallows earlier shapes of its own tag and covers the others, with
// `error` an overlap is an error. Sizes are in px, y grows downwards, built-in shapes are centred on the
// origin unless `at: (x, y)` says otherwise.
#pragma once

#include <string>
#include <vector>

#include "base/random.h"
#include "base/result.h"
#include "derivation/inputs.h"
#include "language/settings.h"
#include "plane/polygon.h"

namespace filigree {

struct StartShape {
    std::uint32_t polygon = 0;  // index into PlaneStart::polygons
    Key key;                    // of its start statement and its place in it; the tag is not hashed
};
// One group to begin with: the shapes of all starts of one tag.
struct StartGroup {
    std::string tag;
    Key key;
    std::vector<StartShape> shapes;
};
struct PlaneStart {
    Polygons polygons;
    std::vector<StartGroup> groups;  // in the order in which their tags first appear
};

// Reports every start that is wrong: unknown shapes (with the nearest), missing files, open paths, ids that
// an SVG lacks, empty results, shapes larger than the plane or smaller than a px, and starts without area.
Result<PlaneStart> make_plane_start(const Settings& settings, const Document& document, const Inputs& inputs);

// The files that the document's starts name, each once, in order, with where they are named.
std::vector<Name> start_files(const Document& document);

}  // namespace filigree
