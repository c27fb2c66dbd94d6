#include "curves/frame.h"

#include <algorithm>
#include <cmath>

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

double looseness(const Element& parabola) {
    const Vec chord = parabola.at[2] - parabola.at[0];
    const double cc = dot(chord, chord), area = cross(chord, parabola.at[1] - parabola.at[0]);
    return 4 * cc * cc / (area * area);
}

Vec multiplier(const ParabolaFrame& from, const ParabolaFrame& to, bool is_reflected) {
    return is_reflected ? -over(to.m, conjugate(from.m)) : over(to.m, from.m);
}

}  // namespace filigree::curves
