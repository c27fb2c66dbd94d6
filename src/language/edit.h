// Edits of a document's text that leave everything else as it is: comments, order, blanks, line ends.
//
// Each takes the text and gives a new one; parse it again to go on. Only the document itself is edited,
// never a file that it includes. For a document that parses without errors, the new text parses without errors
// to the same statements but for the value.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/result.h"
#include "language/document.h"

namespace filigree {

// The text with this seed: its `seed` statement changed, or one added behind `grammar` (else behind `filigree`,
// else at the start).
std::string with_seed(const Document& document, std::uint64_t seed);

// The text with another value for a parameter. An error where no `param` of the document itself has the name
// (with the nearest), or the value is no expression, or lies outside the parameter's constant domain.
// Blanks and comments around the value are not taken over. A value that is no constant is not compared.
Result<std::string> with_parameter(const Document& document, std::string_view name, std::string_view value);

}  // namespace filigree
