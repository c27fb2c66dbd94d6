// From a document's statements to a shape grammar, with everything that is wrong with them.
#pragma once

#include "base/result.h"
#include "derivation/shape_source.h"
#include "engines/shape/grammar.h"
#include "language/settings.h"

namespace filigree::shape {

// `files` holds what file(...) and `rules from` name.
Result<Grammar> read_grammar(const Settings& settings, const Document& document, const ShapeSource& files);

}  // namespace filigree::shape
