// The intrinsic frames of parabola and cubic arcs: what of them stays the same under similarities, and so the
// similarities that carry one onto another.
//
// Of a parabola with the vertex V, a multiplier m makes z -> V + m z map the canonical s + i s^2 / 2 onto the
// descriptor. The slope s there does not change under similarities (a reflection negates it), so an arc can lie on
// another, moved, only where its interval of slopes lies in the other's: known before any transform is. One arc fixes
// the whole similarity but for the reflection in its axis. This is what the paper's equations (7) to (9) come to,
// section 3.1.
//
// A cubic is V + a (u^3 + 3 i q u^2 + l u) with q real: what carries it onto another multiplies u by a real k.
#pragma once

#include <optional>

#include "curves/element.h"
#include "curves/similarity.h"

namespace filigree::curves {

struct ParabolaFrame {
    double low = 0, high = 0;  // the arc's interval of slopes
    Vec m;                     // |m| is the radius of curvature at the vertex, px
    double vertex = 0;         // the arc's parameter where the slope is 0
    double rate = 0;           // by how much the parameter grows with the slope
};

// Of a parabola that is no line.
ParabolaFrame frame_of(const Element& parabola);
inline double parameter_at(const ParabolaFrame& frame, double slope) { return frame.vertex + frame.rate * slope; }
// How much slope a px along the arc is, where the slope is this.
double slope_per_px(const ParabolaFrame& frame, double slope);
// The multiplier of the similarity that carries one descriptor onto another: of the direct one, or of the one that
// reflects, which carries slope s to -s.
Vec multiplier(const ParabolaFrame& from, const ParabolaFrame& to, bool is_reflected);

struct CubicFrame {
    Vec a, l;
    double q = 0;
    double origin = 0;  // the arc's parameter where u is 0; u grows as the parameter does
};

CubicFrame cubic_frame_of(const Element& cubic);
// What u is multiplied by when a cubic is carried onto another; the second of the two that are possible where
// `is_turned`. Nothing where there is none.
std::optional<double> rate_between(const CubicFrame& from, const CubicFrame& to, bool is_reflected, bool is_turned);
Vec multiplier(const CubicFrame& from, const CubicFrame& to, double rate, bool is_reflected);

// The chord over the sagitta, squared: how badly the own noise of an arc that turns to one side is magnified in a
// transform found from it alone.
double looseness(const Element& arc);

}  // namespace filigree::curves
