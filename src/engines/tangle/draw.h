// Drawing a tangle: its leaves in ink on paper, one group of the drawing a step, nested as the derivation.
//
// Without a style a shape is white with a black border, an inverted one black, and what lies inside it is
// drawn in white. Pens are finer the deeper a shape lies. A `style` of a tag whose shapes were expanded
// draws their borders once more, over what they hold.
#pragma once

#include "base/result.h"
#include "engines/tangle/grammar.h"
#include "engines/tangle/tangle.h"
#include "language/settings.h"
#include "scene/drawing.h"

namespace filigree::tangle {

enum class ColourBy {
    style,  // ink and paper, and what the styles say
    tag,    // hue by tag, brightness by group (gTangle, Figure 3)
    group,  // a hue of its own for every group
    step,   // from dark to light in the order of the steps
};

Result<Drawing> draw(const Tangle& tangle, const Grammar& grammar, const Settings& settings, const Document& document,
                     ColourBy colour_by);

}  // namespace filigree::tangle
