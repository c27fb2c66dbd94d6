#include "engines/rewriting/draw.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "derivation/page_canvas.h"
#include "engines/rewriting/turtle_flat.h"
#include "engines/rewriting/word_solid.h"
#include "language/form_value.h"
#include "plane/clean.h"
#include "plane/moved_polygon.h"
#include "plane/transform.h"
#include "scene/drawn_pen.h"
#include "scene/solid_view.h"

namespace filigree::rewriting {
namespace {

constexpr double usual_side = 400;  // px

struct Extent {
    Vec low{1e300, 1e300}, high{-1e300, -1e300};

    void add(Vec p) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    bool is_empty() const { return low.x > high.x; }
};

class WordDrawer {
public:
    WordDrawer(const Derivation& derivation, const DrawRules& rules, const Settings& settings, const Document& document,
               StyleSheet sheet, const DrawOptions& options)
        : derivation_(derivation),
          word_(derivation.word),
          rules_(rules),
          settings_(settings),
          document_(document),
          styles_(derivation, rules, settings, std::move(sheet), options.root),
          options_(options),
          turtle_(turtle_settings(rules, derivation.iteration, settings, document, errors_)) {}

    Result<Picture> run() {
        if (const StyleOverride* common = styles_.common(); common != nullptr && !rules_.view) {
            Result<std::optional<FlatDrawing>> flat =
                flat_drawing(word_.symbols, derivation_.alphabet, turtle_, settings_.limits.elements);
            if (!flat) return flat.diagnostics();
            if (*flat) return draw_flat(**flat, *common);
        }
        const Result<TurtleDrawing> turtled = drawn_by_turtle();
        if (!turtled) return turtled.diagnostics();
        return rules_.view || leaves_wall(*turtled) ? draw_in_space(*turtled) : draw_in_wall(*turtled);
    }

    Result<WordSolid> solid() {
        const Result<TurtleDrawing> turtled = drawn_by_turtle();
        if (!turtled) return turtled.diagnostics();
        return word_solid(derivation_, *turtled, rules_, forms_, styles_);
    }

private:
    // --- styles ---

    std::uint32_t index_of(const Style& style) {
        if (!picture_.drawing.styles.empty() && picture_.drawing.styles[last_style_] == style) return last_style_;
        const auto found = std::find(picture_.drawing.styles.begin(), picture_.drawing.styles.end(), style);
        last_style_ = static_cast<std::uint32_t>(found - picture_.drawing.styles.begin());
        if (found == picture_.drawing.styles.end()) picture_.drawing.styles.push_back(style);
        return last_style_;
    }

    // With the forms that it places.
    Result<TurtleDrawing> drawn_by_turtle() {
        Result<TurtleDrawing> turtled = turtle_drawing(word_, derivation_.alphabet, turtle_, settings_.limits.elements);
        if (!turtled) return turtled;
        if (!errors_.empty() || !read_forms() || !has_room_for_forms(*turtled)) return errors_;
        return turtled;
    }

    // Placed shapes are counted before, their corners here.
    bool has_room_for_forms(const TurtleDrawing& turtled) {
        std::vector<std::uint64_t> times(turtled.shape_names.size());
        for (const TurtleShape& shape : turtled.shapes) ++times[shape.name];
        std::uint64_t corners = 0;
        for (std::size_t i = 0; i < times.size(); ++i) {
            corners += times[i] * forms_[form_number(turtled, static_cast<std::uint32_t>(i))].points.size();
        }
        constexpr std::uint64_t bytes_a_corner = 64;  // with what formats make of it
        if (corners <= settings_.limits.memory_bytes / bytes_a_corner) return true;
        errors_.push_back(
            fault(Fault::limit, "limit.memory",
                  "what the letters place has " + std::to_string(corners) + " corners, which takes too much memory"));
        return false;
    }

    // --- what letters place ---

