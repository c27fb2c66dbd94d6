// Values as a described parameter takes them: what may be written for it, its type and its allowed range.
#pragma once

#include <optional>
#include <string>

#include "base/result.h"
#include "language/description.h"
#include "language/evaluate.h"

namespace filigree {

// What an expression for this parameter may hold beside names: its words, calls, colour words and, for a flag,
// its own name. The scope is taken over as it is.
Evaluation expected_by(const ParameterDescription& parameter, const Document& document, const Scope* scope);

// The value in the parameter's type: lengths in px, angles in degrees, flags as bool, words as Symbol; of any type it
// is left as it is, with its span, which says the unit of a bare length. Ranges are not looked at. Errors carry `span`.
Result<Value> converted(const ParameterDescription& parameter, const Value& value, const Document& document,
                        SourceSpan span);

// language.out-of-range where a converted value lies outside what the parameter allows.
std::optional<Diagnostic> out_of_range(const ParameterDescription& parameter, const Value& value, SourceSpan span);

// Some value of the parameter's type, as `converted` would give it.
Value example_of(const ParameterDescription& parameter);

// "from 1 to 20", "at least 0.1px"; empty where everything is allowed.
std::string allowed_range(const ParameterDescription& parameter);

}  // namespace filigree
