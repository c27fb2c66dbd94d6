// The intrinsic comparison of parabola arcs: the paper's equations (5) to (9), section 3.1.
//
// The search for subshapes stands on the same facts in another form (frame.h); these serve to explain and to check it.
#pragma once

#include <array>
#include <optional>

#include "curves/element.h"

namespace filigree::curves {

// B(t) = a t^2 + b t + c has the curvature D / (A t^2 + B t + C)^(3/2), and B^2 - 4 A C = -4 D^2. D is 0 exactly where
// the points lie in line.
struct Curvature {
    double A = 0, B = 0, C = 0, D = 0;
};
Curvature curvature_of(const Element& parabola);
double curvature_at(const Curvature& curvature, double t);  // signed, 1 / px

// How the descriptors of two parabolas map onto each other: curvature1(t) = curvature2(mu t + nu) / lambda, for both
// signs of mu, since a parabola is its own mirror image.
struct IntrinsicMap {
    double lambda = 1;  // |lambda|: the size of the first beside the second
    std::array<double, 2> mu{}, nu{};
};
// None where either is a straight line.
std::optional<IntrinsicMap> intrinsic_map(const Curvature& first, const Curvature& second);

}  // namespace filigree::curves
