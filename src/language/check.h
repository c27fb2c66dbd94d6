// Checking expressions before they are needed, so that a wrong document is never half run.
//
// Unknown names, unknown functions and wrong argument lists are found in every branch, taken or not. Wrong
// kinds (an angle beside a length) are found by evaluating with example values of the right dimensions.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "language/evaluate.h"

namespace filigree {

// A scope in which the names of names.h have example values.
Scope example_scope(std::span<const std::string_view> names, const Scope* outer);
// The names of `varying`, up to the globals, as a scope of their own: they stand between the globals and what a step
// knows. Empty where `varying` is null.
Scope scope_between(const Scope& globals, const Scope* varying);
// The names that differ from step to step: what a step knows, and those in between. Points into the scope.
std::vector<std::string_view> varying_names(const Scope& between);

// What is wrong with the expression whatever the values: `at` gives its words, calls and (example) scopes.
Diagnostics check_expression(const Expression& expression, const Evaluation& at);

// Whether an error depends on the values and not only on their kinds.
bool depends_on_values(const Diagnostic& diagnostic);

// Whether every name of the expression is a word of `at` or known in `fixed` and not one of `varying`.
bool uses_only(const Expression& expression, const Evaluation& at, const Scope* fixed,
               std::span<const std::string_view> varying);
// Likewise, and it holds no choice and no each(...): its value is the same everywhere.
bool is_constant(const Expression& expression, const Evaluation& at, const Scope* fixed,
                 std::span<const std::string_view> varying);

// A rule's `when` or `weight`: everything that can be known before it is evaluated for a step. Constant ones
// are evaluated; a weight below zero is an error. `varying`: example values of names that differ from step to step
// besides what a step knows (the parameters of a macro), if there are any.
Diagnostics check_condition(const Expression& expression, const Document& document, const Scope& globals,
                            const Scope* varying = nullptr);
Diagnostics check_weight(const Expression& expression, const Document& document, const Scope& globals,
                         const Scope* varying = nullptr);
// A condition that is evaluated otherwise: `at` has example scopes; `globals` are fixed but for the names in `varying`.
Diagnostics check_condition(const Expression& expression, const Evaluation& at, const Scope& globals,
                            std::span<const std::string_view> varying);

// The expressions that may give the value: branches of conditions, candidates of one_of, the inside of
// each(...), and the ends of ranges.
struct Alternative {
    enum class Kind {
        value,      // gives a value
        items,      // the only candidate of a one_of: if it is a list, its items are the values
        range_end,  // an end of a range
        range,      // the range itself: its ends follow as alternatives of their own
    };
    const Expression* expression = nullptr;
    Kind kind = Kind::value;
    bool by_shape = false;  // stands inside each(...)
};
std::vector<Alternative> alternatives_of(const Expression& expression, bool by_shape = false);

}  // namespace filigree
