// An elliptic arc by its centre, from SVG's end points, radii and flags (SVG 1.1, appendix F.6); inner part of
// the paths.
#pragma once

#include "plane/path.h"

namespace filigree {

struct CentreArc {
    bool is_line = true;        // degenerate: its chord is meant
    Vec from;                   // px
    Vec across, along;          // px: the ellipse's half axes as vectors
    double start = 0;           // radians in the ellipse's own parameter
    double turn = 0;            // radians, signed, up to a full turn
    double largest_radius = 0;  // px
};

// `shape` is {rx, ry}, {rotation in degrees, flags} as Verb::arc has them. Radii that do not reach are enlarged.
CentreArc centre_arc(Vec from, const Vec shape[2], Vec to);

// The point at a part (0 to 1) of the way.
Vec point_at(const CentreArc& arc, double part);
// Cubics that follow it to 1e-9 of its radius, three points each.
void append_cubics(Path& path, const CentreArc& arc, Vec to);

}  // namespace filigree
