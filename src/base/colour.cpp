#include "base/colour.h"

namespace filigree {

std::string to_text(Colour colour) {
    constexpr char digits[] = "0123456789abcdef";
    std::string text = "#";
    const auto add = [&](std::uint8_t channel) {
        text += digits[channel >> 4];
        text += digits[channel & 15];
    };
    add(colour.red);
    add(colour.green);
    add(colour.blue);
    if (colour.alpha != 255) add(colour.alpha);
    return text;
}

}  // namespace filigree
