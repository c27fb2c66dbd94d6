#include "curves/moments.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace filigree::curves {
namespace {

// Calls visit(place, weight) for places along an element that stand for stretches of it: Gauss's rule of five points on
// eight parts.
template <class Visit>
void for_each_place(const Element& e, Visit visit) {
    constexpr int parts = 8;
    constexpr std::array<double, 5> places = {0, -0.5384693101056831, 0.5384693101056831, -0.9061798459386640,
                                              0.9061798459386640};
    constexpr std::array<double, 5> weights = {0.5688888888888889, 0.4786286704993665, 0.4786286704993665,
                                               0.2369268850561891, 0.2369268850561891};
    const Interval on = interval_of(e);
    const double half = 0.5 * (on.to - on.from) / parts;
    for (int part = 0; part < parts; ++part) {
        const double middle = on.from + half * (2 * part + 1);
        for (std::size_t i = 0; i < places.size(); ++i) {
            const double t = middle + half * places[i];
            visit(point_at(e, t), weights[i] * half * length(velocity_at(e, t)));
        }
    }
}

template <class Visit>
void for_each_place(const Shape& shape, Visit visit) {
    const bool is_curved = has_curves(shape);
    for (const Element& e : shape.elements) {
        if (e.kind != ElementKind::point) {
            for_each_place(e, visit);
        } else if (!is_curved) {
            visit(e.at[0], 1.0);
        }
    }
}

}  // namespace

bool has_curves(const Shape& shape) {
    return std::any_of(shape.elements.begin(), shape.elements.end(),
                       [](const Element& e) { return e.kind != ElementKind::point; });
}

Moments moments_of(const Shape& shape) {
    Moments moments;
    Vec sum;
    for_each_place(shape, [&](Vec p, double weight) {
        moments.length += weight;
        sum = sum + p * weight;
    });
    if (!(moments.length > 0)) return moments;
    moments.middle = sum * (1 / moments.length);
    double xx = 0, yy = 0;
    for_each_place(shape, [&](Vec p, double weight) {
        const Vec off = p - moments.middle;
        xx += off.x * off.x * weight;
        yy += off.y * off.y * weight;
    });
    moments.along_x = std::sqrt(xx / moments.length);
    moments.along_y = std::sqrt(yy / moments.length);
    moments.spread = std::sqrt((xx + yy) / moments.length);
    return moments;
}

}  // namespace filigree::curves
