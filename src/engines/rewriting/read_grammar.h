// From a document's statements to a grammar, with everything that is wrong with them.
#pragma once

#include "base/result.h"
#include "derivation/inputs.h"
#include "engines/rewriting/grammar.h"
#include "language/document.h"
#include "language/settings.h"

namespace filigree::rewriting {

// What is `system X { ... }` with one letter is a subsystem. Lengths and numbers may use the names of the document.
// `inputs` holds the files of its arrays and maps.
Result<Grammar> read_grammar(const Settings& settings, const Document& document, const Inputs& inputs = {});

}  // namespace filigree::rewriting
