// The step of `embed`: another document is derived inside every shape of the group.
#pragma once

#include <memory>
#include <vector>

#include "base/executor.h"
#include "base/result.h"
#include "derivation/embedding.h"
#include "engines/tangle/grammar.h"
#include "engines/tangle/tangle.h"
#include "language/preset_walk.h"

namespace filigree::tangle {

struct EmbedStep {
    const Tangle& tangle;
    const Group& group;
    const Rule& rule;
    const Arguments& arguments;
    Key key;                 // of the step
    const PresetNode& node;  // of the step
    const PresetWalk& walk;
    std::uint32_t depth = 0;  // documents around the tangle
    std::uint64_t element_budget = 0;
};

// One a shape, in order; null where the shape is too small for the document. Choices inside a shape are drawn at keys
// of its own. Presets reach it by the path of the step and by that of the shape: medallion/embed/...,
// medallion/2/embed/...
Result<std::vector<std::shared_ptr<const Embedded>>> embed_step(const EmbedStep& step, const EmbedFunction& embed,
                                                                Executor& executor);

}  // namespace filigree::tangle
