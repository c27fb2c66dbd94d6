// Shape documents as a person meets them: on the command line. The counts are the paper's (figures 9 to 15).
#include <gtest/gtest.h>

#include "tests/shape_program.h"

namespace filigree {
namespace {

const std::string petals = R"(grammar shape
let petal = path("M -1 -1 Q 1 -3 3 3 M -1 -1 Q -3 1 3 3")
let sides = path("M -3 3 Q -2 0 -1 -1 M 1 1 Q 0 2 -3 3 M 3 -3 Q 2 0 1 1 M -1 -1 Q 0 -2 3 -3")
start design = sides + translate(2, 2) * petal + translate(-2, -2) * rotate(180) * petal
slide = petal -> translate(-2, -2) * petal   match isometry
back = inverse(slide)
)";

std::size_t element_count(const std::string& text) { return matches_of(text, "slide")["elements"].get<std::size_t>(); }

std::string with_step(const std::string& text, const std::string& options) {
    const TestFolder folder;
    const Ran ran = run_program("step " + folder.write("a.fil", text) + " " + options);
    EXPECT_EQ(ran.status, 0) << ran.out;
    return ran.out;
}

TEST(Shape, PetalsEmerge) {
    EXPECT_EQ(match_count(petals, "slide"), 2U);
    EXPECT_EQ(element_count(petals), 8U);
    const std::string one = with_step(petals, "--rule slide --match 1");
    EXPECT_EQ(match_count(one, "slide"), 2U);
    EXPECT_EQ(element_count(one), 6U);
    const TestFolder folder;
    const Ran listed = run_program("match " + folder.write("a.fil", one) + " --rule slide");
    EXPECT_EQ(listed.out.substr(0, 17), "slide: 2 matches\n") << listed.out;
    const std::string two = petals + "apply slide at (3, 3)\napply slide at (-3, -3)\n";
    EXPECT_EQ(match_count(two, "slide"), 4U);
    EXPECT_EQ(element_count(two), 4U);
}

TEST(Shape, TheCurvedSquareInTheMiddleIsFoundOnce) {
    const std::string square = petals + R"(apply slide at (3, 3)
apply slide at (-3, -3)
let side = path("M -1 -1 Q 0 -2 1 -1")
let square = side + rotate(90) * side + rotate(180) * side + rotate(270) * side
turn = square -> rotate(45) * scale(1.5) * square
)";
    const Json found = matches_of(square, "turn");
    EXPECT_EQ(found["rules"][0]["matches"], 1);
    EXPECT_EQ(found["rules"][0]["applications"].size(), 1U) << "the turned square has the symmetries of the square";
    const Json after = matches_of(square + "apply turn at (0, 0)\n", "turn");
    EXPECT_EQ(after["elements"], 12);
    EXPECT_EQ(after["rules"][0]["matches"], 1);
}

TEST(Shape, AnInverseTakesBack) {
    const std::string there = petals + "apply slide at (3, 3)\n";
    const Json gone = matches_of(there + "apply back at (1, 1)\n", "slide");
    EXPECT_EQ(gone["design"], matches_of(petals, "slide")["design"]);
}

TEST(Shape, GoesBackToAStateAndTakesAnotherWay) {
    const std::string tree = petals + R"(apply one = slide at (3, 3)
apply slide at (-3, -3)
back to one
apply back at (1, 1)
)";
    const Json found = matches_of(tree, "slide");
    EXPECT_EQ(found["state"], 3);
    EXPECT_EQ(found["design"], matches_of(petals, "slide")["design"]);
    const TestFolder folder;
    const Ran derived = run_program("derive " + folder.write("a.fil", tree));
    EXPECT_NE(derived.out.find("from state 1"), std::string::npos) << derived.out;
}

TEST(Shape, EndsWhereItHasGoneBackTo) {
    const std::string tree = petals + "apply one = slide at (3, 3)\napply slide at (-3, -3)\nback to one\n";
    EXPECT_EQ(element_count(tree), 6U);
    // One step lies behind that state, whatever was tried besides.
    const std::string asked = "again = petal -> petal + point((0, 0), \"seen\")   match isometry when steps == ";
    EXPECT_EQ(match_count(tree + asked + "1\n", "again"), 2U);
    EXPECT_EQ(match_count(tree + asked + "2\n", "again"), 0U);
}

TEST(Shape, AppliesAtAllPlacesOfAnOrbit) {
    const Json both = matches_of(petals + "apply slide at (3, 3) orbit\n", "slide");
    EXPECT_EQ(both["elements"], 4);
    EXPECT_EQ(both["rules"][0]["matches"], 4);
}

TEST(Shape, AStepNamesItsMatchByWhereItLies) {
    const std::string one = with_step(petals, "--rule slide --match 2");
    EXPECT_EQ(one.substr(0, petals.size()), petals);
    const std::string statement = one.substr(petals.size());
    EXPECT_EQ(statement.substr(0, 15), "apply slide at ") << statement;
    // An earlier edit elsewhere leaves it where it is.
    const std::string earlier = petals + "apply slide at (3, 3)\napply back at (1, 1)\n" + statement;
    EXPECT_EQ(matches_of(earlier, "slide")["design"], matches_of(one, "slide")["design"]);
}

