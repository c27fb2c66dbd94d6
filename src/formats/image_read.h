// Pictures as greys or colours: PNG (all of its kinds, through libpng) and JPEG (through libjpeg).
//
// Of greys, transparent pixels lie on white. A pixel's darkness is 1 less its luma (0.299 red, 0.587 green, 0.114 blue,
// of the values as they are stored), summed in integers, so that the same file gives the same numbers everywhere; 16
// bits a channel stay 16. Colour profiles and gamma are left aside: what counts is how dark a viewer that knows none
// shows it. Colours are the stored ones likewise, of 16 bits the higher 8; CMYK becomes the light that its inks leave.
// A JPEG is turned as its camera says.
#pragma once

#include <cstdint>
#include <string_view>

#include "base/result.h"
#include "plane/colour_image.h"
#include "plane/grey_image.h"

namespace filigree {

// Refused before anything is decoded: more than 64 million pixels (Fault::limit), and what is neither PNG nor
// JPEG. A file that breaks off is an error; a JPEG with damage inside is read with a warning.
Result<GreyImage> read_image(std::string_view bytes);
Result<ColourImage> read_colour_image(std::string_view bytes);

// For the decoders: whether a picture of this size may be read, or why not.
constexpr std::uint64_t most_image_pixels = 64'000'000;
Diagnostics check_image_size(std::uint64_t width, std::uint64_t height);

}  // namespace filigree
