#include "curves/family.h"

#include <gtest/gtest.h>

#include "base/elementary.h"
#include "curves/along.h"
#include "curves/curve_test_shapes.h"
#include "curves/detect.h"
#include "curves/symmetry.h"

namespace filigree::curves {
namespace {

using test_shapes::moved;
using test_shapes::shape_of;

constexpr double pi = elementary::pi;

Matches matches_of(const Shape& left, const Shape& design, MatchGroup group) {
    MatchOptions options;
    options.group = group;
    return find_matches(left, MatchIndex(design, options.tolerance), options);
}
Shape line(double x0, double y0, double x1, double y1) { return shape_of({line_element({x0, y0}, {x1, y1})}); }

bool lies_on(const Shape& left, const Transform& by, const Shape& design, const std::vector<std::uint32_t>& carriers) {
    for (std::size_t i = 0; i < left.elements.size(); ++i) {
        if (!misfit(design.elements[carriers[i]], transformed(left.elements[i], by), 1e-6)) return false;
    }
    return true;
}

// All that a family says lies on the design, and nothing a little beyond its ends.
void expect_bounds(const Family& family, const Shape& left, const Shape& design) {
    for (const double f : {0.0, 0.3, 1.0}) {
        const double growth = family.growth.from + f * (family.growth.to - family.growth.from);
        const Interval moves = moves_at(family, growth);
        for (const double g : {0.0, 0.6, 1.0}) {
            const double move = moves.from + g * (moves.to - moves.from);
            EXPECT_TRUE(lies_on(left, member_of(family, move, growth), design, family.carriers))
                << move << ' ' << growth;
        }
        if (family.turns_freely) continue;
        if (family.kind != FamilyKind::growth) {
            EXPECT_FALSE(lies_on(left, member_of(family, moves.from - 0.01, growth), design, family.carriers));
            EXPECT_FALSE(lies_on(left, member_of(family, moves.to + 0.01, growth), design, family.carriers));
        }
    }
    for (const Match& member : family.members) EXPECT_TRUE(lies_on(left, member.by, design, member.carriers));
}

TEST(Family, ALineSlidesAlongALongerOne) {
    const Shape left = line(0, 0, 2, 0), design = line(10, 5, 10, 12);
    const Matches matches = matches_of(left, design, MatchGroup::isometry);
    EXPECT_TRUE(matches.found.empty());
    ASSERT_EQ(matches.families.size(), 1U);
    const Family& family = matches.families[0];
    EXPECT_EQ(family.kind, FamilyKind::slide);
    EXPECT_NEAR(family.moves.to - family.moves.from, 5, 1e-12);
    expect_bounds(family, left, design);
    ASSERT_EQ(family.members.size(), 3U);
    EXPECT_NEAR(family.members[0].centroid.y, 6, 1e-12);
    EXPECT_NEAR(family.members[1].centroid.y, 8.5, 1e-12);
    EXPECT_NEAR(family.members[2].centroid.y, 11, 1e-12);
    // Turned by 90 degrees: not by 270, which its half turn makes of it.
    EXPECT_EQ(family.members[0].angle_degrees, 90);
    EXPECT_TRUE(matches_of(left, design, MatchGroup::translation).families.empty());
    EXPECT_EQ(matches_of(left, line(3, 3, 8, 3), MatchGroup::translation).families.size(), 1U);
}

TEST(Family, ALineThatFillsItsCarrierIsAMatch) {
    const Matches matches = matches_of(line(0, 0, 2, 0), line(10, 5, 10, 7), MatchGroup::isometry);
    EXPECT_TRUE(matches.families.empty());
    ASSERT_EQ(matches.found.size(), 1U);
    EXPECT_EQ(symmetries(line(0, 0, 2, 0), {}).size(), 4U);
    EXPECT_TRUE(matches_of(line(0, 0, 2, 0), line(10, 5, 10, 6.99), MatchGroup::isometry).found.empty());
}

TEST(Family, ALineOnALineSlidesAndGrows) {
    const Shape left = line(0, 0, 2, 0), design = line(10, 5, 10, 12);
    const Matches matches = matches_of(left, design, MatchGroup::similarity);
    ASSERT_EQ(matches.families.size(), 1U);
    const Family& family = matches.families[0];
    EXPECT_EQ(family.kind, FamilyKind::slide_and_growth);
    EXPECT_NEAR(family.growth.to, 3.5, 1e-12);
    expect_bounds(family, left, design);
    // As drawn at both ends and in the middle, and in full length.
    ASSERT_EQ(family.members.size(), 4U);
    EXPECT_EQ(family.members[0].scale, 1);
    EXPECT_NEAR(family.members[3].scale, 3.5, 1e-12);
}

TEST(Family, TwoSegmentsOfOneLineNeedRoomAtOnce) {
    const Shape left = shape_of({line_element({0, 0}, {1, 0}), line_element({3, 0}, {4, 0})});
    const Shape design = shape_of({line_element({0, 5}, {2, 5}), line_element({3, 5}, {10, 5})});
    const Matches slides = matches_of(left, design, MatchGroup::isometry);
    // Both on the long one with room for 3, or on one each: from 0 to 1.
    ASSERT_EQ(slides.families.size(), 2U);
    EXPECT_NEAR(slides.families[0].moves.to - slides.families[0].moves.from, 1, 1e-12);
    EXPECT_NEAR(slides.families[1].moves.to - slides.families[1].moves.from, 3, 1e-12);
    for (const Family& family : slides.families) expect_bounds(family, left, design);
    for (const Family& family : matches_of(left, design, MatchGroup::similarity).families) {
        expect_bounds(family, left, design);
    }
}

TEST(Family, ParallelLinesAreScaledByTheirDistanceAndSlide) {
    const Shape left = shape_of({line_element({0, 0}, {2, 0}), line_element({1, 1}, {3, 1})});
    const Shape design = shape_of({line_element({0, 10}, {20, 10}), line_element({0, 13}, {20, 13})});
    const Matches matches = matches_of(left, design, MatchGroup::similarity);
    // The half turn is a symmetry, so the two lines may not be swapped; the mirror image is another.
    ASSERT_EQ(matches.families.size(), 2U);
    for (const Family& family : matches.families) {
        EXPECT_EQ(family.kind, FamilyKind::slide);
        EXPECT_NEAR(family.members.front().scale, 3, 1e-12);
        EXPECT_NEAR(family.moves.to - family.moves.from, 11, 1e-12);
        expect_bounds(family, left, design);
    }
    EXPECT_TRUE(matches_of(left, design, MatchGroup::isometry).families.empty());
}

TEST(Family, ACornerGrowsAboutItsPoint) {
    const Shape left = shape_of({line_element({0, 0}, {1, 0}), line_element({0, 0}, {0, 2})});
    const Shape design = shape_of({line_element({0, 0}, {10, 0}), line_element({4, 0}, {4, 5})});
    EXPECT_EQ(symmetries(left, {}).size(), 1U);
    const Matches matches = matches_of(left, design, MatchGroup::similarity);
    // In two corners, with the longer leg up or along.
    ASSERT_EQ(matches.families.size(), 4U);
    std::vector<double> most;
    for (const Family& family : matches.families) {
        EXPECT_EQ(family.kind, FamilyKind::growth);
        expect_bounds(family, left, design);
        most.push_back(family.growth.to);
    }
    std::sort(most.begin(), most.end());
    EXPECT_NEAR(most[0], 2, 1e-12);    // longer leg along, to the left
    EXPECT_NEAR(most[1], 2.5, 1e-12);  // up, whichever way the shorter leg goes
    EXPECT_NEAR(most[2], 2.5, 1e-12);
    EXPECT_NEAR(most[3], 3, 1e-12);  // longer leg along, to the right
    EXPECT_EQ(matches_of(left, design, MatchGroup::isometry).found.size(), 4U);
}

TEST(Family, APointOnALineGrowsAboutIt) {
    Element point = point_element({1, 0});
    const Shape left = shape_of({point, line_element({0, 0}, {3, 0})});
    point.at[0] = {5, 5};
    const Shape design = shape_of({point, line_element({1, 5}, {9, 5})});
    const Matches matches = matches_of(left, design, MatchGroup::similarity);
    ASSERT_EQ(matches.families.size(), 2U);
    for (const Family& family : matches.families) {
        EXPECT_NEAR(family.growth.to, 2, 1e-12);
        expect_bounds(family, left, design);
    }
    EXPECT_EQ(matches_of(left, design, MatchGroup::isometry).found.size(), 2U);
}

TEST(Family, AnArcTurnsOnALongerOne) {
    const Shape left = shape_of({arc_element({0, 0}, {1, 0}, {0, 1}, 0, pi / 2)});
    const Shape design = shape_of({arc_element({5, 5}, {2, 0}, {0, 2}, pi / 4, 3 * pi / 2)});
    const Matches matches = matches_of(left, design, MatchGroup::similarity);
    ASSERT_EQ(matches.families.size(), 1U);
    const Family& family = matches.families[0];
    EXPECT_EQ(family.kind, FamilyKind::turn);
    EXPECT_NEAR(family.moves.from, 45, 1e-9);
    EXPECT_NEAR(family.moves.to, 180, 1e-9);
    expect_bounds(family, left, design);
    EXPECT_EQ(family.members.size(), 3U);
    EXPECT_TRUE(matches_of(left, design, MatchGroup::isometry).families.empty());
    EXPECT_EQ(symmetries(left, {}).size(), 2U);
    // On an arc of the same sweep it is a match.
    EXPECT_EQ(matches_of(left, moved(left, scaling(3, 3)), MatchGroup::similarity).found.size(), 1U);
}

TEST(Family, ConcentricArcsTurnTogether) {
    const Shape left = shape_of({arc_element({0, 0}, {1, 0}, {0, 1}, 0, 1), arc_element({0, 0}, {2, 0}, {0, 2}, 2, 3)});
    const Shape design = shape_of({circle_element({9, 9}, 1), arc_element({9, 9}, {2, 0}, {0, 2}, 0, 4)});
    const Matches matches = matches_of(left, design, MatchGroup::similarity);
    ASSERT_EQ(matches.families.size(), 2U);  // mirrored, too
    for (const Family& family : matches.families) {
        EXPECT_NEAR(family.moves.to - family.moves.from, 3 * 180 / pi, 1e-9);
        expect_bounds(family, left, design);
    }
}

TEST(Family, CirclesAndPointsTurnFreely) {
    const Shape circle = shape_of({circle_element({0, 0}, 1)});
    const Shape design = shape_of({circle_element({5, 0}, 2), circle_element({9, 9}, 1), point_element({1, 1})});
    const Matches circles = matches_of(circle, design, MatchGroup::similarity);
    ASSERT_EQ(circles.families.size(), 2U);
    for (const Family& family : circles.families) {
        EXPECT_TRUE(family.turns_freely);
        EXPECT_EQ(family.members.size(), 1U);
        expect_bounds(family, circle, design);
    }
    EXPECT_EQ(matches_of(circle, design, MatchGroup::isometry).families.size(), 1U);
    EXPECT_EQ(matches_of(circle, design, MatchGroup::translation).found.size(), 1U);
    const Shape point = shape_of({point_element({0, 0})});
    const Matches points = matches_of(point, design, MatchGroup::similarity);
    ASSERT_EQ(points.families.size(), 1U);
    EXPECT_EQ(points.families[0].kind, FamilyKind::turn_and_growth);
    EXPECT_EQ(points.families[0].members.front().by, translation({1, 1}));
}

TEST(Family, ARosetteOfArcsTurnsWithinItsSymmetry) {
    std::vector<Element> arcs, longer;
    for (int i = 0; i < 4; ++i) {
        arcs.push_back(arc_element({0, 0}, {1, 0}, {0, 1}, i * pi / 2, i * pi / 2 + 0.5));
        longer.push_back(arc_element({0, 0}, {1, 0}, {0, 1}, i * pi / 2, i * pi / 2 + 0.9));
    }
    const Shape left = shape_of(arcs);
    EXPECT_EQ(symmetries(left, {}).size(), 8U);
    const Matches matches = matches_of(left, shape_of(longer), MatchGroup::similarity);
    ASSERT_EQ(matches.families.size(), 1U);
    EXPECT_NEAR(matches.families[0].moves.to, 0.4 * 180 / pi, 1e-9);
}

}  // namespace
}  // namespace filigree::curves
