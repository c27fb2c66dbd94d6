#include "curves/kept_matches.h"

#include <gtest/gtest.h>

#include "base/test_cases.h"
#include "curves/curve_test_shapes.h"
#include "curves/test_shapes.h"

namespace filigree::curves {
namespace {

using test_shapes::flower;
using test_shapes::petal;
using test_shapes::shape_of;

// All that is kept is what a new search finds, to the last bit.
void expect_kept(const KeptMatches& kept, const Shape& left, const MatchIndex& design, const MatchOptions& options) {
    const Matches fresh = find_matches(left, design, options);
    ASSERT_EQ(kept.found().size(), fresh.found.size());
    for (std::size_t i = 0; i < fresh.found.size(); ++i) EXPECT_EQ(kept.found()[i], fresh.found[i]) << i;
    ASSERT_EQ(kept.near_misses().size(), fresh.near_misses.size());
    for (std::size_t i = 0; i < fresh.near_misses.size(); ++i) EXPECT_EQ(kept.near_misses()[i], fresh.near_misses[i]);
    EXPECT_EQ(kept.families(), fresh.families);
}

Transform any_similarity(CaseRandom& draws) {
    const Vec to{draws.between(-50, 50), draws.between(-50, 50)};
    const double scale = draws.between(0.5, 2), flip = draws.coin() ? 1 : -1;
    return compose(translation(to), compose(rotation_degrees(draws.between(0, 360)), scaling(scale, flip * scale)));
}

TEST(KeptMatches, APetalThatIsDrawnOutTakesItsNeighboursAlong) {
    Shape design = flower();
    MatchIndex index(design, 1e-6);
    KeptMatches kept(petal(), index, {});
    EXPECT_EQ(kept.found().size(), 4U);
    const std::vector<Element> drawn = shape_of(test_shapes::opened_flower(2)).elements;
    const auto opened = index.update(flower().elements, drawn);
    EXPECT_EQ(opened.removed.size(), 4U);
    EXPECT_EQ(opened.added.size(), 8U);
    kept.update(index, opened);
    EXPECT_EQ(kept.found().size(), 2U);
    kept.update(index, index.update(drawn, flower().elements));
    EXPECT_EQ(kept.found().size(), 4U);
    expect_kept(kept, petal(), index, {});
}

TEST(KeptMatches, AreWhatANewSearchFinds) {
    const std::uint64_t first = first_seed(), count = case_count(1000);
    std::size_t found = 0;
    for (std::uint64_t seed = first; seed < first + count && !HasFailure(); ++seed) {
        SCOPED_TRACE(seed);
        CaseRandom draws(seed);
        std::vector<Element> left, design;
        const bool is_mixed = draws.coin();
        const int size = draws.whole(1, 4);
        const auto any = [&] {
            return random_element(draws, is_mixed ? all_kinds[draws.below(5)] : ElementKind::parabola);
        };
        for (int i = 0; i < size; ++i) left.push_back(any());
        const Shape part = shape_of(left);
        const auto plant = [&](std::vector<Element>& into) {
            const Transform by = any_similarity(draws);
            for (const Element& e : part.elements) into.push_back(*normal_form(transformed(e, by), 1e-9));
        };
        for (int i = draws.whole(0, 3); i > 0; --i) plant(design);
        for (int i = draws.whole(0, 5); i > 0; --i) design.push_back(any());
        Shape shape = shape_of(design);
        MatchOptions options;
        options.min_scale = 0.1;
        MatchIndex index(shape, options.tolerance);
        KeptMatches kept(part, index, options);
        for (int step = 0; step < 3; ++step) {
            std::vector<Element> removed, added;
            MatchIndex::Change change;
            for (int half = draws.whole(1, 2); half > 0; --half) {
                removed.clear();
                added.clear();
                for (std::size_t i = shape.elements.size(); i-- > 0;) {
                    if (draws.below(4) != 0) continue;
                    removed.push_back(shape.elements[i]);
                    shape.elements.erase(shape.elements.begin() + static_cast<std::ptrdiff_t>(i));
                }
                if (draws.coin()) plant(added);
                if (draws.coin()) added.push_back(*normal_form(any(), 1e-9));
                // Half of a copy may have been taken away above: put it back.
                if (draws.coin() && !removed.empty()) added.push_back(removed.front());
                shape.elements.insert(shape.elements.end(), added.begin(), added.end());
                const auto one = index.update(removed, added);
                change.removed.insert(change.removed.end(), one.removed.begin(), one.removed.end());
                change.added.insert(change.added.end(), one.added.begin(), one.added.end());
            }
            kept.update(index, change);
            expect_kept(kept, part, index, options);
            found += kept.found().size();
        }
    }
    EXPECT_GT(found, count / 2);
}

}  // namespace
}  // namespace filigree::curves
