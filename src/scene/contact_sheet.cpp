#include "scene/contact_sheet.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "base/unicode.h"
#include "scene/arrange.h"
#include "scene/lettering.h"

namespace filigree {
namespace {

constexpr Colour ink{38, 38, 38, 255};
constexpr Colour paper{255, 255, 255, 255};
constexpr double title_size = 1.5;          // in labels
constexpr double label_distance = 1.3;      // from a box to the top of its label, in labels
constexpr double stroke_of_letters = 0.09;  // in their height
constexpr double most_mitre = 2;            // how far a corner reaches from its point, in pens: SVG's limit of 4

struct Rectangle {  // px
    Vec min, max;
};
Rectangle grown(const Rectangle& by, double on_each_side) {
    const Vec more{on_each_side, on_each_side};
    return {by.min - more, by.max + more};
}

void add_ring(Polygons& polygons, const Rectangle& r, bool is_hole) {
    const Point a = snap(r.min), b = snap({r.max.x, r.min.y}), c = snap(r.max), d = snap({r.min.x, r.max.y});
    if (is_hole) {
        polygons.add_ring(std::vector<Point>{a, d, c, b});
    } else {
        polygons.add_ring(std::vector<Point>{a, b, c, d});
    }
}

Polygons polygon_of(const Rectangle& outer, const std::optional<Rectangle>& hole = {}) {
    Polygons polygons;
    add_ring(polygons, outer, false);
    if (hole) add_ring(polygons, *hole, true);
    polygons.end_polygon();
    return polygons;
}

bool is_drawable(const Canvas& canvas) {
    return canvas.size.x > 0 && canvas.size.y > 0 && is_on_plane(canvas.size) && is_on_plane(canvas.origin);
}

double scale_of(const Canvas& canvas, double cell) { return cell / std::max(canvas.size.x, canvas.size.y); }

double drawn_pen(const Style& style, double scale) {
    return style.stroke && style.pen > 0 ? std::max(style.pen * scale, thinnest_sheet_pen) : 0;
}

// Whether anything, pens included, is drawn outside the canvas.
bool reaches_beyond(const Drawing& drawing, double scale) {
    const Canvas& canvas = drawing.canvas;
    const Vec end = canvas.origin + canvas.size;
    return std::any_of(drawing.shapes.begin(), drawing.shapes.end(), [&](const DrawnShape& shape) {
        const Box box = bounds(filigree::polygon_of(drawing, shape));
        const double pen = drawn_pen(drawing.styles[shape.style], scale) / scale / 2;
        const Vec min = to_px(box.min), max = to_px(box.max);
        return min.x - pen < canvas.origin.x || min.y - pen < canvas.origin.y || max.x + pen > end.x ||
               max.y + pen > end.y;
    });
}

// The text, or as much of it as leaves room for the dots after it.
std::string cut_to(std::string_view text, double width, double height) {
    if (lettering_width(text, height) <= width) return std::string(text);
    constexpr std::string_view dots = "...";
    std::size_t kept = 0;
    double used = lettering_width(dots, height);
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t next = at + unicode::decode(text, at).length;
        used += lettering_width(text.substr(at, next - at), height);
        if (used > width) break;
        at = next;
        if (text[at - 1] != ' ') kept = at;
    }
    return std::string(text.substr(0, kept)).append(dots);
}

class Sheet {
public:
    Sheet(const std::vector<SheetCell>& cells, const SheetOptions& options)
        : cells_(cells), options_(options), margin_(2 * options.gap) {}

    Drawing draw() && {
        measure();
        sheet_.canvas.background = paper;
        sheet_.groups.emplace_back();
        if (!options_.title.empty()) {
            const double height = title_size * options_.label_height;
            add_line(options_.title, {sheet_.canvas.size.x / 2, margin_ + height}, sheet_.canvas.size.x - 2 * margin_,
                     height);
        }
        sheet_.groups[0].end_shape = shape_count();
        for (std::size_t i = 0; i < cells_.size(); ++i) draw_cell(i);
        return std::move(sheet_);
    }

private:
    std::uint32_t shape_count() const { return static_cast<std::uint32_t>(sheet_.shapes.size()); }

