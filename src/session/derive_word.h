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
    rewriting::Derivation derivation;  // with the choices of the word, where they were to be recorded
    Choices choices;                   // of the document's definitions
    std::uint64_t seed = 0;            // what is drawn from
};

struct WordOptions {
    std::optional<std::uint64_t> steps;  // iterations; none: as many as the document says
    DocumentSite site;
    std::uint64_t most_elements = UINT64_MAX;
    bool with_ages = false;        // even where nothing in the document asks for them
    bool records_choices = false;  // those of the word
};

// What rewriting is told of the document; points to it, to `checked` and to what the site points to.
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
