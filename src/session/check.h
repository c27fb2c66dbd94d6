// Checking a document: everything that can be known to be wrong before anything is derived, and the
// grammar's graph (gTangle, section 5), which is there even beside errors.
#pragma once

#include <optional>

#include "derivation/plane_start.h"
#include "engines/tangle/grammar.h"
#include "engines/tangle/graph.h"
#include "language/settings.h"
#include "session/open.h"

namespace filigree {

struct CheckedDocument {
    std::optional<Settings> settings;        // none where they could not be read
    std::optional<tangle::Grammar> grammar;  // likewise
    std::optional<PlaneStart> start;         // likewise
    std::vector<const GroupRule*> rules;     // as they stand in the document
    tangle::RuleGraph graph;
    Diagnostics diagnostics;  // of opening and checking, errors and warnings
};

// `opened` must outlive the result.
CheckedDocument check_document(const OpenedDocument& opened);

}  // namespace filigree
