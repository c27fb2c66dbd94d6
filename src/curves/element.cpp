#include "curves/element.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "curves/quadrature.h"

namespace filigree::curves {
namespace {

constexpr double turn = 2 * elementary::pi;

double squared(Vec v) { return dot(v, v); }
bool is_less(Vec a, Vec b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

// The coefficients of a Bezier: at[0] t^3 + at[1] t^2 + at[2] t + at[3].
std::array<Vec, 4> coefficients(const Element& e) {
    const auto& b = e.at;
    if (e.kind == ElementKind::cubic) {
        return {b[3] - b[0] + 3 * (b[1] - b[2]), 3 * (b[0] - 2 * b[1] + b[2]), 3 * (b[1] - b[0]), b[0]};
    }
    if (e.kind == ElementKind::parabola) return {Vec{}, b[0] - 2 * b[1] + b[2], 2 * (b[1] - b[0]), b[0]};
    return {Vec{}, Vec{}, b[1] - b[0], b[0]};
}

// The parameters inside (0, 1) where a x^2 + b x + c = 0.
struct Roots {
    std::array<double, 2> at{};
    int count = 0;
};
Roots roots_inside(double a, double b, double c) {
    Roots roots;
    const auto take = [&](double t) {
        if (t > 0 && t < 1) roots.at[static_cast<std::size_t>(roots.count++)] = t;
    };
    const double d = b * b - 4 * a * c;
    if (d < 0) return roots;
    const double q = -0.5 * (b + std::copysign(std::sqrt(d), b));
    if (a != 0) take(q / a);
    if (q != 0 && (a == 0 || roots.count == 0 || c / q != roots.at[0])) take(c / q);
    return roots;
}

// The parameters inside (0, 1) where a Bezier is outermost along a direction.
Roots turning_points(const std::array<Vec, 4>& k, Vec along) {
    return roots_inside(3 * dot(k[0], along), 2 * dot(k[1], along), dot(k[2], along));
}

// The line between the outermost points of a Bezier along a direction.
Element hull_line(const Element& e, Vec along) {
    const auto k = coefficients(e);
    Vec low = e.at[0], high = low;
    const auto take = [&](Vec p) {
        if (dot(p, along) < dot(low, along)) low = p;
        if (dot(p, along) > dot(high, along)) high = p;
    };
    take(point_at(e, 1));
    const Roots roots = turning_points(k, along);
    for (int i = 0; i < roots.count; ++i) take(point_at(e, roots.at[static_cast<std::size_t>(i)]));
    return line_element(low, high);
}

// The direction from the first control point to another, or between the last ones, in which it is longest.
Vec main_direction(const Element& e) {
    const std::size_t count = vector_count(e.kind);
    Vec best;
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = i + 1; j < count; ++j) {
            if (squared(e.at[j] - e.at[i]) > squared(best)) best = e.at[j] - e.at[i];
        }
    }
    return best;
}

Element with_same_ink(Element made, const Element& of) {
    made.layer = of.layer;
    made.weight = of.weight;
    return made;
}

Element directed(const Element& e) {
    const auto [first, last] = ends_of(e);
    if (is_less(last, first)) return reversed(e);
    if (first == last && e.kind == ElementKind::cubic && is_less(e.at[2], e.at[1])) return reversed(e);
    return e;
}

Element without_negative_zeros(Element e) {
    for (Vec& p : e.at) p = p + Vec{0, 0};
    return e;
}

// The line that a Bezier looks like, between its outermost points; nothing where it is broader than the tolerance.
std::optional<Element> line_of_flat(const Element& e, double tolerance) {
    const Vec along = main_direction(e);
    if (squared(along) == 0) return line_element(e.at[0], e.at[0]);
    const Element line = hull_line(e, along);
    const Vec way = line.at[1] - line.at[0];
    const std::size_t count = vector_count(e.kind);
    double most = 0;
    for (std::size_t i = 0; i < count; ++i) most = std::max(most, std::fabs(cross(way, e.at[i] - line.at[0])));
    // With both ends on the line the curve keeps within half (of a cubic: three quarters) of its control polygon.
    const auto [first, last] = ends_of(e);
    const bool is_between_ends = std::pair(first, last) == std::pair(line.at[0], line.at[1]) ||
                                 std::pair(first, last) == std::pair(line.at[1], line.at[0]);
    const double share = !is_between_ends ? 1 : e.kind == ElementKind::parabola ? 0.5 : 0.75;
    if (!(share * most <= tolerance * length(way))) return std::nullopt;
    return line;
}

std::optional<Element> line_form(const Element& line, const Element& of, double tolerance) {
    if (length(line.at[1] - line.at[0]) <= tolerance) return std::nullopt;
    return with_same_ink(directed(line), of);
}

// Of an arc that is not flat: a nearly round ellipse is a circle, and what ends where it began is whole.
Element round_form(const Element& e, double tolerance) {
    Vec u = e.at[1], v = e.at[2];
    const double broad = length(u), narrow = length(v);
    if (!is_circular(e) && broad - narrow <= tolerance) {
        const double radius = 0.5 * (broad + narrow);
        u = u * (radius / broad);
        v = perpendicular(u);
    }
    const Element form = with_same_ink(arc_element(e.at[0], u, v, e.from, e.to), e);
    const double gap = turn - (form.to - form.from);
    if (gap * length(velocity_at(form, form.to + 0.5 * gap)) > tolerance) return form;
    return with_same_ink(arc_element(e.at[0], u, v, 0, turn), e);
}

// Of an ellipse as flat as a line: the part of its long axis that the arc covers.
std::optional<Element> flat_ellipse_form(const Element& e, double tolerance) {
    const auto [first, last] = ends_of(e);
    double low = std::min(dot(first, e.at[1]), dot(last, e.at[1])),
           high = std::max(dot(first, e.at[1]), dot(last, e.at[1]));
    const double own = dot(e.at[0], e.at[1]), reach = squared(e.at[1]);
    if (!(reach > 0)) return std::nullopt;
    for (int half = -4; half <= 8; ++half) {
        if (const double t = half * elementary::pi; t > e.from && t < e.to) {
            (half % 2 == 0 ? high : low) = own + (half % 2 == 0 ? reach : -reach);
        }
    }
    const Vec unit = e.at[1] * (1 / reach);
    return line_form(line_element(e.at[0] + unit * (low - own), e.at[0] + unit * (high - own)), e, tolerance);
}

// Whether an arc keeps within the tolerance of its chord. Of less than half a turn the middle is the farthest from it;
// at a flat ellipse's tip it may turn back.
bool is_flat_arc(const Element& e, double tolerance) {
    const auto [first, last] = ends_of(e);
    const Vec chord = last - first, middle = point_at(e, 0.5 * (e.from + e.to));
    return e.to - e.from < elementary::pi && std::fabs(cross(chord, middle - first)) <= tolerance * length(chord) &&
           dot(velocity_at(e, e.from), chord) > 0 && dot(velocity_at(e, e.to), chord) > 0;
}

}  // namespace

