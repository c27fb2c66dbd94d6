#include "language/evaluate.h"

#include <limits>
#include <set>

#include "base/number_text.h"
#include "language/text_evaluation.h"

namespace filigree {
namespace {

class Evaluating : public testing::Test {
protected:
    Document px_document = document_of("unit px\n");
    Document mm_document = document_of("unit mm\n");
    Scope scope;
    Evaluation at;

    void SetUp() override {
        scope.names["gap"] = number_value(5);
        scope.names["width"] = length_value(200);
        scope.names["area"] = area_value(900);
        scope.names["turned"] = Value{Quantity{30, 0, true}, {}};
        scope.names["page.width"] = length_value(960);
        scope.names["dual"] = Value{true, {}};
        scope.names["name"] = Value{std::string("leaf"), {}};
        scope.names["ink"] = Value{ValueList{{Value{Colour{1, 2, 3, 255}, {}}, Value{Colour{4, 5, 6, 255}, {}}}}, {}};
        at.document = &px_document;
        at.scope = &scope;
        at.site = {7, Key{1}, "distance"};
    }
    std::string run(std::string_view text) { return evaluated(text, at); }
    std::string in_mm(std::string_view text) {
        Evaluation mm = at;
        mm.document = &mm_document;
        return evaluated(text, mm);
    }
    std::string kind(std::string_view text) {
        const Result<Value> value = evaluate(*expression_of(text), at);
        return value ? std::string(kind_of(*value)) : shown(value);
    }
};

TEST_F(Evaluating, Literals) {
    EXPECT_EQ(run("25"), "25");
    EXPECT_EQ(run("1in"), "96");
    EXPECT_EQ(run("25.4mm"), "96");
    EXPECT_EQ(run("2.54cm"), "96");
    EXPECT_EQ(run("0.0254m"), "96");
    EXPECT_EQ(run("72pt"), "96");
    EXPECT_EQ(run("40%"), "0.4");
    EXPECT_EQ(run("0.5turn"), "180deg");
    EXPECT_EQ(run("4GB"), "4000000000");
    EXPECT_EQ(run("true"), "true");
    EXPECT_EQ(run("\"a\\\"b\""), "\"a\\\"b\"");
    EXPECT_EQ(run("#a03"), "#aa0033");
    EXPECT_EQ(run("[1, 2, [3]]"), "[1, 2, [3]]");
    EXPECT_EQ(run("(1, 2in)"), "(1, 192)");
    EXPECT_EQ(run("page.width"), "960");
}

TEST_F(Evaluating, Arithmetic) {
    EXPECT_EQ(run("1 + 2 * 3 - 4 / 2"), "5");
    EXPECT_EQ(run("-gap + 1"), "-4");
    EXPECT_EQ(run("-0"), "0");
    EXPECT_EQ(run("(1, 2) + (3, 4) * 2"), "(7, 10)");
    EXPECT_EQ(run("-(1, 2) / 2"), "(-0.5, -1)");
    EXPECT_EQ(run("1 < 2 && 2 <= 2 && !(3 > 4)"), "true");
    EXPECT_EQ(run("1 == 1 || 1 / 0 > 1"), "true");
    EXPECT_EQ(run("1 != 1 && 1 / 0 > 1"), "false");
    EXPECT_EQ(run("gap > 3 ? 1 : 1 / 0"), "1");
    EXPECT_EQ(run("dual ? 1 : 2"), "1");
    EXPECT_EQ(run("0 ? 1 : 2"), "2");
    EXPECT_EQ(run("name == \"leaf\""), "true");
    EXPECT_EQ(run("ink(1) == #010203"), "true");
    EXPECT_EQ(run("25.4mm == 1in"), "true");
}

TEST_F(Evaluating, DimensionsFollowTheAlgebra) {
    EXPECT_EQ(kind("2 * width"), "a length");
    EXPECT_EQ(kind("width * width"), "an area");
    EXPECT_EQ(kind("width * width * width"), "a power of a length");
    EXPECT_EQ(kind("width / 10"), "a length");
    EXPECT_EQ(kind("width / 1mm"), "a number");
    EXPECT_EQ(kind("area / width"), "a length");
    EXPECT_EQ(kind("1 / width"), "a number per length");
    EXPECT_EQ(kind("sqrt(area)"), "a length");
    EXPECT_EQ(kind("pow(width, 2)"), "an area");
    EXPECT_EQ(kind("turned * 2"), "an angle");
    EXPECT_EQ(kind("turned / 2deg"), "a number");
    EXPECT_EQ(kind("atan2(width, 3)"), "an angle");
    EXPECT_EQ(kind("sin(turned)"), "a number");
    EXPECT_EQ(run("width + 10"), "210");
    EXPECT_EQ(run("10 + width"), "210");
    EXPECT_EQ(run("area > 40"), "true");
    EXPECT_EQ(run("turned + 15"), "45deg");
    EXPECT_EQ(run("width * turned"), "language.wrong-kind: cannot multiply a length by an angle");
    EXPECT_EQ(run("width + turned"), "language.wrong-kind: cannot add an angle to a length");
    EXPECT_EQ(run("area - width"), "language.wrong-kind: cannot subtract a length from an area");
    EXPECT_EQ(run("3 / turned"), "language.wrong-kind: cannot divide a number by an angle");
    EXPECT_EQ(run("width < turned"), "language.wrong-kind: cannot compare a length with an angle");
    EXPECT_EQ(run("name + 1"), "language.wrong-kind: cannot add a number to a text");
    EXPECT_EQ(run("sqrt(width)"), "language.wrong-kind: sqrt takes a number or an area, but this is a length");
}

TEST_F(Evaluating, BareNumbersAreInTheUnitOfTheirFile) {
    EXPECT_EQ(in_mm("1in + 25.4"), "192");
    EXPECT_EQ(in_mm("width > 52"), "true");   // 52mm are 196.5px
    EXPECT_EQ(in_mm("width > 53"), "false");  // 53mm are 200.3px
    EXPECT_EQ(in_mm("area < 63"), "false");   // 900px^2 are 63.004mm^2
    EXPECT_EQ(in_mm("area < 63.01"), "true");
    EXPECT_EQ(in_mm("(25.4, 0)"), "(96, 0)");
    EXPECT_EQ(in_mm("floor(12.3mm) == 12mm && ceil(12mm) == 12 && round(12.5mm) == 13mm"), "true");
    EXPECT_EQ(in_mm("max(25.4, 1in)"), "96");
    EXPECT_EQ(in_mm("(25.4..25.4) == 1in"), "true");
}

TEST(EvaluatingIncluded, ABareNumberKeepsTheUnitOfItsFile) {
    const Document document = document_of("include \"mm.fil\"\nunit px\n", {{"mm.fil", "unit mm\nlet gap = 25.4"}});
    ASSERT_EQ(document.units.size(), 2U);
    Scope scope;
    scope.names["gap"] = Value{Quantity{25.4, 0, false}, {1, 0, 0}};
    scope.names["count"] = number_value(25.4);
    Evaluation at;
    at.document = &document;
    at.scope = &scope;
    const auto px = [&](std::string_view text, std::uint32_t file = 0) {
        const Result<Value> value = evaluate(*expression_of(text, file), at);
        return to_text(*as_length(*value, document));
    };
    EXPECT_EQ(px("gap"), "96");
    EXPECT_EQ(px("gap * 2"), "192");
    EXPECT_EQ(px("2 * gap + 0"), "192");
    EXPECT_EQ(px("-gap"), "-96");
    EXPECT_EQ(px("max(gap, 1)"), "96");
    EXPECT_EQ(px("1px + gap"), "97");
    EXPECT_EQ(px("true ? gap : 1"), "96");
    EXPECT_EQ(px("one_of(gap, gap)"), "96");
    EXPECT_EQ(px("count"), "25.4");
    EXPECT_EQ(px("count", 1), "96");
    EXPECT_EQ(px("count * 2", 1), "192");
}

TEST_F(Evaluating, Functions) {
    EXPECT_EQ(run("min(3, 1, 2)"), "1");
    EXPECT_EQ(run("max(3, width / 40)"), "5");
    EXPECT_EQ(run("abs(-2)"), "2");
    EXPECT_EQ(run("floor(-1.5)"), "-2");
    EXPECT_EQ(run("ceil(-1.5)"), "-1");
    EXPECT_EQ(run("round(2.5)"), "3");
    EXPECT_EQ(run("sqrt(16)"), "4");
    EXPECT_EQ(run("mod(7, 3)"), "1");
    EXPECT_EQ(run("mod(-1, 3)"), "2");
    EXPECT_EQ(run("mod(7, -3)"), "-2");
    EXPECT_EQ(run("pow(2, 10)"), "1024");
    EXPECT_EQ(run("sin(30)"), "0.5");
    EXPECT_EQ(run("cos(60deg)"), "0.5");
    EXPECT_EQ(run("round(tan(45) * 1000000)"), "1000000");
    EXPECT_EQ(run("asin(1)"), "90deg");
    EXPECT_EQ(run("acos(1)"), "0deg");
    EXPECT_EQ(run("atan2(1, 1)"), "45deg");
    EXPECT_EQ(run("exp(0)"), "1");
    EXPECT_EQ(run("log(1)"), "0");
    EXPECT_EQ(run("hypot(3, 4)"), "5");
    EXPECT_EQ(run("hypot(3e300, 4e300) == 5e300"), "true");
    EXPECT_EQ(run("clamp(9, 1, 5)"), "5");
    EXPECT_EQ(run("lerp(10, 20, 25%)"), "12.5");
    EXPECT_EQ(run("ink(2)"), "#040506");
    EXPECT_EQ(run("ink(3)"), "#010203");
    EXPECT_EQ(run("ink(0)"), "#040506");
    EXPECT_EQ(run("ink(-1e15) == ink(2)"), "true");
}

TEST_F(Evaluating, WhatIsNotFiniteIsAnError) {
    for (const std::string_view text : {"1 / 0", "width / 0mm", "0 / 0", "mod(1, 0)", "1e308 * 10", "1e308 + 1e308",
                                        "sqrt(-1)", "log(0)", "exp(1000)", "asin(2)", "acos(-1.1)", "tan(90)",
                                        "pow(-8, 0.5)", "pow(0, -1)", "(1, 2) / 0", "1e308m", "-1e308..1e308"}) {
        EXPECT_EQ(run(text).substr(0, 20), "language.not-finite:") << text;
    }
    scope.names["nan"] = number_value(std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(run("nan"), "language.not-finite: this has no finite value");
}

TEST_F(Evaluating, UnknownNamesAreReportedWithTheNearest) {
    const Result<Value> value = evaluate(*expression_of("gpa + widht"), at);
    ASSERT_FALSE(value);
    ASSERT_EQ(value.diagnostics().size(), 2U);
    EXPECT_EQ(value.diagnostics()[0].code, "language.unknown-name");
    EXPECT_EQ(value.diagnostics()[0].hints, std::vector<std::string>{"did you mean 'gap'?"});
    EXPECT_EQ(value.diagnostics()[1].span, (SourceSpan{0, 6, 11}));
    EXPECT_EQ(run("index"),
              "language.unknown-name: 'index' differs from shape to shape and is known only inside each(...)");
    EXPECT_EQ(run("depth"), "language.unknown-name: 'depth' is not known here, only in rules and styles");
    EXPECT_EQ(run("max"), "language.unknown-name: 'max' is a function and needs its arguments");
    EXPECT_EQ(run("maxx(1, 2)"), "language.unknown-function: there is no function 'maxx'");
    EXPECT_EQ(run("gap(1)"), "language.unknown-function: 'gap' is a number and takes no arguments");
    EXPECT_EQ(run("max(1)"), "language.wrong-arguments: 'max' takes at least 2 arguments, but 1 is given");
    EXPECT_EQ(run("sin(1, 2)"), "language.wrong-arguments: 'sin' takes 1 argument, but 2 are given");
    EXPECT_EQ(run("ink(1.5)"), "language.out-of-range: the place in a list must be a whole number");
    EXPECT_EQ(run("sin(x: 1)"), "language.wrong-arguments: the arguments of 'sin' have no names");
    EXPECT_EQ(run("5 ? 1 : 2"),
              "language.out-of-range: true or false is needed here, but this is a number other than 0 and 1");
    EXPECT_EQ(run("width ? 1 : 2"), "language.wrong-kind: true or false is needed here, but this is a length");
    EXPECT_EQ(run("5 in 1..9"), "language.wrong-kind: 'in' keeps a normal(...) in a range low..high");
    EXPECT_EQ(run("9..5"), "language.empty-range: the low end of the range lies above its high end");
    EXPECT_EQ(run("1deg..5mm"), "language.wrong-kind: a range cannot go from an angle to a length");
    EXPECT_EQ(run("one_of(1: 0, 2: 0)"), "language.no-alternative: no alternative has a weight above zero");
    EXPECT_EQ(run("one_of(1: -1)"), "language.out-of-range: a weight cannot be below zero");
    EXPECT_EQ(run("normal(1, -1)"), "language.out-of-range: a deviation cannot be below zero");
    EXPECT_EQ(run("each(1)"), "language.each-outside: each(...) is known only in the arguments of a rule's operator");
}

TEST_F(Evaluating, WordsStandOnlyWhereTheResultMayComeFrom) {
    EXPECT_EQ(run("line").substr(0, 22), "language.unknown-name:");
    at.words = {"line", "wave", "gap"};
    EXPECT_EQ(run("line"), "line");
    EXPECT_EQ(run("gap"), "gap");
    EXPECT_EQ(run("gap > 3 ? line : wave"), "line");
    EXPECT_EQ(run("gap + 1"), "6");
    EXPECT_EQ(run("one_of(line: 1, wave: 0)"), "line");
    EXPECT_EQ(run("line + 1"), "language.unknown-name: the word 'line' cannot be part of a calculation");
    EXPECT_EQ(run("max(line, 1)"), "language.unknown-name: the word 'line' cannot be part of a calculation");
    const Result<Value> typo = evaluate(*expression_of("lnie"), at);
    EXPECT_EQ(typo.diagnostics()[0].hints, std::vector<std::string>{"did you mean 'line'?"});
}

TEST_F(Evaluating, CallsAreKeptWhereTheyAreExpected) {
    EXPECT_EQ(run("turn(30)"), "language.unknown-function: there is no function 'turn'");
    at.calls = {"turn"};
    EXPECT_EQ(run("turn(gap * 2)"), "turn(10)");
    EXPECT_EQ(run("turn(keep)").substr(0, 22), "language.unknown-name:");
    EXPECT_EQ(run("turn(30) + 1"), "language.unknown-function: 'turn' cannot be part of a calculation");
    EXPECT_EQ(run("other(30)"), "language.unknown-function: there is no function 'other'");
    at.calls = {"*"};
    EXPECT_EQ(run("file(\"leaf.svg\", id: \"hair\")"), "file(\"leaf.svg\", id: \"hair\")");
    EXPECT_EQ(run("host(fit: cover, gap: gap)"), "host(fit: cover, gap: 5)");
    EXPECT_EQ(run("rectangle(max(1, 2), width)"), "rectangle(2, 200)");
    EXPECT_EQ(run("a(b(c))"), "a(b(c))");
    EXPECT_EQ(run("cover").substr(0, 22), "language.unknown-name:");
}

TEST_F(Evaluating, EachUsesTheShapesScopeAndKey) {
    Scope shape;
    shape.names["index"] = number_value(3);
    at.shape_scope = &shape;
    at.shape_key = Key{99};
    EXPECT_EQ(run("each(index * gap)"), "15");
    EXPECT_EQ(run("gap + each(index)"), "8");
    EXPECT_EQ(run("index").substr(0, 22), "language.unknown-name:");
    // Inside it the shape's key draws, outside the step's.
    const std::string of_step = run("0..1"), of_shape = run("each(0..1)");
    EXPECT_NE(of_step, of_shape);
    at.shape_key = Key{100};
    EXPECT_EQ(run("0..1"), of_step);
    EXPECT_NE(run("each(0..1)"), of_shape);
    EXPECT_TRUE(varies_by_shape(*expression_of("1 + max(2, each(3))")));
    EXPECT_FALSE(varies_by_shape(*expression_of("1 + max(2, 3..4)")));
    EXPECT_TRUE(has_choice(*expression_of("[1, 2 > 1 ? 1..2 : 3]")));
    EXPECT_TRUE(has_choice(*expression_of("normal(1, 2) in 0..1")));
    EXPECT_FALSE(has_choice(*expression_of("max(1, 2)")));
}

// The k-th choice is drawn under the name "~k", whatever branch is taken.
TEST_F(Evaluating, ChoicesAreNumberedByTheirPlace) {
    const auto unit_of = [&](std::string_view name) {
        return to_text(to_unit(random_bits(at.site.seed, at.site.key, name)));
    };
    EXPECT_EQ(run("0..1"), unit_of("distance"));
    EXPECT_EQ(run("[0..1, 0..1]"), "[" + unit_of("distance") + ", " + unit_of("distance~2") + "]");
    EXPECT_EQ(run("true ? 0..1 : 0..1"), unit_of("distance"));
    EXPECT_EQ(run("false ? 0..1 : 0..1"), unit_of("distance~2"));
    EXPECT_EQ(run("[false ? [0..1, 0..1] : 3, 0..1]"), "[3, " + unit_of("distance~3") + "]");
    EXPECT_EQ(run("[true ? 3 : [0..1, 0..1], 0..1]"), "[3, " + unit_of("distance~3") + "]");
    EXPECT_EQ(run("[true || (0..1) > 2, 0..1]"), "[true, " + unit_of("distance~2") + "]");
    EXPECT_EQ(run("[false && (0..1) > 2, 0..1]"), "[false, " + unit_of("distance~2") + "]");
    EXPECT_EQ(run("[normal(0, 1) in -1..1, 0..1]").substr(run("[normal(0, 1) in -1..1, 0..1]").find(", ") + 2),
              unit_of("distance~2") + "]");
    EXPECT_EQ(run("[one_of(5..5: 1..1, 6: 0), 0..1]"), "[5, " + unit_of("distance~4") + "]");
}

TEST_F(Evaluating, WholeRangesHoldBothEnds) {
    at.whole = true;
    std::set<std::string> seen;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        at.site.seed = seed;
        seen.insert(run("5..9"));
    }
    EXPECT_EQ(seen, (std::set<std::string>{"5", "6", "7", "8", "9"}));
    EXPECT_EQ(run("4.5..5.5"), "5");
    EXPECT_EQ(run("4.1..4.9"), "language.empty-range: there is no whole number in this range");
    // Arguments of functions and conditions are numbers of their own.
    EXPECT_NE(run("floor((0..1) * 1000)"), "0");
    EXPECT_EQ(run("-(3..3) + 2 * (4..4)"), "5");
}

TEST_F(Evaluating, ANormalStaysInItsRange) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        at.site.seed = seed;
        const double inside =
            std::get<Quantity>(evaluate(*expression_of("normal(1, 0.2) in 0.6..1.6"), at)->data).value;
        EXPECT_TRUE(inside >= 0.6 && inside <= 1.6) << seed;
    }
    EXPECT_EQ(run("normal(1, 0) in 2..3"), "2");
    EXPECT_EQ(kind("normal(1mm, 0.2) in 0..1cm"), "a length");
    EXPECT_EQ(kind("normal(1, 0.2) in 0..1cm"), "a length");
    EXPECT_EQ(run("normal(1mm, 2deg)"), "language.wrong-kind: the deviation of a length cannot be an angle");
    EXPECT_EQ(run("normal(1deg, 2deg) in 0mm..3mm"),
              "language.wrong-kind: cannot keep an angle in a range of a length");
}

