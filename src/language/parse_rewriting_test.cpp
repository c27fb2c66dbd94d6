#include <gtest/gtest.h>

#include "base/test_cases.h"
#include "language/parse.h"
#include "language/unparse.h"

namespace filigree {
namespace {

constexpr std::string_view head = "grammar rewriting\n";

Parsed parsed(const std::string& text) { return parse_document("a.fil", std::string(head) + text, {}); }

// The one statement, as it is understood; or the code of the first error and the text that it points to.
std::string understood(const std::string& text) {
    const Parsed result = parsed(text);
    if (!result.diagnostics.empty()) {
        const Diagnostic& first = result.diagnostics.front();
        return first.code + "@" + result.document.text().substr(first.span.begin, first.span.end - first.span.begin);
    }
    if (result.document.statements.size() != 2) return std::to_string(result.document.statements.size());
    return unparse(result.document.statements[1]);
}

TEST(ParseRewriting, Rules) {
    EXPECT_EQ(understood("a -> \"ab\""), "\"a\" -> \"ab\"");
    EXPECT_EQ(understood("a → \"ab\"   # doubles"), "\"a\" -> \"ab\"");
    EXPECT_EQ(understood("a@1 -> \"a[P<n]\""), "\"a\"@1..1 -> \"a[P<n]\"");
    EXPECT_EQ(understood("n @ 2..5 -> \"a\""), "\"n\"@2..5 -> \"a\"");
    EXPECT_EQ(understood("b -> \"ab\" *2, \"c\" *1"), "\"b\" -> \"ab\" * (2), \"c\" * (1)");
    EXPECT_EQ(understood("a b < c > d[e] -> \"x\""), "\"ab\" < \"c\" > \"d[e]\" -> \"x\"");
    EXPECT_EQ(understood("\"+\" -> \"-\""), "\"+\" -> \"-\"");
    EXPECT_EQ(understood("0 -> \"1\""), "\"0\" -> \"1\"");
    EXPECT_EQ(understood("+ -> \"-\""), "\"+\" -> \"-\"");
    EXPECT_EQ(understood("r@1 -> goto a@3"), "\"r\"@1..1 -> goto \"a\"@3");
    EXPECT_EQ(understood("a@4 -> M[ix][iy + 1] { ix = ix+1, iy = 0 }"),
              "\"a\"@4..4 -> M[ix][(iy + 1)] { ix = (ix + 1); iy = 0; }");
    EXPECT_EQ(understood("a -> \"ab\" loop 3 when depth < 2"), "\"a\" -> \"ab\" loop 3 when (depth < 2)");
    EXPECT_EQ(understood("a ->\n    \"ab\""), "\"a\" -> \"ab\"") << "a rule whose arrow ends the line";
    // ñ in one code point, in two, and by its other name.
    EXPECT_EQ(understood("\u00F1@3 -> \"a\""), "\"\u00F1\"@3..3 -> \"a\"");
    EXPECT_EQ(understood("n\u0303@3 -> \"a\""), "\"\u00F1\"@3..3 -> \"a\"");
    EXPECT_EQ(understood("~n@3 -> \"a\""), "\"\u00F1\"@3..3 -> \"a\"");
    EXPECT_EQ(understood("r -> goto ~n@3"), "\"r\" -> goto \"\u00F1\"@3");
    EXPECT_EQ(understood("b[c] < a -> \"x\""), "\"b[c]\" < \"a\" -> \"x\"");
}

TEST(ParseRewriting, SettingsMacrosAndCells) {
    EXPECT_EQ(understood("axiom \"D+a+a+a\""), "axiom \"D+a+a+a\"");
    EXPECT_EQ(understood("gain q 1 g 2"), "gain q, 1, g, 2");
    EXPECT_EQ(understood("gain q, 1, g, 2"), "gain q, 1, g, 2");
    EXPECT_EQ(understood("array M [10] [10]"), "array M, [10], [10]");
    EXPECT_EQ(understood("M[3][9] -> \"ab\""), "M[3][9] -> \"ab\"");
    EXPECT_EQ(understood("R = random 1..8 \"abbccc\""), "\"R\" = random (1 .. 8) \"abbccc\"");
    EXPECT_EQ(understood("W = random 5 \"ab\" unique"), "\"W\" = random 5 \"ab\" unique");
    EXPECT_EQ(understood("system A { axiom \"c\"; c -> \"cd\"; iterations 3 }"),
              "system A { axiom \"c\"; \"c\" -> \"cd\"; iterations 3; }");
    EXPECT_EQ(understood("param k = 3 in 1..9"), "param k = 3 in (1 .. 9)");
}

TEST(ParseRewriting, MasksAndSleep) {
    EXPECT_EQ(understood("mask a@2, \"b+\" @ 3..5 when depth > 2"), "mask \"a\"@2..2, \"b+\"@3..5 when (depth > 2)");
    EXPECT_EQ(understood("mask ~n, +"), "mask \"\u00F1\", \"+\"");
    EXPECT_EQ(understood("sleep a, q until age > 3"), "sleep \"a\", \"q\" until (age > 3)");
    EXPECT_EQ(understood("sleep a"), "language.missing-condition@");
    EXPECT_EQ(understood("sleep a when age > 3"), "language.missing-condition@when");
    EXPECT_EQ(understood("mask a until age > 3"), "language.unexpected-token@until");
    EXPECT_EQ(understood("mask a b"), "language.unexpected-token@b");
    EXPECT_EQ(understood("mask a@0"), "language.missing-iteration@0");
    EXPECT_EQ(understood("mask a@3..2"), "language.empty-range@2");
    EXPECT_EQ(understood("mask"), "language.missing-symbol@");
    EXPECT_EQ(understood("mask a,"), "language.missing-symbol@");
}

TEST(ParseRewriting, Loops) {
    EXPECT_EQ(understood("loop a 3"), "loop \"a\" 3");
    EXPECT_EQ(understood("loop a@2, \"b+\" @ 3..5 count + side"), "loop \"a\"@2..2, \"b+\"@3..5 (count + side)");
    EXPECT_EQ(understood("loop ~n (t)"), "loop \"\u00F1\" t");
    EXPECT_EQ(understood("loop"), "language.missing-symbol@");
    EXPECT_EQ(understood("loop a"), "language.missing-value@");
    EXPECT_EQ(understood("loop a@2"), "language.missing-value@");
    EXPECT_EQ(understood("loop a@0 3"), "language.missing-iteration@0");
    EXPECT_EQ(understood("loop a 3 when t > 2"), "language.unexpected-token@when");
}

TEST(ParseRewriting, Lookups) {
    EXPECT_EQ(understood("image wall \"a.png\" over 0, 0, 400, 300"), "image wall, \"a.png\", over, 0, 0, 400, 300");
    EXPECT_EQ(understood("data d \"a.csv\" over -5, -k, 9, 9 outside wrap"),
              "data d, \"a.csv\", over, (-5), (-k), 9, 9, outside, wrap")
        << "no difference of `over` and 5";
    EXPECT_EQ(understood("i -> image wall L { 0..85 \"T+b\"; 86..170 \"b\", 255 \"{$L p}\" }"),
              "\"i\" -> image wall L { (0 .. 85) \"T+b\"; (86 .. 170) \"b\"; 255 \"{$L p}\"; }");
    EXPECT_EQ(understood("b@2 -> data heights {\n  -1..1.5 \"b\"   # low\n\n  1.5..2 * k \"bb\"\n} * 2, image[3] "
                         "loop 2 when value > 1 { ix = L }"),
              "\"b\"@2..2 -> data heights { ((-1) .. 1.5) \"b\"; (1.5 .. (2 * k)) \"bb\"; } * (2), image[3] "
              "loop 2 when (value > 1) { ix = L; }");

    EXPECT_EQ(understood("i -> image"), "language.missing-name@");
    EXPECT_EQ(understood("i -> image wall { 0 \"a\" }"), "language.missing-channel@{");
    EXPECT_EQ(understood("i -> image wall L"), "language.missing-rows@");
    EXPECT_EQ(understood("i -> data heights L { 0 \"a\" }"), "language.missing-rows@L");
    EXPECT_EQ(understood("i -> data heights { }"), "language.missing-rows@}");
    EXPECT_EQ(understood("i -> data heights { 0..1 }"), "language.missing-text@}");
    EXPECT_EQ(understood("i -> data heights { \"a\" }"), "language.missing-text@}");
    EXPECT_EQ(understood("i -> data heights { 0..1 \"a\" 1..2 \"b\" }"), "language.unexpected-token@1");
    EXPECT_EQ(understood("i -> data heights { 0..1 \"a\""), "language.unclosed-bracket@{");
    const Parsed next = parsed("i -> data heights {\n  0..1 a\n  1..2 \"b\"\n}\na -> \"b\"");
    EXPECT_EQ(next.diagnostics.size(), 1U) << to_text(next.diagnostics, next.document.sources);
    EXPECT_EQ(next.document.statements.size(), 2U) << "the next rule is read again";
}

TEST(ParseRewriting, WhatIsWrong) {
    EXPECT_EQ(understood("a -> ab"), "language.missing-word@ab");
    EXPECT_EQ(understood("a -> \"ab\","), "language.missing-word@");
    EXPECT_EQ(understood("a - > \"ab\""), "language.missing-symbol@a -");
    EXPECT_EQ(understood("ab -> \"c\""), "language.unknown-statement@ab");
    EXPECT_EQ(understood("\"ab\" -> \"c\""), "language.missing-symbol@\"ab\"");
    EXPECT_EQ(understood("a@0 -> \"b\""), "language.missing-iteration@0");
    EXPECT_EQ(understood("a@3..2 -> \"b\""), "language.empty-range@2");
    EXPECT_EQ(understood("a < -> \"b\""), "language.missing-symbol@->");
    EXPECT_EQ(understood("r -> goto a"), "language.missing-iteration@");
    EXPECT_EQ(understood("a -> \"b\" { ix + 1 }"), "language.missing-equals@+");
    EXPECT_EQ(understood("a -> \"b\" when 1 when 2"), "language.repeated-clause@when");
    EXPECT_EQ(understood("iterations"), "language.missing-value@");
    EXPECT_EQ(understood("angel = 30"), "language.unknown-statement@angel");
    EXPECT_EQ(understood("iterations = 30"), "language.lone-equals@=");
    EXPECT_EQ(understood("iteratoins 3"), "language.unknown-statement@iteratoins");
    EXPECT_EQ(understood("R = 1..8 \"ab\""), "language.missing-random@1");
    EXPECT_EQ(understood("outline(3) : a -> b"), "language.unknown-statement@outline");
}

// Statements that are written again mean the same, and damaged ones are survived.
TEST(ParseRewriting, DamagedRulesAreSurvived) {
    const std::vector<std::string> rules = {
        "a b < c > d[e]@2..5 -> \"x{3 y+}\" * 2, goto a@3, M[ix][iy] loop k when t > 2 { ix = ix + 1; iy = 0 }",
        "i -> image wall L { 0..85 \"T+b\"; 86 \"b\" } * 2, data d { 0..1 \"{$value b}\" } loop 2 { ix = L }",
        "image wall \"a.png\" over -1, 0, 3, 3 outside none",
        "R = random 1..8 \"abbccc\" unique",
        "gain q 1 g 2",
        "M[3][9] -> \"ab\"",
        "loop \"ab\"@2..3, c count * 2",
        "\u00F1 -> \"a\""};
    for (std::uint64_t seed = 0; seed < 3 * case_count(); ++seed) {
        CaseRandom random(seed);
        std::string text = rules[random.index(rules.size())];
        EXPECT_NE(understood(text).find(' '), std::string::npos) << text;
        EXPECT_EQ(understood(understood(text)), understood(text));
        constexpr std::string_view signs = "\"<>@=->{}[]*,;. \\a1#\n";
        for (int edits = random.whole(1, 4); edits > 0; --edits) {
            const std::size_t at = random.index(text.size());
            if (random.coin()) {
                text.insert(at, 1, signs[random.index(signs.size())]);
            } else {
                text.erase(at, 1);
            }
            if (text.empty()) text = "a";
        }
        const Parsed result = parsed(text);
        for (const Diagnostic& diagnostic : result.diagnostics) {
            EXPECT_LE(diagnostic.span.begin, diagnostic.span.end) << text;
            EXPECT_LE(diagnostic.span.end, result.document.text().size()) << text;
        }
        if (result.diagnostics.empty()) {
            const std::string written = unparse(result.document);
            EXPECT_EQ(unparse(parse_document("a.fil", written, {}).document), written) << text;
        }
    }
}

}  // namespace
}  // namespace filigree
