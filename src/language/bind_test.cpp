#include "language/bind.h"

#include <set>

#include "language/check.h"
#include "language/names.h"
#include "language/text_evaluation.h"

namespace filigree {
namespace {

using enum ParameterType;

const OperatorDescription place = {
    .name = "place",
    .parameters =
        {{.name = "shape", .type = word, .default_text = "disc", .words = {"disc", "blob", "star"}},
         {.name = "size", .type = length, .low = 0.1, .high = 1000},
         {.name = "spacing", .type = length, .default_text = "size * 1.5", .low = 0.1, .high = 10000},
         {.name = "sides", .type = whole, .default_text = "5", .low = 3, .high = 60},
         {.name = "angle", .type = direction, .default_text = "keep", .words = {"keep", "random"}, .calls = {"turn"}},
         {.name = "centred", .type = flag, .default_text = "false", .aliases = {"centered"}}},
};
const OperatorDescription split = {
    .name = "regular_split",
    .parameters = {{.name = "curve", .type = word, .default_text = "line", .words = {"line", "wave", "circ"}},
                   {.name = "offset", .type = lengths, .low = 0},
                   {.name = "dual", .type = flag, .default_text = "false"},
                   {.name = "phase", .type = angle, .default_text = "0", .low = -360, .high = 360},
                   {.name = "amount", .type = real, .default_text = "0.5", .low = 0, .high = 1},
                   {.name = "note", .type = text, .default_text = "\"none\""},
                   {.name = "centre", .type = point, .default_text = "(0, 0)"},
                   {.name = "ink", .type = colour, .default_text = "black"}},
};

StepChoices with_seed(std::uint64_t seed) {
    StepChoices choices;
    choices.seed.value = seed;
    return choices;
}

class Binding : public testing::Test {
protected:
    Document document = document_of("unit px\n");
    Scope globals, step;
    std::vector<ShapeContext> shapes;

