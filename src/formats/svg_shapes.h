// SVG's basic shapes and its path element as paths in their own coordinates.
#pragma once

#include "formats/svg_attributes.h"
#include "plane/path.h"

namespace filigree {

bool is_shape_element(std::string_view local_name);

// The path of a shape element; empty where SVG draws nothing (a size of 0, no data). Rounded corners, circles and
// ellipses are quarter arcs. What is wrong with the element is added to the attributes' diagnostics.
Path shape_path(SvgAttributes& attributes);

}  // namespace filigree
