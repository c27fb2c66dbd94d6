// From the call of an edit, such as insert("T+", at: "a"), to the edit, with everything that is wrong with it.
#pragma once

#include <vector>

#include "base/result.h"
#include "engines/rewriting/grammar.h"
#include "language/document.h"

namespace filigree::rewriting {

struct EditCall {
    const Name& name;
    const std::vector<CallArgument>& arguments;  // pairs have a text in the place of the name
    SourceSpan span;
};

// The grammar's systems and registers must be read; its edits are those before this one. `globals` must outlive the
// result. When the edit acts is left open.
Result<WordEdit> read_edit(const EditCall& call, const Grammar& grammar, const Document& document,
                           const Scope& globals);

}  // namespace filigree::rewriting
