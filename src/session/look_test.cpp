// Choices, picking and variations of a run.
#include <gtest/gtest.h>

#include <set>

#include "formats/svg_write.h"
#include "language/edit.h"
#include "session/list_choices.h"
#include "session/pick.h"
#include "session/variations.h"

namespace filigree {
namespace {

constexpr const char* knot = "grammar tangle\nstart ground = host()\noutline(2..3) : ground -> in, rim\n";
constexpr const char* sheet =
    "grammar tangle\n"
    "seed 4\n"
    "let gap = 18..22\n"
    "start body = rectangle(100, 60)\n"
    "outline(4..8) : body -> in, rim\n"
    "regular_split(line, gap, dual: true, angle: 0) : in -> quads\n"
    "embed(\"knot.fil\") : quads\n"
    "style rim when (0..1) < 2 { pen: 1..2 }\n";

struct Ran {
    OpenedDocument opened;
    CheckedDocument checked;
    Run run;
};

std::unique_ptr<Ran> ran(std::string text, const Replay* replay = nullptr) {
    auto all = std::make_unique<Ran>();
    all->opened = open_text("sheet.fil", std::move(text), {{"knot.fil", knot}});
    all->checked = check_document(all->opened, replay);
    EXPECT_FALSE(has_errors(all->checked.diagnostics)) << to_text(all->checked.diagnostics, all->opened.sources);
    SerialExecutor serial;
    RunOptions options;
    options.replay = replay;
    Result<Run> run = run_document(all->opened, all->checked, options, serial, {});
    EXPECT_TRUE(run) << to_text(run.diagnostics(), all->opened.sources);
    if (run) all->run = std::move(*run);
    return all;
}

std::string listing(const Ran& all) {
    std::string text;
    list_choices(all.opened, all.checked, all.run, [&](std::string_view piece) { text += piece; });
    return text;
}

TEST(ListChoices, NamesWhereEveryChoiceWasMade) {
    const auto all = ran(sheet);
    std::set<std::string> places;
    for_each_choice(all->opened, all->checked, all->run,
                    [&](const ListedChoice& choice) { places.insert(choice.path + "." + std::string(choice.name)); });
    EXPECT_TRUE(places.count("let/gap.gap"));
    EXPECT_TRUE(places.count("body/outline.distance"));
    EXPECT_TRUE(places.count("body/outline/in/regular_split/quads/1/embed/ground/outline.distance"));
    EXPECT_TRUE(places.count("body/outline/rim/1/style.pen"));
    EXPECT_TRUE(places.count("body/outline/rim/1/style.when"));
}

TEST(ListChoices, AreReplayedWithAnotherSeed) {
    const auto all = ran(sheet);
    const Result<Replay> replay = read_choices(listing(*all));
    ASSERT_TRUE(replay);
    const auto other = ran(with_seed(all->opened.document, 99));
    const auto again = ran(with_seed(all->opened.document, 99), &*replay);
    EXPECT_NE(to_svg(all->run.drawing, {}), to_svg(other->run.drawing, {}));
    EXPECT_EQ(to_svg(all->run.drawing, {}), to_svg(again->run.drawing, {}));
    for (const ChoiceSource source : again->run.tangle.choices.sources) EXPECT_EQ(source, ChoiceSource::replayed);
}

TEST(ListChoices, WrongListingsAreRefused) {
    EXPECT_EQ(read_choices("{}").diagnostics().front().code, "choices.not-json");
    EXPECT_EQ(read_choices("[1]").diagnostics().front().code, "choices.bad-row");
    EXPECT_EQ(read_choices(R"([{"name": "a", "value": 3, "key": "12"}])").diagnostics().front().code,
              "choices.bad-row");
    EXPECT_EQ(read_choices(R"([{"name": "a", "key": "0123456789abcdef"}])").diagnostics().front().code,
              "choices.bad-row");
    EXPECT_TRUE(read_choices("[]"));
}

TEST(Pick, FindsTheStepsOnBothSidesOfABorder) {
    const auto all = ran(sheet);
    const auto picked = pick(all->opened, all->checked, all->run, {0, 0});
    ASSERT_TRUE(picked);
    ASSERT_EQ(picked->steps.size(), 4U);
    EXPECT_EQ(picked->steps[0].document, "knot.fil");
    EXPECT_EQ(picked->steps[0].operation, "outline");
    EXPECT_EQ(picked->steps[0].line, 3U);
    EXPECT_EQ(picked->steps[1].rule, "embed");
    EXPECT_EQ(picked->steps[1].document, "sheet.fil");
    EXPECT_EQ(picked->steps[2].operation, "regular_split");
    EXPECT_EQ(picked->steps[3].path, "body/outline");
    EXPECT_EQ(picked->path.rfind(picked->steps[0].path, 0), 0U);
    const auto rim = pick(all->opened, all->checked, all->run, {-49, 0});
    ASSERT_TRUE(rim);
    EXPECT_EQ(rim->tag, "rim");
    EXPECT_FALSE(pick(all->opened, all->checked, all->run, {500, 0}));
}

TEST(Pick, TellsTheArgumentsOfTheShapeAtThePoint) {
    const auto all =
        ran("grammar tangle\nstart body = rectangle(100, 60)\n"
            "regular_split(line, 50, angle: 90) : body -> halves\noutline(each(index * 3)) : halves -> in, rim\n");
    const auto distance = [&](Vec at) {
        const auto picked = pick(all->opened, all->checked, all->run, at);
        return picked && !picked->steps.empty() ? picked->steps[0].arguments[0].second : std::string("nothing");
    };
    const auto sorted = [](std::string a, std::string b) { return a < b ? a + " " + b : b + " " + a; };
    EXPECT_EQ(sorted(distance({-25, 0}), distance({25, 0})), "3px 6px");
    EXPECT_EQ(sorted(distance({-25, 29}), distance({25, 29})), "3px 6px") << "in the rim";
}

TEST(Variations, DifferOnlyInWhatIsFree) {
    const std::string text = std::string(sheet) + "set body/outline.distance = 5\nkeep let/gap\n";
    const auto all = ran(text);
    VariationOptions options;
    options.count = 6;
    options.distance = 1;
    const auto neighbours = variations(all->opened, all->checked, all->run, options);
    ASSERT_TRUE(neighbours);
    std::set<std::string> pictures{to_svg(all->run.drawing, {})};
    for (const Variation& one : *neighbours) {
        EXPECT_EQ(one.text.rfind(text, 0), 0U) << "nothing but statements at the end";
        const auto other = ran(one.text);
        EXPECT_TRUE(pictures.insert(to_svg(other->run.drawing, {})).second);
        EXPECT_EQ(other->checked.settings->globals.find("gap")->data, all->checked.settings->globals.find("gap")->data);
        const auto first = [](const Ran& run) { return run.run.tangle.groups[1].shapes; };
        EXPECT_EQ(first(*other), first(*all)) << "what is set stays";
    }
    const auto fixed = ran("grammar tangle\nstart a = circle(40)\noutline(3) : a -> b, c\n");
    EXPECT_EQ(variations(fixed->opened, fixed->checked, fixed->run, {}).diagnostics().front().code,
              "variations.nothing-free");
}

}  // namespace
}  // namespace filigree
