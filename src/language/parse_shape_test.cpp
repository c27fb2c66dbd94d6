#include <gtest/gtest.h>

#include "language/parse.h"
#include "language/unparse.h"

namespace filigree {
namespace {

Parsed parsed(const std::string& text) { return parse_document("a.fil", "grammar shape\n" + text, {}); }

// The one statement below the grammar, as it is understood; or the code of the first error and what it points to.
std::string understood(const std::string& text) {
    const Parsed result = parsed(text);
    if (!result.diagnostics.empty()) {
        const Diagnostic& first = result.diagnostics.front();
        return first.code + "@" + result.document.text().substr(first.span.begin, first.span.end - first.span.begin);
    }
    if (result.document.statements.size() != 2) return std::to_string(result.document.statements.size());
    return unparse(result.document.statements[1]);
}
// The first hint of the first error.
std::string hint(const std::string& text) {
    const Parsed result = parsed(text);
    if (result.diagnostics.empty() || result.diagnostics.front().hints.empty()) return "";
    return result.diagnostics.front().hints.front();
}

TEST(ParseShape, Rules) {
    EXPECT_EQ(understood("slide = petal -> translate(-2, -2) * petal"),
              "slide = petal -> (translate((-2), (-2)) * petal)");
    EXPECT_EQ(understood("slide = petal \xE2\x86\x92 lens"), "slide = petal -> lens");
    EXPECT_EQ(understood("slide=petal->\n\n  lens weight 2 # half"), "slide = petal -> lens weight 2");
    EXPECT_EQ(understood("slide = petal -> lens  when n > 2 unless box(0, 0, 3, 3) priority 1 weight w match isometry "
                         "unless inside(lens)"),
              "slide = petal -> lens match isometry weight w priority 1 unless box(0, 0, 3, 3) unless inside(lens) "
              "when (n > 2)");
    EXPECT_EQ(understood("grow = empty -> petal"), "grow = empty -> petal");
    EXPECT_EQ(understood("wither = petal + lens - leaf & bud -> empty"),
              "wither = ((petal + lens) - (leaf & bud)) -> empty");
    EXPECT_EQ(understood("slide = petal -> lens match visual(0.5)"), "slide = petal -> lens match visual(0.5)");
    EXPECT_EQ(understood("back = inverse(slide)"), "back = inverse(slide)");
    EXPECT_EQ(understood("flip = mirror(slide, 45)"), "flip = mirror(slide, 45)");
    EXPECT_EQ(understood("system a { grammar shape; back = inverse(slide) }"),
              "system a { grammar shape; back = inverse(slide); }");
}

TEST(ParseShape, ReservedWordsNameRulesBeforeAnArrow) {
    EXPECT_EQ(understood("match = petal -> lens match match"), "match = petal -> lens match match");
    EXPECT_EQ(understood("start = petal -> lens"), "start = petal -> lens");
    EXPECT_EQ(understood("rules = petal -> weight weight 3"), "rules = petal -> weight weight 3");
    EXPECT_EQ(understood("start petal = lens"), "start petal = lens");
    EXPECT_EQ(understood("steps = 12"), "language.lone-equals@=");
    EXPECT_EQ(understood("seed = 12"), "language.lone-equals@=");
    EXPECT_EQ(understood("seed = 12; grow = empty -> petal"), "language.lone-equals@=");
}

TEST(ParseShape, OtherStatements) {
    EXPECT_EQ(understood("rules from \"knot.svg\""), "rules from \"knot.svg\"");
    EXPECT_EQ(understood("steps 12"), "steps 12");
    EXPECT_EQ(understood("tolerance 0.01mm"), "tolerance 0.01mm");
    EXPECT_EQ(understood("match affine"), "match affine");
    EXPECT_EQ(understood("choose one_of(first, random)"), "choose one_of(first, random)");
    EXPECT_EQ(understood("show points"), "show points");
    EXPECT_EQ(understood("show control_polygons,matches(slide), film(columns: 4)"),
              "show control_polygons, matches(slide), film(columns: 4)");
    EXPECT_EQ(understood("apply slide at (3, 3)"), "apply slide at (3, 3)");
    EXPECT_EQ(understood("apply slide orbit mirrored scale 2 angle 90 at (3, 3)"),
              "apply slide at (3, 3) angle 90 scale 2 mirrored orbit");
    EXPECT_EQ(understood("start design = petal + translate(2, 2) * rotate(180) * petal"),
              "start design = (petal + ((translate(2, 2) * rotate(180)) * petal))");
    EXPECT_EQ(understood("apply rim = outline(5) to a/b"), "apply rim = outline(5) to a/b");
    EXPECT_EQ(understood("apply outline(5) to a/b"), "apply outline(5) to a/b");
}

TEST(ParseShape, PartsKnowTheirPlaces) {
    const std::string text = "slide  = petal -> lens weight 2  # so";
    const Parsed result = parsed(text + "\nrules from \"a.svg\" ; apply slide at (3, 3)");
    ASSERT_EQ(result.document.statements.size(), 4U);
    const auto bytes = [&](SourceSpan span) {
        return result.document.text().substr(span.begin, span.end - span.begin);
    };
    const auto& rule = std::get<ShapeRule>(result.document.statements[1].node);
    EXPECT_EQ(bytes(result.document.statements[1].span), "slide  = petal -> lens weight 2");
    EXPECT_EQ(bytes(rule.name.span), "slide");
    EXPECT_EQ(bytes(rule.right->span), "lens");
    EXPECT_EQ(bytes(std::get<RulesFromStatement>(result.document.statements[2].node).file.span), "\"a.svg\"");
    EXPECT_EQ(bytes(std::get<MatchStatement>(result.document.statements[3].node).rule.span), "slide");
}

TEST(ParseShape, Failures) {
    EXPECT_EQ(understood("slide = petal -> lens weigth 2"), "language.unknown-clause@weigth");
    EXPECT_EQ(hint("slide = petal -> lens weigth 2"), "did you mean 'weight'?");
    EXPECT_EQ(hint("slide = petal -> lens yonder 2"), "the clauses are match, weight, priority, unless, when");
    EXPECT_EQ(understood("slide = petal -> lens weight 2 match isometry weight 3"), "language.repeated-clause@weight");
    EXPECT_EQ(understood("slide = petal -> lens when a and b"), "language.unexpected-token@and");
    EXPECT_EQ(understood("slide = petal -> lens, bud"), "language.unexpected-token@,");
    EXPECT_EQ(understood("slide = -> lens"), "language.missing-side@->");
    EXPECT_EQ(understood("slide = petal ->"), "language.missing-side@");
    EXPECT_EQ(understood("slide = petal -> weight 3"), "language.missing-side@weight");
    EXPECT_EQ(understood("slide = petal => lens"), "language.missing-arrow@=>");
    EXPECT_EQ(understood("slide = petal lens"), "language.missing-arrow@lens");
    EXPECT_EQ(understood("back = inverse(slide) weight 2"), "language.missing-arrow@weight");
    EXPECT_EQ(hint("back = inverse(slide) weight 2"), "a rule that follows from another one has no clauses of its own");
    EXPECT_EQ(understood("gap = 5"), "language.missing-arrow@");
    EXPECT_EQ(understood("slide petal -> lens"), "language.missing-equals@petal");
    EXPECT_EQ(understood("petal -> lens"), "language.missing-equals@->");
    EXPECT_EQ(understood("outline(25) : leaf -> in, out"), "language.missing-equals@(");
    EXPECT_EQ(understood("outline(25) : leaf"), "language.unknown-statement@outline");
    EXPECT_EQ(understood("rules \"knot.svg\""), "language.missing-from@\"knot.svg\"");
    EXPECT_EQ(understood("rules from knot.svg"), "language.missing-text@knot");
    EXPECT_EQ(understood("step 12"), "language.unknown-statement@step");
    EXPECT_EQ(hint("step 12"), "did you mean 'steps'?");
    EXPECT_EQ(understood("steps"), "language.missing-value@");
    EXPECT_EQ(understood("steps 12 13"), "language.unexpected-token@13");
    EXPECT_EQ(understood("show points,"), "language.missing-value@");
    EXPECT_EQ(understood("apply slide"), "language.missing-place@");
    EXPECT_EQ(understood("apply slide mirrored angle 30"), "language.missing-place@");
    EXPECT_EQ(understood("apply slide at (3, 3) mirrored mirrored"), "language.repeated-clause@mirrored");
    EXPECT_EQ(understood("apply slide at (3, 3) mirored"), "language.unknown-clause@mirored");
    EXPECT_EQ(hint("apply slide at (3, 3) mirored"), "did you mean 'mirrored'?");
    EXPECT_EQ(understood("apply slide (3, 3)"), "language.missing-to@");
    EXPECT_EQ(hint("apply slide (3, 3)"), "write it as in 'apply slide at (3, 3)'");
}

// A rule that is wrong before an arrow at the line's end takes its right side with it.
TEST(ParseShape, OneErrorForOneBrokenStatement) {
    for (const std::string broken :
         {"slide = (petal ->\n translate(2, 2) * petal", "slide = petal + ->\n\n lens weight 2",
          "slide = -> \xE2\x86\x92\nlens", "slide = petal ->\n + lens", "slide = petal -> lens weigth 2",
          "slide petal -> lens", "apply slide at", "rules", "steps", "show", "slide = petal -> lens -> bud"}) {
        const Parsed result = parsed("grow = empty -> bud\n" + broken + "\nsteps 3\nback = inverse(grow)\n");
        EXPECT_EQ(result.diagnostics.size(), 1U) << broken << to_text(result.diagnostics, result.document.sources);
        EXPECT_EQ(unparse(result.document), "grammar shape\ngrow = empty -> bud\nsteps 3\nback = inverse(grow)\n")
            << broken;
    }
}

// The words of shape grammars are no words elsewhere.
TEST(ParseShape, OtherGrammarsStayAsTheyAre) {
    for (const std::string text :
         {"steps 12", "slide = petal -> lens", "rules from \"a.svg\"", "apply slide at (3, 3)"}) {
        EXPECT_FALSE(parse_document("a.fil", "grammar tangle\n" + text, {}).diagnostics.empty()) << text;
    }
    EXPECT_TRUE(
        parse_document("a.fil", "grammar tangle\nmatch = outline(3) : steps -> rules, show", {}).diagnostics.empty());
    EXPECT_TRUE(parse_document("a.fil", "grammar shape\nsystem a { grammar tangle; outline(3) : a -> b }\nsteps 3", {})
                    .diagnostics.empty());
}

}  // namespace
}  // namespace filigree
