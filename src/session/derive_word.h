// The words of rewriting documents: derived, edited and drawn.
#pragma once

#include <cstdint>
#include <optional>

#include "base/executor.h"
#include "base/job.h"
#include "engines/rewriting/draw.h"
#include "language/choices.h"
#include "scene/drawing.h"
#include "session/check.h"

namespace filigree {

// What a rewriting document came to.
struct WordRun {
    rewriting::Derivation derivation;
    Choices choices;  // of the document's definitions
};

struct WordOptions {
    std::optional<std::uint64_t> steps;  // iterations; none: as many as the document says
    Key root;                            // folded into all keys
    std::uint64_t most_elements = UINT64_MAX;
    bool with_ages = false;  // even where nothing in the document asks for them
};

// What rewriting is told of the document; points to it and to `checked`.
rewriting::DeriveOptions word_options(const OpenedDocument& opened, const CheckedDocument& checked,
                                      const WordOptions& options = {});

// The word of a rewriting document, after its edits. `checked` must hold no errors.
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

// Seconds of a steady clock, for measuring alone.
double now_seconds();

}  // namespace filigree
