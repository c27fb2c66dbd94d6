// The steps of a shape derivation as text and as JSON: what `derive` prints of it; and all designs to a depth.
#pragma once

#include <string>

#include "base/job.h"
#include "engines/shape/enumerate.h"
#include "session/check.h"

namespace filigree {

// One line a step: its number, path, where the rule was applied, what came out.
std::string design_text(const OpenedDocument& opened, const CheckedDocument& checked,
                        const shape::Derivation& derivation);
std::string design_json(const OpenedDocument& opened, const CheckedDocument& checked,
                        const shape::Derivation& derivation);

// All designs that the rules make of the one that the document leads to.
Result<shape::FoundDesigns> find_designs(const OpenedDocument& opened, const CheckedDocument& checked,
                                         const shape::EnumerateOptions& options, const Job& job);
std::string designs_text(const CheckedDocument& checked, const shape::FoundDesigns& found);
std::string designs_json(const OpenedDocument& opened, const CheckedDocument& checked,
                         const shape::FoundDesigns& found);

// "M 0 0 Q ...": the design's curves as path data, joined.
std::string path_data_of(const curves::Shape& design, double tolerance);

}  // namespace filigree