    bool read_forms() {
        for (const PlacedForm& placed : rules_.forms) {
            Polygons polygons;
            if (placed.form.name == "box") {
                const double length = number_of(placed.form, "length"), half = number_of(placed.form, "breadth") / 2;
                for (const Vec p : {Vec{0, -half}, Vec{length, -half}, Vec{length, half}, Vec{0, half}}) {
                    polygons.points.push_back(snap(p));
                }
                polygons.end_ring();
                polygons.end_polygon();
            } else {
                const Result<std::shared_ptr<const ShapeOutlines>> outlines = options_.shapes->outlines(placed.form);
                if (!outlines) {
                    errors_ = with_span(outlines.diagnostics(), placed.span);
                    return false;
                }
                polygons = clean((*outlines)->lines, (*outlines)->rule);
                if (polygons.empty()) {
                    errors_.push_back(error("rewriting.empty-form",
                                            "'" + placed.form.name + "' encloses no area that could be placed",
                                            placed.span));
                    return false;
                }
            }
            forms_.push_back(std::move(polygons));
        }
        return true;
    }

    // From the form's coordinates, which have y downwards, to the page.
    static Transform transform_of(const TurtleShape& shape, const PagePlace& place) {
        const double s = shape.scale * place.scale;
        const Vec at = place(shape.position);
        const Frame& frame = shape.frame;
        return {s * frame.heading.x, -s * frame.heading.y, -s * frame.left.x, s * frame.left.y, at.x, at.y};
    }

    const Polygons& form_of(const TurtleDrawing& turtled, const TurtleShape& shape) const {
        return forms_[form_number(turtled, shape.name)];
    }

    // --- the page ---

    Extent extent_of(const TurtleDrawing& turtled) const {
        Extent extent;
        const PagePlace as_it_is;
        for (const TurtleSegment& segment : turtled.segments) {
            extent.add(as_it_is(segment.from));
            extent.add(as_it_is(segment.to));
        }
        for (const Vec3 corner : turtled.corners) extent.add(as_it_is(corner));
        for (const TurtleShape& shape : turtled.shapes) {
            const Box box = bounds(form_of(turtled, shape));
            const Transform to_page = transform_of(shape, as_it_is);
            for (const Point corner : {box.min, box.max, Point{box.min.x, box.max.y}, Point{box.max.x, box.min.y}}) {
                extent.add(filigree::apply(to_page, to_px(corner)));
            }
        }
        return extent;
    }
    // A page is filled, unless the document says how long a step is; one that fits is as large as drawings mostly are.
    PagePlace place_of(const Extent& extent) const {
        const Page& page = settings_.page;
        if (page.kind == PageStatement::Kind::tile || rules_.has_own_step || extent.is_empty()) return {};
        const double margin = page.margin.value_or(0);
        const bool fits = page.kind == PageStatement::Kind::fit;
        const Vec room = fits ? Vec{usual_side, usual_side} : Vec{page.width - 2 * margin, page.height - 2 * margin};
        const Vec size = extent.high - extent.low;
        if (!(room.x > 0 && room.y > 0) || !(std::max(size.x, size.y) > 0)) return {};
        PagePlace place;
        place.scale = std::min(size.x > 0 ? room.x / size.x : 1e300, size.y > 0 ? room.y / size.y : 1e300);
        place.offset = -0.5 * place.scale * (extent.low + extent.high);
        return place;
    }
    bool is_on_page(const Extent& extent, const PagePlace& place) {
        if (extent.is_empty()) return true;
        const Vec low = place.scale * extent.low + place.offset, high = place.scale * extent.high + place.offset;
        if (is_on_plane(low) && is_on_plane(high)) return true;
        errors_.push_back(fault(Fault::limit, "rewriting.too-far", "the word leads farther than 2^30 px away"));
        return false;
    }
    Result<Picture> finished(const Extent& extent, const PagePlace& place) {
        Diagnostics warnings;
        Box box{{0, 0}, {0, 0}};
        if (!extent.is_empty()) {
            box = {snap(place.scale * extent.low + place.offset), snap(place.scale * extent.high + place.offset)};
        }
        double pen = 0;
        for (const Style& style : picture_.drawing.styles) pen = has_stroke(style) ? std::max(pen, style.pen) : pen;
        const auto reach = static_cast<std::int64_t>(std::min(pen / 2, 0x1p20) * grid_per_px);
        if (settings_.page.kind == PageStatement::Kind::fit) {
            box = {{box.min.x - reach, box.min.y - reach}, {box.max.x + reach, box.max.y + reach}};
        }
        Drawing& drawing = picture_.drawing;
        drawing.canvas = page_canvas(settings_, document_, box, "lines", warnings);
        picture_.place = place;
        drawing.geometry = {std::make_shared<const Polygons>(std::move(geometry_))};
        drawing.groups = {{"word", 0, static_cast<std::uint32_t>(drawing.shapes.size()), 0, 0, {}}};
        return {std::move(picture_), std::move(warnings)};
    }

