// A colour as documents and drawings know it: eight bits a channel, sRGB, straight alpha.
#pragma once

#include <cstdint>
#include <string>

namespace filigree {

struct Colour {
    std::uint8_t red = 0, green = 0, blue = 0, alpha = 255;

    bool operator==(const Colour&) const = default;
};

std::string to_text(Colour colour);  // #rrggbb, or #rrggbbaa where it is not opaque

}  // namespace filigree
