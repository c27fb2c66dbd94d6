// Deriving an embedded document inside a shape of another (derivation/embedding.h): what the session hands engines.
#pragma once

#include <functional>

#include "base/job.h"
#include "derivation/embedding.h"
#include "engines/tangle/draw.h"
#include "engines/tangle/tangle.h"
#include "session/check.h"
#include "session/run.h"

namespace filigree {

// A document inside a shape, with all that its parts may be asked about. Its drawing is Embedded::drawing.
struct EmbeddedPart : EmbeddedRun {
    std::shared_ptr<const OpenedDocument> opened;
    std::shared_ptr<const CheckedDocument> checked;
    Key root;           // folded into its keys
    Transform to_host;  // from its coordinates to those of the host
};
struct EmbeddedTangle : EmbeddedPart {
    PlaneStart start;
    tangle::Tangle tangle;
    tangle::Picture picture;  // its choices
};
struct EmbeddedWord : EmbeddedPart {
    WordRun word;
};
struct EmbeddedDesign : EmbeddedPart {
    DesignRun design;
};

// Null where another kind of document was embedded.
const EmbeddedTangle* tangle_in(const Embedded& embedded);
const EmbeddedWord* word_in(const Embedded& embedded);
const EmbeddedDesign* design_in(const Embedded& embedded);

// Calls `visit` for every tangle that grows in a shape of this one, and in those, in the order of the steps.
void for_each_embedded(const tangle::Tangle& tangle, const std::function<void(const EmbeddedTangle& inner)>& visit);

// For the documents that `opened` may embed, which must outlive the result; errors have their places in the sources of
// the outermost document. Documents whose parameters hold no choice and are not given are read once.
// `lists_choices` as in RunOptions.
EmbedFunction embed_function(const OpenedDocument& opened, bool lists_choices, const Job& job);

}  // namespace filigree