    // --- in space ---

    static bool leaves_wall(const TurtleDrawing& turtled) {
        const auto is_out = [](Vec3 p) { return std::fabs(p.z) > 1e-9; };
        const auto leans = [](const Frame& frame) {
            return std::fabs(frame.heading.z) > 1e-9 || std::fabs(frame.left.z) > 1e-9;
        };
        return std::any_of(turtled.segments.begin(), turtled.segments.end(),
                           [&](const TurtleSegment& s) { return is_out(s.from) || is_out(s.to); }) ||
               std::any_of(turtled.corners.begin(), turtled.corners.end(), is_out) ||
               std::any_of(turtled.shapes.begin(), turtled.shapes.end(),
                           [&](const TurtleShape& s) { return is_out(s.position) || leans(s.frame); });
    }

    Result<Picture> draw_in_space(const TurtleDrawing& turtled) {
        Result<WordSolid> solid = word_solid(derivation_, turtled, rules_, forms_, styles_);
        if (!solid) return solid.diagnostics();
        constexpr double farthest = 0x1p29;  // px: so that the view of it stays on the plane
        for (const Vec3 p : solid->mesh.vertices) {
            if (std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}) < farthest) continue;
            return fault(Fault::limit, "rewriting.too-far", "the word leads farther than 2^29 px away");
        }
        View view = rules_.view.value_or(View{});
        view.up = UpAxis::y;
        const Camera camera = camera_of(view, solid->mesh);
        Extent extent;
        for (const Vec3 p : solid->mesh.vertices) extent.add(projected(camera, seen_from(camera, p)));
        view.scale = place_of(extent).scale;
        for (MeshLine& line : solid->mesh.lines) line.width /= view.scale;  // pens stay as wide on the page
        SolidViewOptions options;
        options.margin = 0;
        options.path = "word";
        options.most_pieces = settings_.limits.elements;
        options.job = options_.job;
        Result<Drawing> drawing = solid_view(solid->mesh, solid->materials, view, options);
        if (!drawing) return drawing.diagnostics();
        Box box{{0, 0}, {0, 0}};
        if (settings_.page.kind == PageStatement::Kind::fit) {
            box = {snap(drawing->canvas.origin), snap(drawing->canvas.origin + drawing->canvas.size)};
        } else if (!extent.is_empty()) {
            box = {snap(view.scale * extent.low), snap(view.scale * extent.high)};
        }
        Diagnostics warnings;
        picture_.drawing = std::move(*drawing);
        picture_.drawing.canvas = page_canvas(settings_, document_, box, "lines", warnings);
        for (const DrawnShape& shape : picture_.drawing.shapes) {
            const auto symbol = solid->symbols.find(shape.key.value);
            picture_.symbols.push_back(symbol == solid->symbols.end() ? 0 : symbol->second);
        }
        picture_.is_in_space = true;
        return {std::move(picture_), std::move(warnings)};
    }

    // --- lines, faces ---

    void add_shape(const Style& style, Key key, std::uint64_t symbol) {
        picture_.drawing.shapes.push_back({0, static_cast<std::uint32_t>(geometry_.size() - 1), index_of(style), key});
        picture_.symbols.push_back(symbol);
    }
    void add_point(Point p, std::size_t first) {
        if (geometry_.points.size() == first || geometry_.points.back() != p) geometry_.points.push_back(p);
    }
    // The points from `first` on become a line; where all are one, a dot stays.
    void end_line(std::size_t first, const Look& look, Key key, std::uint64_t symbol) {
        if (geometry_.points.size() == first) return;
        if (!has_stroke(look.style)) {
            geometry_.points.resize(first);
            return;
        }
        if (geometry_.points.size() == first + 1) geometry_.points.push_back(geometry_.points.back());
        if (look.is_by_hand) {
            const std::vector<Point> line(geometry_.points.begin() + static_cast<std::ptrdiff_t>(first),
                                          geometry_.points.end());
            geometry_.points.resize(first);
            const Polygons strokes = drawn_stroke(line, false, look.style.pen, key);
            Style filled;
            filled.fill = look.style.stroke;
            for (std::size_t i = 0; i < strokes.size(); ++i) {
                geometry_.add(strokes[i]);
                add_shape(filled, key, symbol);
            }
            return;
        }
        geometry_.end_ring();
        geometry_.end_polygon();
        add_shape(look.style, key, symbol);
    }

