#include <gtest/gtest.h>

#include "base/test_cases.h"
#include "language/parse.h"
#include "language/random_text.h"
#include "language/unparse.h"

namespace filigree {
namespace {

Parsed parsed(std::string_view text) { return parse_document("case.fil", text, nullptr); }

std::string meaning(std::string_view text) {
    const Parsed result = parsed(text);
    EXPECT_EQ(to_text(result.diagnostics, result.document.sources), "") << text;
    return unparse(result.document);
}
// "line:column code" of every error, then what could be understood.
std::string problems(std::string_view text) {
    const Parsed result = parsed(text);
    std::string said;
    for (const Diagnostic& found : result.diagnostics) {
        const LineColumn place = line_column(text, found.span.begin);
        said += std::to_string(place.line) + ":" + std::to_string(place.column) + " " + found.code + "\n";
    }
    return said + unparse(result.document);
}
std::string repeated(std::string_view text, std::size_t count) {
    std::string result;
    for (std::size_t i = 0; i < count; ++i) result += text;
    return result;
}

TEST(ParseBlock, Systems) {
    EXPECT_EQ(meaning("system dots { grammar tangle; start a = circle(5) }\n"
                      "system lace(size = 3mm, gap, way = one_of(a, b)) {  # a note\n  grammar tangle\n\n"
                      "  place(\n    size, gap) : host -> [a,\n  b]  # another\n  style a {\n fill: black\n }; keep a\n"
                      "}; let after = 1\nsystem empty() {}\n"),
              "system dots { grammar tangle; start a = circle(5); }\n"
              "system lace(size = 3mm, gap, way = one_of(a, b)) { grammar tangle; place(size, gap) : host -> a, b; "
              "style a { fill: black; }; keep a; }\nlet after = 1\nsystem empty { }\n");
    EXPECT_EQ(meaning("system a {f(1):b->c};system = f() : a"), "system a { f(1) : b -> c; }\nsystem = f() : a\n");
}

TEST(ParseBlock, Operators) {
    EXPECT_EQ(meaning("operator lace(size = 3, spacing) -> dots, 0_ground {\n  outline(size) : in -> dots, rest\n"
                      "  two = place(spacing) : rest when count > 3 -> 0_ground; }\noperator nothing() { }\n"
                      "operator in(\n  a = [1,\n 2], # one\n  b) { f() : a }"),
              "operator lace(size = 3, spacing) -> dots, 0_ground { outline(size) : in -> dots, rest; "
              "two = place(spacing) : rest when (count > 3) -> 0_ground; }\noperator nothing() { }\n"
              "operator in(a = [1, 2], b) { f() : a; }\n");
}

TEST(ParseBlock, PlacesOfParts) {
    const std::string text = "let a = 1\n system  dots ( n = 2 ) { f(1) : a ; keep b # note\n } # end\n";
    const Parsed result = parsed(text);
    const auto bytes = [&](SourceSpan span) { return text.substr(span.begin, span.end - span.begin); };
    const Statement& statement = result.document.statements.at(1);
    const SystemStatement& system = std::get<SystemStatement>(statement.node);
    EXPECT_EQ(bytes(statement.span), "system  dots ( n = 2 ) { f(1) : a ; keep b # note\n }");
    EXPECT_EQ(bytes(system.name.span), "dots");
    EXPECT_EQ(bytes(system.parameters.at(0).name.span), "n");
    EXPECT_EQ(bytes(system.parameters.at(0).value->span), "2");
    EXPECT_EQ(bytes(system.statements.at(0).span), "f(1) : a");
    EXPECT_EQ(bytes(system.statements.at(1).span), "keep b");
}

TEST(ParseBlock, UnitsSeedsAndVersionsCountForTheirBlock) {
    const Parsed result = parsed(
        "unit mm\nseed 1\nfiligree 1\nsystem a { unit cm; seed 2; filigree 1\n"
        "system b { seed 3; system c { unit pt } } }\nsystem d { seed 4 }");
    EXPECT_EQ(to_text(result.diagnostics, result.document.sources), "");
    EXPECT_EQ(result.document.units, std::vector<Unit>{Unit::mm});
    const SystemStatement& a = std::get<SystemStatement>(result.document.statements.at(3).node);
    const SystemStatement& b = std::get<SystemStatement>(a.statements.at(3).node);
    const SystemStatement& c = std::get<SystemStatement>(b.statements.at(1).node);
    EXPECT_EQ(a.unit, Unit::cm);
    EXPECT_EQ(b.unit, std::nullopt);
    EXPECT_EQ(c.unit, Unit::pt);

    EXPECT_EQ(problems("system a { seed 1; seed 2 }\nseed 3\nseed 4"),
              "1:20 language.repeated-statement\n3:1 language.repeated-statement\nsystem a { seed 1; }\nseed 3\n");
    EXPECT_EQ(problems("seed 1\nsystem a { seed 2; system b { seed 3 }; seed 4 }\nseed 5"),
              "2:41 language.repeated-statement\n3:1 language.repeated-statement\n"
              "seed 1\nsystem a { seed 2; system b { seed 3; }; }\n");
    EXPECT_EQ(parsed("system a { unit mm; unit cm }").diagnostics.at(0).hints.at(0), "the first is on line 1");
}

TEST(ParseBlock, WhatMayNotStandInside) {
    EXPECT_EQ(problems("system a { include \"b.fil\"; keep c }"),
              "1:12 language.include-in-system\nsystem a { keep c; }\n");
    EXPECT_EQ(problems("operator a() {\n  f() : a\n  let b = (1,\n 2); g() : b; seed 5\n  style c {\n fill: black\n }\n"
                       "  system d { f() : a }\n  operator e() { f() : a }\n  set = f() : c\n}\nkeep d"),
              "3:3 language.not-a-rule\n4:15 language.not-a-rule\n5:3 language.not-a-rule\n8:3 language.not-a-rule\n"
              "9:3 language.not-a-rule\noperator a() { f() : a; g() : b; set = f() : c; }\nkeep d\n");
    EXPECT_EQ(problems("operator a() { include \"b.fil\" }"), "1:16 language.not-a-rule\noperator a() { }\n");
    EXPECT_EQ(problems("system s { operator a() { keep b }; operator c() { f() : a } }"),
              "1:27 language.not-a-rule\nsystem s { operator a() { }; operator c() { f() : a; }; }\n");
}

TEST(ParseBlock, DepthIsBounded) {
    const auto nested = [](std::size_t depth) {
        return repeated("system a {\n", depth) + "operator b() { f() : a }\n" + repeated("}\n", depth) + "keep c\n";
    };
    EXPECT_EQ(problems(nested(32)),
              repeated("system a { ", 32) + "operator b() { f() : a; };" + repeated(" };", 31) + " }\nkeep c\n");
    EXPECT_EQ(problems(nested(33)), "33:1 language.nesting\n" + repeated("system a { ", 31) + "system a { };" +
                                        repeated(" };", 30) + " }\nkeep c\n");
    EXPECT_EQ(parsed(nested(10000)).diagnostics.size(), 1U);
    EXPECT_EQ(parsed("let a = " + repeated("(", 200) + "1" + repeated(")", 200) +
                     "\nsystem s {\nlet a = " + repeated("(", 200) + "1" + repeated(")", 200) + "\n}")
                  .diagnostics.size(),
              0U);
}

// --- going on behind what is wrong -----------------------------------------------------------------------------

TEST(ParseBlock, ABrokenStatementCostsItselfAlone) {
    const std::uint64_t cases = case_count(300);
    for (std::uint64_t seed = 0; seed < cases; ++seed) {
        RandomText random(seed);
        const std::string broken = random.pick({"strat a = circle(1)",
                                                "let = 5",
                                                "f(1 : a -> b",
                                                "f(1,) : a -> b",
                                                "f(1) : a ->",
                                                "f(1) : a -> b,\n  c",
                                                "f(1) : a -> [<b>",
                                                "let a = \"b",
                                                "style a { b 5 }",
                                                "style a { b: 5 c: 5 }",
                                                "style a { b: (5 }",
                                                "style a {\n b: 5\n c 5\n }",
                                                "style a { b: 5",
                                                "style a {\n b: 5\n",
                                                "machinery a {\n b\n }",
                                                "machinery a { b",
                                                "f(\n 1 1,\n 2) : a",
                                                ")",
                                                "keep a//b",
                                                "keep a = 3",
                                                "keep a[1",
                                                "set a.b",
                                                "set a.b =",
                                                "set a b = 3",
                                                "default a. = 3",
                                                "reroll a x 0",
                                                "apply f() a",
                                                "apply f() to a.b",
                                                "apply f() to a,\n b/c -> d",
                                                "system {\n keep a\n }",
                                                "system a",
                                                "system a\n{\n keep b\n }",
                                                "system a(b, { keep c }",
                                                "system a(b: 3) { keep c }",
                                                "system a(b,) {\n keep c }",
                                                "system a { keep b } c",
                                                "operator a { f() : b }",
                                                "operator a() -> {\n f() : b\n }",
                                                "operator a() -> b, { f() : b }",
                                                "operator a() b { f() : b }",
                                                "include \"a.fil\"",
                                                "#x"});
        const std::string text = "system s {\n  let before = 1\n  " + broken +
                                 "\n  outline(3) : z -> y\n  style q { fill: black }\n}\nlet after = 2\n";
        ASSERT_EQ(parsed(text).diagnostics.size(), 1U) << problems(text) << text;
        ASSERT_EQ(unparse(parsed(text).document),
                  "system s { let before = 1; outline(3) : z -> y; style q { fill: black; }; }\nlet after = 2\n")
            << text;
    }
}

TEST(ParseBlock, OnOneLine) {
    EXPECT_EQ(problems("system s { keep }; keep a"), "1:17 language.missing-path\nsystem s { }\nkeep a\n");
    EXPECT_EQ(problems("system s { keep a//b; keep c = 3; let d = (1; keep e }\nkeep f"),
              "1:19 language.bad-path\n1:30 language.unexpected-token\n1:43 language.unclosed-bracket\n"
              "system s { }\nkeep f\n");
    EXPECT_EQ(problems("system s { f(1 : a -> b }\nkeep f"), "1:13 language.unclosed-bracket\nsystem s { }\nkeep f\n");
    EXPECT_EQ(problems("system s { style a { b 5 } }\nkeep f"), "1:24 language.missing-colon\nsystem s { }\nkeep f\n");
}

TEST(ParseBlock, ABlockThatIsNotClosed) {
    EXPECT_EQ(problems("let a = 1\nsystem s {\n  keep b\n"), "2:10 language.unclosed-bracket\nlet a = 1\n");
    EXPECT_EQ(problems("operator s() -> a { f() : b -> a"), "1:19 language.unclosed-bracket\n");
    EXPECT_EQ(problems("system s {\n  system t {\n    keep a\n}\nkeep b"), "1:10 language.unclosed-bracket\n");
    EXPECT_EQ(problems("system s {\n  keep a//b\n"), "2:10 language.bad-path\n1:10 language.unclosed-bracket\n");
    EXPECT_EQ(parsed("system s {").diagnostics.at(0).hints.at(0), "expected '}' before the end of the text");
    // A style that is not closed inside a system that is.
    EXPECT_EQ(problems("system s {\n  style a {\n    fill: black\n  f(1) : a -> b\n}\nkeep c\n"),
              "2:11 language.unclosed-bracket\nsystem s { f(1) : a -> b; }\nkeep c\n");
    EXPECT_EQ(problems("system s { keep a } }\nkeep b"), "1:21 language.unmatched-bracket\nkeep b\n");
    EXPECT_EQ(problems("system s { keep a }\n}\nkeep b"),
              "2:1 language.unmatched-bracket\nsystem s { keep a; }\nkeep b\n");
}

TEST(ParseBlock, TooManyErrorsInside) {
    const Parsed result = parsed("system s {\n" + repeated("strat a = 5\n", 5000) + "}\nstrat b = 5");
    ASSERT_EQ(result.diagnostics.size(), max_diagnostics + 1);
    EXPECT_EQ(result.diagnostics.back().code, "language.too-many-errors");
}

// Texts that make careless parsers quadratic: each would take minutes.
TEST(ParseBlock, StaysLinear) {
    constexpr std::size_t size = 1U << 18;
    for (const std::string_view part : {"system a {",
                                        "system a {\n",
                                        "system a { seed 1 }\n",
                                        "system a { style b {\n c\n",
                                        "system a { style b { c }\n",
                                        "system a {\n f(1 1 }\n",
                                        "operator a() {",
                                        "operator a() { seed 1\n",
                                        "system a(",
                                        "system a(b = ",
                                        "{",
                                        "style b {\n c\n",
                                        "keep a/",
                                        "keep a,",
                                        "keep a[1,\n",
                                        "a/",
                                        "**/",
                                        ",",
                                        "1,",
                                        "[1,",
                                        "e\xCC\x81/",
                                        "apply f() to a, ",
                                        "apply f() to a,\n",
                                        "set a = (\n",
                                        "reroll a x\n"}) {
        const std::string text = repeated(part, size / part.size());
        parsed(text);
        parsed("keep a[1," + text);
        parsed("system a {\n" + text);
        parsed("system a { operator b() {\n" + text + "} }");
    }
}

}  // namespace
}  // namespace filigree
