// The steps of a derivation as text and as JSON: what `derive` prints. Those of documents that grow inside shapes
// stand behind the step that embeds them, with their paths from the outermost start on.
#pragma once

#include <string>

#include "session/check.h"

namespace filigree {

// One line a step: its number, path, rule's line, and what came out.
std::string steps_text(const OpenedDocument& opened, const CheckedDocument& checked, const tangle::Tangle& tangle);
std::string steps_json(const OpenedDocument& opened, const CheckedDocument& checked, const tangle::Tangle& tangle);

}  // namespace filigree
