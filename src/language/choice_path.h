// Paths as text: what a document writes for a place of a derivation, and whether two paths say the same.
//
// to_text gives the normal form, which parse_path (parse.h) reads back as the same path.
#pragma once

#include <string>

#include "language/document.h"

namespace filigree {

// "big_poly/outline/in/quads[3]/outline.distance~2", as a document writes it.
std::string to_text(const ChoicePath& path);

// Whether two paths say the same, wherever they stand.
bool same_path(const ChoicePath& a, const ChoicePath& b);

}  // namespace filigree
