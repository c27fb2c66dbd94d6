// The choice of a group's rule: a race among those that match it and whose condition holds.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "engines/tangle/grammar.h"
#include "engines/tangle/tangle.h"
#include "language/preset_walk.h"

namespace filigree::tangle {

struct RuleDraw {
    const Grammar& grammar;
    const Document& document;
    const PresetWalk& walk;
    Key group;               // of the group
    const PresetNode& node;  // of the group
    std::span<const std::uint32_t> matching;
    const Scope& scope;  // of the step
};

// The index of the rule that expands the group; none where it stays a leaf. Recorded as the choice `rule` at the
// group's key where there was one. A preset names a rule by its segment, `none` for none; one_of(...) of several races
// them with their own conditions and weights, or with the given weights.
Result<std::optional<std::uint32_t>> draw_rule(const RuleDraw& draw, ChoiceBuffer& record);

}  // namespace filigree::tangle
