// Elements made anew from parts of others: cut off, or continued by another that goes on along the same descriptor.
#pragma once

#include <optional>

#include "curves/overlap.h"

namespace filigree::curves {

// The share of the tolerance below which a place, or a descriptor, is as good as exact.
inline constexpr double as_good_as_exact = 0x1p-10;

// The piece of an element's descriptor along a stretch, with the stretch's ends as they are where they lie on the
// curve.
std::optional<Element> piece_between(const Element& e, const Stretch& stretch, double tolerance);

// An element and another that goes on along its descriptor, as one. `together`: of the element's parameter, with the
// ends of the whole; `on`: where the other lies. The descriptor is the element's where the other lies on it exactly,
// else the one that fits both best.
std::optional<Element> extended(const Element& e, const Stretch& together, const Element& other, const Stretch& on,
                                double tolerance);

}  // namespace filigree::curves
