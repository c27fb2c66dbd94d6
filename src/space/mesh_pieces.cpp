#include "space/mesh_pieces.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "space/convex_parts.h"

namespace filigree {
namespace {

bool is_near_origin(Vec3 p) {  // false for what is not a number
    return std::fabs(p.x) <= 0x1p30 && std::fabs(p.y) <= 0x1p30 && std::fabs(p.z) <= 0x1p30;
}

class Collector {
public:
    Collector(const Mesh& mesh, const Camera& camera, const Job& job)
        : mesh_(mesh), job_(job), viewer_(viewer_of(camera)), near_(near_plane(camera)) {
        double extent = 0;
        seen_.reserve(mesh.vertices.size());
        for (const Vec3 vertex : mesh.vertices) {
            seen_.push_back(seen_from(camera, vertex));
            const Vec3 p = seen_.back();
            if (is_near_origin(p)) extent = std::max({extent, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
        }
        flat_ = extent * 0x1p-32;
    }

    MeshPieces collect() && {
        for (std::uint32_t face = 0; face < mesh_.faces.size(); ++face) add_face(face);
        for (std::uint32_t line = 0; line < mesh_.lines.size(); ++line) add_line(line);
        return std::move(all_);
    }

private:
    void add_face(std::uint32_t face) {
        all_.looks.push_back(0);
        const std::span<const std::uint32_t> corners = corners_of_face(mesh_, face);
        ring_.clear();
        for (const std::uint32_t corner : corners) ring_.push_back(seen_[corner]);
        if (!std::all_of(ring_.begin(), ring_.end(), is_near_origin)) return;
        const Vec3 area = doubled_area(ring_);
        if (!(length(area) > 0)) return;
        const Plane3 plane = plane_of(area, ring_[0]);
        const double side = side_of(viewer_, plane);
        all_.looks.back() = static_cast<signed char>(side > 0 ? 1 : side < 0 ? -1 : 0);

        const ConvexParts parts = convex_parts(ring_, flat_, job_);
        const std::uint32_t first_edge = first_corner(mesh_, face);
        const auto count = static_cast<std::uint32_t>(ring_.size());
        std::uint32_t parent = no_piece;
        if (parts.is_whole && parts.ends.size() > 1 && !is_beside_camera(ring_)) {
            for (std::uint32_t i = 0; i < count; ++i) all_.pieces.corners.push_back({ring_[i], first_edge + i});
            parent = add_piece({0, count, face, add_plane(plane), no_piece, false});
        }
        std::uint32_t begin = 0;
        for (const std::uint32_t end : parts.ends) {
            add_part(face, {parts.corners.data() + begin, parts.corners.data() + end}, parent,
                     parts.is_whole ? &plane : nullptr);
            begin = end;
        }
    }

    // By its corners in the ring. A plane that all parts share is known better than the small ones among them say.
    void add_part(std::uint32_t face, std::span<const std::uint32_t> part, std::uint32_t parent, const Plane3* shared) {
        const auto ring_size = static_cast<std::uint32_t>(ring_.size());
        part_.clear();
        for (const std::uint32_t corner : part) part_.push_back(ring_[corner]);
        const Vec3 area = doubled_area(part_);
        if (!(length(area) > 0)) return;
        const Plane3 plane = shared != nullptr ? *shared : plane_of(area, part_[0]);
        const double side = side_of(viewer_, plane);
        if (side == 0 || (side < 0 && !mesh_.faces[face].is_sheet)) return;
        for (std::size_t i = 0; i < part.size(); ++i) {
            const std::uint32_t next = part[i + 1 < part.size() ? i + 1 : 0];
            const bool is_edge = next == (part[i] + 1) % ring_size;
            all_.pieces.corners.push_back({part_[i], is_edge ? first_corner(mesh_, face) + part[i] : no_edge});
        }
        const std::uint32_t piece =
            add_piece({0, static_cast<std::uint32_t>(part.size()), face, add_plane(plane), parent, false});
        add_visible(piece, is_beside_camera(part_));
    }

    void add_line(std::uint32_t line) {
        const std::span<const std::uint32_t> points = points_of_line(mesh_, line);
        ring_.clear();
        for (const std::uint32_t point : points) {
            if (ring_.empty() || ring_.back() != seen_[point]) ring_.push_back(seen_[point]);
        }
        if (ring_.size() < 2 || !(mesh_.lines[line].width > 0)) return;
        if (!std::all_of(ring_.begin(), ring_.end(), is_near_origin)) return;
        const bool is_beside = is_beside_camera(ring_);
        std::uint32_t parent = no_piece;
        if (ring_.size() > 2 && !is_beside) {
            for (const Vec3 p : ring_) all_.pieces.corners.push_back({p, 0});
            parent = add_piece({0, static_cast<std::uint32_t>(ring_.size()), line, 0, no_piece, true});
        }
        for (std::size_t i = 1; i < ring_.size(); ++i) {
            const std::uint32_t plane = add_plane(plane_facing(viewer_, ring_[i - 1], ring_[i]));
            all_.pieces.corners.push_back({ring_[i - 1], 0});
            all_.pieces.corners.push_back({ring_[i], 0});
            add_visible(add_piece({0, 2, line, plane, parent, true}), is_beside);
        }
    }

    // What was cut off here is gone, so that its pieces never become whole again.
    void add_visible(std::uint32_t piece, bool is_beside) {
        if (!is_beside) {
            all_.whole.push_back(piece);
            return;
        }
        PlaneSides sides;
        part(all_.pieces, std::span(&piece, 1), *near_, flat_, sides);
        for (const std::uint32_t kept : sides.behind) {
            all_.pieces.pieces[kept].parent = no_piece;
            all_.whole.push_back(kept);
        }
    }

    bool is_beside_camera(const std::vector<Vec3>& points) const {
        return near_ && std::any_of(points.begin(), points.end(), [&](Vec3 p) { return p.z >= near_->offset; });
    }

    static Plane3 plane_of(Vec3 area, Vec3 through) {
        const Vec3 normal = unit(area);
        return {normal, dot(normal, through)};
    }
    std::uint32_t add_plane(const Plane3& plane) {
        all_.pieces.planes.push_back(plane);
        return static_cast<std::uint32_t>(all_.pieces.planes.size() - 1);
    }
    // Of the corners that stand last.
    std::uint32_t add_piece(Piece piece) {
        piece.first = static_cast<std::uint32_t>(all_.pieces.corners.size()) - piece.count;
        all_.pieces.pieces.push_back(piece);
        return static_cast<std::uint32_t>(all_.pieces.pieces.size() - 1);
    }

    const Mesh& mesh_;
    const Job& job_;
    const Viewer viewer_;
    const std::optional<Plane3> near_;
    MeshPieces all_;
    std::vector<Vec3> seen_;  // the mesh's vertices
    double flat_ = 0;         // how far from a plane is in it
    std::vector<Vec3> ring_, part_;
};

}  // namespace

MeshPieces mesh_pieces(const Mesh& mesh, const Camera& camera, const Job& job) {
    return Collector(mesh, camera, job).collect();
}

}  // namespace filigree
