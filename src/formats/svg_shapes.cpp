#include "formats/svg_shapes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace filigree {
namespace {

class Pen {
public:
    void move(Vec to) { put(Verb::move, {to}); }
    void line(Vec to) { put(Verb::line, {to}); }
    void quarter(Vec radii, Vec to) { put(Verb::arc, {radii, Vec{0, 2}, to}); }  // a small arc from +x towards +y
    void close() { path_.verbs.push_back(Verb::close); }
    Path take() && { return std::move(path_); }

private:
    void put(Verb verb, std::initializer_list<Vec> points) {
        path_.verbs.push_back(verb);
        path_.points.insert(path_.points.end(), points);
    }
    Path path_;
};

Path ellipse_path(Vec centre, Vec radii) {
    if (!(radii.x > 0 && radii.y > 0)) return {};
    Pen pen;
    pen.move(centre + Vec{radii.x, 0});
    pen.quarter(radii, centre + Vec{0, radii.y});
    pen.quarter(radii, centre + Vec{-radii.x, 0});
    pen.quarter(radii, centre + Vec{0, -radii.y});
    pen.quarter(radii, centre + Vec{radii.x, 0});
    pen.close();
    return std::move(pen).take();
}

Path rect_path(SvgAttributes& attributes) {
    const Vec corner{attributes.length_or("x", Axis::x, 0), attributes.length_or("y", Axis::y, 0)};
    const Vec size{attributes.size("width", Axis::x).value_or(0), attributes.size("height", Axis::y).value_or(0)};
    std::optional<double> rx = attributes.size("rx", Axis::x), ry = attributes.size("ry", Axis::y);
    if (!(size.x > 0 && size.y > 0)) return {};
    if (!rx) rx = ry.value_or(0);
    if (!ry) ry = rx;
    const Vec r{std::min(*rx, size.x / 2), std::min(*ry, size.y / 2)};

    const Vec end = corner + size;
    Pen pen;
    if (!(r.x > 0 && r.y > 0)) {
        pen.move(corner);
        pen.line({end.x, corner.y});
        pen.line(end);
        pen.line({corner.x, end.y});
    } else {
        // Straight pieces are left out where two corners meet.
        const auto line_between = [&](double room, double radius, Vec to) {
            if (room > 2 * radius) pen.line(to);
        };
        pen.move({corner.x + r.x, corner.y});
        line_between(size.x, r.x, {end.x - r.x, corner.y});
        pen.quarter(r, {end.x, corner.y + r.y});
        line_between(size.y, r.y, {end.x, end.y - r.y});
        pen.quarter(r, {end.x - r.x, end.y});
        line_between(size.x, r.x, {corner.x + r.x, end.y});
        pen.quarter(r, {corner.x, end.y - r.y});
        line_between(size.y, r.y, {corner.x, corner.y + r.y});
        pen.quarter(r, {corner.x + r.x, corner.y});
    }
    pen.close();
    return std::move(pen).take();
}

Path circle_path(SvgAttributes& attributes) {
    const Vec centre{attributes.length_or("cx", Axis::x, 0), attributes.length_or("cy", Axis::y, 0)};
    const double r = attributes.size("r", Axis::both).value_or(0);
    return ellipse_path(centre, {r, r});
}

Path ellipse_element_path(SvgAttributes& attributes) {
    const Vec centre{attributes.length_or("cx", Axis::x, 0), attributes.length_or("cy", Axis::y, 0)};
    const std::optional<double> rx = attributes.size("rx", Axis::x), ry = attributes.size("ry", Axis::y);
    return ellipse_path(centre, {rx ? *rx : ry.value_or(0), ry ? *ry : rx.value_or(0)});
}

Path line_path(SvgAttributes& attributes) {
    Pen pen;
    pen.move({attributes.length_or("x1", Axis::x, 0), attributes.length_or("y1", Axis::y, 0)});
    pen.line({attributes.length_or("x2", Axis::x, 0), attributes.length_or("y2", Axis::y, 0)});
    return std::move(pen).take();
}

Path points_path(SvgAttributes& attributes, bool is_closed) {
    const std::vector<double> numbers = attributes.numbers("points");
    if (numbers.size() % 2 != 0) {
        attributes.refuse("points", "svg.odd-points", "are an odd number of coordinates");
        return {};
    }
    Pen pen;
    for (std::size_t i = 0; i < numbers.size(); i += 2) {
        const Vec p{numbers[i], numbers[i + 1]};
        if (i == 0) {
            pen.move(p);
        } else {
            pen.line(p);
        }
    }
    if (is_closed && !numbers.empty()) pen.close();
    return std::move(pen).take();
}

}  // namespace

bool is_shape_element(std::string_view local_name) {
    constexpr std::array<std::string_view, 7> names = {"path", "rect",     "circle", "ellipse",
                                                       "line", "polyline", "polygon"};
    return std::find(names.begin(), names.end(), local_name) != names.end();
}

Path shape_path(SvgAttributes& attributes) {
    const std::string_view name = local_name(attributes.element().name());
    if (name == "path") return attributes.path_data();
    if (name == "rect") return rect_path(attributes);
    if (name == "circle") return circle_path(attributes);
    if (name == "ellipse") return ellipse_element_path(attributes);
    if (name == "line") return line_path(attributes);
    return points_path(attributes, name == "polygon");
}

}  // namespace filigree
