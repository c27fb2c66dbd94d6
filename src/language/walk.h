// Walking expression trees without recursion, and the place at which each part stands.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "language/description.h"
#include "language/expression.h"

namespace filigree {

// What may stand at a node because of the nodes above it.
struct Place {
    bool result = true;     // the whole's value may come from here: enumeration words and symbolic calls may stand
    bool symbols = false;   // any bare word may stand (arguments of a start's call)
    bool whole = false;     // ranges are whole
    bool by_shape = false;  // inside each(...)
    bool shapes = false;    // shapes and operations over them may stand here
};

// The parameter that an argument of a form goes to, as far as its name or place says; `positional` counts those without
// a name before it. Null where there is none.
const ParameterDescription* parameter_of(const OperatorDescription& form, const CallArgument& argument,
                                         std::size_t positional);
// The place of an argument of a call that is a shape, a transform or a region, by what its parameter takes.
Place shape_argument_place(Place place, std::string_view call, const CallArgument& argument, std::size_t positional);

// The place of an operand, condition, weight or function argument: a number of its own, not the result.
Place operand_place(Place place);
Place operand_place(Place place, BinaryOperator op);

struct PlacedExpression {
    const Expression* expression = nullptr;
    Place place;
};
// The parts in the order in which choices are numbered. `any_call`: whether any symbolic call is allowed. A
// range behind `in` is no choice, so its two ends stand for it. Names of arguments are no parts.
std::vector<PlacedExpression> parts_of(const Expression& expression, Place place = {}, bool any_call = false);

bool is_choice(const Expression& expression);
// How many choices the tree holds.
std::uint32_t count_choices(const Expression& expression);

// "page.width" for names and members of names; empty for everything else.
std::string dotted_name(const Expression& expression);

// Every name in the tree, dotted names as a whole, and the names of calls.
struct NameInExpression {
    std::string text;
    SourceSpan span;
};
std::vector<NameInExpression> names_in(const Expression& expression);

// The expressions that one_of draws among and their weights (null: 1), in order.
struct WeightedExpression {
    const Expression* candidate = nullptr;
    const Expression* weight = nullptr;
};
std::vector<WeightedExpression> candidates_of(const CallExpression& one_of);

}  // namespace filigree
