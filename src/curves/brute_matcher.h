// For tests alone: a matcher that tries every correspondence of characteristic points and asks of sampled points
// whether they lie on the design. It shares no code with the search; elements alone come from there, as data.
//
// Its transforms are less accurate, so it accepts what lies within a reach well above the tolerance of the search, and
// scenes must leave nothing in between.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "curves/shape.h"

namespace filigree::curves::brute {

using Complex = std::complex<double>;

struct Map {
    Complex m{1, 0}, t;
    bool flips = false;

    Complex operator()(Complex z) const { return m * (flips ? std::conj(z) : z) + t; }
};
inline Map undone(const Map& map) {
    Map back;
    back.flips = map.flips;
    back.m = 1.0 / (map.flips ? std::conj(map.m) : map.m);
    back.t = -back.m * (map.flips ? std::conj(map.t) : map.t);
    return back;
}
inline Map chained(const Map& outer, const Map& inner) {
    Map both;
    both.flips = outer.flips != inner.flips;
    both.m = outer.m * (outer.flips ? std::conj(inner.m) : inner.m);
    both.t = outer(inner.t);
    return both;
}
inline std::vector<Map> maps_between(Complex p, Complex q, Complex to_p, Complex to_q) {
    const Complex direct = (to_q - to_p) / (q - p), flipped = (to_q - to_p) / std::conj(q - p);
    return {{direct, to_p - direct * p, false}, {flipped, to_p - flipped * std::conj(p), true}};
}

// One curve, evaluated by de Casteljau's algorithm or by its angles.
struct Curve {
    ElementKind kind = ElementKind::line;
    std::uint32_t layer = 0;
    double weight = 1;
    std::vector<Complex> control;
    double from = 0, to = 1;  // of arcs

    explicit Curve(const Element& e) : kind(e.kind), layer(e.layer), weight(e.weight), from(e.from), to(e.to) {
        const std::size_t count = kind == ElementKind::point                                  ? 1
                                  : kind == ElementKind::line                                 ? 2
                                  : kind == ElementKind::parabola || kind == ElementKind::arc ? 3
                                                                                              : 4;
        for (std::size_t i = 0; i < count; ++i) control.emplace_back(e.at[i].x, e.at[i].y);
        if (kind == ElementKind::parabola) lay_axes();
    }

    Complex at(double t) const {
        if (kind == ElementKind::arc) {
            const double angle = from + (to - from) * t;
            return control[0] + control[1] * std::cos(angle) + control[2] * std::sin(angle);
        }
        std::vector<Complex> left = control;
        while (left.size() > 1) {
            for (std::size_t i = 0; i + 1 < left.size(); ++i) left[i] = left[i] * (1 - t) + left[i + 1] * t;
            left.pop_back();
        }
        return left[0];
    }

