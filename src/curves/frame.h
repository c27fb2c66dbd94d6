// The intrinsic frame of a parabola arc: what of it stays the same under similarities, and the similarities that carry
// one parabola onto another.
//
// With the vertex V and a multiplier m, z -> V + m z maps the canonical parabola s + i s^2 / 2 onto the descriptor. The
// slope s there does not change under similarities (a reflection negates it), so an arc can lie on another, moved, only
// where its interval of slopes lies in the other's: known before any transform is. One arc fixes the whole similarity
// but for the reflection in its axis. This is what the paper's equations (7) to (9) come to, section 3.1.
#pragma once

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

// The chord over the sagitta, squared: how badly the arc's own noise is magnified in a transform found from it alone.
double looseness(const Element& parabola);

// The multiplier of the similarity that carries one descriptor onto another: of the direct one, or of the one that
// reflects, which carries slope s to -s.
Vec multiplier(const ParabolaFrame& from, const ParabolaFrame& to, bool is_reflected);

}  // namespace filigree::curves
