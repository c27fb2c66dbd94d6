// Styles: what `style TAG when CONDITION { property: value }` says of a shape.
//
// All statements whose tags match are gone through in order and later ones win, property by property. What
// does not depend on the shape is evaluated once, when the styles are read; a tag whose styles are all like
// that costs nothing per shape.
//
//   Result<StyleSheet> sheet = read_styles(settings, document);
//   TagStyle of_leaf = style_of_tag(*sheet, "leaf");               // once a tag
//   if (of_leaf.is_constant) use(of_leaf.common);
//   else use(*style_of_shape(*sheet, of_leaf, shape_scope, key));  // once a shape
//
// In paths the document's first style statement is `style`, the N-th style#N, below a shape: leaf/3/style#2.fill.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "base/colour.h"
#include "base/result.h"
#include "language/evaluate.h"
#include "language/settings.h"
#include "language/step_choices.h"
#include "scene/drawing.h"

namespace filigree {

enum class LineQuality : std::uint8_t { even, drawn };

// What styles say; properties that none names are absent.
struct StyleOverride {
    using Paint = std::optional<Colour>;  // empty: none
    std::optional<Paint> fill = {};
    std::optional<Paint> stroke = {};
    std::optional<double> pen = {};  // px, at least 0
    std::optional<Corner> corner = {};
    std::optional<double> wobble = {};         // px, at least 0: how far drawn lines leave their places at most
    std::optional<double> wobble_length = {};  // px, at least 1: from crest to crest
    std::optional<LineQuality> line = {};

    bool operator==(const StyleOverride&) const = default;
};

enum class StylePropertyKind : std::uint8_t { fill, stroke, pen, corner, wobble, wobble_length, line };

struct StyleRuleProperty {
    StylePropertyKind kind = StylePropertyKind::fill;
    ExpressionPtr value = {};
    std::optional<StyleOverride> constant = {};       // with this one property, where all shapes have the same
    std::vector<StyleOverride::Paint> by_group = {};  // where it depends on nothing but the shape's group
};
struct StyleRule {
    std::vector<std::string> tags = {};  // `*` matches every tag
    ExpressionPtr condition = {};        // null: always
    std::optional<bool> constant_condition = {};
    std::vector<StyleRuleProperty> properties = {};  // each kind once, the one that counts
    std::string segment = {};                        // in paths: "style", "style#2", ...
    // Under which its choices are drawn. Numbered among those that draw, so that plain statements between them change
    // no picture.
    std::string site = {};
};

// How paths name the N-th style statement of a document, from 1: style, style#2, ...
std::string style_segment(std::size_t number);

struct StyleSheet {
    const Document* document = nullptr;
    const Settings* settings = nullptr;
    std::vector<StyleRule> rules = {};
    std::vector<std::string_view> paint_words = {};  // colour words that are no names of the document, and none
};

// Checks every condition and value: unknown properties, names and words, wrong kinds, constants out of range.
// Expressions may use the globals and, of the shape, style_names() (names.h), or word_style_names() of a symbol.
// `settings` and `document` must outlive the result.
Result<StyleSheet> read_styles(const Settings& settings, const Document& document);

struct TagStyle {
    bool is_constant = true;
    StyleOverride common = {};              // what holds before any shape is looked at; all of it where constant
    std::vector<std::uint32_t> rules = {};  // the rules that must be gone through for each shape, in order
};
// `may_be_preset`: whether a preset may say something of a style; then no style is the same for all shapes.
TagStyle style_of_tag(const StyleSheet& sheet, std::string_view tag, bool may_be_preset = false);

// How the choices of a shape's styles are made: what presets say at GROUP/SHAPE/SEGMENT of `when` and of the
// properties, and where they are recorded: at the key of the shape, folded with the segment, under these names. What
// the result points to must last until the next call. Empty: drawn by the document's seed and not recorded.
using StyleChoices = std::function<Result<StepChoices>(std::string_view segment)>;

// The style of one shape. Its scope holds the shape's names (its outer scopes come before the globals); choices
// are drawn at its key. A list of colours as fill or stroke gives the shape's group one: the first to group 1.
Result<StyleOverride> style_of_shape(const StyleSheet& sheet, const TagStyle& of_tag, const Scope& shape, Key key,
                                     const StyleChoices& choices = {});

// What is wrong, whatever the shape, with a preset's value for a style's property (or its `when`), which
// knows the globals and the shape.
Diagnostics check_style_preset(std::string_view property, const Expression& value, const Document& document,
                               const Scope& globals);

}  // namespace filigree
