// Drawing a tangle: its leaves in ink on paper, one group of the drawing a step, nested as the derivation.
//
// Without a style a shape is white with a black border, an inverted one black, and what lies inside it is
// drawn in white. Pens are finer the deeper a shape lies. A `style` of a tag whose shapes were expanded
// draws their borders once more, over what they hold. Where a style says so, lines waver (`wobble`) and pens are
// drawn as by hand (`line: drawn`); one noise, the same for all documents, moves all that belongs to one.
#pragma once

#include "base/job.h"
#include "base/result.h"
#include "engines/tangle/grammar.h"
#include "engines/tangle/tangle.h"
#include "language/preset_walk.h"
#include "language/settings.h"
#include "scene/drawing.h"

namespace filigree::tangle {

enum class ColourBy {
    style,  // ink and paper, and what the styles say
    tag,    // hue by tag, brightness by group (gTangle, Figure 3)
    group,  // a hue of its own for every group
    step,   // from dark to light in the order of the steps
};

// Rows of Picture::choices that belong to one shape.
struct StyledShape {
    std::uint32_t group = 0;
    std::uint32_t shape = 0;  // its index there
    std::size_t first_choice = 0, end_choice = 0;
};

// Where the choices of a shape's styles are made: a shape that several steps hand on has styles of its own in each
// group.
inline Key style_key(const Group& group, std::size_t shape) { return child(group.key, group.shapes[shape].key.value); }

struct DrawOptions {
    ColourBy colour_by = ColourBy::style;
    DocumentSite site = {};  // as in the derivation
    Job job = {};            // its progress is not reported
};

struct Picture {
    Drawing drawing;
    Choices choices;                  // made in styles, shape by shape in the order of drawing
    std::vector<StyledShape> styled;  // where they were made
    std::vector<std::uint8_t> met;    // of each preset in force: whether it met a style
};

// With what has grown in the shapes of `embed` steps. Fault::limit where the job is cancelled.
Result<Picture> draw(const Tangle& tangle, const Grammar& grammar, const Settings& settings, const Document& document,
                     const DrawOptions& options);

}  // namespace filigree::tangle
