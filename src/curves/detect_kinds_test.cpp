// Left sides of lines, labelled points, arcs and cubics, and of several kinds.
#include <gtest/gtest.h>

#include "base/elementary.h"
#include "curves/curve_test_shapes.h"
#include "curves/detect.h"
#include "curves/symmetry.h"

namespace filigree::curves {
namespace {

using test_shapes::moved;
using test_shapes::shape_of;

constexpr double pi = elementary::pi;

Matches matches_of(const Shape& left, const Shape& design, const MatchOptions& options = {}) {
    return find_matches(left, MatchIndex(design, options.tolerance), options);
}
MatchOptions within(MatchGroup group) {
    MatchOptions options;
    options.group = group;
    return options;
}
Element point_of(Vec place, std::uint32_t label) {
    Element e = point_element(place);
    e.layer = label;
    return e;
}
Shape together(const std::vector<Shape>& shapes) {
    std::vector<Element> elements;
    for (const Shape& s : shapes) elements.insert(elements.end(), s.elements.begin(), s.elements.end());
    return shape_of(elements);
}

// A grid of whole lines: 4 by 3 cells.
Shape grid() {
    std::vector<Element> lines;
    for (int x = 0; x <= 4; ++x) lines.push_back(line_element({1.0 * x, 0}, {1.0 * x, 3}));
    for (int y = 0; y <= 3; ++y) lines.push_back(line_element({0, 1.0 * y}, {4, 1.0 * y}));
    return shape_of(lines);
}
Shape square() {
    return shape_of({line_element({0, 0}, {1, 0}), line_element({1, 0}, {1, 1}), line_element({1, 1}, {0, 1}),
                     line_element({0, 1}, {0, 0})});
}

TEST(DetectKinds, AllSquaresOfAGridAreFoundInLinesThatRunOn) {
    EXPECT_EQ(symmetries(square(), {}).size(), 8U);
    // 12 of one cell, 6 of two by two, 2 of three by three.
    const Matches matches = matches_of(square(), grid());
    ASSERT_EQ(matches.found.size(), 20U);
    EXPECT_EQ(matches.found[0].scale, 1);
    EXPECT_EQ(matches.found[12].scale, 2);
    EXPECT_EQ(matches.found[18].scale, 3);
    EXPECT_EQ(matches_of(square(), grid(), within(MatchGroup::isometry)).found.size(), 12U);
    EXPECT_EQ(matches_of(square(), grid(), within(MatchGroup::translation)).found.size(), 12U);
    const Shape turned = moved(grid(), compose(rotation_degrees(27), scaling(3, -3)));
    EXPECT_EQ(matches_of(square(), turned).found.size(), 20U);
    EXPECT_EQ(matches_of(square(), turned, within(MatchGroup::translation)).found.size(), 0U);
}

TEST(DetectKinds, LinesThatDoNotTouchFixATransformByWhereTheirCarriersCross) {
    // A triangle without its corners.
    const Shape left =
        shape_of({line_element({2, 0}, {8, 0}), line_element({9, 1.5}, {6, 6}), line_element({4, 6}, {1, 1.5})});
    const Shape design =
        together({moved(left, compose(translation({30, 4}), compose(rotation_degrees(77), scaling(2, 2)))),
                  moved(left, translation({-20, 3})), grid()});
    const Matches matches = matches_of(left, design);
    ASSERT_EQ(matches.found.size(), 2U);
    EXPECT_NEAR(matches.found[1].scale, 2, 1e-12);
    EXPECT_NEAR(matches.found[1].angle_degrees, 77, 1e-9);
}

TEST(DetectKinds, ALabelledPointAloneFixesATranslation) {
    const Shape left = shape_of({point_of({1, 2}, 3)});
    const Shape design = shape_of({point_of({4, 2}, 3), point_of({5, 7}, 3), point_of({5, 8}, 4)});
    const Matches matches = matches_of(left, design, within(MatchGroup::translation));
    ASSERT_EQ(matches.found.size(), 2U);
    EXPECT_EQ(matches.found[0].by, translation({3, 0}));
    EXPECT_EQ(matches.found[1].by, translation({4, 5}));
}

TEST(DetectKinds, PointsMatchByTheirLabels) {
    const Shape left = shape_of({point_of({0, 0}, 1), point_of({1, 0}, 2), point_of({0, 1}, 2)});
    const Shape copy = moved(left, compose(translation({7, 7}), compose(rotation_degrees(30), scaling(2, 2))));
    Shape other = moved(left, translation({20, 0}));
    for (Element& e : other.elements) e.layer = 2;
    const Shape design = together({copy, other});
    const Matches matches = matches_of(left, design);
    ASSERT_EQ(matches.found.size(), 1U);  // it is its own mirror image
    EXPECT_NEAR(matches.found[0].scale, 2, 1e-12);
    EXPECT_EQ(symmetries(left, {}).size(), 2U);
}

TEST(DetectKinds, ACircleWithALineIsFixed) {
    const Shape left = shape_of({circle_element({0, 0}, 1), line_element({0, 0}, {3, 0})});
    const Shape design = shape_of({circle_element({5, 5}, 2), line_element({5, 1}, {5, 20}),
                                   line_element({5, 5}, {11, 5}), circle_element({5, 5}, 1)});
    // The small circle has room in both directions of the long line, the large one only upwards; the short line
    // carries both.
    const Matches matches = matches_of(left, design);
    EXPECT_EQ(symmetries(left, {}).size(), 2U);
    ASSERT_EQ(matches.found.size(), 5U);
    EXPECT_EQ(matches.found[0].angle_degrees, 270);
    EXPECT_EQ(matches.found[4].scale, 2);
}

TEST(DetectKinds, ArcsLieOnLongerArcsOfTheSameCircle) {
    const Shape left = shape_of({arc_element({0, 0}, {1, 0}, {0, 1}, 0, pi / 2), point_of({3, 0}, 1)});
    const Shape quarter = shape_of({arc_element({10, 0}, {2, 0}, {0, 2}, -0.1, pi / 2), point_of({16, 0}, 1)});
    const Shape eighth = shape_of({arc_element({20, 0}, {1, 0}, {0, 1}, 0.01, pi / 2), point_of({23, 0}, 1)});
    const Shape round = shape_of({circle_element({30, 0}, 1), point_of({33, 0}, 1)});
    EXPECT_EQ(matches_of(left, quarter).found.size(), 1U);
    EXPECT_EQ(matches_of(left, eighth).found.size(), 0U);
    EXPECT_EQ(matches_of(left, round).found.size(), 2U);
}

TEST(DetectKinds, AnEllipseFixesATransformButForItsSymmetries) {
    const Shape whole = shape_of({arc_element({0, 0}, {3, 0}, {0, 1}, -pi, pi)});
    EXPECT_EQ(symmetries(whole, {}).size(), 4U);
    const Shape design = moved(whole, compose(translation({4, 4}), compose(rotation_degrees(20), scaling(2, 2))));
    EXPECT_EQ(matches_of(whole, design).found.size(), 1U);
    const Shape part = shape_of({arc_element({0, 0}, {3, 0}, {0, 1}, 0.1, 1)});
    EXPECT_EQ(symmetries(part, {}).size(), 1U);
    EXPECT_EQ(matches_of(part, design).found.size(), 4U);
    const Shape rounder = shape_of({arc_element({0, 0}, {3, 0}, {0, 1.01}, 0.1, 1)});
    EXPECT_EQ(matches_of(rounder, design).found.size(), 0U);
}

TEST(DetectKinds, CubicsAreFoundInLongerCubics) {
    const Element whole = cubic_element({0, 0}, {4, 9}, {9, -7}, {12, 3});
    const Shape left = shape_of({piece_of(whole, {0.2, 0.7})});
    const Transform by = compose(translation({40, 4}), compose(rotation_degrees(123), scaling(0.5, -0.5)));
    const Matches matches = matches_of(left, shape_of({whole, transformed(whole, by)}));
    ASSERT_EQ(matches.found.size(), 2U);
    EXPECT_NEAR(matches.found[0].scale, 0.5, 1e-9);
    EXPECT_TRUE(matches.found[0].is_reflected);
    EXPECT_NEAR(matches.found[0].by.e, 40, 1e-8);
    EXPECT_EQ(matches_of(left, shape_of({piece_of(whole, {0.2005, 1})})).found.size(), 0U);
}

TEST(DetectKinds, ACubicThatIsItsOwnHalfTurnIsOneMatch) {
    const Shape wave = shape_of({cubic_element({0, 0}, {2, 4}, {4, -4}, {6, 0})});
    EXPECT_EQ(symmetries(wave, {}).size(), 2U);
    const Transform by = compose(translation({40, 4}), rotation_degrees(200));
    EXPECT_EQ(matches_of(wave, moved(wave, by)).found.size(), 1U);
    const Shape half = shape_of({piece_of(wave.elements[0], {0, 0.5})});
    EXPECT_EQ(matches_of(half, wave).found.size(), 2U);
}

TEST(DetectKinds, ARoundedDrawingOfLinesMatchesAtAnyRotation) {
    for (int turn = 0; turn < 40; ++turn) {
        SCOPED_TRACE(turn);
        const Transform by =
            compose(translation({0.1234 * turn, 7.6}), compose(rotation_degrees(turn * 9.0 + 0.37), scaling(25, 25)));
        Shape design = moved(grid(), by);
        for (Element& e : design.elements) {
            for (Vec& p : e.at) p = {std::round(p.x * 1e4) * 1e-4, std::round(p.y * 1e4) * 1e-4};
        }
        MatchOptions options;
        options.tolerance = 1e-4;
        EXPECT_EQ(matches_of(square(), design, options).found.size(), 20U);
        options.tolerance = 1e-3;
        EXPECT_EQ(matches_of(square(), design, options).found.size(), 20U);
    }
}

}  // namespace
}  // namespace filigree::curves
