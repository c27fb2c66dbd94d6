// Arguments and starts that are shapes, curves, letters and pictures; drawings repeated by a symmetry; what reopens.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/program.h"

namespace filigree {
namespace {

const std::string starts = std::string(FILIGREE_SOURCE_DIR) + "/examples/tangle/starts/";
const std::string small_font = std::string(FILIGREE_SOURCE_DIR) + "/tests/data/fonts/dejavu_sans_subset.ttf";

struct Grown {
    Ran ran;
    nlohmann::json stats;
};
Grown grown(const TestFolder& folder, const std::string& text) {
    const std::string document = folder.write("a.fil", "grammar tangle\n" + text);
    Grown out;
    out.ran = run_program("render " + document + " --verify -o " + folder / "a.svg" + " --stats " + folder / "a.json");
    if (out.ran.status == 0) out.stats = nlohmann::json::parse(folder.read("a.json"));
    return out;
}

TEST(Forms, EveryKindOfShapeCanBePlaced) {
    const TestFolder folder;
    std::filesystem::copy(starts + "leaf_motif.svg", folder / "leaf.svg");
    std::filesystem::copy(small_font, folder / "font.ttf");
    for (const char* shape :
         {"blob", "disc", "square", "rectangle(30, 10)", "circle(5)", "ellipse(9, 4)", "polygon(5, 10)",
          "star(5, 10, 4)", "path(\"M 0 0 C 8 -9 8 9 0 0 Z\")", "file(\"leaf.svg\")", "text(\"f\", font: \"font.ttf\")",
          "one_of(disc, star(4, 9, 3): 2)"}) {
        const Grown one = grown(folder, "start a = circle(100)\nplace(" + std::string(shape) +
                                            ", 16, 20, rotation: random) : a -> placed, rest\n");
        EXPECT_EQ(one.ran.status, 0) << shape << one.ran.out;
        EXPECT_EQ(one.ran.out, "") << shape;
        ASSERT_EQ(one.ran.status, 0);
        EXPECT_GT(one.stats["elements"], 20) << shape;
    }
}

TEST(Forms, RangesAreWholeWhereTheParameterIs) {
    const TestFolder folder;
    for (const char* shape : {"star(5..8, 10, 4)", "star(points: 5..8, outer: 10, inner: 4)",
                              "one_of(star(3..4, 8..10, 4), polygon(3..6, 8))"}) {
        const Grown one =
            grown(folder, "start a = circle(90)\nplace(" + std::string(shape) + ", 20, 25) : a -> placed, rest\n");
        EXPECT_EQ(one.ran.status, 0) << shape << one.ran.out;
    }
    const Grown empty = grown(folder, "start a = circle(90)\nplace(star(5.2..5.8, 10, 4), 20, 25) : a -> b, c\n");
    EXPECT_EQ(empty.ran.status, 1);
    EXPECT_NE(empty.ran.out.find("language.empty-range"), std::string::npos) << empty.ran.out;
}

TEST(Forms, FilesAreFoundThroughNamesAndChoices) {
    const TestFolder folder;
    std::filesystem::copy(starts + "leaf_motif.svg", folder / "one.svg");
    std::filesystem::copy(starts + "leaf_motif.svg", folder / "two.svg");
    const Grown named = grown(folder,
                              "let other = \"two.svg\"\nlet both = one_of(\"one.svg\", other)\n"
                              "start a = circle(100)\nplace(file(both), 16, 20) : a -> placed, rest\n");
    EXPECT_EQ(named.ran.status, 0) << named.ran.out;
    const Grown looped = grown(folder,
                               "let f = one_of(f, \"one.svg\")\nstart a = circle(100)\n"
                               "place(file(f), 16, 20) : a -> placed, rest\n");
    EXPECT_EQ(looped.ran.status, 1);
}

TEST(Forms, CurvesAreDrawnOrDoubleBack) {
    const TestFolder folder;
    for (const char* curve : {"circ", "spiral", "rays", "path(\"M 0 0 C 10 -20 30 20 40 0\")",
                              "path(\"M 0 0 C 40 0 30 30 10 20 C -10 10 0 -20 30 -10\")"}) {
        for (const char* dual : {"", ", dual: yes"}) {
            const Grown one = grown(
                folder, "start a = circle(100)\nregular_split(" + std::string(curve) + ", 15" + dual + ") : a -> b\n");
            EXPECT_EQ(one.ran.status, 0) << curve << one.ran.out;
            ASSERT_EQ(one.ran.status, 0);
            EXPECT_GE(one.stats["elements"], 2) << curve;  // a spiral has two arms
        }
    }
}

TEST(Forms, ASplitFarTooFineIsRefusedBeforeItIsMade) {
    const TestFolder folder;
    for (const char* split : {"regular_split(line, 0.02, dual: yes)", "regular_split(circ, 0.02, dual: yes)",
                              "streamline_split(smooth, 0.02)", "voronoi(0.2)", "place(0.2, 0.3)", "stipple(0.2)",
                              "regular_split(rays, 0.02)", "radial(100000, rings: 100000)"}) {
        const Grown one = grown(folder, "start a = circle(2000)\n" + std::string(split) + " : a -> b\n");
        EXPECT_TRUE(one.ran.status == 4 || one.ran.status == 1) << split << one.ran.status << one.ran.out;
    }
}

TEST(Forms, EveryLetterIsAShapeAndRightToLeftIsShaped) {
    const TestFolder folder;
    std::filesystem::copy(starts + "LeagueSpartan-Black.otf", folder / "bold.otf");
    std::filesystem::copy(starts + "dejavu_sans_subset.ttf", folder / "arabic.ttf");
    const Grown word = grown(folder, "start a = text(\"LACE\", font: \"bold.otf\", size: 100)\nungroup() : a -> b\n");
    ASSERT_EQ(word.ran.status, 0) << word.ran.out;
    EXPECT_EQ(word.stats["elements"], 4);
    // Seen, lam with alef as one ligature, meem.
    const Grown peace =
        grown(folder, "start a = text(\"\u0633\u0644\u0627\u0645\", font: \"arabic.ttf\", size: 100)\n");
    ASSERT_EQ(peace.ran.status, 0) << peace.ran.out;
    EXPECT_EQ(peace.stats["elements"], 3);
    const Grown lacking = grown(folder, "start a = text(\"L\u4e2d\", font: \"bold.otf\")\n");
    EXPECT_EQ(lacking.ran.status, 0);
    EXPECT_NE(lacking.ran.out.find("warning"), std::string::npos) << lacking.ran.out;
}

TEST(Forms, APicturesDarkPartsAndItsTones) {
    const TestFolder folder;
    std::filesystem::copy(starts + "pear.png", folder / "pear.png");
    const Grown dark = grown(folder, "start a = image(\"pear.png\", width: 300, threshold: 0.6)\n");
    ASSERT_EQ(dark.ran.status, 0) << dark.ran.out;
    EXPECT_GE(dark.stats["elements"], 1);
    const auto dots = [&](const std::string& density) {
        const Grown one =
            grown(folder, "start a = rectangle(200, 200)\nstipple(4, density: " + density + ") : a -> g, d\n");
        EXPECT_EQ(one.ran.status, 0) << density << one.ran.out;
        return one.ran.status == 0 ? one.stats["tangle"]["marks"].get<int>() : 0;
    };
    const int all = dots("1"), half = dots("0.5"), ramp = dots("gradient(1, 0)"), picture = dots("image(\"pear.png\")");
    EXPECT_NEAR(half, all / 2, all / 8);
    EXPECT_NEAR(ramp, all / 2, all / 8);
    EXPECT_GT(picture, all / 20);
    EXPECT_LT(picture, all);
}

TEST(Forms, APdfReopensToTheSameDrawing) {
    const TestFolder folder;
    std::filesystem::copy(starts + "leaf_motif.svg", folder / "leaf.svg");
    ASSERT_EQ(grown(folder, "seed 9\nstart a = circle(80)\nplace(file(\"leaf.svg\"), 16, 20) : a -> b, c\n").ran.status,
              0);
    ASSERT_EQ(run_program("render " + folder / "a.fil" + " -o " + folder / "a.pdf").status, 0);
    EXPECT_EQ(folder.read("a.pdf").substr(0, 5), "%PDF-");
    std::filesystem::remove(folder / "leaf.svg");
    std::filesystem::remove(folder / "a.fil");
    ASSERT_EQ(run_program("render " + folder / "a.pdf" + " -o " + folder / "b.svg" + " -o " + folder / "b.pdf").status,
              0);
    EXPECT_EQ(folder.read("a.svg"), folder.read("b.svg"));
    EXPECT_EQ(folder.read("a.pdf"), folder.read("b.pdf"));
}

TEST(Symmetries, CopiesFillTheTileAndCanBePicked) {
    const TestFolder folder;
    for (const char* group : {"p1", "p2", "pm", "pg", "cm", "pmm", "pmg", "pgg", "cmm", "p4", "p4m", "p4g", "p3",
                              "p3m1", "p31m", "p6", "p6m", "c5", "d8"}) {
        const std::string name = group;
        const bool is_rosette = name == "c5" || name == "d8";
        const Grown one = grown(folder, "symmetry " + name + "\n" + (is_rosette ? "" : "page 400 x 400\n") +
                                            "start a = cell(200)\nregular_split(line, 20, dual: yes) : a -> b\n");
        ASSERT_EQ(one.ran.status, 0) << group << one.ran.out;
        const Ran picked = run_program("pick " + folder / "a.fil" + " --at=-60,-35");
        EXPECT_EQ(picked.status, 0) << group << picked.out;
        EXPECT_NE(picked.out.find("regular_split"), std::string::npos) << group << picked.out;
    }
}

TEST(Symmetries, ATileIsExactlyOnePeriod) {
    const TestFolder folder;
    ASSERT_EQ(grown(folder, "page tile 100 x 80\nstart a = circle(70)\nregular_split(line, 9) : a -> b\n").ran.status,
              0);
    const std::string svg = folder.read("a.svg");
    EXPECT_NE(svg.find("width=\"100\" height=\"80\""), std::string::npos) << svg.substr(0, 400);
}

}  // namespace
}  // namespace filigree
