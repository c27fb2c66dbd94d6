// JPEG to greys and colours. What most JPEGs hold is luma already, so no colour is decoded for greys of them.
#include <csetjmp>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

#include <jpeglib.h>

#include <jerror.h>

#include "formats/image_decode.h"
#include "formats/image_read.h"

namespace filigree {
namespace {

constexpr int most_scans = 200;  // real ones have some ten; a small file with thousands would take hours

struct Decoder {
    jpeg_decompress_struct jpeg{};
    jpeg_error_mgr errors{};
    jpeg_source_mgr source{};
    jpeg_progress_mgr progress{};
    std::jmp_buf leave{};
    std::string_view bytes;
    std::string problem, damage;
    bool is_cut_off = false;
};

Decoder& decoder_of(j_common_ptr jpeg) { return *static_cast<Decoder*>(jpeg->client_data); }
Decoder& decoder_of(j_decompress_ptr jpeg) { return *static_cast<Decoder*>(jpeg->client_data); }

std::string message_of(j_common_ptr jpeg) {
    char text[JMSG_LENGTH_MAX];
    jpeg->err->format_message(jpeg, text);
    return text;
}

[[noreturn]] void on_error(j_common_ptr jpeg) {
    Decoder& decoder = decoder_of(jpeg);
    decoder.problem = message_of(jpeg);
    std::longjmp(decoder.leave, 1);
}
void on_message(j_common_ptr jpeg, int level) {
    Decoder& decoder = decoder_of(jpeg);
    if (level < 0 && decoder.damage.empty()) decoder.damage = message_of(jpeg);
}
void on_progress(j_common_ptr jpeg) {
    Decoder& decoder = decoder_of(jpeg);
    if (decoder.jpeg.input_scan_number <= most_scans) return;
    decoder.problem = "it has too many scans";
    std::longjmp(decoder.leave, 1);
}

void on_start(j_decompress_ptr) {}
boolean on_empty(j_decompress_ptr jpeg) {
    Decoder& decoder = decoder_of(jpeg);
    decoder.is_cut_off = true;
    std::longjmp(decoder.leave, 1);
}
void on_skip(j_decompress_ptr jpeg, long count) {
    if (count <= 0) return;
    jpeg_source_mgr& source = *jpeg->src;
    if (static_cast<std::size_t>(count) > source.bytes_in_buffer) on_empty(jpeg);
    source.next_input_byte += count;
    source.bytes_in_buffer -= static_cast<std::size_t>(count);
}

// How the camera was held, from the EXIF data in an APP1 segment; 1 (upright) where none says so.
std::uint32_t exif_layout(const Decoder& decoder) {
    static constexpr std::string_view head("Exif\0\0", 6);
    for (jpeg_saved_marker_ptr marker = decoder.jpeg.marker_list; marker != nullptr; marker = marker->next) {
        std::string_view data(reinterpret_cast<const char*>(marker->data), marker->data_length);
        if (data.substr(0, head.size()) != head) continue;
        data.remove_prefix(head.size());
        if (data.size() < 8) return 1;
        const bool is_little = data[0] == 'I';
        const auto number = [&](std::size_t at, std::size_t size) {
            std::size_t value = 0;
            for (std::size_t i = 0; i < size; ++i) {
                const auto byte = static_cast<unsigned char>(data[is_little ? at + size - 1 - i : at + i]);
                value = value << 8 | byte;
            }
            return value;
        };
        const std::size_t entries = number(4, 4);
        if (entries > data.size() || data.size() - entries < 2) return 1;
        const std::size_t count = number(entries, 2);
        for (std::size_t i = 0, at = entries + 2; i < count && at + 12 <= data.size(); ++i, at += 12) {
            if (number(at, 2) == 0x112) return static_cast<std::uint32_t>(number(at + 8, 2));
        }
        return 1;
    }
    return 1;
}

// libjpeg leaves by longjmp, so nothing with a destructor may live in these frames.
bool read_head(Decoder& decoder) {
    jpeg_decompress_struct& jpeg = decoder.jpeg;
    if (setjmp(decoder.leave) != 0) return false;
    jpeg_create_decompress(&jpeg);
    decoder.source.next_input_byte = reinterpret_cast<const JOCTET*>(decoder.bytes.data());
    decoder.source.bytes_in_buffer = decoder.bytes.size();
    decoder.source.init_source = on_start;
    decoder.source.fill_input_buffer = on_empty;
    decoder.source.skip_input_data = on_skip;
    decoder.source.resync_to_restart = jpeg_resync_to_restart;
    decoder.source.term_source = on_start;
    decoder.progress.progress_monitor = on_progress;
    jpeg.src = &decoder.source;
    jpeg.progress = &decoder.progress;
    jpeg_save_markers(&jpeg, JPEG_APP0 + 1, 0xFFFF);
    jpeg_read_header(&jpeg, TRUE);
    return true;
}

enum class Samples : std::uint8_t { luma, colours, ink, missing_ink };

struct Light {
    std::uint64_t red = 0, green = 0, blue = 0, white = 255;  // each at most `white`
};
Light light_of(const JSAMPLE* sample, Samples samples) {
    if (samples == Samples::luma) return {sample[0], sample[0], sample[0]};
    if (samples == Samples::colours) return {sample[0], sample[1], sample[2]};
    std::uint64_t light[4];
    for (int i = 0; i < 4; ++i) light[i] = samples == Samples::ink ? std::uint64_t{255} - sample[i] : sample[i];
    return {light[0] * light[3], light[1] * light[3], light[2] * light[3], std::uint64_t{255} * 255};
}
void set_pixel(float& darkness, Light light) {
    darkness = darkness_of(light.red, light.green, light.blue, light.white);
}
void set_pixel(Colour& colour, Light light) {
    const auto rounded = [&](std::uint64_t value) {
        return static_cast<std::uint8_t>((255 * value + light.white / 2) / light.white);
    };
    colour = {rounded(light.red), rounded(light.green), rounded(light.blue), 255};
}

// What libjpeg is asked for, of pictures that are not printed.
Samples samples_for(const GreyImage&, const jpeg_decompress_struct& jpeg) {
    const bool is_luma = jpeg.jpeg_color_space == JCS_GRAYSCALE || jpeg.jpeg_color_space == JCS_YCbCr;
    return is_luma ? Samples::luma : Samples::colours;
}
Samples samples_for(const ColourImage&, const jpeg_decompress_struct& jpeg) {
    return jpeg.jpeg_color_space == JCS_GRAYSCALE ? Samples::luma : Samples::colours;
}

template <class Image>
bool read_rows(Decoder& decoder, Image& image, std::vector<JSAMPLE>& row) {
    jpeg_decompress_struct& jpeg = decoder.jpeg;
    if (setjmp(decoder.leave) != 0) return false;
    const bool is_ink = jpeg.jpeg_color_space == JCS_CMYK || jpeg.jpeg_color_space == JCS_YCCK;
    // Adobe's CMYK counts the ink that is missing; what says nothing of Adobe counts the ink.
    const Samples samples = !is_ink                      ? samples_for(image, jpeg)
                            : jpeg.saw_Adobe_marker != 0 ? Samples::missing_ink
                                                         : Samples::ink;
    jpeg.out_color_space = is_ink ? JCS_CMYK : samples == Samples::luma ? JCS_GRAYSCALE : JCS_RGB;
    jpeg.dct_method = JDCT_ISLOW;      // the one that is the same everywhere,
    jpeg.do_fancy_upsampling = FALSE;  // and so is this
    jpeg_start_decompress(&jpeg);
    if (jpeg.output_width != image.width || jpeg.output_height != image.height) return false;
    const auto step = static_cast<std::size_t>(jpeg.output_components);
    if (step != (is_ink ? 4U : samples == Samples::luma ? 1U : 3U)) return false;
    for (std::uint32_t y = 0; y < image.height; ++y) {
        JSAMPROW rows[] = {row.data()};
        if (jpeg_read_scanlines(&jpeg, rows, 1) != 1) return false;
        auto* const to = pixels_of(image).data() + std::size_t{y} * image.width;
        for (std::uint32_t x = 0; x < image.width; ++x) set_pixel(to[x], light_of(row.data() + x * step, samples));
    }
    return true;  // what follows the last row is of no use
}

template <class Image>
Result<Image> decode(Decoder& decoder) {
    const auto broken = [&] {
        if (decoder.is_cut_off) return error("image.cut-off", "the JPEG breaks off before its picture is complete");
        return error("image.broken",
                     "the JPEG is broken: " + (decoder.problem.empty() ? "unknown colours" : decoder.problem));
    };
    if (!read_head(decoder)) return broken();
    Image image;
    image.width = decoder.jpeg.image_width;
    image.height = decoder.jpeg.image_height;
    if (Diagnostics refused = check_image_size(image.width, image.height); !refused.empty()) return refused;
    const std::uint32_t layout = exif_layout(decoder);
    pixels_of(image).resize(std::size_t{image.width} * image.height);
    std::vector<JSAMPLE> row(std::size_t{4} * image.width);
    if (!read_rows(decoder, image, row)) return broken();
    Diagnostics warnings;
    if (!decoder.damage.empty()) {
        warnings.push_back(
            warning("image.damaged", "the JPEG is damaged and was read as far as that goes: " + decoder.damage));
    }
    return {turned(std::move(image), layout), std::move(warnings)};
}

}  // namespace

bool is_jpeg(std::string_view bytes) { return bytes.substr(0, 3) == "\xFF\xD8\xFF"; }

template <class Image>
Result<Image> decode_jpeg(std::string_view bytes) {
    Decoder decoder;
    decoder.bytes = bytes;
    decoder.jpeg.err = jpeg_std_error(&decoder.errors);
    decoder.jpeg.client_data = &decoder;
    decoder.errors.error_exit = on_error;
    decoder.errors.emit_message = on_message;
    Result<Image> image = decode<Image>(decoder);
    jpeg_destroy_decompress(&decoder.jpeg);
    return image;
}
template Result<GreyImage> decode_jpeg(std::string_view bytes);
template Result<ColourImage> decode_jpeg(std::string_view bytes);

template <class Image>
Image turned(Image image, std::uint32_t layout) {
    if (layout < 2 || layout > 8) return image;
    const bool is_transposed = layout >= 5;
    const bool flips_x = layout == 2 || layout == 3 || layout == 7 || layout == 8;
    const bool flips_y = layout == 3 || layout == 4 || layout == 6 || layout == 7;
    Image result;
    result.width = is_transposed ? image.height : image.width;
    result.height = is_transposed ? image.width : image.height;
    pixels_of(result).resize(pixels_of(image).size());
    for (std::uint32_t y = 0; y < result.height; ++y) {
        for (std::uint32_t x = 0; x < result.width; ++x) {
            std::uint32_t from_x = is_transposed ? y : x, from_y = is_transposed ? x : y;
            if (flips_x) from_x = image.width - 1 - from_x;
            if (flips_y) from_y = image.height - 1 - from_y;
            pixels_of(result)[std::size_t{y} * result.width + x] =
                pixels_of(image)[std::size_t{from_y} * image.width + from_x];
        }
    }
    return result;
}
template GreyImage turned(GreyImage image, std::uint32_t layout);
template ColourImage turned(ColourImage image, std::uint32_t layout);

}  // namespace filigree
