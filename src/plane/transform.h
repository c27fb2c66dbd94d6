// Affine maps of the plane, as SVG writes them: x' = a x + c y + e, y' = b x + d y + f.
#pragma once

#include "plane/point.h"

namespace filigree {

struct Transform {
    double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;

    bool operator==(const Transform&) const = default;
};

constexpr Vec apply(const Transform& t, Vec p) { return {t.a * p.x + t.c * p.y + t.e, t.b * p.x + t.d * p.y + t.f}; }
// First `inner`, then `outer`.
constexpr Transform compose(const Transform& outer, const Transform& inner) {
    return {outer.a * inner.a + outer.c * inner.b,           outer.b * inner.a + outer.d * inner.b,
            outer.a * inner.c + outer.c * inner.d,           outer.b * inner.c + outer.d * inner.d,
            outer.a * inner.e + outer.c * inner.f + outer.e, outer.b * inner.e + outer.d * inner.f + outer.f};
}
constexpr double determinant(const Transform& t) { return t.a * t.d - t.b * t.c; }
// The map back; its determinant must not be zero.
constexpr Transform inverse(const Transform& t) {
    const double k = determinant(t);
    return {t.d / k, -t.b / k, -t.c / k, t.a / k, (t.c * t.f - t.d * t.e) / k, (t.b * t.e - t.a * t.f) / k};
}
// Whether the map keeps all ratios of lengths (turns, reflections and even scalings, exactly).
constexpr bool is_similarity(const Transform& t) { return (t.a == t.d && t.b == -t.c) || (t.a == -t.d && t.b == t.c); }

constexpr Transform translation(Vec by) { return {1, 0, 0, 1, by.x, by.y}; }
constexpr Transform scaling(double x, double y) { return {x, 0, 0, y, 0, 0}; }
Vec unit_at_degrees(double angle);         // from +x towards +y, as all angles
Transform rotation_degrees(double angle);  // from +x towards +y
// As SVG's skewX and skewY together: x' = x + y tan(x_angle), y' = y + x tan(y_angle). Not finite at 90 degrees.
Transform skew_degrees(double x_angle, double y_angle);

}  // namespace filigree
