#include "scene/arrange.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "plane/clean.h"
#include "plane/edge_tree.h"
#include "plane/line_inside.h"
#include "plane/moved_polygon.h"
#include "scene/curves.h"

namespace filigree {

// Where geometry and styles stand in a growing drawing: the first of equal ones.
class DrawingIndex {
public:
    explicit DrawingIndex(Drawing& drawing) : drawing_(drawing) {}

    // Takes in what came to the drawing since the last time.
    void catch_up() {
        for (; known_geometry_ < drawing_.geometry.size(); ++known_geometry_) {
            geometry_.emplace(drawing_.geometry[known_geometry_].get(), static_cast<std::uint32_t>(known_geometry_));
        }
        for (; known_styles_ < drawing_.styles.size(); ++known_styles_) {
            styles_.emplace(words_of(drawing_.styles[known_styles_]), static_cast<std::uint32_t>(known_styles_));
        }
    }

    std::uint32_t index_of(const std::shared_ptr<const Polygons>& geometry) {
        const auto count = static_cast<std::uint32_t>(drawing_.geometry.size());
        const auto [known, is_new] = geometry_.emplace(geometry.get(), count);
        if (is_new) drawing_.geometry.push_back(geometry);
        return known->second;
    }
    std::uint32_t index_of(const Style& style) {
        const auto count = static_cast<std::uint32_t>(drawing_.styles.size());
        const auto [known, is_new] = styles_.emplace(words_of(style), count);
        if (is_new) drawing_.styles.push_back(style);
        return known->second;
    }

private:
    using Words = std::array<std::uint64_t, 4>;  // of a style: pens are compared by their bits, as NaN equals nothing

    static std::uint64_t word_of(const std::optional<Colour>& colour) {
        return colour ? std::bit_cast<std::uint32_t>(*colour) : UINT64_MAX;
    }
    static Words words_of(const Style& style) {
        return {word_of(style.fill), word_of(style.stroke), std::bit_cast<std::uint64_t>(style.pen),
                static_cast<std::uint64_t>(style.corner) | (style.is_open ? 16U : 0U)};
    }

    Drawing& drawing_;
    std::size_t known_geometry_ = 0, known_styles_ = 0;  // how many were taken in
    std::map<const Polygons*, std::uint32_t> geometry_;  // asked, never walked: pointers have no order
    std::map<Words, std::uint32_t> styles_;
};

namespace {

// Where shapes lie with respect to a clip; most are far from its border.
class Clip {
public:
    enum class Side { inside, across, outside };

    explicit Clip(const Polygons& polygons) : polygons_(unite(polygons, {})), tree_(edges_of_all(polygons_)) {}

    Side side_of(PolygonView polygon) const {
        const Box box = bounds(polygon);
        const VecBox in_px{to_px(box.min), to_px(box.max)};
        if (tree_.any(in_px, [](std::uint32_t) { return true; })) return Side::across;
        return tree_.is_inside(in_px.min) ? Side::inside : Side::outside;
    }
    const Polygons& polygons() const { return polygons_; }
    const EdgeTree& border() const { return tree_; }

private:
    static std::vector<Edge> edges_of_all(const Polygons& polygons) {
        std::vector<Edge> edges;
        for (std::size_t i = 0; i < polygons.size(); ++i) {
            const std::vector<Edge> some = edges_of(polygons[i], Point{});
            edges.insert(edges.end(), some.begin(), some.end());
        }
        return edges;
    }

    Polygons polygons_;
    EdgeTree tree_;
};

// Nothing where it leaves the plane or collapses on the grid.
Polygons mapped(PolygonView polygon, const Transform& by, bool is_open) {
    Polygons moved;
    for (std::size_t r = 0; r < polygon.ring_count(); ++r) {
        bool is_whole = true;
        for (const Point from : polygon.ring(r)) {
            const Vec to = apply(by, to_px(from));
            is_whole = is_whole && is_on_plane(to);
            if (!is_whole) break;
            moved.points.push_back(snap(to));
        }
        if (!is_whole && r == 0) return {};
        if (!is_whole) moved.points.resize(moved.ring_ends.back());  // a hole is left out
        moved.end_ring();
    }
    moved.end_polygon();
    Polygons result;
    if (is_open) {
        add_moved_line(result, moved[0].outer());
    } else {
        add_moved(result, moved[0], determinant(by) < 0);
    }
    return result;
}

class Placing {
public:
    Placing(Drawing& to, DrawingIndex& index, const Drawing& from, const Placement& placement)
        : to_(to),
          index_(index),
          from_(from),
          placement_(placement),
          keeps_geometry_(placement.transform == Transform{}) {
        if (placement.clip != nullptr) clip_.emplace(*placement.clip);
        std::size_t polygons = 0;
        for (const auto& geometry : from.geometry) {
            first_polygon_.push_back(polygons);
            polygons += geometry->size();
        }
        pieces_.resize(polygons);
        new_curve_.resize(from.curves.size());
    }

    void place() {
        const auto first_shape = static_cast<std::uint32_t>(to_.shapes.size());
        const std::vector<std::uint32_t> new_shape = add_shapes();
        add_groups(new_shape);
        if (fresh_.empty()) return;
        const auto fresh = static_cast<std::uint32_t>(to_.geometry.size());
        to_.geometry.push_back(std::make_shared<const Polygons>(std::move(fresh_)));
        for (std::uint32_t s = first_shape; s < to_.shapes.size(); ++s) {
            if (to_.shapes[s].geometry == to_be_added) to_.shapes[s].geometry = fresh;
        }
    }

private:
    static constexpr std::uint32_t to_be_added = UINT32_MAX;

