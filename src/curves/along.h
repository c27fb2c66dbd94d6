// Whether two elements have the same descriptor, and where one lies along the other's: what maximal shapes, sums,
// differences and the search for subshapes all stand on.
//
// Descriptors are compared where the elements are, never by their vertices, axes or centres: those of a shallow arc are
// known badly although the arc itself is known well. Paper: sections 2.2 and 3.1, figure 3.
#pragma once

#include <optional>

#include "curves/element.h"

namespace filigree::curves {

struct Along {
    Interval on;               // of the carrier's parameter; of an arc with its middle nearest to the carrier's
    bool is_reversed = false;  // it runs against the carrier's parameter
    double distance = 0;       // px: how far it lies off the carrier's descriptor (control points; of arcs the points)
};

// Where `part` lies along the descriptor of `carrier`, beyond its ends, too. Nothing unless both are of one kind and
// layer (weights do not matter) and the distance is at most `reach`, px. Both in normal form. Well conditioned where
// `part` is not much longer than `carrier`.
std::optional<Along> along(const Element& carrier, const Element& part, double reach);

// How far a part that lies along a carrier sticks out beyond its ends, px along the curve; negative inside.
double overhang(const Element& carrier, const Along& part);

// Whether all of `part` lies on `carrier`, as a length that must not exceed the tolerance: the larger of distance and
// overhang. Nothing where it exceeds `reach`.
std::optional<double> misfit(const Element& carrier, const Element& part, double reach);

}  // namespace filigree::curves
