#include "language/style.h"

#include <memory>
#include <set>

#include "base/number_text.h"
#include "language/check.h"
#include "language/names.h"
#include "language/preset_place.h"
#include "language/text_evaluation.h"

namespace filigree {
namespace {

struct Styled {
    std::unique_ptr<Document> document;
    std::unique_ptr<Settings> settings;
    Result<StyleSheet> sheet = Diagnostics{};
};
Styled styled(const std::string& text) {
    Styled out;
    out.document = std::make_unique<Document>(document_of("grammar tangle\n" + text));
    Result<Settings> settings = read_settings(*out.document);
    EXPECT_TRUE(settings) << to_text(settings.diagnostics(), out.document->sources);
    out.settings = std::make_unique<Settings>(std::move(*settings));
    out.sheet = read_styles(*out.settings, *out.document);
    return out;
}
std::string complaints(const std::string& text) {
    const Styled result = styled(text);
    return codes_of(result.sheet.diagnostics(), *result.document);
}

Scope shape_of(double group, double area = 100) {
    Scope scope;
    for (const std::string_view name : style_names()) scope.names[std::string(name)] = number_value(1);
    for (const std::string_view name : {"width", "height", "x", "y"}) scope.names[std::string(name)] = length_value(10);
    scope.names["group"] = number_value(group);
    scope.names["area"] = area_value(area);
    return scope;
}

std::string text_of(const StyleOverride& style) {
    std::string out;
    const auto paint = [](const StyleOverride::Paint& colour) { return colour ? to_text(*colour) : "none"; };
    if (style.fill) out += "fill " + paint(*style.fill) + " ";
    if (style.stroke) out += "stroke " + paint(*style.stroke) + " ";
    if (style.pen) out += "pen " + to_text(*style.pen) + " ";
    if (style.corner) out += "corner " + std::to_string(static_cast<int>(*style.corner)) + " ";
    if (style.wobble) out += "wobble " + to_text(*style.wobble) + " ";
    if (style.wobble_length) out += "wobble_length " + to_text(*style.wobble_length) + " ";
    if (style.line) out += *style.line == LineQuality::drawn ? "drawn " : "even ";
    return out;
}
std::string shown(const Styled& result, std::string_view tag, const Scope& shape, std::uint64_t key = 1) {
    if (!result.sheet) return codes_of(result.sheet.diagnostics(), *result.document);
    const TagStyle of_tag = style_of_tag(*result.sheet, tag);
    const Result<StyleOverride> style = style_of_shape(*result.sheet, of_tag, shape, Key{key});
    return style ? text_of(*style) : codes_of(style.diagnostics(), *result.document);
}

TEST(Styles, LaterOnesWinPropertyByProperty) {
    const Styled result = styled(
        "style * { fill: white; stroke: black }\n"
        "style leaf, blob { fill: #a03; pen: 0.3mm }\n"
        "style leaf { stroke: none; stroke-linejoin: miter }\n"
        "style leaf when 1 > 2 { fill: red }\n"
        "style leaf when true { stroke-width: 2 }\n");
    ASSERT_TRUE(result.sheet);
    EXPECT_EQ(shown(result, "other", shape_of(1)), "fill #ffffff stroke #000000 ");
    EXPECT_EQ(shown(result, "leaf", shape_of(1)), "fill #aa0033 stroke none pen 2 corner 0 ");
    const TagStyle leaf = style_of_tag(*result.sheet, "leaf");
    EXPECT_TRUE(leaf.is_constant);
    EXPECT_TRUE(leaf.rules.empty());
    EXPECT_EQ(text_of(leaf.common), "fill #aa0033 stroke none pen 2 corner 0 ");
    EXPECT_EQ(text_of(style_of_tag(*styled("").sheet, "leaf").common), "");
}

TEST(Styles, KnowHowAHandDraws) {
    const Styled result = styled(
        "unit mm\nstyle * { wobble: 0.25in; wobble-length: 10 }\n"
        "style leaf { line: drawn; wobble_length: 1in }\nstyle blob { line: one_of(even, even); wobble: 0 }\n");
    ASSERT_TRUE(result.sheet);
    EXPECT_EQ(shown(result, "leaf", shape_of(1)), "wobble 24 wobble_length 96 drawn ");
    EXPECT_EQ(shown(result, "blob", shape_of(1)).substr(0, 23), "wobble 0 wobble_length ");
    EXPECT_NE(shown(result, "blob", shape_of(1)).find(" even "), std::string::npos);
    EXPECT_EQ(complaints("style leaf { line: wavy }"), "language.unknown-name@wavy\n");
    EXPECT_EQ(complaints("style leaf { line: 3 }"), "language.wrong-kind@3\n");
    EXPECT_EQ(complaints("style leaf { wobble: -1; wobble-length: 0.5 }"),
              "language.out-of-range@-1\nlanguage.out-of-range@0.5\n");
    EXPECT_EQ(complaints("style leaf { wobble: 3deg }"), "language.wrong-kind@3deg\n");
    EXPECT_EQ(complaints("style leaf { wobbel: 3 }"), "language.unknown-property@wobbel\n");
    EXPECT_EQ(styled("style leaf { wobble-length: 0.5 }").sheet.diagnostics().front().message,
              "'wobble_length' must be from 1px to 1000000px, but this is 0.5px");
}

TEST(Styles, ConditionsAreEvaluatedPerShape) {
    const Styled result = styled(
        "unit mm\nparam size = 10\n"
        "style leaf { fill: white }\n"
        "style leaf when area > size * size { fill: black; pen: width / 10 }\n"
        "style leaf { stroke: red }\n");
    ASSERT_TRUE(result.sheet);
    EXPECT_FALSE(style_of_tag(*result.sheet, "leaf").is_constant);
    // 10mm squared are 1428px^2.
    EXPECT_EQ(shown(result, "leaf", shape_of(1, 1400)), "fill #ffffff stroke #ff0000 ");
    EXPECT_EQ(shown(result, "leaf", shape_of(1, 1500)), "fill #000000 stroke #ff0000 pen 1 ");
}

TEST(Styles, PalettesCycleByTheGroup) {
    const Styled result = styled(
        "palette teal = [#000001, #000002, #000003]\n"
        "style leaf { fill: teal; stroke: [red, none] }\n"
        "style drawn { fill: one_of(teal) }\n"
        "style second { fill: teal(2); stroke: teal(group) }\n");
    ASSERT_TRUE(result.sheet);
    EXPECT_EQ(shown(result, "leaf", shape_of(1)), "fill #000001 stroke #ff0000 ");
    EXPECT_EQ(shown(result, "leaf", shape_of(2)), "fill #000002 stroke none ");
    EXPECT_EQ(shown(result, "leaf", shape_of(4)), "fill #000001 stroke none ");
    EXPECT_EQ(shown(result, "leaf", shape_of(0)), "fill #000003 stroke none ");
    EXPECT_EQ(shown(result, "second", shape_of(3)), "fill #000002 stroke #000003 ");
    std::set<std::string> seen;
    for (std::uint64_t key = 0; key < 40; ++key) seen.insert(shown(result, "drawn", shape_of(1), key));
    EXPECT_EQ(seen, (std::set<std::string>{"fill #000001 ", "fill #000002 ", "fill #000003 "}));
}

// A plain statement between those that draw, or another name for the tag, changes no picture.
TEST(Styles, PlainStatementsChangeNoDraw) {
    const Styled a = styled("style leaf { fill: one_of(red, blue) }\nstyle leaf { stroke: one_of(red, blue) }\n");
    const Styled b = styled(
        "style blatt { fill: one_of(red, blue) }\nstyle blatt { pen: 3 }\n"
        "style blatt { stroke: one_of(red, blue) }\n");
    for (std::uint64_t key = 0; key < 40; ++key) {
        EXPECT_EQ(shown(a, "leaf", shape_of(1), key) + "pen 3 ", shown(b, "blatt", shape_of(1), key));
    }
}

TEST(Styles, EverythingIsCheckedUpFront) {
    EXPECT_EQ(complaints("style leaf { fil: black }"), "language.unknown-property@fil\n");
    EXPECT_EQ(complaints("style leaf { fill: balck }"), "language.unknown-name@balck\n");
    EXPECT_EQ(complaints("style leaf when aera > 5 { fill: black }"), "language.unknown-name@aera\n");
    EXPECT_EQ(complaints("style leaf when area > 30deg { pen: 30deg }"),
              "language.wrong-kind@area > 30deg\nlanguage.wrong-kind@30deg\n");
    EXPECT_EQ(complaints("style leaf when area { pen: -1 }"), "language.wrong-kind@area\nlanguage.out-of-range@-1\n");
    EXPECT_EQ(complaints("style leaf { pen: area > 5 ? 1 : foo; fill: 5 }"),
              "language.unknown-name@foo\nlanguage.wrong-kind@5\n");
    EXPECT_EQ(complaints("style leaf { pen: area > 5 ? 1 : 5deg; stroke: area > 5 ? none : 3 }"),
              "language.wrong-kind@5deg\nlanguage.wrong-kind@3\n");
    EXPECT_EQ(complaints("style leaf { corner: sharp; stroke: one_of(red, 3, \"x\") }"),
              "language.unknown-name@sharp\nlanguage.wrong-kind@3\nlanguage.wrong-kind@\"x\"\n");
    EXPECT_EQ(complaints("style leaf when count > 1 { fill: none }"), "language.unknown-name@count\n");
    EXPECT_EQ(complaints("style leaf when 1 / (group - 6) > 1 { pen: 1 / (index - 7) }"), "");
    EXPECT_EQ(complaints("style leaf { pen: 9..5; fill: [] }"), "language.empty-range@9..5\nlanguage.wrong-kind@[]\n");
}

TEST(Styles, WhatOnlyAShapeShowsIsReportedThere) {
    const Styled result = styled("style leaf { pen: 1 / (group - 6) }");
    ASSERT_TRUE(result.sheet);
    EXPECT_EQ(shown(result, "leaf", shape_of(6)), "language.not-finite@1 / (group - 6)\n");
    EXPECT_EQ(shown(result, "leaf", shape_of(8)), "pen 0.5 ");
    EXPECT_EQ(shown(result, "leaf", shape_of(5)), "language.out-of-range@1 / (group - 6)\n");
}

// --- presets ----------------------------------------------------------------------------------------------------

class StylePresets : public testing::Test {
protected:
    Styled styles;
    PresetPlace place;
    std::vector<std::uint32_t> accepted_at_rule;
    bool random = true;

