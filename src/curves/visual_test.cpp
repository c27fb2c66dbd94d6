#include "curves/visual.h"

#include <gtest/gtest.h>

#include "base/elementary.h"
#include "curves/curve_test_shapes.h"
#include "curves/detect.h"

namespace filigree::curves {
namespace {

using test_shapes::flower;
using test_shapes::moved;
using test_shapes::petal;
using test_shapes::shape_of;

Matches look_alikes(const Shape& left, const Shape& design, double visual_tolerance, MatchOptions options = {}) {
    options.visual_tolerance = visual_tolerance;
    return find_look_alikes(left, MatchIndex(design, options.tolerance), options);
}

// A triangle with one side drawn as a parabola of low curvature.
Shape triangle(double bow) {
    const Element side = bow == 0 ? line_element({0, 0}, {6, 0}) : parabola_element({0, 0}, {3, 2 * bow}, {6, 0});
    return shape_of({side, line_element({6, 0}, {1, 4}), line_element({1, 4}, {0, 0})});
}
const Transform somewhere = compose(translation({20, -7}), compose(rotation_degrees(33), scaling(1.5, 1.5)));

TEST(Visual, AParabolaOfLowCurvatureLooksLikeALine) {
    const Shape design = moved(triangle(0.02), somewhere);
    EXPECT_TRUE(find_matches(triangle(0), MatchIndex(design, 1e-6), {}).found.empty());
    const Matches found = look_alikes(triangle(0), design, 0.1);
    ASSERT_EQ(found.found.size(), 1U);
    EXPECT_TRUE(found.found[0].is_visual);
    EXPECT_EQ(found.found[0].carriers.size(), 3U);
    EXPECT_NEAR(found.found[0].scale, 1.5, 0.05);
    EXPECT_GT(found.found[0].misfit, 0.01);
    EXPECT_LE(found.found[0].misfit, 1);
    EXPECT_TRUE(look_alikes(triangle(0), design, 0.002).found.empty());
    // And the other way round.
    EXPECT_EQ(look_alikes(triangle(0.02), moved(triangle(0), somewhere), 0.1).found.size(), 1U);
}

TEST(Visual, WhatIsFoundExactlyIsNoLookAlike) {
    EXPECT_TRUE(look_alikes(triangle(0), moved(triangle(0), somewhere), 0.1).found.empty());
    EXPECT_TRUE(look_alikes(petal(), flower(), 0.01).found.empty());
}

TEST(Visual, AnArcThatWasDrawnAsAQuadraticIsFound) {
    // A twelfth of a circle, and the quadratic with its ends and tangents there.
    const Element arc = arc_element({0, 0}, {10, 0}, {0, 10}, 0, elementary::pi / 6);
    const auto [first, last] = ends_of(arc);
    const Vec u = velocity_at(arc, arc.from), v = velocity_at(arc, arc.to);
    const Vec corner = first + u * (cross(last - first, v) / cross(u, v));
    const Shape left = shape_of({arc, line_element({0, 0}, first), line_element({0, 0}, last)});
    const Shape design =
        shape_of({parabola_element(first, corner, last), line_element({0, 0}, first), line_element({0, 0}, last)});
    const Matches found = look_alikes(left, moved(design, somewhere), 0.1);
    ASSERT_EQ(found.found.size(), 1U);
    EXPECT_LT(found.found[0].misfit, 0.5);
}

TEST(Visual, TwoPiecesThatGoOnInEachOtherNearlyAreOne) {
    const Shape left = shape_of({line_element({0, 0}, {10, 0})});
    MatchOptions options;
    options.group = MatchGroup::isometry;
    const Shape design = shape_of({line_element({3, 3}, {8, 3}), line_element({8, 3}, {13, 3.04})});
    const Matches found = look_alikes(left, design, 0.05, options);
    ASSERT_EQ(found.found.size(), 1U);
    const std::vector<Element> pieces =
        covered_pieces(left, MatchIndex(design, options.tolerance), found.found[0], 0.05);
    ASSERT_EQ(pieces.size(), 2U);
    EXPECT_NEAR(length_of(pieces[0]) + length_of(pieces[1]), 10, 0.1);
}

TEST(Visual, APieceOfWhatIsCoveredEndsWhereTheLeftSideEnds) {
    const Shape design = shape_of(
        {parabola_element({0, 0}, {10, 0.4}, {20, 0}), line_element({4, -3}, {4, 3}), line_element({12, -3}, {12, 3})});
    const Shape left =
        shape_of({line_element({0, 0}, {8, 0}), line_element({0, -1}, {0, 1}), line_element({8, -1}, {8, 1})});
    const Matches found = look_alikes(left, design, 0.1);
    ASSERT_FALSE(found.found.empty());
    for (const Match& match : found.found) {
        for (const Element& piece : covered_pieces(left, MatchIndex(design, 1e-6), match, 0.1)) {
            if (piece.kind != ElementKind::parabola) continue;
            EXPECT_LT(std::fabs(length_of(piece) - 8 * match.scale), 0.3);
        }
    }
}

TEST(Visual, LayersWeightsAndReflectionsCount) {
    Shape design = moved(triangle(0.02), compose(somewhere, scaling(-1, 1)));
    MatchOptions direct;
    direct.with_reflections = false;
    EXPECT_TRUE(look_alikes(triangle(0), design, 0.1, direct).found.empty());
    EXPECT_EQ(look_alikes(triangle(0), design, 0.1).found.size(), 1U);
    design.elements[0].weight = 0.5;
    EXPECT_TRUE(look_alikes(triangle(0), design, 0.1).found.empty());
    design.elements[0].weight = 1;
    design.elements[1].layer = 2;
    EXPECT_TRUE(look_alikes(triangle(0), design, 0.1).found.empty());
}

}  // namespace
}  // namespace filigree::curves
