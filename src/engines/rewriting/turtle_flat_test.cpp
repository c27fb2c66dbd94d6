#include "engines/rewriting/turtle_flat.h"

#include <gtest/gtest.h>

#include <bit>

#include "engines/rewriting/turtle_cases.h"

namespace filigree::rewriting {
namespace {

bool are_same(Vec a, Vec3 b) {
    return std::bit_cast<std::uint64_t>(a.x) == std::bit_cast<std::uint64_t>(b.x) &&
           std::bit_cast<std::uint64_t>(a.y) == std::bit_cast<std::uint64_t>(b.y) && b.z == 0;
}

std::optional<FlatDrawing> flat(const TurtleWord& of, const TurtleSettings& settings, FlatDrawing reuse = {}) {
    auto drawing = flat_drawing(of.word.symbols, of.alphabet, settings, Limits{}.elements, std::move(reuse));
    EXPECT_TRUE(drawing);
    return *std::move(drawing);
}

// Segment by segment, bit by bit.
void expect_same(const FlatDrawing& flat, const TurtleDrawing& general) {
    ASSERT_EQ(flat.segments, general.segments.size());
    std::size_t segment = 0;
    std::uint64_t points = 0;
    for (const FlatRun& run : flat.runs) {
        ASSERT_EQ(run.first, points);
        ASSERT_GE(run.count, 2U);
        points += run.count;
        ASSERT_LE(points, flat.points().size());
        for (std::uint64_t i = run.first; i + 1 < points; ++i, ++segment) {
            ASSERT_LT(segment, general.segments.size());
            const TurtleSegment& wanted = general.segments[segment];
            ASSERT_TRUE(are_same(flat.points()[i], wanted.from)) << "segment " << segment;
            ASSERT_TRUE(are_same(flat.points()[i + 1], wanted.to)) << "segment " << segment;
            ASSERT_EQ(run.width, wanted.width);
            ASSERT_EQ(run.colour, wanted.colour);
        }
    }
    EXPECT_EQ(segment, general.segments.size());
    EXPECT_EQ(points, flat.points().size());
    EXPECT_TRUE(are_same(flat.end, general.end));
    EXPECT_EQ(flat.stray_closings, general.stray_closings);
    EXPECT_EQ(flat.unclosed, general.unclosed);
}

TEST(TurtleFlat, IsTheGeneralTurtle) {
    std::uint64_t drawn = 0;
    for (std::uint64_t i = first_seed(); i < first_seed() + case_count(); ++i) {
        SCOPED_TRACE(i);
        CaseRandom random(i);
        const TurtleSettings settings = random_turtle_settings(random);
        const std::u32string letters = random_letters(random, U"FFFFFFfabn=++++----<>TXYQ[[]]#!,;e", 300);
        const bool has_gaits = random.below(4) == 0;
        const TurtleWord of = has_gaits ? turtle_word(letters, random_gaits(random, letters.size(), random.coin()))
                                        : turtle_word(letters);
        const std::optional<FlatDrawing> fast = flat(of, settings);
        if (!fast) continue;
        ++drawn;
        const Result<TurtleDrawing> general = turtle_drawing(of.word, of.alphabet, settings);
        ASSERT_TRUE(general);
        expect_same(*fast, *general);
    }
    EXPECT_GT(drawn, case_count() / 4);
}

TEST(TurtleFlat, LongLinesAndManyDirections) {
    TurtleSettings settings;
    settings.angle = 25.7;
    settings.angle2 = 0.1;
    settings.letters = signs_for_everything();
    CaseRandom random(5);
    std::u32string letters;
    for (int i = 0; i < 30; ++i) letters += random_letters(random, U"FFF+-<><", 9000) + U"f[" + U"]";
    const TurtleWord of = turtle_word(letters);
    const std::optional<FlatDrawing> fast = flat(of, settings);
    ASSERT_TRUE(fast);
    ASSERT_GT(fast->segments, 20000U);
    expect_same(*fast, *turtle_drawing(of.word, of.alphabet, settings));
}

TEST(TurtleFlat, MemoryIsTakenAgain) {
    TurtleSettings settings;
    std::optional<FlatDrawing> before = flat(turtle_word("FF+F[FF]fF+F+F+F"), settings);
    ASSERT_TRUE(before);
    const void* const memory = before->memory.data();
    const TurtleWord of = turtle_word("F+F[F]fF");
    const std::optional<FlatDrawing> after = flat(of, settings, *std::move(before));
    ASSERT_TRUE(after);
    EXPECT_EQ(after->memory.data(), memory);
    expect_same(*after, *turtle_drawing(of.word, of.alphabet, settings));
}

TEST(TurtleFlat, LinesGoOnWhereTheTurtleStands) {
    const TurtleSettings settings;
    EXPECT_EQ(flat(turtle_word("F[+]F"), settings)->runs.size(), 1U);
    EXPECT_EQ(flat(turtle_word("F[+F]F"), settings)->runs.size(), 2U);
    EXPECT_EQ(flat(turtle_word("FFfFF"), settings)->runs.size(), 2U);
    EXPECT_EQ(flat(turtle_word("ff[+]f"), settings)->runs.size(), 0U);
    EXPECT_EQ(flat(turtle_word(""), settings)->points().size(), 0U);
}

TEST(TurtleFlat, LeavesTheRestToTheGeneralTurtle) {
    TurtleSettings settings;
    settings.letters = signs_for_everything();
    for (const char* word : {"aP+a", "aD+a", "aZa", "aT?a", "~(0.5)a", "a{aa}", "a.", "o"}) {
        EXPECT_FALSE(flat(turtle_word(word), settings)) << word;
    }
    EXPECT_TRUE(flat(turtle_word("aT+aXaYa[a]#,"), settings));
    settings.angle = 137.50776405003785;
    EXPECT_FALSE(flat(turtle_word("aT+a"), settings));
    settings.angle = 25.734;
    EXPECT_FALSE(flat(turtle_word("aT+a"), settings)) << "the table would be longer than the word";
    settings.angle = 30;
    settings.step = 1e299;
    EXPECT_FALSE(flat(turtle_word("aaaaaaaaaaaa"), settings));
}

TEST(TurtleFlat, TellsLimits) {
    const TurtleWord of = turtle_word("F+F+F");
    EXPECT_TRUE(flat_drawing(of.word.symbols, of.alphabet, {}, 3));
    const auto refused = flat_drawing(of.word.symbols, of.alphabet, {}, 2);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.diagnostics()[0].code, "limit.elements");
    EXPECT_EQ(refused.diagnostics()[0].fault, Fault::limit);
    TurtleSettings wide;
    wide.width_ratio = 1e200;
    wide.letters = signs_for_everything();
    const TurtleWord too_wide = turtle_word("F##F");
    const auto wrong = flat_drawing(too_wide.word.symbols, too_wide.alphabet, wide);
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.diagnostics()[0].code, "rewriting.turtle-out-of-range");
}

}  // namespace
}  // namespace filigree::rewriting
