// Binding: a call's arguments to a described operator's parameters.
//
// Positional arguments fill the parameters that have no named one, in order; one skips an optional parameter
// whose type cannot take it (`place(20, 25)` skips the shape's word; a flag takes true, false, yes, no, 0, 1 and its
// own name). Named arguments go by name or alias. Binding is checked once, when the document is; evaluating is done
// once for every step, and constant arguments are evaluated only when they are bound.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "language/description.h"
#include "language/evaluate.h"
#include "language/step_choices.h"

namespace filigree {

// Which expression each parameter of the description takes.
struct BoundCall {
    const OperatorDescription* description = nullptr;
    SourceSpan span = {};                              // of the call
    std::vector<ExpressionPtr> expressions = {};       // one a parameter; the parsed default where none was given
    std::vector<bool> given = {};                      // whether the document gave it
    std::vector<std::optional<Value>> constants = {};  // the converted value where it is the same for every step
    std::vector<Evaluation> expected = {};             // words, calls and wholeness of each parameter
};

// Reports every surplus, unknown, doubled, missing and mistyped argument. Constant arguments are checked
// against type and range now, as are the ends of ranges and the alternatives of choices that are constant;
// others when they are evaluated. `varying`: example values of names between the globals and what a step knows (the
// parameters of a macro around the call), whose values are known only at each step. `globals` must outlive the result.
Result<BoundCall> bind(const OperatorDescription& description, const std::vector<CallArgument>& arguments,
                       SourceSpan call, const Document& document, const Scope& globals, const Scope* varying = nullptr);

// The value of each parameter for one step.
struct ArgumentValue {
    Value common = {};                  // where it is the same for all shapes
    std::vector<Value> per_shape = {};  // else one a shape (the document or a preset wrote each(...))

    const Value& at(std::size_t shape) const { return per_shape.empty() ? common : per_shape[shape]; }
};
struct Arguments {
    const OperatorDescription* description = nullptr;
    std::vector<ArgumentValue> values = {};  // one a parameter, converted: lengths px, angles degrees, flags bool

    // By the parameter's name, which must exist and have the fitting type.
    double number(std::string_view name, std::size_t shape = 0) const;  // whole, real, length, angle
    bool flag(std::string_view name, std::size_t shape = 0) const;
    std::string_view word(std::string_view name, std::size_t shape = 0) const;
    std::vector<double> lengths(std::string_view name, std::size_t shape = 0) const;
    const Value& value(std::string_view name, std::size_t shape = 0) const;
};

// What is known of one shape inside each(...).
struct ShapeContext {
    Key key = {};
    Scope scope = {};  // index, x, y, i, j
};

// Evaluates all arguments of a step in order; earlier parameters are visible to later defaults and to presets. `shapes`
// is read only where an argument varies by shape. Choices are made at (step key, parameter's name), inside each(...)
// at the shape's key. A preset of the step goes before the document's expression, and one of a single shape
// (StepChoices::shapes) goes before both. A preset's value is converted and must lie in the
// parameter's range like any other; what is wrong with it is reported where it stands.
Result<Arguments> evaluate_arguments(const BoundCall& call, const Document& document, const Scope& step_scope,
                                     const StepChoices& choices, Key step, std::span<const ShapeContext> shapes);

// Whether a preset holds each(...), so that evaluate_arguments needs the shapes although the call itself does not.
bool presets_vary_by_shape(const BoundCall& call, const StepChoices& choices);

}  // namespace filigree
