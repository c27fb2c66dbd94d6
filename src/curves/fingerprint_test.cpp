#include "curves/fingerprint.h"

#include <gtest/gtest.h>

#include "curves/algebra.h"
#include "curves/test_cells.h"

namespace filigree::curves {
namespace {

constexpr double tolerance = 1e-6;
constexpr UpTo all_sorts[] = {UpTo::nothing, UpTo::translation, UpTo::isometry, UpTo::similarity};

Transform random_map(CaseRandom& random, UpTo up_to) {
    const Transform moved = translation(random_place(random, Coordinates::any, 50));
    if (up_to == UpTo::nothing) return {};
    if (up_to == UpTo::translation) return moved;
    const double scale = up_to == UpTo::similarity ? random.between(0.5, 3) : 1;
    return compose(
        moved, compose(scaling(scale, random.coin() ? scale : -scale), rotation_degrees(random.between(-180, 180))));
}

Shape noisy(const Shape& shape, CaseRandom& random, double by) {
    Shape moved;
    for (const Element& e : shape.elements) moved.elements.push_back(*own_form(shaken(e, random, by), 0));
    std::sort(moved.elements.begin(), moved.elements.end(), comes_before);
    return moved;
}

TEST(Fingerprint, RecognisesMovedDesigns) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(); ++seed) {
        CaseRandom random(seed);
        SCOPED_TRACE(seed);
        const World world = random_world(random, Coordinates::any);
        const Shape design = merged(runs_of(world, random_cells(random, world, 2)), tolerance);
        for (const UpTo up_to : all_sorts) {
            const Shape moved = noisy(transformed(design, random_map(random, up_to)), random, 0.01 * tolerance);
            ASSERT_TRUE(are_same_design(design, moved, up_to, tolerance)) << static_cast<int>(up_to);
            ASSERT_TRUE(are_same_design(moved, design, up_to, tolerance)) << static_cast<int>(up_to);
            DesignSet known(up_to, tolerance);
            EXPECT_EQ(known.find_or_add(design, 7), std::nullopt);
            EXPECT_EQ(known.find_or_add(moved, 8), 7U) << static_cast<int>(up_to);
        }
        if (!design.elements.empty()) {
            EXPECT_FALSE(are_same_design(design, transformed(design, translation({1, 0})), UpTo::nothing, tolerance));
        }
    }
}

TEST(Fingerprint, TellsOthersApart) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(); ++seed) {
        CaseRandom random(seed);
        SCOPED_TRACE(seed);
        const World world = random_world(random, Coordinates::any);
        const Cells cells = random_cells(random, world, 2);
        const Shape design = merged(runs_of(world, cells), tolerance);
        if (design.elements.size() < 2) continue;
        // The same elements, one of them moved a little against the others.
        Shape other = design;
        Element& e = other.elements[random.index(other.elements.size())];
        const Vec by = random_place(random, Coordinates::any, 0.02) + Vec{0.005, 0.005};
        if (length(by) < 0.001) continue;
        e = transformed(e, translation(by));
        other = merged(other.elements, tolerance);
        EXPECT_FALSE(are_same_design(design, other, UpTo::nothing, tolerance));
        EXPECT_FALSE(are_same_design(design, other, UpTo::translation, tolerance));
        if (design.elements.size() > 3) {
            EXPECT_FALSE(are_same_design(design, other, UpTo::isometry, tolerance));
            EXPECT_FALSE(are_same_design(design, other, UpTo::similarity, tolerance));
        }
    }
}

TEST(Fingerprint, TellsMirrorImagesApartWhereAsked) {
    const Shape hook = maximal({line_element({0, 0}, {4, 0}), line_element({4, 0}, {4, 1})}, tolerance);
    for (const UpTo up_to : {UpTo::isometry, UpTo::similarity}) {
        const Shape turned = transformed(hook, rotation_degrees(50)), mirrored = transformed(turned, scaling(1, -1));
        EXPECT_TRUE(are_same_design(hook, turned, up_to, tolerance, false));
        EXPECT_TRUE(are_same_design(hook, mirrored, up_to, tolerance));
        EXPECT_FALSE(are_same_design(hook, mirrored, up_to, tolerance, false));
        DesignSet known(up_to, tolerance, false);
        EXPECT_FALSE(known.find_or_add(hook, 0));
        EXPECT_FALSE(known.find_or_add(mirrored, 1));
        EXPECT_EQ(known.find_or_add(turned, 2), 0U);
    }
}

// Designs that some moves carry onto themselves, or that fix none.
TEST(Fingerprint, RecognisesDesignsThatFixFewMoves) {
    const auto rotated = [](std::vector<Element> elements, int copies) {
        std::vector<Element> all;
        for (int i = 0; i < copies; ++i) {
            for (const Element& e : elements) all.push_back(transformed(e, rotation_degrees(360.0 * i / copies)));
        }
        return maximal(std::move(all), tolerance);
    };
    const Element petal = parabola_element({1, 0}, {2, 2}, {4, 0});
    const std::vector<Shape> designs = {
        {},
        rotated({line_element({0, 0}, {3, 0})}, 1),
        rotated({line_element({0, 0}, {3, 0}), line_element({1, 1}, {2, 1})}, 1),
        rotated({line_element({0, 0}, {3, 0})}, 5),
        rotated({circle_element({1, 1}, 2)}, 1),
        rotated({circle_element({1, 1}, 2), circle_element({1, 1}, 3)}, 1),
        rotated({circle_element({1, 1}, 2), arc_element({1, 1}, {3, 0}, {0, 3}, 0, 1)}, 1),
        rotated({arc_element({1, 1}, {3, 0}, {0, 3}, 0, 1)}, 1),
        rotated({arc_element({1, 1}, {3, 0}, {0, 2}, -4, 4)}, 1),
        rotated({point_element({2, 1})}, 1),
        rotated({point_element({2, 1})}, 6),
        rotated({petal}, 1),
        rotated({petal}, 12),
        rotated({petal, line_element({4, 0}, {5, 0})}, 6),
        rotated({cubic_element({1, 0}, {2, 2}, {3, -1}, {4, 0})}, 3),
    };
    CaseRandom random(1);
    for (std::size_t i = 0; i < designs.size(); ++i) {
        for (const UpTo up_to : all_sorts) {
            for (int round = 0; round < 5; ++round) {
                const Shape moved = transformed(designs[i], random_map(random, up_to));
                EXPECT_TRUE(are_same_design(designs[i], moved, up_to, tolerance))
                    << i << ' ' << static_cast<int>(up_to);
            }
            for (std::size_t k = 0; k < designs.size(); ++k) {
                EXPECT_EQ(are_same_design(designs[i], designs[k], up_to, tolerance), i == k) << i << ' ' << k;
            }
        }
    }
}

}  // namespace
}  // namespace filigree::curves
