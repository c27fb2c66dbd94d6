// What the shape expressions of a shape grammar are made of: calls that are shapes, transforms and regions, described
// like operators, and what they and the operations + - & * over them come to.
//
// A value that is a shape is a SymbolicCall, or the word `empty`. An operation is a call whose name is its sign, with
// two operands or more, folded from the left: `a - b - c` is "-"(a, b, c); of "*" all operands but the last are
// transforms.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "language/description.h"
#include "language/evaluate.h"

namespace filigree {

const std::vector<OperatorDescription>& drawn_shapes();      // path(...), circle(...), point(...), file(...)
const std::vector<OperatorDescription>& shape_transforms();  // translate(...), rotate(...), scale(...), mirror(...)
const std::vector<OperatorDescription>& shape_regions();     // box(...), disc(...), inside(...), as `unless` takes them
// How a rule follows from another one: inverse(RULE), mirror(RULE, angle). No shapes, and no part of expressions.
const std::vector<OperatorDescription>& rule_derivations();

// The shape, transform or region with this name; null where there is none.
const OperatorDescription* find_shape_form(std::string_view name);

enum class ShapeKind { shape, transform, region };
// None where the value is nothing of them.
std::optional<ShapeKind> shape_kind(const Value& value);
// kind_of (value.h), but "a shape", "a transform" or "a region" where it is one.
std::string_view kind_among_shapes(const Value& value);

// The evaluation of an expression in which all of them may stand.
Evaluation with_shapes(Evaluation at);

}  // namespace filigree
