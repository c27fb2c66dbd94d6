#include "curves/frame.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"

namespace filigree::curves {

ParabolaFrame frame_of(const Element& parabola) {
    const Vec a = parabola.at[0] - 2 * parabola.at[1] + parabola.at[2], b = 2 * (parabola.at[1] - parabola.at[0]);
    const double aa = dot(a, a), ab = dot(a, b), ba = cross(b, a), size = std::sqrt(aa);
    ParabolaFrame frame;
    frame.vertex = -ab / (2 * aa);
    frame.rate = ba / (2 * aa);
    const double first = ab / ba, last = (2 * aa + ab) / ba;
    frame.low = std::min(first, last);
    frame.high = std::max(first, last);
    const double radius = ba * ba / (2 * aa * size);
    frame.m = Vec{a.y, -a.x} * (radius / size);
    return frame;
}

double slope_per_px(const ParabolaFrame& frame, double slope) {
    return 1 / std::sqrt(dot(frame.m, frame.m) * (1 + slope * slope));
}

Vec multiplier(const ParabolaFrame& from, const ParabolaFrame& to, bool is_reflected) {
    return is_reflected ? -over(to.m, conjugate(from.m)) : over(to.m, from.m);
}

CubicFrame cubic_frame_of(const Element& cubic) {
    const auto& at = cubic.at;
    const Vec b = 3 * (at[0] - 2 * at[1] + at[2]);
    CubicFrame frame;
    frame.a = at[3] - at[0] + 3 * (at[1] - at[2]);
    const Vec r = over(b, 3 * frame.a);
    frame.q = r.y;
    frame.origin = -r.x;
    frame.l = over(velocity_at(cubic, frame.origin), frame.a);
    return frame;
}

std::optional<double> rate_between(const CubicFrame& from, const CubicFrame& to, bool is_reflected, bool is_turned) {
    // By q or by l, whichever bends the arc more; q tells the sign, too.
    const double from_reach = std::fabs(from.origin - 0.5) + 0.5;
    double rate = 0;
    if (3 * std::fabs(from.q) * from_reach > length(from.l)) {
        if (is_turned) return std::nullopt;
        rate = (is_reflected ? -to.q : to.q) / from.q;
    } else {
        rate = std::sqrt(std::sqrt(dot(to.l, to.l) / dot(from.l, from.l)));
        if (is_turned) rate = -rate;
    }
    if (!(std::fabs(rate) > 0) || !std::isfinite(rate)) return std::nullopt;
    return rate;
}

Vec multiplier(const CubicFrame& from, const CubicFrame& to, double rate, bool is_reflected) {
    return over(to.a * (rate * rate * rate), is_reflected ? conjugate(from.a) : from.a);
}

double looseness(const Element& arc) {
    const Interval on = interval_of(arc);
    if (arc.kind == ElementKind::arc && on.to - on.from > elementary::pi) return 4;
    const Vec first = point_at(arc, on.from), chord = point_at(arc, on.to) - first;
    const double cc = dot(chord, chord), area = cross(chord, point_at(arc, 0.5 * (on.from + on.to)) - first);
    return cc * cc / (area * area);
}

}  // namespace filigree::curves
