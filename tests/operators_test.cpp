// The tangle's operators on inputs with closed-form answers.
#include <gtest/gtest.h>

#include <cmath>

#include "engines/tangle/verify.h"
#include "tests/grown.h"

namespace filigree {
namespace {

using tangle::Group;

struct Grown : GrownDocument {
    // All groups of a tag, in order.
    std::vector<const Group*> groups(std::string_view tag) const {
        std::vector<const Group*> found;
        for (const Group& group : tangle.groups) {
            if (checked.grammar->tags[group.tag] == tag) found.push_back(&group);
        }
        return found;
    }
    std::size_t shapes(std::string_view tag) const {
        std::size_t count = 0;
        for (const Group* group : groups(tag)) count += group->shapes.size();
        return count;
    }
    double area_of(std::string_view tag) const {
        double sum = 0;
        for (const Group* group : groups(tag)) {
            for (const tangle::Shape& shape : group->shapes) sum += area(tangle.polygon(shape));
        }
        return sum;
    }
};

std::unique_ptr<Grown> grow(const std::string& rules) { return grown_document<Grown>(rules); }

TEST(RegularSplit, KeepsTheDistanceAndBothEndsEqual) {
    const auto grown = grow("start a = rectangle(100, 46)\nregular_split(line, 10, angle: 0) : a -> b\n");
    const std::vector<tangle::Shape>& strips = grown->groups("b").front()->shapes;
    ASSERT_EQ(strips.size(), 6U);  // cuts at -20, -10, 0, 10, 20: ends of 3, kept since they are no slivers
    const std::vector<double> heights = {3, 10, 10, 10, 10, 3};
    for (std::size_t i = 0; i < strips.size(); ++i) {
        EXPECT_NEAR(area(grown->tangle.polygon(strips[i])), 100 * heights[i], 1e-6);
        EXPECT_EQ(strips[i].column, static_cast<int>(i) - 3);
    }
}

TEST(RegularSplit, SliversAtTheEndsJoinTheirNeighbours) {
    const auto grown = grow("start a = rectangle(100, 44)\nregular_split(line, 10, angle: 0) : a -> b\n");
    const std::vector<tangle::Shape>& strips = grown->groups("b").front()->shapes;
    ASSERT_EQ(strips.size(), 4U);  // the ends would be 2 px thin
    EXPECT_NEAR(area(grown->tangle.polygon(strips.front())), 1200, 1e-6);
    EXPECT_NEAR(area(grown->tangle.polygon(strips.back())), 1200, 1e-6);
}

TEST(RegularSplit, FitStretchesToWholeStrips) {
    const auto grown = grow("start a = rectangle(100, 46)\nregular_split(line, 10, angle: 0, fit: true) : a -> b\n");
    const std::vector<tangle::Shape>& strips = grown->groups("b").front()->shapes;
    ASSERT_EQ(strips.size(), 5U);
    for (const tangle::Shape& strip : strips) EXPECT_NEAR(area(grown->tangle.polygon(strip)), 920, 1e-5);
}

TEST(RegularSplit, FlagsAreSaidInManyWays) {
    const auto pieces = [](const std::string& arguments) {
        return grow("start a = rectangle(80, 60)\nregular_split(" + arguments + ", angle: 0) : a -> b\n")->shapes("b");
    };
    for (const char* yes : {"line, 20, 1", "line, 20, dual", "line, 20, true", "20, dual: yes", "20, dual: 1"}) {
        EXPECT_EQ(pieces(std::string(yes) + ", fit: yes"), 12U) << yes;
    }
    for (const char* no : {"line, 20, 0", "line, 20, false", "20, dual: no", "20"}) {
        EXPECT_EQ(pieces(std::string(no) + ", fit: yes"), 3U) << no;
    }
}

TEST(RegularSplit, OffsetsCycle) {
    const auto grown =
        grow("start a = rectangle(60, 90)\nregular_split(line, [10, 20], angle: 0, fit: true) : a -> b\n");
    const std::vector<tangle::Shape>& strips = grown->groups("b").front()->shapes;
    ASSERT_EQ(strips.size(), 6U);
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_NEAR(area(grown->tangle.polygon(strips[i])), i % 2 == 0 ? 600 : 1200, 1e-5);
    }
}

TEST(RegularSplit, DualIsAGridAndRegroupTwoAChessboard) {
    const auto grown = grow(
        "start a = rectangle(80, 60)\nregular_split(line, 20, dual: true, angle: 0, fit: true) : a -> b\n"
        "regroup(2) : b -> c\ninvert() : c when mod(group, 2) == 0 -> dark\n");
    EXPECT_EQ(grown->shapes("b"), 12U);
    ASSERT_EQ(grown->groups("c").size(), 2U);
    for (const Group* group : grown->groups("c")) {
        EXPECT_EQ(group->shapes.size(), 6U);
        for (const tangle::Shape& shape : group->shapes) {
            EXPECT_EQ((shape.column + shape.row) & 1, (group->shapes[0].column + group->shapes[0].row) & 1);
        }
    }
    EXPECT_EQ(grown->shapes("dark"), 6U);
    EXPECT_NEAR(grown->area_of("dark"), 2400, 1e-6);
}

TEST(RegularSplit, ThePageAnchorAlignsNeighbours) {
    const auto grown = grow(
        "start a = rectangle(40, 33, at: (0, 0))\nstart a = rectangle(40, 77, at: (40, 10))\n"
        "regular_split(line, 10, angle: 0, anchor: page) : a -> b\n");
    for (const tangle::Shape& strip : grown->groups("b").front()->shapes) {
        const Box box = bounds(grown->tangle.polygon(strip));
        const double low = to_px(box.min).y, high = to_px(box.max).y;
        EXPECT_LE(std::floor(low / 10) + 1, std::ceil(high / 10) + 1e-9);
        EXPECT_LE(high - low, 10 + 1e-9);
    }
}

TEST(Outline, BandAndInsideOfASquare) {
    const auto grown = grow("start a = rectangle(100, 60)\noutline(5) : a -> inside, band\n");
    EXPECT_NEAR(grown->area_of("inside"), 90 * 50, 1e-6);
    EXPECT_NEAR(grown->area_of("band"), 6000 - 4500, 1e-6);
}

TEST(Outline, WhatVanishesIsAllBand) {
    const auto grown = grow("start a = rectangle(100, 8)\noutline(5) : a -> inside, band\n");
    EXPECT_EQ(grown->shapes("inside"), 0U);
    EXPECT_NEAR(grown->area_of("band"), 800, 1e-6);
}

TEST(Outline, EachShapeItsOwnDistance) {
    const auto grown = grow(
        "start a = rectangle(100, 100)\nregular_split(line, 20, angle: 0, fit: true) : a -> b\n"
        "outline(each(index)) : b -> inside, band\n");
    const std::vector<tangle::Shape>& insides = grown->groups("inside").front()->shapes;
    ASSERT_EQ(insides.size(), 5U);
    for (std::size_t i = 0; i < 5; ++i) {
        const double distance = static_cast<double>(i + 1);
        EXPECT_NEAR(area(grown->tangle.polygon(insides[i])), (100 - 2 * distance) * (20 - 2 * distance), 1e-5);
    }
}

TEST(Place, DiscsKeepApartAndInside) {
    const auto grown = grow("start a = circle(100)\nplace(12, 15) : a -> disc, rest\n");
    const std::vector<tangle::Shape>& discs = grown->groups("disc").front()->shapes;
    EXPECT_GT(discs.size(), 60U);
    std::vector<Vec> centres;
    for (const tangle::Shape& disc : discs) {
        const Vec centre = centroid(grown->tangle.polygon(disc));
        for (const Vec other : centres) EXPECT_GE(length(centre - other), 15 - 1e-3);
        EXPECT_LE(length(centre), 94 + 1e-3);
        centres.push_back(centre);
    }
    EXPECT_EQ(grown->shapes("rest"), 1U);
    EXPECT_EQ(tangle::broken_invariants(grown->tangle), std::vector<std::string>{});
}

TEST(Place, ShapesLargerThanTheSpacingShrink) {
    const auto grown = grow("start a = circle(60)\nplace(30, 12) : a -> disc, rest\n");
    EXPECT_GT(grown->shapes("disc"), 30U);
    EXPECT_EQ(tangle::broken_invariants(grown->tangle), std::vector<std::string>{});
}

TEST(Stipple, DotsAreMarksAndTheGroundStaysWhole) {
    const auto grown = grow("start a = rectangle(100, 60)\nstipple(5, size: 2) : a -> ground, dots\n");
    EXPECT_NEAR(grown->area_of("ground"), 6000, 1e-9);
    EXPECT_GT(grown->shapes("dots"), 120U);
    for (const tangle::Shape& dot : grown->groups("dots").front()->shapes) EXPECT_TRUE(dot.is_mark);
    EXPECT_EQ(tangle::broken_invariants(grown->tangle), std::vector<std::string>{});
}

TEST(Grouping, UngroupGivesEveryShapeAGroup) {
    const auto grown =
        grow("start a = rectangle(100, 100)\nregular_split(line, 20, angle: 0) : a -> b\nungroup() : b -> c\n");
    EXPECT_EQ(grown->groups("c").size(), grown->shapes("b"));
}

TEST(Grouping, RegroupById) {
    const auto grown = grow(
        "start a = rectangle(100, 100)\nregular_split(line, 20, angle: 0, fit: true) : a -> b\nregroup(3, by: id) : b "
        "-> c\n");
    ASSERT_EQ(grown->groups("c").size(), 3U);
    EXPECT_EQ(grown->groups("c")[0]->shapes.size(), 2U);
    EXPECT_EQ(grown->groups("c")[2]->shapes.size(), 1U);
}

TEST(Decoration, InvertTakesAllOrEverySecond) {
    const auto grown = grow(
        "start a = rectangle(80, 60)\nregular_split(line, 20, dual: true, angle: 0, fit: true) : a -> b\n"
        "invert(even) : b -> dark, light\ninvert() : dark -> again\n");
    EXPECT_EQ(grown->shapes("dark"), 6U);
    EXPECT_EQ(grown->shapes("light"), 6U);
    for (const tangle::Shape& shape : grown->groups("dark").front()->shapes) {
        EXPECT_TRUE(shape.inked);
        EXPECT_EQ((shape.column + shape.row) & 1, 0);
    }
    for (const tangle::Shape& shape : grown->groups("light").front()->shapes) EXPECT_FALSE(shape.inked);
    for (const tangle::Shape& shape : grown->groups("again").front()->shapes) EXPECT_FALSE(shape.inked);
}

TEST(Rules, TheLowestGroupGoesNextAndOutputsAreOneGroupEach) {
    const auto grown = grow(
        "start a = rectangle(100, 100)\nregular_split(line, 20, angle: 0) : a -> b\noutline(2) : b -> c, d\n"
        "regular_split(line, 3) : d -> e\nregular_split(line, 3) : c -> f\n");
    ASSERT_EQ(grown->tangle.steps.size(), 4U);
    EXPECT_EQ(grown->groups("c").size(), 1U);
    EXPECT_EQ(grown->groups("d").size(), 1U);
    for (std::size_t s = 1; s < 4; ++s) EXPECT_GT(grown->tangle.steps[s].group, grown->tangle.steps[s - 1].group);
}

TEST(Rules, WeightsDecideHowOften) {
    int first = 0;
    const int draws = 2000;
    for (int seed = 0; seed < draws; ++seed) {
        const auto grown =
            grow("seed " + std::to_string(seed) +
                 "\nstart a = rectangle(10, 10)\none = invert() : a weight 3 -> b\ntwo = invert() : a -> c\n");
        first += grown->shapes("b") == 1 ? 1 : 0;
    }
    EXPECT_NEAR(first, 0.75 * draws, 4 * std::sqrt(draws * 0.75 * 0.25));
}

TEST(Rules, AnAppendedRuleChangesOnlyTheDrawsThatItWins) {
    const std::string head =
        "start a = rectangle(400, 400)\nregular_split(line, 20, dual: true, angle: 0, fit: true) : a -> "
        "cell\nungroup() : cell -> c\n"
        "one = invert() : c -> x\ntwo = invert() : c weight 2 -> y\n";
    const auto before = grow(head), after = grow(head + "three = invert() : c weight 1 -> z\n");
    int changed = 0, total = 0;
    for (std::size_t s = 0; s < before->tangle.steps.size(); ++s) {
        const std::uint32_t old_rule = before->tangle.steps[s].rule, new_rule = after->tangle.steps[s].rule;
        if (before->tangle.groups[before->tangle.steps[s].group].depth < 2) continue;
        ++total;
        if (old_rule == new_rule) continue;
        ++changed;
        EXPECT_EQ(new_rule, 4U);
    }
    EXPECT_EQ(total, 400);
    EXPECT_NEAR(changed, 100, 4 * std::sqrt(400 * 0.25 * 0.75));
}

TEST(Starts, LaterOnesCoverEarlierOnes) {
    const auto grown = grow("start a = rectangle(100, 100)\nstart b = rectangle(40, 40)\n");
    EXPECT_NEAR(grown->area_of("a"), 10000 - 1600, 1e-6);
    EXPECT_NEAR(grown->area_of("b"), 1600, 1e-6);
}

TEST(Starts, UnionSwallowsItsOwnTag) {
    const auto grown =
        grow("start a = rectangle(100, 100)\nstart a = rectangle(100, 100, at: (50, 0), overlap: union)\n");
    EXPECT_EQ(grown->shapes("a"), 1U);
    EXPECT_NEAR(grown->area_of("a"), 15000, 1e-6);
}

TEST(Starts, NothingOffThePlaneIsDroppedWithoutAWord) {
    const std::string svg =
        "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='100'><g id='hair'>"
        "<rect width='40' height='20'/></g></svg>";
    const std::string far = "start a = file(\"p.svg\", width: 1000000000px)\nstart a = circle(1px, at: (2e9px, 0px))\n";
    const OpenedDocument opened = open_text("a.fil", "grammar tangle\n" + far, {{"p.svg", svg}});
    const CheckedDocument checked = check_document(opened);
    ASSERT_TRUE(has_errors(checked.diagnostics));
    EXPECT_EQ(checked.diagnostics.front().code, "start.off-plane");
}

TEST(Starts, LayersOfAnSvgBecomeTags) {
    const std::string svg =
        "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='100'><g id='hair'><rect width='40' "
        "height='20'/></g>"
        "<g id='face'><circle cx='60' cy='60' r='30'/></g></svg>";
    const OpenedDocument opened =
        open_text("a.fil", "grammar tangle\nstart from \"p.svg\"\noutline(2) : hair -> b, c\n", {{"p.svg", svg}});
    const CheckedDocument checked = check_document(opened);
    ASSERT_FALSE(has_errors(checked.diagnostics)) << to_text(checked.diagnostics, opened.document.sources);
    ASSERT_EQ(checked.start->groups.size(), 2U);
    EXPECT_EQ(checked.start->groups[0].tag, "hair");
    EXPECT_NEAR(area(checked.start->polygons[0]), 800, 1e-6);
    EXPECT_NEAR(area(checked.start->polygons[1]), 3.14159265 * 900, 2 * 3.14159265 * 30 * 0.1);
}

}  // namespace
}  // namespace filigree
