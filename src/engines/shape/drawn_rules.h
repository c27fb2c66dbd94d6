// Rules and shapes drawn in an SVG file, as one draws them in Inkscape.
//
// A rule is a group, called by its Inkscape label, else its id, else "rule" and its number. In it are
//   left, right   groups: its sides, drawn side by side or one over the other; also a and b, alpha and beta, lhs and
//                 rhs. Two groups without such names are the left side and the right one
//   origin        in each side a mark, any shape, group or text, of which the box's centre says where the side's origin
//                 is; one beside the sides serves both. Without marks the sides lie as they do on the page, the right
//                 one drawn over the left one
//   unless ...    groups or shapes: a condition each, what must not be there where the rule is applied
//   void ...      groups or shapes: closed paths in which nothing may lie
//   notes         for the eye alone, as are texts beside the sides
// and anything else belongs to both sides. What stands beside the sides lies as the left one does, but conditions and
// regions may have a mark `origin` of their own; within a side they lie as that one does. Texts in sides and conditions
// are labelled points. Names are case-blind, and what programs add to make them unique (left-3) is passed over.
//
// Rules stand in layers or in groups of rules; a layer is a rule only where its sides are named.
// Paper: section 3.3 and figure 10, where both sides of a rule are drawn in a coordinate system of their own.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/colour.h"
#include "base/result.h"
#include "formats/svg_read.h"
#include "plane/path.h"

namespace filigree::shape {

struct DrawnPath {
    Path path;                     // px
    std::optional<Colour> colour;  // of its stroke, where not all strokes of the file have the same
    double weight = 1;             // its stroke's width, px, where widths are weights

    bool operator==(const DrawnPath&) const = default;
};
struct DrawnLabel {
    std::string text;
    Vec place;  // px

    bool operator==(const DrawnLabel&) const = default;
};
struct DrawnSide {
    std::vector<DrawnPath> paths;
    std::vector<DrawnLabel> labels;

    bool operator==(const DrawnSide&) const = default;
};

struct DrawnRule {
    std::string name;
    DrawnSide left, right;
    std::vector<DrawnSide> conditions;
    std::vector<Path> regions;
    SourceSpan span;  // of its group
};

struct DrawnOptions {
    bool widths_are_weights = false;
};

// Of a picture that was read as a drawing, in its order; at least one. Warnings name groups that look like rules and
// are none, and sides that lie apart without marks.
Result<std::vector<DrawnRule>> drawn_rules(const SvgPicture& picture, const DrawnOptions& options = {});

// What is drawn in the groups and by the shapes of that id or label, in the whole file where the name is empty. Notes,
// conditions and regions in it are left out; it is moved so that a mark `origin` in it lies at the origin.
Result<DrawnSide> drawn_below(const SvgPicture& picture, std::string_view name, const DrawnOptions& options = {});

}  // namespace filigree::shape
