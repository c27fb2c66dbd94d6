#include "formats/image_read.h"

#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <jpeglib.h>

#include "base/test_cases.h"
#include "formats/image_decode.h"

namespace filigree {
namespace {

struct PngKind {
    int colour = PNG_COLOR_TYPE_GRAY, depth = 8, interlace = PNG_INTERLACE_NONE;
};

// `rows` as they are stored, packed to whole bytes.
std::string png_of(std::uint32_t width, std::uint32_t height, PngKind kind, std::vector<std::string> rows,
                   const std::vector<png_color>& palette = {}, std::vector<unsigned char> transparent = {},
                   const png_color_16* key = nullptr) {
    std::string bytes;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(
        png, &bytes,
        [](png_structp to, png_bytep data, png_size_t size) {
            static_cast<std::string*>(png_get_io_ptr(to))->append(reinterpret_cast<const char*>(data), size);
        },
        nullptr);
    png_set_IHDR(png, info, width, height, kind.depth, kind.colour, kind.interlace, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    if (!palette.empty()) png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
    if (!transparent.empty()) {
        png_set_tRNS(png, info, transparent.data(), static_cast<int>(transparent.size()), nullptr);
    } else if (key != nullptr) {
        png_set_tRNS(png, info, nullptr, 0, key);
    }
    png_write_info(png, info);
    std::vector<png_bytep> pointers;
    for (std::string& row : rows) pointers.push_back(reinterpret_cast<png_bytep>(row.data()));
    png_write_image(png, pointers.data());
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return bytes;
}

std::string jpeg_of(int width, int height, J_COLOR_SPACE space, int components, const std::string& pixels,
                    bool is_progressive = false, const std::string& exif = "") {
    jpeg_compress_struct jpeg{};
    jpeg_error_mgr errors{};
    jpeg.err = jpeg_std_error(&errors);
    jpeg_create_compress(&jpeg);
    unsigned char* memory = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&jpeg, &memory, &size);
    jpeg.image_width = static_cast<JDIMENSION>(width);
    jpeg.image_height = static_cast<JDIMENSION>(height);
    jpeg.input_components = components;
    jpeg.in_color_space = space;
    jpeg_set_defaults(&jpeg);
    jpeg_set_quality(&jpeg, 100, TRUE);
    if (is_progressive) jpeg_simple_progression(&jpeg);
    jpeg_start_compress(&jpeg, TRUE);
    if (!exif.empty()) {
        jpeg_write_marker(&jpeg, JPEG_APP0 + 1, reinterpret_cast<const JOCTET*>(exif.data()),
                          static_cast<unsigned>(exif.size()));
    }
    while (jpeg.next_scanline < jpeg.image_height) {
        std::string row = pixels.substr(std::size_t{jpeg.next_scanline} * width * components,
                                        static_cast<std::size_t>(width) * components);
        JSAMPROW rows[] = {reinterpret_cast<JSAMPROW>(row.data())};
        jpeg_write_scanlines(&jpeg, rows, 1);
    }
    jpeg_finish_compress(&jpeg);
    std::string bytes(reinterpret_cast<char*>(memory), size);
    jpeg_destroy_compress(&jpeg);
    std::free(memory);
    return bytes;
}

GreyImage read(const std::string& bytes) {
    const Result<GreyImage> image = read_image(bytes);
    EXPECT_TRUE(image) << (image ? "" : image.diagnostics()[0].message);
    EXPECT_TRUE(image.diagnostics().empty());
    return image ? *image : GreyImage{};
}

std::vector<Colour> colours_in(const std::string& bytes) {
    const Result<ColourImage> image = read_colour_image(bytes);
    EXPECT_TRUE(image) << (image ? "" : image.diagnostics()[0].message);
    EXPECT_TRUE(image.diagnostics().empty());
    return image ? image->pixels : std::vector<Colour>{};
}

std::string code_of(std::string_view bytes) {
    const Result<GreyImage> image = read_image(bytes);
    const Result<ColourImage> colour = read_colour_image(bytes);
    EXPECT_EQ(image.diagnostics().size(), colour.diagnostics().size());
    EXPECT_EQ(image ? "ok" : image.diagnostics()[0].code, colour ? "ok" : colour.diagnostics()[0].code);
    return image ? "ok" : image.diagnostics()[0].code;
}

std::string bytes_of(std::initializer_list<int> values) {
    std::string text;
    for (const int value : values) text += static_cast<char>(value);
    return text;
}

TEST(ImageRead, GreysOfEveryDepth) {
    const auto darkness = [&](int depth, const std::string& row) {
        return read(png_of(4, 1, {PNG_COLOR_TYPE_GRAY, depth}, {row})).darkness;
    };
    using Row = std::vector<float>;
    EXPECT_EQ(darkness(1, bytes_of({0b10110000})), (Row{0, 1, 0, 0}));
    EXPECT_EQ(darkness(2, bytes_of({0b00011011})), (Row{1, 2 / 3.F, 1 / 3.F, 0}));
    EXPECT_EQ(darkness(4, bytes_of({0x0F, 0x36})), (Row{1, 0, 12 / 15.F, 9 / 15.F}));
    EXPECT_EQ(darkness(8, bytes_of({0, 255, 51, 102})), (Row{1, 0, 0.8F, 0.6F}));
    const Row fine = darkness(16, bytes_of({0, 0, 255, 255, 0, 1, 1, 0}));
    EXPECT_EQ(fine, (Row{1, 0, static_cast<float>(65534.0 / 65535), static_cast<float>((65535.0 - 256) / 65535)}));
}

TEST(ImageRead, ColoursAndAlpha) {
    const auto near = [](float value, double expected) { EXPECT_NEAR(value, expected, 1e-6); };
    const GreyImage rgb = read(png_of(2, 2, {PNG_COLOR_TYPE_RGB, 8},
                                      {bytes_of({255, 0, 0, 0, 255, 0}), bytes_of({0, 0, 255, 255, 255, 255})}));
    EXPECT_EQ(rgb.width, 2U);
    EXPECT_EQ(rgb.height, 2U);
    near(rgb.darkness[0], 1 - 0.299);
    near(rgb.darkness[1], 1 - 0.587);
    near(rgb.darkness[2], 1 - 0.114);
    EXPECT_EQ(rgb.darkness[3], 0);

    const GreyImage rgba =
        read(png_of(3, 1, {PNG_COLOR_TYPE_RGB_ALPHA, 8}, {bytes_of({0, 0, 0, 51, 0, 0, 0, 0, 255, 255, 255, 128})}));
    near(rgba.darkness[0], 0.2);
    EXPECT_EQ(rgba.darkness[1], 0);  // transparent black is paper
    EXPECT_EQ(rgba.darkness[2], 0);
    const GreyImage grey_alpha =
        read(png_of(2, 1, {PNG_COLOR_TYPE_GRAY_ALPHA, 16}, {bytes_of({0, 0, 0x33, 0x33, 0x66, 0x66, 0xFF, 0xFF})}));
    near(grey_alpha.darkness[0], 0.2);
    near(grey_alpha.darkness[1], 0.6);

    const GreyImage palette = read(png_of(4, 1, {PNG_COLOR_TYPE_PALETTE, 2}, {bytes_of({0b00011011})},
                                          {{0, 0, 0}, {255, 255, 255}, {255, 0, 0}, {0, 0, 0}}, {255, 255, 255, 102}));
    EXPECT_EQ(palette.darkness[0], 1);
    EXPECT_EQ(palette.darkness[1], 0);
    near(palette.darkness[2], 1 - 0.299);
    near(palette.darkness[3], 0.4);
    png_color_16 key{};
    key.gray = 10;
    const GreyImage keyed = read(png_of(2, 1, {PNG_COLOR_TYPE_GRAY, 8}, {bytes_of({10, 0})}, {}, {}, &key));
    EXPECT_EQ(keyed.darkness, (std::vector<float>{0, 1}));
}

TEST(ImageRead, ColoursAsTheyAreStored) {
    using Row = std::vector<Colour>;
    const auto grey = [](std::uint8_t level) { return Colour{level, level, level}; };
    EXPECT_EQ(colours_in(png_of(4, 1, {PNG_COLOR_TYPE_GRAY, 1}, {bytes_of({0b10110000})})),
              (Row{grey(255), grey(0), grey(255), grey(255)}));
    EXPECT_EQ(colours_in(png_of(4, 1, {PNG_COLOR_TYPE_GRAY, 4}, {bytes_of({0x0F, 0x36})})),
              (Row{grey(0), grey(255), grey(51), grey(102)}));
    EXPECT_EQ(colours_in(png_of(3, 1, {PNG_COLOR_TYPE_GRAY, 16}, {bytes_of({0, 255, 1, 0, 0x7F, 0xFF})})),
              (Row{grey(0), grey(1), grey(0x7F)}))
        << "rounded down";
    EXPECT_EQ(colours_in(png_of(2, 2, {PNG_COLOR_TYPE_RGB, 8},
                                {bytes_of({255, 0, 1, 2, 254, 3}), bytes_of({4, 5, 253, 255, 255, 255})})),
              (Row{{255, 0, 1}, {2, 254, 3}, {4, 5, 253}, {255, 255, 255}}));
    EXPECT_EQ(colours_in(png_of(2, 1, {PNG_COLOR_TYPE_RGB_ALPHA, 8}, {bytes_of({9, 8, 7, 0, 6, 5, 4, 128})})),
              (Row{{9, 8, 7, 0}, {6, 5, 4, 128}}))
        << "what is transparent keeps its colour";
    EXPECT_EQ(colours_in(png_of(1, 1, {PNG_COLOR_TYPE_GRAY_ALPHA, 16}, {bytes_of({0x33, 0x99, 0x80, 0xFF})})),
              (Row{{0x33, 0x33, 0x33, 0x80}}));
    EXPECT_EQ(colours_in(png_of(2, 1, {PNG_COLOR_TYPE_PALETTE, 1}, {bytes_of({0b10000000})}, {{1, 2, 3}, {250, 20, 30}},
                                {255, 102})),
              (Row{{250, 20, 30, 102}, {1, 2, 3, 255}}));
    png_color_16 key{};
    key.gray = 10;
    EXPECT_EQ(colours_in(png_of(2, 1, {PNG_COLOR_TYPE_GRAY, 8}, {bytes_of({10, 11})}, {}, {}, &key)),
              (Row{{10, 10, 10, 0}, grey(11)}));
}

TEST(ImageRead, InterlacedPicturesAreTheSame) {
    CaseRandom random(5);
    for (const std::uint32_t width : {1U, 2U, 3U, 5U, 8U, 9U, 17U}) {
        for (const std::uint32_t height : {1U, 2U, 4U, 5U, 9U, 16U}) {
            std::vector<std::string> rows(height);
            for (std::string& row : rows) {
                for (std::uint32_t i = 0; i < 3 * width; ++i) row += static_cast<char>(random.below(256));
            }
            const GreyImage plain = read(png_of(width, height, {PNG_COLOR_TYPE_RGB, 8}, rows));
            const std::string interlaced = png_of(width, height, {PNG_COLOR_TYPE_RGB, 8, PNG_INTERLACE_ADAM7}, rows);
            EXPECT_EQ(plain, read(interlaced));
            const std::vector<Colour> pixels = colours_in(interlaced);
            ASSERT_EQ(pixels.size(), std::size_t{width} * height);
            for (std::uint32_t y = 0; y < height; ++y) {
                for (std::uint32_t x = 0; x < width; ++x) {
                    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(rows[y][3 * x + i]); };
                    ASSERT_EQ(pixels[y * width + x], (Colour{byte(0), byte(1), byte(2)}));
                }
            }
        }
    }
}

TEST(ImageRead, JpegsOfEveryKind) {
    std::string greys, colours, ink;
    for (int y = 0; y < 24; ++y) {
        for (int x = 0; x < 32; ++x) {
            greys += static_cast<char>(8 * x);
            colours += bytes_of({8 * x, 255 - 8 * x, 4 * y});
            ink += bytes_of({255 - 8 * x, 255 - 8 * x, 255 - 8 * x, 255 - 4 * y});  // missing ink, as Adobe counts
        }
    }
    for (const bool is_progressive : {false, true}) {
        const GreyImage grey = read(jpeg_of(32, 24, JCS_GRAYSCALE, 1, greys, is_progressive));
        const GreyImage colour = read(jpeg_of(32, 24, JCS_RGB, 3, colours, is_progressive));
        const GreyImage printed = read(jpeg_of(32, 24, JCS_CMYK, 4, ink, is_progressive));
        ASSERT_EQ(grey.width, 32U);
        ASSERT_EQ(grey.height, 24U);
        ASSERT_EQ(colour.darkness.size(), 32U * 24);
        ASSERT_EQ(printed.darkness.size(), 32U * 24);
        const auto coloured = [&](J_COLOR_SPACE space, int components, const std::string& pixels) {
            std::vector<Colour> read = colours_in(jpeg_of(32, 24, space, components, pixels, is_progressive));
            EXPECT_EQ(read.size(), 32U * 24);
            read.resize(32 * 24);
            return read;
        };
        const std::vector<Colour> grey_pixels = coloured(JCS_GRAYSCALE, 1, greys);
        const std::vector<Colour> colour_pixels = coloured(JCS_RGB, 3, colours);
        const std::vector<Colour> printed_pixels = coloured(JCS_CMYK, 4, ink);
        const auto expect_near = [](Colour found, double red, double green, double blue, double tolerance) {
            EXPECT_NEAR(found.red, red, tolerance);
            EXPECT_NEAR(found.green, green, tolerance);
            EXPECT_NEAR(found.blue, blue, tolerance);
            EXPECT_EQ(found.alpha, 255);
        };
        for (std::size_t y = 0; y < 24; ++y) {
            for (std::size_t x = 0; x < 32; ++x) {
                const double X = static_cast<double>(x), Y = static_cast<double>(y);
                EXPECT_NEAR(grey.darkness[y * 32 + x], 1 - 8 * X / 255, 0.02);
                const double luma = 0.299 * 8 * X + 0.587 * (255 - 8 * X) + 0.114 * 4 * Y;
                EXPECT_NEAR(colour.darkness[y * 32 + x], 1 - luma / 255, 0.03);
                const double light = (255 - 8 * X) * (255 - 4 * Y) / 255;
                EXPECT_NEAR(printed.darkness[y * 32 + x], 1 - light / 255, 0.03);
                expect_near(grey_pixels[y * 32 + x], 8 * X, 8 * X, 8 * X, 2);
                expect_near(colour_pixels[y * 32 + x], 8 * X, 255 - 8 * X, 4 * Y, 12);  // colours are stored coarsely
                expect_near(printed_pixels[y * 32 + x], light, light, light, 4);
            }
        }
    }
}

TEST(ImageRead, TurnsPicturesAsTheCameraSays) {
    // 3 x 2:  0 1 2 / 3 4 5
    const GreyImage stored{3, 2, {0, 1, 2, 3, 4, 5}};
    using Rows = std::vector<float>;
    EXPECT_EQ(turned(stored, 1), stored);
    EXPECT_EQ(turned(stored, 2).darkness, (Rows{2, 1, 0, 5, 4, 3}));
    EXPECT_EQ(turned(stored, 3).darkness, (Rows{5, 4, 3, 2, 1, 0}));
    EXPECT_EQ(turned(stored, 4).darkness, (Rows{3, 4, 5, 0, 1, 2}));
    EXPECT_EQ(turned(stored, 5).darkness, (Rows{0, 3, 1, 4, 2, 5}));
    EXPECT_EQ(turned(stored, 6).darkness, (Rows{3, 0, 4, 1, 5, 2}));
    EXPECT_EQ(turned(stored, 6).width, 2U);
    EXPECT_EQ(turned(stored, 7).darkness, (Rows{5, 2, 4, 1, 3, 0}));
    EXPECT_EQ(turned(stored, 8).darkness, (Rows{2, 5, 1, 4, 0, 3}));
    EXPECT_EQ(turned(stored, 9), stored);
    const Colour a{1, 2, 3}, b{4, 5, 6, 7};
    EXPECT_EQ(turned(ColourImage{2, 1, {a, b}}, 8), (ColourImage{1, 2, {b, a}}));

    const std::string pixels = std::string(16 * 8, '\xFF') + std::string(16 * 8, '\0');  // dark below
    const std::string motorola =
        bytes_of({'E', 'x', 'i', 'f', 0, 0, 'M', 'M', 0, 42, 0, 0, 0, 8, 0, 1, 1, 0x12, 0, 3, 0, 0, 0, 1, 0, 6, 0, 0});
    const std::string intel =
        bytes_of({'E', 'x', 'i', 'f', 0, 0, 'I', 'I', 42, 0, 8, 0, 0, 0, 1, 0, 0x12, 1, 3, 0, 1, 0, 0, 0, 6, 0, 0, 0});
    for (const std::string& exif : {motorola, intel}) {
        const GreyImage image = read(jpeg_of(16, 16, JCS_GRAYSCALE, 1, pixels, false, exif));
        EXPECT_GT(image.darkness[8 * 16 + 2], 0.9F);  // a quarter turn clockwise: dark on the left
        EXPECT_LT(image.darkness[8 * 16 + 13], 0.1F);
        const std::vector<Colour> turned_colours = colours_in(jpeg_of(16, 16, JCS_GRAYSCALE, 1, pixels, false, exif));
        ASSERT_EQ(turned_colours.size(), 256U);
        EXPECT_LT(turned_colours[8 * 16 + 2].red, 25);
        EXPECT_GT(turned_colours[8 * 16 + 13].red, 230);
        for (std::size_t length = 0; length < exif.size(); ++length) {
            read(jpeg_of(16, 16, JCS_GRAYSCALE, 1, pixels, false, exif.substr(0, length)));
        }
    }
}

TEST(ImageRead, RefusesWhatItCannotRead) {
    EXPECT_EQ(code_of(""), "image.empty");
    EXPECT_EQ(code_of("x"), "image.unknown-format");
    EXPECT_EQ(code_of("GIF89a..."), "image.unknown-format");
    EXPECT_EQ(read_image("GIF89a...").diagnostics()[0].message, "the picture is a GIF; PNG and JPEG can be read");
    EXPECT_EQ(code_of("\x89PNG\r\n\x1A\n"), "image.cut-off");
    EXPECT_EQ(code_of("\xFF\xD8\xFF"), "image.cut-off");
    EXPECT_EQ(code_of("\xFF\xD8\xFF\xD9"), "image.broken");
    const std::string png = png_of(2, 2, {}, {bytes_of({0, 1}), bytes_of({2, 3})});
    EXPECT_EQ(code_of(png), "ok");
    EXPECT_EQ(code_of(png.substr(0, png.size() - 20)), "image.cut-off");
    std::string wrong = png;
    wrong[20] = '\x7F';  // the checksum no longer fits
    EXPECT_EQ(code_of(wrong), "image.broken");
    const std::string jpeg = jpeg_of(64, 64, JCS_GRAYSCALE, 1, std::string(64 * 64, 'a') + "b");
    EXPECT_EQ(code_of(jpeg), "ok");
    EXPECT_EQ(code_of(jpeg.substr(0, jpeg.size() - 40)), "image.cut-off");
}

TEST(ImageRead, RefusesHugePicturesBeforeItDecodesThem) {
    const auto png_head = [](std::uint32_t width, std::uint32_t height) {
        std::string ihdr = "IHDR";
        for (const std::uint32_t side : {width, height}) {
            for (const int shift : {24, 16, 8, 0}) ihdr += static_cast<char>(side >> shift & 255);
        }
        ihdr += bytes_of({8, 0, 0, 0, 0});
        std::uint32_t crc = 0xFFFFFFFFU;
        for (const char c : ihdr) {
            crc ^= static_cast<unsigned char>(c);
            for (int i = 0; i < 8; ++i) crc = crc >> 1 ^ (crc & 1 ? 0xEDB88320U : 0);
        }
        crc = ~crc;
        std::string bytes = "\x89PNG\r\n\x1A\n" + bytes_of({0, 0, 0, 13}) + ihdr;
        for (const int shift : {24, 16, 8, 0}) bytes += static_cast<char>(crc >> shift & 255);
        return bytes + bytes_of({0, 0, 0, 0}) + "IDAT" + bytes_of({0x35, 0xAF, 0x06, 0x1E});
    };
    EXPECT_EQ(code_of(png_head(8001, 8000)), "image.too-large");
    EXPECT_EQ(code_of(png_head(0x7FFFFFFF, 0x7FFFFFFF)), "image.too-large");
    EXPECT_EQ(read_image(png_head(64'000'001, 1)).diagnostics()[0].fault, Fault::limit);
    EXPECT_EQ(code_of(png_head(1000, 64)), "image.cut-off");
    EXPECT_EQ(code_of(png_head(0, 64)), "image.broken");
    EXPECT_TRUE(check_image_size(8000, 8000).empty());
    EXPECT_EQ(check_image_size(8000, 0)[0].code, "image.no-pixels");

    std::string jpeg = jpeg_of(8, 8, JCS_GRAYSCALE, 1, std::string(64, 'a'));
    const std::size_t frame = jpeg.find("\xFF\xC0");
    ASSERT_NE(frame, std::string::npos);
    for (const std::size_t i : {5U, 7U}) jpeg[frame + i] = '\x7F';  // 32,520 a side
    EXPECT_EQ(code_of(jpeg), "image.too-large");
}

TEST(ImageRead, DamagedFilesNeverCrash) {
    std::string greys, colours;
    CaseRandom pixels(3);
    for (int i = 0; i < 24 * 24; ++i) greys += static_cast<char>(pixels.below(256));
    for (int i = 0; i < 24 * 24 * 3; ++i) colours += static_cast<char>(pixels.below(256));
    std::vector<std::string> rows;
    for (std::size_t y = 0; y < 24; ++y) rows.push_back(colours.substr(y * 24 * 3, 24 * 3));
    const std::vector<std::string> valid = {
        png_of(24, 24, {PNG_COLOR_TYPE_RGB, 8}, rows),
        png_of(24, 24, {PNG_COLOR_TYPE_RGB, 8, PNG_INTERLACE_ADAM7}, rows),
        png_of(24, 24, {PNG_COLOR_TYPE_PALETTE, 8}, rows, std::vector<png_color>(256), {1, 2, 3}),
        jpeg_of(24, 24, JCS_GRAYSCALE, 1, greys),
        jpeg_of(24, 24, JCS_RGB, 3, colours),
        jpeg_of(24, 24, JCS_RGB, 3, colours, true),
        jpeg_of(24, 18, JCS_CMYK, 4, colours),
    };
    std::uint64_t read_anyway = 0;
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed);
        std::string bytes = valid[random.index(valid.size())];
        if (random.coin()) bytes.resize(random.index(bytes.size()));
        const std::uint32_t flips = random.below(4);
        for (std::uint32_t i = 0; i < flips && !bytes.empty(); ++i) {
            bytes[random.index(bytes.size())] = static_cast<char>(random.below(256));
        }
        const Result<GreyImage> image = read_image(bytes);
        const Result<ColourImage> colour = read_colour_image(bytes);
        ASSERT_EQ(image.operator bool(), colour.operator bool());
        if (!image) {
            ASSERT_FALSE(image.diagnostics().empty());
            continue;
        }
        ++read_anyway;
        ASSERT_EQ(image->darkness.size(), std::size_t{image->width} * image->height);
        ASSERT_EQ(colour->pixels.size(), image->darkness.size());
        for (const float value : image->darkness) ASSERT_TRUE(value >= 0 && value <= 1);
    }
    EXPECT_LT(read_anyway, case_count());
}

}  // namespace
}  // namespace filigree