    void SetUp() override {
        globals.names["gap"] = number_value(12);
        globals.names["kind"] = Value{Symbol{"wave"}, {}};
        globals.names["inks"] = Value{ValueList{{Value{Colour{1, 2, 3, 255}, {}}}}, {}};
        step.outer = &globals;
        for (const std::string_view name : step_names()) step.names[std::string(name)] = number_value(2);
        step.names["width"] = length_value(80);
        step.names["area"] = area_value(6400);
        for (int i = 0; i < 3; ++i) {
            ShapeContext shape{Key{static_cast<std::uint64_t>(100 + i)}, {}};
            for (const std::string_view name : shape_names())
                shape.scope.names[std::string(name)] = number_value(i + 1);
            shapes.push_back(shape);
        }
    }
    // Parses "op(arguments)" into its arguments.
    static std::vector<CallArgument> arguments_of(const std::string& text) {
        return std::get<CallExpression>(expression_of("f(" + text + ")")->node).arguments;
    }
    Result<BoundCall> bound(const OperatorDescription& description, const std::string& text) {
        const auto end = static_cast<std::uint32_t>(text.size() + 3);
        return bind(description, arguments_of(text), {0, 0, end}, document, globals);
    }
    // "shape=disc size=20 ..." of the arguments that are not at their default, or the diagnostics.
    std::string run(const OperatorDescription& description, const std::string& text, std::uint64_t seed = 1) {
        document = document_of("unit px\n");
        const Result<BoundCall> call = bound(description, text);
        if (!call) return problems(call.diagnostics(), "f(" + text + ")");
        const Result<Arguments> arguments = evaluate_arguments(*call, document, step, with_seed(seed), Key{5}, shapes);
        if (!arguments) return problems(arguments.diagnostics(), "f(" + text + ")");
        std::string out;
        for (std::size_t i = 0; i < description.parameters.size(); ++i) {
            if (!call->given[i]) continue;
            out += (out.empty() ? "" : " ") + std::string(description.parameters[i].name) + "=";
            const ArgumentValue& value = arguments->values[i];
            if (value.per_shape.empty()) out += to_text(value.common);
            for (const Value& one : value.per_shape) out += (&one == &value.per_shape[0] ? "" : "|") + to_text(one);
        }
        return out;
    }
    static std::string problems(const Diagnostics& diagnostics, const std::string& text) {
        std::string out;
        for (const Diagnostic& one : diagnostics) {
            EXPECT_EQ(one.span.file, 0U) << one.message;
            if (!out.empty()) out += "; ";
            out += one.code.substr(9) + "@" + text.substr(one.span.begin, one.span.end - one.span.begin);
        }
        return out;
    }
};

TEST_F(Binding, PositionalArgumentsSkipWhatCannotTakeThem) {
    EXPECT_EQ(run(place, "20, 25"), "size=20 spacing=25");
    EXPECT_EQ(run(place, "blob, 20, 25"), "shape=blob size=20 spacing=25");
    EXPECT_EQ(run(place, "blob, size: 20, gap"), "shape=blob size=20 spacing=12");
    EXPECT_EQ(run(place, "20, true"), "size=20 centred=true");
    EXPECT_EQ(run(place, "20, random"), "size=20 angle=random");
    EXPECT_EQ(run(place, "20, turn(30)"), "size=20 angle=turn(30deg)");
    EXPECT_EQ(run(place, "20, 30deg"), "size=20 angle=30deg");
    EXPECT_EQ(run(place, "20, centered"), "size=20 centred=true");
    EXPECT_EQ(run(place, "20, 25, 2.5"), "size=20 spacing=25 angle=2.5deg");
    EXPECT_EQ(run(place, "one_of(blob, star: 0), 20").substr(0, 10), "shape=blob");
    EXPECT_EQ(run(split, "line, 90, 1"), "curve=line offset=[90] dual=true");
    EXPECT_EQ(run(split, "90, 0"), "offset=[90] dual=false");
    EXPECT_EQ(run(split, "90, 45"), "offset=[90] phase=45deg");
    EXPECT_EQ(run(split, "90, dual"), "offset=[90] dual=true");
    EXPECT_EQ(run(split, "90, count > 1"), "offset=[90] dual=true");
    EXPECT_EQ(run(split, "kind, [10, 20, 1in]"), "curve=wave offset=[10, 20, 96]");
    EXPECT_EQ(run(split, "90, \"x\", (1, 2), red"), "offset=[90] note=\"x\" centre=(1, 2) ink=#ff0000");
    EXPECT_EQ(run(split, "90, inks(1)"), "offset=[90] ink=#010203");
    EXPECT_EQ(run(split, "90, one_of(inks)"), "offset=[90] ink=#010203");
    EXPECT_EQ(run(split, "width / 4"), "offset=[20]");
    EXPECT_EQ(run(split, "offset: 9, wave"), "curve=wave offset=[9]");
}

TEST_F(Binding, WhatIsWrongIsReportedWhereItIs) {
    EXPECT_EQ(run(place, ""), "missing-argument@f()");
    EXPECT_EQ(run(place, "blbo, 20"), "unknown-name@blbo");
    EXPECT_EQ(run(place, "20, size: 30, size: 40, spcing: 3"), "doubled-argument@size; unknown-argument@spcing");
    EXPECT_EQ(run(place, "disc, 1, 2, 3, keep, true, 9"), "surplus-argument@9");
    EXPECT_EQ(run(place, "\"x\""), "wrong-kind@\"x\"");
    EXPECT_EQ(run(place, "0"), "out-of-range@0");
    EXPECT_EQ(run(place, "20, sides: 2.5"), "out-of-range@2.5");
    EXPECT_EQ(run(place, "20, sides: 2"), "out-of-range@2");
    EXPECT_EQ(run(place, "size: 30deg"), "wrong-kind@30deg");
    EXPECT_EQ(run(place, "size: gpa, sides: width"), "unknown-name@gpa; wrong-kind@width");
    EXPECT_EQ(run(place, "size: count > 1 ? 3 : 1 / count + foo"), "unknown-name@foo");
    EXPECT_EQ(run(place, "size: count > 1 ? 3 : 30deg"), "wrong-kind@30deg");
    EXPECT_EQ(run(place, "size: 0..9"), "out-of-range@0");
    EXPECT_EQ(run(place, "size: 9..5"), "empty-range@9..5");
    EXPECT_EQ(run(place, "size: one_of(5, 0)"), "out-of-range@0");
    EXPECT_EQ(run(place, "size: each(index - 1)"), "out-of-range@each(index - 1)");
    EXPECT_EQ(run(place, "size: index"), "unknown-name@index");
    EXPECT_EQ(run(place, "20, shape: wave"), "unknown-name@wave");
    EXPECT_EQ(run(place, "20, shape: kind"), "wrong-kind@kind");
    EXPECT_EQ(run(place, "20, angle: turn(1, 2)"), "wrong-arguments@turn(1, 2)");
    EXPECT_EQ(run(place, "20, angle: spin(1)"), "unknown-function@spin");
    EXPECT_EQ(run(split, "0"), "out-of-range@0");
    EXPECT_EQ(run(split, "[1, 0]"), "out-of-range@[1, 0]");
    EXPECT_EQ(run(split, "[]"), "wrong-kind@[]");
    EXPECT_EQ(run(split, "9, amount: 2"), "out-of-range@2");
    EXPECT_EQ(run(split, "9, amount: width / 8"), "wrong-kind@width / 8");
    EXPECT_EQ(run(split, "9, dual: 2"), "out-of-range@2");
    EXPECT_EQ(run(split, "9, ink: rde"), "unknown-name@rde");
    EXPECT_EQ(run(split, "9, 1: 2"), "wrong-arguments@1");
    EXPECT_EQ(run(split, "1 / 0"), "not-finite@1 / 0");
    EXPECT_EQ(run(split, "1 / (count - 2)"), "not-finite@1 / (count - 2)");
}

TEST_F(Binding, MessagesNameWhatIsAllowed) {
    const auto message = [&](const std::string& text) {
        const Result<BoundCall> call = bound(place, text);
        return call ? "" : call.diagnostics()[0].message;
    };
    EXPECT_EQ(message("0"), "'size' must be from 0.1px to 1000px, but this is 0px");
    EXPECT_EQ(message("20, sides: 99"), "'sides' must be from 3 to 60, but this is 99");
    EXPECT_EQ(message("20, sides: 3.5"), "'sides' must be a whole number, but this is 3.5");
    EXPECT_EQ(message("size: \"a\""), "'size' must be a length, but this is a text");
    EXPECT_EQ(message(""), "'place' needs 'size', a length");
    const Result<BoundCall> unknown = bound(place, "20, spcing: 3");
    EXPECT_EQ(unknown.diagnostics()[0].hints, std::vector<std::string>{"did you mean 'spacing'?"});
    const Result<BoundCall> typo = bound(place, "satr, 20");
    EXPECT_EQ(typo.diagnostics()[0].hints, std::vector<std::string>{"did you mean 'star'?"});
}

TEST_F(Binding, DefaultsKnowTheParametersBeforeThemAndNothingOfTheDocument) {
    document = document_of("unit mm\n");
    globals.names["size"] = number_value(999);
    const Result<BoundCall> call = bound(place, "10");
    ASSERT_TRUE(call);
    const Result<Arguments> arguments = evaluate_arguments(*call, document, step, with_seed(1), Key{5}, {});
    ASSERT_TRUE(arguments);
    EXPECT_DOUBLE_EQ(arguments->number("size"), 10 * 96 / 25.4);
    EXPECT_DOUBLE_EQ(arguments->number("spacing"), 15 * 96 / 25.4);
    EXPECT_EQ(arguments->number("sides"), 5);
    EXPECT_EQ(arguments->word("shape"), "disc");
    EXPECT_EQ(arguments->word("angle"), "keep");
    EXPECT_FALSE(arguments->flag("centred"));
    const Result<BoundCall> cut = bound(split, "[1, 2]");
    ASSERT_TRUE(cut);
    const Result<Arguments> values = evaluate_arguments(*cut, document, step, with_seed(1), Key{5}, {});
    EXPECT_EQ(values->lengths("offset").size(), 2U);
    EXPECT_EQ(std::get<Colour>(values->value("ink").data), (Colour{0, 0, 0, 255}));
}

TEST_F(Binding, ADefaultThatUsesWhatVariesVariesToo) {
    const Result<BoundCall> call = bound(place, "size: each(index * 10)");
    ASSERT_TRUE(call);
    const Result<Arguments> arguments = evaluate_arguments(*call, document, step, with_seed(1), Key{5}, shapes);
    ASSERT_TRUE(arguments);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(arguments->number("size", i), 10.0 * static_cast<double>(i + 1));
        EXPECT_EQ(arguments->number("spacing", i), 15.0 * static_cast<double>(i + 1));
        EXPECT_EQ(arguments->number("sides", i), 5);
    }
    const Result<Arguments> nothing = evaluate_arguments(*call, document, step, with_seed(1), Key{5}, {});
    ASSERT_TRUE(nothing);
    EXPECT_GE(nothing->number("size"), 0.1);
}

TEST_F(Binding, ChoicesAreDrawnAtTheStepOrTheShape) {
    std::set<std::string> steps, of_shapes;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        steps.insert(run(place, "5..9", seed));
        of_shapes.insert(run(place, "each(5..9)", seed));
    }
    EXPECT_EQ(steps.size(), 20U);
    EXPECT_EQ(of_shapes.size(), 20U);
    EXPECT_EQ(run(place, "5..9", 3), run(place, "5..9", 3));
    // Another argument's choice changes nothing.
    EXPECT_EQ(run(place, "5..9, sides: 3..9", 3).substr(0, 12), run(place, "5..9", 3).substr(0, 12));
}