std::string_view name_of(ElementKind kind) {
    switch (kind) {
        case ElementKind::point:
            return "point";
        case ElementKind::line:
            return "line";
        case ElementKind::parabola:
            return "parabola";
        case ElementKind::arc:
            return "arc";
        case ElementKind::cubic:
            return "cubic";
    }
    return "";
}

Element point_element(Vec place) {
    Element e;
    e.kind = ElementKind::point;
    e.at[0] = place;
    return e;
}

Element line_element(Vec from, Vec to) {
    Element e;
    e.at = {from, to, Vec{}, Vec{}};
    return e;
}

Element parabola_element(Vec b0, Vec b1, Vec b2) {
    Element e;
    e.kind = ElementKind::parabola;
    e.at = {b0, b1, b2, Vec{}};
    return e;
}

Element cubic_element(Vec b0, Vec b1, Vec b2, Vec b3) {
    Element e;
    e.kind = ElementKind::cubic;
    e.at = {b0, b1, b2, b3};
    return e;
}

Element arc_element(Vec centre, Vec u, Vec v, double from, double to) {
    if (to < from) std::swap(from, to);
    const double uu = squared(u), vv = squared(v), uv = dot(u, v);
    const auto mirror_angles = [&] {
        std::swap(from, to);
        from = -from;
        to = -to;
    };
    // What is in this form already stays as it is, to the last bit.
    if (4 * uv * uv + (uu - vv) * (uu - vv) <= 1e-18 * (uu + vv) * (uu + vv)) {
        const double radius = std::sqrt(0.5 * (uu + vv));
        if (cross(u, v) < 0) mirror_angles();
        const double at = elementary::atan2(u.y, u.x);
        from += at;
        to += at;
        u = {radius, 0};
        v = {0, radius};
    } else {
        if (uu < vv || std::fabs(uv) > 1e-14 * (uu + vv)) {
            const double shift = 0.5 * elementary::atan2(2 * uv, uu - vv);
            const auto [cosine, sine] = elementary::cos_sin(shift);
            const Vec longer = u * cosine + v * sine;
            v = v * cosine - u * sine;
            u = longer;
            from -= shift;
            to -= shift;
        }
        if (cross(u, v) < 0) {
            v = -v;
            mirror_angles();
        }
        if (is_less(u, Vec{})) {
            u = -u;
            v = -v;
            from += elementary::pi;
            to += elementary::pi;
        }
    }
    if (to - from >= turn * (1 - 1e-15)) {
        from = -elementary::pi;
        to = elementary::pi;
    } else if (!(from >= -elementary::pi && from < elementary::pi)) {
        const double turns = turn * std::floor((from + elementary::pi) / turn);
        from = std::max(from - turns, -elementary::pi);
        to -= turns;
        if (from >= elementary::pi) {
            from = -elementary::pi;
            to -= turn;
        }
    }
    Element e;
    e.kind = ElementKind::arc;
    e.at = {centre, u, v, Vec{}};
    e.from = from;
    e.to = to;
    return e;
}

