// Whether two elements have the same descriptor, and where one lies along the other's: what maximal shapes, sums,
// differences and the search for subshapes all stand on.
//
// Descriptors are compared where the elements are, never by their vertices, axes or centres: those of a shallow arc are
// known badly although the arc itself is known well. Paper: sections 2.2 and 3.1, figure 3.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "curves/element.h"

namespace filigree::curves {

struct Along {
    Interval on;               // of the carrier's parameter; of an arc with its middle nearest to the carrier's
    bool is_reversed = false;  // it runs against the carrier's parameter
    double distance = 0;       // px: how far it lies off the carrier's descriptor (control points; of arcs the points)
};

// Where `part` lies along the descriptor of `carrier`, beyond its ends, too. Nothing unless both are of one kind and
// layer (weights do not matter) and the distance is at most `reach`, px. Both in normal form, or pieces of such. Well
// conditioned where `part` is not much longer than `carrier`.
std::optional<Along> along(const Element& carrier, const Element& part, double reach);
// The same of two lines and of two parabolas, whatever their layers.
std::optional<Along> along_line(const Element& carrier, const Element& part, double reach);
std::optional<Along> along_parabola(const Element& carrier, const Element& part, double reach);

// The parameter at which a descriptor passes a point that lies near it; of an arc and of a cubic the one near `guess`.
double parameter_near(const Element& carrier, Vec point, double guess);

// How far a part that lies along a carrier sticks out beyond its ends, px along the curve; 0 inside.
double overhang(const Element& carrier, const Along& part);

// Whether all of `part` lies on `carrier`, as a length that must not exceed the tolerance: the larger of distance and
// overhang. Nothing where it exceeds `reach`.
std::optional<double> misfit(const Element& carrier, const Element& part, double reach);

// Of parabolas and cubics, from parameters near those of the part's ends: the piece of the carrier whose control points
// come nearest to the part's. Where a curve turns sharply its ends alone do not tell its parameters.
std::optional<Along> fitted_along(const Element& carrier, const Element& part, double first, double last, double reach);

// What follows is here since the search for subshapes lives on it.

inline std::optional<Along> along_line(const Element& carrier, const Element& part, double reach) {
    const Vec way = carrier.at[1] - carrier.at[0];
    const double size = dot(way, way);
    const double first = dot(part.at[0] - carrier.at[0], way) / size;
    const Vec first_off = carrier.at[0] + way * first - part.at[0];
    if (!(dot(first_off, first_off) <= reach * reach)) return std::nullopt;
    const double last = dot(part.at[1] - carrier.at[0], way) / size;
    const Vec last_off = carrier.at[0] + way * last - part.at[1];
    const double most = std::max(dot(first_off, first_off), dot(last_off, last_off));
    if (!(most <= reach * reach)) return std::nullopt;
    return Along{{std::min(first, last), std::max(first, last)}, last < first, std::sqrt(most)};
}

// A parabola as a t^2 + b t + its first control point. Across the axis the parameter is linear, so no vertex is needed.
class ParabolaPath {
public:
    explicit ParabolaPath(const Element& e)
        : start_(e.at[0]), a_(e.at[0] - 2 * e.at[1] + e.at[2]), b_(2 * (e.at[1] - e.at[0])), turn_(cross(a_, b_)) {
        // A piece so flat that its axis is noise: along its chord the parameter is as good as linear.
        constexpr double flat = 1e-6;
        if (std::fabs(turn_) <= flat * (dot(a_, a_) + dot(b_, b_))) {
            const Vec chord = a_ + b_;
            across_ = chord * (1 / dot(chord, chord));
            is_flat_ = true;
        }
    }

    Vec at(double t) const { return start_ + (a_ * t + b_) * t; }
    // The control point between those at two parameters.
    Vec middle(double u, double v) const { return start_ + a_ * (u * v) + b_ * (0.5 * (u + v)); }

    double parameter_near(Vec p, double close_enough) const {
        double t = is_flat_ ? dot(p - start_, across_) : cross(a_, p - start_) / turn_;
        // What lies beside the curve was projected along the axis; now straight across the curve.
        for (int round = 0; round < (is_flat_ ? 3 : 1); ++round) {
            const Vec off = p - at(t), way = 2 * t * a_ + b_;
            const double size = dot(way, way);
            if (dot(off, off) <= close_enough * close_enough || !(size > 0)) break;
            t += dot(off, way) / size;
        }
        return t;
    }

private:
    Vec start_, a_, b_;
    double turn_;
    Vec across_{};
    bool is_flat_ = false;
};

inline std::optional<Along> along_parabola(const Element& carrier, const Element& part, double reach) {
    const ParabolaPath path(carrier);
    const double close_enough = reach * 0x1p-10;
    const double first = path.parameter_near(part.at[0], close_enough);
    const Vec first_off = path.at(first) - part.at[0];
    if (!(dot(first_off, first_off) <= reach * reach)) return std::nullopt;
    const double last = path.parameter_near(part.at[2], close_enough);
    const Vec last_off = path.at(last) - part.at[2];
    if (!(dot(last_off, last_off) <= reach * reach)) return std::nullopt;
    const Vec middle_off = path.middle(first, last) - part.at[1];
    if (!(dot(middle_off, middle_off) <= reach * reach)) return fitted_along(carrier, part, first, last, reach);
    const double most =
        std::max(std::max(dot(first_off, first_off), dot(last_off, last_off)), dot(middle_off, middle_off));
    return Along{{std::min(first, last), std::max(first, last)}, last < first, std::sqrt(most)};
}

}  // namespace filigree::curves
