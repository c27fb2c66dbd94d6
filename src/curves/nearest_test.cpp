#include "curves/nearest.h"

#include <gtest/gtest.h>

#include "curves/test_shapes.h"

namespace filigree::curves {
namespace {

double sampled_distance(const Element& e, Vec p) {
    const Interval on = interval_of(e);
    double best = 1e300;
    for (int i = 0; i <= 4000; ++i)
        best = std::min(best, length(point_at(e, on.from + (on.to - on.from) * i / 4000) - p));
    return best;
}

TEST(Nearest, NoPointOfAnElementIsNearerThanItsFoot) {
    const std::uint64_t first = first_seed(), count = case_count(1000);
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        SCOPED_TRACE(seed);
        CaseRandom random(seed);
        const Element e = random_element(random, all_kinds[random.below(5)]);
        const Vec p = random_place(random, Coordinates::any, 15);
        const Foot foot = foot_on(e, p);
        const Interval on = interval_of(e);
        EXPECT_GE(foot.t, on.from);
        EXPECT_LE(foot.t, on.to);
        EXPECT_NEAR(length(point_at(e, foot.t) - p), foot.distance, 1e-9);
        const double sampled = sampled_distance(e, p);
        EXPECT_LE(foot.distance, sampled + 1e-9);
        EXPECT_GE(foot.distance, sampled - 0.01);
        if (HasFailure()) break;
    }
}

TEST(Nearest, ThePartThatSticksOutIsFarthest) {
    const Element line = line_element({0, 0}, {10, 0});
    EXPECT_EQ(farthest_of(line_element({2, 1}, {8, 1}), 9, line), 1);
    EXPECT_EQ(farthest_of(line_element({2, 0}, {12, 0}), 9, line), 2);
    EXPECT_EQ(farthest_of(circle_element({5, 0}, 2), 9, line), 2);
}

}  // namespace
}  // namespace filigree::curves
