#include "scene/by_hand.h"

#include <algorithm>
#include <array>
#include <bit>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "plane/border_map.h"
#include "scene/drawn_pen.h"

namespace filigree {
namespace {

constexpr std::uint32_t none = UINT32_MAX;

struct InkedStroke {
    std::uint32_t group = 0;
    std::uint32_t rank = 0;  // of the shape that it strokes, in the order of painting
    DrawnShape shape;
};

class HandDrawer {
public:
    HandDrawer(Drawing& drawing, const std::vector<HandShape>& shapes, std::uint64_t seed)
        : drawing_(drawing), shapes_(shapes), seed_(seed) {}

    void draw() {
        move_lines();
        const bool has_pens =
            std::any_of(shapes_.begin(), shapes_.end(), [this](const HandShape& shape) { return is_penned(shape); });
        if (!has_pens) return;
        read_order();
        draw_borders();
        draw_marks();
        put_strokes();
    }

private:
    const Style& style_of(const HandShape& shape) const { return drawing_.styles[drawing_.shapes[shape.shape].style]; }
    bool has_stroke(const HandShape& shape) const {
        return shape.shape != HandShape::not_drawn && style_of(shape).stroke && style_of(shape).pen > 0;
    }
    bool is_penned(const HandShape& shape) const { return shape.style.has_drawn_line && has_stroke(shape); }

    // --- geometry ---

    void move_lines() {
        PerturbInput input;
        input.seed = seed_;
        const auto list_of = [&](HandRole role) -> std::pair<WobblyShapes&, std::vector<std::uint32_t>&> {
            if (role == HandRole::face) return {input.faces, faces_};
            if (role == HandRole::border) return {input.borders, borders_};
            return {input.marks, marks_};
        };
        for (std::uint32_t i = 0; i < shapes_.size(); ++i) {
            const HandShape& shape = shapes_[i];
            const auto [list, indices] = list_of(shape.role);
            list.polygons.add((*drawing_.geometry[shape.geometry])[shape.polygon]);
            list.wobbles.push_back(shape.shape == HandShape::not_drawn ? follows_neighbours : shape.style.wobble);
            indices.push_back(i);
        }
        Perturbed moved = perturb(input);
        use(std::move(moved.faces), faces_);
        use(std::move(moved.borders), borders_);
        use(std::move(moved.marks), marks_);
    }

    void use(Polygons polygons, const std::vector<std::uint32_t>& indices) {
        if (polygons.empty()) return;
        for (std::uint32_t polygon = 0; polygon < indices.size(); ++polygon) {
            const HandShape& shape = shapes_[indices[polygon]];
            if (shape.shape == HandShape::not_drawn) continue;
            drawing_.shapes[shape.shape].geometry = static_cast<std::uint32_t>(drawing_.geometry.size());
            drawing_.shapes[shape.shape].polygon = polygon;
            // Faces that do not waver hold their place; borders follow the faces.
            const bool may_move = shape.role == HandRole::border || shape.style.wobble.amplitude > 0;
            if (may_move) drawing_.shapes[shape.shape].curve = DrawnShape::no_curve;
        }
        drawing_.geometry.push_back(std::make_shared<const Polygons>(std::move(polygons)));
    }

    PolygonView polygon_of(const HandShape& shape) const {
        return filigree::polygon_of(drawing_, drawing_.shapes[shape.shape]);
    }

    // --- where things stand ---

    void read_order() {
        ranks_.assign(drawing_.shapes.size(), 0);
        groups_of_.assign(drawing_.shapes.size(), 0);
        std::uint32_t rank = 0;
        for (const PaintStep& step : painting_steps(drawing_)) {
            if (step.kind != PaintStep::Kind::shapes) continue;
            for (std::uint32_t s = step.first; s < step.end; ++s) {
                ranks_[s] = rank++;
                groups_of_[s] = step.group;
            }
        }
        parents_.assign(drawing_.groups.size(), 0);
        depths_.assign(drawing_.groups.size(), 0);
        for (std::uint32_t g = 0; g < drawing_.groups.size(); ++g) {
            for (const std::uint32_t child : drawing_.groups[g].children) {
                parents_[child] = g;
                depths_[child] = depths_[g] + 1;
            }
        }
    }

    // The group that holds both.
    std::uint32_t common_group(std::uint32_t a, std::uint32_t b) const {
        if (a == none || b == none) return a == none ? b : a;
        while (a != b) {
            if (depths_[a] < depths_[b]) std::swap(a, b);
            a = parents_[a];
        }
        return a;
    }

