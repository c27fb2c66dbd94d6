// Shape rules with conditions, at orbits, by hand before the machine: each as a person meets it.
#include "tests/shape_program.h"

namespace filigree {
namespace {

const std::string squares = R"(grammar shape
let square = rectangle(4, 4)
)";

TEST(ShapeRules, AStepByHandComesBeforeThoseOfTheMachine) {
    const std::string text = squares + R"(start design = square
move = square -> translate(30, 0) * square   match translation
steps 1
)";
    const TestFolder folder;
    const std::string file = folder.write("a.fil", text);
    const Ran late = run_program("step " + file + " --rule move --match 1");
    EXPECT_EQ(late.status, 2);
    EXPECT_NE(late.out.find("step.after-the-machine"), std::string::npos) << late.out;
    EXPECT_EQ(matches_of(text, "move")["rules"][0]["applications"][0]["at"][0], 30);
    EXPECT_NEAR(matches_of(text, "move", "--by-hand")["rules"][0]["applications"][0]["at"][0].get<double>(), 0, 1e-9);
    const Ran stepped = run_program("step " + file + " --rule move --match 1 --by-hand");
    ASSERT_EQ(stepped.status, 0) << stepped.out;
    EXPECT_EQ(matches_of(stepped.out, "move")["rules"][0]["applications"][0]["at"][0], 60);
}

TEST(ShapeRules, OrbitsKeepToTheRulesMapsAndConditions) {
    const std::string start = "start design = translate(20, 0) * square + translate(-20, 0) * square + circle(60)\n";
    const std::string right = "mark = square -> square + circle(1)   match translation when x > 0\n";
    EXPECT_EQ(matches_of(squares + start + right + "apply mark at (20, 0) orbit\n", "mark")["elements"], 10);
    const std::string both = "mark = square -> square + circle(1)   match translation\n";
    EXPECT_EQ(matches_of(squares + start + both + "apply mark at (20, 0) orbit\n", "mark")["elements"], 11);
}

TEST(ShapeRules, OrbitsOfLookAlikesTakeAwayWhatTheyCover) {
    const Json found = matches_of(R"(grammar shape
let bump = path("M -30 0 Q -20 0.3 -10 0")
start design = bump + mirror(90) * bump + circle(60)
flat = line((0, 0), (20, 0)) -> line((0, 0), (0, 5))   match visual(0.5, maps: isometry)
apply flat at (-20, 0) orbit
)",
                                  "flat");
    ASSERT_EQ(found["elements"], 3);
    for (const Json& element : found["design"]) EXPECT_NE(element["kind"], "parabola");
}

TEST(ShapeRules, VoidRegionsAreStretchedWithThePolygon) {
    EXPECT_EQ(match_count(R"(grammar shape
start design = translate(10, 10) * rectangle(8, 8) + point((10, 10), "x") + translate(30, 10) * rectangle(8, 8)
cut = rectangle(1, 1) -> circle(1)   match corners unless box(-0.4, -0.4, 0.4, 0.4)
)",
                          "cut"),
              1U);
}

TEST(ShapeRules, WhatLooksAlikeDoesNotStandInItsOwnWay) {
    EXPECT_EQ(match_count(R"(grammar shape
start design = path("M -10 0 Q 0 0.3 10 0")
flat = line((-10, 0), (10, 0)) -> empty   match visual(0.5, maps: isometry) unless box(-5, -2, 5, 2)
)",
                          "flat"),
              1U);
}

TEST(ShapeRules, TheBorderOfARegionIsOutside) {
    const auto count = [](const std::string& radius) {
        return match_count(R"(grammar shape
let cross = line((-3, 0), (3, 0)) + line((0, -3), (0, 3))
start design = cross + circle()" +
                               radius + R"()
mark = cross -> circle(1)   match isometry unless disc((0, 0), 10)
)",
                           "mark");
    };
    EXPECT_EQ(count("10"), 1U);
    EXPECT_EQ(count("9.98"), 0U);
}

TEST(ShapeRules, ConditionsOfTheTurnTellSymmetricMatchesApart) {
    const std::string petal = R"(grammar shape
let petal = path("M -1 -1 Q 1 -3 3 3 M -1 -1 Q -3 1 3 3")
start design = translate(10, 0) * petal
mark = petal -> petal + circle(0.5)   match isometry)";
    EXPECT_EQ(match_count(petal + "\n", "mark"), 1U);
    EXPECT_EQ(match_count(petal + " when mirrored\n", "mark"), 1U);
    EXPECT_EQ(match_count(petal + " when angle < 1\n", "mark"), 1U);
}

