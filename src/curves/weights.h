// Whether an element of a design is as heavy as a left side asks for.
#pragma once

#include "curves/match.h"

namespace filigree::curves {

// Weights are what documents say, so they are compared but for rounding.
inline bool is_heavy_enough(double carrier, double part, WeightRule rule) {
    const double slack = 1e-9 * part;
    if (carrier < part - slack) return false;
    return rule == WeightRule::at_least || carrier <= part + slack;
}

}  // namespace filigree::curves
