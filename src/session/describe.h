// The operators' descriptions as pages: what `list` and `describe` print, and the reference in docs/.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"

namespace filigree {

// Engines, operators, start shapes, functions and examples, a line each.
std::string list_text();
// One page on an operator, a start shape or an engine; an error with the nearest name where there is none.
Result<std::string> describe_text(std::string_view name);
// The whole language reference, as Markdown.
std::string reference_markdown();
// All descriptions, for programs.
std::string descriptions_json();

}  // namespace filigree