    void measure() {
        const double label = options_.label_height;
        const std::size_t count = cells_.size();
        columns_ = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
        if (options_.columns > 0) columns_ = std::min<std::size_t>(options_.columns, count);
        columns_ = std::max<std::size_t>(columns_, 1);
        const std::size_t rows = (count + columns_ - 1) / columns_;
        for (const SheetCell& cell : cells_) {
            if (cell.drawing == nullptr || !is_drawable(cell.drawing->canvas)) continue;
            const Vec size = cell.drawing->canvas.size * scale_of(cell.drawing->canvas, options_.cell);
            box_ = {std::max(box_.x, size.x), std::max(box_.y, size.y)};
        }
        // Narrow boxes still leave their labels some room.
        box_.x = std::max(box_.x, options_.cell / 2);
        const bool has_labels =
            std::any_of(cells_.begin(), cells_.end(), [](const SheetCell& cell) { return !cell.label.empty(); });
        const double label_room = has_labels ? (label_distance + 1) * label : 0;
        step_ = {box_.x + options_.gap, box_.y + label_room + (has_labels ? 1.25 : 1) * options_.gap};
        first_ = {margin_, margin_};
        if (!options_.title.empty()) first_.y += title_size * label + 1.25 * options_.gap;
        const double last_gap = step_.y - box_.y - label_room;
        const Vec across{static_cast<double>(columns_), static_cast<double>(rows)};
        sheet_.canvas.size = {std::ceil(first_.x + across.x * step_.x - options_.gap + margin_),
                              std::ceil(first_.y + across.y * step_.y - (rows > 0 ? last_gap : 0) + margin_)};
    }

    void draw_cell(std::size_t i) {
        const auto number = static_cast<std::uint32_t>(sheet_.groups.size());
        const std::string name = std::to_string(i + 1);
        sheet_.groups[0].children.push_back(number);
        sheet_.groups.push_back({name, shape_count(), shape_count(), 0, 0, {}});
        const Vec corner{first_.x + static_cast<double>(i % columns_) * step_.x,
                         first_.y + static_cast<double>(i / columns_) * step_.y};
        const Drawing* const drawing = cells_[i].drawing;
        const bool has_drawing = drawing != nullptr && is_drawable(drawing->canvas);
        Polygons cover;
        if (has_drawing) cover = draw_picture(*drawing, corner, number, name);
        sheet_.groups[number].first_overlay = shape_count();
        if (!cover.empty()) add(std::move(cover), {paper, {}, 1, Corner::round});
        const double label = options_.label_height;
        add_line(cells_[i].label, corner + Vec{box_.x / 2, box_.y + (label_distance + 1) * label}, box_.x, label);
        sheet_.groups[number].end_overlay = shape_count();
    }

    // What is left to be painted over the picture in the colour of the paper: where shapes are cut, their outlines
    // run along the cut, and so they are cut a little outside the canvas and this is covered.
    Polygons draw_picture(const Drawing& drawing, Vec corner, std::uint32_t group, const std::string& name) {
        const Canvas& canvas = drawing.canvas;
        const double scale = scale_of(canvas, options_.cell);
        const Vec size = canvas.size * scale;
        const Vec min = corner + 0.5 * (box_ - size);
        const Rectangle place{min, min + size};
        if (canvas.background) {
            add(polygon_of(place), {canvas.background, {}, 1, Corner::round});
            sheet_.groups[group].end_shape = shape_count();
        }
        double pen = 0;
        for (const Style& style : drawing.styles) pen = std::max(pen, drawn_pen(style, scale));
        const bool is_cut = reaches_beyond(drawing, scale);
        const Polygons clip = polygon_of(grown(place, pen));
        Placement placement;
        placement.transform = compose(translation(min), compose(scaling(scale, scale), translation(-canvas.origin)));
        placement.clip = is_cut ? &clip : nullptr;
        placement.path_prefix = name;
        placement.parent = group;
        placement.pen_scale = scale;
        placement.least_pen = thinnest_sheet_pen;
        place_drawing(sheet_, drawing, placement);
        if (!is_cut || pen == 0) return {};
        return polygon_of(grown(place, std::min((1 + most_mitre) * pen, options_.gap / 2)), place);
    }

    // A line of text around the middle of its baseline.
    void add_line(std::string_view text, Vec middle, double width, double height) {
        const std::string line = cut_to(text, width, height);
        const Vec at{middle.x - lettering_width(line, height) / 2, middle.y};
        add(lettering(line, at, {height, stroke_of_letters * height}), {ink, {}, 1, Corner::round});
    }

    void add(Polygons polygons, const Style& style) {
        const auto known = std::find(sheet_.styles.begin(), sheet_.styles.end(), style);
        const auto index = static_cast<std::uint32_t>(known - sheet_.styles.begin());
        if (known == sheet_.styles.end()) sheet_.styles.push_back(style);
        const auto geometry = static_cast<std::uint32_t>(sheet_.geometry.size());
        for (std::uint32_t p = 0; p < polygons.size(); ++p) {
            sheet_.shapes.push_back({geometry, p, index, child(child(Key{}, "contact sheet"), shape_count())});
        }
        if (!polygons.empty()) sheet_.geometry.push_back(std::make_shared<const Polygons>(std::move(polygons)));
    }

    const std::vector<SheetCell>& cells_;
    const SheetOptions& options_;
    const double margin_;  // px
    std::size_t columns_ = 1;
    Vec box_;    // px, the size of each
    Vec step_;   // px, from one box to the next
    Vec first_;  // px, the first one's corner
    Drawing sheet_;
};

}  // namespace

Drawing contact_sheet(const std::vector<SheetCell>& cells, const SheetOptions& options) {
    return Sheet(cells, options).draw();
}

}  // namespace filigree
