// Which edges of a mesh's faces show as lines in a view.
#pragma once

#include <cstdint>
#include <vector>

#include "space/mesh.h"

namespace filigree {

// For each of Mesh::corners, whether the edge that goes on from it is an outline or a crease: its face has no other
// beside it there or several, or one that looks the other way from the viewer, or one at `crease` degrees or more.
// `looks` says of each face whether it looks towards the viewer (1), away (-1) or neither (0).
std::vector<char> drawn_edges(const Mesh& mesh, const std::vector<signed char>& looks, double crease);

}  // namespace filigree
