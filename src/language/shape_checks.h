// What is wrong with the expressions of a shape grammar before anything is derived.
#pragma once

#include "language/document.h"
#include "language/evaluate.h"
#include "language/shape_rules.h"

namespace filigree {

// Sides, starts and `unless` must be shapes (`unless` also takes regions); places, angles, factors, weights, conditions
// and the like must be of their kind. `varying` as in shape_rules.h. The words of `match`, `choose` and `show` are not
// looked at.
Diagnostics check_shape_expressions(const Document& document, const ShapeRules& rules, const Scope& globals,
                                    const Scope* varying);

}  // namespace filigree
