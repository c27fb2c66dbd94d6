// Derivation of a tangle: breadth first, the group of the lowest number next (gTangle, section 3).
//
// Steps of one wave are independent, since every choice is addressed by keys; they run in parallel and are
// committed in the order of their groups, so the result depends on neither threads nor timing.
//
// Law: derive(d, i, previous) == derive(d, i, nothing), byte for byte, whatever `previous` is. What of it still
// holds is taken over (reuse.h): whole steps whose rules, presets and shapes are the same, and the results of operators
// whose arguments have come out the same.
#pragma once

#include <cstdint>
#include <optional>

#include "base/executor.h"
#include "base/job.h"
#include "base/result.h"
#include "derivation/embedding.h"
#include "derivation/plane_start.h"
#include "engines/tangle/grammar.h"
#include "engines/tangle/tangle.h"

namespace filigree::tangle {

struct DeriveOptions {
    std::optional<std::uint64_t> steps;           // stop after so many: a prefix of the whole derivation
    const Tangle* previous = nullptr;             // of an earlier state of the document
    DocumentSite site;                            // inside a shape of another document, or on its own
    EmbedFunction embed;                          // must be given if a rule embeds
    const ShapeSource* shapes = nullptr;          // what forms mean; must be given
    std::optional<std::uint64_t> element_budget;  // where it is less than the document's own limit
};

// Fault::limit where a limit is reached or the job is cancelled; `previous` is whole in any case.
Result<Tangle> derive(const Grammar& grammar, const PlaneStart& start, const Settings& settings,
                      const Document& document, const DeriveOptions& options, Executor& executor, const Job& job);

}  // namespace filigree::tangle
