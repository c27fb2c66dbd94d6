// Telling people of decisions that fell within ten tolerances of the limit (curves/ambiguity.h).
#pragma once

#include <optional>

#include "base/diagnostic.h"
#include "curves/ambiguity.h"
#include "language/document.h"

namespace filigree::shape {

// One warning for all of them, which names the nearest; nothing where there are none.
std::optional<Diagnostic> warning_of(const curves::Ambiguities& doubts, const Document& document, SourceSpan span);

}  // namespace filigree::shape
