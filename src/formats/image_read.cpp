#include "formats/image_read.h"

#include <string>

#include "formats/image_decode.h"

namespace filigree {
namespace {

// What a file that is no picture for us probably is.
std::string_view likely_kind(std::string_view bytes) {
    const auto starts = [&](std::string_view with) { return bytes.substr(0, with.size()) == with; };
    if (starts("GIF8")) return "a GIF";
    if (starts("RIFF") && bytes.size() >= 12 && bytes.substr(8, 4) == "WEBP") return "a WebP";
    if (starts("BM")) return "a BMP";
    if (starts("II*") || starts(std::string_view("MM\0*", 4))) return "a TIFF";
    if (bytes.size() >= 12 && bytes.substr(4, 4) == "ftyp") return "an AVIF or HEIC";
    if (starts("%PDF")) return "a PDF";
    if (starts("<?xml") || starts("<svg")) return "an SVG";
    return "";
}

template <class Image>
Result<Image> read_as(std::string_view bytes) {
    if (bytes.empty()) return error("image.empty", "the picture is an empty file");
    if (is_png(bytes)) return decode_png<Image>(bytes);
    if (is_jpeg(bytes)) return decode_jpeg<Image>(bytes);
    const std::string_view kind = likely_kind(bytes);
    Diagnostic unknown = error("image.unknown-format",
                               kind.empty() ? "the picture is neither a PNG nor a JPEG"
                                            : "the picture is " + std::string(kind) + "; PNG and JPEG can be read");
    unknown.hints = {"convert it to PNG"};
    return unknown;
}

}  // namespace

Result<GreyImage> read_image(std::string_view bytes) { return read_as<GreyImage>(bytes); }
Result<ColourImage> read_colour_image(std::string_view bytes) { return read_as<ColourImage>(bytes); }

Diagnostics check_image_size(std::uint64_t width, std::uint64_t height) {
    if (width == 0 || height == 0) return {error("image.no-pixels", "the picture has no pixels")};
    if (width <= most_image_pixels / height) return {};
    Diagnostic refused = fault(
        Fault::limit, "image.too-large",
        "the picture has " + std::to_string(width) + " x " + std::to_string(height) + " pixels, more than 64 million");
    refused.hints = {"scale it down"};
    return {refused};
}

}  // namespace filigree
