#include "language/step_choices.h"

#include <set>

#include "base/test_cases.h"
#include "language/check.h"
#include "language/names.h"
#include "language/preset_place.h"

namespace filigree {
namespace {

constexpr Key step_key{5};

class StepChoosing : public testing::Test {
protected:
    PresetPlace place;
    Scope step;
    Document own_document = document_of("unit px\n");

    void SetUp() override {
        place.globals.names["gap"] = number_value(12);
        step = example_scope(step_names(), &place.globals);
        step.names["count"] = number_value(4);
    }
    void stand(std::string_view text) { place.stand_at("big_poly/outline", text); }
    Evaluation evaluation(std::string_view name = "distance") {
        Evaluation at;
        at.document = &own_document;
        at.scope = &step;
        at.site = {0, step_key, std::string(name)};
        return at;
    }
    // The value with this expression of its own.
    std::string with(std::string_view own, std::string_view parameter = "distance") {
        place.buffer = {};
        return shown(evaluate_with(place.choices, parameter, *expression_of(own), evaluation(parameter)));
    }
    std::string preset(std::string_view parameter = "distance") {
        place.buffer = {};
        const Result<std::optional<Value>> value = preset_value(place.choices, parameter, evaluation(parameter));
        if (!value) return value.diagnostics().front().code;
        return *value ? to_text(**value) : "none";
    }
    std::string rows() const { return place.rows(step_key); }
    double drawn(std::string_view own, std::uint64_t seed) {
        Evaluation at = evaluation();
        at.site.seed = seed;
        return std::get<Quantity>(evaluate(*expression_of(own), at)->data).value;
    }
};

TEST_F(StepChoosing, WhatNothingIsSaidOfIsDrawnAsEver) {
    stand("set big_poly/outline.other = 3\nset big_poly.distance = 4\n");
    EXPECT_EQ(with("5..9"), to_text(drawn("5..9", place.seed)));
    EXPECT_EQ(rows(), "distance: 5..9 drawn " + to_text(drawn("5..9", place.seed)) + "\n");
    EXPECT_EQ(preset(), "none");
    EXPECT_EQ(rows(), "");
    place.choices = {};
    EXPECT_EQ(with("5..9"), to_text(drawn("5..9", 0)));
    EXPECT_EQ(preset(), "none");
}

TEST_F(StepChoosing, ASetGoesBeforeTheExpressionAndIsRecorded) {
    stand("set big_poly/outline.distance = 7\n");
    EXPECT_EQ(with("5..9"), "7");
    EXPECT_EQ(rows(), "distance: 7 set\n");
    EXPECT_EQ(with("3"), "7");
    EXPECT_EQ(preset(), "7");
    EXPECT_EQ(with("3", "other"), "3");
    EXPECT_EQ(rows(), "") << "what is no choice is no row";
    stand("set big_poly/outline.distance = gap * count\n");
    EXPECT_EQ(with("3"), "48");
    stand("set big_poly/outline.distance = nothing\n");
    EXPECT_EQ(with("3").substr(0, 22), "language.unknown-name:");
}

TEST_F(StepChoosing, ARestrictedChoiceMovesAndKeepsItsQuantile) {
    for (place.seed = 1; place.seed <= case_count(200); ++place.seed) {
        stand("set big_poly/outline.distance = 4..5\n");
        const Result<std::optional<Value>> value = preset_value(place.choices, "distance", evaluation());
        const double narrow = std::get<Quantity>((*value)->data).value;
        EXPECT_NEAR(narrow - 4, drawn("0..10", place.seed) / 10, 1e-12);
        EXPECT_EQ(rows(), "distance: 4..5 set " + to_text(narrow) + "\n");
        stand("reroll big_poly/outline.distance\n");
        EXPECT_NE(with("0..10"), to_text(drawn("0..10", place.seed)));
        EXPECT_EQ(with("0..10", "other"), [&] {
            Evaluation at = evaluation("other");
            at.site.seed = place.seed;
            return shown(evaluate(*expression_of("0..10"), at));
        }());
    }
}

TEST_F(StepChoosing, TheNarrowerGoesFirstWhereItsConditionHolds) {
    stand(
        "set **.distance = 1\nset **/outline.distance = 2 when count > 4\nset big_poly/**.distance = 3 when gap > "
        "12\n");
    EXPECT_EQ(with("5"), "1");
    step.names["count"] = number_value(5);
    EXPECT_EQ(with("5"), "2");
    stand("set **.distance = 1 when count\n");
    EXPECT_EQ(with("5").substr(0, 22), "language.out-of-range:");
    stand("set **.distance = 1 when width\n");
    EXPECT_EQ(with("5").substr(0, 20), "language.wrong-kind:");
    stand("set **.distance = 1 when page\n");
    EXPECT_EQ(with("5").substr(0, 22), "language.unknown-name:");
}

TEST_F(StepChoosing, DefaultsCountWhereNothingIsRandom) {
    stand("default **.distance = 3\n");
    EXPECT_EQ(with("5..9"), to_text(drawn("5..9", place.seed)));
    stand("default **.distance = 3\nset big_poly/**.is_random = false\n");
    EXPECT_FALSE(place.choices.is_random);
    EXPECT_EQ(with("5..9"), "3");
    EXPECT_EQ(rows(), "distance: 3 default\n");
    EXPECT_EQ(with("20"), "3");
    EXPECT_EQ(with("5..9", "other"), "7");
    EXPECT_EQ(rows(), "other: 5..9 middle 7\n");
    stand("default **.distance = 30..40\nset **.is_random = false\n");
    EXPECT_EQ(with("5..9"), "35");
    EXPECT_EQ(rows(), "distance: 30..40 default 35\n");
    stand("default big_poly/outline.distance = 3\nset **.distance = 4\nset **.is_random = false\n");
    EXPECT_EQ(with("5..9"), "4") << "a set goes before a default, however wide";
}

TEST_F(StepChoosing, IsRandomIsWhatTheFirstPresetThatHoldsSays) {
    const auto is_random = [&](std::string_view text) -> std::string {
        place.stand_at("big_poly/outline", "");
        const Document document = document_of(text);
        const Presets presets = with_presets_of({}, document, place.globals, 1);
        place.presets = presets;
        const Result<bool> value = is_random_at(presets, place.accepted_at("big_poly/outline"), step);
        return value ? (*value ? "yes" : "no") : value.diagnostics().front().code;
    };
    EXPECT_EQ(is_random(""), "yes");
    EXPECT_EQ(is_random("set **.is_random = false"), "no");
    EXPECT_EQ(is_random("set **.is_random = no"), "no");
    EXPECT_EQ(is_random("set **.is_random = 0"), "no");
    EXPECT_EQ(is_random("set **.is_random = false when count > 4"), "yes");
    EXPECT_EQ(is_random("set **.is_random = gap == 12\nset big_poly/**.is_random = count > 3"), "yes");
    EXPECT_EQ(is_random("default **.is_random = false"), "yes");
    EXPECT_EQ(is_random("set **.is_random = one_of(true, false: 3)"), "no") << "the heaviest";
    EXPECT_EQ(is_random("set **.is_random = 3"), "language.out-of-range");
    EXPECT_EQ(is_random("set **.is_random = maybe"), "language.unknown-name");
}

TEST_F(StepChoosing, PartsOfAnArgumentArePresetAlone) {
    stand("set big_poly/outline.distance~2 = 6\n");
    EXPECT_EQ(with("[1..1, 5..9]"), "[1, 6]");
    EXPECT_EQ(rows(), "distance: 1..1 drawn 1\ndistance~2: 5..9 set 6\n");
    EXPECT_EQ(with("[1..1, 7..9]").substr(0, 22), "preset.outside-domain:");
    EXPECT_EQ(preset(), "none");
    stand("set **.distance~1 = 6 when count > 4\nset **.distance~1 = 7 when count < 4\ndefault **.distance~1 = 8\n");
    EXPECT_EQ(with("5..9"), to_text(drawn("5..9", place.seed)));
    step.names["count"] = number_value(5);
    EXPECT_EQ(with("5..9"), "6");
    stand("default **.distance~1 = 8\nset **.is_random = false\n");
    EXPECT_EQ(with("5..9"), "8");
    EXPECT_EQ(rows(), "distance: 5..9 default 8\n");
    stand("set big_poly/outline.distance~1 = 8\nset **.distance~1 = 20\n");
    EXPECT_EQ(with("5..9"), "8") << "the narrower";
    stand("set big_poly/outline.distance~1 = gap / 2\n");
    EXPECT_EQ(with("5..9"), "6");
}

// The narrower preset of a part holds in the wider one of the whole, but not the other way round.
TEST_F(StepChoosing, PartsOfPresetsCanBePresetToo) {
    stand("set **.distance = [5..9, 20..30]\nset big_poly/outline.distance~2 = 25\n");
    EXPECT_EQ(with("3").substr(with("3").find(',')), ", 25]");
    stand("set **.distance~2 = 25\nset big_poly/outline.distance = [5..5, 29..30]\n");
    EXPECT_EQ(with("3").substr(0, 5), "[5, 2");
    EXPECT_EQ(rows().find("20..30"), std::string::npos);
}

TEST_F(StepChoosing, ChoicesInConditionsHaveNamesOfTheirOwn) {
    stand(
        "set **.distance = 1 when (0..1) > 1\nset **/outline.distance = 2 when (0..1) > 2 && (0..3) > 1\n"
        "set big_poly/**.distance = 4..5 when count > 100\nset big_poly/outline.distance~1 = 6 when (0..1) > 3\n");
    const std::string value = with("5..9");
    EXPECT_EQ(value, to_text(drawn("5..9", place.seed)));
    std::set<std::string> names;
    for (const ChoiceBuffer::Row& row : place.buffer.rows) {
        EXPECT_TRUE(names.insert(place.buffer.places[row.place].name).second);
        EXPECT_EQ(row.key, step_key);
    }
    EXPECT_EQ(names, (std::set<std::string>{"distance", "distance?when", "distance?when#2", "distance?when#3"}));
    // They replay.
    ChoiceRecorder recorder;
    recorder.append(place.buffer);
    for (std::size_t row = 0; row < recorder.choices.size(); ++row) {
        place.replay.add(recorder.choices.keys[row], recorder.choices.name_table[recorder.choices.names[row]],
                         value_of(recorder.choices, row));
    }
    place.choices.seed.value = 99;
    EXPECT_EQ(with("5..9"), value);
    place.replay.add(step_key, "distance?when", number_value(1));
    EXPECT_EQ(with("5..9"), value);
}

TEST_F(StepChoosing, PresetsKnowTheDocumentThatSaysThem) {
    PresetPlace outer;
    outer.globals.names["gap"] = number_value(3);
    outer.stand_at("big_poly/outline",
                   "unit mm\nset **.distance = gap when gap == 3 && count == 4\nset **.size~1 = 25.4\n"
                   "set **.other = only_here\n");
    place.globals.names["only_here"] = number_value(1);
    place.stand_at("big_poly/outline", "unit px\nset big_poly/outline.distance = 7\n", &outer);
    const Result<std::optional<DecidedValue>> value = decide(place.choices, "distance", nullptr, evaluation());
    ASSERT_TRUE(value && *value);
    EXPECT_EQ(to_text((*value)->value), "3") << "the outer document goes before the inner one";
    ASSERT_NE((*value)->preset, nullptr);
    EXPECT_EQ(to_text(*as_length((*value)->value, *(*value)->preset->document)), to_text(to_px(3, Unit::mm)));
    EXPECT_EQ(with("50px..100px", "size"), "96");
    EXPECT_EQ(with("1", "other").substr(0, 22), "language.unknown-name:");
    EXPECT_EQ(with("gap", "free"), "12");
}

TEST_F(StepChoosing, WithoutAParameterItIsTheNodeItself) {
    place.stand_at("let/rows", "set let/rows = 5..9\nreroll let/rows\n");
    Evaluation at = evaluation("rows");
    const std::string value = shown(evaluate_with(place.choices, "", *expression_of("3"), at));
    EXPECT_EQ(place.rows(step_key), "rows: 5..9 set " + value + "\n");
    at.site.seed = place.choices.seed.value;
    EXPECT_NE(place.choices.seed.value, place.seed);
    EXPECT_EQ(value, shown(evaluate(*expression_of("5..9"), at))) << "re-rolled once";
}

TEST_F(StepChoosing, AllRecordedValuesReplayWithoutThePresetsOfTheSeed) {
    stand("set big_poly/**.distance = one_of(5..9, 30..40)\nset **.other~1 = 2..3\n");
    for (const std::string_view name : {"distance", "other", "free"}) {
        const std::string value = with("(0..10) + (1..2)", name);
        Replay replay;
        ChoiceRecorder recorder;
        recorder.append(place.buffer);
        for (std::size_t row = 0; row < recorder.choices.size(); ++row) {
            replay.add(recorder.choices.keys[row], recorder.choices.name_table[recorder.choices.names[row]],
                       value_of(recorder.choices, row));
        }
        place.choices.replay = &replay;
        place.choices.seed.value = 1234;
        EXPECT_EQ(with("(0..10) + (1..2)", name), value) << name;
        place.choices.replay = nullptr;
        EXPECT_NE(with("(0..10) + (1..2)", name), value) << name;
        place.choices.seed.value = place.seed;
    }
}

TEST_F(StepChoosing, ScatterIsAWholeNumber) {
    const auto scatter = [&]() -> std::string {
        place.buffer = {};
        const Result<std::uint32_t> value = draw_scatter(place.choices, step_key, step);
        return value ? to_text(std::uint64_t{*value}) : value.diagnostics().front().code;
    };
    stand("");
    const std::string drawn = to_text(random_bits(place.seed, step_key, "scatter") >> 32);
    EXPECT_EQ(scatter(), drawn);
    EXPECT_EQ(rows(), "scatter: 0..4294967295 drawn " + drawn + "\n");
    EXPECT_TRUE(place.buffer.places[0].domain.whole);
    stand("reroll big_poly/outline.scatter\n");
    EXPECT_NE(scatter(), drawn);
    stand("reroll big_poly/outline.distance\n");
    EXPECT_EQ(scatter(), drawn);
    stand("set **.is_random = false\n");
    EXPECT_EQ(scatter(), "2147483648");
    EXPECT_EQ(rows(), "scatter: 0..4294967295 middle 2147483648\n");
    stand("set **.scatter = gap * 2\n");
    EXPECT_EQ(scatter(), "24");
    EXPECT_EQ(rows(), "scatter: 24 set\n");
    stand("set **.scatter = 3..4\n");
    const std::string restricted = scatter();
    EXPECT_TRUE(restricted == "3" || restricted == "4");
    EXPECT_EQ(rows(), "scatter: 3..4 set " + restricted + "\n");
    for (const std::string_view wrong : {"2.5", "-1", "4294967296", "\"a\"", "3mm"}) {
        stand("set **.scatter = " + std::string(wrong) + "\n");
        EXPECT_EQ(scatter(), "preset.outside-domain") << wrong;
    }
    stand("");
    place.replay.add(step_key, "scatter", number_value(77));
    EXPECT_EQ(scatter(), "77");
    EXPECT_EQ(rows(), "scatter: 0..4294967295 replayed 77\n");
    place.replay.add(step_key, "scatter", number_value(7.5));
    EXPECT_EQ(scatter(), "choices.outside-domain");
}

}  // namespace
}  // namespace filigree
