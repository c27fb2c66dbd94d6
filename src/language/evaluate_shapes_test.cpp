#include "base/test_cases.h"
#include "language/check.h"
#include "language/form_value.h"
#include "language/settings.h"
#include "language/shape_forms.h"
#include "language/text_evaluation.h"

namespace filigree {
namespace {

// Shapes by name, a number and a point.
class EvaluatingShapes : public testing::Test {
protected:
    EvaluatingShapes() {
        at.document = &document;
        for (const std::string name : {"petal", "lens", "bud"}) {
            globals.names[name] = Value{SymbolicCall{"path", {{{}, {"M " + name, {}}, {}}}}, {}};
        }
        globals.names["half"] = Value{SymbolicCall{"rotate", {{{}, number_value(180), {}}}}, {}};
        globals.names["n"] = number_value(3);
        globals.names["spot"] = Value{Vec{1, 2}, {}};
        at.scope = &globals;
        at = with_shapes(at);
    }
    // With the names of shapes instead of their paths.
    std::string run(std::string_view text) const {
        const ExpressionPtr expression = expression_of(text);
        const Diagnostics problems = check_expression(*expression, at);
        const Result<Value> value = evaluate(*expression, at);
        EXPECT_EQ(problems.empty(), bool(value)) << text << "\n" << codes_of(problems, document);
        std::string out = shown(value);
        for (const std::string name : {"petal", "lens", "bud"}) {
            const std::string path = "path(\"M " + name + "\")";
            for (std::size_t i; (i = out.find(path)) != std::string::npos;) out.replace(i, path.size(), name);
        }
        return out;
    }
    std::string hint(std::string_view text) const {
        const Result<Value> value = evaluate(*expression_of(text), at);
        return value || value.diagnostics().front().hints.empty() ? "" : value.diagnostics().front().hints.front();
    }
    SymbolicCall call(std::string_view text) const {
        return std::get<SymbolicCall>(evaluate(*expression_of(text), at)->data);
    }

