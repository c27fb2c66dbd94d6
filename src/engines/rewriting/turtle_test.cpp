#include "engines/rewriting/turtle.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "base/number_text.h"
#include "engines/rewriting/turtle_cases.h"

namespace filigree::rewriting {
namespace {

TEST(Turtle, FormulasKnowWhereTheyStand) {
    TurtleWord of = turtle_word("aP?[=?a[T?");
    of.word.ages = {1, 2, 3, 4, 5, 6, 7, 8, 9};
    std::vector<AngleFacts> asked;
    TurtleSettings settings;
    settings.formula = [&](const AngleFacts& facts) {
        asked.push_back(facts);
        return 90.0;
    };
    ASSERT_TRUE(turtle_drawing(of.word, of.alphabet, settings));
    ASSERT_EQ(asked.size(), 3U);
    EXPECT_EQ(asked[1].k, 1U);
    EXPECT_EQ(asked[0].depth, 0U);
    EXPECT_EQ(asked[2].depth, 2U);
    EXPECT_EQ(asked[0].age, 3U);
    EXPECT_EQ(asked[1].age, 5U);
    EXPECT_EQ(asked[2].age, 9U);
    expect_near({asked[2].x, asked[2].y, asked[2].z}, {1 + -1, 0, 0});  // twice pitched by 90
    settings.formula = [](const AngleFacts& facts) { return 1 / (1 - static_cast<double>(facts.k)); };
    const Result<TurtleDrawing> refused = turtle_drawing(of.word, of.alphabet, settings);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.diagnostics()[0].code, "rewriting.angle-not-finite");
    EXPECT_NE(refused.diagnostics()[0].message.find("number 2"), std::string::npos);
}

TEST(Turtle, TurnsAreClockwiseAgainstTheirAxis) {
    TurtleSettings settings;
    settings.angle = 90;
    settings.angle2 = 180;
    EXPECT_EQ(drawn("+a", settings).end, (Vec3{0, -1, 0}));
    EXPECT_EQ(drawn("T-a", settings).end, (Vec3{0, 1, 0}));
    EXPECT_EQ(drawn("P+a", settings).end, (Vec3{0, 0, 1}));
    EXPECT_EQ(drawn("P-a", settings).end, (Vec3{0, 0, -1}));
    EXPECT_EQ(drawn("D+P+a", settings).end, (Vec3{0, 1, 0})) << "rolled to the left, up is what was left";
    EXPECT_EQ(drawn("<a", settings).end, (Vec3{-1, 0, 0}));
    EXPECT_EQ(drawn(">-a", settings).end, (Vec3{0, -1, 0}));
    settings.plus = PlusTurn::counterclockwise;
    EXPECT_EQ(drawn("+a", settings).end, (Vec3{0, 1, 0}));
}

TEST(Turtle, HeadingsAreTheWorlds) {
    EXPECT_EQ(drawn("T+P-D+Xa").end, (Vec3{1, 0, 0}));
    EXPECT_EQ(drawn("T+P-D+Ya").end, (Vec3{0, 1, 0}));
    EXPECT_EQ(drawn("T+P-D+Za").end, (Vec3{0, 0, 1}));
    EXPECT_EQ(drawn("T+P-D+Z").end_frame.up, (Vec3{-1, 0, 0}));
    TurtleSettings settings;
    settings.angle = 90;
    EXPECT_EQ(drawn("YT+a", settings).end, (Vec3{1, 0, 0})) << "Fig. 7: YT+ turns in the wall";
    EXPECT_EQ(drawn("PX+a", settings).end, (Vec3{0, 0, 1})) << "a heading selects nothing";
}

TEST(Turtle, ShrinksToTheEndOfTheBranch) {
    const TurtleDrawing drawing = drawn("a[~(0.5)a~(0.5)=a]a~(2)f~(0)a~a");
    EXPECT_EQ(drawing.segments[1].to, (Vec3{1.5, 0, 0}));
    EXPECT_EQ(drawing.segments[2].to, (Vec3{1.75, 0, 0}));
    EXPECT_EQ(drawing.segments[3].to, (Vec3{2, 0, 0}));
    EXPECT_EQ(drawing.end, (Vec3{8, 0, 0})) << "what is no shrink does nothing";
    TurtleSettings settings;
    settings.letters = {{U'(', Act::line}, {U'0', Act::line}};
    EXPECT_EQ(drawn("~(0.5)a", settings).segments.size(), 1U) << "inside a shrink nothing acts";
    EXPECT_EQ(drawn("(0)a", settings).segments.size(), 3U);
}

TEST(Turtle, LettersDoWhatTheSettingsSay) {
    TurtleSettings settings;
    settings.letters = signs_for_everything();
    settings.angle = 90;
    const TurtleDrawing drawing = drawn("~(2)o#+,u!;;aG(5", settings);
    ASSERT_EQ(drawing.shapes.size(), 2U);
    EXPECT_EQ(drawing.shape_names.size(), 2U);
    EXPECT_EQ(drawing.shape_names[drawing.shapes[0].name], "leaf");
    EXPECT_EQ(drawing.shape_names[drawing.shapes[1].name], "cone");
    EXPECT_EQ(drawing.shapes[0].position, (Vec3{0, 0, 0}));
    EXPECT_EQ(drawing.shapes[1].position, (Vec3{2, 0, 0}));
    EXPECT_EQ(drawing.shapes[1].frame.heading, (Vec3{0, -1, 0}));
    EXPECT_EQ(drawing.shapes[1].scale, 2);
    EXPECT_EQ(drawing.shapes[1].width, 1.25);
    EXPECT_EQ(drawing.shapes[1].colour, 1);
    EXPECT_EQ(drawing.shapes[1].symbol, 8U);
    ASSERT_EQ(drawing.segments.size(), 1U);
    EXPECT_EQ(drawing.segments[0].width, 1) << "wider and narrower again";
    EXPECT_EQ(drawing.segments[0].colour, -1);
    EXPECT_EQ(drawing.segments[0].symbol, 12U);
}

TEST(Turtle, InvertersAndUpperCaseDrawNothing) {
    TurtleWord of = turtle_word("qqqQABñ=字");
    of.word.symbols.push_back(*of.alphabet.number_of({U'i', Role::inverter, 0}));
    EXPECT_EQ(turtle_drawing(of.word, of.alphabet, {})->segments.size(), 5U);
}

TEST(Turtle, CollectsPolygons) {
    TurtleSettings settings;
    settings.letters = signs_for_everything();
    settings.angle = 90;
    const TurtleDrawing square = drawn("f,{.+f+F+a}}a", settings);
    ASSERT_EQ(square.polygons.size(), 1U);
    EXPECT_EQ(square.corners, (std::vector<Vec3>{{1, 0, 0}, {2, 0, 0}, {2, -1, 0}, {1, -1, 0}}));
    EXPECT_EQ(square.polygons[0].count, 4U);
    EXPECT_EQ(square.polygons[0].symbol, 2U);
    EXPECT_EQ(square.polygons[0].colour, 1);
    EXPECT_EQ(square.stray_polygon_ends, 1U);
    EXPECT_EQ(square.segments.size(), 3U);
    const TurtleDrawing nested = drawn("{f[-{f+f+f}]+f+f{f}{ff+f", settings);
    ASSERT_EQ(nested.polygons.size(), 3U);
    EXPECT_EQ(nested.unclosed_polygons, 2U);
    EXPECT_EQ(nested.polygons[0].symbol, 4U) << "the inner one ends first";
    EXPECT_EQ(nested.polygons[0].count, 4U);
    EXPECT_EQ(nested.polygons[1].count, 4U);
    EXPECT_EQ(nested.polygons[2].symbol, 0U);
    EXPECT_EQ(nested.polygons[2].first, 8U);
    EXPECT_EQ(nested.polygons[2].count, 4U) << "steps inside another polygon are corners of that one";
    EXPECT_EQ(nested.corners.size(), 12U);
}

TEST(Turtle, TellsWherePositionsAre) {
    const TurtleWord of = turtle_word("ia=ia[+i~(2)a]ia");
    TurtleSettings settings;
    settings.letters = {{U'i', Act::nothing}};
    settings.angle = 90;
    const std::vector<Vec> positions = *symbol_positions(of.word, of.alphabet, settings);
    const std::vector<Vec> wanted = {{0, 0}, {0, 0}, {1, 0}, {1, 0}, {2, 0},  {2, 0}, {2, 0}, {2, 0},
                                     {2, 0}, {2, 0}, {2, 0}, {2, 0}, {2, -2}, {2, 0}, {2, 0}};
    EXPECT_EQ(positions, wanted);
}

TEST(Turtle, TellsLimitsAndWrongSettings) {
    const TurtleWord of = turtle_word("[[[[FF");
    EXPECT_TRUE(turtle_drawing(of.word, of.alphabet, {}, 4));
    const Result<TurtleDrawing> deep = turtle_drawing(of.word, of.alphabet, {}, 3);
    ASSERT_FALSE(deep);
    EXPECT_EQ(deep.diagnostics()[0].code, "limit.elements");
    const Result<TurtleDrawing> many = turtle_drawing(of.word, of.alphabet, {}, 1);
    ASSERT_FALSE(many);
    EXPECT_EQ(many.diagnostics()[0].fault, Fault::limit);
    EXPECT_NE(many.diagnostics()[0].message.find("2 segments"), std::string::npos);
    EXPECT_FALSE(symbol_positions(of.word, of.alphabet, {}, 5));
    EXPECT_TRUE(symbol_positions(of.word, of.alphabet, {}, 6));
    const auto code = [&](const TurtleSettings& settings) {
        const Result<TurtleDrawing> drawing = turtle_drawing(of.word, of.alphabet, settings);
        return drawing ? std::string() : drawing.diagnostics()[0].code;
    };
    EXPECT_EQ(code({}), "");
    EXPECT_EQ(code({.angle = NAN}), "rewriting.turtle-setting");
    EXPECT_EQ(code({.angle2 = INFINITY}), "rewriting.turtle-setting");
    EXPECT_EQ(code({.step = INFINITY}), "rewriting.turtle-setting");
    EXPECT_EQ(code({.width = -1}), "rewriting.turtle-setting");
    EXPECT_EQ(code({.width_ratio = 0}), "rewriting.turtle-setting");
    EXPECT_EQ(code({.angles = {1, NAN}}), "rewriting.turtle-setting");
    EXPECT_EQ(code({.step = 1e308}), "rewriting.turtle-out-of-range");
}

TEST(Turtle, CountsUnbalancedBrackets) {
    const TurtleDrawing drawing = drawn("]a]][a[a]");
    EXPECT_EQ(drawing.stray_closings, 3U);
    EXPECT_EQ(drawing.unclosed, 1U);
    EXPECT_EQ(drawing.segments.size(), 3U);
    EXPECT_EQ(drawing.end, (Vec3{2, 0, 0}));
}

// Bits that were computed once, and are to be so everywhere.
TEST(Turtle, HasTheSameBitsEverywhere) {
    std::string word = "F";
    for (int n = 0; n < 5; ++n) {
        std::string next;
        for (const char letter : word) next += letter == 'F' ? "F[P+FT>F]D<F[P-F]T+" : std::string(1, letter);
        word = next;
    }
    TurtleSettings settings;
    settings.angle = 22.5;
    settings.angle2 = 137.50776405003785;
    const TurtleDrawing drawing = drawn(word, settings);
    std::uint64_t hash = 0;
    const auto add = [&](double value) {
        hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x9E3779B97F4A7C15;
        hash ^= hash >> 29;
    };
    for (const TurtleSegment& s : drawing.segments) {
        for (const Vec3 v : {s.from, s.to, s.frame.heading, s.frame.left, s.frame.up}) {
            for (const double value : {v.x, v.y, v.z}) add(value);
        }
    }
    EXPECT_EQ(drawing.segments.size(), 3125U);
    EXPECT_EQ(to_hex(hash), "caf74bf8a8b19a5c");
}

}  // namespace
}  // namespace filigree::rewriting
