#include "formats/png_write.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "formats/png_test_reader.h"
#include "formats/test_drawings.h"

namespace filigree {
namespace {

DecodedPng drawn(const Drawing& drawing, double scale = 1) {
    const Result<std::string> png = to_png(drawing, {scale});
    EXPECT_TRUE(png) << (png ? "" : png.diagnostics()[0].message);
    return png ? decode_png(*png) : DecodedPng{};
}

constexpr std::uint32_t white_pixel = 0xFFFFFFFFU, black_pixel = 0xFF000000U, red_pixel = 0xFFFF0000U;

TEST(PngWrite, FillsWithHolesByTheEvenOddRule) {
    const Drawing drawing =
        drawing_of(polygons_of({rectangle_ring(2, 2, 6, 6), rectangle_ring(4, 4, 2, 2, true)}), filled(red), {10, 10});
    for (const int scale : {1, 3}) {
        const DecodedPng picture = drawn(drawing, scale);
        ASSERT_EQ(picture.width, 10 * scale);
        ASSERT_EQ(picture.height, 10 * scale);
        for (int y = 0; y < 10; ++y) {
            for (int x = 0; x < 10; ++x) {
                const bool is_in = x >= 2 && x < 8 && y >= 2 && y < 8;
                const bool is_hole = x >= 4 && x < 6 && y >= 4 && y < 6;
                ASSERT_EQ(picture.at(x * scale, y * scale), is_in && !is_hole ? red_pixel : white_pixel)
                    << x << " " << y;
            }
        }
    }
}

TEST(PngWrite, StrokesAreCentredAndJoinedAsSaid) {
    Drawing drawing = drawing_of(polygons_of({rectangle_ring(4, 4, 8, 8)}), stroked(black, 2), {16, 16});
    drawing.styles[0].corner = Corner::mitre;
    DecodedPng picture = drawn(drawing);
    EXPECT_EQ(picture.at(8, 3), black_pixel);
    EXPECT_EQ(picture.at(8, 4), black_pixel);
    EXPECT_EQ(picture.at(8, 2), white_pixel);
    EXPECT_EQ(picture.at(8, 5), white_pixel);
    EXPECT_EQ(picture.at(3, 3), black_pixel);  // the whole corner
    drawing.styles[0].corner = Corner::bevel;
    picture = drawn(drawing);
    EXPECT_GT(picture.at(3, 3) & 255, 96U);
    EXPECT_LT(picture.at(3, 3) & 255, 160U);
    drawing.styles[0].corner = Corner::round;
    picture = drawn(drawing);
    EXPECT_GT(picture.at(3, 3) & 255, 32U);
    EXPECT_LT(picture.at(3, 3) & 255, 80U);
}

TEST(PngWrite, LinesAreOpenAndNeverFilled) {
    Drawing drawing = line_drawing({{4, 4}, {12, 4}, {12, 12}, {4, 12}}, {red, black, 2, Corner::mitre}, {16, 16});
    DecodedPng picture = drawn(drawing);
    EXPECT_EQ(picture.at(8, 4), black_pixel);
    EXPECT_EQ(picture.at(12, 8), black_pixel);
    EXPECT_EQ(picture.at(4, 8), white_pixel);  // where it would close
    EXPECT_EQ(picture.at(8, 8), white_pixel);
    EXPECT_EQ(picture.at(3, 4), white_pixel);  // cut off square
    drawing.styles[0].corner = Corner::round;
    EXPECT_NE(drawn(drawing).at(3, 4), white_pixel);
}

TEST(PngWrite, LinesThatReachFarAreDrawnWhereTheyAreSeen) {
    const Drawing drawing =
        line_drawing({{-1e8, 8}, {1e8, 8}, {1e8, 1e8}, {8, 1e8}, {8, -1e8}}, {{}, black, 2, Corner::mitre}, {16, 16});
    const DecodedPng picture = drawn(drawing);
    for (int i = 0; i < 16; ++i) {
        EXPECT_EQ(picture.at(i, 8), black_pixel);
        EXPECT_EQ(picture.at(8, i), black_pixel);
    }
    EXPECT_EQ(picture.at(2, 2), white_pixel);
    EXPECT_EQ(picture.at(14, 14), white_pixel);
}

TEST(PngWrite, PaintsInOrderWithOverlaysOnTop) {
    Polygons geometry;
    for (int i = 0; i < 3; ++i) {
        geometry.add_ring(rectangle_ring(i, i, 4, 4));
        geometry.end_polygon();
    }
    Drawing drawing = drawing_of(geometry, filled(black), {8, 8});
    drawing.styles = {filled(black), filled(red), filled({0, 0, 255, 255})};
    for (std::uint32_t i = 0; i < 3; ++i) drawing.shapes[i].style = i;
    drawing.groups = {{"r", 1, 2, 0, 1, {1}}, {"r/s", 2, 3, 0, 0, {}}};  // red, then blue, then black on top
    const DecodedPng picture = drawn(drawing);
    EXPECT_EQ(picture.at(1, 1), black_pixel);
    EXPECT_EQ(picture.at(3, 3), black_pixel);
    EXPECT_EQ(picture.at(4, 4), 0xFF0000FFU);
    EXPECT_EQ(picture.at(4, 1), red_pixel);
}

TEST(PngWrite, Backgrounds) {
    Drawing drawing = drawing_of(polygons_of({rectangle_ring(0, 0, 1, 1)}), filled(black), {4, 4});
    drawing.canvas.background = Colour{10, 20, 30, 255};
    EXPECT_EQ(drawn(drawing).at(2, 2), 0xFF0A141EU);
    drawing.canvas.background = Colour{255, 0, 0, 0};
    DecodedPng picture = drawn(drawing);
    EXPECT_EQ(picture.at(2, 2), 0U);
    EXPECT_EQ(picture.at(0, 0), black_pixel);
    drawing.canvas.background = Colour{255, 0, 0, 128};
    EXPECT_EQ(drawn(drawing).at(2, 2), 0x80800000U);
}

TEST(PngWrite, TheCanvasMayLieAnywhere) {
    Drawing drawing = drawing_of(polygons_of({rectangle_ring(-1000, 500, 5, 5)}), filled(black), {10, 10});
    drawing.canvas.origin = {-1002, 497};
    const DecodedPng picture = drawn(drawing);
    EXPECT_EQ(picture.at(1, 3), white_pixel);
    EXPECT_EQ(picture.at(2, 3), black_pixel);
    EXPECT_EQ(picture.at(6, 7), black_pixel);
    EXPECT_EQ(picture.at(7, 8), white_pixel);
}

TEST(PngWrite, HugeShapesAreCutToThePicture) {
    Polygons geometry =
        polygons_of({rectangle_ring(-5e8, -5e8, 5e8 + 3, 1e9), rectangle_ring(-4e8, 5, 4e8 + 2, 2, true)});
    Drawing drawing = drawing_of(geometry, filled(black), {8, 8});
    drawing.styles[0].stroke = red;
    drawing.styles[0].pen = 1e-3;
    const DecodedPng picture = drawn(drawing, 4);
    const auto is_dark = [&](int x, int y) { return (picture.at(4 * x + 1, 4 * y + 1) & 255) < 40; };
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 8; ++x) EXPECT_EQ(is_dark(x, y), x < 3 && !(x < 2 && y >= 5 && y < 7)) << x << " " << y;
    }
}

