// PNG to greys and colours. Every kind of PNG becomes rows of 16-bit red, green, blue and alpha first.
#include <png.h>

#include <bit>
#include <csetjmp>
#include <cstddef>
#include <cstring>
#include <string>
#include <vector>

#include "formats/image_decode.h"
#include "formats/image_read.h"

namespace filigree {
namespace {

constexpr std::size_t channels = 4;

struct Input {
    std::string_view bytes;
    std::size_t at = 0;
    std::string problem;
    bool is_cut_off = false;
};

void on_error(png_structp png, png_const_charp message) {
    static_cast<Input*>(png_get_error_ptr(png))->problem = message;
    png_longjmp(png, 1);
}
void on_warning(png_structp, png_const_charp) {}
void on_read(png_structp png, png_bytep to, png_size_t size) {
    Input& input = *static_cast<Input*>(png_get_io_ptr(png));
    if (input.bytes.size() - input.at < size) {
        input.is_cut_off = true;
        png_error(png, "it ends too early");
    }
    std::memcpy(to, input.bytes.data() + input.at, size);
    input.at += size;
}

// libpng leaves by longjmp, so nothing with a destructor may live in these frames.
bool read_head(png_structp png, png_infop info) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_read_info(png, info);
    return true;
}

// Of red, green, blue and alpha.
void set_pixel(float& darkness, const std::uint16_t* channel) {
    const std::uint64_t alpha = channel[3], paper = std::uint64_t{65535} * (65535 - alpha);
    darkness = darkness_of(channel[0] * alpha + paper, channel[1] * alpha + paper, channel[2] * alpha + paper,
                           std::uint64_t{65535} * 65535);
}
void set_pixel(Colour& colour, const std::uint16_t* channel) {
    const auto high = [&](int i) { return static_cast<std::uint8_t>(channel[i] >> 8); };
    colour = {high(0), high(1), high(2), high(3)};
}

// Rows as they are stored: of interlaced pictures, one sparse picture after another.
template <class Image>
bool read_rows(png_structp png, png_infop info, Image& image, std::vector<std::uint16_t>& row) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_set_expand_16(png);
    png_set_gray_to_rgb(png);
    png_set_add_alpha(png, 0xFFFF, PNG_FILLER_AFTER);
    if constexpr (std::endian::native == std::endian::little) png_set_swap(png);
    const bool is_interlaced = png_get_interlace_type(png, info) != PNG_INTERLACE_NONE;
    const int passes = is_interlaced ? PNG_INTERLACE_ADAM7_PASSES : 1;
    png_read_update_info(png, info);
    if (png_get_rowbytes(png, info) != channels * sizeof(std::uint16_t) * image.width) return false;
    for (int pass = 0; pass < passes; ++pass) {
        const std::uint32_t first_x = is_interlaced ? PNG_PASS_START_COL(pass) : 0;
        const std::uint32_t first_y = is_interlaced ? PNG_PASS_START_ROW(pass) : 0;
        const std::uint32_t step_x = is_interlaced ? 1U << PNG_PASS_COL_SHIFT(pass) : 1;
        const std::uint32_t step_y = is_interlaced ? 1U << PNG_PASS_ROW_SHIFT(pass) : 1;
        if (first_x >= image.width) continue;
        for (std::uint32_t y = first_y; y < image.height; y += step_y) {
            png_read_row(png, reinterpret_cast<png_bytep>(row.data()), nullptr);
            const std::uint16_t* pixel = row.data();
            auto* const to = pixels_of(image).data() + std::size_t{y} * image.width;
            for (std::uint32_t x = first_x; x < image.width; x += step_x, pixel += channels) set_pixel(to[x], pixel);
        }
    }
    png_read_end(png, nullptr);
    return true;
}

class PngReader {
public:
    explicit PngReader(Input& input)
        : png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, &input, on_error, on_warning)),
          info_(png_ == nullptr ? nullptr : png_create_info_struct(png_)) {
        if (info_ == nullptr) return;
        png_set_read_fn(png_, &input, on_read);
        png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // the size is checked here, in pixels
    }
    ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;

    png_structp png() { return png_; }
    png_infop info() { return info_; }

private:
    png_structp png_;
    png_infop info_;
};

}  // namespace

bool is_png(std::string_view bytes) {
    static constexpr std::string_view signature = "\x89PNG\r\n\x1A\n";
    return bytes.substr(0, signature.size()) == signature;
}

template <class Image>
Result<Image> decode_png(std::string_view bytes) {
    Input input{bytes, 0, {}, false};
    const auto broken = [&] {
        if (input.is_cut_off) return error("image.cut-off", "the PNG breaks off before its picture is complete");
        return error("image.broken", "the PNG is broken: " + (input.problem.empty() ? "no memory" : input.problem));
    };
    PngReader reader(input);
    if (reader.info() == nullptr || !read_head(reader.png(), reader.info())) return broken();
    Image image;
    image.width = png_get_image_width(reader.png(), reader.info());
    image.height = png_get_image_height(reader.png(), reader.info());
    if (Diagnostics refused = check_image_size(image.width, image.height); !refused.empty()) return refused;
    pixels_of(image).resize(std::size_t{image.width} * image.height);
    std::vector<std::uint16_t> row(channels * image.width);
    if (!read_rows(reader.png(), reader.info(), image, row)) return broken();
    return image;
}
template Result<GreyImage> decode_png(std::string_view bytes);
template Result<ColourImage> decode_png(std::string_view bytes);

}  // namespace filigree
