// Pixels to PNG bytes, by libpng.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "base/result.h"

namespace filigree {

struct PixelView {
    std::uint32_t width = 0, height = 0;
    const unsigned char* rows = nullptr;  // four bytes a pixel: one native 32-bit word 0xAARRGGBB
    std::size_t stride = 0;               // bytes from row to row
    bool has_alpha = false;               // premultiplied; else the upper byte means nothing
};

// Grey pictures are written as such. The picture says its size: `pixels_per_px` pixels are 1/96 in.
Result<std::string> encode_png(const PixelView& pixels, double pixels_per_px);

}  // namespace filigree
