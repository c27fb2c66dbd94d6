// A drawing: styled shapes in the order of painting, grouped by what made them.
//
// A drawing shares the geometry of the derivation that it shows; nothing is copied. Groups form a tree as
// the derivation's steps do. Painting a group: its own shapes, then its child groups, then its overlay.
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/colour.h"
#include "base/random.h"
#include "plane/path.h"
#include "plane/polygon.h"

namespace filigree {

// Lines end as they turn corners: round ones are rounded, others are cut off square.
enum class Corner : std::uint8_t { mitre, round, bevel };

struct Style {
    std::optional<Colour> fill;
    std::optional<Colour> stroke;
    double pen = 1;  // px, width of the stroke
    Corner corner = Corner::round;
    bool is_open = false;  // a line, of one ring of two points or more: neither closed nor filled

    bool operator==(const Style&) const = default;
};
inline bool has_fill(const Style& style) { return style.fill.has_value() && !style.is_open; }
inline bool has_stroke(const Style& style) {
    return style.stroke.has_value() && style.pen > 0 && std::isfinite(style.pen);
}

struct DrawnShape {
    static constexpr std::uint32_t no_curve = UINT32_MAX;

    std::uint32_t geometry = 0;  // index into Drawing::geometry
    std::uint32_t polygon = 0;   // index into that
    std::uint32_t style = 0;     // index into Drawing::styles
    Key key;                     // names the shape in exported files
    // Index into Drawing::curves: what the polygon was flattened from, and what files draw in its place. Who moves or
    // cuts the polygon does the same to the curve, or drops it.
    std::uint32_t curve = no_curve;
};
inline bool has_curve(const DrawnShape& shape) { return shape.curve != DrawnShape::no_curve; }

struct DrawingGroup {
    std::string path;                                  // "big_poly/outline/in": what made it, for people
    std::uint32_t first_shape = 0, end_shape = 0;      // of Drawing::shapes
    std::uint32_t first_overlay = 0, end_overlay = 0;  // of Drawing::shapes: painted over the children
    std::vector<std::uint32_t> children;               // indices of groups, in painting order; all above this one's own
};

// The visible rectangle and how large it is in the world.
struct Canvas {
    Vec origin;          // px, its top left corner in the drawing's coordinates
    Vec size{1, 1};      // px
    bool in_mm = false;  // whether files should give its size in mm
    std::optional<Colour> background;

    bool operator==(const Canvas&) const = default;
};

struct Drawing {
    Canvas canvas;
    std::vector<std::shared_ptr<const Polygons>> geometry;
    std::vector<Style> styles;
    std::vector<DrawnShape> shapes;
    // Subpaths begin with a move, and those of filled shapes close and cross nowhere. All points lie on the plane.
    std::vector<Path> curves;
    std::vector<DrawingGroup> groups;  // [0] is the root; a child stands after its parent
};

inline PolygonView polygon_of(const Drawing& drawing, const DrawnShape& shape) {
    return (*drawing.geometry[shape.geometry])[shape.polygon];
}

// Lays the canvas around a box with a margin in px (without one, a little), in whole thousandths of a px, which read
// better in files than the grid's fractions.
void fit_canvas(Canvas& canvas, const Box& box, std::optional<double> margin);

// One step of painting a drawing, as a walk over its groups.
struct PaintStep {
    enum class Kind : std::uint8_t { enter, shapes, leave };
    Kind kind = Kind::enter;
    bool overlay = false;  // of shapes: whether they are the group's overlay
    std::uint32_t group = 0;
    std::uint32_t first = 0, end = 0;  // of shapes: a range of Drawing::shapes, never empty

    bool operator==(const PaintStep&) const = default;
};
// The whole order of painting: what every format walks. Groups without a shape anywhere below are left out.
std::vector<PaintStep> painting_steps(const Drawing& drawing);

}  // namespace filigree
