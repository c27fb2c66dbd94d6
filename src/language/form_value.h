// Values of a `form` parameter: a word, a number, or a call such as star(5, 20, 8) or file("leaf.svg", id: "vein")
// that is described like an operator.
#pragma once

#include <string_view>
#include <vector>

#include "base/result.h"
#include "language/description.h"
#include "language/evaluate.h"

namespace filigree {

// Names and aliases of the calls that may stand for the parameter.
std::vector<std::string_view> form_names(const ParameterDescription& parameter);

// Whether a number may stand there too: where the parameter bounds it.
bool takes_numbers(const ParameterDescription& parameter);

// A word as it is, a number as a bare one, a call as SymbolicCall under its proper name with a value for every
// parameter of its description, in that order, converted (parameter_value.h). Reports surplus, unknown, missing,
// mistyped and out-of-range arguments at `span`.
Result<Value> to_form(const ParameterDescription& parameter, const Value& value, const Document& document,
                      SourceSpan span);

// An argument of a converted call, by the parameter's name, which must exist.
const Value& argument_of(const SymbolicCall& call, std::string_view name);
double number_of(const SymbolicCall& call, std::string_view name);
const std::string& text_of(const SymbolicCall& call, std::string_view name);
std::string_view word_of(const SymbolicCall& call, std::string_view name);

}  // namespace filigree
