// Derivation of a tangle: breadth first, the group of the lowest number next (gTangle, section 3).
//
// Steps of one wave are independent, since every choice is addressed by keys; they run in parallel and are
// committed in the order of their groups, so the result depends on neither threads nor timing.
#pragma once

#include <cstdint>
#include <optional>

#include "base/executor.h"
#include "base/job.h"
#include "base/result.h"
#include "derivation/inputs.h"
#include "derivation/plane_start.h"
#include "engines/tangle/grammar.h"
#include "engines/tangle/tangle.h"

namespace filigree::tangle {

struct DeriveOptions {
    std::optional<std::uint64_t> steps;  // stop after so many: a prefix of the whole derivation
};

// Fault::limit where a limit is reached or the job is cancelled.
Result<Tangle> derive(const Grammar& grammar, const PlaneStart& start, const Settings& settings,
                      const Document& document, const DeriveOptions& options, Executor& executor, const Job& job);

// "big_poly/outline/in/regular_split/quads[3]": where a group stands, and a step's path without the last tag.
std::string segment_of_group(const Tangle& tangle, const Grammar& grammar, std::uint32_t group);  // "quads[3]"
std::string path_of_group(const Tangle& tangle, const Grammar& grammar, std::uint32_t group);
std::string path_of_step(const Tangle& tangle, const Grammar& grammar, std::uint32_t step);

}  // namespace filigree::tangle
