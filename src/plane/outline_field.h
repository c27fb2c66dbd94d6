// A distance from the border that grows rounder inwards: its level lines are concentric outlines (gTangle, section
// 4.2, streamline split, smooth outline).
//
// The plain distance has kinks where it comes from several sides, and its level lines keep every corner. Here
// the border gives off heat, so to say, that fades within `reach`; the directions in which it fades are smooth, and
// the field is the function whose gradient comes closest to them at unit length. So lines stay equally far from
// one another, run parallel to the border near it, and forget its corners within `reach`. Where walls meet halfway
// the field keeps its ridge.
#pragma once

#include "plane/edge_tree.h"
#include "plane/grid_field.h"

namespace filigree {

// 0 at the border, negative outside. `distances` as signed_distances gives them; a reach of 0 leaves the plain
// distance, but for the spline between the nodes.
GridField outline_field(const Grid& grid, const std::vector<double>& distances, double reach);

}  // namespace filigree