    Document document = document_of("unit mm\n");
    Scope globals;
    Evaluation at;
};

TEST_F(EvaluatingShapes, OperationsStayCalls) {
    EXPECT_EQ(run("petal"), "petal");
    EXPECT_EQ(run("empty"), "empty");
    EXPECT_EQ(run("petal + lens"), "petal + lens");
    EXPECT_EQ(run("petal - lens & bud + empty"), "petal - lens & bud + empty");
    EXPECT_EQ(run("(petal - lens) & (bud + empty)"), "(petal - lens) & (bud + empty)");
    EXPECT_EQ(run("translate(-2, 2in) * petal"), "translate(-2, 192) * petal");
    EXPECT_EQ(run("translate(n - 1, 0) * rotate(30deg, (0, 0)) * (petal + lens)"),
              "translate(2, 0) * rotate(30deg, (0, 0)) * (petal + lens)");
    EXPECT_EQ(run("half * mirror(45)"), "rotate(180) * mirror(45)");
    EXPECT_EQ(run("half * petal + half * (half * lens)"), "rotate(180) * petal + rotate(180) * rotate(180) * lens");
    EXPECT_EQ(run("n > 2 ? petal : lens"), "petal");
    EXPECT_EQ(run("[petal, petal - lens]"), "[petal, petal - lens]");
    EXPECT_EQ(run("inside(petal + lens)"), "inside(petal + lens)");
    EXPECT_EQ(run("circle(n * 2, colour: red, weight: 2)"), "circle(6, colour: red, weight: 2)");
    EXPECT_EQ(run("1 + n * 2"), "7");
}

TEST_F(EvaluatingShapes, ChainsAreFlat) {
    const SymbolicCall sum = call("petal + lens + (bud + petal) + half * lens");
    EXPECT_EQ(sum.name, "+");
    ASSERT_EQ(sum.arguments.size(), 5U);
    EXPECT_EQ(to_text(sum.arguments[3].value), "path(\"M petal\")");
    const SymbolicCall difference = call("petal - lens - bud - (petal - lens)");
    ASSERT_EQ(difference.arguments.size(), 4U);
    EXPECT_EQ(run("petal - lens - bud - (petal - lens)"), "petal - lens - bud - (petal - lens)");
    EXPECT_EQ(run("petal - (lens + bud)"), "petal - (lens + bud)");
    EXPECT_EQ(run("petal - lens + bud"), "petal - lens + bud");
    EXPECT_EQ(run("petal & (half * lens)"), "petal & (rotate(180) * lens)");
    EXPECT_EQ(run("half * petal & lens"), "rotate(180) * petal & lens");
    EXPECT_EQ(call("half * half * petal").arguments.size(), 3U);
}

TEST_F(EvaluatingShapes, KindsAreTold) {
    const auto kind = [&](std::string_view text) { return shape_kind(*evaluate(*expression_of(text), at)); };
    EXPECT_EQ(kind("petal"), ShapeKind::shape);
    EXPECT_EQ(kind("empty"), ShapeKind::shape);
    EXPECT_EQ(kind("half"), ShapeKind::transform);
    EXPECT_EQ(kind("half * half"), ShapeKind::transform);
    EXPECT_EQ(kind("half * half * petal"), ShapeKind::shape);
    EXPECT_EQ(kind("box(0, 0, 1, 1)"), ShapeKind::region);
    EXPECT_EQ(kind("n"), std::nullopt);
    EXPECT_EQ(shape_kind(Value{SymbolicCall{"star", {}}, {}}), std::nullopt);
    EXPECT_EQ(kind_of(*evaluate(*expression_of("petal + lens"), at)), "a shape");
}

TEST_F(EvaluatingShapes, WhatCannotBeJoinedIsTold) {
    EXPECT_EQ(run("2 * petal"), "language.wrong-kind: cannot multiply a number by a shape");
    EXPECT_EQ(hint("2 * petal"), "a shape is made larger or smaller by 'scale(2) * shape'");
    EXPECT_EQ(hint("petal / 2"), "a shape is made larger or smaller by 'scale(2) * shape'");
    EXPECT_EQ(run("petal * half"), "language.wrong-kind: cannot multiply a shape by a transform");
    EXPECT_EQ(hint("petal * half"), "a transform stands before its shape");
    EXPECT_EQ(run("petal * lens"), "language.wrong-kind: cannot multiply a shape by a shape");
    EXPECT_EQ(hint("petal * lens"), "what two shapes have in common is written 'a & b'");
    EXPECT_EQ(run("petal + n"), "language.wrong-kind: cannot add a number to a shape");
    EXPECT_EQ(run("petal + half"), "language.wrong-kind: cannot add a transform to a shape");
    EXPECT_EQ(hint("petal + half"), "a transform is applied by '*', as in 'rotate(90) * shape'");
    EXPECT_EQ(hint("petal + spot"), "a shape is moved by 'translate(2, 2) * shape'");
    EXPECT_EQ(run("petal & box(0, 0, 1, 1)"), "language.wrong-kind: cannot intersect a shape with a region");
    EXPECT_EQ(run("half * box(0, 0, 1, 1)"), "language.wrong-kind: cannot multiply a transform by a region");
    EXPECT_EQ(run("petal == lens"), "language.wrong-kind: cannot compare a shape with a shape");
    EXPECT_EQ(run("-petal"), "language.wrong-kind: a shape cannot be negated");
    EXPECT_EQ(run("-circle(3)"), "language.wrong-kind: a shape cannot be negated");
    EXPECT_EQ(run("petal + petl"), "language.unknown-name: there is no name 'petl'");
    EXPECT_EQ(hint("petal + petl"), "did you mean 'petal'?");
    EXPECT_EQ(run("petal + cirle(3)"), "language.unknown-function: there is no function 'cirle'");
    EXPECT_EQ(hint("petal + cirle(3)"), "did you mean 'circle'?");
    EXPECT_EQ(run("max(circle(3), 2)"), "language.unknown-function: 'circle' cannot be part of a calculation");
    EXPECT_EQ(run("circle(radius)"), "language.unknown-name: there is no name 'radius'");
    EXPECT_EQ(run("n & n"), "language.wrong-kind: '&' is the product of shapes, but this is a number");
}

// A sum as an expression, leaning to the left.
ExpressionPtr chain(std::size_t count, bool alternates, std::vector<ExpressionPtr>& keep) {
    const ExpressionPtr petal = expression_of("petal");
    ExpressionPtr sum = petal;
    for (std::size_t i = 1; i < count; ++i) {
        const BinaryOperator op = alternates && i % 2 == 0 ? BinaryOperator::subtract : BinaryOperator::add;
        sum = std::make_shared<Expression>(Expression{{0, 0, 1}, BinaryExpression{op, sum, petal}});
        keep.push_back(sum);  // so that no destructor runs down the chain
    }
    return sum;
}

TEST_F(EvaluatingShapes, LongChainsAreNoDanger) {
    std::vector<ExpressionPtr> keep;
    const Result<Value> sum = evaluate(*chain(10000, false, keep), at);
    ASSERT_TRUE(sum);
    EXPECT_EQ(std::get<SymbolicCall>(sum->data).arguments.size(), 10000U);
    EXPECT_EQ(size_of(*sum).depth, 3U);
    const Value copy = *sum;
    EXPECT_EQ(copy, *sum);
    EXPECT_EQ(to_text(copy).size(), 10000 * std::string("path(\"M petal\") + ").size() - 3);
    EXPECT_TRUE(evaluate(*chain(400, true, keep), at));
    EXPECT_EQ(shown(evaluate(*chain(10000, true, keep), at)), "language.too-deep: this shape is nested too deeply");
    while (!keep.empty()) keep.pop_back();
}

// A shape at random, or a transform, with brackets where chance puts them.
std::string random_shape(CaseRandom& random, int depth, bool is_transform) {
    const auto shape = [&] { return random_shape(random, depth - 1, false); };
    const auto transform = [&] { return random_shape(random, depth - 1, true); };
    const auto bracketed = [&](const std::string& text) { return random.below(2) == 0 ? "(" + text + ")" : text; };
    if (depth <= 0) {
        constexpr std::string_view shapes[] = {"petal", "empty", "circle(3)"}, transforms[] = {"half", "scale(2)"};
        return std::string(is_transform ? transforms[random.below(2)] : shapes[random.below(3)]);
    }
    if (is_transform) return bracketed(transform() + " * " + bracketed(transform()));
    constexpr std::string_view signs[] = {" + ", " - "};
    switch (random.below(4)) {
        case 0:
            return "(" + transform() + ") * (" + shape() + ")";
        case 1:
            return "(" + shape() + ") & (" + shape() + ")";
        default: {
            const std::string left = bracketed(shape());
            return left + std::string(signs[random.below(2)]) + bracketed(shape());
        }
    }
}

TEST_F(EvaluatingShapes, TheirTextsSayTheSame) {
    std::size_t longest = 0;
    const std::uint64_t cases = case_count(1000);
    for (std::uint64_t seed = 0; seed < cases; ++seed) {
        CaseRandom random(seed);
        const std::string text = random_shape(random, 4, false);
        const Result<Value> value = evaluate(*expression_of(text), at);
        ASSERT_TRUE(value) << "seed " << seed << " " << text;
        const Result<Value> again = evaluate(*expression_of(to_text(*value)), at);
        ASSERT_TRUE(again) << "seed " << seed << " " << to_text(*value);
        ASSERT_EQ(*again, *value) << "seed " << seed << " " << text << "\n" << to_text(*value);
        longest = std::max(longest, std::get_if<SymbolicCall>(&value->data)->arguments.size());
    }
    EXPECT_GE(longest, 5U);
}

std::string settings_problem(const std::string& lets) {
    const Document document = document_of("grammar shape\n" + lets);
    const Result<Settings> settings = read_settings(document);
    return settings ? "" : settings.diagnostics().front().code;
}

// A let that doubles another one would be of any size soon, and one inside another of any depth.
TEST(LetsOfShapes, AreBounded) {
    std::string doubles = "let a0 = circle(5)\n", nested = doubles, long_sum = doubles;
    for (int i = 1; i < 40; ++i) {
        const std::string last = "a" + std::to_string(i - 1), next = "let a" + std::to_string(i) + " = ";
        doubles += next + last + " + translate(1, 1) * " + last + "\n";
    }
    for (int i = 1; i < 1000; ++i) {
        const std::string last = "a" + std::to_string(i - 1), next = "let a" + std::to_string(i) + " = ";
        nested += next + "a0 - " + last + "\n";
        long_sum += next + "a0 + " + last + "\n";
    }
    EXPECT_EQ(settings_problem(doubles), "language.large-shape");
    EXPECT_EQ(settings_problem(nested), "language.too-deep");
    EXPECT_EQ(settings_problem(long_sum), "");
}

TEST(LetsOfShapes, HoldThemInShapeGrammarsAlone) {
    const Document document = document_of(
        "grammar shape\nparam r = 5\nlet petal = path(\"M 0 0 Q 1 1 2 0\", weight: 2)\n"
        "let ring = circle(r) - translate(1, r) * petal\nlet many = [petal, ring]\nlet other = many(1) + empty\n"
        "let one = one_of(petal, ring)\nlet sides = polygon(3..8, 5)\n");
    const Result<Settings> settings = read_settings(document);
    ASSERT_TRUE(settings) << codes_of(settings.diagnostics(), document);
    const auto value = [&](std::string_view name) { return to_text(*settings->globals.find(name)); };
    EXPECT_EQ(value("ring"), "circle(5) - translate(1, 5) * path(\"M 0 0 Q 1 1 2 0\", weight: 2)");
    EXPECT_EQ(value("other"), "path(\"M 0 0 Q 1 1 2 0\", weight: 2) + empty");
    EXPECT_TRUE(value("one") == value("petal") || value("one") == value("ring"));
    EXPECT_EQ(value("sides").size(), std::string("polygon(3, 5)").size()) << "sides are whole";
    EXPECT_EQ(settings_problem("let petal = pat(\"M 0 0\")"), "language.unknown-function");
    EXPECT_EQ(settings_problem("param petal = circle(5)"), "language.unknown-function");
    EXPECT_EQ(settings_problem("let empty = circle(5)"), "language.reserved-name");
    const Document tangle = document_of("grammar tangle\nlet petal = path(\"M 0 0 Q 1 1 2 0\")\n");
    EXPECT_FALSE(read_settings(tangle));
}

// --- descriptions -------------------------------------------------------------------------------------------------

std::string bound(const std::vector<OperatorDescription>& forms, std::string_view text) {
    const Document document = document_of("unit mm\n");
    Evaluation at;
    at.document = &document;
    const Value value = *evaluate(*expression_of(text), with_shapes(at));
    return shown(to_form({.name = "shape", .type = ParameterType::form, .forms = &forms}, value, document, {}));
}

TEST(ShapeForms, AreBound) {
    EXPECT_EQ(bound(drawn_shapes(), "circle(1in, colour: red)"),
              "circle(radius: 96, centre: (0, 0), weight: 1, colour: #ff0000)");
    EXPECT_EQ(bound(drawn_shapes(), "point((0, 0), \"tip\")"),
              "point(at: (0, 0), label: \"tip\", weight: 1, colour: #000000)");
    EXPECT_EQ(bound(drawn_shapes(), "polyline((0, 0), (0mm, 1in), (1in, 0), weight: 2)"),
              "polyline(points: [(0, 0), (0, 96), (96, 0)], weight: 2, colour: #000000)");
    EXPECT_EQ(bound(drawn_shapes(), "polyline(points: [(0, 0), (0mm, 1in)])"),
              "polyline(points: [(0, 0), (0, 96)], weight: 1, colour: #000000)");
    EXPECT_EQ(bound(drawn_shapes(), "polyline()"), "language.missing-argument: 'polyline' needs 'points', a point");
    EXPECT_EQ(bound(drawn_shapes(), "polyline((0, 0), 3)"),
              "language.wrong-kind: 'points' must be a point, but this is a number");
    EXPECT_EQ(bound(drawn_shapes(), "circle(-1)"),
              "language.out-of-range: 'radius' must be from 1e-9px to 1073741824px, but this is -3.779527559055118px");
    EXPECT_EQ(bound(shape_transforms(), "rotate(0.25turn, (1in, 0))"), "rotate(angle: 90deg, about: (96, 0))");
    EXPECT_EQ(bound(shape_transforms(), "scale(2)"), "scale(factor: 2, about: (0, 0))");
    EXPECT_EQ(bound(shape_regions(), "inside(circle(1) + empty)"), "inside(shape: circle(1) + empty)");
}

TEST(ShapeForms, AreDescribedInFull) {
    for (const auto* forms : {&drawn_shapes(), &shape_transforms(), &shape_regions(), &rule_derivations()}) {
        for (const OperatorDescription& form : *forms) {
            EXPECT_FALSE(form.help.empty() || form.help.back() == '.') << form.name;
            EXPECT_NE(form.example.find(std::string(form.name) + "("), std::string_view::npos) << form.name;
            const std::string text =
                "grammar shape\nlet lens = circle(1); let petal = lens\n" + std::string(form.example);
            EXPECT_TRUE(parse_document("a.fil", text, {}).diagnostics.empty()) << form.example;
            for (const ParameterDescription& parameter : form.parameters) {
                EXPECT_FALSE(parameter.help.empty() || parameter.help.back() == '.') << parameter.name;
            }
        }
    }
}

}  // namespace
}  // namespace filigree
