#include "language/choices.h"

#include <limits>
#include <set>

#include "base/number_text.h"
#include "base/test_cases.h"
#include "language/choice.h"
#include "language/random_text.h"
#include "language/text_evaluation.h"

namespace filigree {
namespace {

using Kind = ChoiceDomain::Kind;

class MakingChoices : public testing::Test {
protected:
    Document document = document_of("unit mm\n");
    Scope globals, shape;
    ChoiceBuffer buffer;
    Replay replay;
    ChoiceMaking making;
    Evaluation at;

    void SetUp() override {
        globals.names["ink"] = Value{ValueList{{Value{Colour{1, 2, 3, 255}, {}}, Value{Colour{4, 5, 6, 255}, {}}}}, {}};
        shape.names["index"] = number_value(3);
        making.record = &buffer;
        making.replay = &replay;
        at.document = &document;
        at.scope = &globals;
        at.shape_scope = &shape;
        at.shape_key = Key{99};
        at.site = {7, Key{1}, "distance"};
        at.words = {"line", "wave"};
        at.choices = &making;
    }
    std::string run(std::string_view text) {
        buffer = {};
        return evaluated(text, at);
    }
    Choices recorded() const {
        ChoiceRecorder recorder;
        recorder.append(buffer);
        return recorder.choices;
    }
    // "distance~2: 5..9 drawn", one a line; with the key where it is the shape's.
    std::string rows() const {
        const Choices choices = recorded();
        std::string out;
        for (std::size_t row = 0; row < choices.size(); ++row) {
            if (choices.keys[row] != at.site.key) out += "@" + to_text(choices.keys[row].value) + " ";
            out += choices.name_table[choices.names[row]] + ": " +
                   domain_text(choices.domain_table[choices.domains[row]]) + " " +
                   std::string(name_of(choices.sources[row])) + "\n";
        }
        return out;
    }
    std::string values() const {
        const Choices choices = recorded();
        std::string out;
        for (std::size_t row = 0; row < choices.size(); ++row) {
            out += (row > 0 ? " " : "") + to_text(value_of(choices, row));
        }
        return out;
    }
    // Whether the value is that of the only row.
    bool is_recorded(std::string_view text) {
        const std::string value = run(text);
        return value == values();
    }
    double second_of(std::string_view text) {
        const Result<Value> list = evaluate(*expression_of(text), at);
        return std::get<Quantity>(std::get<ValueList>(list->data).items[1].data).value;
    }
    DrawPreset preset(std::uint32_t draw, std::string_view text) { return {draw, expression_of(text)}; }
};

TEST_F(MakingChoices, EveryKindIsRecordedWithItsDomain) {
    EXPECT_TRUE(is_recorded("5..9"));
    EXPECT_EQ(rows(), "distance: 5..9 drawn\n");
    EXPECT_EQ(run("5mm..9deg").substr(0, 20), "language.wrong-kind:");
    EXPECT_EQ(rows(), "");
    EXPECT_TRUE(is_recorded("1in..2in"));
    EXPECT_EQ(rows(), "distance: 96px..192px drawn\n");
    EXPECT_TRUE(is_recorded("0..1turn"));
    EXPECT_EQ(rows(), "distance: 0deg..360deg drawn\n");
    EXPECT_TRUE(is_recorded("normal(1, 0.2)"));
    EXPECT_EQ(rows(), "distance: normal(1, 0.2) drawn\n");
    EXPECT_TRUE(is_recorded("normal(1, 0.2) in 0..2"));
    EXPECT_EQ(rows(), "distance: normal(1, 0.2) in 0..2 drawn\n");
    EXPECT_TRUE(is_recorded("one_of(line: 3, wave)"));
    EXPECT_EQ(rows(), "distance: one_of(line: 3, wave) drawn\n");
    EXPECT_TRUE(is_recorded("one_of(ink)"));
    EXPECT_EQ(rows(), "distance: one_of(#010203, #040506) drawn\n");
    EXPECT_TRUE(is_recorded("one_of(\"a\", 2in, (1px, 2px))"));
    EXPECT_EQ(rows(), "distance: one_of(\"a\", 192px, (1, 2)) drawn\n");
    EXPECT_EQ(run("6..6"), "6");
    EXPECT_EQ(rows(), "distance: 6..6 drawn\n");
    at.whole = true;
    EXPECT_TRUE(is_recorded("4.5..7.5"));
    EXPECT_EQ(rows(), "distance: 5..7 drawn\n");
    EXPECT_TRUE(buffer.places[0].domain.whole);
    EXPECT_TRUE(is_recorded("normal(5, 3) in 4.5..7.5"));
    EXPECT_EQ(rows(), "distance: normal(5, 3) in 4.5..7.5 drawn\n");
}

// In the order of evaluation: what stands inside a choice is made before it, whether it wins or not.
TEST_F(MakingChoices, RowsStandInTheOrderOfEvaluation) {
    run("one_of(5..9, 20) + (1..2)");
    std::vector<std::string> names;
    for (const ChoiceBuffer::Row& row : buffer.rows) names.push_back(buffer.places[row.place].name);
    EXPECT_EQ(names, (std::vector<std::string>{"distance~2", "distance", "distance~3"}));
    run("true ? (1..2) : (3..4)");
    EXPECT_EQ(rows(), "distance: 1..2 drawn\n");
    run("false ? (1..2) : (3..4)");
    EXPECT_EQ(rows(), "distance~2: 3..4 drawn\n");
    run("(0..1) + each(index..5)");
    EXPECT_EQ(rows(), "distance: 0..1 drawn\n@99 distance~2: 3..5 drawn\n");
    run("(1..2)..(3..4)");
    EXPECT_EQ(buffer.rows.size(), 3U);
    EXPECT_EQ(buffer.places[buffer.rows[2].place].name, "distance");
}

TEST_F(MakingChoices, ADomainIsWrittenOnceAndATextWithAnotherIsAnotherPlace) {
    const ExpressionPtr both = expression_of("[5..9, each(0..index)]");
    for (int i = 0; i < 100; ++i) {
        at.site.key = Key{static_cast<std::uint64_t>(1000 + i)};
        ASSERT_TRUE(evaluate(*both, at));
    }
    EXPECT_EQ(buffer.rows.size(), 200U);
    EXPECT_EQ(buffer.places.size(), 2U);
    for (int i = 0; i < 100; ++i) {
        shape.names["index"] = number_value(i + 10);
        ASSERT_TRUE(evaluate(*both, at));
    }
    EXPECT_EQ(buffer.rows.size(), 400U);
    const Choices choices = recorded();
    EXPECT_EQ(choices.size(), 400U);
    EXPECT_EQ(choices.domain_table.size(), 102U);
    EXPECT_EQ(choices.name_table, (std::vector<std::string>{"distance", "distance~2"}));
    for (std::size_t row = 0; row < choices.size(); ++row) {
        ASSERT_TRUE(place_in(choices.domain_table[choices.domains[row]], value_of(choices, row))) << row;
    }
}

TEST_F(MakingChoices, WithoutARecordNothingElseChanges) {
    for (const std::string_view text : {"5..9", "one_of(5..9, 20)", "normal(5, 2)", "each(0..index)"}) {
        const std::string with = run(text);
        at.choices = nullptr;
        EXPECT_EQ(run(text), with);
        at.choices = &making;
    }
}

TEST_F(MakingChoices, WhereNothingIsRandomTheyTakeTheMiddle) {
    making.is_random = false;
    EXPECT_EQ(run("5..10"), "7.5");
    EXPECT_EQ(rows(), "distance: 5..10 middle\n");
    EXPECT_EQ(run("normal(1, 0.2)"), "1");
    EXPECT_EQ(run("normal(9, 0.2) in 0..2"), "2");
    EXPECT_EQ(run("one_of(line, wave)"), "line");
    EXPECT_EQ(run("one_of(line, wave: 2)"), "wave");
    EXPECT_EQ(run("one_of(line: 0, wave: 0)").substr(0, 24), "language.no-alternative:");
    EXPECT_EQ(run("one_of([])").substr(0, 24), "language.no-alternative:");
    EXPECT_EQ(run("one_of(5..9, 20)"), "7");
    EXPECT_EQ(rows(), "distance~2: 5..9 middle\ndistance: one_of(7, 20) middle\n");
    at.whole = true;
    EXPECT_EQ(run("5..10"), "7");
    EXPECT_EQ(run("-4..-1"), "-3");
    EXPECT_EQ(run("4.5..9.5"), "7");
    EXPECT_EQ(run("normal(6.6, 1)"), "7");
    EXPECT_EQ(run("normal(9.9, 1) in 1.5..8.5"), "8");
    // Inside a preset's expression the source is the preset.
    making.source = ChoiceSource::fallback;
    EXPECT_EQ(run("5..9"), "7");
    EXPECT_EQ(rows(), "distance: 5..9 default\n");
}

TEST_F(MakingChoices, RecordedValuesAreTakenAgain) {
    replay.add(Key{1}, "distance", number_value(6.25));
    EXPECT_EQ(run("5..9"), "6.25");
    EXPECT_EQ(rows(), "distance: 5..9 replayed\n");
    EXPECT_EQ(run("normal(1, 3)"), "6.25");
    EXPECT_EQ(run("5px..9px"), "6.25");
    EXPECT_EQ(run("each(5..9)").substr(0, 4), run("each(5..9)").substr(0, 4));
    EXPECT_EQ(rows(), "@99 distance: 5..9 drawn\n");
    replay.add(Key{99}, "distance", number_value(8));
    EXPECT_EQ(run("each(5..9)"), "8");
    making.is_random = false;
    EXPECT_EQ(run("5..9"), "6.25");
    replay.add(Key{1}, "distance", Value{Symbol{"wave"}, {}});
    EXPECT_EQ(run("one_of(line: 3, wave)"), "wave");
    // Of what is written alike, the one that is equal.
    replay.add(Key{1}, "distance", length_value(20));
    EXPECT_EQ(run("one_of(20, 20px) > 10mm"), "false");
    replay.add(Key{1}, "distance", number_value(20));
    EXPECT_EQ(run("one_of(20, 20px) > 10mm"), "true");
    EXPECT_EQ(run("one_of(10px, 20px) > 10mm"), "false");
}

TEST_F(MakingChoices, ARecordedValueOutsideOfItsDomainIsAnError) {
    const auto problem = [&](std::string_view text) {
        const ExpressionPtr expression = expression_of(text);
        const Result<Value> value = evaluate(*expression, at);
        if (value) return std::string("none");
        EXPECT_EQ(value.diagnostics().size(), 1U);
        EXPECT_EQ(value.diagnostics()[0].code, "choices.outside-domain");
        EXPECT_EQ(value.diagnostics()[0].span.begin, expression->span.begin);
        return value.diagnostics()[0].message;
    };
    replay.add(Key{1}, "distance", number_value(6.5));
    EXPECT_EQ(problem("5..9"), "none");
    EXPECT_EQ(problem("7..9"), "the recorded 6.5 of 'distance' does not lie in 7..9");
    EXPECT_EQ(problem("normal(0, 1) in 0..5"), "the recorded 6.5 of 'distance' does not lie in normal(0, 1) in 0..5");
    EXPECT_EQ(problem("one_of(6, 7)"), "the recorded 6.5 of 'distance' does not lie in one_of(6, 7)");
    at.whole = true;
    EXPECT_EQ(problem("5..9"), "the recorded 6.5 of 'distance' does not lie in 5..9");
    at.whole = false;
    replay.add(Key{1}, "distance", Value{Quantity{6, 0, true}, {}});
    EXPECT_EQ(problem("5..9"), "the recorded 6deg of 'distance' does not lie in 5..9");
    replay.add(Key{1}, "distance", number_value(std::numeric_limits<double>::quiet_NaN()));
    EXPECT_NE(problem("normal(0, 1)"), "none");
}

TEST_F(MakingChoices, PresetsOfADrawReplaceItAlone) {
    const auto with = [&](std::vector<DrawPreset> draws, std::string_view text) {
        making.draws = draws;
        const std::string out = run(text);
        making.draws = {};
        return out;
    };
    EXPECT_EQ(with({preset(2, "7")}, "[1..1, 5..9, 2..2]"), "[1, 7, 2]");
    EXPECT_EQ(rows(), "distance: 1..1 drawn\ndistance~2: 5..9 set\ndistance~3: 2..2 drawn\n");
    EXPECT_EQ(with({preset(1, "wave")}, "one_of(line: 0, wave: 0)"),
              "language.no-alternative: no alternative has a "
              "weight above zero")
        << "a choice that cannot be made";
    EXPECT_EQ(with({preset(1, "wave")}, "one_of(line, wave)"), "wave");
    EXPECT_EQ(with({preset(1, "1in")}, "20mm..30mm"), "96");
    EXPECT_EQ(with({preset(1, "25.4")}, "20mm..30mm"), "96") << "bare: in the document's unit";
    EXPECT_EQ(with({preset(1, "25.4")}, "one_of(20mm, 1in)"), "96");
    EXPECT_EQ(with({preset(1, "10")}, "5..9"), "preset.outside-domain: 'distance' must lie in 5..9, but this is 10");
    EXPECT_EQ(with({preset(1, "10deg")}, "1mm..9mm").substr(0, 22), "preset.outside-domain:");
    EXPECT_EQ(with({preset(1, "nothing")}, "5..9").substr(0, 22), "language.unknown-name:");
    EXPECT_EQ(with({preset(3, "10")}, "5..9"), run("5..9")) << "there is no such draw";
    // The inner choices of one that is not taken are made as ever.
    EXPECT_EQ(with({preset(1, "20")}, "one_of(5..9, 20)"), "20");
    EXPECT_EQ(rows().substr(0, 28), "distance~2: 5..9 drawn\ndista");
    making.is_random = false;
    EXPECT_EQ(with({preset(1, "7")}, "5..9"), "7");
}

// A preset that restricts a draw moves its value, whose quantile stays, and is recorded in its place.
TEST_F(MakingChoices, ARestrictedDrawKeepsItsQuantile) {
    for (std::uint64_t seed = 1; seed <= case_count(200); ++seed) {
        at.site.seed = seed;
        const double wide = second_of("[5..9, 0..10]");
        const DrawPreset draws[] = {preset(2, "4..5")};
        making.draws = draws;
        buffer = {};
        const double narrow = second_of("[5..9, 0..10]");
        making.draws = {};
        EXPECT_NEAR(narrow, 4 + wide / 10, 1e-12) << seed;
        EXPECT_EQ(rows(), "distance: 5..9 drawn\ndistance~2: 4..5 set\n");
    }
    const DrawPreset two[] = {preset(2, "(4..5) + (1..2)")};
    making.draws = two;
    run("[5..9, 0..10]");
    EXPECT_EQ(rows(), "distance: 5..9 drawn\ndistance~2: 4..5 set\ndistance~2~2: 1..2 set\n");
}

TEST_F(MakingChoices, TheyCanBeRecordedElsewhere) {
    const std::string plain = run("[5..9, 5..9]");
    const ChoiceAddress elsewhere{Key{50}, "pen"};
    at.site.recorded_at = &elsewhere;
    EXPECT_EQ(run("[5..9, 5..9]"), plain) << "drawn where they were";
    EXPECT_EQ(rows(), "@50 pen: 5..9 drawn\n@50 pen~2: 5..9 drawn\n");
    replay.add(Key{50}, "pen~2", number_value(6));
    EXPECT_EQ(run("[5..5, 5..9]"), "[5, 6]");
}

// --- tables -----------------------------------------------------------------------------------------------------

TEST_F(MakingChoices, TheRecorderDependsOnWhatIsRecordedAlone) {
    // The same choices by other expressions, in other buffers.
    const std::string_view texts[] = {"5..9", "one_of(line: 3, wave)", "5..9", "[0..1, 5..9]", "one_of(line, wave)"};
    ChoiceRecorder together, apart, copied;
    std::vector<ExpressionPtr> expressions;  // so that no two are at the same place
    for (int round = 0; round < 2; ++round) {
        ChoiceBuffer all;
        for (const std::string_view text : texts) {
            ChoiceBuffer one;
            for (ChoiceBuffer* to : {&one, &all}) {
                making.record = to;
                expressions.push_back(expression_of(text));
                ASSERT_TRUE(evaluate(*expressions.back(), at));
            }
            apart.append(one);
        }
        together.append(all);
    }
    for (std::size_t row = 0; row < together.choices.size(); row += 3) {
        copied.append(together.choices, row, std::min(row + 3, together.choices.size()));
    }
    for (const ChoiceRecorder* other : {&apart, &copied}) {
        const Choices &a = together.choices, &b = other->choices;
        EXPECT_EQ(a.keys, b.keys);
        EXPECT_EQ(a.names, b.names);
        EXPECT_EQ(a.values, b.values);
        EXPECT_EQ(a.domains, b.domains);
        EXPECT_EQ(a.sources, b.sources);
        EXPECT_EQ(a.name_table, b.name_table);
        EXPECT_EQ(a.domain_table, b.domain_table);
    }
    EXPECT_EQ(together.choices.size(), 12U);
    EXPECT_EQ(together.choices.name_table.size(), 2U);
    EXPECT_EQ(together.choices.domain_table.size(), 4U);
}

TEST(Choices, RowsOfOtherDerivationsFindTheirTables) {
    ChoiceRecorder first, second, both;
    const auto fill = [](ChoiceRecorder& recorder, std::initializer_list<double> highs, std::string_view name) {
        for (const double high : highs) {
            ChoiceBuffer buffer;
            ChoiceDomain domain;
            domain.high = high;
            record(buffer, nullptr, name, domain, Key{static_cast<std::uint64_t>(high)}, high / 2, ChoiceSource::drawn);
            recorder.append(buffer);
        }
    };
    fill(first, {1, 2, 3}, "a");
    fill(second, {3, 1, 4}, "b");
    both.append(first.choices, 1, 3);
    both.append(second.choices, 0, 3);
    both.append(first.choices, 0, 1);
    std::string shown;
    for (std::size_t row = 0; row < both.choices.size(); ++row) {
        shown += both.choices.name_table[both.choices.names[row]] +
                 domain_text(both.choices.domain_table[both.choices.domains[row]]) + "=" +
                 to_text(value_of(both.choices, row)) + " ";
    }
    EXPECT_EQ(shown, "a0..2=1 a0..3=1.5 b0..3=1.5 b0..1=0.5 b0..4=2 a0..1=0.5 ");
    EXPECT_EQ(both.choices.domain_table.size(), 4U);
}

TEST(Choices, FixedValuesHaveTheirValueAsDomain) {
    ChoiceDomain domain{Kind::fixed};
    domain.alternatives = {length_value(12)};
    ChoiceBuffer buffer;
    record(buffer, nullptr, "size", domain, Key{3}, 0, ChoiceSource::set);
    ChoiceRecorder recorder;
    recorder.append(buffer);
    EXPECT_EQ(value_of(recorder.choices, 0), length_value(12));
    EXPECT_EQ(domain_text(domain), "12px");
    EXPECT_EQ(text_with_unit(Value{Quantity{3, 0, true}, {}}), "3deg");
    std::set<std::string_view> names;
    for (const ChoiceSource source : {ChoiceSource::drawn, ChoiceSource::set, ChoiceSource::fallback,
                                      ChoiceSource::middle, ChoiceSource::replayed}) {
        names.insert(name_of(source));
    }
    EXPECT_EQ(names, (std::set<std::string_view>{"drawn", "set", "default", "middle", "replayed"}));
}

// --- at random --------------------------------------------------------------------------------------------------

// Numbers with choices of every kind inside one another; none can fail.
class ChoiceText : public CaseRandom {
public:
    using CaseRandom::CaseRandom;

