#include "plane/cubics.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/test_cases.h"

namespace filigree {
namespace {

Path path_of(std::string_view data) { return *parse_path_data(data); }

// How far the points of one polyline lie from another, at most.
double distance(const Polyline& from, const Polyline& to) {
    double farthest = 0;
    for (const Vec p : from.points) {
        double nearest = 1e300;
        const std::size_t count = to.points.size() - (to.closed ? 0 : 1);
        for (std::size_t i = 0; i < count; ++i) {
            const Vec a = to.points[i], along = to.points[(i + 1) % to.points.size()] - a;
            const double squared = dot(along, along);
            const double part = squared > 0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0;
            nearest = std::min(nearest, length(p - a - part * along));
        }
        farthest = std::max(farthest, nearest);
    }
    return farthest;
}

TEST(Cubics, RaiseQuadraticsAndKeepTheRest) {
    EXPECT_EQ(in_cubics(path_of("M0 0L3 0Q6 0 6 3C1 2 3 4 5 6ZM9 9L8 8")),
              path_of("M0 0L3 0C5 0 6 1 6 3C1 2 3 4 5 6ZM9 9L8 8"));
    EXPECT_EQ(in_cubics(path_of("M1 1A0 5 0 0 0 7 7")), path_of("M1 1L7 7"));
    EXPECT_EQ(in_cubics({}), Path{});
    EXPECT_EQ(in_cubics({{Verb::quadratic}, {{1, 1}}}), Path{});  // too few points
    // What follows a close starts where the subpath did.
    EXPECT_EQ(in_cubics(path_of("M3 0L0 0ZQ3 3 0 3")), path_of("M3 0L0 0ZC3 2 2 3 0 3"));
}

TEST(Cubics, FollowTheCurve) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(300); ++seed) {
        CaseRandom random(seed);
        const auto point = [&] { return Vec{random.between(-100, 100), random.between(-100, 100)}; };
        Path path{{Verb::move}, {point()}};
        for (std::uint32_t n = 1 + random.below(4); n > 0; --n) {
            switch (random.below(4)) {
                case 0:
                    path.verbs.push_back(Verb::line);
                    path.points.push_back(point());
                    break;
                case 1:
                    path.verbs.push_back(Verb::quadratic);
                    path.points.insert(path.points.end(), {point(), point()});
                    break;
                case 2:
                    path.verbs.push_back(Verb::cubic);
                    path.points.insert(path.points.end(), {point(), point(), point()});
                    break;
                default:
                    path.verbs.push_back(Verb::arc);
                    path.points.insert(path.points.end(), {{random.between(1, 90), random.between(1, 90)},
                                                           {random.between(-180, 180), 1.0 * random.below(4)},
                                                           point()});
            }
        }
        if (random.coin()) path.verbs.push_back(Verb::close);
        const Path cubics = in_cubics(path);
        for (const Verb verb : cubics.verbs) {
            EXPECT_TRUE(verb != Verb::quadratic && verb != Verb::arc) << "seed " << seed;
        }
        const std::vector<Polyline> before = flatten(path, 0.01), after = flatten(cubics, 0.01);
        ASSERT_EQ(after.size(), 1U) << "seed " << seed;
        ASSERT_EQ(after[0].closed, before[0].closed) << "seed " << seed;
        EXPECT_LT(distance(after[0], before[0]), 0.01001) << "seed " << seed;
        EXPECT_LT(distance(before[0], after[0]), 0.01001) << "seed " << seed;
    }
}

}  // namespace
}  // namespace filigree