TEST(Shape, DerivesByItselfAndEndsWhereNoRuleApplies) {
    const std::string text = R"(grammar shape
seed 3
start bar = line((0, 0), (90, 0)) + point((0, 0), "tip")
grow = point((0, 0), "tip") -> point((10, 0), "tip") + line((0, 0), (0, 5))   match translation when x < 75
steps 100
)";
    const TestFolder folder;
    const std::string file = folder.write("a.fil", text);
    const Ran derived = run_program("derive " + file);
    EXPECT_EQ(derived.status, 0) << derived.out;
    EXPECT_NE(derived.out.find("8  step[8]/grow"), std::string::npos) << derived.out;
    EXPECT_NE(derived.out.find("no rule applies any more"), std::string::npos);
    const Ran rendered = run_program("render " + file + " --verify -o " + (folder / "a.svg"));
    EXPECT_EQ(rendered.status, 0) << rendered.out;
}

TEST(Shape, ChoicesAreListedSetAndReplayed) {
    const std::string text = R"(grammar shape
seed 3
start bar = point((0, 0), "a") + point((50, 0), "a")
grow = point((0, 0), "a") -> point((0, 10), "a") + line((0, 0), (3..9, 10))   match translation
branch = point((0, 0), "a") -> point((10, 10), "a") + line((0, 0), (10, 10))   match translation weight 2
steps 12
)";
    const TestFolder folder;
    const std::string file = folder.write("a.fil", text);
    const Ran choices = run_program("choices " + file);
    ASSERT_EQ(choices.status, 0) << choices.out;
    const Json rows = Json::parse(choices.out);
    std::size_t rules = 0, matches = 0, rights = 0;
    for (const Json& row : rows) {
        rules += row["name"] == "rule" ? 1U : 0U;
        matches += row["name"] == "match" ? 1U : 0U;
        rights += row["name"] == "right" ? 1U : 0U;
    }
    EXPECT_EQ(rules, 12U);
    EXPECT_EQ(matches, 12U);
    EXPECT_GT(rights, 0U);
    const std::string kept = folder.write("c.json", choices.out);
    const auto path_of = [&](const std::string& options) {
        const Ran ran = run_program("derive " + file + " --format json " + options);
        EXPECT_EQ(ran.status, 0) << ran.out;
        return Json::parse(ran.out)["path"].get<std::string>();
    };
    EXPECT_NE(path_of("--seed 8"), path_of(""));
    const Ran replayed = run_program("render " + file + " --seed 8 --choices " + kept + " -o " + (folder / "b.svg"));
    const Ran drawn = run_program("render " + file + " -o " + (folder / "a.svg"));
    ASSERT_EQ(replayed.status, 0) << replayed.out;
    ASSERT_EQ(drawn.status, 0) << drawn.out;
    const auto set = [&](const std::string& preset) { return path_of("--set '" + preset + "'"); };
    EXPECT_NE(set("step[1].rule=\"branch\""), set("step[1].rule=\"grow\""));
    EXPECT_NE(set("step[2].match=1"), set("step[2].match=2"));
}

TEST(Shape, EnumeratesDesignsOnce) {
    const std::string text = R"(grammar shape
start two = point((0, 0), "a") + point((50, 0), "a")
mark = point((0, 0), "a") -> point((0, 0), "b")   match translation
)";
    const TestFolder folder;
    const std::string file = folder.write("a.fil", text);
    const Ran all = run_program("designs " + file + " --depth 5");
    EXPECT_NE(all.out.find("4 designs: 1 at depth 0, 2 at depth 1, 1 at depth 2"), std::string::npos) << all.out;
    const Ran alike = run_program("designs " + file + " --depth 5 --up-to isometry");
    EXPECT_NE(alike.out.find("3 designs: 1 at depth 0, 1 at depth 1, 1 at depth 2"), std::string::npos) << alike.out;
}

TEST(Shape, CutsPolygonsByTheirCorners) {
    const std::string text = R"(grammar shape
seed 2
start frame = rectangle(200, 150)
cut = rectangle(1, 1) -> rectangle(1, 1) + line((-0.2..0.2, -0.5), (-0.2..0.2, 0.5))   match corners when area > 1500
steps 200
)";
    const TestFolder folder;
    const Ran derived = run_program("derive " + folder.write("a.fil", text) + " --format json");
    ASSERT_EQ(derived.status, 0) << derived.out;
    const Json json = Json::parse(derived.out);
    EXPECT_TRUE(json["finished"]);
    EXPECT_GT(json["steps"].size(), 15U);
    EXPECT_LT(json["steps"].size(), 60U);
}

