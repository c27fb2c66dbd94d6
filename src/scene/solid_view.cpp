#include "scene/solid_view.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include "space/convex_parts.h"
#include "space/mesh_edges.h"
#include "space/painters_order.h"
#include "space/rejoin.h"

namespace filigree {
namespace {

constexpr std::int64_t least_step = 16;  // grid units between neighbours of a ring, so that rounding crosses nothing
constexpr double thinnest = 0x1p-20;     // px

bool is_near_origin(Vec3 p) {  // false for what is not a number
    return std::fabs(p.x) <= 0x1p30 && std::fabs(p.y) <= 0x1p30 && std::fabs(p.z) <= 0x1p30;
}

// What stands before the camera, in convex pieces that know their faces and lines.
class Preparation {
public:
    Preparation(const Mesh& mesh, const Camera& camera)
        : mesh_(mesh), viewer_(viewer_of(camera)), near_(near_plane(camera)) {
        double extent = 0;
        seen_.reserve(mesh.vertices.size());
        for (const Vec3 vertex : mesh.vertices) {
            seen_.push_back(seen_from(camera, vertex));
            const Vec3 p = seen_.back();
            if (is_near_origin(p)) extent = std::max({extent, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
        }
        flat_ = extent * 0x1p-32;
    }

    // Lines stand behind faces: where they lie in a face they are painted over it.
    void prepare() {
        for (std::uint32_t face = 0; face < mesh_.faces.size(); ++face) add_face(face);
        for (std::uint32_t line = 0; line < mesh_.lines.size(); ++line) add_line(line);
    }

    Pieces pieces;
    std::vector<std::uint32_t> whole;  // pieces that no other is cut into yet
    std::vector<signed char> looks;    // of each face: towards the viewer, away, or neither

private:
    void add_face(std::uint32_t face) {
        looks.push_back(0);
        const std::span<const std::uint32_t> corners = corners_of_face(mesh_, face);
        ring_.clear();
        for (const std::uint32_t corner : corners) ring_.push_back(seen_[corner]);
        if (!std::all_of(ring_.begin(), ring_.end(), is_near_origin)) return;
        const Vec3 area = doubled_area(ring_);
        if (!(length(area) > 0)) return;
        const double side = side_of(viewer_, plane_of(area, ring_[0]));
        looks.back() = static_cast<signed char>(side > 0 ? 1 : side < 0 ? -1 : 0);

        const ConvexParts parts = convex_parts(ring_, flat_);
        const std::uint32_t first_edge = first_corner(mesh_, face);
        const auto count = static_cast<std::uint32_t>(ring_.size());
        std::uint32_t parent = no_piece;
        if (parts.is_whole && parts.ends.size() > 1 && !is_beside_camera(ring_)) {
            for (std::uint32_t i = 0; i < count; ++i) pieces.corners.push_back({ring_[i], first_edge + i});
            parent = add_piece({0, count, face, add_plane(plane_of(area, ring_[0])), no_piece, false});
        }
        std::uint32_t begin = 0;
        for (const std::uint32_t end : parts.ends) {
            add_part(face, {parts.corners.data() + begin, parts.corners.data() + end}, parent);
            begin = end;
        }
    }

    // Of the ring, which part it is by its corners there.
    void add_part(std::uint32_t face, std::span<const std::uint32_t> part, std::uint32_t parent) {
        const auto ring_size = static_cast<std::uint32_t>(ring_.size());
        part_.clear();
        for (const std::uint32_t corner : part) part_.push_back(ring_[corner]);
        const Vec3 area = doubled_area(part_);
        if (!(length(area) > 0)) return;
        const Plane3 plane = plane_of(area, part_[0]);
        const double side = side_of(viewer_, plane);
        if (side == 0 || (side < 0 && !mesh_.faces[face].is_sheet)) return;
        for (std::size_t i = 0; i < part.size(); ++i) {
            const std::uint32_t next = part[i + 1 < part.size() ? i + 1 : 0];
            const bool is_edge = next == (part[i] + 1) % ring_size;
            pieces.corners.push_back({part_[i], is_edge ? first_corner(mesh_, face) + part[i] : no_edge});
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
            for (const Vec3 p : ring_) pieces.corners.push_back({p, 0});
            parent = add_piece({0, static_cast<std::uint32_t>(ring_.size()), line, 0, no_piece, true});
        }
        for (std::size_t i = 1; i < ring_.size(); ++i) {
            const std::uint32_t plane = add_plane(plane_facing(viewer_, ring_[i - 1], ring_[i]));
            pieces.corners.push_back({ring_[i - 1], 0});
            pieces.corners.push_back({ring_[i], 0});
            add_visible(add_piece({0, 2, line, plane, parent, true}), is_beside);
        }
    }

    // What was cut off here is gone, so that its pieces never become whole again.
    void add_visible(std::uint32_t piece, bool is_beside) {
        if (!is_beside) {
            whole.push_back(piece);
            return;
        }
        PlaneSides sides;
        part(pieces, std::span(&piece, 1), *near_, flat_, sides);
        for (const std::uint32_t kept : sides.behind) {
            pieces.pieces[kept].parent = no_piece;
            whole.push_back(kept);
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
        pieces.planes.push_back(plane);
        return static_cast<std::uint32_t>(pieces.planes.size() - 1);
    }
    // Of the corners that stand last.
    std::uint32_t add_piece(Piece piece) {
        piece.first = static_cast<std::uint32_t>(pieces.corners.size()) - piece.count;
        pieces.pieces.push_back(piece);
        return static_cast<std::uint32_t>(pieces.pieces.size() - 1);
    }

    const Mesh& mesh_;
    const Viewer viewer_;
    const std::optional<Plane3> near_;
    std::vector<Vec3> seen_;  // the mesh's vertices
    double flat_ = 0;         // how far from a plane is in it
    std::vector<Vec3> ring_, part_;
};

Colour shaded(Colour colour, double light) {
    const auto channel = [&](std::uint8_t value) {
        return static_cast<std::uint8_t>(round_to_whole(std::clamp(value * light, 0.0, 255.0)));
    };
    return {channel(colour.red), channel(colour.green), channel(colour.blue), colour.alpha};
}

// Pieces to shapes of a drawing.
class Draughtsman {
public:
    Draughtsman(const Mesh& mesh, std::span<const Material> materials, const View& view, const Camera& camera,
                const SolidViewOptions& options, const Pieces& pieces, const std::vector<char>& drawn)
        : mesh_(mesh),
          materials_(materials),
          options_(options),
          pieces_(pieces),
          drawn_(drawn),
          viewer_(viewer_of(camera)),
          light_(length(view.light) > 0 ? unit(view.light) : Vec3{0, 0, 1}),
          ambient_(std::clamp(view.ambient, 0.0, 1.0)) {
        places_.reserve(pieces.corners.size());
        for (const PieceCorner& corner : pieces.corners) places_.push_back(projected(camera, corner.at));
        widths_.reserve(pieces.pieces.size());
        const std::vector<double> pens = pens_of_lines(camera);
        for (const Piece& piece : pieces.pieces) widths_.push_back(piece.is_line ? pens[piece.source] : 0);
    }

    Drawing draw(std::span<const std::uint32_t> order) && {
        for (const std::uint32_t piece : rejoined(pieces_, order, places_, widths_)) {
            if (pieces_.pieces[piece].is_line) {
                draw_line(piece);
            } else {
                draw_face(piece);
            }
        }
        const auto count = static_cast<std::uint32_t>(drawing_.shapes.size());
        drawing_.groups.push_back({options_.path, 0, count, 0, 0, {}});
        if (!is_empty(box_)) fit_canvas(drawing_.canvas, box_, options_.margin);
        drawing_.geometry.push_back(std::make_shared<const Polygons>(std::move(geometry_)));
        return std::move(drawing_);
    }

private:
    // Of one line everywhere the same, so that its pieces fit together.
    std::vector<double> pens_of_lines(const Camera& camera) const {
        std::vector<double> pens;
        for (std::uint32_t i = 0; i < mesh_.lines.size(); ++i) {
            const std::span<const std::uint32_t> points = points_of_line(mesh_, i);
            double pen = mesh_.lines[i].width * camera.scale;
            if (camera.distance && !points.empty()) {
                double nearest = -1e300;
                for (const std::uint32_t point : points) {
                    nearest = std::max(nearest, seen_from(camera, mesh_.vertices[point]).z);
                }
                pen *= *camera.distance / std::max(*camera.distance - nearest, *camera.distance * 0.01);
            }
            pens.push_back(pen);
        }
        return pens;
    }

    const Material& material(const MeshOrigin& origin) const {
        return origin.material < materials_.size() ? materials_[origin.material] : usual_;
    }

    // Of what turns to the viewer.
    double light_on(Vec3 normal, bool is_turned) const {
        const double falls = std::max(0.0, dot(is_turned ? -normal : normal, light_));
        return ambient_ + (1 - ambient_) * falls;
    }

    void draw_face(std::uint32_t number) {
        const Piece& piece = pieces_.pieces[number];
        const MeshFace& face = mesh_.faces[piece.source];
        set_ring(number);
        if (!is_thick()) return;
        bool any_stroked = false, all_stroked = true;
        const Material& made_of = material(face.origin);
        for (const char stroked : stroked_) {
            any_stroked = any_stroked || stroked != 0;
            all_stroked = all_stroked && stroked != 0;
        }
        if (!made_of.edge) any_stroked = all_stroked = false;

        const Plane3& plane = pieces_.planes[piece.plane];
        const Colour fill = shaded(made_of.fill, light_on(plane.normal, side_of(viewer_, plane) < 0));
        Style style;
        style.fill = fill;
        if (all_stroked) {
            style.stroke = made_of.edge;
            style.pen = made_of.pen;
        } else if (fill.alpha == 255 && options_.seam_pen > 0) {
            style.stroke = fill;
            style.pen = options_.seam_pen;
        }
        if (filigree::doubled_area(RingView(ring_)) < 0) {
            geometry_.points.insert(geometry_.points.end(), ring_.rbegin(), ring_.rend());
        } else {
            geometry_.points.insert(geometry_.points.end(), ring_.begin(), ring_.end());
        }
        add_shape(style, face.origin.element);
        if (any_stroked && !all_stroked) draw_edges(made_of, face.origin.element);
    }

    // In runs that begin behind an edge that is not stroked.
    void draw_edges(const Material& made_of, Key element) {
        Style style;
        style.stroke = made_of.edge;
        style.pen = made_of.pen;
        style.is_open = true;
        const std::size_t count = ring_.size();
        std::size_t start = 0;
        while (stroked_[start] != 0) ++start;
        bool is_drawing = false;
        for (std::size_t i = 1; i <= count; ++i) {
            const std::size_t at = (start + i) % count;
            if (is_drawing || stroked_[at] != 0) geometry_.points.push_back(ring_[at]);
            if (is_drawing && stroked_[at] == 0) add_shape(style, element);
            is_drawing = stroked_[at] != 0;
        }
    }

    void draw_line(std::uint32_t number) {
        const Piece& piece = pieces_.pieces[number];
        const MeshLine& line = mesh_.lines[piece.source];
        set_ring(number);
        if (ring_.size() < 2) return;
        Style style;
        style.stroke = material(line.origin).fill;
        style.pen = widths_[number];
        style.is_open = true;
        const std::span<const PieceCorner> corners = corners_of(pieces_, number);
        const bool is_cut_off = corners.front().edge == no_edge, ends_cut = corners.back().edge == no_edge;
        if (is_cut_off || ends_cut) {
            draw_stretch(style, is_cut_off, ends_cut, line.origin.element);
            return;
        }
        geometry_.points.insert(geometry_.points.end(), ring_.begin(), ring_.end());
        add_shape(style, line.origin.element);
    }

    // Square where it was cut: a round end would lie on what hides the other part. A little longer, so that no seam
    // shows.
    void draw_stretch(Style style, bool is_cut_off, bool ends_cut, Key element) {
        const Vec from = to_px(ring_.front()), to = to_px(ring_.back());
        const Vec along = (to - from) * (1 / length(to - from)), more = along * (options_.seam_pen / 2);
        if (length(to - from) > style.pen && (!is_cut_off || !ends_cut)) {
            const Point middle = snap(from + (to - from) * 0.5);
            geometry_.points.insert(geometry_.points.end(),
                                    {is_cut_off ? middle : ring_.front(), is_cut_off ? ring_.back() : middle});
            add_shape(style, element);
        }
        style.corner = Corner::bevel;
        geometry_.points.push_back(snap(from - more));
        geometry_.points.push_back(snap(to + more));
        add_shape(style, element);
    }

    // The piece in the picture, without points that lie too near to the one before.
    void set_ring(std::uint32_t number) {
        const std::span<const PieceCorner> corners = corners_of(pieces_, number);
        const bool is_line = pieces_.pieces[number].is_line;
        ring_.clear();
        stroked_.clear();
        const auto is_next_to = [](Point a, Point b) {
            return std::abs(a.x - b.x) < least_step && std::abs(a.y - b.y) < least_step;
        };
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Vec place = places_[pieces_.pieces[number].first + i];
            if (!is_on_plane(place)) {
                ring_.clear();
                return;
            }
            const Point p = snap(place);
            const bool is_edge = !is_line && corners[i].edge != no_edge;
            const char is_stroked = is_edge ? drawn_[corners[i].edge] : 0;
            if (!ring_.empty() && is_next_to(ring_.back(), p)) {
                stroked_.back() = is_stroked;
                continue;
            }
            ring_.push_back(p);
            stroked_.push_back(is_stroked);
        }
        while (!is_line && ring_.size() > 1 && is_next_to(ring_.back(), ring_.front())) {
            ring_.pop_back();
            stroked_.pop_back();
        }
    }

    bool is_thick() const {
        if (ring_.size() < 3) return false;
        double around = 0;
        for (std::size_t i = 0; i < ring_.size(); ++i) {
            around += length(to_px(ring_[i]) - to_px(ring_[i + 1 < ring_.size() ? i + 1 : 0]));
        }
        return std::fabs(area(RingView(ring_))) > thinnest * around;
    }

    // Of the points that stand behind the last ring.
    void add_shape(const Style& style, Key element) {
        const std::size_t first = geometry_.ring_ends.empty() ? 0 : geometry_.ring_ends.back();
        for (std::size_t i = first; i < geometry_.points.size(); ++i) {
            const std::int64_t around = round_to_whole(style.pen / 2 * grid_per_px);
            extend(box_, {geometry_.points[i].x - around, geometry_.points[i].y - around});
            extend(box_, {geometry_.points[i].x + around, geometry_.points[i].y + around});
        }
        geometry_.end_ring();
        geometry_.end_polygon();
        const auto polygon = static_cast<std::uint32_t>(geometry_.size() - 1);
        drawing_.shapes.push_back({0, polygon, style_number(style), element});
    }

    std::uint32_t style_number(const Style& style) {
        const auto bits = [](const std::optional<Colour>& colour) -> std::uint64_t {
            if (!colour) return 0;
            return std::uint64_t{1} << 32 | std::uint64_t{colour->red} << 24 | std::uint64_t{colour->green} << 16 |
                   std::uint64_t{colour->blue} << 8 | colour->alpha;
        };
        const auto next = static_cast<std::uint32_t>(drawing_.styles.size());
        const auto [known, is_new] =
            styles_.try_emplace({bits(style.fill), bits(style.stroke), style.pen, style.is_open, style.corner}, next);
        if (is_new) drawing_.styles.push_back(style);
        return known->second;
    }

    const Mesh& mesh_;
    const std::span<const Material> materials_;
    const Material usual_;
    const SolidViewOptions& options_;
    const Pieces& pieces_;
    const std::vector<char>& drawn_;  // edges, by their first corners
    const Viewer viewer_;
    const Vec3 light_;
    const double ambient_;
    std::vector<Vec> places_;     // of the pieces' corners in the picture
    std::vector<double> widths_;  // of the pieces
    std::vector<Point> ring_;
    std::vector<char> stroked_;  // from each point of the ring on
    Polygons geometry_;
    Box box_;
    Drawing drawing_;
    std::map<std::tuple<std::uint64_t, std::uint64_t, double, bool, Corner>, std::uint32_t> styles_;
};

}  // namespace

Result<Drawing> solid_view(const Mesh& mesh, std::span<const Material> materials, const View& view,
                           const SolidViewOptions& options) {
    const Camera camera = camera_of(view, mesh);
    Preparation ready(mesh, camera);
    ready.prepare();
    const auto order = painters_order(ready.pieces, ready.whole, viewer_of(camera), options.most_pieces);
    if (!order) return order.diagnostics();
    const std::vector<char> drawn = drawn_edges(mesh, ready.looks, options.crease);
    return Draughtsman(mesh, materials, view, camera, options, ready.pieces, drawn).draw(*order);
}

}  // namespace filigree
