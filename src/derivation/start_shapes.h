// The shapes that may stand behind `start TAG =`, described like operators, and the outlines of the built-in ones.
#pragma once

#include <vector>

#include "language/bind.h"
#include "language/description.h"
#include "plane/path.h"

namespace filigree {

// All of them: for checking, for `describe` and for the reference.
const std::vector<OperatorDescription>& start_shape_descriptions();

// A rectangle, circle, ellipse, polygon or star around the origin, in px, with curves followed to `tolerance`.
std::vector<Polyline> built_in_outline(const Arguments& arguments, double tolerance);

}  // namespace filigree