    struct Pieces {  // what a polygon became
        std::uint32_t geometry = to_be_added;
        std::uint32_t first = 0, end = 0;
        bool is_whole = false;  // not cut
    };

    // Where each shape, and the end, came to stand.
    std::vector<std::uint32_t> add_shapes() {
        std::vector<std::uint32_t> new_style(from_.styles.size(), to_be_added);
        std::vector<std::uint32_t> new_shape;
        new_shape.reserve(from_.shapes.size() + 1);
        for (const DrawnShape& shape : from_.shapes) {
            new_shape.push_back(static_cast<std::uint32_t>(to_.shapes.size()));
            const Pieces pieces = pieces_of(shape.geometry, shape.polygon, from_.styles[shape.style].is_open);
            if (pieces.first == pieces.end) continue;
            std::uint32_t& style = new_style[shape.style];
            if (style == to_be_added) style = index_.index_of(scaled(from_.styles[shape.style]));
            const std::uint32_t curve =
                has_curve(shape) && pieces.is_whole ? placed_curve(shape.curve) : DrawnShape::no_curve;
            for (std::uint32_t p = pieces.first; p < pieces.end; ++p) {
                to_.shapes.push_back({pieces.geometry, p, style, shape.key, curve});
            }
        }
        new_shape.push_back(static_cast<std::uint32_t>(to_.shapes.size()));
        return new_shape;
    }

    void add_groups(const std::vector<std::uint32_t>& new_shape) {
        if (to_.groups.empty()) to_.groups.emplace_back();
        const auto root = static_cast<std::uint32_t>(to_.groups.size());
        to_.groups[placement_.parent].children.push_back(root);
        for (const DrawingGroup& group : from_.groups) {
            DrawingGroup added = group;
            const std::string& prefix = placement_.path_prefix;
            if (!prefix.empty()) added.path = group.path.empty() ? prefix : prefix + "/" + group.path;
            added.first_shape = new_shape[group.first_shape];
            added.end_shape = new_shape[group.end_shape];
            added.first_overlay = new_shape[group.first_overlay];
            added.end_overlay = new_shape[group.end_overlay];
            for (std::uint32_t& child : added.children) child += root;
            to_.groups.push_back(std::move(added));
        }
    }

    Style scaled(Style style) const {
        if (style.pen > 0) style.pen = std::max(style.pen * placement_.pen_scale, placement_.least_pen);
        return style;
    }

    // A polygon that several shapes show is placed once; all of them as a line, or none.
    Pieces pieces_of(std::uint32_t geometry, std::uint32_t polygon, bool is_open) {
        std::optional<Pieces>& known = pieces_[first_polygon_[geometry] + polygon];
        if (!known) known = placed(geometry, polygon, is_open);
        return *known;
    }

    Pieces placed(std::uint32_t geometry, std::uint32_t polygon, bool is_open) {
        const PolygonView view = (*from_.geometry[geometry])[polygon];
        if (view.ring_count() == 0) return {};
        const Polygons moved = keeps_geometry_ ? Polygons{} : mapped(view, placement_.transform, is_open);
        if (!keeps_geometry_ && moved.empty()) return {};
        const PolygonView here = keeps_geometry_ ? view : moved[0];
        const Clip::Side side = clip_ ? clip_->side_of(here) : Clip::Side::inside;
        if (side == Clip::Side::outside) return {};
        if (side == Clip::Side::inside && keeps_geometry_) {
            return {index_.index_of(from_.geometry[geometry]), polygon, polygon + 1, true};
        }
        const auto first = static_cast<std::uint32_t>(fresh_.size());
        if (side == Clip::Side::inside) {
            fresh_.add(here);
        } else if (is_open) {
            add_parts_inside(fresh_, here.outer(), clip_->border());
        } else {
            Polygons whole;
            whole.add(here);
            fresh_.add_all(intersect(whole, clip_->polygons()));
        }
        return {to_be_added, first, static_cast<std::uint32_t>(fresh_.size()), side == Clip::Side::inside};
    }

    // None where it leaves the plane.
    std::uint32_t placed_curve(std::uint32_t number) {
        std::optional<std::uint32_t>& known = new_curve_[number];
        if (known) return *known;
        Path moved = keeps_geometry_ ? from_.curves[number] : transformed(from_.curves[number], placement_.transform);
        known = DrawnShape::no_curve;
        if (is_on_plane(moved)) {
            known = static_cast<std::uint32_t>(to_.curves.size());
            to_.curves.push_back(std::move(moved));
        }
        return *known;
    }

    Drawing& to_;
    DrawingIndex& index_;
    const Drawing& from_;
    const Placement& placement_;
    const bool keeps_geometry_;
    std::optional<Clip> clip_;
    std::vector<std::size_t> first_polygon_;  // of each geometry of from_ in pieces_
    std::vector<std::optional<Pieces>> pieces_;
    std::vector<std::optional<std::uint32_t>> new_curve_;
    Polygons fresh_;
};

}  // namespace

DrawingPlacer::DrawingPlacer(Drawing& to) : to_(to), index_(std::make_unique<DrawingIndex>(to)) {}
DrawingPlacer::~DrawingPlacer() = default;

void DrawingPlacer::place(const Drawing& from, const Placement& placement) {
    if (from.groups.empty()) return;
    if (&to_ == &from) return place(Drawing(from), placement);
    index_->catch_up();
    Placing(to_, *index_, from, placement).place();
}

void place_drawing(Drawing& to, const Drawing& from, const Placement& placement) {
    DrawingPlacer(to).place(from, placement);
}

}  // namespace filigree
