// What the edits of words refuse alike.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/diagnostic.h"

namespace filigree::rewriting {

std::string quoted(std::u32string_view text);  // for messages: in quotes, long ones cut

Diagnostic unbalanced_text(std::string_view what, std::u32string_view text);
Diagnostic too_large_word(std::uint64_t symbols, std::uint64_t most_symbols);

}  // namespace filigree::rewriting
