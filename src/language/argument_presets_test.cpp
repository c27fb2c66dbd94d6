// Presets of operators' arguments: what they give, and what is known to be wrong with them beforehand.
#include "base/test_cases.h"
#include "language/argument_check.h"
#include "language/bind.h"
#include "language/names.h"
#include "language/preset_place.h"

namespace filigree {
namespace {

using enum ParameterType;

const OperatorDescription spread = {
    .name = "spread",
    .parameters = {{.name = "shape", .type = word, .default_text = "disc", .words = {"disc", "blob", "star"}},
                   {.name = "size", .type = length, .low = 0.1, .high = 1000},
                   {.name = "spacing", .type = length, .default_text = "size * 1.5", .low = 0.1, .high = 10000},
                   {.name = "sides", .type = whole, .default_text = "5", .low = 3, .high = 60},
                   {.name = "turn", .type = direction, .default_text = "keep", .words = {"keep"}, .calls = {"by"}},
                   {.name = "centred", .type = flag, .default_text = "false", .aliases = {"centered"}},
                   {.name = "ink", .type = colour, .default_text = "black"}},
};
constexpr Key step_key{5};

class ArgumentPresets : public testing::Test {
protected:
    PresetPlace place;
    Document own_document = document_of("unit px\n");
    Scope step;
    std::vector<ShapeContext> shapes;

