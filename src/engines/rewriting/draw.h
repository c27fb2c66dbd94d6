// Drawing a word: the turtle's lines, polygons and placed shapes, in the order of the word.
//
// A line goes on as long as the pen stays down and its look stays the same, so that a plotter draws it without lifting.
// Words that leave the wall, and those with a `view`, are seen in space (scene/solid_view.h).
#pragma once

#include <cstdint>
#include <vector>

#include "base/job.h"
#include "base/result.h"
#include "engines/rewriting/derive.h"
#include "engines/rewriting/word_solid.h"
#include "engines/rewriting/word_styles.h"
#include "language/settings.h"
#include "scene/drawing.h"

namespace filigree::rewriting {

struct DrawOptions {
    Key root;                             // folded into all keys
    const ShapeSource* shapes = nullptr;  // what placed forms mean; must not be null
    Job job = {};                         // its progress is not reported
};

// From the turtle's wall, where y goes up, to the page.
struct PagePlace {
    double scale = 1;
    Vec offset;

    Vec operator()(Vec3 p) const { return {scale * p.x + offset.x, offset.y - scale * p.y}; }
};

struct Picture {
    Drawing drawing;
    // Of each shape of the drawing: which symbol of the word it begins with. Empty where all are lines and no one
    // knows.
    std::vector<std::uint64_t> symbols;
    PagePlace place;
    bool is_in_space = false;  // seen from `view`: `place` means nothing then
};

// `word` must have ages where a style or the formula asks for them (asks_for_ages).
Result<Picture> draw(const Derivation& derivation, const DrawRules& rules, const Settings& settings,
                     const Document& document, const DrawOptions& options);

// The same as solids, sheets and lines in space, whether or not it leaves the wall.
Result<WordSolid> draw_solid(const Derivation& derivation, const DrawRules& rules, const Settings& settings,
                             const Document& document, const DrawOptions& options);

// The turtle's settings, with the document's formula in them. What goes wrong in it is told in `problems`, which the
// result points to, as it does to all arguments.
TurtleSettings turtle_settings(const DrawRules& rules, std::uint32_t iteration, const Settings& settings,
                               const Document& document, Diagnostics& problems);

}  // namespace filigree::rewriting
