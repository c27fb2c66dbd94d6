#include "plane/arc.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"

namespace filigree {

namespace {

// Cubics of 9 degrees err by 3e-10 of the radius.
constexpr double cubic_turn = elementary::pi / 20;

// R(rotation) diag(radii) (p), the ellipse's parameter circle to the plane.
Vec from_circle(const CentreArc& arc, Vec p) { return p.x * arc.across + p.y * arc.along; }

}  // namespace

CentreArc centre_arc(Vec from, const Vec shape[2], Vec to) {
    CentreArc arc;
    arc.from = from;
    const double rx = std::fabs(shape[0].x);
    const double ry = std::fabs(shape[0].y);
    if (from == to || !(rx > 0) || !(ry > 0)) return arc;
    const elementary::CosSin axis = elementary::cos_sin_degrees(std::fmod(shape[1].x, 360));
    const bool is_large = shape[1].y == 1 || shape[1].y == 3;
    const bool is_sweep = shape[1].y >= 2;

    // Half the chord, backwards, in the ellipse's own axes where its radii are 1.
    const Vec half = 0.5 * (from - to);
    const double u = (axis.cos * half.x + axis.sin * half.y) / rx;
    const double v = (axis.cos * half.y - axis.sin * half.x) / ry;
    const double reach = u * u + v * v;
    // Two halves of a circle are common, and there a rounding error of the end points would enter the centre
    // as its square root: within the error that they may carry, the chord is a diameter.
    const double largest = std::max({std::fabs(from.x), std::fabs(from.y), std::fabs(to.x), std::fabs(to.y)});
    const double slack = 1e-15 * (1 + largest * (std::fabs(u) / rx + std::fabs(v) / ry));
    double enlarged = 1;
    double offset = 0;  // of the centre from the chord, over half the chord's length
    double half_turn = elementary::pi / 2;
    if (reach > 1 - slack) {
        enlarged = std::sqrt(reach);
    } else {
        offset = std::sqrt(1 / reach - 1);
        if (is_large == is_sweep) offset = -offset;
        half_turn = elementary::atan2(std::sqrt(reach), std::sqrt(1 - reach));
        if (is_large) half_turn = elementary::pi - half_turn;
    }
    arc.turn = is_sweep ? 2 * half_turn : -2 * half_turn;
    arc.start = elementary::atan2(v + offset * u, u - offset * v);
    arc.across = enlarged * rx * Vec{axis.cos, axis.sin};
    arc.along = enlarged * ry * Vec{-axis.sin, axis.cos};
    arc.largest_radius = enlarged * std::max(rx, ry);
    // Chords so short beside their radii that nothing remains of them, and numbers that ran over.
    const bool is_sound = reach > 0 && std::isfinite(offset) && std::isfinite(arc.start) &&
                          std::isfinite(arc.largest_radius) && std::isfinite(length(arc.across) + length(arc.along));
    arc.is_line = !is_sound;
    return arc;
}

Vec point_at(const CentreArc& arc, double part) {
    // From the start point, not from the centre, which may be far away.
    const double half = 0.5 * arc.turn * part;
    const double chord = 2 * elementary::cos_sin(half).sin;
    const elementary::CosSin direction = elementary::cos_sin(arc.start + half);
    return arc.from + from_circle(arc, {-chord * direction.sin, chord * direction.cos});
}

void append_cubics(Path& path, const CentreArc& arc, Vec to) {
    const int count = std::max(1, static_cast<int>(std::ceil(std::fabs(arc.turn) / cubic_turn)));
    const double reach = 4.0 / 3.0 * elementary::tan(arc.turn / count / 4);
    const auto tangent = [&](int i) {
        const elementary::CosSin at = elementary::cos_sin(arc.start + arc.turn * i / count);
        return from_circle(arc, reach * Vec{-at.sin, at.cos});
    };
    Vec here = arc.from;
    for (int i = 0; i < count; ++i) {
        const Vec next = i + 1 == count ? to : point_at(arc, static_cast<double>(i + 1) / count);
        path.verbs.push_back(Verb::cubic);
        path.points.insert(path.points.end(), {here + tangent(i), next - tangent(i + 1), next});
        here = next;
    }
}

}  // namespace filigree