    std::string number(int depth) {
        if (depth <= 0) return to_text(std::uint64_t{below(20)}) + (below(3) == 0 ? ".5" : "");
        switch (below(10)) {
            case 0:
            case 1:
                return "(" + small(depth) + " .. (10 + " + small(depth) + "))";
            case 2:
                return "(normal(" + number(depth - 1) + ", abs(" + number(depth - 1) + ")) in " + small(depth) +
                       "..(11 + " + small(depth) + "))";
            case 3:
                return "normal(" + number(depth - 1) + ", 1 + abs(" + number(depth - 1) + "))";
            case 4:
            case 5:
                return one_of(depth);
            case 6:
                return "(" + number(depth - 1) + " < " + number(depth - 1) + " ? " + number(depth - 1) + " : " +
                       number(depth - 1) + ")";
            case 7:
                return "each(index + " + number(depth - 1) + ")";
            case 8:
                return "(" + number(depth - 1) + (coin() ? " + " : " - ") + number(depth - 1) + ")";
            default:
                return "max(" + number(depth - 1) + ", " + number(depth - 1) + ")";
        }
    }

private:
    std::string small(int depth) { return "clamp(" + number(depth - 1) + ", 0, 10)"; }
    std::string one_of(int depth) {
        std::string out = "one_of(" + number(depth - 1);
        for (std::uint32_t i = below(4); i > 0; --i) {
            out += ", " + number(depth - 1);
            if (coin()) out += ": 1 + abs(" + number(depth - 1) + ")";
        }
        return out + ")";
    }
};

std::vector<std::string> rows_of(const Choices& choices) {
    std::vector<std::string> out;
    for (std::size_t row = 0; row < choices.size(); ++row) {
        out.push_back(to_text(choices.keys[row].value) + " " + choices.name_table[choices.names[row]] + " " +
                      to_text(value_of(choices, row)) + " of " +
                      domain_text(choices.domain_table[choices.domains[row]]));
    }
    return out;
}

// What is recorded says all: replayed with another seed it gives the same value and the same record.
TEST(RandomChoices, ReplayToTheSameValueWithAnySeed) {
    const Document document = document_of("unit mm\n");
    Scope globals, shape;
    globals.names["line"] = number_value(2);
    globals.names["gap"] = number_value(5);
    globals.names["x"] = length_value(30);
    globals.names["page.width"] = length_value(300);
    shape.names["index"] = number_value(3);
    std::uint64_t made = 0, moved = 0;
    for (std::uint64_t seed = 1; seed <= case_count(3000); ++seed) {
        // Every third text is any at all, wherever that has a value.
        const std::string text =
            seed % 3 == 0 ? RandomText(seed).expression(3) : ChoiceText(seed).number(1 + static_cast<int>(seed % 4));
        const Result<ExpressionPtr> parsed = parse_expression(text);
        if (!parsed) continue;
        ChoiceBuffer buffer;
        ChoiceMaking making;
        making.record = &buffer;
        Evaluation at;
        at.document = &document;
        at.scope = &globals;
        at.shape_scope = &shape;
        at.shape_key = Key{seed + 1};
        at.site = {seed, Key{seed}, "x"};
        at.whole = seed % 2 == 0;
        const std::string plain = shown(evaluate(**parsed, at));
        at.choices = &making;
        const Result<Value> value = evaluate(**parsed, at);
        ASSERT_EQ(shown(value), plain) << seed << ": " << text;
        if (!value) {
            ASSERT_EQ(seed % 3, 0U) << text << "\n" << shown(value);
            continue;
        }
        ChoiceRecorder first, second;
        first.append(buffer);
        const Choices& choices = first.choices;
        made += choices.size();
        Replay replay;
        for (std::size_t row = 0; row < choices.size(); ++row) {
            const ChoiceDomain& domain = choices.domain_table[choices.domains[row]];
            ASSERT_TRUE(place_in(domain, value_of(choices, row))) << seed << ": " << text;
            replay.add(choices.keys[row], choices.name_table[choices.names[row]], value_of(choices, row));
        }
        ASSERT_EQ(replay.size(), choices.size()) << "each has a name of its own: " << text;
        at.site.seed = seed + 1000000;
        at.choices = nullptr;
        moved += shown(evaluate(**parsed, at)) != plain ? 1 : 0;
        at.choices = &making;
        buffer = {};
        making.replay = &replay;
        making.is_random = seed % 5 != 0;
        ASSERT_EQ(shown(evaluate(**parsed, at)), plain) << seed << ": " << text;
        second.append(buffer);
        ASSERT_EQ(rows_of(second.choices), rows_of(choices)) << seed << ": " << text;
        for (const ChoiceSource source : second.choices.sources) ASSERT_EQ(source, ChoiceSource::replayed);
    }
    EXPECT_GT(made, case_count(3000));
    EXPECT_GT(moved, case_count(3000) / 10);
}

// Where nothing is random, any seed gives the same, inside every domain.
TEST(RandomChoices, WithoutRandomnessNoSeedMatters) {
    Scope shape;
    shape.names["index"] = number_value(3);
    shape.names["line"] = number_value(2);
    for (std::uint64_t seed = 1; seed <= case_count(1000); ++seed) {
        const std::string text = ChoiceText(seed).number(1 + static_cast<int>(seed % 4));
        const ExpressionPtr expression = expression_of(text);
        ChoiceMaking making;
        ChoiceBuffer buffer;
        making.is_random = false;
        making.record = &buffer;
        Evaluation at;
        at.scope = &shape;
        at.shape_scope = &shape;
        at.shape_key = Key{1};
        at.choices = &making;
        at.whole = seed % 2 == 0;
        at.site = {seed, Key{2}, "x"};
        const std::string once = shown(evaluate(*expression, at));
        at.site = {seed + 1, Key{3}, "y"};
        ASSERT_EQ(shown(evaluate(*expression, at)), once) << seed << ": " << text;
        ChoiceRecorder recorder;
        recorder.append(buffer);
        for (std::size_t row = 0; row < recorder.choices.size(); ++row) {
            ASSERT_TRUE(place_in(buffer.places[buffer.rows[row].place].domain, value_of(recorder.choices, row)))
                << text;
            ASSERT_EQ(recorder.choices.sources[row], ChoiceSource::middle);
        }
    }
}

}  // namespace
}  // namespace filigree
