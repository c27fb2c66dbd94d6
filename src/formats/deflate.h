// Bytes packed and unpacked as zlib streams (RFC 1950), by libdeflate.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace filigree {

// Fast before small: measured on path data, level 1 takes a twentieth of the time of zlib's level 6 for a tenth more
// bytes. The same bytes give the same stream.
std::string deflated(std::string_view bytes);

// What was packed; none where the stream is damaged or does not unpack to `size` bytes.
std::optional<std::string> inflated(std::string_view stream, std::size_t size);

}  // namespace filigree
