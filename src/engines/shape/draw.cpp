#include "engines/shape/draw.h"

#include "engines/shape/paths.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "curves/path_elements.h"
#include "derivation/page_canvas.h"
#include "language/quantity.h"
#include "language/style.h"
#include "scene/contact_sheet.h"
#include "scene/curves.h"
#include "scene/lettering.h"

namespace filigree::shape {
namespace {

using curves::Element;
using curves::ElementKind;

// A design that fits its page and is smaller than this is enlarged to the other: shapes are often written in units.
constexpr double smallest_px = 100, enlarged_px = 400;

constexpr Colour ink{0, 0, 0, 255}, construction{120, 132, 150, 255}, accent{200, 60, 40, 255};

// As far apart as hues can be, one after another.
Colour hue(std::uint32_t number) {
    static constexpr Colour hues[] = {{214, 69, 65, 150},  {44, 120, 190, 150}, {240, 160, 40, 150},
                                      {60, 160, 90, 150},  {150, 80, 180, 150}, {20, 165, 165, 150},
                                      {200, 90, 150, 150}, {110, 110, 60, 150}};
    return hues[number % 8];
}

double scale_of(const curves::Bounds& box, const Settings& settings, const Document& document) {
    const Unit unit = unit_of(document);
    const double size = std::max(box.max.x - box.min.x, box.max.y - box.min.y);
    const bool has_size = settings.page.kind != PageStatement::Kind::fit || unit != Unit::px;
    if (has_size || !(size > 0) || size >= smallest_px) return 1;
    // What lies far off stays on the plane.
    const double scale = enlarged_px / size;
    const double far = std::max({-box.min.x, -box.min.y, box.max.x, box.max.y});
    return scale * far > 0x1p29 ? 1 : scale;
}

// A design with the states that its elements came with.
struct Frame {
    const Derivation* derivation = nullptr;  // whose states; null where all came with the start
    const curves::Shape& design;
    const std::vector<std::uint32_t>& made_by;
    std::string label;
};

// Draws one design into a drawing.
class Painter {
public:
    Painter(const Grammar& grammar, const Surroundings& around, const StyleSheet& sheet, double scale, Key root)
        : grammar_(grammar), around_(around), sheet_(sheet), scale_(scale), root_(root) {
        drawing.groups.push_back({grammar.start_tag, 0, 0, 0, 0, {}});
    }

    Drawing drawing;
    std::vector<std::vector<std::uint32_t>> elements;
    Diagnostics errors;

    void paint(const Frame& frame) {
        std::map<std::uint32_t, std::vector<std::uint32_t>> by_state;
        for (std::uint32_t i = 0; i < frame.made_by.size(); ++i) by_state[frame.made_by[i]].push_back(i);
        for (const auto& [state, own] : by_state) {
            begin_group(state == 0 ? "" : path_of_state(*frame.derivation, grammar_, state));
            const std::string& rule =
                state == 0 ? grammar_.start_tag : grammar_.rules[frame.derivation->steps[state - 1].rule].name;
            paint_state(frame.design, own, state, rule);
            end_group();
        }
    }

    void paint_marks(const curves::Shape& design) {
        const Show& show = grammar_.show;
        if (!show.control_polygons && !show.points && !show.labels && !show.dots) return;
        begin_group("marks");
        const double pen = 0.6;
        for (std::size_t i = 0; i < design.elements.size(); ++i) {
            const Element& e = design.elements[i];
            const Key key = child(child(root_, "mark"), i);
            if (show.control_polygons) paint_control_polygon(e, key, pen);
            if (show.points && e.kind != ElementKind::point && !is_closed(e)) {
                const auto [from, to] = ends_of(e);
                for (const Vec end : {from, to}) paint_dot(end, 1.8, ink, key);
            }
            if (show.dots && e.kind == ElementKind::point) paint_dot(e.at[0], 2.5, ink, key);
            if (show.labels && e.kind == ElementKind::point) {
                paint_dot(e.at[0], 2, accent, key);
                paint_text(label_of(grammar_, e.layer), e.at[0] * scale_ + Vec{4, -4}, 8, accent, key);
            }
        }
        end_group();
    }