    Result<Picture> draw_flat(const FlatDrawing& flat, const StyleOverride& over) {
        Extent extent;
        for (const FlatRun& run : flat.runs) {
            for (const Vec p : flat.points().subspan(run.first, run.count)) extent.add({p.x, -p.y});
        }
        const PagePlace place = place_of(extent);
        if (!is_on_page(extent, place)) return errors_;
        geometry_.points.reserve(flat.point_count);
        for (std::size_t r = 0; r < flat.runs.size(); ++r) {
            const FlatRun& run = flat.runs[r];
            const Look look = styles_.look_of(Drawn::line, run.width, run.colour, over);
            const std::size_t first = geometry_.points.size();
            for (const Vec p : flat.points().subspan(run.first, run.count))
                add_point(snap(place({p.x, p.y, 0})), first);
            end_line(first, look, child(options_.root, r), 0);
        }
        picture_.symbols.clear();
        return finished(extent, place);
    }

    Result<Picture> draw_in_wall(const TurtleDrawing& turtled) {
        const Extent extent = extent_of(turtled);
        const PagePlace place = place_of(extent);
        if (!is_on_page(extent, place)) return errors_;
        std::vector<TurtlePolygon> polygons = turtled.polygons;  // in the order in which they begin
        std::sort(polygons.begin(), polygons.end(),
                  [](const TurtlePolygon& a, const TurtlePolygon& b) { return a.symbol < b.symbol; });
        auto polygon = polygons.begin();
        auto shape = turtled.shapes.begin();
        const auto next_polygon = [&] { return polygon != polygons.end() ? polygon->symbol : UINT64_MAX; };
        const auto next_shape = [&] { return shape != turtled.shapes.end() ? shape->symbol : UINT64_MAX; };
        const auto next_other = [&] { return std::min(next_polygon(), next_shape()); };
        const auto draw_others_before = [&](std::uint64_t symbol) {
            while (next_other() < symbol) {
                if (next_polygon() < next_shape()) {
                    draw_polygon(turtled, *polygon++, place);
                } else {
                    draw_shape(turtled, *shape++, place);
                }
            }
        };
        // The line that is being drawn.
        std::size_t first = geometry_.points.size();
        Look look;
        Key key;
        std::uint64_t symbol = 0;
        Vec3 at;
        std::uint64_t done = 0;
        for (const TurtleSegment& segment : turtled.segments) {
            if ((++done & 0xFFFF) == 0 && is_cancelled(options_.job)) return cancelled_diagnostic();
            const bool is_interrupted = next_other() < segment.symbol;
            if (is_interrupted) {
                end_line(first, look, key, symbol);
                draw_others_before(segment.symbol);
                first = geometry_.points.size();
            }
            const Look now =
                styles_.look_of(Drawn::line, {segment.symbol, segment.width, segment.colour, segment.from});
            if (!styles_.errors.empty()) return styles_.errors;
            const bool goes_on = !is_interrupted && geometry_.points.size() > first && segment.from == at &&
                                 now.style == look.style && now.is_by_hand == look.is_by_hand;
            if (!goes_on) {
                end_line(first, look, key, symbol);
                first = geometry_.points.size();
                look = now;
                key = styles_.key_of(segment.symbol);
                symbol = segment.symbol;
                add_point(snap(place(segment.from)), first);
            }
            add_point(snap(place(segment.to)), first);
            at = segment.to;
        }
        end_line(first, look, key, symbol);
        draw_others_before(UINT64_MAX);
        if (!styles_.errors.empty()) return styles_.errors;
        return finished(extent, place);
    }

