// What the paper and other books show: figures, and the curves of tests/data/rewriting_vectors.json.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/elementary.h"
#include "engines/rewriting/turtle_cases.h"
#include "engines/rewriting/word_edits.h"

namespace filigree::rewriting {
namespace {

using nlohmann::json;

json vectors() {
    std::ifstream file(FILIGREE_SOURCE_DIR "/tests/data/rewriting_vectors.json");
    return json::parse(file);
}

TEST(TurtleFigures, DrawsPublishedCurves) {
    int rows = 0;
    for (const json& row : vectors()) {
        if (row["kind"] != "d0l" || !row.contains("turtle2d") || row["turtle2d"].is_null()) continue;
        SCOPED_TRACE(row["name"].get<std::string>());
        ++rows;
        std::string word = row["axiom"];
        for (int n = row["n"]; n > 0; --n) {
            std::string next;
            for (const char letter : word) next += row["rules"].value(std::string(1, letter), std::string(1, letter));
            word = next;
        }
        const TurtleWord of = turtle_word(word);
        TurtleSettings settings;
        settings.angle = row["angle"];
        settings.plus = PlusTurn::counterclockwise;
        settings.letters = {{U'X', Act::nothing}};
        const Result<TurtleDrawing> drawing = turtle_drawing(of.word, of.alphabet, settings);
        const Result<std::vector<Vec>> positions = symbol_positions(of.word, of.alphabet, settings);
        ASSERT_TRUE(drawing && positions);
        const json& wanted = row["turtle2d"];
        EXPECT_EQ(drawing->segments.size(), wanted["segs"]);
        EXPECT_NEAR(drawing->end.x, wanted["end"][0].get<double>(), 1e-3);
        EXPECT_NEAR(drawing->end.y, wanted["end"][1].get<double>(), 1e-3);
        Vec low{drawing->end.x, drawing->end.y}, high = low;
        for (const Vec p : *positions) {
            low = {std::min(low.x, p.x), std::min(low.y, p.y)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        }
        EXPECT_NEAR(low.x, wanted["bbox"][0].get<double>(), 1e-3);
        EXPECT_NEAR(low.y, wanted["bbox"][1].get<double>(), 1e-3);
        EXPECT_NEAR(high.x, wanted["bbox"][2].get<double>(), 1e-3);
        EXPECT_NEAR(high.y, wanted["bbox"][3].get<double>(), 1e-3);
    }
    EXPECT_EQ(rows, 11);
}

// Fig. 11.
TEST(TurtleFigures, TurnsByAFormula) {
    const std::vector<json> rows = vectors();
    const auto row =
        std::find_if(rows.begin(), rows.end(), [](const json& r) { return r.value("name", "") == "angle formula"; });
    ASSERT_NE(row, rows.end());
    TurtleSettings settings;
    settings.formula = [](const AngleFacts& facts) { return 30 * static_cast<double>(facts.k); };
    const TurtleDrawing drawing = drawn((*row)["axiom"].get<std::string>(), settings);
    EXPECT_NEAR(drawing.end.x, (*row)["end"][0].get<double>(), 1e-3);
    EXPECT_NEAR(drawing.end.y, (*row)["end"][1].get<double>(), 1e-3);
    TurtleSettings by_data;
    by_data.angles = {0, 30, 60};
    EXPECT_EQ(drawn("aT?aT?aT?a", by_data).end, drawing.end);
    by_data.plus = PlusTurn::counterclockwise;
    EXPECT_EQ(drawn("aT?aT?aT?a", by_data).end, (Vec3{drawing.end.x, -drawing.end.y, 0}));
    by_data.angles = {90};
    expect_near(drawn("?a?a?a?a", by_data).end, {0, 0, 0});
    EXPECT_EQ(drawn("aT?a").end, (Vec3{2, 0, 0})) << "neither formula nor data: no turn";
}

// The axis stays selected; '[' keeps it.
TEST(TurtleFigures, DrawsFigure9) {
    const TurtleDrawing drawing = drawn("D+a[P<a[T<a]]+a[P<a[T<aa]a[T<aa]]+a[P<a[T<aaa]a[T<aaa]a[T<aaa]]");
    ASSERT_EQ(drawing.segments.size(), 23U);
    const double c = std::sqrt(0.75);
    expect_near(drawing.segments[0].to, {1, 0, 0});
    expect_near(drawing.segments[1].to, {1 + c, 0.25, c / 2});
    expect_near(drawing.segments[2].to, {1 + c + 0.75, 0.25 - c / 4, c / 2 + 0.625});
    expect_near(drawing.segments[3].from, {1, 0, 0});
    expect_near(drawing.segments[3].to, {2, 0, 0});
    expect_near(drawing.segments[4].to, {2 + c, c / 2, 0.25});  // rolled by 60
    EXPECT_EQ(drawing.end, (Vec3{3, 0, 0}));
    expect_near(drawing.end_frame.up, {0, 1, 0});
}

std::string bred(std::string_view a, std::string_view b) {
    return to_utf8(*breed_carrying_headings(letters_of(a), letters_of(b)));
}

// A line and a line are stairs.
TEST(TurtleFigures, DrawsFigures19And20) {
    EXPECT_EQ(drawn("Xaaaa").end, (Vec3{4, 0, 0}));
    EXPECT_EQ(drawn("Yaaaa").end, (Vec3{0, 4, 0}));
    const TurtleDrawing stairs = drawn(bred("Xaaaa", "Yaaaa"));
    ASSERT_EQ(stairs.segments.size(), 8U);
    for (int i = 0; i < 8; ++i) {
        EXPECT_EQ(stairs.segments[static_cast<std::size_t>(i)].to, (Vec3{(i + 2) / 2 * 1.0, (i + 1) / 2 * 1.0, 0}));
    }
}

std::string spiral(int steps) {
    std::string word;
    for (int i = 0; i < steps; ++i) word += "aT-~(0.9)";
    return word;
}

TEST(TurtleFigures, DrawsFigure21) {
    const TurtleDrawing alone = drawn(spiral(40));
    ASSERT_EQ(alone.segments.size(), 40U);
    double x = 0, y = 0;
    for (int k = 0; k < 40; ++k) {
        x += std::pow(0.9, k) * std::cos(k * elementary::pi / 6);
        y += std::pow(0.9, k) * std::sin(k * elementary::pi / 6);
        expect_near(alone.segments[static_cast<std::size_t>(k)].to, {x, y, 0});
    }
    const TurtleDrawing hybrid = drawn(bred("XaYaXaYaXaYaXaYa", spiral(8)));
    ASSERT_EQ(hybrid.segments.size(), 16U);
    double shortest = 1;
    for (const TurtleSegment& s : hybrid.segments) {
        shortest = std::min(shortest, std::hypot(s.to.x - s.from.x, s.to.y - s.from.y));
    }
    EXPECT_NEAR(shortest, std::pow(0.9, 7), 1e-12) << "steps shrink as in the spiral";
}

// A plane is a line with branches.
TEST(TurtleFigures, DrawsFigure22) {
    const std::string plane = "X[Yaaa]a[Yaaa]a[Yaaa]";
    const TurtleDrawing alone = drawn(plane);
    ASSERT_EQ(alone.segments.size(), 11U);
    for (int column = 0; column < 3; ++column) {
        const Vec3 top{static_cast<double>(column), 3, 0};
        EXPECT_TRUE(std::any_of(alone.segments.begin(), alone.segments.end(),
                                [&](const TurtleSegment& s) { return s.to == top; }));
    }
    EXPECT_EQ(alone.end, (Vec3{2, 0, 0}));
    const TurtleDrawing hybrid = drawn(bred(plane, spiral(9)));
    EXPECT_EQ(hybrid.segments.size(), 20U);
    EXPECT_EQ(hybrid.unclosed + hybrid.stray_closings, 0U);
}

}  // namespace
}  // namespace filigree::rewriting