TEST_F(Evaluating, OneOfDrawsAmongTheItemsOfAList) {
    std::set<std::string> seen;
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        at.site.seed = seed;
        seen.insert(run("one_of(ink)"));
    }
    EXPECT_EQ(seen, (std::set<std::string>{"#010203", "#040506"}));
    EXPECT_EQ(run("one_of(ink, ink)"), "[#010203, #040506]");
    EXPECT_EQ(run("one_of([7])"), "7");
}

TEST_F(Evaluating, LongChainsAndDeepTreesAreNoDanger) {
    ExpressionPtr chain = expression_of("1");
    const ExpressionPtr one = chain;
    std::vector<ExpressionPtr> keep{chain};  // so that no destructor runs down the chain
    for (int i = 0; i < 100000; ++i) {
        chain = std::make_shared<Expression>(Expression{{0, 0, 1}, BinaryExpression{BinaryOperator::add, chain, one}});
        keep.push_back(chain);
    }
    EXPECT_EQ(shown(evaluate(*chain, at)), "100001");
    EXPECT_FALSE(has_choice(*chain));
    ExpressionPtr deep = one;
    for (int i = 0; i < 100000; ++i) {
        deep = std::make_shared<Expression>(Expression{{0, 0, 1}, UnaryExpression{UnaryOperator::negate, deep}});
        keep.push_back(deep);
    }
    EXPECT_EQ(shown(evaluate(*deep, at)), "language.too-deep: this expression is nested too deeply");
    EXPECT_FALSE(varies_by_shape(*deep));
    chain = deep = nullptr;
    while (!keep.empty()) keep.pop_back();
}

TEST(FunctionDescriptions, HoldEveryFunctionOnce) {
    std::set<std::string_view> signatures;
    for (const FunctionDescription& description : function_descriptions()) {
        EXPECT_TRUE(signatures.insert(description.signature).second);
        EXPECT_FALSE(description.help.empty());
        EXPECT_NE(description.help.back(), '.');
    }
    EXPECT_EQ(signatures.size(), 24U);
}

}  // namespace
}  // namespace filigree