    void paint_application(const Application& at, std::uint32_t number) {
        const Rule& rule = grammar_.rules[at.rule];
        begin_group("match/" + rule.name + "[" + std::to_string(number) + "]");
        Style style;
        style.stroke = hue(number - 1);
        style.pen = 6;
        const curves::Shape covered = placed(rule.left, rule, at, grammar_.tolerance);
        const Key key = child(child(root_, "match"), number);
        for (const curves::JoinedPath& joined : paths_of(covered.elements, 2 * grammar_.tolerance)) {
            add(joined.path, style, key, {});
        }
        for (const Element& e : covered.elements) {
            if (e.kind == ElementKind::point) paint_dot(e.at[0], 5, hue(number - 1), key);
        }
        Colour dark = hue(number - 1);
        dark.alpha = 255;
        const std::string text = std::to_string(number);
        paint_text(text, at.place * scale_ + Vec{-0.5 * lettering_width(text, 10), 5}, 10, dark, key);
        end_group();
    }

private:
    void begin_group(std::string path) {
        const auto shape = static_cast<std::uint32_t>(drawing.shapes.size());
        if (path.empty()) {
            current_ = 0;
            drawing.groups[0].first_shape = shape;
            return;
        }
        current_ = static_cast<std::uint32_t>(drawing.groups.size());
        drawing.groups.push_back({std::move(path), shape, shape, shape, shape, {}});
        drawing.groups[0].children.push_back(current_);
    }
    void end_group() { drawing.groups[current_].end_shape = static_cast<std::uint32_t>(drawing.shapes.size()); }

    // What came with one state: joined where colour and weight are the same.
    void paint_state(const curves::Shape& design, const std::vector<std::uint32_t>& members, std::uint32_t state,
                     const std::string& tag) {
        std::vector<Element> own;
        std::vector<std::uint32_t> numbers;
        for (const std::uint32_t i : members) {
            const Element& e = design.elements[i];
            if (e.kind == ElementKind::point) continue;
            own.push_back(e);
            numbers.push_back(i);
        }
        const TagStyle of_tag = style_of_tag(sheet_, tag);
        const Key group = child(child(root_, "state"), state);
        std::uint64_t number = 0;
        for (const curves::JoinedPath& joined : paths_of(own, 2 * grammar_.tolerance)) {
            std::vector<std::uint32_t> shown;
            for (const std::uint32_t i : joined.joined) shown.push_back(numbers[i]);
            const Element& first = own[joined.joined.front()];
            const Key key = child(group, number++);
            add(joined.path, look_of(of_tag, first, state, key), key, std::move(shown));
        }
    }

    Style look_of(const TagStyle& of_tag, const Element& e, std::uint32_t state, Key key) {
        StyleOverride over = of_tag.common;
        if (!of_tag.is_constant) {
            Scope scope;
            scope.outer = &around_.settings.globals;
            const Vec middle = point_at(e, 0.5 * (interval_of(e).from + interval_of(e).to));
            scope.names["weight"] = {Quantity{e.weight, 0, false}, {}};
            scope.names["step"] = {Quantity{static_cast<double>(state), 0, false}, {}};
            scope.names["x"] = {Quantity{middle.x, 1, false}, {}};
            scope.names["y"] = {Quantity{middle.y, 1, false}, {}};
            scope.names["length"] = {Quantity{length_of(e), 1, false}, {}};
            Result<StyleOverride> found = style_of_shape(sheet_, of_tag, scope, key);
            if (!found) {
                if (errors.empty()) errors = found.diagnostics();
            } else {
                over = *found;
            }
        }
        Style style;
        style.stroke = ink;
        style.pen = 1.5;
        if (over.fill) style.fill = *over.fill;
        if (over.stroke) style.stroke = *over.stroke;
        if (over.pen) style.pen = *over.pen;
        if (over.corner) style.corner = *over.corner;
        if (const auto colour = colour_of_layer(e.layer)) style.stroke = *colour;
        style.pen *= e.weight;
        return style;
    }

    void add(const Path& path, const Style& style, Key key, std::vector<std::uint32_t> shown) {
        const Path larger = scale_ == 1 ? path : transformed(path, scaling(scale_, scale_));
        add_curve(drawing, larger, style, key, around_.settings.resolution);
        elements.resize(drawing.shapes.size(), shown);
    }

