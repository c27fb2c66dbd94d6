// Solids from what turtles make: prisms and bricks along a segment, flat sheets.
//
// Solids are closed, and their faces look outwards (mesh.h); each has vertices of its own. A frame says how they
// are turned about the segment, so that rows of them do not twist; what has no extent in some direction is left out
// whole, and nothing is said about it: false is returned.
#pragma once

#include <cstdint>
#include <span>

#include "space/mesh.h"

namespace filigree {

// A prism over a regular polygon with its corners at `radius` from the axis, the first of them to the frame's left,
// turning towards its up; `sides` is at least 3. The ends are cut at right angles to the frame's heading.
bool add_prism(Mesh& mesh, Vec3 from, Vec3 to, const Frame3& frame, double radius, std::uint32_t sides,
               const MeshOrigin& origin);

// A brick about the segment's line: `breadth` along the frame's left and `height` along its up, half on either side.
bool add_box(Mesh& mesh, Vec3 from, Vec3 to, const Frame3& frame, double breadth, double height,
             const MeshOrigin& origin);

// A flat polygon that is seen from both sides, convex or not.
bool add_sheet(Mesh& mesh, std::span<const Vec3> ring, const MeshOrigin& origin);

}  // namespace filigree
