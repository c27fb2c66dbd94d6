// Families of curves that are no graphs over a line: circles, rays and spirals about a point, and copies of a drawn
// curve laid side by side.
//
// Each family numbers the strips between its curves, so that a piece keeps its number when other pieces come or go:
// rings outwards from the centre, sectors from the first ray on, rows of copies by their levels. One or two families
// cut a shape at once by cut_by_curves, so that the pieces of a dual cut share all of their vertices. A piece is
// numbered by a point inside it: one thinner than the tolerance may get a neighbour's number.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "plane/level_cut.h"
#include "plane/path.h"
#include "plane/polygon.h"

namespace filigree {

struct Circles {
    Vec centre;                      // px
    std::vector<double> radii = {};  // px, > 0, increasing
    std::int32_t first_ring = 0;     // number of the ring (or disc) inside radii[0]
    double tolerance = 0.1;          // px
};

// Rays from a centre outwards. With a curl they bend as they go out: many turns make a spiral of as many arms.
struct Rays {
    Vec centre;                        // px
    std::vector<double> degrees = {};  // where each starts: in [first, first + 360), increasing; one alone cuts little
    double curl = 0;                   // degrees a px outwards
    double from = 0;                   // px from the centre: where they start
    double tolerance = 0.1;            // px
};

// A drawn curve along +x, from the origin on, ready to be repeated.
struct DrawnCurve {
    std::vector<Polyline> lines;
    double period = 0;           // px along x from copy to copy
    double low = 0, high = 0;    // px: its extent in y
    double left = 0, right = 0;  // px: in x
    bool goes_on = false;        // each copy starts where the one before it ends
};
// Nothing where the lines have no length. An open line is turned so that its ends lie on the x axis and is continued
// end to end; closed ones and several keep their direction and are laid side by side.
std::optional<DrawnCurve> drawn_curve(std::span<const Polyline> lines);
// The same curve as a function of x, where it is one, to the tolerance.
std::optional<Profile> profile_of(const DrawnCurve& curve, double tolerance);

struct Copies {
    DrawnCurve curve;
    Frame frame;
    std::vector<double> levels;    // px across the frame, increasing
    std::int32_t first_strip = 0;  // of what lies before levels[0]
};

using CurveFamily = std::variant<Circles, Rays, Copies>;

struct FamilyCut {
    Polygons pieces;  // by column, then by row, then by their least points
    std::vector<std::int32_t> columns, rows;
    bool too_large = false;  // a family would need more than 2^22 points over the shape: nothing was cut
};
// The second family may be null; then all rows are 0.
FamilyCut cut_by_families(PolygonView shape, const CurveFamily& first, const CurveFamily* second);

// How near the shape comes to a point (0 where it lies inside) and how far it reaches from it, px.
LevelRange distance_range(PolygonView shape, Vec from);

}  // namespace filigree