Element circle_element(Vec centre, double radius) {
    return arc_element(centre, {radius, 0}, {0, radius}, -elementary::pi, elementary::pi);
}

bool is_circular(const Element& arc) {
    const double uu = squared(arc.at[1]), vv = squared(arc.at[2]);
    return std::fabs(uu - vv) <= 2e-9 * (uu + vv);
}

bool is_closed(const Element& e) { return e.kind == ElementKind::arc && e.to - e.from >= turn * (1 - 1e-15); }

Vec point_at(const Element& e, double t) {
    const auto& b = e.at;
    switch (e.kind) {
        case ElementKind::point:
            return b[0];
        case ElementKind::line:
            return b[0] * (1 - t) + b[1] * t;
        case ElementKind::parabola:
            return b[0] * ((1 - t) * (1 - t)) + b[1] * (2 * t * (1 - t)) + b[2] * (t * t);
        case ElementKind::cubic: {
            const double s = 1 - t;
            return b[0] * (s * s * s) + b[1] * (3 * s * s * t) + b[2] * (3 * s * t * t) + b[3] * (t * t * t);
        }
        case ElementKind::arc: {
            const auto [cosine, sine] = elementary::cos_sin(t);
            return b[0] + b[1] * cosine + b[2] * sine;
        }
    }
    return {};
}

Vec velocity_at(const Element& e, double t) {
    if (e.kind == ElementKind::point) return {};
    if (e.kind == ElementKind::arc) {
        const auto [cosine, sine] = elementary::cos_sin(t);
        return e.at[2] * cosine - e.at[1] * sine;
    }
    const auto k = coefficients(e);
    return k[0] * (3 * t * t) + k[1] * (2 * t) + k[2];
}

std::pair<Vec, Vec> ends_of(const Element& e) {
    switch (e.kind) {
        case ElementKind::point:
            return {e.at[0], e.at[0]};
        case ElementKind::line:
            return {e.at[0], e.at[1]};
        case ElementKind::parabola:
            return {e.at[0], e.at[2]};
        case ElementKind::cubic:
            return {e.at[0], e.at[3]};
        case ElementKind::arc:
            return {point_at(e, e.from), point_at(e, e.to)};
    }
    return {};
}

double rough_length(const Element& e) {
    switch (e.kind) {
        case ElementKind::point:
            return 0;
        case ElementKind::line:
            return length(e.at[1] - e.at[0]);
        case ElementKind::parabola:
            return length(e.at[1] - e.at[0]) + length(e.at[2] - e.at[1]);
        case ElementKind::cubic:
            return length(e.at[1] - e.at[0]) + length(e.at[2] - e.at[1]) + length(e.at[3] - e.at[2]);
        case ElementKind::arc:
            return length(e.at[1]) * (e.to - e.from);
    }
    return 0;
}