    void SetUp() override {
        place.globals.names["gap"] = number_value(12);
        step = example_scope(step_names(), &place.globals);
        step.names["count"] = number_value(3);
        step.names["width"] = length_value(80);
        for (int i = 0; i < 3; ++i) {
            ShapeContext shape{Key{static_cast<std::uint64_t>(100 + i)}, Scope{&step}};
            for (const std::string_view name : shape_names())
                shape.scope.names[std::string(name)] = number_value(i + 1);
            shapes.push_back(shape);
        }
    }
    Result<Arguments> evaluated_arguments(const std::string& arguments) {
        const ExpressionPtr call = expression_of("f(" + arguments + ")");
        const Result<BoundCall> bound = filigree::bind(spread, std::get<CallExpression>(call->node).arguments,
                                                       call->span, own_document, place.globals);
        if (!bound) return bound.diagnostics();
        place.buffer = {};
        call_ = *bound;
        return evaluate_arguments(call_, own_document, step, place.choices, step_key, shapes);
    }
    // The argument's value, or "code@what is wrong".
    std::string run(std::string_view presets, const std::string& arguments, std::string_view name) {
        place.stand_at("big_poly/spread", presets);
        return value_of_argument(arguments, name);
    }
    std::string value_of_argument(const std::string& arguments, std::string_view name) {
        const Result<Arguments> result = evaluated_arguments(arguments);
        if (!result) {
            const Diagnostic& first = result.diagnostics().front();
            const std::string& text = place.document.text();
            return first.code.substr(9) + "@" +
                   (first.span.end <= text.size() ? text.substr(first.span.begin, first.span.end - first.span.begin)
                                                  : std::string());
        }
        for (std::size_t i = 0; i < spread.parameters.size(); ++i) {
            if (spread.parameters[i].name != name) continue;
            const ArgumentValue& value = result->values[i];
            if (value.per_shape.empty()) return to_text(value.common);
            std::string out;
            for (const Value& one : value.per_shape) out += (out.empty() ? "" : "|") + to_text(one);
            return out;
        }
        return "no such argument";
    }
    std::string rows() const { return place.rows(step_key); }

private:
    BoundCall call_;
};

TEST_F(ArgumentPresets, GoBeforeWhateverTheCallSays) {
    EXPECT_EQ(run("set **.size = 7", "20", "size"), "7") << "a constant";
    EXPECT_EQ(rows(), "size: 7 set\n");
    EXPECT_EQ(run("set **.size = 7", "count * 2", "size"), "7");
    EXPECT_EQ(run("set **.size = 7", "5..9", "size"), "7");
    EXPECT_EQ(run("set **.size = 7", "5..9", "spacing"), "10.5") << "defaults follow";
    EXPECT_EQ(run("set **.spacing = 7", "5..9", "spacing"), "7") << "a default";
    EXPECT_EQ(run("set **.size = 7 when count > 5", "20", "size"), "20");
    EXPECT_EQ(rows(), "");
    EXPECT_EQ(run("unit mm\nset **.size = 7", "20", "size"), to_text(to_px(7, Unit::mm)));
    EXPECT_EQ(run("set **.shape = star", "20", "shape"), "star");
    EXPECT_EQ(run("set **.shape = one_of(star, blob: 0)", "20", "shape"), "star");
    EXPECT_EQ(rows(), "shape: one_of(star, blob: 0) set star\n");
    EXPECT_EQ(run("set **.turn = by(30)", "20", "turn"), "by(30deg)");
    EXPECT_EQ(run("set **.centred = yes", "20", "centred"), "true");
    EXPECT_EQ(run("set **.ink = red", "20", "ink"), "#ff0000");
    EXPECT_EQ(run("set **.sides = 5.5..6.5", "20", "sides"), "6") << "as whole as the argument";
    EXPECT_EQ(run("set **.is_random = false", "5..9", "size"), "7");
    EXPECT_EQ(run("set **.is_random = false\ndefault **.size = 8", "5..9", "size"), "8");
    EXPECT_EQ(run("set **.size~1 = 8", "5..9", "size"), "8");
    EXPECT_EQ(run("set **.sides~1 = 8", "5..9, sides: 3..9", "sides"), "8");
}

TEST_F(ArgumentPresets, ReadTheParametersBeforeTheirs) {
    EXPECT_EQ(run("set **.spacing = size + gap", "20", "spacing"), "32");
    EXPECT_EQ(run("set **.sides = 9 when size > 30", "20", "sides"), "5");
    EXPECT_EQ(run("set **.sides = 9 when size > 30", "40", "sides"), "9");
    EXPECT_EQ(run("set **.sides = 9 when shape == shape && spacing == size * 1.5", "40", "sides"), "9");
    EXPECT_EQ(run("set **.size = sides", "40", "size"), "unknown-name@sides") << "only those before it";
    EXPECT_EQ(run("set **.size = 50\nset **.sides = 9 when size > 30", "20", "sides"), "9");
    EXPECT_EQ(run("set **.sides~1 = sides_wanted", "40, sides: 3..9", "sides"), "unknown-name@sides_wanted");
    EXPECT_EQ(run("set **.sides~1 = 4 when size > 30", "40, sides: 3..9", "sides"), "4");
}

TEST_F(ArgumentPresets, WhatIsWrongIsReportedWhereItStands) {
    EXPECT_EQ(run("set **.size = 0", "20", "size"), "out-of-range@0");
    EXPECT_EQ(run("set **.size = 2000 when true", "20", "size"), "out-of-range@2000");
    EXPECT_EQ(run("set **.size = 30deg", "20", "size"), "wrong-kind@30deg");
    EXPECT_EQ(run("set **.sides = 2.5", "20", "size"), "out-of-range@2.5");
    EXPECT_EQ(run("set **.shape = wave", "20", "size"), "unknown-name@wave");
    EXPECT_EQ(run("set **.size = 1 / (count - 3)", "20", "size"), "not-finite@1 / (count - 3)");
    EXPECT_EQ(run("set **.size = 7 when nothing", "20", "size"), "unknown-name@nothing");
}

TEST_F(ArgumentPresets, VaryByShapeWhereAnExpressionDoes) {
    EXPECT_EQ(run("set **.size = 7", "each(5..9)", "size"), "7|7|7");
    EXPECT_EQ(run("set **.size = each(index * 2)", "20", "size"), "2|4|6");
    EXPECT_EQ(rows(), "@100 size: 2 set\n@101 size: 4 set\n@102 size: 6 set\n");
    EXPECT_EQ(run("set **.size = 7 when each(index > 1)", "20", "size"), "20|7|7");
    EXPECT_EQ(run("set **.sides = 9 when size > 3", "each(index * 2)", "sides"), "5|9|9")
        << "what uses an argument that varies, varies";
    EXPECT_EQ(run("set **.spacing = size + 1", "each(index)", "spacing"), "2|3|4");
    EXPECT_EQ(run("set **.size~1 = 8", "each(5..9)", "size"), "8|8|8");
    EXPECT_EQ(run("set **.size~1 = each(index + 5)", "each(5..9)", "size"), "6|7|8");
    EXPECT_EQ(run("set **.size~1 = each(index + 5)", "5..9", "size"), "6|7|8");
    EXPECT_EQ(rows(), "@100 size: 5..9 set 6\n@101 size: 5..9 set 7\n@102 size: 5..9 set 8\n");
}

// A choice that is common to all shapes is recorded once.
TEST_F(ArgumentPresets, ChoicesOutsideOfEachAreRecordedOnce) {
    run("", "each(index..9) + (1..2)", "size");
    const auto count_of = [&](std::string_view name, Key key) {
        int count = 0;
        for (const ChoiceBuffer::Row& row : place.buffer.rows) {
            count += place.buffer.places[row.place].name == name && row.key == key ? 1 : 0;
        }
        return count;
    };
    EXPECT_EQ(place.buffer.rows.size(), 4U);
    EXPECT_EQ(count_of("size~2", step_key), 1);
    for (const ShapeContext& shape : shapes) EXPECT_EQ(count_of("size", shape.key), 1);
    run("set **.size = 5..9", "each(1..2)", "size");
    EXPECT_EQ(place.buffer.rows.size(), 1U);
    EXPECT_EQ(count_of("size", step_key), 1);
    run("set **.size = 7 when (0..1) < 2", "each(1..2)", "size");
    EXPECT_EQ(count_of("size?when", step_key), 1);
    EXPECT_EQ(place.buffer.rows.size(), 4U);
}

TEST_F(ArgumentPresets, OfSingleShapesGoBeforeThoseOfTheStep) {
    const auto with_shapes = [&](std::string_view presets, const std::string& arguments, std::string_view name) {
        place.stand_at("big_poly/spread", presets);
        for (std::uint32_t shape = 1; shape <= 3; ++shape) {
            place.add_shape(shape, "big_poly/" + to_text(std::uint64_t{shape}) + "/spread");
        }
        return value_of_argument(arguments, name);
    };
    EXPECT_EQ(with_shapes("set big_poly/2/spread.size = 7", "each(index)", "size"), "1|7|3");
    EXPECT_EQ(rows(), "@101 size: 7 set\n");
    EXPECT_EQ(with_shapes("set big_poly/2/spread.size = 7\nset big_poly/spread.size = 8", "each(index)", "size"),
              "8|7|8");
    EXPECT_EQ(with_shapes("set big_poly/1,3/spread.size = 7 when index > 1", "each(index)", "size"), "1|2|7");
    EXPECT_EQ(with_shapes("set big_poly/2/spread.size = 7", "20", "size"), "20|7|20");
    EXPECT_EQ(with_shapes("set **.size = 7", "each(index)", "size"), "7|7|7");
    EXPECT_EQ(rows(), "@100 size: 7 set\n@101 size: 7 set\n@102 size: 7 set\n");
    EXPECT_EQ(with_shapes("set big_poly/2/spread.size~1 = 7", "each(7..7 + index)", "size").substr(0, 1), "7");
    EXPECT_EQ(with_shapes("set big_poly/2/**.is_random = false", "each(index..index + 1)", "size").find("|2.5|") !=
                  std::string::npos,
              true);
    // Re-rolled alone, from the shape's own key.
    const std::string plain = with_shapes("", "each(5..9)", "size");
    const std::string rolled = with_shapes("reroll big_poly/2/spread.size", "each(5..9)", "size");
    const auto part = [](const std::string& text, int n) {
        std::size_t begin = 0;
        for (; n > 0; --n) begin = text.find('|', begin) + 1;
        return text.substr(begin, text.find('|', begin) - begin);
    };
    EXPECT_EQ(part(plain, 0), part(rolled, 0));
    EXPECT_NE(part(plain, 1), part(rolled, 1));
    EXPECT_EQ(part(plain, 2), part(rolled, 2));
    EXPECT_EQ(with_shapes("set big_poly/2/spread.size = 5..9", "each(5..9)", "size"), plain)
        << "drawn where the shape's own choice is";
}

TEST_F(ArgumentPresets, MayNeedShapesThatTheCallDoesNot) {
    const Result<Arguments> first = evaluated_arguments("20");
    ASSERT_TRUE(first);
    const ExpressionPtr call = expression_of("f(20)");
    const Result<BoundCall> bound =
        filigree::bind(spread, std::get<CallExpression>(call->node).arguments, call->span, own_document, place.globals);
    const auto vary = [&](std::string_view presets) {
        place.stand_at("big_poly/spread", presets);
        return presets_vary_by_shape(*bound, place.choices);
    };
    EXPECT_FALSE(vary("set **.size = 5..9"));
    EXPECT_TRUE(vary("set **.size = each(5..9)"));
    EXPECT_TRUE(vary("set **.size = 3 when each(index > 1)"));
    EXPECT_FALSE(vary("set **.other = each(5..9)"));
    EXPECT_FALSE(vary("default **.size = each(5..9)"));
    EXPECT_TRUE(vary("default **.size = each(5..9)\nset **.is_random = false"));
}

// --- checks -----------------------------------------------------------------------------------------------------

class PresetChecks : public testing::Test {
protected:
    Document document = document_of("unit px\n");
    Scope globals, macro;

