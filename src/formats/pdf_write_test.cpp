#include "formats/pdf_write.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>

#include "base/thread_pool.h"
#include "formats/pdf_test_reader.h"
#include "formats/test_drawings.h"

namespace filigree {
namespace {

std::string names(const std::vector<PdfOperator>& operators) {
    std::string text;
    for (const PdfOperator& o : operators) text += (text.empty() ? "" : " ") + o.name;
    return text;
}

std::vector<PdfOperator> painted(const Drawing& drawing, const PdfOptions& options = {}) {
    return pdf_operators(read_test_pdf(to_pdf(drawing, options)).content());
}

TEST(PdfWrite, OnePageAsLargeAsTheCanvas) {
    Drawing drawing = drawing_of(polygons_of({rectangle_ring(1, 2, 3, 4)}), filled(red), {96, 192});
    drawing.canvas.origin = {-8, 4};
    const TestPdf pdf = read_test_pdf(to_pdf(drawing, {}));
    EXPECT_EQ(TestPdf::value(pdf.page(), "/MediaBox"), "[0 0 72 144]");
    const std::vector<PdfOperator> operators = pdf_operators(pdf.content());
    EXPECT_EQ(names(operators), "q cm M gs rg m l l l f* Q");
    EXPECT_EQ(operators[4].operands, (std::vector<std::string>{"1", "0", "0"}));
    // Where the points come to lie on the page, upwards.
    const PdfOperator& cm = operators[1];
    const auto on_page = [&](const PdfOperator& at) {
        EXPECT_EQ(cm.number(1), 0);
        EXPECT_EQ(cm.number(2), 0);
        return Vec{cm.number(0) * at.number(0) + cm.number(4), cm.number(3) * at.number(1) + cm.number(5)};
    };
    const std::vector<Vec> expected = {{1, 2}, {4, 2}, {4, 6}, {1, 6}};
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec at = on_page(operators[5 + i]);
        EXPECT_NEAR(at.x, 0.75 * (expected[i].x + 8), 1e-9);
        EXPECT_NEAR(at.y, 144 - 0.75 * (expected[i].y - 4), 1e-9);
    }
}

TEST(PdfWrite, HugePagesHaveALargerUnit) {
    const TestPdf pdf =
        read_test_pdf(to_pdf(drawing_of(polygons_of({rectangle_ring(0, 0, 9, 9)}), filled(red), {40'000, 100}), {}));
    EXPECT_EQ(TestPdf::value(pdf.page(), "/UserUnit"), "3");
    EXPECT_EQ(TestPdf::value(pdf.page(), "/MediaBox"), "[0 0 10000 25]");
    EXPECT_EQ(pdf_operators(pdf.content())[1].operands[0], "0.00025");
}

TEST(PdfWrite, CoordinatesAreRoundedToWholeUnits) {
    Polygons geometry = polygons_of({{snap({0.1236, 0}), snap({5, 0.0004}), snap({-3.5555, 7})}});
    EXPECT_EQ(painted(drawing_of(geometry, filled(red), {9, 9}))[5].operands, (std::vector<std::string>{"124", "0"}));
    const std::vector<PdfOperator> coarse =
        painted(drawing_of(geometry, filled(red), {9, 9}), {1, nullptr, "", nullptr});
    EXPECT_EQ(coarse[5].operands, (std::vector<std::string>{"1", "0"}));
    EXPECT_EQ(coarse[7].operands, (std::vector<std::string>{"-36", "70"}));
    EXPECT_EQ(coarse[1].operands[0], "0.075");
    // A shape that reaches far costs digits, never the shape.
    geometry.add_ring(rectangle_ring(5e6, 0, 1e6, 1));
    geometry.end_polygon();
    const std::vector<PdfOperator> far = painted(drawing_of(geometry, filled(red), {9, 9}));
    EXPECT_EQ(far[9].operands, (std::vector<std::string>{"500000000", "0"}));
    EXPECT_EQ(far[1].operands[0], "0.0075");
}

TEST(PdfWrite, HolesStrokesAndJoins) {
    const Polygons geometry = polygons_of({rectangle_ring(0, 0, 9, 9), rectangle_ring(2, 2, 2, 2, true)});
    Drawing drawing = drawing_of(geometry, {red, black, 1.5, Corner::mitre}, {9, 9});
    const std::vector<PdfOperator> both = painted(drawing);
    EXPECT_EQ(names(both), "q cm M gs rg RG w j m l l l h m l l l h B* Q");
    EXPECT_EQ(both[6].operands[0], "1500");
    EXPECT_EQ(both[7].operands[0], "0");
    EXPECT_EQ(both[2].operands[0], "4");
    drawing.styles[0].fill.reset();
    drawing.styles[0].corner = Corner::bevel;
    const std::vector<PdfOperator> line = painted(drawing);
    EXPECT_EQ(names(line), "q cm M gs RG w j m l l l h m l l l h S Q");
    EXPECT_EQ(line[6].operands[0], "2");
    for (const double pen : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
        drawing.styles[0].pen = pen;
        EXPECT_EQ(names(painted(drawing)), "q cm M Q");
    }
    // A hole that rounds to nothing is left out.
    const Polygons tiny = polygons_of({rectangle_ring(0, 0, 9, 9), rectangle_ring(2, 2, 1e-5, 1e-5, true)});
    EXPECT_EQ(names(painted(drawing_of(tiny, filled(red), {9, 9}))), "q cm M gs rg m l l l f* Q");
}

TEST(PdfWrite, LinesAreOpenAndNeverFilled) {
    const Style style{red, black, 1.5, Corner::round};
    const std::vector<PdfOperator> line = painted(line_drawing({{1, 1}, {5, 1}, {5, 5}}, style, {9, 9}));
    EXPECT_EQ(names(line), "q cm M gs RG w J j m l l S Q");
    EXPECT_EQ(line[6].operands[0], "1");
}

TEST(PdfWrite, StateIsSharedAlongARun) {
    Polygons geometry;
    for (int i = 0; i < 4; ++i) {
        geometry.add_ring(rectangle_ring(2 * i, 0, 1, 1));
        geometry.end_polygon();
    }
    Drawing drawing = drawing_of(geometry, filled(red), {9, 9});
    drawing.styles = {filled(red), filled(black), filled({255, 0, 0, 128})};
    drawing.shapes[2].style = 1;
    drawing.shapes[3].style = 2;
    const TestPdf pdf = read_test_pdf(to_pdf(drawing, {}));
    const std::vector<PdfOperator> operators = pdf_operators(pdf.content());
    EXPECT_EQ(names(operators), "q cm M gs rg m l l l f* m l l l f* rg m l l l f* gs rg m l l l f* Q");
    const std::size_t translucent = 21;
    ASSERT_EQ(operators[translucent].name, "gs");
    EXPECT_NE(pdf.page().find(operators[translucent].operands[0] + " << /ca 0.502 /CA 1 >>"), std::string::npos)
        << pdf.page();
    EXPECT_NE(pdf.page().find("/Group << /S /Transparency"), std::string::npos);
}

TEST(PdfWrite, PaintsInOrderWithOverlaysOnTop) {
    Polygons geometry;
    for (int i = 0; i < 3; ++i) {
        geometry.add_ring(rectangle_ring(i, i, 4, 4));
        geometry.end_polygon();
    }
    Drawing drawing = drawing_of(geometry, filled(black), {8, 8});
    drawing.styles = {filled(black), filled(red), filled({0, 0, 255, 255})};
    for (std::uint32_t i = 0; i < 3; ++i) drawing.shapes[i].style = i;
    drawing.groups = {{"r", 1, 2, 0, 1, {1}}, {"r/s", 2, 3, 0, 0, {}}};  // red, then blue, then black on top
    std::vector<std::string> starts;
    for (const PdfOperator& o : painted(drawing)) {
        if (o.name == "m") starts.push_back(o.operands[0]);
    }
    EXPECT_EQ(starts, (std::vector<std::string>{"1000", "2000", "0"}));
}

TEST(PdfWrite, TranslucentStrokesLieOnTheirFill) {
    const Style style{red, Colour{0, 0, 0, 51}, 2, Corner::round};
    const TestPdf pdf = read_test_pdf(to_pdf(drawing_of(polygons_of({rectangle_ring(1, 1, 3, 3)}), style, {9, 9}), {}));
    EXPECT_EQ(names(pdf_operators(pdf.content())), "q cm M gs rg RG w j m l l l h f* m l l l h S Q");
    EXPECT_NE(pdf.page().find("<< /ca 1 /CA 0.2 >>"), std::string::npos) << pdf.page();
}

TEST(PdfWrite, BackgroundsAndEmptyDrawings) {
    Drawing drawing;
    drawing.canvas.size = {96, 48};
    EXPECT_EQ(names(painted(drawing)), "q cm M Q");
    drawing.canvas.background = Colour{0, 51, 255, 128};
    const TestPdf pdf = read_test_pdf(to_pdf(drawing, {}));
    const std::vector<PdfOperator> operators = pdf_operators(pdf.content());
    EXPECT_EQ(names(operators), "q gs rg re f cm M Q");
    EXPECT_EQ(operators[2].operands, (std::vector<std::string>{"0", "0.2", "1"}));
    EXPECT_EQ(operators[3].operands, (std::vector<std::string>{"0", "0", "72", "36"}));
    drawing.canvas.size = {std::nan(""), HUGE_VAL};
    EXPECT_EQ(TestPdf::value(read_test_pdf(to_pdf(drawing, {})).page(), "/MediaBox"), "[0 0 0 0]");
}

TEST(PdfWrite, TitleAndProducer) {
    PdfOptions options;
    const auto info = [&](const std::string& title) {
        options.title = title;
        const TestPdf pdf = read_test_pdf(to_pdf(Drawing{}, options));
        return pdf.object(TestPdf::value(pdf.trailer, "/Info"));
    };
    EXPECT_EQ(info(""), "<< /Producer (Filigree) >>");
    EXPECT_EQ(info("A (leaf\\"), "<< /Title (A \\(leaf\\\\) /Producer (Filigree) >>");
    EXPECT_EQ(info("\xC3\xA4\xF0\x9F\x8C\xBF"), "<< /Title <FEFF00E4D83CDF3F> /Producer (Filigree) >>");
}

TEST(PdfWrite, TheSameBytesOnAnyNumberOfThreadsAndFast) {
    for (const Style& style : {Style{white, black, 1, Corner::round}, filled(red)}) {
        const Drawing drawing = many_blobs(18'000, 60, {1000, 1000}, style);
        const auto start = std::chrono::steady_clock::now();
        const std::string pdf = to_pdf(drawing, {});
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        std::printf("18,000 shapes of 60 points: %.0f ms, %zu bytes\n", 1e3 * seconds, pdf.size());
        ThreadPool pool(3);
        PdfOptions options;
        options.executor = &pool;
        EXPECT_TRUE(pdf == to_pdf(drawing, options));
        const TestPdf read = read_test_pdf(pdf);
        std::size_t shapes = 0;
        for (const PdfOperator& o : pdf_operators(read.content())) shapes += o.name == "f*" || o.name == "B*" ? 1 : 0;
        EXPECT_EQ(shapes, 18'000U);
        EXPECT_GT(read.objects.size(), 20U);  // the page comes in pieces
    }
}

}  // namespace
}  // namespace filigree