TEST(ShapeRules, RoundingDoesNotTurnAMatchByAWholeTurn) {
    EXPECT_EQ(match_count(R"(grammar shape
let flag = path("M 0 0 L 10 0 L 10 3")
start design = translate(50, 20) * rotate(-1e-13) * flag + translate(80, 20) * rotate(120) * rotate(120) * rotate(120) * flag
mark = flag -> circle(3)   match isometry(reflections: false) when angle < 1
)",
                          "mark"),
              2U);
}

TEST(ShapeRules, AllMeansAllMatchesNotAllWaysToSeeThem) {
    EXPECT_EQ(matches_of(squares + R"(start design = square
mark = square -> square + line((0, 0), (2, 0))   match isometry
choose all
steps 1
)",
                         "mark")["elements"],
              5);
}

TEST(ShapeRules, DesignsAreThoseThatTheMachineCanMake) {
    const TestFolder folder;
    const Ran ran = run_program("designs --depth 1 " + folder.write("a.fil", squares + R"(start design = square
first = square -> translate(30, 0) * square   match translation priority 2
never = square -> circle(3)   match translation weight 0
later = square -> circle(4)   match translation
)"));
    EXPECT_NE(ran.out.find("2 designs: 1 at depth 0, 1 at depth 1"), std::string::npos) << ran.out;
}

TEST(ShapeRules, NearDecisionsAreTold) {
    const TestFolder folder;
    const auto said = [&](const std::string& end) {
        return run_program("check " + folder.write("a.fil", R"(grammar shape
tolerance 0.01
start design = line((0, 0), (10, 0)) + line(()" + end + R"(, 0), (20, 0))
)"))
            .out;
    };
    EXPECT_NE(said("10.05").find("a.fil:3:16: warning: "), std::string::npos) << said("10.05");
    EXPECT_NE(said("10.05").find("a gap in a curve of 5 tolerances at (10, 0)"), std::string::npos) << said("10.05");
    EXPECT_EQ(said("10.2").find("warning"), std::string::npos) << said("10.2");
    EXPECT_EQ(said("10.001").find("warning"), std::string::npos) << said("10.001");
}

TEST(ShapeRules, WhatGrowsBeyondThePlaneIsTold) {
    const TestFolder folder;
    const Ran ran = run_program("derive " + folder.write("a.fil", R"(grammar shape
start design = circle(5)
grow = circle(1) -> scale(2) * circle(1)
steps 40
)"));
    EXPECT_EQ(ran.status, 4);
    EXPECT_NE(ran.out.find("a.fil:3:1: error: "), std::string::npos) << ran.out;
    EXPECT_NE(ran.out.find("limit.plane"), std::string::npos) << ran.out;
}

TEST(ShapeRules, WhatAStepWritesMeansTheMatchThatWasChosen) {
    // Large left sides that lie near each other, tiny ones, and one without a breadth.
    const std::string large = R"(grammar shape
let flag = path("M 0 0 L 100 0 L 100 30")
start design = flag + translate(123.6769, 6.9231) * rotate(180) * flag
mark = flag -> flag + circle(3)   match isometry(reflections: false)
)";
    const std::string tiny = R"(grammar shape
let square = scale(0.0001) * rectangle(10, 10)
start design = square + translate(0.0003, 0) * square + translate(0.0003, 0.002) * square
mark = square -> square + scale(0.0001) * circle(1)   match translation
)";
    const std::string point = R"(grammar shape
start design = point((1 / 3, 0), "eye") + line((0, 9), (90, 9))
mark = point((0, 0), "eye") -> point((0, 0), "eye") + circle(1)   match isometry
)";
    const TestFolder folder;
    for (const std::string& text : {large, tiny, point}) {
        const Json all = matches_of(text, "mark")["rules"][0]["applications"];
        ASSERT_GE(all.size(), 1U);
        for (std::size_t k = 1; k <= all.size(); ++k) {
            const Ran ran =
                run_program("step " + folder.write("a.fil", text) + " --rule mark --match " + std::to_string(k));
            const Json design = matches_of(ran.out, "mark")["design"];
            const auto circle = std::find_if(design.begin(), design.end(),
                                             [](const Json& element) { return element["kind"] == "arc"; });
            ASSERT_NE(circle, design.end()) << ran.out;
            const Json& by = all[k - 1]["transform"];
            EXPECT_NEAR((*circle)["points"][0][0].get<double>(), by[4].get<double>(), 1e-6);
            EXPECT_NEAR((*circle)["points"][0][1].get<double>(), by[5].get<double>(), 1e-6);
        }
    }
}

}  // namespace
}  // namespace filigree
