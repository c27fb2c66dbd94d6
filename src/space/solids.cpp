#include "space/solids.h"

#include <array>
#include <vector>

#include "base/elementary.h"

namespace filigree {
namespace {

// `section` runs counterclockwise as seen from where the heading points to.
void add_extrusion(Mesh& mesh, Vec3 from, Vec3 to, std::span<const Vec3> section, const MeshOrigin& origin) {
    const auto sides = static_cast<std::uint32_t>(section.size());
    std::vector<Vec3> points;
    points.reserve(2 * section.size());
    for (const Vec3 end : {from, to}) {
        for (const Vec3 offset : section) points.push_back(end + offset);
    }
    const std::uint32_t first = add_vertices(mesh, points);
    std::vector<std::uint32_t> cap;
    for (std::uint32_t i = sides; i-- > 0;) cap.push_back(first + i);
    add_face(mesh, cap, origin);
    for (std::uint32_t i = 0; i < sides; ++i) {
        const std::uint32_t next = i + 1 < sides ? i + 1 : 0;
        add_face(mesh, std::array{first + i, first + next, first + sides + next, first + sides + i}, origin);
    }
    cap.clear();
    for (std::uint32_t i = 0; i < sides; ++i) cap.push_back(first + sides + i);
    add_face(mesh, cap, origin);
}

// Whether the segment goes forwards, so that faces come out looking outwards.
bool goes_along(Vec3 from, Vec3 to, const Frame3& frame) { return dot(to - from, frame.heading) > 0; }

}  // namespace

bool add_prism(Mesh& mesh, Vec3 from, Vec3 to, const Frame3& frame, double radius, std::uint32_t sides,
               const MeshOrigin& origin) {
    if (!(radius > 0) || sides < 3 || !goes_along(from, to, frame)) return false;
    std::vector<Vec3> section;
    for (std::uint32_t i = 0; i < sides; ++i) {
        const elementary::CosSin turn = elementary::cos_sin_degrees(360.0 * i / sides);
        section.push_back(frame.left * (radius * turn.cos) + frame.up * (radius * turn.sin));
    }
    add_extrusion(mesh, from, to, section, origin);
    return true;
}

bool add_box(Mesh& mesh, Vec3 from, Vec3 to, const Frame3& frame, double breadth, double height,
             const MeshOrigin& origin) {
    if (!(breadth > 0) || !(height > 0) || !goes_along(from, to, frame)) return false;
    const Vec3 left = frame.left * (breadth / 2), up = frame.up * (height / 2);
    add_extrusion(mesh, from, to, std::array{left - up, left + up, -left + up, -left - up}, origin);
    return true;
}

bool add_sheet(Mesh& mesh, std::span<const Vec3> ring, const MeshOrigin& origin) {
    if (ring.size() < 3 || !(length(doubled_area(ring)) > 0)) return false;
    const std::uint32_t first = add_vertices(mesh, ring);
    std::vector<std::uint32_t> corners;
    for (std::uint32_t i = 0; i < ring.size(); ++i) corners.push_back(first + i);
    add_face(mesh, corners, origin, true);
    return true;
}

}  // namespace filigree