double rough_length(const Element& e, Interval on) {
    if (e.kind == ElementKind::arc) return (on.to - on.from) * length(velocity_at(e, 0.5 * (on.from + on.to)));
    return rough_length(piece_of(e, on));
}

double length_of(const Element& e) {
    if (e.kind == ElementKind::point) return 0;
    if (e.kind == ElementKind::line) return length(e.at[1] - e.at[0]);
    const Interval on = interval_of(e);
    if (e.kind == ElementKind::arc && is_circular(e)) return length(e.at[1]) * (on.to - on.from);
    double before = -1;
    for (int parts = 4;; parts *= 2) {
        double sum = 0;
        for_each_gauss_place(on, parts, [&](double t, double weight) { sum += weight * length(velocity_at(e, t)); });
        if (std::fabs(sum - before) <= 1e-8 * sum || parts == 1024) return sum;
        before = sum;
    }
}

void extend(Bounds& bounds, Vec p) {
    bounds.min = {std::min(bounds.min.x, p.x), std::min(bounds.min.y, p.y)};
    bounds.max = {std::max(bounds.max.x, p.x), std::max(bounds.max.y, p.y)};
}

void extend(Bounds& bounds, const Bounds& by) {
    extend(bounds, by.min);
    extend(bounds, by.max);
}

Bounds bounds_of(std::span<const Element> elements) {
    Bounds bounds;
    for (const Element& e : elements) extend(bounds, bounds_of(e));
    return bounds;
}

double diagonal_of(const Bounds& bounds) { return bounds.min.x > bounds.max.x ? 0 : length(bounds.max - bounds.min); }

Bounds bounds_of(const Element& e) {
    Bounds bounds;
    const auto [first, last] = ends_of(e);
    extend(bounds, first);
    extend(bounds, last);
    if (e.kind == ElementKind::parabola || e.kind == ElementKind::cubic) {
        const auto k = coefficients(e);
        for (const Vec along : {Vec{1, 0}, Vec{0, 1}}) {
            const Roots roots = turning_points(k, along);
            for (int i = 0; i < roots.count; ++i) extend(bounds, point_at(e, roots.at[static_cast<std::size_t>(i)]));
        }
    }
    if (e.kind == ElementKind::arc) {
        // Outermost in x where v.x / u.x is the tangent of the angle, and half a turn on; in y likewise.
        for (const double outermost :
             {elementary::atan2(e.at[2].x, e.at[1].x), elementary::atan2(e.at[2].y, e.at[1].y)}) {
            for (int half = -3; half <= 5; ++half) {
                if (const double t = outermost + half * elementary::pi; t > e.from && t < e.to) {
                    extend(bounds, point_at(e, t));
                }
            }
        }
    }
    return bounds;
}

bool is_on_plane(const Element& e) {
    return std::all_of(e.at.begin(), e.at.end(), [](Vec p) { return filigree::is_on_plane(p); }) &&
           std::isfinite(e.from) && std::isfinite(e.to) && std::isfinite(e.weight);
}

double farthest_from(const Element& e, Vec place) {
    const Bounds box = bounds_of(e);
    return length(
        Vec{std::max(place.x - box.min.x, box.max.x - place.x), std::max(place.y - box.min.y, box.max.y - place.y)});
}

Element piece_of(const Element& e, Interval on) {
    const auto [u, v] = on;
    const auto& b = e.at;
    Element piece = e;
    switch (e.kind) {
        case ElementKind::point:
            break;
        case ElementKind::line:
            piece.at[0] = point_at(e, u);
            piece.at[1] = point_at(e, v);
            break;
        case ElementKind::parabola:
            piece.at[0] = point_at(e, u);
            piece.at[1] = b[0] * ((1 - u) * (1 - v)) + b[1] * (u * (1 - v) + v * (1 - u)) + b[2] * (u * v);
            piece.at[2] = point_at(e, v);
            break;
        case ElementKind::cubic: {
            // The blossom of the cubic at three parameters, the control points at u, u, v and u, v, v.
            const auto blossom = [&](double r, double s, double t) {
                const auto mix = [](Vec p, Vec q, double at) { return p * (1 - at) + q * at; };
                const Vec p = mix(b[0], b[1], r), q = mix(b[1], b[2], r), w = mix(b[2], b[3], r);
                return mix(mix(p, q, s), mix(q, w, s), t);
            };
            piece.at = {point_at(e, u), blossom(u, u, v), blossom(u, v, v), point_at(e, v)};
            break;
        }
        case ElementKind::arc:
            return with_same_ink(arc_element(b[0], b[1], b[2], u, v), e);
    }
    return piece;
}

