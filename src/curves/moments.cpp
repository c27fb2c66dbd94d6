#include "curves/moments.h"

#include <algorithm>
#include <cmath>

#include "curves/quadrature.h"

namespace filigree::curves {
namespace {

// Calls visit(place, weight) for places along the curves that stand for stretches of them.
template <class Visit>
void for_each_place(const Shape& shape, Visit visit) {
    const bool is_curved = has_curves(shape);
    for (const Element& e : shape.elements) {
        if (e.kind != ElementKind::point) {
            for_each_gauss_place(interval_of(e), 8, [&](double t, double weight) {
                visit(point_at(e, t), weight * length(velocity_at(e, t)));
            });
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