TEST(PngWrite, OddStylesAndSizes) {
    Drawing drawing = drawing_of(polygons_of({rectangle_ring(2, 2, 6, 6)}), filled(black), {10.2, 10});
    EXPECT_EQ(drawn(drawing).width, 11);
    drawing.canvas.size = {10 + 1e-9, 10};
    EXPECT_EQ(drawn(drawing).width, 10);
    drawing.canvas.size = {0.01, 0.01};
    EXPECT_EQ(drawn(drawing).width, 1);
    drawing.canvas.size = {10, 10};
    for (const double pen : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
        drawing.styles[0] = {{}, black, pen, Corner::round};
        const DecodedPng picture = drawn(drawing);
        EXPECT_TRUE(std::all_of(picture.pixels.begin(), picture.pixels.end(), [](auto p) { return p == white_pixel; }));
    }
    drawing.styles[0] = {{}, black, 1e30, Corner::mitre};
    EXPECT_EQ(drawn(drawing).at(5, 5), black_pixel);
    EXPECT_EQ(drawn(Drawing{}).width, 1);
}

TEST(PngWrite, RefusesWhatIsTooLarge) {
    Drawing drawing = drawing_of(polygons_of({rectangle_ring(2, 2, 6, 6)}), filled(black), {100, 100});
    const auto code_of = [&](Vec size, double scale) {
        drawing.canvas.size = size;
        const Result<std::string> png = to_png(drawing, {scale});
        if (png) return std::string("ok");
        EXPECT_EQ(png.diagnostics()[0].fault, Fault::limit);
        return png.diagnostics()[0].code;
    };
    EXPECT_EQ(code_of({32'000, 1}, 1), "ok");
    EXPECT_EQ(code_of({32'001, 1}, 1), "png.too-large");
    EXPECT_EQ(code_of({20'001, 20'000}, 1), "png.too-large");
    EXPECT_EQ(code_of({100, 100}, 1e9), "png.too-large");
    for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
        EXPECT_EQ(code_of({bad, 10}, 1), "png.no-size");
        EXPECT_EQ(code_of({10, 10}, bad), "png.no-size");
    }
}

TEST(PngWrite, EndsWhereItIsCancelled) {
    const std::atomic<bool> is_cancelled = true;
    PngOptions options;
    options.job.cancel_flag = &is_cancelled;
    const Result<std::string> ended = to_png(many_blobs(3, 9, {50, 50}, filled(red)), options);
    ASSERT_FALSE(ended);
    EXPECT_EQ(ended.diagnostics()[0].code, "job.cancelled");
}

TEST(PngWrite, TheSamePictureGivesTheSameBytes) {
    for (const Style& style : {Style{white, black, 1, Corner::round}, filled(red)}) {
        const Drawing drawing = many_blobs(2000, 60, {500, 500}, style);
        const auto start = std::chrono::steady_clock::now();
        const Result<std::string> png = to_png(drawing, {2});
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        ASSERT_TRUE(png);
        std::printf("2,000 shapes of 60 points on 1000 x 1000 pixels: %.0f ms, %zu bytes\n", 1e3 * seconds,
                    png->size());
        EXPECT_TRUE(*png == *to_png(drawing, {2}));
    }
}

}  // namespace
}  // namespace filigree
