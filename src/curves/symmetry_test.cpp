#include "curves/symmetry.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/elementary.h"
#include "curves/algebra.h"
#include "curves/curve_test_shapes.h"
#include "curves/detect.h"

namespace filigree::curves {
namespace {

using test_shapes::flower;
using test_shapes::moved;
using test_shapes::opened_flower;
using test_shapes::petal;
using test_shapes::shape_of;

constexpr double tolerance = 1e-6;

std::size_t order_of(const Shape& shape) { return symmetries(shape, {}).size(); }

TEST(Symmetry, NothingIsCarriedOntoItself) { EXPECT_EQ(symmetries({}, {}).size(), 1U); }

TEST(Symmetry, OfShapesThatAreKnown) {
    EXPECT_EQ(order_of(petal()), 2U);
    EXPECT_EQ(order_of(flower()), 8U);
    const Shape lens =
        shape_of({parabola_element({-2, 0}, {0, 2}, {2, 0}), parabola_element({-2, 0}, {0, -2}, {2, 0})});
    EXPECT_EQ(order_of(lens), 4U);
    EXPECT_EQ(order_of(shape_of({parabola_element({-2, 0}, {0, 2}, {2, 0})})), 2U);
    std::vector<Element> hexagon;
    for (int i = 0; i < 6; ++i) {
        hexagon.push_back(line_element(unit_at_degrees(60.0 * i), unit_at_degrees(60.0 * (i + 1))));
    }
    EXPECT_EQ(order_of(shape_of(hexagon)), 12U);
    hexagon[0].weight = 2;
    EXPECT_EQ(order_of(shape_of(hexagon)), 2U);
    hexagon[0].layer = 3;
    EXPECT_EQ(order_of(shape_of(hexagon)), 2U);
}

TEST(Symmetry, CarriesTheShapeOntoItself) {
    for (const Symmetry& g : symmetries(flower(), {})) {
        EXPECT_TRUE(are_equal(transformed(flower(), g.by), flower(), tolerance));
        for (std::uint32_t i = 0; i < 4; ++i) {
            EXPECT_NE(std::count(g.images.begin(), g.images.end(), i), 0);
        }
    }
    MatchOptions options;
    options.group = MatchGroup::translation;
    EXPECT_EQ(symmetries(flower(), options).size(), 1U);
}

TEST(Symmetry, ARuleHasAsManyVariantsAsPictures) {
    const std::vector<Symmetry> own = symmetries(petal(), {});
    // Drawn out along its axis a petal is still its own mirror image; beside it is not.
    const Shape along = moved(petal(), translation({-2, -2})), beside = moved(petal(), translation({-2, 1}));
    EXPECT_EQ(variants(own, along, {}, tolerance).size(), 1U);
    const std::vector<Symmetry> two = variants(own, beside, {}, tolerance);
    ASSERT_EQ(two.size(), 2U);
    EXPECT_FALSE(two[0].is_reflected);
    EXPECT_TRUE(two[1].is_reflected);
    // A condition may tell them apart as well.
    EXPECT_EQ(variants(own, along, std::vector<Shape>{beside}, tolerance).size(), 2U);
    EXPECT_EQ(variants(own, {}, {}, tolerance).size(), 1U);
}

// Vector 5 of the notes: 2 petals, moved inwards one after the other; 8, 6, 4 arcs; then 4 petals, the flower.
TEST(Symmetry, PetalsMovedInwardsMakeTheFlower) {
    Shape design = maximal(opened_flower(2), tolerance);
    EXPECT_EQ(design.elements.size(), 8U);
    const Shape right = moved(petal(), translation({-2, -2}));
    const std::vector<Symmetry> ways = variants(symmetries(petal(), {}), right, {}, tolerance);
    ASSERT_EQ(ways.size(), 1U);
    for (const std::size_t arcs : {6U, 4U}) {
        const Matches matches = find_matches(petal(), MatchIndex(design, tolerance), {});
        ASSERT_EQ(matches.found.size(), 2U);
        // Not the one that was moved already, which lies at the centre.
        const auto far =
            std::max_element(matches.found.begin(), matches.found.end(),
                             [](const Match& a, const Match& b) { return length(a.centroid) < length(b.centroid); });
        const Transform by = applications(*far, ways)[0];
        design = replaced(design, transformed(petal(), by), transformed(right, by), tolerance);
        EXPECT_EQ(design.elements.size(), arcs);
    }
    EXPECT_TRUE(are_equal(design, flower(), tolerance));
    EXPECT_EQ(find_matches(petal(), MatchIndex(design, tolerance), {}).found.size(), 4U);
}

TEST(Symmetry, ASquareThatIsTurnedAndGrownIsOneSquareAgain) {
    std::vector<Element> sides;
    for (int i = 0; i < 4; ++i) {
        sides.push_back(transformed(parabola_element({-1, -1}, {0, -2}, {1, -1}), rotation_degrees(90.0 * i)));
    }
    const Shape square = shape_of(sides);
    const Shape right = transformed(square, compose(rotation_degrees(45), scaling(1.5, 1.5)));
    const Matches matches = find_matches(square, MatchIndex(flower(), tolerance), {});
    ASSERT_EQ(matches.found.size(), 1U);
    const std::vector<Symmetry> ways = variants(symmetries(square, {}), right, {}, tolerance);
    EXPECT_EQ(ways.size(), 1U);
    const Transform by = applications(matches.found[0], ways)[0];
    const Shape design = replaced(flower(), transformed(square, by), transformed(right, by), tolerance);
    EXPECT_EQ(design.elements.size(), 12U);
    EXPECT_EQ(find_matches(square, MatchIndex(design, tolerance), {}).found.size(), 1U);
}

}  // namespace
}  // namespace filigree::curves
