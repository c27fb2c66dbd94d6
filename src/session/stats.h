// What --stats writes and what `check` prints.
#pragma once

#include <string>

#include "session/run.h"

namespace filigree {

std::string stats_json(const OpenedDocument& opened, const CheckedDocument& checked, const Run& run);

// The grammar's graph: nodes, edges, longest path, and each rule with the rules that may follow it.
std::string check_text(const CheckedDocument& checked, const Document& document);
std::string check_json(const OpenedDocument& opened, const CheckedDocument& checked);

// Peak resident memory of this process so far.
std::uint64_t peak_memory_bytes();

}  // namespace filigree
