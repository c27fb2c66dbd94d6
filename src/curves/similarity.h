// Similarities of the plane in complex numbers: z -> m z + t, or m conj(z) + t where it reflects. Paper: section 3.1.
#pragma once

#include "plane/transform.h"

namespace filigree::curves {

constexpr Vec conjugate(Vec z) { return {z.x, -z.y}; }
constexpr Vec times(Vec z, Vec w) { return {z.x * w.x - z.y * w.y, z.x * w.y + z.y * w.x}; }
// z / w; exact where the quotient is and w is a power of two times a whole unit.
constexpr Vec over(Vec z, Vec w) {
    const double size = dot(w, w);
    return {(z.x * w.x + z.y * w.y) / size, (z.y * w.x - z.x * w.y) / size};
}

struct Similarity {
    Vec m{1, 0};  // the scale times the unit vector that +x is turned to
    Vec t;
    bool is_reflected = false;  // across the x axis, before all else

    bool operator==(const Similarity&) const = default;
};

constexpr Vec unreflected(const Similarity& s, Vec z) { return s.is_reflected ? conjugate(z) : z; }
constexpr Vec apply(const Similarity& s, Vec z) { return times(s.m, unreflected(s, z)) + s.t; }
constexpr Transform to_transform(const Similarity& s) {
    if (s.is_reflected) return {s.m.x, s.m.y, s.m.y, -s.m.x, s.t.x, s.t.y};
    return {s.m.x, s.m.y, -s.m.y, s.m.x, s.t.x, s.t.y};
}
// Of a transform that is one.
constexpr Similarity to_similarity(const Transform& t) { return {{t.a, t.b}, {t.e, t.f}, determinant(t) < 0}; }
// The one with this multiplier that carries `from` to `to`.
constexpr Similarity carrying(Vec from, Vec to, Vec m, bool is_reflected) {
    Similarity s{m, {}, is_reflected};
    s.t = to - times(m, unreflected(s, from));
    return s;
}

}  // namespace filigree::curves
