// Drawing a design: its elements as pens draw them, joined to paths, by the step that they came with; and what a
// document asks to be shown over them.
//
// Elements of the start have the style of its tag, those that a rule put that of the rule; colours and weights of their
// own go over it. Paper: Jowers and Earl, section 3.3, for control polygons and matches that are scrolled through.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/job.h"
#include "base/result.h"
#include "engines/shape/derive.h"
#include "scene/drawing.h"

namespace filigree::shape {

struct DrawOptions {
    Key root;  // folded into all keys
    Job job = {};
};

struct Picture {
    Drawing drawing;
    double scale = 1;  // by which the design was enlarged
    // Of each shape of the drawing: the elements of the design that it shows, by index; nothing of marks.
    std::vector<std::vector<std::uint32_t>> elements;
};

// The design where the derivation stands; with `show film`, all states on the way there, side by side.
Result<Picture> draw(const Derivation& derivation, const Grammar& grammar, const Surroundings& around,
                     const DrawOptions& options);

// One design with some applications of rules over it, each in a hue of its own and with its number.
Result<Drawing> draw_matches(const Derivation& derivation, const Grammar& grammar, const Surroundings& around,
                             const std::vector<Application>& shown, const DrawOptions& options);

// Designs side by side, each with a label below.
Result<Drawing> draw_sheet(const std::vector<curves::Shape>& designs, const std::vector<std::string>& labels,
                           const Grammar& grammar, const Surroundings& around, std::uint32_t columns,
                           const DrawOptions& options);

}  // namespace filigree::shape
