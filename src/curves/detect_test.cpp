#include "curves/detect.h"

#include <gtest/gtest.h>

#include <array>

#include "base/elementary.h"
#include "curves/curve_test_shapes.h"
#include "curves/symmetry.h"

namespace filigree::curves {
namespace {

using test_shapes::flower;
using test_shapes::moved;
using test_shapes::opened_flower;
using test_shapes::petal;
using test_shapes::shape_of;

Matches matches_of(const Shape& left, const Shape& design, const MatchOptions& options = {}) {
    return find_matches(left, MatchIndex(design, options.tolerance), options);
}

TEST(Detect, FindsTheFourPetalsOfAFlowerThatNobodyDrewAsPetals) {
    const Matches matches = matches_of(petal(), flower());
    ASSERT_EQ(matches.found.size(), 4U);
    EXPECT_TRUE(matches.near_misses.empty());
    for (const Match& match : matches.found) {
        EXPECT_EQ(match.scale, 1);
        EXPECT_FALSE(match.is_reflected);
        EXPECT_FALSE(match.is_ambiguous);
        EXPECT_LT(match.misfit, 1e-8);
        EXPECT_EQ(match.carriers.size(), 2U);
    }
    // By their centroids, from left to right and from top to bottom.
    const std::array<double, 4> angles = {180, 90, 270, 0};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(matches.found[i].angle_degrees, angles[i]);
        EXPECT_NEAR(matches.found[i].by.e, 0, 1e-14);
        EXPECT_NEAR(matches.found[i].by.f, 0, 1e-14);
    }
}

TEST(Detect, FindsTwoPetalsHoweverFarTheyAreDrawnOut) {
    for (const double out : {-4.0, -3.0, -2.0, -1.0, -0.5, 0.5, 1.0, 3.0, 4.0, 6.0}) {
        SCOPED_TRACE(out);
        const Matches matches = matches_of(petal(), shape_of(opened_flower(out)));
        ASSERT_EQ(matches.found.size(), 2U);
        for (const Match& match : matches.found) {
            EXPECT_EQ(match.scale, 1);
            EXPECT_EQ(match.by.e, match.by.f);
            EXPECT_EQ(std::fabs(match.by.e), std::fabs(out));
        }
    }
}

// Vector 3 of the notes: the arc runs on beyond the end of the one that it is a similar copy of a part of.
TEST(Detect, AnArcThatStartsBeforeTheEndButRunsOnIsNotFound) {
    const Shape design = shape_of({parabola_element({0, 0}, {1, 0}, {2, 1})});
    const Shape part =
        shape_of({parabola_element({5.582265, -0.407229}, {8.163995, 0.121083}, {11.995725, -1.515668})});
    MatchOptions options;
    options.tolerance = 1e-5;
    EXPECT_TRUE(matches_of(part, design, options).found.empty());
}

TEST(Detect, ASquareOfCurvesIsFoundOnceHoweverSymmetricItIs) {
    std::vector<Element> sides;
    for (int i = 0; i < 4; ++i) {
        sides.push_back(transformed(parabola_element({-1, -1}, {0, -2}, {1, -1}), rotation_degrees(90.0 * i)));
    }
    const Shape square = shape_of(std::move(sides));
    EXPECT_EQ(symmetries(square, {}).size(), 8U);
    EXPECT_EQ(matches_of(square, flower()).found.size(), 1U);
    EXPECT_EQ(matches_of(square, shape_of(opened_flower(2))).found.size(), 0U);
    MatchOptions direct;
    direct.with_reflections = false;
    EXPECT_EQ(symmetries(square, direct).size(), 4U);
    EXPECT_EQ(matches_of(square, flower(), direct).found.size(), 1U);
}

TEST(Detect, FindsWhatWasReflectedOnlyWhereReflectionsAreAllowed) {
    // Half a petal has no symmetry.
    const Shape hook = shape_of({parabola_element({-1, -1}, {1, -3}, {3, 3})});
    EXPECT_EQ(symmetries(hook, {}).size(), 1U);
    MatchOptions direct;
    direct.with_reflections = false;
    EXPECT_EQ(matches_of(hook, flower()).found.size(), 8U);
    EXPECT_EQ(matches_of(hook, flower(), direct).found.size(), 4U);
    EXPECT_EQ(matches_of(hook, moved(hook, scaling(-2, 2)), direct).found.size(), 0U);
    const Matches mirrored = matches_of(hook, moved(hook, scaling(-2, 2)));
    ASSERT_EQ(mirrored.found.size(), 1U);
    EXPECT_TRUE(mirrored.found[0].is_reflected);
    EXPECT_EQ(mirrored.found[0].scale, 2);
    EXPECT_EQ(mirrored.found[0].angle_degrees, 180);
}

TEST(Detect, TheGroupAndTheScaleSayWhatIsAMatch) {
    std::vector<Element> elements = flower().elements;
    for (const Element& e : moved(flower(), compose(translation({40, 7}), rotation_degrees(30))).elements) {
        elements.push_back(e);
    }
    for (const Element& e : moved(flower(), compose(translation({-40, 7}), scaling(1.5, 1.5))).elements) {
        elements.push_back(e);
    }
    const Shape design = shape_of(elements);
    const auto count = [&](MatchGroup group, double min_scale = 0, double max_scale = 100) {
        MatchOptions options;
        options.group = group;
        options.min_scale = min_scale;
        options.max_scale = max_scale;
        return matches_of(petal(), design, options).found.size();
    };
    EXPECT_EQ(count(MatchGroup::translation), 1U);
    EXPECT_EQ(count(MatchGroup::isometry), 8U);
    EXPECT_EQ(count(MatchGroup::similarity), 12U);
    EXPECT_EQ(count(MatchGroup::similarity, 1.2), 4U);
    EXPECT_EQ(count(MatchGroup::similarity, 0, 1.2), 8U);
}

TEST(Detect, AHeavierElementCarriesALighterOneAndLayersAreApart) {
    Shape design = flower();
    design.elements[0].weight = 2;
    Shape left = petal();
    EXPECT_EQ(matches_of(left, design).found.size(), 4U);
    MatchOptions equal;
    equal.weights = WeightRule::equal;
    EXPECT_EQ(matches_of(left, design, equal).found.size(), 2U);
    for (Element& e : left.elements) e.weight = 2;
    EXPECT_EQ(matches_of(left, design).found.size(), 0U);
    for (Element& e : left.elements) e.weight = 1;
    for (Element& e : left.elements) e.layer = 1;
    EXPECT_EQ(matches_of(left, flower()).found.size(), 0U);
}

TEST(Detect, ADrawingOfSize100RoundedToFourDecimalsMatchesAtAnyRotation) {
    std::size_t ambiguous = 0;
    for (int turn = 0; turn < 90; ++turn) {
        SCOPED_TRACE(turn);
        // Off the centre, so that the four arcs are not rounded alike.
        const Transform by = compose(translation({0.12343 * turn, 7.65432}),
                                     compose(rotation_degrees(turn * 4.0 + 0.37), scaling(16, 16)));
        Shape design = moved(flower(), by);
        for (Element& e : design.elements) {
            for (Vec& p : e.at) p = {std::round(p.x * 1e4) * 1e-4, std::round(p.y * 1e4) * 1e-4};
        }
        MatchOptions options;
        options.tolerance = 1e-4;
        const Matches near = matches_of(petal(), design, options);
        EXPECT_EQ(near.found.size(), 4U);
        for (const Match& match : near.found) ambiguous += match.is_ambiguous;
        options.tolerance = 1e-3;
        const Matches matches = matches_of(petal(), design, options);
        EXPECT_EQ(matches.found.size(), 4U);
        EXPECT_TRUE(matches.near_misses.empty());
        for (const Match& match : matches.found) EXPECT_FALSE(match.is_ambiguous) << match.misfit;
    }
    EXPECT_GT(ambiguous, 300U);  // of 360
}

}  // namespace
}  // namespace filigree::curves