    void paint_control_polygon(const Element& e, Key key, double pen) {
        if (e.kind != ElementKind::parabola && e.kind != ElementKind::cubic) return;
        const std::size_t count = e.kind == ElementKind::parabola ? 3 : 4;
        Path path;
        for (std::size_t i = 0; i < count; ++i) {
            path.verbs.push_back(i == 0 ? Verb::move : Verb::line);
            path.points.push_back(e.at[i]);
        }
        Style style;
        style.stroke = construction;
        style.pen = pen;
        add(path, style, key, {});
        for (std::size_t i = 0; i < count; ++i) paint_dot(e.at[i], 1.6, construction, key);
    }

    // A dot on the page: `radius` in px there.
    void paint_dot(Vec at, double radius, Colour colour, Key key) {
        const Vec centre = at * scale_, right = centre + Vec{radius, 0}, left = centre - Vec{radius, 0};
        Path path;
        path.verbs = {Verb::move, Verb::arc, Verb::arc, Verb::close};
        path.points = {right, {radius, radius}, {0, 2}, left, {radius, radius}, {0, 2}, right};
        Style style;
        style.fill = colour;
        add_curve(drawing, path, style, key, around_.settings.resolution);
        elements.resize(drawing.shapes.size());
    }

    void paint_text(std::string_view text, Vec at, double height, Colour colour, Key key) {
        auto letters = std::make_shared<Polygons>(lettering(text, at, {height, 0.12 * height}));
        Style style;
        style.fill = colour;
        drawing.styles.push_back(style);
        const auto geometry = static_cast<std::uint32_t>(drawing.geometry.size());
        for (std::uint32_t i = 0; i < letters->size(); ++i) {
            DrawnShape shape;
            shape.geometry = geometry;
            shape.polygon = i;
            shape.style = static_cast<std::uint32_t>(drawing.styles.size() - 1);
            shape.key = key;
            drawing.shapes.push_back(shape);
        }
        drawing.geometry.push_back(std::move(letters));
        elements.resize(drawing.shapes.size());
    }

    const Grammar& grammar_;
    const Surroundings& around_;
    const StyleSheet& sheet_;
    const double scale_;
    const Key root_;
    std::uint32_t current_ = 0;
};

Box grid_box(const curves::Bounds& box, double scale) {
    Box grid;
    if (box.min.x > box.max.x) return grid;
    filigree::extend(grid, snap(box.min * scale));
    filigree::extend(grid, snap(box.max * scale));
    return grid;
}

Diagnostic nothing_drawn() { return error("shape.nothing-drawn", "the design is empty, so there is nothing to draw"); }

// Frames side by side, all to one scale and in place, so that what moved is seen to have moved.
class SheetPainter {
public:
    SheetPainter(const Grammar& grammar, const Surroundings& around, StyleSheet sheet, const curves::Bounds& box)
        : grammar_(grammar), around_(around), sheet_(std::move(sheet)), box_(box) {
        scale_ = enlarged_px / std::max({box.max.x - box.min.x, box.max.y - box.min.y, 1e-9});
    }

    Diagnostics errors;

    void add(const Frame& frame, Key root) {
        Painter painter(grammar_, around_, sheet_, scale_, root);
        painter.paint(frame);
        painter.paint_marks(frame.design);
        if (errors.empty()) errors = painter.errors;
        fit_canvas(painter.drawing.canvas, grid_box(box_, scale_), around_.settings.page.margin);
        drawings_.push_back(std::move(painter.drawing));
        labels_.push_back(frame.label);
    }

