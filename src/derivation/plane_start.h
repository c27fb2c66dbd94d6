// What a plane engine grows from: the built-in shapes, path data and SVG files as clean, tagged polygons.
//
// Starts may overlap in the document; here they do not: by default a later one covers the earlier ones
// (`overlap: top`), with `union` it swallows earlier shapes of its own tag and covers the others, with
// `error` an overlap is an error. Sizes are in px, y grows downwards, built-in shapes are centred on the
// origin unless `at: (x, y)` says otherwise.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/random.h"
#include "base/result.h"
#include "derivation/shape_source.h"
#include "language/preset_walk.h"
#include "language/settings.h"
#include "plane/polygon.h"
#include "plane/symmetry.h"
#include "plane/transform.h"

namespace filigree {

struct StartShape {
    std::uint32_t polygon = 0;  // index into PlaneStart::polygons
    Key key;                    // of its start statement and its place in it; the tag is not hashed

    bool operator==(const StartShape&) const = default;
};
// One group to begin with: the shapes of all starts of one tag.
struct StartGroup {
    std::string tag;
    Key key;  // of the first piece that has its tag, whether anything of that is left or not
    std::vector<StartShape> shapes;

    bool operator==(const StartGroup&) const = default;
};
struct PlaneStart {
    Polygons polygons;
    std::vector<StartGroup> groups;    // in the order in which their tags first appear
    ChoiceBuffer choices;              // made in the starts' arguments
    std::vector<std::uint32_t> met;    // presets in force that a start has met
    bool in_host = false;              // whether a start is the host's shape
    bool leaves_host = false;          // whether another start may reach beyond it
    std::optional<Symmetry> symmetry;  // at its place; p1 where there is but a `page tile`
    Transform to_host;                 // from this document's coordinates to the host's, where in_host

    bool is_same(const PlaneStart& other) const { return polygons == other.polygons && groups == other.groups; }
};

// Reports every start that is wrong: unknown shapes (with the nearest), missing files, open paths, ids that
// an SVG lacks, empty results, shapes larger than the plane or smaller than a px, and starts without area.
// `host`: the one polygon that `host(...)` means, in the host's coordinates; null for a document on its own, where it
// is the page, else a rectangle of 400 x 300 px.
Result<PlaneStart> make_plane_start(const Settings& settings, const Document& document, const ShapeSource& shapes,
                                    const DocumentSite& site = {}, const PolygonView* host = nullptr);

// How a document's page, centred on the origin, is laid over a box: words as in host(fit: ...).
Transform page_onto(const Page& page, const Box& box, std::string_view fit);

}  // namespace filigree
