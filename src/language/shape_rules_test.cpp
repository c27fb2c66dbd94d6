#include "language/shape_rules.h"

#include "language/settings.h"
#include "language/text_evaluation.h"

namespace filigree {
namespace {

using Kind = NamedShapeRule::Kind;

constexpr std::string_view head =
    "grammar shape\nparam n = 3\nlet petal = path(\"M 0 0 Q 1 1 2 0\")\nstart design = petal\n";

struct Read {
    Document document;
    Result<ShapeRules> rules;
};
Read read(const std::string& text, std::span<const DrawnRule> drawn = {}, const Scope* varying = nullptr) {
    Read result{document_of(std::string(head) + text), ShapeRules{}};
    static Scope globals;
    globals = read_settings(result.document)->globals;
    result.rules = read_shape_rules(result.document, globals, drawn, varying);
    return result;
}
std::string codes(const std::string& text, std::span<const DrawnRule> drawn = {}) {
    const Read result = read(text, drawn);
    return codes_of(result.rules.diagnostics(), result.document);
}

TEST(ShapeRules, FollowFromEachOther) {
    const Read result = read(
        "again = inverse(back)\nslide = petal -> empty\nback = inverse(slide)\nflip = mirror(angle: n * 15, rule: "
        "again)\n"
        "side = mirror(slide)\n");
    ASSERT_TRUE(result.rules) << codes_of(result.rules.diagnostics(), result.document);
    const std::vector<NamedShapeRule>& rules = result.rules->rules;
    ASSERT_EQ(rules.size(), 5U);
    EXPECT_EQ(rules[0].name, "again");
    EXPECT_EQ(rules[0].kind, Kind::inverse);
    EXPECT_EQ(rules[0].base, 2U);
    EXPECT_EQ(rules[1].kind, Kind::written);
    EXPECT_EQ(rules[1].statement->name.text, "slide");
    EXPECT_EQ(rules[2].base, 1U);
    EXPECT_EQ(rules[3].kind, Kind::mirror);
    EXPECT_EQ(rules[3].base, 0U);
    ASSERT_TRUE(rules[3].angle);
    EXPECT_FALSE(rules[4].angle);
    EXPECT_EQ(result.rules->in_order, (std::vector<std::size_t>{1, 2, 0, 3, 4}));
}

TEST(ShapeRules, DrawnOnesHaveNamesToo) {
    const DrawnRule drawn[] = {{"lobe", {0, 0, 1}}, {"twist", {0, 0, 1}}};
    const std::string text = "back = inverse(lobe)\nslide = petal -> empty\napply twist at (n, 3) angle n orbit\n";
    const Read result = read(text, drawn);
    ASSERT_TRUE(result.rules);
    ASSERT_EQ(result.rules->rules.size(), 4U);
    EXPECT_EQ(result.rules->rules[0].base, 2U);
    EXPECT_EQ(result.rules->rules[2].kind, Kind::drawn);
    EXPECT_EQ(result.rules->rules[2].statement, nullptr);
    ASSERT_EQ(result.rules->applies.size(), 1U);
    EXPECT_EQ(result.rules->applies[0].rule, 3U);
    EXPECT_TRUE(result.rules->applies[0].statement->is_orbit);
    EXPECT_EQ(result.rules->in_order, (std::vector<std::size_t>{2, 0, 1, 3}));
    EXPECT_EQ(codes(text), "language.unknown-rule@lobe\nlanguage.unknown-rule@twist\n");
    EXPECT_EQ(codes("lobe = petal -> empty\n", drawn), "language.doubled-name@g\n") << "at the file";
}

TEST(ShapeRules, SettingsAreCollected) {
    const Read result = read("steps n * 4\nshow points, labels\ntolerance 0.1mm\nmatch isometry\n");
    ASSERT_TRUE(result.rules);
    ASSERT_EQ(result.rules->settings.size(), 4U);
    EXPECT_EQ(result.rules->settings[1]->values.size(), 2U);
    EXPECT_EQ(codes("show points\nshow labels\n"), "language.repeated-statement@show\n");
}

TEST(ShapeRules, ExpressionsAreChecked) {
    EXPECT_EQ(
        codes("slide = petal -> translate(n, 2) * petal weight n - 1 priority 2 unless box(0, 0, n, 3) when n > 2"),
        "");
    EXPECT_EQ(codes("slide = petal -> one_of(petal, empty, n)"), "language.wrong-kind@n\n") << "each alternative";
    EXPECT_EQ(codes("slide = petal -> n > 5 ? rotate(90) : petal"), "language.wrong-kind@rotate(90)\n");
    EXPECT_EQ(codes("slide = petal -> empty weight 1..2 when one_of(true, false)"), "");
    EXPECT_EQ(codes("slide = petal -> empty weight step"), "language.unknown-name@step\n");
    EXPECT_EQ(codes("slide = petal -> empty weight area"), "language.unknown-name@area\n");
    EXPECT_EQ(codes("flip = mirror(slide, 3mm)\nslide = petal -> empty"), "language.wrong-kind@3mm\n");
    EXPECT_EQ(codes("steps 3mm"), "language.wrong-kind@3mm\n");
    EXPECT_EQ(codes("tolerance 0.1deg"), "language.wrong-kind@0.1deg\n");
}

// What an engine knows besides, as its steps.
TEST(ShapeRules, ConditionsMayKnowMore) {
    Scope step;
    step.names["step"] = number_value(1);
    const std::string text = "slide = petal -> empty weight 3 - step when step > 2\n";
    EXPECT_TRUE(read(text, {}, &step).rules);
    const Read deeper = read("slide = petal -> empty weight step - 3\n", {}, &step);
    EXPECT_EQ(codes_of(deeper.rules.diagnostics(), deeper.document), "") << "hangs on the value";
    const Read wrong = read("slide = petal -> empty when step + 2mm > 3deg\n", {}, &step);
    EXPECT_EQ(codes_of(wrong.rules.diagnostics(), wrong.document), "language.wrong-kind@step + 2mm > 3deg\n");
}

// Ways that lead into a circle are no circles.
TEST(ShapeRules, LongCirclesAreNoDanger) {
    std::string text = "r0 = inverse(r1)\n";
    for (int i = 1; i < 20000; ++i) {
        text += "r" + std::to_string(i) + " = inverse(r" + std::to_string((i + 1) % 20000) + ")\n";
    }
    EXPECT_EQ(codes(text + "side = inverse(r7)\n"), "language.rule-cycle@r0\n");
}

}  // namespace
}  // namespace filigree
