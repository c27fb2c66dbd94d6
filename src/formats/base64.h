// Base64 (RFC 4648, the standard alphabet with padding), for bytes that XML cannot hold.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace filigree {

// Lines of at most `line` characters with a newline between them; one line for 0.
std::string to_base64(std::string_view bytes, std::size_t line = 0);

// The bytes; white space is skipped. None where anything else is amiss: a foreign character, wrong padding,
// bits left over.
std::optional<std::string> from_base64(std::string_view text);

}  // namespace filigree