Element transformed(const Element& e, const Transform& by) {
    Element moved = e;
    if (e.kind == ElementKind::arc) {
        const auto turned = [&](Vec v) { return Vec{by.a * v.x + by.c * v.y, by.b * v.x + by.d * v.y}; };
        return with_same_ink(arc_element(apply(by, e.at[0]), turned(e.at[1]), turned(e.at[2]), e.from, e.to), e);
    }
    for (std::size_t i = 0; i < vector_count(e.kind); ++i) moved.at[i] = apply(by, e.at[i]);
    return moved;
}

Element reversed(const Element& e) {
    Element back = e;
    if (e.kind == ElementKind::line) std::swap(back.at[0], back.at[1]);
    if (e.kind == ElementKind::parabola) std::swap(back.at[0], back.at[2]);
    if (e.kind == ElementKind::cubic) std::reverse(back.at.begin(), back.at.end());
    return back;
}

std::optional<Element> own_form(const Element& given, double tolerance) {
    if (!is_on_plane(given)) return std::nullopt;
    const Element e = without_negative_zeros(given);
    if (e.kind == ElementKind::point) return e;
    if (e.kind == ElementKind::arc) {
        const Element arc = with_same_ink(arc_element(e.at[0], e.at[1], e.at[2], e.from, e.to), e);
        if (length(arc.at[2]) <= tolerance) return flat_ellipse_form(arc, tolerance);
        const Element form = round_form(arc, tolerance);
        if (rough_length(form) <= tolerance) return std::nullopt;
        return form;
    }
    if (e.kind != ElementKind::line && turning_points(coefficients(e), main_direction(e)).count > 0) {
        if (const auto line = line_of_flat(e, tolerance)) return line_form(*line, e, tolerance);
    }
    if (rough_length(e) <= tolerance) return std::nullopt;
    return directed(e);
}

std::optional<Element> normal_form(const Element& given, double tolerance) {
    const std::optional<Element> own = own_form(given, tolerance);
    if (!own) return own;
    const Element& e = *own;
    if (e.kind == ElementKind::arc && is_flat_arc(e, tolerance)) {
        const auto [first, last] = ends_of(e);
        return line_form(line_element(first, last), e, tolerance);
    }
    if (e.kind != ElementKind::parabola && e.kind != ElementKind::cubic) return e;
    if (const auto line = line_of_flat(e, tolerance)) return line_form(*line, e, tolerance);
    // A cubic departs from the parabola with its ends and its middle's tangent by |a| sqrt(3) / 36.
    if (e.kind == ElementKind::cubic && length(coefficients(e)[0]) * 0.04811252243246881 <= tolerance) {
        const Vec middle = (3 * (e.at[1] + e.at[2]) - e.at[0] - e.at[3]) * 0.25;
        const Element parabola = with_same_ink(parabola_element(e.at[0], middle, e.at[3]), e);
        // One that is a line would look too different from the cubic.
        if (!line_of_flat(parabola, tolerance)) return directed(parabola);
    }
    return e;
}

bool comes_before(const Element& a, const Element& b) {
    if (a.kind != b.kind) return a.kind < b.kind;
    if (a.layer != b.layer) return a.layer < b.layer;
    for (std::size_t i = 0; i < a.at.size(); ++i) {
        if (a.at[i] != b.at[i]) return is_less(a.at[i], b.at[i]);
    }
    if (a.from != b.from) return a.from < b.from;
    if (a.to != b.to) return a.to < b.to;
    return a.weight < b.weight;
}

}  // namespace filigree::curves
