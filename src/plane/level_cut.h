// The exact split of a polygon with holes by a family of level curves.
//
// A family is the graphs v = profile(u) + level over a frame: straight lines, waves, zigzags or any drawn
// curve that is a graph. Cutting is a walk along each ring, not a boolean: crossings are emitted in order,
// sorted along each level, paired, and the faces are traced. Paper: gTangle, section 4.2 (regular split).
//
// Guarantees: the pieces partition the shape (both sides of a cut share all of its vertices, so their areas
// add up to the shape's to 1e-9). Crossings on an edge depend on the edge and the family alone: neighbours
// cut by one family share their new vertices, too, so a dual split is a conforming partition. A vertex within
// 2^-20 px of a level is on it, and levels within 2^-20 px of the one below them are left out, so no slivers
// thinner than that arise. The result depends on the geometry alone, not on where rings start or in what
// order they come: a ring starts at its lexicographically least point, holes are in the order of theirs.
// What runs along a level stays on its own side; a piece comes to no point twice because of a cut.
// Refuses: what is no family leaves the shape in one piece, of first_strip: a frame, samples or levels (over
// the shape) that are not finite, levels that do not increase, a step below 2^-16 px, more than 2^22 samples
// over the shape, more than 2^31 points of all pieces. The shape must be clean (polygon.h).
// Cost: O(points + crossings log crossings + chord points); levels outside the shape cost a bisection.
// Holes that no level crosses are assigned to faces of their strip by one sweep a strip.
//
// Method: level_walk.h (rings to arcs, crossings to chords), level_faces.h (both to faces).
#pragma once

#include <cstdint>
#include <vector>

#include "plane/polygon.h"

namespace filigree {

// Coordinates (u, v) along and across a family: p = origin + u direction + v perpendicular(direction).
struct Frame {
    Vec origin;           // px
    Vec direction{1, 0};  // unit length

    bool operator==(const Frame&) const = default;
};

constexpr Vec to_frame(const Frame& frame, Vec p) {
    const Vec d = p - frame.origin;
    return {dot(d, frame.direction), dot(d, perpendicular(frame.direction))};
}
constexpr Vec from_frame(const Frame& frame, Vec uv) {
    return frame.origin + uv.x * frame.direction + uv.y * perpendicular(frame.direction);
}
// The same frame turned by a quarter turn: the second family of a dual split.
constexpr Frame turned(const Frame& frame) { return {frame.origin, perpendicular(frame.direction)}; }

// The curve of a family as a periodic, piecewise linear function of u: profile(k step) = samples[k mod n].
// No samples: a straight line.
struct Profile {
    double step = 1;              // px between samples, > 0
    std::vector<double> samples;  // px

    bool operator==(const Profile&) const = default;
};

struct LevelFamily {
    Frame frame;
    Profile profile;
    std::vector<double> levels;  // px, strictly increasing
    std::int32_t first_strip =
        0;  // index of the strip below levels[0]; levels[k] separates first_strip + k and + k + 1
};

struct LevelCut {
    Polygons pieces;                   // by strip, then by where their lowest point lies in u
    std::vector<std::int32_t> strips;  // of each piece
};
LevelCut cut(PolygonView shape, const LevelFamily& family);

// The range of v - profile(u) over the shape's boundary (for straight lines: its extent across the frame).
struct LevelRange {
    double low = 0, high = 0;  // px
};
LevelRange level_range(PolygonView shape, const Frame& frame, const Profile& profile);

}  // namespace filigree
