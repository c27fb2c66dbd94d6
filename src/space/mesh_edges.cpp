#include "space/mesh_edges.h"

#include <algorithm>
#include <tuple>

#include "base/elementary.h"

namespace filigree {
namespace {

struct FaceEdge {
    std::uint32_t low = 0, high = 0;  // vertices
    std::uint32_t corner = 0;         // it begins there
    std::uint32_t face = 0;

    bool operator<(const FaceEdge& other) const {
        return std::tie(low, high, corner) < std::tie(other.low, other.high, other.corner);
    }
};

std::vector<FaceEdge> sorted_edges(const Mesh& mesh) {
    std::vector<FaceEdge> edges;
    edges.reserve(mesh.corners.size());
    for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
        const std::uint32_t first = first_corner(mesh, face), end = mesh.faces[face].end;
        for (std::uint32_t corner = first; corner < end; ++corner) {
            const auto [low, high] =
                std::minmax(mesh.corners[corner], mesh.corners[corner + 1 < end ? corner + 1 : first]);
            edges.push_back({low, high, corner, face});
        }
    }
    std::sort(edges.begin(), edges.end());
    return edges;
}

}  // namespace

std::vector<char> drawn_edges(const Mesh& mesh, const std::vector<signed char>& looks, double crease) {
    const double least_cosine = elementary::cos_sin_degrees(std::clamp(crease, 0.0, 180.0)).cos;
    std::vector<Vec3> areas;
    areas.reserve(mesh.faces.size());
    for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) areas.push_back(doubled_area(mesh, face));
    const auto is_smooth = [&](std::uint32_t a, std::uint32_t b) {
        return looks[a] == looks[b] && dot(areas[a], areas[b]) > least_cosine * (length(areas[a]) * length(areas[b]));
    };
    std::vector<char> drawn(mesh.corners.size(), 1);
    const std::vector<FaceEdge> edges = sorted_edges(mesh);
    for (std::size_t first = 0, end = 0; first < edges.size(); first = end) {
        while (end < edges.size() && edges[end].low == edges[first].low && edges[end].high == edges[first].high) ++end;
        if (end - first != 2 || !is_smooth(edges[first].face, edges[first + 1].face)) continue;
        drawn[edges[first].corner] = drawn[edges[first + 1].corner] = 0;
    }
    return drawn;
}

}  // namespace filigree
