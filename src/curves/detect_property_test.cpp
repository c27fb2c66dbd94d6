// Planted copies against a matcher that shares no code with the search: no miss, no false match.
#include <gtest/gtest.h>

#include "base/test_cases.h"
#include "curves/brute_matcher.h"
#include "curves/curve_test_shapes.h"
#include "curves/detect.h"
#include "curves/test_shapes.h"

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

// No shallower than a sagitta of a tenth of the chord, and without sharp turns, so that both matchers know its
// descriptor well.
Element parabola(CaseRandom& draws) {
    for (;;) {
        const Vec b0 = point_within(draws, 10), b1 = point_within(draws, 10), b2 = point_within(draws, 10);
        const double area = std::fabs(cross(b2 - b0, b1 - b0)), chord = length(b2 - b0);
        const Vec a = b0 - 2 * b1 + b2;
        if (chord > 2 && area > 0.2 * chord * chord && length(a) > 2 && length(a) < 4 * chord)
            return parabola_element(b0, b1, b2);
    }
}

// Of any kind, so that neither matcher finds its descriptor hard to tell.
Element any_element(CaseRandom& draws) {
    constexpr ElementKind kinds[] = {ElementKind::point, ElementKind::line, ElementKind::line,
                                     ElementKind::arc,   ElementKind::arc,  ElementKind::cubic};
    const std::uint32_t kind = draws.below(7);
    if (kind == 6) return parabola(draws);
    Element e = random_element(draws, kinds[kind]);
    // A cubic that is nearly straight is as hard to tell as a shallow arc.
    const auto breadth = [&](Vec p) { return std::fabs(cross(p - e.at[0], e.at[3] - e.at[0])); };
    if (e.kind == ElementKind::cubic && std::max(breadth(e.at[1]), breadth(e.at[2])) < 20) return any_element(draws);
    if (e.kind == ElementKind::arc && !is_closed(e)) e.to = std::min(e.to, e.from + 5);
    if (e.kind == ElementKind::point) e.layer = draws.below(2);
    return e;
}
Element line_or_point(CaseRandom& draws) {
    Element e = random_element(draws, draws.below(4) == 0 ? ElementKind::point : ElementKind::line);
    if (e.kind == ElementKind::point) e.layer = draws.below(2);
    return e;
}

// A piece of the descriptor that is longer by parts of the length.
Element stretched(const Element& e, double before, double after) {
    if (e.kind == ElementKind::point || is_closed(e)) return e;
    const Interval on = interval_of(e);
    const double width = on.to - on.from;
    const Interval piece{on.from - before * width, on.to + after * width};
    return e.kind == ElementKind::arc && piece.to - piece.from > 5.6 ? e : piece_of(e, piece);
}
// With an end that is beyond the element's, or its own.
Element lengthened(CaseRandom& draws, const Element& e) {
    const double most = e.kind == ElementKind::cubic ? 0.1 : 0.4;
    const double before = draws.coin() ? 0 : draws.between(0.01, most);
    return stretched(e, before, draws.coin() ? 0 : draws.between(0.01, most));
}
Element shortened(CaseRandom& draws, const Element& e) {
    if (e.kind == ElementKind::point) return point_element(e.at[0] + Vec{0.01, 0});
    if (is_closed(e)) return circle_element(e.at[0], length(e.at[1]) * 1.001);
    return draws.coin() ? stretched(e, -0.001, 0) : stretched(e, 0, -0.001);
}

struct Scene {
    Shape left, design;
};

Scene scene_of(CaseRandom& draws, Element (*element)(CaseRandom&), int most) {
    std::vector<Element> left, design;
    const int count = draws.whole(1, most);
    for (int i = 0; i < count; ++i) left.push_back(element(draws));
    if (draws.below(3) == 0) {
        const Transform to = similarity(draws, 3);
        const Transform across = compose(to, compose(scaling(1, -1), inverse(to)));
        for (int i = 0; i < count; ++i) left.push_back(transformed(left[static_cast<std::size_t>(i)], across));
    }
    const int copies = draws.whole(0, 2);
    for (int copy = 0; copy < copies; ++copy) {
        const Transform by = similarity(draws, 60);
        const std::size_t decoy = draws.below(3) == 0 ? draws.index(left.size()) : left.size();
        for (std::size_t i = 0; i < left.size(); ++i) {
            const Element moved = transformed(left[i], by);
            design.push_back(i == decoy ? shortened(draws, moved) : lengthened(draws, moved));
        }
    }
    const int others = draws.whole(0, most);
    for (int i = 0; i < others; ++i) design.push_back(transformed(element(draws), similarity(draws, 60)));
    return {shape_of(left, tolerance), shape_of(design, tolerance)};
}

// How many matches both find.
std::size_t expect_same_matches(const Scene& scene) {
    MatchOptions options;
    options.tolerance = tolerance;
    options.min_scale = min_scale;
    const Matches matches = find_matches(scene.left, MatchIndex(scene.design, tolerance), options);
    const std::vector<brute::Map> maps = brute::all_maps(scene.left, scene.design, min_scale, reach);
    EXPECT_EQ(matches.found.size(), maps.size());
    const brute::Curves left = brute::curves_of(scene.left), design = brute::curves_of(scene.design);
    for (const Match& match : matches.found) {
        const Transform& by = match.by;
        const brute::Map map{{by.a, by.b}, {by.e, by.f}, match.is_reflected};
        EXPECT_TRUE(brute::lies_on(left, map, design, reach));
        const auto is_same = [&](const brute::Map& other) { return brute::is_same(left, map, other, reach); };
        EXPECT_EQ(std::count_if(maps.begin(), maps.end(), is_same), 1);
    }
    return maps.size();
}

void try_scenes(Element (*element)(CaseRandom&), int most) {
    const std::uint64_t first = first_seed(), count = case_count(1000);
    std::size_t found = 0, fixed = 0;
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        SCOPED_TRACE(seed);
        CaseRandom draws(seed);
        const Scene scene = scene_of(draws, element, most);
        if (!brute::is_fixed(brute::curves_of(scene.left))) continue;
        ++fixed;
        found += expect_same_matches(scene);
        if (testing::Test::HasFailure()) return;
    }
    if (count < 100) return;
    EXPECT_GT(fixed, count / 3);
    EXPECT_GT(found, count / 3);
}

TEST(DetectProperty, PlantedParabolasAreFoundAndNothingElse) { try_scenes(parabola, 3); }
TEST(DetectProperty, PlantedLinesAndPointsAreFoundAndNothingElse) { try_scenes(line_or_point, 4); }
TEST(DetectProperty, PlantedElementsOfAllKindsAreFoundAndNothingElse) { try_scenes(any_element, 4); }

}  // namespace
}  // namespace filigree::curves