TEST_F(Binding, ConstantsAreEvaluatedOnce) {
    const Result<BoundCall> call = bound(place, "gap * 2, 3..4, sides: count + 3");
    ASSERT_TRUE(call);
    EXPECT_TRUE(call->constants[0]);
    EXPECT_TRUE(call->constants[1]);
    EXPECT_FALSE(call->constants[2]);
    EXPECT_FALSE(call->constants[3]);
    EXPECT_TRUE(call->constants[4]);
}

TEST_F(Binding, RulesConditionsAndWeightsAreCheckedBefore) {
    const auto code = [](const Diagnostics& diagnostics) {
        return diagnostics.empty() ? std::string() : diagnostics[0].code;
    };
    const auto when = [&](std::string_view text) {
        return code(check_condition(*expression_of(text), document, globals));
    };
    EXPECT_EQ(when("area > 40 && count < 3"), "");
    EXPECT_EQ(when("1 / (count - 5) > 2"), "");
    EXPECT_EQ(when("aera > 40"), "language.unknown-name");
    EXPECT_EQ(when("true || aera > 40"), "language.unknown-name");
    EXPECT_EQ(when("area > 30deg"), "language.wrong-kind");
    EXPECT_EQ(when("width"), "language.wrong-kind");
    EXPECT_EQ(when("count"), "");  // 0 or 1 is for the step to see
    EXPECT_EQ(when("7"), "language.out-of-range");
    EXPECT_EQ(when("1 / 0 > 1"), "language.not-finite");
    EXPECT_EQ(when("index > 1"), "language.unknown-name");
    EXPECT_EQ(when("each(index > 1)"), "language.each-outside");
    const auto weight = [&](std::string_view text) {
        return code(check_weight(*expression_of(text), document, globals));
    };
    EXPECT_EQ(weight("3 + count"), "");
    EXPECT_EQ(weight("-1"), "language.out-of-range");
    EXPECT_EQ(weight("width"), "language.wrong-kind");
    EXPECT_EQ(weight("width / gap / 1px"), "");
}

