// The steps of a derivation as text and as JSON: what `derive` prints. Those of documents that grow inside shapes
// stand behind the step that embeds them, with their paths from the outermost start on.
#pragma once

#include <cstdint>
#include <string>

#include "session/check.h"

namespace filigree {

// The line that a place of a document stands on, from 1; 0 for none.
std::uint32_t line_of(const Document& document, SourceSpan span);

// One line a step: its number, path, rule's line, and what came out.
std::string steps_text(const OpenedDocument& opened, const CheckedDocument& checked, const tangle::Tangle& tangle);
std::string steps_json(const OpenedDocument& opened, const CheckedDocument& checked, const tangle::Tangle& tangle);

}  // namespace filigree
