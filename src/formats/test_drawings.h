// For this layer's tests: drawings with known geometry.
#pragma once

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/elementary.h"
#include "base/random.h"
#include "scene/drawing.h"

namespace filigree {

inline Point at_px(double x, double y) { return snap({x, y}); }

inline std::vector<Point> rectangle_ring(double x, double y, double width, double height, bool is_hole = false) {
    const Point a = at_px(x, y), b = at_px(x + width, y), c = at_px(x + width, y + height), d = at_px(x, y + height);
    return is_hole ? std::vector<Point>{a, d, c, b} : std::vector<Point>{a, b, c, d};
}

inline Polygons polygons_of(const std::vector<std::vector<Point>>& rings) {  // one polygon
    Polygons polygons;
    for (const std::vector<Point>& ring : rings) polygons.add_ring(ring);
    polygons.end_polygon();
    return polygons;
}

// A blob with a wobbly outline that turns from +x towards +y.
inline std::vector<Point> blob_ring(Vec centre, double radius, std::size_t count, std::uint64_t seed,
                                    bool is_hole = false) {
    std::vector<Point> ring;
    for (std::size_t i = 0; i < count; ++i) {
        const double turn = 360.0 * static_cast<double>(i) / static_cast<double>(count);
        const elementary::CosSin direction = elementary::cos_sin_degrees(is_hole ? -turn : turn);
        const double r = radius * (0.8 + 0.2 * to_unit(random_bits(seed, Key{i}, "radius")));
        ring.push_back(snap({centre.x + r * direction.cos, centre.y + r * direction.sin}));
    }
    return ring;
}

// One group with all shapes of the geometry in one style.
inline Drawing drawing_of(Polygons geometry, Style style, Vec size) {
    Drawing drawing;
    drawing.canvas.size = size;
    drawing.styles = {style};
    const auto count = static_cast<std::uint32_t>(geometry.size());
    for (std::uint32_t i = 0; i < count; ++i) drawing.shapes.push_back({0, i, 0, child(Key{7}, i)});
    drawing.geometry = {std::make_shared<const Polygons>(std::move(geometry))};
    drawing.groups = {{"start", 0, count, 0, 0, {}}};
    return drawing;
}

// `count` blobs of `points` points in rows.
inline Drawing many_blobs(std::size_t count, std::size_t points, Vec size, Style style) {
    Polygons geometry;
    const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
    const Vec cell = size * (1 / static_cast<double>(columns));
    for (std::size_t i = 0; i < count; ++i) {
        const Vec centre{(static_cast<double>(i % columns) + 0.5) * cell.x,
                         (static_cast<double>(i / columns) + 0.5) * cell.y};
        geometry.add_ring(blob_ring(centre, 0.45 * cell.x, points, i));
        geometry.end_polygon();
    }
    return drawing_of(std::move(geometry), style, size);
}

inline Style filled(Colour colour) { return {colour, {}, 1, Corner::round}; }
inline Style stroked(Colour colour, double pen) { return {{}, colour, pen, Corner::round}; }
// One line, open.
inline Drawing line_drawing(const std::vector<Vec>& points, Style style, Vec size) {
    std::vector<Point> line;
    for (const Vec p : points) line.push_back(snap(p));
    style.is_open = true;
    return drawing_of(polygons_of({line}), style, size);
}
constexpr Colour black{0, 0, 0, 255}, white{255, 255, 255, 255}, red{255, 0, 0, 255};

}  // namespace filigree