    // --- strokes ---

    // Faces and borders as a map: their edges, and which shape strokes each.
    void draw_borders() {
        Polygons all;
        std::vector<std::uint32_t> drawn;
        for (std::uint32_t i = 0; i < shapes_.size(); ++i) {
            if (shapes_[i].role == HandRole::mark || shapes_[i].shape == HandShape::not_drawn) continue;
            all.add(polygon_of(shapes_[i]));
            drawn.push_back(i);
        }
        std::vector<std::uint32_t> in_order(drawn.size());
        for (std::uint32_t p = 0; p < in_order.size(); ++p) in_order[p] = p;
        std::sort(in_order.begin(), in_order.end(), [&](std::uint32_t a, std::uint32_t b) {
            return ranks_[shapes_[drawn[a]].shape] < ranks_[shapes_[drawn[b]].shape];
        });
        const BorderMap map = border_map(all);
        std::vector<std::uint32_t> strokers(map.edges.size(), none), groups(map.edges.size(), none);
        for (const std::uint32_t p : in_order) {
            const HandShape& shape = shapes_[drawn[p]];
            const std::uint32_t group = groups_of_[shape.shape];
            for (const std::uint32_t side : map.sides_of(p)) {
                if (side == BorderMap::none) continue;
                const std::uint32_t edge = BorderMap::edge_of(side);
                groups[edge] = common_group(groups[edge], group);
                if (has_stroke(shape) && is_over(drawn[p], strokers[edge])) strokers[edge] = drawn[p];
            }
        }
        std::vector<std::uint32_t> pens(map.edges.size(), no_pen);
        for (std::size_t e = 0; e < pens.size(); ++e) {
            if (strokers[e] != none && shapes_[strokers[e]].style.has_drawn_line)
                pens[e] = pen_of(shapes_[strokers[e]]);
        }
        std::vector<Point> line;
        for (const PenPath& path : pen_paths(map, pens)) {
            std::uint32_t group = none, rank = 0;
            for (const std::uint32_t edge : path.edges) {
                group = common_group(group, groups[edge]);
                rank = std::max(rank, ranks_[shapes_[strokers[edge]].shape]);
            }
            line.clear();
            for (const std::uint32_t v : path.vertices) line.push_back(map.vertices[v]);
            const Style pen = drawing_.styles[pens[path.edges[0]]];
            add_stroke(line, path.is_closed, pen, group, rank);
        }
    }

    // Marks stroke their own rings.
    void draw_marks() {
        for (const std::uint32_t i : marks_) {
            if (!is_penned(shapes_[i])) continue;
            const PolygonView polygon = polygon_of(shapes_[i]);
            for (std::size_t r = 0; r < polygon.ring_count(); ++r) {
                const Style pen = style_of(shapes_[i]);
                add_stroke(polygon.ring(r), true, pen, groups_of_[shapes_[i].shape], ranks_[shapes_[i].shape]);
            }
        }
    }

    // Whether a shape's stroke is seen where one painted before it runs, too.
    bool is_over(std::uint32_t later, std::uint32_t earlier) const {
        if (earlier == none) return true;
        const Style& over = style_of(shapes_[later]);
        const Style& under = style_of(shapes_[earlier]);
        return over.stroke != under.stroke || over.pen >= under.pen;
    }

    // One pen a colour and width.
    std::uint32_t pen_of(const HandShape& shape) {
        Style pen;
        pen.stroke = style_of(shape).stroke;
        pen.pen = style_of(shape).pen;
        return index_of(pen);
    }

    std::uint32_t index_of(const Style& style) {
        for (; known_styles_ < drawing_.styles.size(); ++known_styles_) {
            styles_.emplace(words_of(drawing_.styles[known_styles_]), static_cast<std::uint32_t>(known_styles_));
        }
        const auto [known, is_new] = styles_.emplace(words_of(style), static_cast<std::uint32_t>(known_styles_));
        if (is_new) {
            drawing_.styles.push_back(style);
            ++known_styles_;
        }
        return known->second;
    }

