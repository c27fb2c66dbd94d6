// The elements of curved shapes: labelled points, straight lines, parabola arcs (quadratic Beziers), arcs of circles
// and ellipses, and cubic Beziers; in doubles, px.
//
// An element lies along its *descriptor*, the curve of infinite extent (or the whole ellipse) that carries it, between
// two values of the descriptor's parameter. Which of the two ends comes first means nothing. Paper: Jowers and Earl,
// section 2.2; shapes of quadratic Beziers alone in section 3.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "plane/point.h"
#include "plane/transform.h"

namespace filigree::curves {

enum class ElementKind : std::uint8_t { point, line, parabola, arc, cubic };

struct Element {
    ElementKind kind = ElementKind::line;
    // Elements of different layers never merge and never match. Whoever makes shapes numbers them: one for each
    // colour, of points one for each label.
    std::uint32_t layer = 0;
    double weight = 1;  // > 0; where elements of a sum overlap, the heavier one is seen
    // point: its place; line: its ends; parabola and cubic: their control points; arc: the ellipse's centre and two
    // conjugate half axes u and v. The rest is zero.
    std::array<Vec, 4> at{};
    double from = 0, to = 0;  // arc: centre + u cos t + v sin t, from < to <= from + 2 pi

    bool operator==(const Element&) const = default;
};

// A range of a descriptor's parameter, from <= to.
struct Interval {
    double from = 0, to = 1;

    bool operator==(const Interval&) const = default;
};
// Where an element lies on its own descriptor: 0..1, an arc from..to.
inline Interval interval_of(const Element& e) {
    return e.kind == ElementKind::arc ? Interval{e.from, e.to} : Interval{};
}
std::string_view name_of(ElementKind kind);  // "point", "line", ...
// How many vectors of `at` a kind has: control points, or an arc's centre and half axes.
constexpr std::size_t vector_count(ElementKind kind) {
    return kind == ElementKind::point ? 1 : kind == ElementKind::line ? 2 : kind == ElementKind::cubic ? 4 : 3;
}

// Elements as they are meant; nothing is put into normal form.
Element point_element(Vec place);
Element line_element(Vec from, Vec to);
Element parabola_element(Vec b0, Vec b1, Vec b2);
Element cubic_element(Vec b0, Vec b1, Vec b2, Vec b3);
// Of an ellipse by any two conjugate half axes; the angles may come in either order and lie anywhere. The axes become
// the principal ones (the longer first, to the right; v a quarter turn from +x to +y behind u), those of a circle
// (radius, 0) and (0, radius), and `from` lies in [-pi, pi), of a whole ellipse at -pi.
Element arc_element(Vec centre, Vec u, Vec v, double from, double to);
Element circle_element(Vec centre, double radius);

// Whether an arc is of a circle: its axes are as long, to 1e-9.
bool is_circular(const Element& arc);
// Whether it is a whole circle or ellipse, and so has no ends.
bool is_closed(const Element& e);

// On the descriptor, at any value of its parameter.
Vec point_at(const Element& e, double t);
Vec velocity_at(const Element& e, double t);
std::pair<Vec, Vec> ends_of(const Element& e);
// Of the curve, px; to about 1e-8 of it.
double length_of(const Element& e);
// Cheap lengths, px, that come near the length of short pieces: of Beziers that of the control polygon, never less.
// The second is of the descriptor between two parameters.
double rough_length(const Element& e);
double rough_length(const Element& e, Interval on);

struct Bounds {  // px, closed; empty while min > max
    Vec min{1e300, 1e300}, max{-1e300, -1e300};
};
void extend(Bounds& bounds, Vec p);
void extend(Bounds& bounds, const Bounds& by);
// Whether two come within `reach` of each other along x and y.
inline bool do_overlap(const Bounds& a, const Bounds& b, double reach = 0) {
    return a.min.x <= b.max.x + reach && b.min.x <= a.max.x + reach && a.min.y <= b.max.y + reach &&
           b.min.y <= a.max.y + reach;
}
// Exact for points, lines and arcs; for Beziers the box of the curve, not of the control points.
Bounds bounds_of(const Element& e);
Bounds bounds_of(std::span<const Element> elements);
double diagonal_of(const Bounds& bounds);  // px; 0 of empty ones
// Whether its control points lie on the plane, no farther than 2^30 px from the origin along x and y, and its numbers
// are finite. What does not is no part of a shape.
bool is_on_plane(const Element& e);
// The farthest that an element's box comes from a place, px.
double farthest_from(const Element& e, Vec place);

// The part of the descriptor between two parameters, in either order and beyond the element's ends, too: sub-division
// and extension by one formula, the blossom. Paper: section 3.2, there by de Casteljau's algorithm.
Element piece_of(const Element& e, Interval on);
Element transformed(const Element& e, const Transform& by);
Element reversed(const Element& e);

// As the simplest element that looks the same to within the tolerance (px): a cubic of lower degree is a parabola, a
// straight curve is the line between its outermost points. Lines and curves start at the lesser end (x, then y).
// A nearly round ellipse is a circle, and an arc that ends where it began is a whole one. Nothing where the whole is
// shorter than the tolerance, or not finite. Points stay. The normal form of a normal form is the same, bit by bit.
std::optional<Element> normal_form(const Element& e, double tolerance);
// The same for pieces of curves: they keep their kind, however flat they are, since what a curve was cut into must make
// the curve again. Only a flat curve that turns back on itself is a line.
std::optional<Element> own_form(const Element& e, double tolerance);

// Total orders of elements: by kind, layer, then all coordinates, then weight.
bool comes_before(const Element& a, const Element& b);

}  // namespace filigree::curves