TEST_F(Binding, ValuesOfAnyKindAreTakenAsTheyAre) {
    const OperatorDescription lace = {
        .name = "lace",
        .parameters = {{.name = "motif", .type = any},
                       {.name = "size", .type = any, .default_text = "motif"},
                       {.name = "note", .type = any, .default_text = "none"}},
    };
    const auto values = [&](const std::string& text) {
        const Result<BoundCall> call = bound(lace, text);
        if (!call) return problems(call.diagnostics(), "f(" + text + ")");
        const Result<Arguments> arguments = evaluate_arguments(*call, document, step, with_seed(1), Key{5}, shapes);
        if (!arguments) return problems(arguments.diagnostics(), "f(" + text + ")");
        return to_text(arguments->value("motif")) + " " + to_text(arguments->value("size")) + " " +
               to_text(arguments->value("note"));
    };
    EXPECT_EQ(values("3, 2deg"), "3 2deg none");
    EXPECT_EQ(values("star"), "star star none") << "a word, and a default that is an earlier parameter";
    EXPECT_EQ(values("gap, note: [1, \"x\", wave]"), "12 12 [1, \"x\", wave]");
    EXPECT_EQ(values("kind, area"), "wave 6400 none") << "names go before words";
    EXPECT_EQ(values("inks(1), count > 1 ? star : disc"), "#010203 star none");
    EXPECT_EQ(values("star + 1"), "unknown-name@star");
    EXPECT_EQ(values("star(1)"), "unknown-function@star");
    EXPECT_EQ(values("1 / (count - 5)"), "-0.3333333333333333 -0.3333333333333333 none");
    // Bare numbers keep their place, which says their unit.
    const Result<BoundCall> call = bound(lace, "3");
    ASSERT_TRUE(call && call->constants[0] && !call->constants[1] && call->constants[2]);
    EXPECT_EQ(call->constants[0]->span, (SourceSpan{0, 2, 3}));
    const Result<BoundCall> of_step = bound(lace, "area");
    EXPECT_FALSE(of_step->constants[0]) << "what a step knows is no word";
}

