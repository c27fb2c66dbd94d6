// For tests alone: random elements and shapes, and where points lie on them, found by looking.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/elementary.h"
#include "base/test_cases.h"
#include "curves/element.h"
#include "curves/shape.h"

namespace filigree::curves {

// Coordinates of random elements: multiples of 1/8, so that sums are exact, or any.
enum class Coordinates { dyadic, any };

inline Vec random_place(CaseRandom& random, Coordinates in, double size = 10) {
    const Vec p{random.between(-size, size), random.between(-size, size)};
    return in == Coordinates::any ? p : Vec{std::round(p.x * 8) / 8, std::round(p.y * 8) / 8};
}

// Of a kind, with a length of some 1..20 and a shape that is not nearly degenerate.
inline Element random_element(CaseRandom& random, ElementKind kind, Coordinates in = Coordinates::any) {
    for (;;) {
        const Vec p = random_place(random, in), q = random_place(random, in), r = random_place(random, in);
        if (kind == ElementKind::point) return point_element(p);
        if (length(q - p) < 1) continue;
        if (kind == ElementKind::line) return line_element(p, q);
        if (std::fabs(cross(q - p, r - q)) < 0.2 * length(q - p) * length(r - q)) continue;
        if (length(r - q) < 1 || length(r - p) < 1) continue;
        if (kind == ElementKind::parabola) return parabola_element(p, q, r);
        if (kind == ElementKind::cubic) {
            const Element e = cubic_element(p, q, r, random_place(random, in));
            // Nearly a parabola, or with a cusp near by: the same curve to within noise is hard to tell then.
            if (length(e.at[3] - e.at[0] + 3 * (e.at[1] - e.at[2])) < 2) continue;
            double slowest = 1e300;
            for (int i = -20; i <= 40; ++i) slowest = std::min(slowest, length(velocity_at(e, i / 20.0)));
            if (slowest > 2) return e;
            continue;
        }
        const double radius = in == Coordinates::any ? random.between(1, 5) : random.whole(1, 5);
        const double other = random.coin() ? radius : radius * random.between(0.3, 0.9);
        if (random.below(8) == 0) return circle_element(p, radius);
        const double from =
            in == Coordinates::any ? random.between(-4, 4) : 0.25 * elementary::pi * random.whole(-4, 4);
        const double sweep =
            in == Coordinates::any ? random.between(0.5, 6) : 0.25 * elementary::pi * random.whole(1, 7);
        const double turned = random.coin() ? 0 : random.between(-180, 180);
        const Vec u = unit_at_degrees(turned) * radius;
        return arc_element(p, u, perpendicular(u) * (other / radius), from, from + sweep);
    }
}

inline constexpr ElementKind all_kinds[] = {ElementKind::point, ElementKind::line, ElementKind::parabola,
                                            ElementKind::arc, ElementKind::cubic};

// Moves the points of an element a little, each on its own.
inline Element shaken(Element e, CaseRandom& random, double by) {
    const auto shake = [&](Vec p) { return p + Vec{random.between(-by, by), random.between(-by, by)}; };
    if (e.kind == ElementKind::arc) {
        const double radius = length(e.at[1]), grown = 1 + random.between(-by, by) / radius;
        Element moved = arc_element(shake(e.at[0]), e.at[1] * grown, e.at[2] * grown, e.from, e.to);
        moved.layer = e.layer;
        moved.weight = e.weight;
        return moved;
    }
    const std::size_t count = e.kind == ElementKind::point      ? 1
                              : e.kind == ElementKind::line     ? 2
                              : e.kind == ElementKind::parabola ? 3
                                                                : 4;
    for (std::size_t i = 0; i < count; ++i) e.at[i] = shake(e.at[i]);
    return e;
}

// A random similarity: scale 0.4..2.5, any angle, mirrored or not; of dyadic numbers a quarter turn and whole shift.
inline Transform random_similarity(CaseRandom& random, Coordinates in = Coordinates::any) {
    const bool is_exact = in == Coordinates::dyadic;
    const double scale = is_exact ? (random.coin() ? 1 : 2) : random.between(0.4, 2.5);
    const double angle = is_exact ? 90.0 * random.below(4) : random.between(-180, 180);
    const Transform turned = compose(scaling(scale, random.coin() ? scale : -scale), rotation_degrees(angle));
    return compose(translation(random_place(random, in, 20)), turned);
}

// Whether a point lies on an element, to within a distance: by halving the element until a half is too far away to
// come as near as that, or its middle is near enough.
inline bool lies_on(const Element& e, Vec p, double within) {
    if (e.kind == ElementKind::point) return length(e.at[0] - p) <= within;
    double fastest = 0;
    for (std::size_t i = 0; i < 3; ++i) fastest = std::max(fastest, 3 * length(e.at[i + 1] - e.at[i]));
    if (e.kind == ElementKind::line) fastest = length(e.at[1] - e.at[0]);
    if (e.kind == ElementKind::parabola) fastest = 2 * std::max(length(e.at[1] - e.at[0]), length(e.at[2] - e.at[1]));
    if (e.kind == ElementKind::arc) fastest = length(e.at[1]) * (1 + 1e-9);
    std::vector<Interval> open = {interval_of(e)};
    while (!open.empty()) {
        const auto [from, to] = open.back();
        open.pop_back();
        const double middle = 0.5 * (from + to), off = length(point_at(e, middle) - p);
        if (off <= within) return true;
        if (off - fastest * 0.5 * (to - from) > within || to - from < 1e-13) continue;
        open.push_back({from, middle});
        open.push_back({middle, to});
    }
    return false;
}

}  // namespace filigree::curves
