// The designs of shape documents: derived and drawn.
#pragma once

#include <cstdint>
#include <optional>

#include "base/job.h"
#include "engines/shape/draw.h"
#include "scene/drawing.h"
#include "session/check.h"

namespace filigree {

// What a shape document came to.
struct DesignRun {
    shape::Derivation derivation;
    double scale = 1;                                  // of its drawing
    std::vector<std::vector<std::uint32_t>> elements;  // of each shape of the drawing: those of the design
};

struct DesignOptions {
    std::optional<std::uint64_t> steps;  // none: as many as the document says
    DocumentSite site = {};
    bool by_hand_alone = false;  // without the machine's steps
};

// What the engine is told of the document; points to it and to `checked`.
shape::Surroundings surroundings_of(const OpenedDocument& opened, const CheckedDocument& checked);

// `checked` must hold no errors.
Result<shape::Derivation> derive_design(const OpenedDocument& opened, const CheckedDocument& checked,
                                        const DesignOptions& options, const Job& job);

// The same with its drawing.
struct DrawnDesign {
    DesignRun run;
    Drawing drawing;
    double derived = 0;  // when that was done: now_seconds
};
Result<DrawnDesign> draw_design(const OpenedDocument& opened, const CheckedDocument& checked,
                                const DesignOptions& options, const Job& job);

}  // namespace filigree