    using Words = std::array<std::uint64_t, 4>;
    static std::uint64_t word_of(const std::optional<Colour>& colour) {
        if (!colour) return UINT64_MAX;
        return std::uint64_t{colour->red} << 24 | std::uint64_t{colour->green} << 16 |
               std::uint64_t{colour->blue} << 8 | colour->alpha;
    }
    static Words words_of(const Style& style) {
        return {word_of(style.fill), word_of(style.stroke), std::bit_cast<std::uint64_t>(style.pen),
                static_cast<std::uint64_t>(style.corner) | (style.is_open ? 16U : 0U)};
    }

    // Its key hangs on its ends alone, so that it stays as it is when other lines meet it on the way.
    void add_stroke(std::span<const Point> line, bool is_closed, const Style& pen, std::uint32_t group,
                    std::uint32_t rank) {
        const auto word = [](Point p) {
            return fold(static_cast<std::uint64_t>(p.x), static_cast<std::uint64_t>(p.y));
        };
        const Key key = child(child(Key{word(line.front())}, is_closed ? 0 : word(line.back())), "stroke");
        const Polygons outline = drawn_stroke(line, is_closed, pen.pen, child(key, seed_));
        Style style;
        style.fill = pen.stroke;
        const std::uint32_t ink = index_of(style);
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const DrawnShape shape{static_cast<std::uint32_t>(drawing_.geometry.size()),
                                   static_cast<std::uint32_t>(outlines_.size()), ink, key};
            outlines_.add(outline[i]);
            strokes_.push_back({group, rank, shape});
        }
    }

    // Strokes come before the overlay of their group; what they draw is no longer stroked.
    void put_strokes() {
        std::sort(strokes_.begin(), strokes_.end(), [this](const InkedStroke& a, const InkedStroke& b) {
            if (a.group != b.group) return a.group < b.group;
            if (a.rank != b.rank) return a.rank < b.rank;
            const Point p = outlines_[a.shape.polygon].outer()[0], q = outlines_[b.shape.polygon].outer()[0];
            return p != q ? p < q : a.shape.polygon < b.shape.polygon;
        });
        drawing_.geometry.push_back(std::make_shared<const Polygons>(std::move(outlines_)));
        std::vector<std::uint8_t> is_bare(drawing_.shapes.size(), 0);
        for (const HandShape& shape : shapes_) {
            if (!is_penned(shape)) continue;
            Style style = style_of(shape);
            style.stroke.reset();
            if (!style.fill) is_bare[shape.shape] = 1;
            bare_.push_back({shape.shape, style});
        }
        for (const auto& [shape, style] : bare_) drawing_.shapes[shape].style = index_of(style);

        std::vector<DrawnShape> kept;
        const auto keep = [&](std::uint32_t& first, std::uint32_t& end, auto add_before) {
            const auto start = static_cast<std::uint32_t>(kept.size());
            add_before();
            for (std::uint32_t s = first; s < end; ++s) {
                if (is_bare[s] == 0) kept.push_back(drawing_.shapes[s]);
            }
            first = start;
            end = static_cast<std::uint32_t>(kept.size());
        };
        for (DrawingGroup& group : drawing_.groups) keep(group.first_shape, group.end_shape, [] {});
        auto stroke = strokes_.begin();
        for (std::uint32_t g = 0; g < drawing_.groups.size(); ++g) {
            keep(drawing_.groups[g].first_overlay, drawing_.groups[g].end_overlay, [&] {
                for (; stroke != strokes_.end() && stroke->group == g; ++stroke) kept.push_back(stroke->shape);
            });
        }
        drawing_.shapes = std::move(kept);
    }

    Drawing& drawing_;
    const std::vector<HandShape>& shapes_;
    const std::uint64_t seed_;
    std::vector<std::uint32_t> faces_, borders_, marks_;  // indices in shapes_, as they were perturbed
    std::vector<std::uint32_t> ranks_, groups_of_;        // of each shape of the drawing
    std::vector<std::uint32_t> parents_, depths_;         // of each group
    std::map<Words, std::uint32_t> styles_;               // of the drawing, as far as they are known
    std::size_t known_styles_ = 0;
    Polygons outlines_;
    std::vector<InkedStroke> strokes_;
    std::vector<std::pair<std::uint32_t, Style>> bare_;
};

}  // namespace

void draw_by_hand(Drawing& drawing, const std::vector<HandShape>& shapes, std::uint64_t seed) {
    const bool are_plain =
        std::all_of(shapes.begin(), shapes.end(), [](const HandShape& shape) { return shape.style.is_plain(); });
    if (!are_plain) HandDrawer(drawing, shapes, seed).draw();
}

}  // namespace filigree
