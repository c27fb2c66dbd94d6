// Whether bytes are a font whose outlines can be read, before a shaper sees them.
#pragma once

#include <string_view>

#include "base/result.h"

namespace filigree {

// Checks the signature, that the table directory and all tables lie within the file, and that there are a head, a
// cmap, widths and outlines. Of a collection the first font is checked. Empty where all is well.
Diagnostics check_font(std::string_view font);

}  // namespace filigree
