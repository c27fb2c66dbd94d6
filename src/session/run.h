// Running a document: derive, draw, measure, verify.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/executor.h"
#include "base/job.h"
#include "derivation/plane_start.h"
#include "engines/tangle/draw.h"
#include "engines/tangle/tangle.h"
#include "scene/drawing.h"
#include "session/check.h"

namespace filigree {

struct RunOptions {
    std::optional<std::uint64_t> steps;  // a prefix of the derivation
    tangle::ColourBy colour_by = tangle::ColourBy::style;
    bool verify = false;
};

struct RunTimes {  // seconds
    double parse = 0, derive = 0, draw = 0, write = 0, total = 0;
};

struct Run {
    tangle::Tangle tangle;
    Drawing drawing;
    Diagnostics diagnostics;          // warnings
    std::vector<std::string> broken;  // invariants that do not hold; empty if not verified
    bool verified = false;
    RunTimes times;
};

// `checked` must hold no errors.
Result<Run> run_document(const OpenedDocument& opened, const CheckedDocument& checked, const RunOptions& options,
                         Executor& executor, const Job& job);

// Seconds of a steady clock, for measuring alone.
double now_seconds();

}  // namespace filigree
