// The domain of a parameter: what stands behind `in`.
#pragma once

#include <optional>
#include <vector>

#include "base/result.h"
#include "language/document.h"
#include "language/quantity.h"
#include "language/value.h"

namespace filigree {

// A range in one dimension, or the values of a list or a one_of.
struct ParamDomain {
    std::optional<AdaptedPair> range = {};
    SourceSpan low_span = {}, high_span = {};  // say the unit of bare ends
    std::vector<Value> alternatives = {};      // where there is no range
};

// The range from one value to another. Spans of errors: `span`.
Result<ParamDomain> range_domain(const Value& low, const Value& high, const Document& document, SourceSpan span);

// The items of a list or the candidates of a one_of; empty for anything else.
std::vector<ExpressionPtr> items_of_domain(const Expression& domain);

// Why a value is not in the domain; none where it is.
std::optional<Diagnostic> outside(const ParamDomain& domain, const Value& value, const Document& document,
                                  SourceSpan span);

}  // namespace filigree