    Drawing sheet(std::uint32_t columns) const {
        std::vector<SheetCell> cells;
        for (std::size_t i = 0; i < drawings_.size(); ++i) cells.push_back({&drawings_[i], labels_[i]});
        SheetOptions options;
        options.columns = columns;
        return contact_sheet(cells, options);
    }

private:
    const Grammar& grammar_;
    const Surroundings& around_;
    const StyleSheet sheet_;
    const curves::Bounds box_;
    double scale_ = 1;
    std::vector<Drawing> drawings_;
    std::vector<std::string> labels_;
};

// All states on the way to where a derivation stands.
Result<Drawing> draw_film(const Derivation& derivation, const Grammar& grammar, const Surroundings& around,
                          StyleSheet sheet, const DrawOptions& options) {
    const std::vector<std::uint32_t> way = way_to(derivation, derivation.state);
    Derivation at = derivation;
    curves::Bounds box;
    for (const std::uint32_t state : way) {
        go_to(at, state);
        extend(box, bounds_of(at.design.elements));
    }
    if (box.min.x > box.max.x) return nothing_drawn();
    SheetPainter painter(grammar, around, std::move(sheet), box);
    for (std::size_t i = 0; i < way.size(); ++i) {
        if (is_cancelled(options.job)) return cancelled_diagnostic();
        go_to(at, way[i]);
        const std::string label =
            i == 0 ? grammar.start_tag
                   : std::to_string(i) + "  " + grammar.rules[derivation.steps[way[i] - 1].rule].name;
        painter.add({&at, at.design, at.made_by, label}, child(options.root, i));
        if (!painter.errors.empty()) return painter.errors;
    }
    return painter.sheet(*grammar.show.film);
}

}  // namespace

Result<Drawing> draw_sheet(const std::vector<curves::Shape>& designs, const std::vector<std::string>& labels,
                           const Grammar& grammar, const Surroundings& around, std::uint32_t columns,
                           const DrawOptions& options) {
    Result<StyleSheet> sheet = read_styles(around.settings, around.document);
    if (!sheet) return sheet.diagnostics();
    curves::Bounds box;
    for (const curves::Shape& design : designs) extend(box, bounds_of(design.elements));
    if (box.min.x > box.max.x) return nothing_drawn();
    SheetPainter painter(grammar, around, std::move(*sheet), box);
    for (std::size_t i = 0; i < designs.size(); ++i) {
        if (is_cancelled(options.job)) return cancelled_diagnostic();
        const std::vector<std::uint32_t> of_start(designs[i].elements.size(), 0);
        painter.add({nullptr, designs[i], of_start, labels[i]}, child(options.root, i));
        if (!painter.errors.empty()) return painter.errors;
    }
    return painter.sheet(columns);
}

namespace {

// The design itself, with the applications that are shown over it.
Result<Picture> draw_design(const Derivation& derivation, const Grammar& grammar, const Surroundings& around,
                            StyleSheet sheet, const std::vector<Application>& shown, const DrawOptions& options) {
    curves::Bounds box;
    extend(box, bounds_of(derivation.design.elements));
    if (box.min.x > box.max.x) return nothing_drawn();
    Picture picture;
    picture.scale = scale_of(box, around.settings, around.document);
    Painter painter(grammar, around, sheet, picture.scale, options.root);
    painter.paint({&derivation, derivation.design, derivation.made_by, {}});
    painter.paint_marks(derivation.design);
    for (std::uint32_t i = 0; i < shown.size(); ++i) painter.paint_application(shown[i], i + 1);
    if (!painter.errors.empty()) return painter.errors;
    picture.drawing = std::move(painter.drawing);
    picture.elements = std::move(painter.elements);
    Diagnostics warnings;
    picture.drawing.canvas =
        page_canvas(around.settings, around.document, grid_box(box, picture.scale), "curves", warnings);
    return {std::move(picture), std::move(warnings)};
}

}  // namespace

Result<Picture> draw(const Derivation& derivation, const Grammar& grammar, const Surroundings& around,
                     const DrawOptions& options) {
    Result<StyleSheet> sheet = read_styles(around.settings, around.document);
    if (!sheet) return sheet.diagnostics();
    if (grammar.show.film) {
        Result<Drawing> film = draw_film(derivation, grammar, around, std::move(*sheet), options);
        if (!film) return film.diagnostics();
        Picture picture;
        picture.drawing = std::move(*film);
        picture.elements.resize(picture.drawing.shapes.size());
        return picture;
    }
    std::vector<Application> shown;
    if (!grammar.show.matches.empty()) {
        SeenDesign seen = seen_design(grammar, derivation);
        for (const std::uint32_t rule : grammar.show.matches) {
            const Result<Applications> found = applications_of(grammar, rule, seen, around, options.job);
            if (!found) return found.diagnostics();
            for (const Application& at : found->all) {
                if (at.variant == 0) shown.push_back(at);
            }
        }
    }
    return draw_design(derivation, grammar, around, std::move(*sheet), shown, options);
}

Result<Drawing> draw_matches(const Derivation& derivation, const Grammar& grammar, const Surroundings& around,
                             const std::vector<Application>& shown, const DrawOptions& options) {
    Result<StyleSheet> sheet = read_styles(around.settings, around.document);
    if (!sheet) return sheet.diagnostics();
    Result<Picture> picture = draw_design(derivation, grammar, around, std::move(*sheet), shown, options);
    if (!picture) return picture.diagnostics();
    return std::move(picture->drawing);
}

}  // namespace filigree::shape
