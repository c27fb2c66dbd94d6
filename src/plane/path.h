// Paths: lines, circular and elliptic arcs, quadratic and cubic Beziers; in doubles, px.
//
// A path is two flat arrays, verbs and points. Subpaths start with `move`; a drawing verb right after `close`
// starts a subpath where the last one started, as in SVG. Where a path is not well formed (a drawing verb
// first, too few points), drawing starts at the origin and ends where the points do.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "plane/point.h"
#include "plane/transform.h"

namespace filigree {

enum class Verb : std::uint8_t {
    move,       // to: 1 point
    line,       // to: 1 point
    quadratic,  // control, to: 2 points
    cubic,      // control, control, to: 3 points
    arc,        // {rx, ry}, {rotation in degrees, flags: 1 large + 2 sweep}, to: 3 entries as in SVG's A
    close,      // none
};

// How many entries of Path::points a verb takes; its last is where it ends.
constexpr std::size_t point_count(Verb verb) {
    switch (verb) {
        case Verb::move:
        case Verb::line:
            return 1;
        case Verb::quadratic:
            return 2;
        case Verb::cubic:
        case Verb::arc:
            return 3;
        case Verb::close:
            return 0;
    }
    return 0;
}

struct Path {
    std::vector<Verb> verbs;
    std::vector<Vec> points;

    bool operator==(const Path&) const = default;
};

// A subpath as a polyline.
struct Polyline {
    std::vector<Vec> points;  // a closed one does not repeat its first point
    bool closed = false;

    bool operator==(const Polyline&) const = default;
};

// SVG path data (all commands, absolute and relative). As SVG says, what stands before an error could be
// drawn; here an error is an error: its span holds the byte offset in `data` (file is no_file).
Result<Path> parse_path_data(std::string_view data);
// Path data that parses to the same path; absolute commands, shortest numbers. Numbers must be finite.
std::string to_path_data(const Path& path);

// Exact but for rounding: an ellipse under an affine map is an ellipse, so arcs stay arcs. Only where a map
// flattens an arc by more than a million times does it become cubics, true to 1e-9 of its radius.
Path transformed(const Path& path, const Transform& by);

// Polylines that stay within `tolerance` px of the path (Beziers by their second differences, arcs by their
// sagitta). The number of points grows with the square root of size / tolerance and is at most 10^6 a curve; a
// tolerance finer than the grid, or none (0, NaN), is the grid's. A Bezier and its reverse give the same points.
// No point follows its equal. Subpaths that only move give nothing; a curve with a point off the plane
// (point.h) is taken as its chord.
std::vector<Polyline> flatten(const Path& path, double tolerance);

}  // namespace filigree
