// The decoders behind read_image and read_colour_image (image_read.h), one a format, each for both kinds of picture.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "plane/colour_image.h"
#include "plane/grey_image.h"

namespace filigree {

inline std::vector<float>& pixels_of(GreyImage& image) { return image.darkness; }
inline std::vector<Colour>& pixels_of(ColourImage& image) { return image.pixels; }

// `Image` is GreyImage or ColourImage.
bool is_png(std::string_view bytes);
template <class Image>
Result<Image> decode_png(std::string_view bytes);
bool is_jpeg(std::string_view bytes);
template <class Image>
Result<Image> decode_jpeg(std::string_view bytes);

// A picture under a layout of EXIF (1 to 8: how its rows and columns lie); itself for any other number.
template <class Image>
Image turned(Image image, std::uint32_t layout);

// 1 less the luma of a colour whose channels go from 0 to `white`, which is at most 2^32.
inline float darkness_of(std::uint64_t red, std::uint64_t green, std::uint64_t blue, std::uint64_t white) {
    const std::uint64_t full = 1000 * white;
    const std::uint64_t dark = full - (299 * red + 587 * green + 114 * blue);
    return static_cast<float>(static_cast<double>(dark) / static_cast<double>(full));
}

}  // namespace filigree
