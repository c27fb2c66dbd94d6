// A curved shape grammar as plain data: an initial shape and rules left -> right, with what they ask of a match.
//
// Paper: Jowers and Earl, "Implementation of curved shape grammars", sections 2.1 and 3.3.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/colour.h"
#include "curves/detect.h"
#include "curves/shape.h"
#include "engines/shape/region.h"
#include "language/document.h"

namespace filigree::shape {

// Layers of elements (curves::Element::layer): of curves their colour, of points their label.
std::uint32_t layer_of_colour(std::optional<Colour> colour);  // 0: none, drawn as the styles say
std::optional<Colour> colour_of_layer(std::uint32_t layer);
std::uint32_t layer_of_label(std::string_view label);

struct Rule {
    std::string name;
    SourceSpan span;  // of its statement; of a drawn rule that of `rules from`
    curves::Shape left, right;
    const Expression* right_side = nullptr;  // evaluated anew for every application, where it makes choices
    bool by_corners = false;                 // matches every polygon with as many corners
    std::vector<Vec> corners;                // of such a rule's left side, in the order of a face
    // By which symmetries of the left side one match has several applications: the identity, and one for every way in
    // which the right side and the conditions look different.
    std::vector<Transform> variants = {Transform{}};
    std::vector<curves::Shape> forbidden;  // no match where one of them is part of the design
    std::vector<Region> voids;             // no match where the design has more than the match itself in one of them
    const Expression* condition = nullptr;
    double weight = 1;
    double priority = 0;           // rules of a lower one apply only where no other does
    curves::MatchOptions options;  // which maps its left side may take, and how closely it must fit
};

// How automatic derivation picks among the applications of the rule that it has drawn.
enum class Pick : std::uint8_t {
    random,
    first,
    all,
    orbit,  // a random one, and all that the design's symmetries make of it
};

// apply NAME at PLACE [angle A] [scale S] [mirrored] [orbit]
struct ApplyAt {
    std::uint32_t rule = 0;
    std::string name;                    // of the state behind it, for `back to`; else empty
    Vec place;                           // px
    std::optional<double> angle, scale;  // degrees, factor
    bool is_mirrored = false;
    bool is_orbit = false;  // at all places that the symmetries of the design take this one to
    SourceSpan span;
};
// back to NAME: the derivation goes on from the state that an `apply` has named, or from `start`.
struct BackTo {
    std::string name;
    SourceSpan span;
};

// What a drawing shows beside the design.
struct Show {
    bool control_polygons = false;       // as QI draws them
    bool points = false;                 // the ends of elements
    bool labels = false;                 // labelled points, with their labels
    bool dots = false;                   // the same as dots alone
    std::vector<std::uint32_t> matches;  // rules whose matches are shown
    std::optional<std::uint32_t> film;   // all states side by side, in so many columns; 0: as many as rows
};

struct Grammar {
    std::string start_tag;  // as the design is called in styles and paths
    curves::Shape start;
    std::vector<Rule> rules;
    std::map<std::uint32_t, std::string> labels;  // by layer
    double tolerance = 0;                         // px: what lies so near is the same
    std::uint64_t steps = 0;
    Pick pick = Pick::random;
    std::vector<std::variant<ApplyAt, BackTo>> by_hand;  // in the document's order
    Show show;
};

std::optional<std::uint32_t> find_rule(const Grammar& grammar, std::string_view name);
// The text of a label, by its layer.
std::string label_of(const Grammar& grammar, std::uint32_t layer);

}  // namespace filigree::shape
