#include "curves/intrinsic.h"

#include <cmath>

namespace filigree::curves {

Curvature curvature_of(const Element& parabola) {
    const Vec a = parabola.at[0] - 2 * parabola.at[1] + parabola.at[2], b = 2 * (parabola.at[1] - parabola.at[0]);
    return {4 * dot(a, a), 4 * dot(a, b), dot(b, b), 2 * cross(b, a)};
}

double curvature_at(const Curvature& curvature, double t) {
    const double speed = (curvature.A * t + curvature.B) * t + curvature.C;
    return curvature.D / (speed * std::sqrt(speed));
}

std::optional<IntrinsicMap> intrinsic_map(const Curvature& first, const Curvature& second) {
    if (first.A == 0 || first.D == 0 || second.A == 0 || second.D == 0) return std::nullopt;
    const double ratio = second.A / first.A, turn = first.D / second.D;
    IntrinsicMap map;
    map.lambda = std::copysign(ratio * std::sqrt(ratio) * turn * turn, first.D * second.D);
    const double rate = first.A * second.D / (second.A * first.D);
    map.mu = {rate, -rate};
    for (std::size_t i = 0; i < 2; ++i) {
        map.nu[i] = map.mu[i] * first.B / (2 * first.A) - second.B / (2 * second.A);
    }
    return map;
}

}  // namespace filigree::curves
