// Meshes in space: faces that share vertices, and lines, in flat arrays.
//
// Conventions: a face is one ring of at least three vertices that does not repeat its first; it is planar and does not
// cross itself. Seen from outside the solid that it bounds, it runs counterclockwise (the axes are right-handed). Faces
// of one solid that meet along an edge name the same two vertices: what edge belongs to two faces is told by that. A
// line is at least two vertices. Who draws or writes a mesh must come to no harm where it is otherwise.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/colour.h"
#include "base/random.h"
#include "space/vector.h"

namespace filigree {

// How faces and lines of one kind look. A mesh only numbers its materials.
struct Material {
    std::string name = {};
    Colour fill{222, 213, 200};                       // in full light; of lines: as it is
    std::optional<Colour> edge = Colour{64, 54, 46};  // strokes along edges; none if empty
    double pen = 0.6;                                 // px, of these

    bool operator==(const Material&) const = default;
};

// What a face or a line is made of, and which element of a word or a derivation made it.
struct MeshOrigin {
    Key element;
    std::uint32_t material = 0;

    bool operator==(const MeshOrigin&) const = default;
};

struct MeshFace {
    std::uint32_t end = 0;  // one past its last corner, in Mesh::corners; it begins where the one before it ends
    MeshOrigin origin;
    bool is_sheet = false;  // seen from both sides: not part of a solid

    bool operator==(const MeshFace&) const = default;
};

struct MeshLine {
    std::uint32_t end = 0;  // one past its last point, in Mesh::line_points
    MeshOrigin origin;
    double width = 1;  // in the units of space

    bool operator==(const MeshLine&) const = default;
};

struct Mesh {
    std::vector<Vec3> vertices;
    std::vector<std::uint32_t> corners;  // of all faces: indices of vertices
    std::vector<MeshFace> faces;
    std::vector<std::uint32_t> line_points;  // of all lines: indices of vertices
    std::vector<MeshLine> lines;

    bool operator==(const Mesh&) const = default;
};

inline std::uint32_t first_corner(const Mesh& mesh, std::size_t face) {
    return face == 0 ? 0 : mesh.faces[face - 1].end;
}
inline std::span<const std::uint32_t> corners_of_face(const Mesh& mesh, std::size_t face) {
    return {mesh.corners.data() + first_corner(mesh, face), mesh.corners.data() + mesh.faces[face].end};
}
inline std::span<const std::uint32_t> points_of_line(const Mesh& mesh, std::size_t line) {
    const std::uint32_t first = line == 0 ? 0 : mesh.lines[line - 1].end;
    return {mesh.line_points.data() + first, mesh.line_points.data() + mesh.lines[line].end};
}

// Both return the number of the first new vertex.
std::uint32_t add_vertices(Mesh& mesh, std::span<const Vec3> vertices);
std::uint32_t append(Mesh& to, const Mesh& from);  // a copy of all; not of itself

void add_face(Mesh& mesh, std::span<const std::uint32_t> corners, const MeshOrigin& origin, bool is_sheet = false);
void add_line(Mesh& mesh, std::span<const Vec3> points, double width, const MeshOrigin& origin);

// Along the normal by the right-hand rule, as long as twice the area (Newell): right for every planar ring, and a
// mean for others.
Vec3 doubled_area(std::span<const Vec3> ring);
Vec3 doubled_area(const Mesh& mesh, std::size_t face);

}  // namespace filigree
