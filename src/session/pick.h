// What made the element at a point: the shape there, and the steps behind it, innermost first (gTangle, section 6).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "session/run.h"

namespace filigree {

// One step behind an element; of words, the rule that put a symbol, or one that it descends from.
struct PickedStep {
    std::string path;        // "big_poly/outline/in/regular_split"
    std::string document;    // whose step it is: the name of the document or of the one that it embeds
    std::string rule;        // its segment
    std::string operation;   // its operator; of words the rule as the document says it
    std::uint32_t line = 0;  // of the rule
    Key key;
    std::vector<std::pair<std::string, std::string>> arguments;  // as a document would write them
};
struct Picked {
    std::string path;               // of the group, with the shape's number where it has several: big_poly/outline/in/2
    std::string tag;                // "" is the unnamed terminal
    Key key;                        // of the shape
    double area = 0;                // px^2
    std::vector<PickedStep> steps;  // innermost first; empty for a shape of a start
};

// The shape that is drawn on top there, in the coordinates of the drawing, px; none where there is nothing. Shapes of
// documents that grow inside others are found, with the steps on both sides of the border; those of copies by a
// symmetry too, as the shapes that they copy.
std::optional<Picked> pick(const OpenedDocument& opened, const CheckedDocument& checked, const Run& run, Vec at);

std::string picked_text(const Picked& picked);
std::string picked_json(const Picked& picked);

}  // namespace filigree
