#include "formats/svg_write.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <pugixml.hpp>

#include "base/random.h"
#include "base/test_cases.h"
#include "formats/svg_read.h"
#include "formats/test_drawings.h"
#include "plane/clean.h"

namespace filigree {
namespace {

// A root with a rectangle in a group of its own, an empty group, and a group of two unlike shapes with an overlay.
Drawing small_drawing() {
    Drawing drawing;
    drawing.canvas.size = {100, 50};
    Polygons geometry;
    for (const auto& rings : std::vector<std::vector<std::vector<Point>>>{
             {rectangle_ring(0, 0, 10, 10)},
             {rectangle_ring(10, 0, 20, 10), rectangle_ring(12, 2, 4, 4, true)},
             {rectangle_ring(0, 10, 5, 5)},
             {rectangle_ring(1, 1, 1, 1)}}) {
        for (const std::vector<Point>& ring : rings) geometry.add_ring(ring);
        geometry.end_polygon();
    }
    drawing.geometry = {std::make_shared<const Polygons>(geometry)};
    drawing.styles = {filled(black), stroked(red, 0.5), {Colour{1, 2, 3, 128}, black, 2, Corner::mitre}};
    drawing.shapes = {{0, 0, 0, Key{0x1111111100000000U}},
                      {0, 1, 1, Key{0x2222222200000000U}},
                      {0, 2, 2, Key{0x1111111100000001U}},
                      {0, 3, 0, Key{0xabcdef0100000000U}}};
    drawing.groups = {{"leaf", 0, 0, 0, 0, {1, 2, 3}},
                      {"leaf/split", 0, 1, 0, 0, {}},
                      {"leaf/nothing", 1, 1, 0, 0, {}},
                      {"leaf/<a & \"b\">", 1, 3, 3, 4, {}}};
    return drawing;
}

TEST(SvgWrite, LinesAreOpenAndNeverFilled) {
    const Style style{red, black, 2, Corner::round};
    const std::string svg = to_svg(line_drawing({{1, 1}, {5, 1}, {5, 5}}, style, {9, 9}), {});
    EXPECT_NE(svg.find("fill=\"none\" stroke=\"#000000\""), std::string::npos) << svg;
    EXPECT_NE(svg.find("stroke-linecap=\"round\""), std::string::npos) << svg;
    EXPECT_NE(svg.find(" d=\"m1 1h4v4\"/>"), std::string::npos) << svg;
    // What is too short to be seen is still something that is drawn.
    const std::string dot = to_svg(line_drawing({{1, 1}, {1.00001, 1}}, style, {9, 9}), {});
    EXPECT_NE(dot.find(" d=\"m1 1h0\"/>"), std::string::npos) << dot;
    const Style square{{}, black, 2, Corner::mitre};
    EXPECT_EQ(to_svg(line_drawing({{1, 1}, {5, 1}}, square, {9, 9}), {}).find("linecap"), std::string::npos);
}

TEST(SvgWrite, WholeFile) {
    EXPECT_EQ(to_svg(small_drawing(), {}),
              "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
              "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100\" height=\"50\" viewBox=\"0 0 100 50\">\n"
              "<g fill-rule=\"evenodd\" data-path=\"leaf\">\n"
              "<g data-path=\"leaf/split\" fill=\"#000000\" stroke=\"none\">\n"
              "<path id=\"s11111111\" d=\"m0 0h10v10h-10z\"/>\n"
              "</g>\n"
              "<g data-path=\"leaf/&lt;a &amp; &quot;b&quot;&gt;\">\n"
              "<path id=\"s22222222\" fill=\"none\" stroke=\"#ff0000\" stroke-width=\"0.5\" stroke-linejoin=\"round\" "
              "d=\"m10 0h20v10h-20zm2 2v4h4v-4z\"/>\n"
              "<path id=\"s11111111-2\" fill=\"#010203\" stroke=\"#000000\" fill-opacity=\"0.502\" stroke-width=\"2\" "
              "d=\"m0 10h5v5h-5z\"/>\n"
              "<path id=\"sabcdef01\" fill=\"#000000\" stroke=\"none\" d=\"m1 1h1v1h-1z\"/>\n"
              "</g>\n"
              "</g>\n"
              "</svg>\n");
}

TEST(SvgWrite, LeanJoinsRunsOfOneStyle) {
    Drawing drawing = small_drawing();
    drawing.shapes[1].style = 0;
    SvgOptions options;
    options.lean = true;
    EXPECT_EQ(
        to_svg(drawing, options),
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100\" height=\"50\" viewBox=\"0 0 100 50\">\n"
        "<path fill=\"#000000\" stroke=\"none\" d=\"m0 0h10v10h-10zm10 0h20v10h-20zm2 2v4h4v-4z\"/>\n"
        "<path fill=\"#010203\" stroke=\"#000000\" fill-opacity=\"0.502\" stroke-width=\"2\" d=\"m0 10h5v5h-5z\"/>\n"
        "<path fill=\"#000000\" stroke=\"none\" d=\"m1 1h1v1h-1z\"/>\n"
        "</svg>\n");
}

TEST(SvgWrite, LeanNeverJoinsTranslucentShapes) {
    Drawing drawing = small_drawing();
    for (DrawnShape& shape : drawing.shapes) shape.style = 2;
    SvgOptions options;
    options.lean = true;
    const Result<SvgPicture> picture = read_svg(to_svg(drawing, options));
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->shapes.size(), 4U);
}

TEST(SvgWrite, NestedStylesAreSaidWhereTheyChange) {
    Drawing drawing = small_drawing();
    drawing.groups = {{"a", 0, 1, 0, 0, {1}}, {"b", 1, 2, 0, 0, {2}}, {"c", 2, 3, 0, 0, {}}};
    drawing.shapes[0].style = 2;  // translucent and stroked
    drawing.shapes[1].style = 2;
    drawing.shapes[2].style = 0;  // opaque again
    const std::string svg = to_svg(drawing, {});
    EXPECT_NE(svg.find("<g data-path=\"b\">\n"), std::string::npos) << svg;
    EXPECT_NE(svg.find("<g data-path=\"c\" fill=\"#000000\" stroke=\"none\" fill-opacity=\"1\">"), std::string::npos)
        << svg;
}

TEST(SvgWrite, SizesUnitsBackgroundAndTitle) {
    Drawing drawing = small_drawing();
    drawing.canvas = {{-10.5, 20}, {210 * 96 / 25.4, 297 * 96 / 25.4}, true, Colour{250, 240, 230, 255}};
    SvgOptions options;
    options.title = "a <leaf>\x01";
    const std::string svg = to_svg(drawing, options);
    EXPECT_NE(svg.find("width=\"210mm\" height=\"297mm\" viewBox=\"-10.5 20 793.7007874015749 "), std::string::npos)
        << svg;
    EXPECT_NE(svg.find("<title>a &lt;leaf&gt;\xEF\xBF\xBD</title>"), std::string::npos) << svg;
    EXPECT_NE(svg.find("<rect id=\"background\" x=\"-10.5\" y=\"20\" width=\"793.7"), std::string::npos) << svg;

    const Result<SvgPicture> picture = read_svg(svg);
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->origin, drawing.canvas.origin);
    EXPECT_NEAR(picture->size.x, drawing.canvas.size.x, 1e-9);
    EXPECT_EQ(picture->shapes[1].path.points[1], (Vec{10, 0}));  // px stay px
}

