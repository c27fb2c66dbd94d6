// Shapes that are placed many times over: discs, blobs, drawn ones; scaled to a circle of radius 1 about the origin.
//
// A motif is clean (polygon.h) at every size of a few grid steps and more, in every direction.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plane/clean.h"

namespace filigree {

struct Motif {
    std::vector<Vec> points;               // of all rings; none farther than 1 from the origin
    std::vector<std::uint32_t> ring_ends;  // as in Polygons: outers positive, then the holes of each
    std::vector<std::uint32_t> polygon_ends;
    bool is_round = false;  // fitted by the circle around it, which it fills about
    bool is_frail = false;  // parts of it come so near to each other that rounding to the grid might join them
};

// Where a motif lies. Its x axis goes to `direction`.
struct Pose {
    Vec at;               // px
    Vec direction{1, 0};  // unit
    double radius = 0;    // px
};

// How many corners a circle of that radius needs to stay within `tolerance` px: 12 to 256, a multiple of 4.
int circle_corners(double radius, double tolerance);
std::vector<Vec> unit_circle(int corners);
Motif disc_motif(int corners);
// A pebble: a disc that wavers gently, its centroid in the origin. Another `bits`, another pebble. The circle is one
// of unit_circle.
Motif blob_motif(const std::vector<Vec>& circle, std::uint64_t bits);
Motif square_motif();
// A stroke with round ends along x, from end to end 2; `width` is a part of that length.
Motif dash_motif(double width, int corners);
// A stroke of that width in the form of a flat S.
Motif curve_motif(double width, int corners);
Motif ring_motif(double width, int corners);

// From outlines as people draw them: moved so that the smallest circle around them is the motif's. Details below
// `tolerance` (a part of the radius) are left out. Empty where the outlines enclose nothing.
Motif drawn_motif(const std::vector<Polyline>& outlines, FillRule rule, double tolerance);

// Adds the motif's polygons there, on the grid.
void append(Polygons& polygons, const Motif& motif, const Pose& pose);

}  // namespace filigree