TEST(Shape, ExplainsByTheMapThatTurnsLeast) {
    const TestFolder folder;
    const Ran ran = run_program("match --rule lift --explain " + folder.write("a.fil", R"(grammar shape
let dome = path("M 0 0 Q 10 -20 20 0 L 0 0")
start design = path("M 0 0 Q 10 -20 20 0") + line((0, 0), (19.9, 0))
lift = dome -> translate(0, -5) * dome
)"));
    EXPECT_EQ(ran.out,
              "lift comes nearest at (10, -3.52), angle 0, scale 1: 1 of 2 elements fit\n"
              "  element 1 (line): its curve ends 0.5 % too early, at (19.9, 0)\n");
}

// Where all points of two designs lie within some tolerances of each other, element by element.
void expect_near(const Json& found, const std::string& wanted, double tolerances) {
    const double reach = tolerances * found["tolerance"].get<double>();
    const Json other = matches_of(wanted, "go")["design"];
    ASSERT_EQ(found["design"].size(), other.size());
    for (std::size_t i = 0; i < other.size(); ++i) {
        const Json &a = found["design"][i]["points"], &b = other[i]["points"];
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t k = 0; k < a.size(); ++k) {
            for (int axis = 0; axis < 2; ++axis) {
                EXPECT_NEAR(a[k][axis].get<double>(), b[k][axis].get<double>(), reach);
            }
        }
    }
}

TEST(Shape, AThousandStepsOfARuleAndItsInverseEndWhereTheyBegan) {
    const std::string text = R"(grammar shape
let petal = path("M -1 -1 Q 1 -3 3 3 M -1 -1 Q -3 1 3 3")
let other = path("M -1 -1 C 1 -3 2 0 3 3 A 4 4 0 0 0 -1 -1")
start design = petal + line((-9, -9), (20, 3)) + point((0, 0), "a")
let there = rotate(37) * scale(1.3) * translate(0.3, 0.7)
go = there * (petal + point((0, 0), "a")) -> there * (other + point((0.1, 0), "b"))
back = inverse(go)
)";
    const Json found = matches_of(text + "steps 1000\n", "go");
    EXPECT_EQ(found["state"], 1000);
    expect_near(found, text, 2);
}

TEST(Shape, AThousandSmallMovesAreOneLargeMove) {
    const auto text = [](const std::string& start) {
        return R"(grammar shape
let petal = path("M -1 -1 Q 1 -3 3 3 M -1 -1 Q -3 1 3 3 C 1 2 0 2 3 9 A 4 4 0 0 1 5 9")
start design = line((-9, -9), (20, 3)) + )" +
               start + R"(
go = rotate(20) * petal -> rotate(20) * translate(0.1, 0.07) * petal   match isometry(reflections: false)
)";
    };
    const Json found = matches_of(text("petal") + "steps 1000\n", "go");
    EXPECT_EQ(found["state"], 1000);
    expect_near(found, text("translate(100, 70) * petal"), 2);
}

// What is wrong shows only when the design is there.
TEST(Shape, SaysWhyARuleDoesNotApplyWhereItIsWanted) {
    const std::string bars = R"(grammar shape
start design = line((0, 0), (100, 0)) + point((50, 50), "eye") + path("M 0 90 Q 30 60 60 90")
part = line((0, 0), (10, 0)) -> line((0, 0), (10, 5))   match isometry
turn = point((0, 0), "eye") -> point((5, 0), "eye")   match isometry
bow = path("M 0 0 Q 30 -30 60 0") -> path("M 0 0 Q 30 30 60 0 L 60 20")   match isometry
none = circle(20) -> circle(10)
)";
    const std::pair<std::string, std::string> cases[] = {
        {"none at (50, 50)", "shape.no-match"},
        {"turn at (10, 10)", "shape.no-match-there"},
        {"part at (50, 30)", "shape.no-match-there"},
        {"part at (52, 1)", "shape.infinite-matches"},
        {"bow at (30, 80) angle 45", "shape.no-match-there"},
    };
    const TestFolder folder;
    for (const auto& [apply, code] : cases) {
        const Ran ran = run_program("render " + folder.write("a.fil", bars + "apply " + apply + "\n") + " -o " +
                                    (folder / "a.svg"));
        EXPECT_EQ(ran.status, 1) << apply;
        EXPECT_NE(ran.out.find("a.fil:7:"), std::string::npos) << ran.out;
        EXPECT_NE(ran.out.find(code), std::string::npos) << ran.out;
        EXPECT_FALSE(std::filesystem::exists(folder / "a.svg"));
    }
}

// Circles become the ellipses of the polygon that they lie in.
TEST(Shape, StretchesArcsWithThePolygon) {
    const std::string text = R"(grammar shape
start frame = path("M 0 0 L 60 0 L 60 20 L 0 20 Z")
disc = path("M -1 -1 L 1 -1 L 1 1 L -1 1 Z") -> circle(1)   match corners
choose first
steps 1
)";
    const Json found = matches_of(text, "disc");
    ASSERT_EQ(found["elements"], 1);
    const Json& ellipse = found["design"][0];
    EXPECT_EQ(ellipse["kind"], "arc");
    EXPECT_NEAR(ellipse["points"][0][0].get<double>(), 30, 1e-9);
    EXPECT_NEAR(ellipse["points"][1][0].get<double>(), 30, 1e-9);
    EXPECT_NEAR(ellipse["points"][2][1].get<double>(), 10, 1e-9);
}

}  // namespace
}  // namespace filigree