TEST(SvgWrite, AnEmptyDrawingIsAPicture) {
    const std::string svg = to_svg({}, {});
    const Result<SvgPicture> picture = read_svg(svg);
    ASSERT_TRUE(picture);
    EXPECT_TRUE(picture->shapes.empty());
}

TEST(SvgWrite, RandomDrawingsComeBackToRounding) {
    for (std::uint64_t seed = 0; seed < case_count(200); ++seed) {
        const auto pick = [&](const char* name, std::uint32_t count, std::uint64_t draw = 0) {
            return to_whole(random_bits(seed, Key{}, name, draw), count);
        };
        Drawing drawing;
        drawing.canvas = {{-50, 10}, {300, 200}, pick("mm", 2) == 1, {}};
        drawing.styles = {filled(black), stroked(red, 1), {white, black, 0.7, Corner::bevel}};
        Polygons geometry;
        const auto count = static_cast<std::uint32_t>(1 + pick("count", 12));
        for (std::uint32_t i = 0; i < count; ++i) {
            const Vec centre{to_unit(random_bits(seed, Key{i}, "x")) * 200,
                             to_unit(random_bits(seed, Key{i}, "y")) * 200};
            geometry.add_ring(blob_ring(centre, 10, 20, i));
            if (pick("hole", 2, i) == 1) geometry.add_ring(blob_ring(centre, 5, 9, i + 99, true));
            geometry.end_polygon();
            drawing.shapes.push_back({0, i, static_cast<std::uint32_t>(pick("style", 3, i)), child(Key{1}, i)});
        }
        const auto middle = static_cast<std::uint32_t>(pick("middle", count + 1));
        drawing.groups = {{"r", 0, middle, 0, 0, {1}}, {"r/s", middle, count, 0, 0, {}}};
        drawing.geometry = {std::make_shared<const Polygons>(geometry)};
        SvgOptions options;
        options.decimals = static_cast<int>(pick("decimals", 7));
        const Result<SvgPicture> picture = read_svg(to_svg(drawing, options));
        ASSERT_TRUE(picture) << "seed " << seed;
        ASSERT_EQ(picture->shapes.size(), count) << "seed " << seed;
        for (std::uint32_t i = 0; i < count; ++i) {
            const SvgShape& shape = picture->shapes[i];
            EXPECT_EQ(shape.fill_rule, FillRule::even_odd);
            EXPECT_EQ(shape.filled, drawing.shapes[i].style != 1);
            double unit = 1;
            for (int k = 0; k < options.decimals; ++k) unit /= 10;
            const double written = area(geometry[i]), read = area(clean(flatten(shape.path, 0.1), shape.fill_rule));
            ASSERT_NEAR(written, read, unit * 100) << "seed " << seed << " shape " << i;
        }
    }
}

TEST(SvgWrite, IsQuick) {
    const Drawing drawing = many_blobs(18'000, 60, {1000, 1000}, stroked(black, 1));
    const auto start = std::chrono::steady_clock::now();
    const std::string svg = to_svg(drawing, {});
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::printf("18,000 shapes of 60 points: %.1f ms, %.1f MB\n", 1e3 * seconds,
                1e-6 * static_cast<double>(svg.size()));
    EXPECT_EQ(svg, to_svg(drawing, {}));
    pugi::xml_document document;
    EXPECT_TRUE(document.load_string(svg.c_str()));
}

}  // namespace
}  // namespace filigree