    // Whether a point lies on the curve to within `reach`.
    bool holds(Complex z, double reach) const {
        switch (kind) {
            case ElementKind::point:
                return std::abs(z - control[0]) <= reach;
            case ElementKind::line: {
                const Complex way = control[1] - control[0], off = (z - control[0]) / way;
                const double slack = reach / std::abs(way);
                return std::fabs(off.imag()) <= slack && off.real() >= -slack && off.real() <= 1 + slack;
            }
            case ElementKind::parabola: {
                const Complex own = (z - vertex) / axis;  // y = x^2 / (4 focal), along +i
                const double height = own.real() * own.real() / (4 * focal), slope = own.real() / (2 * focal);
                const double tilt = std::sqrt(1 + slope * slope);
                const double slack = reach / tilt;
                return std::fabs(own.imag() - height) <= reach * tilt && own.real() >= low - slack &&
                       own.real() <= high + slack;
            }
            case ElementKind::arc: {
                const double u = std::abs(control[1]), v = std::abs(control[2]);
                const Complex own = (z - control[0]) / (control[1] / u);
                const Complex unit{own.real() / u, own.imag() / v};
                const Complex slope{unit.real() / u, unit.imag() / v};
                if (std::fabs(std::norm(unit) - 1) > 2 * std::abs(slope) * reach) return false;
                const double slack = reach / std::min(u, v);
                double angle = std::arg(unit);
                while (angle < from - slack) angle += 2 * std::numbers::pi;
                while (angle > to + slack) angle -= 2 * std::numbers::pi;
                return angle >= from - slack;
            }
            case ElementKind::cubic: {
                constexpr int steps = 64;
                for (int i = 0; i <= steps; ++i) {
                    double width = 1.0 / steps, t = i * width;
                    if (std::abs(at(t) - z) > 8 * width * std::abs(control[3] - control[0]) + 30 * reach &&
                        std::abs(at(t) - z) > 0.25 * size()) {
                        continue;
                    }
                    // Ternary search around the sample.
                    double a = std::max(0.0, t - width), b = std::min(1.0, t + width);
                    for (int round = 0; round < 60; ++round) {
                        const double c = a + (b - a) / 3, d = b - (b - a) / 3;
                        (std::abs(at(c) - z) < std::abs(at(d) - z) ? b : a) =
                            std::abs(at(c) - z) < std::abs(at(d) - z) ? d : c;
                    }
                    if (std::abs(at(0.5 * (a + b)) - z) <= reach) return true;
                }
                return false;
            }
        }
        return false;
    }
    double size() const {
        double most = 0;
        for (const Complex& c : control) most = std::max(most, std::abs(c - control[0]));
        return most;
    }

