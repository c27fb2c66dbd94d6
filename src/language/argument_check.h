// What can be known of an expression for a described parameter before any step evaluates it, by evaluating it with
// example values of the right kinds.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "language/check.h"
#include "language/description.h"
#include "language/evaluate.h"

namespace filigree {

struct ArgumentCheck {
    const ParameterDescription& parameter;
    const Document& document;
    const Scope* fixed = nullptr;                    // names whose values are known already,
    std::span<const std::string_view> varying = {};  // but for these
    Evaluation at = {};                              // words, calls, wholeness; example scopes

    // Whether the value is the same for every step.
    bool is_fixed(const Expression& expression) const { return is_constant(expression, at, fixed, varying); }
    // Whether every alternative is of the parameter's type. Ranges are looked at later, so that a value out of range
    // is reported and not passed on to the next parameter.
    bool fits(const Expression& argument) const;
    // What is wrong whatever the step: unknown names and words, wrong kinds, constants out of range.
    Diagnostics problems(const Expression& argument) const;

private:
    bool all_fit(const Alternative& alternative, const Value& value, bool fixed_value) const;
    Diagnostics problems_of_value(const Alternative& alternative, const Value& value) const;
};

// What is wrong, whatever the step, with a preset's value for an operator's parameter, and with its condition. They may
// use the globals, what the step knows, and the operator's `parameters` before this one. `varying`: as in bind.
Diagnostics check_preset_value(const ParameterDescription& parameter, const Expression& value, const Document& document,
                               const Scope& globals, std::span<const ParameterDescription> parameters = {},
                               const Scope* varying = nullptr);
Diagnostics check_preset_condition(const ParameterDescription& parameter, const Expression& condition,
                                   const Document& document, const Scope& globals,
                                   std::span<const ParameterDescription> parameters = {},
                                   const Scope* varying = nullptr);

}  // namespace filigree
