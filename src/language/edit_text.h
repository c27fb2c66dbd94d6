// What edits do with a document's text: replace bytes, add a line at its end, take a statement out.
//
// Everything else of the text stays as it is. Added lines end as the last line of the text does.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "language/expression.h"

namespace filigree {

// The text with `with` in the place of its bytes begin..end.
std::string spliced(std::string_view text, std::size_t begin, std::size_t end, std::string_view with);

// The bytes of an expression that stands in the text.
std::string_view text_of(const Expression& expression, std::string_view text);

// The text with one more line, which gets a line end behind it. A last line without one gets its own first.
std::string with_last_line(std::string_view text, std::string_view line);

// The text without the statement at begin..end, nor one ';' that set it apart. Its lines go where nothing else
// stands on them; a comment behind it stays.
std::string without_statement(std::string_view text, std::uint32_t begin, std::uint32_t end);

}  // namespace filigree
