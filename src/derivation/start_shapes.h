// The shapes that may stand behind `start TAG =` and wherever an operator takes a form, described like operators, and
// the outlines of the built-in ones.
#pragma once

#include <vector>

#include "language/bind.h"
#include "language/description.h"
#include "plane/path.h"

namespace filigree {

// What may stand behind `start TAG =`: for checking, for `describe` and for the reference.
const std::vector<OperatorDescription>& start_shape_descriptions();
// The forms of a shape that is placed or drawn as a mark: the same without `host` and without `overlap`.
const std::vector<OperatorDescription>& shape_forms();
// The forms of a curve: path and file.
const std::vector<OperatorDescription>& curve_forms();

// Evaluated arguments as a call with a value for every parameter.
SymbolicCall call_of(const Arguments& arguments);

// A rectangle, circle, ellipse, polygon or star around `at`, in px, with curves followed to `tolerance`.
std::vector<Polyline> built_in_outline(const SymbolicCall& shape, double tolerance);

}  // namespace filigree
