#include "language/lexer.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/test_cases.h"
#include "language/random_text.h"

namespace filigree {
namespace {

using Kind = TokenKind;

std::vector<Token> tokens(std::string_view text, LexMode mode = LexMode::value, bool lines_go_on = false) {
    std::vector<Token> result;
    for (std::uint32_t at = text_start(text);;) {
        const Token token = read_token(text, at, mode, lines_go_on);
        if (token.kind == Kind::end_of_text) return result;
        result.push_back(token);
        at = token.end;
    }
}
std::vector<std::string> words(std::string_view text, LexMode mode = LexMode::value, bool lines_go_on = false) {
    std::vector<std::string> result;
    for (const Token& token : tokens(text, mode, lines_go_on)) {
        result.emplace_back(text.substr(token.begin, token.end - token.begin));
    }
    return result;
}
using Words = std::vector<std::string>;

void expect_number(std::string_view text, double value, Unit unit) {
    const Token token = read_token(text, 0, LexMode::value, false);
    EXPECT_EQ(token.kind, Kind::number) << text;
    EXPECT_EQ(token.end, text.size()) << text;
    EXPECT_EQ(token.number, value) << text;
    EXPECT_EQ(token.unit, unit) << text;
}
Trouble trouble_of(std::string_view text) { return read_token(text, 0, LexMode::value, false).trouble; }

TEST(Lexer, NumbersWithUnitsAndExponents) {
    expect_number("12", 12, Unit::none);
    expect_number("3.5mm", 3.5, Unit::mm);
    expect_number("1.2m", 1.2, Unit::m);
    expect_number("2in", 2, Unit::inch);
    expect_number("30deg", 30, Unit::deg);
    expect_number("0.25turn", 0.25, Unit::turn);
    expect_number("40%", 40, Unit::percent);
    expect_number("4GB", 4, Unit::gigabyte);
    expect_number("1e-3", 1e-3, Unit::none);
    expect_number("1E+2px", 100, Unit::px);
    expect_number("3s", 3, Unit::second);
    expect_number("5.", 5, Unit::none);
    expect_number("5.mm", 5, Unit::mm);
    expect_number(".5", 0.5, Unit::none);
    expect_number("5.e2", 500, Unit::none);
    expect_number("007", 7, Unit::none);
    expect_number("1e-999", 0, Unit::none);
}

TEST(Lexer, NumbersThatAreNone) {
    for (const std::string_view text :
         {"0_medium_poly", "5x", "5mmm", "5e", "5em", "1e5x", "2in_", "100x200", "5\xC3\xA9"}) {
        EXPECT_EQ(trouble_of(text), Trouble::bad_unit) << text;
        EXPECT_EQ(words(text), Words{std::string(text)}) << text;
    }
    EXPECT_EQ(trouble_of("1e309"), Trouble::too_large);
    EXPECT_EQ(trouble_of("1e309mm"), Trouble::too_large);
    EXPECT_EQ(trouble_of(std::string(400, '9')), Trouble::too_large);
}

TEST(Lexer, RangesTakeTheirPointsFirst) {
    EXPECT_EQ(words("25..60"), (Words{"25", "..", "60"}));
    EXPECT_EQ(words("1.5..2.5"), (Words{"1.5", "..", "2.5"}));
    EXPECT_EQ(words("-3..3"), (Words{"-", "3", "..", "3"}));
    EXPECT_EQ(words(".5...75"), (Words{".5", "..", ".75"}));
    EXPECT_EQ(words("a..b.c"), (Words{"a", "..", "b", ".", "c"}));
}

TEST(Lexer, PercentIsAUnitOnlyBeforeNothingOfAWord) {
    EXPECT_EQ(words("40%)"), (Words{"40%", ")"}));
    EXPECT_EQ(words("5%2"), (Words{"5", "%", "2"}));
    EXPECT_EQ(words("5%a"), (Words{"5", "%", "a"}));
    EXPECT_EQ(trouble_of("%"), Trouble::foreign_sign);
}

TEST(Lexer, TagsAreRunsOfLettersDigitsAndUnderscores) {
    EXPECT_EQ(words("0_medium_poly,2in->5deg 1e5:<_>", LexMode::tag),
              (Words{"0_medium_poly", ",", "2in", "->", "5deg", "1e5", ":", "<", "_", ">"}));
    EXPECT_EQ(words("\xE8\x91\x89\xE2\x86\x92p\x65\xCC\x81", LexMode::tag),
              (Words{"\xE8\x91\x89", "\xE2\x86\x92", "p\x65\xCC\x81"}));
    EXPECT_EQ(words("stroke-width:stroke-2 a--b", LexMode::property),
              (Words{"stroke-width", ":", "stroke", "-", "2", "a", "-", "-", "b"}));
}

TEST(Lexer, PathsAreWhatStandsTogether) {
    EXPECT_EQ(words("big/outline#2/quads[1,3].x~2=5..9", LexMode::path),
              (Words{"big/outline#2/quads[1,3].x~2", "=", "5..9"}));
    EXPECT_EQ(words("a/2,5, b,\tc,\n**;d{e}f ,g", LexMode::path),
              (Words{"a/2,5", ",", "b", ",", "c", ",", "\n", "**", ";", "d", "{", "e", "}", "f", ",", "g"}));
    EXPECT_EQ(words("a->b\xE2\x86\x92_ a-b\r\n# note\n/x # note", LexMode::path),
              (Words{"a", "->", "b", "\xE2\x86\x92", "_", "a-b", "\n", "\n", "/x"}));
    EXPECT_EQ(words("\"a b\" [1] a\"b,,", LexMode::path), (Words{"\"a b\"", "[", "1]", "a\"b,", ","}));
    EXPECT_EQ(tokens("#2 a", LexMode::path).at(0).trouble, Trouble::hash);
    EXPECT_EQ(tokens("a", LexMode::path).at(0).kind, Kind::path);
}

TEST(Lexer, SignsAreTakenAsLongAsTheyGo) {
    EXPECT_EQ(words("a->b-->c>=d<=e==f!=g&&h||i&j!k<-l"),
              (Words{"a", "->", "b", "-",  "->", "c", ">=", "d", "<=", "e", "==", "f", "!=",
                     "g", "&&", "h", "||", "i",  "&", "j",  "!", "k",  "<", "-",  "l"}));
}

TEST(Lexer, CommentsNeedBlanksOnBothSides) {
    EXPECT_EQ(words("# a note\na # b\nc #\n#"), (Words{"\n", "a", "\n", "c", "\n"}));
    EXPECT_EQ(words("## Head\n  ####\n##x"), (Words{"\n", "\n"}));
    EXPECT_EQ(words("#\r\n#\t\r\n"), (Words{"\n", "\n"}));
    EXPECT_EQ(words("\xEF\xBB\xBF# a\nb"), (Words{"\n", "b"}));
    EXPECT_EQ(trouble_of("#note"), Trouble::hash);
    EXPECT_EQ(tokens("a# b").at(1).trouble, Trouble::hash);
    EXPECT_EQ(tokens("a ## b").at(1).trouble, Trouble::hash);
    EXPECT_EQ(words("[#a03, # one\n#000]", LexMode::value, true), (Words{"[", "#a03", ",", "#000", "]"}));
}

TEST(Lexer, ColoursHaveThreeFourSixOrEightDigits) {
    for (const std::string_view text : {"#a03", "#A03f", "#1a1a1a", "#00000080"}) {
        EXPECT_EQ(read_token(text, 0, LexMode::value, false).kind, Kind::colour) << text;
    }
    for (const std::string_view text : {"#a0", "#a0312", "#a031234", "#a03123456", "#xyz", "#a0_"}) {
        EXPECT_EQ(trouble_of(text), Trouble::hash) << text;
    }
}

TEST(Lexer, TextsEndOnTheirLine) {
    EXPECT_EQ(words("\"a \\\" # b\"c"), (Words{"\"a \\\" # b\"", "c"}));
    EXPECT_EQ(words("\"a\\\\\"b"), (Words{"\"a\\\\\"", "b"}));
    EXPECT_EQ(trouble_of("\"a"), Trouble::unterminated_text);
    EXPECT_EQ(words("\"a\r\nb"), (Words{"\"a", "\n", "b"}));
    EXPECT_EQ(words("\"a\\\nb"), (Words{"\"a\\", "\n", "b"}));
}

TEST(Lexer, KnowsTheFirstTokenOfALine) {
    const std::vector<Token> found = tokens("a b\n  c\n# d\n\te", LexMode::value, true);
    ASSERT_EQ(found.size(), 4U);
    EXPECT_TRUE(found[0].starts_line);
    EXPECT_FALSE(found[1].starts_line);
    EXPECT_TRUE(found[2].starts_line);
    EXPECT_TRUE(found[3].starts_line);
}

// Tokens cover the text: what lies between them is blank or comment, in every mode and for any bytes.
TEST(Lexer, AlwaysGoesForwards) {
    const std::uint64_t cases = case_count();
    for (std::uint64_t seed = 0; seed < cases; ++seed) {
        RandomText random(seed);
        const std::string text = damaged(random.document().text, random);
        for (const LexMode mode : {LexMode::value, LexMode::tag, LexMode::property, LexMode::path}) {
            std::uint32_t last = 0;
            for (const Token& token : tokens(text, mode, random.chance(2))) {
                ASSERT_GE(token.begin, last) << "seed " << seed;
                ASSERT_GT(token.end, token.begin) << "seed " << seed;
                ASSERT_LE(token.end, text.size()) << "seed " << seed;
                ASSERT_EQ(token.kind == Kind::invalid, token.trouble != Trouble::none) << "seed " << seed;
                last = token.end;
            }
        }
    }
}

}  // namespace
}  // namespace filigree
