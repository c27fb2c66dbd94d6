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
#include "session/derive_design.h"
#include "session/derive_word.h"

namespace filigree {

struct RunOptions {
    std::optional<std::uint64_t> steps;  // a prefix of the derivation
    tangle::ColourBy colour_by = tangle::ColourBy::style;
    bool verify = false;
    bool draws = true;                         // else words and designs are only derived
    const tangle::Tangle* previous = nullptr;  // of an earlier state of the document: what still holds is taken over
    bool lists_choices = false;                // words: those that are made are recorded, to be listed
    const Replay* replay = nullptr;            // choices to be taken instead of drawing; null: the document's own
};

struct RunTimes {  // seconds
    double parse = 0, derive = 0, draw = 0, write = 0, total = 0;
};

// A preset that met nothing in this derivation, though it is possible.
struct UnmatchedPreset {
    std::string statement;  // "set", "keep", ...
    std::string path;
    SourceSpan span;
};

struct Run {
    tangle::Tangle tangle;            // without groups where there is a word or a design
    tangle::Picture picture;          // without its drawing
    std::optional<WordRun> word;      // of a rewriting document
    std::optional<DesignRun> design;  // of a shape document
    Drawing drawing;
    Diagnostics diagnostics;  // warnings
    std::vector<UnmatchedPreset> unmatched;
    std::vector<std::string> broken;  // invariants that do not hold; empty if not verified
    bool verified = false;
    RunTimes times;
};

// The derivation alone. `checked` must hold no errors.
Result<tangle::Tangle> derive_document(const OpenedDocument& opened, const CheckedDocument& checked,
                                       const RunOptions& options, Executor& executor, const Job& job);

// With a drawing of what was derived.
Result<Run> run_document(const OpenedDocument& opened, const CheckedDocument& checked, const RunOptions& options,
                         Executor& executor, const Job& job);

}  // namespace filigree