TEST_F(Binding, NamesInBetweenVaryFromStepToStep) {
    Scope macro{&globals};
    macro.names["wish"] = number_value(30);
    macro.names["gap"] = length_value(30);  // hides the global
    macro.names["motif"] = Value{Symbol{"star"}, {}};
    macro.names["colours"] = Value{ValueList{{Value{Colour{9, 9, 9, 255}, {}}}}, {}};
    macro.names["red"] = Value{Colour{1, 2, 3, 255}, {}};
    const auto bound_in = [&](const OperatorDescription& description, const std::string& text) {
        const auto end = static_cast<std::uint32_t>(text.size() + 3);
        return bind(description, arguments_of(text), {0, 0, end}, document, globals, &macro);
    };
    const Result<BoundCall> call = bound_in(place, "motif, wish, gap, sides: 7");
    ASSERT_TRUE(call) << problems(call.diagnostics(), "f(motif, wish, gap, sides: 7)");
    EXPECT_FALSE(call->constants[0] || call->constants[1] || call->constants[2]);
    EXPECT_TRUE(call->constants[3]);
    Scope around{&globals};
    around.names["wish"] = number_value(40);
    around.names["gap"] = number_value(50);
    around.names["motif"] = Value{Symbol{"blob"}, {}};
    step.outer = &around;
    const Result<Arguments> arguments = evaluate_arguments(*call, document, step, with_seed(1), Key{5}, {});
    ASSERT_TRUE(arguments);
    EXPECT_EQ(arguments->word("shape"), "blob");
    EXPECT_EQ(arguments->number("size"), 40);
    EXPECT_EQ(arguments->number("spacing"), 50);
    const Result<BoundCall> inked = bound_in(split, "9, ink: colours(1)");
    ASSERT_TRUE(inked);
    EXPECT_FALSE(inked->constants[7]);
    EXPECT_FALSE(bound_in(split, "9, ink: red")->constants[7]) << "no colour word where it is a name";
    EXPECT_TRUE(bound_in(split, "9, ink: blue")->constants[7]);
    EXPECT_EQ(problems(bound_in(place, "wihs").diagnostics(), "f(wihs)"), "unknown-name@wihs");
    EXPECT_EQ(problems(bound_in(place, "20, sides: gap").diagnostics(), "f(20, sides: gap)"), "wrong-kind@gap");
    EXPECT_EQ(problems(bound_in(place, "wish - 30").diagnostics(), "f(wish - 30)"), "") << "that is for the step";
    EXPECT_TRUE(check_condition(*expression_of("wish > 3"), document, globals, &macro).empty());
    EXPECT_FALSE(check_condition(*expression_of("wish > 3"), document, globals).empty());
    EXPECT_TRUE(check_weight(*expression_of("3 - wish"), document, globals, &macro).empty());
    EXPECT_FALSE(check_weight(*expression_of("gap"), document, globals, &macro).empty()) << "a length";
}

TEST(Descriptions, AreFoundByNameAndAlias) {
    const std::vector<OperatorDescription> operators = {{.name = "regular_split", .aliases = {"regularSplit"}},
                                                        {.name = "outline"}};
    EXPECT_EQ(find_operator(operators, "outline"), &operators[1]);
    EXPECT_EQ(find_operator(operators, "regularSplit"), &operators[0]);
    EXPECT_EQ(find_operator(operators, "regularspilt"), nullptr);
    EXPECT_EQ(type_name(ParameterType::whole), "a whole number");
    EXPECT_EQ(type_name(ParameterType::any), "a value");
}

}  // namespace
}  // namespace filigree