    // Of a parabola: its vertex, the unit of the x axis at it, the focal length, and the range of x.
    Complex vertex, axis{1, 0};
    double focal = 1, low = 0, high = 0;

private:
    void lay_axes() {
        const Complex p = at(0), q = at(0.5), r = at(1);
        const Complex second = p - 2.0 * q + r;
        axis = second / std::abs(second) / Complex{0, 1};
        const auto own = [&](Complex z) { return (z - q) / axis; };
        const double x0 = own(p).real(), y0 = own(p).imag(), x1 = own(r).real(), y1 = own(r).imag();
        // Through the three points, the middle one at 0: y = alpha x^2 + beta x.
        const double alpha = (y0 / x0 - y1 / x1) / (x0 - x1), beta = y0 / x0 - alpha * x0;
        const double x = -beta / (2 * alpha);
        vertex = q + axis * Complex{x, alpha * x * x + beta * x};
        focal = 1 / (4 * alpha);
        low = std::min(x0, x1) - x;
        high = std::max(x0, x1) - x;
    }
};

using Curves = std::vector<Curve>;
inline Curves curves_of(const Shape& shape) {
    Curves curves;
    for (const Element& e : shape.elements) curves.emplace_back(e);
    return curves;
}

// Whether all of the left side, moved, lies on the design, each curve on one.
inline bool lies_on(const Curves& left, const Map& map, const Curves& design, double reach) {
    for (const Curve& part : left) {
        const bool is_carried = std::any_of(design.begin(), design.end(), [&](const Curve& carrier) {
            if (carrier.kind != part.kind || carrier.layer != part.layer || carrier.weight < part.weight) return false;
            for (const double t : {0.0, 1.0, 0.5, 0.3, 0.8, 0.1, 0.9}) {
                if (!carrier.holds(map(part.at(t)), reach)) return false;
            }
            return true;
        });
        if (!is_carried) return false;
    }
    return true;
}

// Pairs of points that a similarity carries along: those of a single curve that fix it, in all orders that could be.
inline std::vector<std::array<Complex, 2>> own_pairs(const Curve& curve) {
    switch (curve.kind) {
        case ElementKind::parabola:
            return {{curve.vertex, curve.vertex + curve.axis * Complex{0, curve.focal}}};
        case ElementKind::arc:
            if (std::fabs(std::abs(curve.control[1]) - std::abs(curve.control[2])) < 1e-6) return {};
            return {{curve.control[0], curve.control[0] + curve.control[1]},
                    {curve.control[0], curve.control[0] - curve.control[1]}};
        case ElementKind::cubic: {
            const Complex d = curve.control[0], c = 3.0 * (curve.control[1] - curve.control[0]);
            const Complex b = 3.0 * (curve.control[0] - 2.0 * curve.control[1] + curve.control[2]);
            const Complex a = curve.control[3] - d - c - b;
            const double t = -(b / a).real() / 3;
            const Complex place = ((a * t + b) * t + c) * t + d, l = ((3.0 * a * t + 2.0 * b) * t + c) / a;
            const Complex off = a * std::pow(std::abs(l), 1.5);
            return {{place, place + off}, {place, place - off}};
        }
        default:
            return {};
    }
}

// Points that are carried to such points whatever the curves are cut to: labelled points, centres, and where the
// descriptors of lines and circles meet.
inline std::vector<Complex> points_of(const Curves& curves) {
    std::vector<Complex> points;
    const auto is_circle = [](const Curve& c) { return c.kind == ElementKind::arc && own_pairs(c).empty(); };
    for (const Curve& c : curves) {
        if (c.kind == ElementKind::point || is_circle(c)) points.push_back(c.control[0]);
    }
    for (std::size_t i = 0; i < curves.size(); ++i) {
        for (std::size_t j = 0; j < curves.size(); ++j) {
            const Curve &a = curves[i], &b = curves[j];
            if (a.kind == ElementKind::line && b.kind == ElementKind::line && i < j) {
                const Complex u = a.control[1] - a.control[0], v = b.control[1] - b.control[0];
                const double turn = (std::conj(u) * v).imag();
                if (std::fabs(turn) < 1e-6 * std::abs(u) * std::abs(v)) continue;
                points.push_back(a.control[0] + u * ((std::conj(b.control[0] - a.control[0]) * v).imag() / turn));
            }
            // The foot of a centre on a line stands for both crossings, and is there where they are not.
            if (a.kind == ElementKind::line && (is_circle(b) || b.kind == ElementKind::point)) {
                const Complex u = a.control[1] - a.control[0];
                points.push_back(a.control[0] + u * ((b.control[0] - a.control[0]) / u).real());
            }
        }
    }
    return points;
}

// All maps of the left side onto the design that are not smaller; those that give the same picture once.
inline std::vector<Map> all_maps(const Shape& left_shape, const Shape& design_shape, double min_scale, double reach) {
    const Curves left = curves_of(left_shape), design = curves_of(design_shape);
    std::vector<Map> found;
    const auto take = [&](const Map& map) {
        if (!(std::abs(map.m) >= min_scale) || !lies_on(left, map, design, reach)) return;
        for (const Map& other : found) {
            if (lies_on(left, chained(undone(other), map), left, reach / std::abs(other.m))) return;
        }
        found.push_back(map);
    };
    // By the curve that fixes the transform and is the least shallow.
    const Curve* pivot = nullptr;
    for (const Curve& c : left) {
        if (!own_pairs(c).empty() && (pivot == nullptr || c.focal < pivot->focal)) pivot = &c;
    }
    if (pivot != nullptr) {
        const auto [p, q] = own_pairs(*pivot)[0];
        for (const Curve& c : design) {
            if (c.kind != pivot->kind) continue;
            for (const auto& [to_p, to_q] : own_pairs(c)) {
                for (const Map& map : maps_between(p, q, to_p, to_q)) take(map);
            }
        }
        return found;
    }
    const std::vector<Complex> from = points_of(left), to = points_of(design);
    Complex p, q;
    for (const Complex& a : from) {
        for (const Complex& b : from) {
            if (std::abs(a - b) > std::abs(p - q)) {
                p = a;
                q = b;
            }
        }
    }
    if (!(std::abs(p - q) > 1e-6)) return found;
    for (const Complex& a : to) {
        for (const Complex& b : to) {
            if (std::abs(a - b) < 1e-9) continue;
            for (const Map& map : maps_between(p, q, a, b)) take(map);
        }
    }
    return found;
}

}  // namespace filigree::curves::brute
