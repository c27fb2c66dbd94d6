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
inline std::array<Map, 2> maps_between(Complex p, Complex q, Complex to_p, Complex to_q) {
    const Complex per_way = std::conj(q - p) / std::norm(q - p);
    const Complex direct = (to_q - to_p) * per_way, flipped = (to_q - to_p) * std::conj(per_way);
    return {Map{direct, to_p - direct * p, false}, Map{flipped, to_p - flipped * std::conj(p), true}};
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
        if (kind == ElementKind::line) {
            high = std::abs(control[1] - control[0]);
            axis = (control[1] - control[0]) / high;
        }
        for (const double t : {0.0, 1.0, 0.5, 0.3, 0.8, 0.1, 0.9}) samples.push_back(at(t));
        for (int i = 1; i < 16 && kind == ElementKind::arc; ++i) samples.push_back(at(i / 16.0));
        for (std::size_t i = 0; i <= trace_steps && kind == ElementKind::cubic; ++i) {
            trace.push_back(at(static_cast<double>(i) / trace_steps));
            if (i > 0) longest_step = std::max(longest_step, std::abs(trace.back() - trace[trace.size() - 2]));
        }
    }

    Complex at(double t) const {
        if (kind == ElementKind::arc) {
            const double angle = from + (to - from) * t;
            return control[0] + control[1] * std::cos(angle) + control[2] * std::sin(angle);
        }
        std::array<Complex, 4> left{};
        std::copy(control.begin(), control.end(), left.begin());
        for (std::size_t count = control.size(); count > 1; --count) {
            for (std::size_t i = 0; i + 1 < count; ++i) left[i] = left[i] * (1 - t) + left[i + 1] * t;
        }
        return left[0];
    }

    // Whether a point lies on the curve to within `reach`.
    bool holds(Complex z, double reach) const {
        switch (kind) {
            case ElementKind::point:
                return std::abs(z - control[0]) <= reach;
            case ElementKind::line: {
                const Complex off = (z - control[0]) * std::conj(axis);
                return std::fabs(off.imag()) <= reach && off.real() >= -reach && off.real() <= high + reach;
            }
            case ElementKind::parabola: {
                const Complex own = (z - vertex) * std::conj(axis);  // y = x^2 / (4 focal), along +i
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
            case ElementKind::cubic:
                return is_near_cubic(z, reach);
        }
        return false;
    }
    double size() const {
        double most = 0;
        for (const Complex& c : control) most = std::max(most, std::abs(c - control[0]));
        return most;
    }

    // Of a parabola: its vertex, the unit of the x axis at it, the focal length, and the range of x. Of a line the unit
    // along it and its length.
    Complex vertex, axis{1, 0};
    double focal = 1, low = 0, high = 0;

    // Points along the curve; of arcs so many that one that is nearly closed does not pass where another is open.
    std::vector<Complex> samples;

private:
    // By the nearest of some points and a search between its neighbours, from every point that may be nearest.
    bool is_near_cubic(Complex z, double reach) const {
        std::array<double, trace_steps + 1> distance{};  // squared
        for (std::size_t i = 0; i <= trace_steps; ++i) distance[i] = std::norm(trace[i] - z);
        const double far = (reach + 2 * longest_step) * (reach + 2 * longest_step);
        for (std::size_t i = 0; i <= trace_steps; ++i) {
            const bool is_least =
                (i == 0 || distance[i] <= distance[i - 1]) && (i == trace_steps || distance[i] <= distance[i + 1]);
            if (!is_least || distance[i] > far) continue;
            double a = std::max(0.0, (static_cast<double>(i) - 1) / trace_steps);
            double b = std::min(1.0, (static_cast<double>(i) + 1) / trace_steps);
            for (int round = 0; round < 60; ++round) {
                const double c = a + (b - a) / 3, d = b - (b - a) / 3;
                if (std::norm(at(c) - z) < std::norm(at(d) - z)) {
                    b = d;
                } else {
                    a = c;
                }
            }
            if (std::abs(at(0.5 * (a + b)) - z) <= reach) return true;
        }
        return false;
    }

    // So many that a sharp turn does not hide a nearest point.
    static constexpr std::size_t trace_steps = 160;
    std::vector<Complex> trace;
    double longest_step = 0;

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
    return std::all_of(left.begin(), left.end(), [&](const Curve& part) {
        return std::any_of(design.begin(), design.end(), [&](const Curve& carrier) {
            if (carrier.kind != part.kind || carrier.layer != part.layer || carrier.weight < part.weight) return false;
            return std::all_of(part.samples.begin(), part.samples.end(),
                               [&](Complex z) { return carrier.holds(map(z), reach); });
        });
    });
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
// descriptors of lines and circles meet, of lines at no less than some angle.
inline std::vector<Complex> points_of(const Curves& curves, double least_sine) {
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
                if (std::fabs(turn) < least_sine * std::abs(u) * std::abs(v)) continue;
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

// The two points that are the farthest apart.
inline std::array<Complex, 2> far_pair(const std::vector<Complex>& points) {
    std::array<Complex, 2> pair{};
    for (const Complex& a : points) {
        for (const Complex& b : points) {
            if (std::norm(a - b) > std::norm(pair[0] - pair[1])) pair = {a, b};
        }
    }
    return pair;
}

// Whether a left side lies on designs in finitely many ways, by what this matcher knows.
inline bool is_fixed(const Curves& left) {
    if (std::any_of(left.begin(), left.end(), [](const Curve& c) { return !own_pairs(c).empty(); })) return true;
    const auto [p, q] = far_pair(points_of(left, 0.05));
    return std::abs(p - q) > 1e-3;
}

// Whether two maps make the same picture of the left side, to within `reach` there.
inline bool is_same(const Curves& left, const Map& a, const Map& b, double reach) {
    const double ratio = std::abs(a.m) / std::abs(b.m);
    return std::fabs(ratio - 1) < 1e-3 && lies_on(left, chained(undone(b), a), left, reach / std::abs(b.m));
}

// All maps of the left side onto the design that are not smaller; those that give the same picture once.
inline std::vector<Map> all_maps(const Shape& left_shape, const Shape& design_shape, double min_scale, double reach) {
    const Curves left = curves_of(left_shape), design = curves_of(design_shape);
    std::vector<Map> found;
    const auto take = [&](const Map& map) {
        if (!(std::norm(map.m) >= min_scale * min_scale) || !lies_on(left, map, design, reach)) return;
        for (const Map& other : found) {
            if (is_same(left, map, other, reach)) return;
        }
        found.push_back(map);
    };
    // By each curve that fixes the transform, since one may be nearly straight.
    bool has_pivot = false;
    for (const Curve& pivot : left) {
        const auto pairs = own_pairs(pivot);
        if (pairs.empty()) continue;
        has_pivot = true;
        for (const Curve& c : design) {
            if (c.kind != pivot.kind) continue;
            for (const auto& [to_p, to_q] : own_pairs(c)) {
                for (const Map& map : maps_between(pairs[0][0], pairs[0][1], to_p, to_q)) take(map);
            }
        }
    }
    if (has_pivot) return found;
    const auto [p, q] = far_pair(points_of(left, 0.05));
    const std::vector<Complex> to = points_of(design, 0.049);
    for (const Complex& a : to) {
        for (const Complex& b : to) {
            if (std::norm(a - b) < 1e-18) continue;
            for (const Map& map : maps_between(p, q, a, b)) take(map);
        }
    }
    return found;
}

}  // namespace filigree::curves::brute
