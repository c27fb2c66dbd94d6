#include "curves/contacts.h"

#include <gtest/gtest.h>

#include "curves/element_grid.h"
#include "curves/test_shapes.h"

namespace filigree::curves {
namespace {

TEST(Contacts, LinesCrossTouchAndStopShort) {
    const Element line = line_element({0, 0}, {10, 0});
    const auto count = [&](Vec from, Vec to, double reach = 1e-6) {
        return contacts_of(line, line_element(from, to), reach).size();
    };
    EXPECT_EQ(count({3, -2}, {3, 2}), 1U);
    EXPECT_EQ(count({3, 0}, {5, 2}), 1U);    // T
    EXPECT_EQ(count({10, 0}, {12, 7}), 1U);  // L
    EXPECT_EQ(count({3, 1e-3}, {3, 2}), 0U);
    EXPECT_EQ(count({3, 1e-3}, {3, 2}, 2e-3), 1U);
    EXPECT_EQ(count({10.1, -1}, {10.1, 2}), 0U);
    EXPECT_EQ(count({0, 1}, {10, 1}), 0U);
    EXPECT_EQ(count({0, 0.001}, {10, -0.001}), 0U);  // at too small an angle
    const Contact contact = contacts_of(line, line_element({3, 2}, {3, -2}), 1e-6)[0];
    EXPECT_EQ(contact.at, (Vec{3, 0}));
    EXPECT_EQ(contact.way, (Vec{1, 0}));
    EXPECT_EQ(contact.other_way, (Vec{0, -1}));
}

TEST(Contacts, CurvesCrossMoreThanOnce) {
    const Element parabola = parabola_element({-2, 4}, {0, -4}, {2, 4});  // y = x^2
    EXPECT_EQ(contacts_of(parabola, line_element({-3, 1}, {3, 1}), 1e-6).size(), 2U);
    EXPECT_EQ(contacts_of(circle_element({0, 0}, 2), circle_element({2, 0}, 2), 1e-6).size(), 2U);
    const Element across = parabola_element({4, -2}, {-4, 0}, {4, 2});  // x = y^2
    const std::vector<Contact> contacts = contacts_of(parabola, across, 1e-6);
    ASSERT_EQ(contacts.size(), 2U);
    EXPECT_NEAR(contacts[0].at.x, 0, 1e-12);
    EXPECT_NEAR(contacts[1].at.x, 1, 1e-12);
    EXPECT_NEAR(contacts[1].at.y, 1, 1e-12);
}

TEST(Contacts, WhatTouchesWithoutAnAngleTouchesOnce) {
    const auto touches = [](const Element& a, const Element& b) {
        const std::vector<Contact> contacts = contacts_of(a, b, 1e-6);
        return contacts.size() == 1 && contacts[0].is_tangential ? contacts[0].at : Vec{1e9, 1e9};
    };
    EXPECT_LT(length(touches(circle_element({0, 0}, 2), circle_element({4, 0}, 2)) - Vec{2, 0}), 1e-9);
    EXPECT_LT(length(touches(circle_element({0, 0}, 2), line_element({-3, 2}, {5, 2})) - Vec{0, 2}), 1e-9);
    // The petal's arcs, at its round end, and where they go on.
    const Element arc = parabola_element({-3, 3}, {0, -6}, {3, 3}), other = parabola_element({3, -3}, {-6, 0}, {3, 3});
    EXPECT_EQ(contacts_of(arc, other, 1e-6).size(), 2U);
    const Element half = parabola_element({-1, -1}, {1, -3}, {3, 3}),
                  mirrored = parabola_element({-1, -1}, {-3, 1}, {3, 3});
    EXPECT_EQ(contacts_of(half, mirrored, 1e-6).size(), 2U);
    // Nothing touches what it lies on.
    EXPECT_TRUE(contacts_of(circle_element({0, 0}, 2), circle_element({0, 0}, 2), 1e-6).empty());
    EXPECT_TRUE(contacts_of(half, piece_of(half, {0.3, 1.5}), 1e-6).empty());
    EXPECT_TRUE(contacts_of(circle_element({0, 0}, 2), circle_element({4.001, 0}, 2), 1e-6).empty());
}

// Where a part of one element ends on another, that is a contact, whatever their kinds.
TEST(Contacts, WhatEndsOnAnElementTouchesIt) {
    const std::uint64_t first = first_seed(), count = case_count(1000);
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        SCOPED_TRACE(seed);
        CaseRandom random(seed);
        const Element e = random_element(random, all_kinds[random.whole(1, 4)]);
        const Interval on = interval_of(e);
        const double t = on.from + (on.to - on.from) * random.between(0.05, 0.95);
        Element other = random_element(random, all_kinds[random.whole(1, 4)]);
        const Vec end = ends_of(other).first, at = point_at(e, t);
        other = transformed(other, translation(at - end));
        const Vec way = velocity_at(e, t), other_way = velocity_at(other, interval_of(other).from);
        if (std::fabs(cross(way, other_way)) < 0.1 * length(way) * length(other_way)) continue;
        std::size_t here = 0;
        for (const Contact& contact : contacts_of(e, other, 1e-6)) {
            EXPECT_TRUE(lies_on(e, contact.at, 2e-6));
            EXPECT_TRUE(lies_on(other, contact.at, 2e-6));
            here += length(contact.at - at) < 1e-6;
        }
        EXPECT_EQ(here, 1U);
        if (HasFailure()) break;
    }
}

TEST(Contacts, AllNeighboursAreAmongTheNumbers) {
    CaseRandom random(5);
    std::vector<Element> elements;
    for (int i = 0; i < 100; ++i) elements.push_back(random_element(random, all_kinds[random.below(5)]));
    const ElementGrid grid(elements);
    for (std::uint32_t i = 0; i < elements.size(); ++i) {
        const std::vector<std::uint32_t> numbers = grid.found_along(elements[i], 0.1);
        EXPECT_TRUE(std::is_sorted(numbers.begin(), numbers.end()));
        for (std::uint32_t j = 0; j < elements.size(); ++j) {
            if (contacts_of(elements[i], elements[j], 0.05).empty()) continue;
            EXPECT_TRUE(std::binary_search(numbers.begin(), numbers.end(), j)) << i << " " << j;
        }
    }
}

}  // namespace
}  // namespace filigree::curves
