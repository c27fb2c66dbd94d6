// What of a mesh stands before a camera, in convex pieces: what painter's order works on.
#pragma once

#include <cstdint>
#include <vector>

#include "base/job.h"
#include "space/mesh.h"
#include "space/painters_order.h"
#include "space/view.h"

namespace filigree {

struct MeshPieces {
    // As seen from the camera. A piece's source is its face or line, an edge of a face its first corner in
    // Mesh::corners. Faces that are not convex and lines of several stretches are parents of what they fall into.
    Pieces pieces;
    // What is to be painted, lines behind faces: where they lie in a face they come out on top of it. Faces of solids
    // that look away are missing, and so is what is seen edge-on, has no extent, is not finite or lies beyond 2^30 px.
    std::vector<std::uint32_t> whole;
    std::vector<signed char> looks;  // of each face: 1 towards the viewer, -1 away, 0 neither
};
// Some of it where the job is cancelled.
MeshPieces mesh_pieces(const Mesh& mesh, const Camera& camera, const Job& job = {});

}  // namespace filigree