    void draw_polygon(const TurtleDrawing& turtled, const TurtlePolygon& polygon, const PagePlace& place) {
        const Look look = styles_.look_of(
            Drawn::face, {polygon.symbol, polygon.width, polygon.colour, turtled.corners[polygon.first]});
        std::vector<Point> ring;
        for (std::uint64_t i = 0; i < polygon.count; ++i)
            ring.push_back(snap(place(turtled.corners[polygon.first + i])));
        add_faces(clean(std::vector<std::vector<Point>>{std::move(ring)}, FillRule::nonzero), look, polygon.symbol);
    }
    void draw_shape(const TurtleDrawing& turtled, const TurtleShape& shape, const PagePlace& place) {
        const Look look = styles_.look_of(Drawn::face, {shape.symbol, shape.width, shape.colour, shape.position});
        const Polygons& form = form_of(turtled, shape);
        const Transform to_page = transform_of(shape, place);
        Polygons moved, placed;
        for (std::size_t i = 0; i < form.size(); ++i) {
            moved = {};
            for (std::size_t r = 0; r < form[i].ring_count(); ++r) {
                for (const Point p : form[i].ring(r)) moved.points.push_back(snap(filigree::apply(to_page, to_px(p))));
                moved.end_ring();
            }
            moved.end_polygon();
            add_moved(placed, moved[0], determinant(to_page) < 0);
        }
        add_faces(placed, look, shape.symbol);
    }
    void add_faces(const Polygons& faces, const Look& look, std::uint64_t symbol) {
        if (!has_fill(look.style) && !has_stroke(look.style)) return;
        for (std::size_t i = 0; i < faces.size(); ++i) {
            geometry_.add(faces[i]);
            add_shape(look.style, child(styles_.key_of(symbol), i), symbol);
        }
    }

    const Derivation& derivation_;
    const Word& word_;
    const DrawRules& rules_;
    const Settings& settings_;
    const Document& document_;
    WordStyles styles_;
    const DrawOptions& options_;
    std::vector<Polygons> forms_;  // of rules_.forms
    Picture picture_;
    Polygons geometry_;
    std::uint32_t last_style_ = 0;
    Diagnostics errors_;
    const TurtleSettings turtle_;  // tells its errors in those
};

}  // namespace

TurtleSettings turtle_settings(const DrawRules& rules, std::uint32_t iteration, const Settings& settings,
                               const Document& document, Diagnostics& problems) {
    TurtleSettings turtle = rules.turtle;
    if (!rules.formula) return turtle;
    turtle.formula = [&rules, iteration, &settings, &document, &problems](const AngleFacts& facts) {
        Scope scope;
        scope.outer = &settings.globals;
        const auto bare = [](double value) { return Value{Quantity{value}, {}}; };
        const auto length_value = [](double px) { return Value{Quantity{px, 1, false}, {}}; };
        scope.names = {{"k", bare(static_cast<double>(facts.k))},
                       {"t", bare(iteration)},
                       {"depth", bare(static_cast<double>(facts.depth))},
                       {"age", bare(facts.age)},
                       {"x", length_value(facts.x)},
                       {"y", length_value(facts.y)},
                       {"z", length_value(facts.z)}};
        Evaluation at;
        at.document = &document;
        at.scope = &scope;
        const Result<Value> value = evaluate(*rules.formula, at);
        const Result<double> angle = value ? as_angle(*value) : Result<double>(value.diagnostics());
        if (angle) return *angle;
        if (problems.empty()) problems = angle.diagnostics();
        return 0.0;
    };
    return turtle;
}

Result<Picture> draw(const Derivation& derivation, const DrawRules& rules, const Settings& settings,
                     const Document& document, const DrawOptions& options) {
    Result<StyleSheet> sheet = read_styles(settings, document);
    if (!sheet) return sheet.diagnostics();
    return WordDrawer(derivation, rules, settings, document, std::move(*sheet), options).run();
}

Result<WordSolid> draw_solid(const Derivation& derivation, const DrawRules& rules, const Settings& settings,
                             const Document& document, const DrawOptions& options) {
    Result<StyleSheet> sheet = read_styles(settings, document);
    if (!sheet) return sheet.diagnostics();
    return WordDrawer(derivation, rules, settings, document, std::move(*sheet), options).solid();
}

}  // namespace filigree::rewriting
