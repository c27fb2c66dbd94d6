// The values of style properties: what may be written for them, and what they come to.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "language/evaluate.h"
#include "language/style.h"

namespace filigree {

// By any of its names: stroke-width is pen, and wobble-length wobble_length, which paths can name.
std::optional<StylePropertyKind> find_style_property(std::string_view name);
std::vector<std::string_view> style_property_names();
std::string_view name_of(StylePropertyKind kind);

// An evaluation for one shape: the whole expression stands inside each(...).
Evaluation evaluation_for(const Document& document, const Scope& globals, const Scope& shape, Key key);
// With the words that may stand for the property.
void expect(Evaluation& at, const std::vector<std::string_view>& paint_words, StylePropertyKind kind);
std::vector<std::string_view> paint_words_beside(const Scope& globals);

// One colour or none, or a list of them.
struct Paints {
    std::vector<StyleOverride::Paint> items;
    bool is_list = false;
};
Result<Paints> paints_of(StylePropertyKind kind, const Value& value, SourceSpan span);
// The group's own colour of a list: the first one for group 1, over and over.
StyleOverride::Paint paint_for_group(const std::vector<StyleOverride::Paint>& paints, const Scope& shape);

// Whether the same value gives every shape the same property.
bool depends_on_group(StylePropertyKind kind, const Value& value);
// The property as an override of its own. `document` says what a bare length means.
Result<StyleOverride> override_of(StylePropertyKind kind, const Value& value, const Document& document,
                                  const Scope& shape, SourceSpan span);

}  // namespace filigree
