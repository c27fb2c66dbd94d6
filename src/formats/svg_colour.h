// Colours as CSS writes them.
#pragma once

#include <optional>
#include <string_view>

#include "base/colour.h"

namespace filigree {

// #rgb, #rgba, #rrggbb, #rrggbbaa, rgb() and rgba() of numbers or per cents, and the names of CSS, case-blind. None for
// anything else: other colour spaces, words that are no colours such as `none`.
std::optional<Colour> parse_css_colour(std::string_view text);

}  // namespace filigree
