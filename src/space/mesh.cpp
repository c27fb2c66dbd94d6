#include "space/mesh.h"

namespace filigree {
namespace {

// About the first point, so that rings far from the origin lose nothing.
template <class PointAt>
Vec3 sum_of_fan(std::size_t count, const PointAt& point_at) {
    Vec3 sum;
    for (std::size_t i = 2; i < count; ++i) {
        sum = sum + cross(point_at(i - 1) - point_at(0), point_at(i) - point_at(0));
    }
    return sum;
}

}  // namespace

std::uint32_t add_vertices(Mesh& mesh, std::span<const Vec3> vertices) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), vertices.begin(), vertices.end());
    return first;
}

std::uint32_t append(Mesh& to, const Mesh& from) {
    const std::uint32_t first = add_vertices(to, from.vertices);
    const auto first_face_corner = static_cast<std::uint32_t>(to.corners.size());
    const auto first_line_point = static_cast<std::uint32_t>(to.line_points.size());
    for (const std::uint32_t corner : from.corners) to.corners.push_back(first + corner);
    for (const std::uint32_t point : from.line_points) to.line_points.push_back(first + point);
    for (MeshFace face : from.faces) {
        face.end += first_face_corner;
        to.faces.push_back(face);
    }
    for (MeshLine line : from.lines) {
        line.end += first_line_point;
        to.lines.push_back(line);
    }
    return first;
}

void add_face(Mesh& mesh, std::span<const std::uint32_t> corners, const MeshOrigin& origin, bool is_sheet) {
    mesh.corners.insert(mesh.corners.end(), corners.begin(), corners.end());
    mesh.faces.push_back({static_cast<std::uint32_t>(mesh.corners.size()), origin, is_sheet});
}

void add_line(Mesh& mesh, std::span<const Vec3> points, double width, const MeshOrigin& origin) {
    const std::uint32_t first = add_vertices(mesh, points);
    for (std::uint32_t i = 0; i < points.size(); ++i) mesh.line_points.push_back(first + i);
    mesh.lines.push_back({static_cast<std::uint32_t>(mesh.line_points.size()), origin, width});
}

Vec3 doubled_area(std::span<const Vec3> ring) {
    return sum_of_fan(ring.size(), [&](std::size_t i) { return ring[i]; });
}

Vec3 doubled_area(const Mesh& mesh, std::size_t face) {
    const std::span<const std::uint32_t> corners = corners_of_face(mesh, face);
    return sum_of_fan(corners.size(), [&](std::size_t i) { return mesh.vertices[corners[i]]; });
}

}  // namespace filigree
