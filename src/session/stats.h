// What --stats writes and what `derive` and `check` list: runs as JSON and as text.
#pragma once

#include <string>

#include "session/run.h"

namespace filigree {

std::string stats_json(const OpenedDocument& opened, const CheckedDocument& checked, const Run& run);

// One line a step: its number, path, rule and what came out.
std::string steps_text(const CheckedDocument& checked, const Document& document, const tangle::Tangle& tangle);
std::string steps_json(const CheckedDocument& checked, const Document& document, const tangle::Tangle& tangle);

// The grammar's graph: nodes, edges, longest path, and each rule with the rules that may follow it.
std::string check_text(const CheckedDocument& checked, const Document& document);
std::string check_json(const OpenedDocument& opened, const CheckedDocument& checked);

// Peak resident memory of this process so far.
std::uint64_t peak_memory_bytes();

}  // namespace filigree
