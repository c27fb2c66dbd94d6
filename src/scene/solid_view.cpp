#include "scene/solid_view.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include "space/mesh_edges.h"
#include "space/mesh_pieces.h"
#include "space/painters_order.h"
#include "space/rejoin.h"
#include "space/stroke_again.h"

namespace filigree {
namespace {

constexpr std::int64_t least_step = 16;  // grid units between neighbours of a ring, so that rounding crosses nothing
constexpr double thinnest = 0x1p-20;     // px

Colour shaded(Colour colour, double light) {
    const auto channel = [&](std::uint8_t value) {
        return static_cast<std::uint8_t>(round_to_whole(std::clamp(value * light, 0.0, 255.0)));
    };
    return {channel(colour.red), channel(colour.green), channel(colour.blue), colour.alpha};
}

// Stretches of a ring that are stroked, where not all of it is: from which point on, and how many edges.
template <class Visit>
void visit_runs(const std::vector<char>& stroked, const Visit& visit) {
    const std::size_t count = stroked.size();
    const auto gap = static_cast<std::size_t>(std::find(stroked.begin(), stroked.end(), 0) - stroked.begin());
    for (std::size_t i = 1, run = 0; i < count; i += run + 1) {
        run = 0;
        while (i + run < count && stroked[(gap + i + run) % count] != 0) ++run;
        if (run > 0) visit((gap + i) % count, run);
    }
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
        strokes_.reserve(pieces.corners.size());
        const std::vector<double> pens = pens_of_lines(camera);
        for (const Piece& piece : pieces.pieces) widths_.push_back(piece.is_line ? pens[piece.source] : 0);
        for (std::uint32_t i = 0; i < pieces.pieces.size(); ++i) add_strokes(i);
    }

    Drawing draw(std::span<const std::uint32_t> order) && {
        const auto hulls = [&](CutEnds ends) { return picture_hulls(pieces_, places_, widths_, ends); };
        const std::vector<std::uint32_t> whole = rejoined(pieces_, order, hulls(CutEnds::shorter));
        const std::vector<StrokeAgain> again = strokes_again(pieces_, whole, places_, hulls(CutEnds::whole), strokes_);
        auto next = again.begin();
        for (std::uint32_t place = 0; place < whole.size(); ++place) {
            if (pieces_.pieces[whole[place]].is_line) {
                draw_line(whole[place]);
            } else {
                draw_face(whole[place]);
            }
            for (; next != again.end() && next->place == place; ++next) draw_again(*next);
        }
        const auto count = static_cast<std::uint32_t>(drawing_.shapes.size());
        drawing_.groups.push_back({options_.path, 0, count, 0, 0, {}});
        if (!is_empty(box_)) fit_canvas(drawing_.canvas, box_, options_.margin);
        drawing_.geometry.push_back(std::make_shared<const Polygons>(std::move(geometry_)));
        return std::move(drawing_);
    }

private:
    // Pieces come in the order of their corners.
    void add_strokes(std::uint32_t number) {
        const Piece& piece = pieces_.pieces[number];
        for (const PieceCorner& corner : corners_of(pieces_, number)) {
            double pen = 0;
            if (!piece.is_line && corner.edge != no_edge && drawn_[corner.edge] != 0) {
                const Material& made_of = material(mesh_.faces[piece.source].origin);
                if (made_of.edge && made_of.pen > 0) pen = made_of.pen + options_.seam_pen;
            }
            strokes_.push_back(pen);
        }
    }

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
        const Material& made_of = material(face.origin);
        const bool is_stroked = std::find(stroked_.begin(), stroked_.end(), 0) == stroked_.end();
        const Plane3& plane = pieces_.planes[piece.plane];
        const Colour fill = shaded(made_of.fill, light_on(plane.normal, side_of(viewer_, plane) < 0));
        Style style;
        style.fill = fill;
        if (is_stroked) {
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

        if (is_stroked) return;
        const Style edges = edge_style(made_of);
        visit_runs(stroked_, [&](std::size_t first, std::size_t count) {
            for (std::size_t i = 0; i <= count; ++i) geometry_.points.push_back(ring_[(first + i) % ring_.size()]);
            add_shape(edges, face.origin.element);
        });
    }

    static Style edge_style(const Material& made_of) {
        Style style;
        style.stroke = made_of.edge;
        style.pen = made_of.pen;
        style.is_open = true;
        return style;
    }

    void draw_again(const StrokeAgain& stroke) {
        const MeshOrigin& origin = mesh_.faces[pieces_.pieces[stroke.piece].source].origin;
        ring_.clear();
        for (const Vec place : stroke.line) {
            if (is_on_plane(place)) add_point(snap(place));
        }
        if (ring_.size() < 2) return;
        geometry_.points.insert(geometry_.points.end(), ring_.begin(), ring_.end());
        add_shape(edge_style(material(origin)), origin.element);
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
        const Piece& piece = pieces_.pieces[number];
        ring_.clear();
        stroked_.clear();
        for (std::uint32_t i = piece.first; i < piece.first + piece.count; ++i) {
            if (!is_on_plane(places_[i])) {
                ring_.clear();
                return;
            }
            add_point(snap(places_[i]));
            stroked_.resize(ring_.size());
            stroked_.back() = strokes_[i] > 0 ? 1 : 0;
        }
        while (!piece.is_line && ring_.size() > 1 && are_near(ring_.back(), ring_.front())) {
            ring_.pop_back();
            stroked_.pop_back();
        }
    }

    void add_point(Point p) {
        if (ring_.empty() || !are_near(ring_.back(), p)) ring_.push_back(p);
    }
    static bool are_near(Point a, Point b) {
        return std::abs(a.x - b.x) < least_step && std::abs(a.y - b.y) < least_step;
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
    std::vector<Vec> places_;      // of the pieces' corners in the picture
    std::vector<double> widths_;   // of lines, by pieces
    std::vector<double> strokes_;  // pens of edges and a seam's, by the pieces' corners
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
    MeshPieces ready = mesh_pieces(mesh, camera, options.job);
    if (is_cancelled(options.job)) return cancelled_diagnostic();
    const auto order = painters_order(ready.pieces, ready.whole, viewer_of(camera), options.most_pieces, options.job);
    if (!order) return order.diagnostics();
    const std::vector<char> drawn = drawn_edges(mesh, ready.looks, options.crease);
    return Draughtsman(mesh, materials, view, camera, options, ready.pieces, drawn).draw(*order);
}

}  // namespace filigree
