// Planted copies against a matcher that shares no code with the search: no miss, no false match.
#include <gtest/gtest.h>

#include "base/test_cases.h"
#include "curves/brute_matcher.h"
#include "curves/curve_test_shapes.h"
#include "curves/detect.h"

namespace filigree::curves {
namespace {

using test_shapes::shape_of;

constexpr double tolerance = 1e-8, reach = 1e-6, min_scale = 0.05;

Vec point_within(CaseRandom& draws, double size) {
    const double x = draws.between(-size, size);
    return {x, draws.between(-size, size)};
}

Transform similarity(CaseRandom& draws, double size) {
    const Vec to = point_within(draws, size);
    const double scale = draws.between(0.4, 2.5), angle = draws.between(0, 360);
    return compose(translation(to), compose(rotation_degrees(angle), scaling(scale, draws.coin() ? scale : -scale)));
}

// No shallower than a sagitta of a tenth of the chord, so that both matchers know its descriptor well.
Element parabola(CaseRandom& draws) {
    for (;;) {
        const Vec b0 = point_within(draws, 10), b1 = point_within(draws, 10), b2 = point_within(draws, 10);
        const double area = std::fabs(cross(b2 - b0, b1 - b0)), chord = length(b2 - b0);
        const Vec a = b0 - 2 * b1 + b2;
        if (chord > 2 && area > 0.2 * chord * chord && length(a) > 2) return parabola_element(b0, b1, b2);
    }
}

// With an end that is beyond the arc's, or the arc's own.
Element lengthened(CaseRandom& draws, const Element& e) {
    const double before = draws.coin() ? 0 : draws.between(0.01, 0.4);
    return piece_of(e, {-before, 1 + (draws.coin() ? 0 : draws.between(0.01, 0.4))});
}
Element shortened(CaseRandom& draws, const Element& e) {
    return draws.coin() ? piece_of(e, {0, 0.999}) : piece_of(e, {0.001, 1});
}

struct Scene {
    Shape left, design;
};

Scene scene_of(CaseRandom& draws, Element (*random_element)(CaseRandom&)) {
    std::vector<Element> left, design;
    const int count = draws.whole(1, 3);
    for (int i = 0; i < count; ++i) left.push_back(random_element(draws));
    if (draws.below(3) == 0) {
        const Transform mirror = similarity(draws, 3);
        const Transform across = compose(mirror, compose(scaling(1, -1), inverse(mirror)));
        for (int i = 0; i < count; ++i) left.push_back(transformed(left[static_cast<std::size_t>(i)], across));
    }
    const int copies = draws.whole(0, 3);
    for (int copy = 0; copy < copies; ++copy) {
        const Transform by = similarity(draws, 60);
        const std::size_t decoy = draws.below(3) == 0 ? draws.index(left.size()) : left.size();
        for (std::size_t i = 0; i < left.size(); ++i) {
            const Element moved = transformed(left[i], by);
            design.push_back(i == decoy ? shortened(draws, moved) : lengthened(draws, moved));
        }
    }
    const int others = draws.whole(0, 4);
    for (int i = 0; i < others; ++i) design.push_back(transformed(random_element(draws), similarity(draws, 60)));
    return {shape_of(left, tolerance), shape_of(design, tolerance)};
}

void expect_same_matches(const Scene& scene) {
    MatchOptions options;
    options.tolerance = tolerance;
    options.min_scale = min_scale;
    const Matches matches = find_matches(scene.left, MatchIndex(scene.design), options);
    const std::vector<brute::Map> maps = brute::all_maps(scene.left, scene.design, min_scale, reach);
    EXPECT_EQ(matches.found.size(), maps.size());
    const brute::Curves left = brute::curves_of(scene.left), design = brute::curves_of(scene.design);
    for (const Match& match : matches.found) {
        const Transform& by = match.by;
        const brute::Map map{{by.a, by.b}, {by.e, by.f}, match.is_reflected};
        EXPECT_TRUE(brute::lies_on(left, map, design, reach));
        const auto is_same = [&](const brute::Map& other) {
            return brute::lies_on(left, brute::chained(brute::undone(other), map), left, reach / match.scale);
        };
        EXPECT_EQ(std::count_if(maps.begin(), maps.end(), is_same), 1);
    }
}

TEST(DetectProperty, PlantedParabolasAreFoundAndNothingElse) {
    const std::uint64_t first = first_seed(), count = case_count(1000);
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        SCOPED_TRACE(seed);
        CaseRandom draws(seed);
        expect_same_matches(scene_of(draws, parabola));
        if (HasFailure()) break;
    }
}

}  // namespace
}  // namespace filigree::curves
