#include <gtest/gtest.h>

#include "base/test_cases.h"
#include "language/choice_path.h"
#include "language/parse.h"
#include "language/random_text.h"

namespace filigree {
namespace {

// In normal form, or the code of what is wrong with it.
std::string path(std::string_view text) {
    const Result<ChoicePath> result = parse_path(text);
    return result ? to_text(*result) : result.diagnostics().front().code;
}
// "begin..end message" of the error, and its hints.
std::string problem(std::string_view text) {
    const Result<ChoicePath> result = parse_path(text);
    if (result) return "none";
    const Diagnostic& found = result.diagnostics().front();
    std::string said = std::to_string(found.span.begin) + ".." + std::to_string(found.span.end) + " " + found.message;
    for (const std::string& hint : found.hints) said += " | " + hint;
    return said;
}

TEST(ParsePath, SegmentsOfEveryKind) {
    const Result<ChoicePath> result = parse_path("big_poly/outline#2/*/**/in[3,1]/2,5/place.distance~17", 4);
    ASSERT_TRUE(result);
    using Kind = PathSegment::Kind;
    const std::vector<PathSegment> expected = {{Kind::name, "big_poly", {}}, {Kind::name, "outline#2", {}},
                                               {Kind::any, "", {}},          {Kind::any_depth, "", {}},
                                               {Kind::name, "in", {1, 3}},   {Kind::shapes, "", {2, 5}},
                                               {Kind::name, "place", {}}};
    EXPECT_EQ(result->segments, expected);
    EXPECT_EQ(result->parameter, "distance");
    EXPECT_EQ(result->draw, 17U);
    EXPECT_EQ(result->span, (SourceSpan{4, 0, 53}));
}

TEST(ParsePath, TheFormsOfTheLanguage) {
    for (const std::string_view text : {"big_poly/outline/in/regular_split/quads[3]/outline.distance",
                                        "big_poly.rule",
                                        "body/2",
                                        "outline.distance~2",
                                        "window/sketch/two_lights/circle.circle_n",
                                        "window/sketch/**/circle.circle_n",
                                        "**/circle.circle_n",
                                        "window/sketch/**.point_up",
                                        "**.is_random",
                                        "let/gap",
                                        "let/gap~2",
                                        "gap~2",
                                        "spacing",
                                        "**",
                                        "*",
                                        "*/*/**",
                                        "0_medium_poly/2in/5deg",
                                        "_/__/a",
                                        "set/keep/to.when",
                                        "\xE8\x91\x89/p\xC3\xA9tale.\xE8\x91\x89",
                                        "a/4294967295",
                                        "quads[4294967295]",
                                        "let/outline.distance~2"}) {
        EXPECT_EQ(path(text), text);
    }
}

TEST(ParsePath, TheNormalForm) {
    EXPECT_EQ(path("a/**/**/**/b"), "a/**/b");
    EXPECT_EQ(path("**/**.x"), "**.x");
    EXPECT_EQ(path("**/*/**"), "**/*/**");
    EXPECT_EQ(path("a[3,1,3,2]/5,2,5"), "a[1,2,3]/2,5");
    EXPECT_EQ(path("a#1/b#02/c[007]/010.d~03"), "a/b#2/c[7]/10.d~3");
    EXPECT_EQ(path("pe\xCC\x81tale.e\xCC\x81"), "p\xC3\xA9tale.\xC3\xA9");
    EXPECT_EQ(path("  a/b\t# a note\n"), "a/b");
    EXPECT_EQ(path("\n a/b"), "a/b");
}

TEST(ParsePath, SamenessIsOfWhatIsSaid) {
    const auto same = [](std::string_view a, std::string_view b) {
        return same_path(*parse_path(a), *parse_path(b, 3));
    };
    EXPECT_TRUE(same("a[2,1]/**/**.x~2", "  a[1,2]/**.x~2"));
    for (const std::string_view other : {"b/**.x~2", "a/**.x~2", "a[1,2]/*.x~2", "a[1,2]/**.y~2", "a[1,2]/**.x~3",
                                         "a[1,2]/**.x", "a[1,2]/**", "a[1,2].x~2", "a#2[1,2]/**.x~2"}) {
        EXPECT_FALSE(same("a[1,2]/**.x~2", other)) << other;
    }
    EXPECT_FALSE(same("a/2", "a/2,3"));
}

TEST(ParsePath, WhatIsNoPath) {
    for (const std::string_view text : {"", " ", "# note", "=", "=3", ";", ",", "->", "[1]", "(a)", "\"a\"", "#2"}) {
        EXPECT_EQ(path(text), text == "#2" ? "language.comment-blank" : "language.missing-path") << text;
    }
    for (const std::string_view text :
         {"/",       "//",    "/a",         "a/",     "a//b",  "a/.x", ".x",     "***",   "a/***",  "a/**b",
          "a*",      "*a",    "*[1]",       "**#2",   "a/b-c", "a,b",  "a.b/c",  "a.b.c", "2",      "2/a",
          "2,5",     "a/b~2", "~2",         "a\"b\"", "a:b",   "a(b)", "a/2[1]", "a/2#2", "a[1]#2", "a[1-3]",
          "a[1..3]", "a.*",   "let/a[1]~2", "a.b[1]", "a /b",  "a/ b", "a .b",   "a [1]", "a{b}"}) {
        const std::string expected = text == "a{b}" ? "language.unexpected-token" : "language.bad-path";
        EXPECT_EQ(path(text), expected) << text;
    }
    for (const std::string_view text : {"a[0]",
                                        "a[]",
                                        "a[,1]",
                                        "a[1,]",
                                        "a[x]",
                                        "a[1x]",
                                        "a[4294967296]",
                                        "a#",
                                        "a#0",
                                        "a#x",
                                        "a#4294967296",
                                        "a.b~",
                                        "a.b~0",
                                        "a.b~x",
                                        "a/0",
                                        "a/2,",
                                        "a/2,x",
                                        "a/2,,3",
                                        "a/99999999999999999999999",
                                        "a[99999999999999999999999]"}) {
        const bool is_comma_end = text == "a/2,";
        EXPECT_EQ(path(text), is_comma_end ? "language.unexpected-token" : "language.bad-ordinal") << text;
    }
    for (const std::string_view text : {"a[", "a[1", "a[1,", "a[1, 3]", "a[1/b"}) {
        const bool goes_on = text == "a[1/b";
        EXPECT_EQ(path(text), goes_on ? "language.bad-path" : "language.unclosed-bracket") << text;
    }
    EXPECT_EQ(path("a."), "language.missing-name");
    EXPECT_EQ(path("a.2x"), "language.missing-name");
    EXPECT_EQ(path("a.b c"), "language.unexpected-token");
    EXPECT_EQ(path("a; b"), "language.unexpected-token");
    EXPECT_EQ(path("a, b"), "language.unexpected-token");
    EXPECT_EQ(path("a\nb"), "language.unexpected-token");
    EXPECT_EQ(path("a\\b"), "language.stray-character");
    EXPECT_EQ(path("a\xC2\xA0"), "language.stray-character");
    EXPECT_EQ(path("a/\xFF"), "language.not-utf8");
    EXPECT_EQ(path(std::string(1001, 'a')), "language.long-name");
    EXPECT_EQ(path(std::string(1001, 'a') + "\\"), "language.long-name");
    EXPECT_EQ(path("a." + std::string(1001, 'a')), "language.long-name");
    EXPECT_EQ(path(std::string(1000, 'a')), std::string(1000, 'a'));
}

TEST(ParsePath, ErrorsSayWhereAndWhatToDo) {
    EXPECT_EQ(problem("a//b"), "2..3 found nothing between '/' and '/' | any number of segments is written '**'");
    EXPECT_EQ(
        problem("a/b/"),
        "3..4 found nothing behind '/' | a path is written as in 'leaf/outline/in/place#2.size' or 'leaf/**.size'");
    EXPECT_EQ(problem("a/ b"),
              "1..2 found nothing behind '/' | a path is written as in "
              "'leaf/outline/in/place#2.size' or 'leaf/**.size' | a path has no blanks");
    EXPECT_EQ(problem("a / b"),
              "1..2 found a blank inside a path | a path has no blanks, as in 'leaf/outline.distance'");
    EXPECT_EQ(problem("a/.x"),
              "2..3 found nothing between '/' and '.' | a parameter of all steps is written '**.name'");
    EXPECT_EQ(problem(".x"), "0..1 found no path before '.' | a parameter of all steps is written '**.name'");
    EXPECT_EQ(problem("a.b~0"), "4..5 '0' is no number of a choice | choices are counted from 1 to 4294967295");
    EXPECT_EQ(problem("quads[0]"), "6..7 '0' is no number of a group | groups are counted from 1 to 4294967295");
    EXPECT_EQ(problem("quads[]"), "6..7 expected the number of a group, found ']'");
    EXPECT_EQ(problem("quads[1"), "5..6 this '[' is never closed | groups are numbered as in 'quads[1,3]'");
    EXPECT_EQ(problem("quads[1, 3]"),
              "5..6 this '[' is never closed | groups are numbered as in 'quads[1,3]' | a path has no blanks");
    EXPECT_EQ(problem("a/4294967296"),
              "2..12 '4294967296' is no number of a shape | shapes are counted from 1 to 4294967295");
    EXPECT_EQ(problem("***"), "0..3 '***' is no segment | '*' stands for one segment, '**' for any number of them");
    EXPECT_EQ(problem("a-b/c"), "1..2 found '-' inside a path | a tag has letters, digits and '_' only");
    EXPECT_EQ(problem("2,5"),
              "0..3 a path starts with a tag, and digits alone are numbers of shapes | "
              "a path is written as in 'leaf/outline/in/place#2.size' or 'leaf/**.size'");
    EXPECT_EQ(problem("a/b~2"),
              "3..4 found '~' inside a path | '~' counts the choices of a parameter, as in "
              "'outline.distance~2'");
    EXPECT_EQ(problem("\"a\""), "0..3 expected a path, found a text | a path is written without quotes");
    EXPECT_EQ(parse_path("a//", 7).diagnostics().front().span.file, 7U);
}

// --- properties --------------------------------------------------------------------------------------------------

TEST(ParsePathProperty, TheNormalFormIsReadBack) {
    const std::uint64_t cases = case_count();
    std::uint64_t with_everything = 0;
    for (std::uint64_t seed = 0; seed < cases; ++seed) {
        RandomText random(seed);
        const std::string text = random.path(true);
        const Result<ChoicePath> first = parse_path(text);
        ASSERT_TRUE(first) << "seed " << seed << " " << text;
        const std::string written = to_text(*first);
        const Result<ChoicePath> second = parse_path(written);
        ASSERT_TRUE(second) << "seed " << seed << " " << written;
        EXPECT_TRUE(same_path(*first, *second)) << "seed " << seed << " " << text;
        EXPECT_EQ(to_text(*second), written) << "seed " << seed;
        EXPECT_EQ(first->span, (SourceSpan{SourceSpan::no_file, 0, static_cast<std::uint32_t>(text.size())}));
        if (first->segments.size() > 2 && first->draw > 0) ++with_everything;
    }
    EXPECT_GT(with_everything, cases / 50);
}

TEST(ParsePathProperty, DamagedPathsAreSurvived) {
    const std::uint64_t cases = 10 * case_count();
    std::uint64_t wrong = 0;
    for (std::uint64_t seed = 0; seed < cases; ++seed) {
        RandomText random(seed);
        const std::string text = damaged(random.path(true), random);
        const Result<ChoicePath> result = parse_path(text);
        if (result) {
            const Result<ChoicePath> again = parse_path(to_text(*result));
            ASSERT_TRUE(again && same_path(*result, *again)) << "seed " << seed << " " << text;
            continue;
        }
        ++wrong;
        const Diagnostic& found = result.diagnostics().front();
        ASSERT_EQ(result.diagnostics().size(), 1U) << "seed " << seed << " " << text;
        ASSERT_LE(found.span.begin, found.span.end) << "seed " << seed << " " << text;
        ASSERT_LE(found.span.end, text.size()) << "seed " << seed << " " << text;
    }
    EXPECT_GT(wrong, cases / 10);
}

}  // namespace
}  // namespace filigree