    // The style of the leaf with this key, by what presets say of leaf/3.
    std::string run(const std::string& text, std::string_view presets, std::uint64_t key = 1) {
        styles = styled(text);
        place.seed = styles.settings->seed;
        place.globals = styles.settings->globals;
        place.stand_at("leaf", presets);
        const TagStyle of_tag = style_of_tag(*styles.sheet, "leaf", true);
        const StyleChoices choices = [this](std::string_view segment) -> Result<StepChoices> {
            accepted_at_rule = place.accepted_at("leaf/3/" + std::string(segment));
            StepChoices at_rule = place.choices;
            at_rule.accepted = accepted_at_rule;
            const Result<bool> is_random = is_random_at(place.presets, accepted_at_rule, place.globals);
            if (!is_random) return is_random.diagnostics();
            at_rule.is_random = *is_random;
            return at_rule;
        };
        Scope shape = shape_of(2);
        const Result<StyleOverride> style = style_of_shape(*styles.sheet, of_tag, shape, Key{key}, choices);
        return style ? text_of(*style) : style.diagnostics().front().code;
    }
    std::string rows(std::uint64_t key, std::string_view segment) const { return place.rows(child(Key{key}, segment)); }
};

TEST_F(StylePresets, ReplaceProperties) {
    const std::string text = "style leaf { fill: white; pen: 3 }\nstyle leaf { fill: one_of(red, blue) }\n";
    EXPECT_EQ(run(text, "set leaf/*/style#1.fill = black\nset **/style#1.pen = 5\n").substr(12), " pen 5 ");
    EXPECT_EQ(run(text, "set leaf/3/style#2.fill = green\n"), "fill #008000 pen 3 ");
    EXPECT_EQ(rows(1, "style#2"), "fill: green set\n");
    EXPECT_EQ(run(text, "set leaf/4/style#2.fill = green\n"), run(text, ""));
    EXPECT_EQ(run(text, "set **.fill = none\n"), "fill none pen 3 ");
    EXPECT_EQ(run(text, "set **.stroke = red\n"), run(text, "")) << "only what the style says";
    EXPECT_EQ(run(text, "set **.pen = -1\n"), "language.out-of-range");
    EXPECT_EQ(run(text, "set **.fill = 3\n"), "language.wrong-kind");
    EXPECT_EQ(run(text, "unit mm\nset **.pen = 1\n"), run(text, "set **.pen = 1mm\n")) << "in the unit of its document";
    EXPECT_EQ(run("style leaf { corner: round }\n", "set **.corner = bevel\n"), "corner 2 ");
    EXPECT_EQ(run("style leaf { line: drawn; wobble: 1 }\n", "set **.line = even\nset **.wobble = 1..1\n"),
              "wobble 1 even ");
    EXPECT_EQ(run("style leaf { wobble-length: 9 }\n", "set **.wobble_length = 8\n"), "wobble_length 8 ");
    EXPECT_EQ(run("style leaf { fill: red }\n", "set **.fill = [red, #000001]\n"), "fill #000001 ") << "by the group";
    EXPECT_EQ(run("style leaf { stroke-width: 1 }\n", "set **.pen = width / 5\n"), "pen 2 ");
    EXPECT_EQ(run("style leaf { pen: 1; stroke-width: 2 }\n", ""), "pen 2 ");
}

TEST_F(StylePresets, TurnRulesOnAndOff) {
    const std::string text =
        "style leaf when area > 500 { pen: 3 }\nstyle leaf when false { pen: 4 }\nstyle leaf { corner: round }";
    EXPECT_EQ(run(text, ""), "corner 1 ");
    EXPECT_EQ(run(text, "set **/style#1.when = true"), "pen 3 corner 1 ");
    EXPECT_EQ(rows(1, "style"), "when: true set\n");
    EXPECT_EQ(run(text, "set **.when = true"), "pen 4 corner 1 ");
    EXPECT_EQ(run(text, "set **/style#3.when = area < 5"), "");
    EXPECT_EQ(run(text, "set **.when = 3"), "language.out-of-range");
}

TEST_F(StylePresets, DrawWhatTheyDrewAndRecordIt) {
    const std::string text =
        "style leaf { pen: 2 }\nstyle leaf { fill: one_of(red, blue, green); pen: 1..2 }\n"
        "style leaf when (0..1) < 0.5 { stroke: one_of(red, none) }\n";
    std::set<std::string> seen;
    for (std::uint64_t key = 0; key < 40; ++key) {
        const std::string with = run(text, "", key);
        EXPECT_EQ(with, shown(styled(text), "leaf", shape_of(2), key)) << "the same bits";
        seen.insert(with);
        const std::string second = rows(key, "style#2"), third = rows(key, "style#3");
        EXPECT_NE(("\n" + second).find("\nfill: one_of(red, blue, green) drawn "), std::string::npos) << second;
        EXPECT_NE(("\n" + second).find("\npen: 1..2 drawn "), std::string::npos) << second;
        EXPECT_NE(("\n" + third).find("\nwhen: 0..1 drawn "), std::string::npos) << third;
        EXPECT_EQ(third.find("\nstroke: ") != std::string::npos, with.find("stroke") != std::string::npos);
    }
    EXPECT_GT(seen.size(), 30U);
    // They replay under their own names.
    place.replay.add(child(Key{7}, "style#2"), "fill", Value{Symbol{"green"}, {}});
    place.replay.add(child(Key{7}, "style#2"), "pen", number_value(1.25));
    EXPECT_EQ(run(text, "", 7).substr(0, 12), "fill #008000");
    EXPECT_NE(run(text, "", 7).find("pen 1.25 "), std::string::npos);
    EXPECT_NE(run(text, "set **.is_random = false", 9).find("pen 1.5 "), std::string::npos);
    EXPECT_NE(run(text, "set **.is_random = false\ndefault **.pen = 4", 9).find("pen 4 "), std::string::npos);
    EXPECT_NE(run(text, "reroll **/style#2.pen", 9), run(text, "", 9));
}

TEST_F(StylePresets, CostNothingWhereNoneNamesAStyle) {
    const Styled result = styled("style leaf { fill: white }\nstyle leaf when false { pen: 4 }\n");
    EXPECT_TRUE(style_of_tag(*result.sheet, "leaf").is_constant);
    const TagStyle open = style_of_tag(*result.sheet, "leaf", true);
    EXPECT_FALSE(open.is_constant);
    EXPECT_EQ(open.rules, (std::vector<std::uint32_t>{0, 1}));
    EXPECT_EQ(open.common, StyleOverride{});
    EXPECT_TRUE(style_of_tag(*result.sheet, "other", true).is_constant);
}

TEST_F(StylePresets, AreCheckedUpFront) {
    const auto check = [&](std::string_view property, std::string_view text) {
        const Diagnostics found = check_style_preset(property, *expression_of(text, 0), place.document, place.globals);
        return found.empty() ? std::string() : found.front().code;
    };
    EXPECT_EQ(check("fill", "one_of(red, none)"), "");
    EXPECT_EQ(check("fill", "rde"), "language.unknown-name");
    EXPECT_EQ(check("stroke", "3"), "language.wrong-kind");
    EXPECT_EQ(check("pen", "-1"), "language.out-of-range");
    EXPECT_EQ(check("pen", "width / 3"), "");
    EXPECT_EQ(check("corner", "sharp"), "language.unknown-name");
    EXPECT_EQ(check("line", "drawn"), "");
    EXPECT_EQ(check("line", "sharp"), "language.unknown-name");
    EXPECT_EQ(check("wobble", "-1"), "language.out-of-range");
    EXPECT_EQ(check("when", "area > 3 && index < 2"), "");
    EXPECT_EQ(check("when", "area"), "language.wrong-kind");
    EXPECT_EQ(check("other", "nothing"), "");
}

}  // namespace
}  // namespace filigree
