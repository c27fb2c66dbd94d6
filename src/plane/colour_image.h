// A picture in its colours, as they are stored: what rules that look at pictures go by.
#pragma once

#include <cstdint>
#include <vector>

#include "base/colour.h"

namespace filigree {

struct ColourImage {
    std::uint32_t width = 0, height = 0;
    std::vector<Colour> pixels;  // width * height of them, rows from the top

    bool operator==(const ColourImage&) const = default;
};

}  // namespace filigree