    void SetUp() override {
        globals.names["gap"] = number_value(12);
        macro.outer = &globals;
        macro.names["wish"] = number_value(3);
    }
    static std::string shown(const Diagnostics& found, std::string_view text) {
        std::string out;
        for (const Diagnostic& one : found) {
            if (!out.empty()) out += "; ";
            out += one.code.substr(9) + "@" + std::string(text.substr(one.span.begin, one.span.end - one.span.begin));
        }
        return out;
    }
    std::string of(std::string_view name, std::string_view text, const Scope* varying = nullptr) {
        for (const ParameterDescription& parameter : spread.parameters) {
            if (parameter.name != name) continue;
            return shown(
                check_preset_value(parameter, *expression_of(text, 0), document, globals, spread.parameters, varying),
                text);
        }
        return "no such parameter";
    }
    std::string when(std::string_view name, std::string_view text, const Scope* varying = nullptr) {
        for (const ParameterDescription& parameter : spread.parameters) {
            if (parameter.name != name) continue;
            return shown(check_preset_condition(parameter, *expression_of(text, 0), document, globals,
                                                spread.parameters, varying),
                         text);
        }
        return "no such parameter";
    }
};

TEST_F(PresetChecks, FindWhatIsWrongWhateverTheStep) {
    EXPECT_EQ(of("size", "20"), "");
    EXPECT_EQ(of("size", "gap * count"), "");
    EXPECT_EQ(of("size", "0"), "out-of-range@0");
    EXPECT_EQ(of("size", "0..9"), "out-of-range@0");
    EXPECT_EQ(of("size", "one_of(5, 2000)"), "out-of-range@2000");
    EXPECT_EQ(of("size", "30deg"), "wrong-kind@30deg");
    EXPECT_EQ(of("size", "gpa"), "unknown-name@gpa");
    EXPECT_EQ(of("size", "count > 3 ? 2 : gpa"), "unknown-name@gpa");
    EXPECT_EQ(of("size", "9..5"), "empty-range@9..5");
    EXPECT_EQ(of("size", "each(index * 2)"), "");
    EXPECT_EQ(of("size", "index"), "unknown-name@index");
    EXPECT_EQ(of("sides", "2.5"), "out-of-range@2.5");
    EXPECT_EQ(of("sides", "3..60"), "");
    EXPECT_EQ(of("shape", "star"), "");
    EXPECT_EQ(of("shape", "one_of(star, wave)"), "unknown-name@wave");
    EXPECT_EQ(of("shape", "3"), "wrong-kind@3");
    EXPECT_EQ(of("centred", "yes"), "");
    EXPECT_EQ(of("centred", "7"), "out-of-range@7");
    EXPECT_EQ(of("ink", "red"), "");
    EXPECT_EQ(of("ink", "rde"), "unknown-name@rde");
    EXPECT_EQ(of("turn", "by(30)"), "");
    EXPECT_EQ(of("turn", "spin(30)"), "unknown-function@spin");
}

TEST_F(PresetChecks, KnowTheParametersBefore) {
    EXPECT_EQ(of("spacing", "size * 2"), "");
    EXPECT_EQ(of("sides", "size"), "wrong-kind@size");
    EXPECT_EQ(of("sides", "size / spacing * 3"), "");
    EXPECT_EQ(of("sides", "floor(width / size)"), "") << "a length by a length";
    EXPECT_EQ(of("size", "spacing"), "unknown-name@spacing");
    EXPECT_EQ(of("size", "size"), "unknown-name@size");
    EXPECT_EQ(of("spacing", "1 / (size - size)"), "") << "that depends on the step";
    EXPECT_EQ(of("ink", "1 / (size - spacing) > 30deg ? red : black"), "wrong-kind@1 / (size - spacing) > 30deg");
    EXPECT_EQ(of("ink", "turn == 30deg ? red : black"), "");
    EXPECT_EQ(of("ink", "turn == 30mm ? red : black"), "") << "a direction may be anything";
    EXPECT_EQ(of("size", "wish"), "unknown-name@wish");
    EXPECT_EQ(of("size", "wish", &macro), "");
}

TEST_F(PresetChecks, ConditionsAreCheckedToo) {
    EXPECT_EQ(when("spacing", "size > 3"), "");
    EXPECT_EQ(when("spacing", "size > 3deg"), "wrong-kind@size > 3deg");
    EXPECT_EQ(when("spacing", "sides > 3"), "unknown-name@sides");
    EXPECT_EQ(when("spacing", "gap"), "out-of-range@gap");
    EXPECT_EQ(when("spacing", "width"), "wrong-kind@width");
    EXPECT_EQ(when("spacing", "each(index > 1)"), "");
    EXPECT_EQ(when("spacing", "wish > 1"), "unknown-name@wish");
    EXPECT_EQ(when("spacing", "wish > 1", &macro), "");
}

}  // namespace
}  // namespace filigree
