// Colours as documents name them: the basic colour words of CSS, and colour values.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "base/colour.h"
#include "base/result.h"
#include "language/evaluate.h"

namespace filigree {

// The sixteen basic words, orange and transparent.
std::span<const std::string_view> colour_words();
// Those that the scope does not use for something else: a palette named `teal` is that palette.
std::vector<std::string_view> colour_words_beside(const Scope* scope);

// A colour, or a word for one.
Result<Colour> as_colour(const Value& value);

}  // namespace filigree
