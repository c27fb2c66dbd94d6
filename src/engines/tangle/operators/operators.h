// The closed table of tangle operators. Each stands in a file of its own; a new one gets a line here and in
// operators.cpp.
#pragma once

#include <span>
#include <string_view>

#include "engines/tangle/operator.h"

namespace filigree::tangle {

Operator embed_operator();
Operator fill_operator();
Operator invert_operator();
Operator outline_operator();
Operator place_operator();
Operator radial_operator();
Operator regroup_operator();
Operator regular_split_operator();
Operator stipple_operator();
Operator streamline_split_operator();
Operator transform_operator();
Operator ungroup_operator();
Operator voronoi_operator();

// All operators by name.
std::span<const Operator> operators();
// By name or alias; null if there is none.
const Operator* find_operator(std::string_view name);

}  // namespace filigree::tangle
