// Running a document: derive, draw, measure, verify.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/executor.h"
#include "base/job.h"
#include "derivation/plane_start.h"
#include "engines/rewriting/draw.h"
#include "engines/tangle/draw.h"
#include "engines/tangle/tangle.h"
#include "scene/drawing.h"
#include "session/check.h"

namespace filigree {

struct RunOptions {
    std::optional<std::uint64_t> steps;  // a prefix of the derivation
    tangle::ColourBy colour_by = tangle::ColourBy::style;
    bool verify = false;
    const tangle::Tangle* previous = nullptr;  // of an earlier state of the document: what still holds is taken over
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

// What a rewriting document came to.
struct WordRun {
    rewriting::Derivation derivation;
    Choices choices;  // of the document's definitions
};

struct Run {
    tangle::Tangle tangle;        // without groups where there is a word
    tangle::Picture picture;      // without its drawing
    std::optional<WordRun> word;  // of a rewriting document
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

struct WordOptions {
    std::optional<std::uint64_t> steps;  // iterations; none: as many as the document says
    Key root;                            // folded into all keys
    std::uint64_t most_elements = UINT64_MAX;
};

// What rewriting is told of the document.
rewriting::DeriveOptions word_options(const OpenedDocument& opened, const CheckedDocument& checked,
                                      const WordOptions& options = {});

// The word of a rewriting document.
Result<rewriting::Derivation> derive_word(const OpenedDocument& opened, const CheckedDocument& checked,
                                          const WordOptions& options, Executor& executor, const Job& job);

// The same with its drawing.
struct DrawnWord {
    WordRun run;
    Drawing drawing;
    double derived = 0;  // when that was done: now_seconds
};
Result<DrawnWord> draw_word(const OpenedDocument& opened, const CheckedDocument& checked, const WordOptions& options,
                            Executor& executor, const Job& job);

// With a drawing of what was derived.
Result<Run> run_document(const OpenedDocument& opened, const CheckedDocument& checked, const RunOptions& options,
                         Executor& executor, const Job& job);

// Seconds of a steady clock, for measuring alone.
double now_seconds();

}  // namespace filigree
