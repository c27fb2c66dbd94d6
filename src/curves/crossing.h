// Where the carriers of two straight lines cross, and where they come nearest to a place.
#pragma once

#include <cmath>
#include <optional>

#include "curves/element.h"

namespace filigree::curves {

// Nothing where they are parallel to a thousandth: the place would be known badly.
inline std::optional<Vec> crossing_of(const Element& a, const Element& b) {
    const Vec u = a.at[1] - a.at[0], v = b.at[1] - b.at[0];
    const double turn = cross(u, v);
    if (!(std::fabs(turn) > 0.001 * length(u) * length(v))) return std::nullopt;
    return a.at[0] + u * (cross(b.at[0] - a.at[0], v) / turn);
}

// Whether two lines touch or cross: their carriers cross within `reach` of both.
inline bool do_meet(const Element& a, const Element& b, double reach) {
    const auto at = crossing_of(a, b);
    if (!at) return false;
    const auto is_on = [&](const Element& e) {
        const Vec way = e.at[1] - e.at[0];
        const double size = length(way), place = dot(*at - e.at[0], way) / size;
        return place >= -reach && place <= size + reach;
    };
    return is_on(a) && is_on(b);
}

inline Vec foot_on(const Element& line, Vec place) {
    const Vec way = line.at[1] - line.at[0];
    return line.at[0] + way * (dot(place - line.at[0], way) / dot(way, way));
}

}  // namespace filigree::curves
