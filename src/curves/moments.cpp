#include "curves/moments.h"

#include <algorithm>
#include <array>

namespace filigree::curves {
namespace {

void add(Moments& moments, Vec p, double weight) {
    moments.length += weight;
    moments.first = moments.first + p * weight;
    moments.xx += p.x * p.x * weight;
    moments.xy += p.x * p.y * weight;
    moments.yy += p.y * p.y * weight;
}

}  // namespace

Moments moments_of(const Shape& shape) {
    // Gauss's rule of five points on eight parts.
    constexpr int parts = 8;
    constexpr std::array<double, 5> places = {0, -0.5384693101056831, 0.5384693101056831, -0.9061798459386640,
                                              0.9061798459386640};
    constexpr std::array<double, 5> weights = {0.5688888888888889, 0.4786286704993665, 0.4786286704993665,
                                               0.2369268850561891, 0.2369268850561891};
    const bool has_curves = std::any_of(shape.elements.begin(), shape.elements.end(),
                                        [](const Element& e) { return e.kind != ElementKind::point; });
    Moments moments;
    for (const Element& e : shape.elements) {
        if (e.kind == ElementKind::point) {
            if (!has_curves) add(moments, e.at[0], 1);
            continue;
        }
        const Interval on = interval_of(e);
        const double half = 0.5 * (on.to - on.from) / parts;
        for (int part = 0; part < parts; ++part) {
            const double middle = on.from + half * (2 * part + 1);
            for (std::size_t i = 0; i < places.size(); ++i) {
                const double t = middle + half * places[i];
                add(moments, point_at(e, t), weights[i] * half * length(velocity_at(e, t)));
            }
        }
    }
    return moments;
}

Vec centroid_of(const Shape& shape) {
    const Moments moments = moments_of(shape);
    return moments.length > 0 ? moments.first * (1 / moments.length) : Vec{};
}

}  // namespace filigree::curves
