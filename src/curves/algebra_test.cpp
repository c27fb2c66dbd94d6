#include "curves/algebra.h"

#include <gtest/gtest.h>

#include <array>

#include "curves/test_cells.h"

namespace filigree::curves {
namespace {

constexpr double tolerance = 1e-7;

Shape shape_of(std::vector<Element> elements) { return maximal(std::move(elements), tolerance); }

// The page's vector.
TEST(Algebra, TakesAPieceOutOfAParabola) {
    const Element whole = parabola_element({0, 0}, {1, 0}, {2, 1});
    const Shape a = shape_of({whole}), b = shape_of({piece_of(whole, {0.25, 0.5})});
    const Shape rest = difference(a, b, tolerance);
    EXPECT_EQ(rest.elements, (std::vector{parabola_element({0, 0}, {0.25, 0}, {0.5, 0.0625}),
                                          parabola_element({1, 0.25}, {1.5, 0.5}, {2, 1})}));
    EXPECT_EQ(sum(rest, b, tolerance), a);
    EXPECT_EQ(product(a, b, tolerance), b);
    EXPECT_TRUE(is_part_of(b, a, tolerance));
    EXPECT_FALSE(is_part_of(a, b, tolerance));
}

TEST(Algebra, LeavesTheRestOfACircle) {
    const Element whole = circle_element({1, 1}, 2);
    const Shape circle = shape_of({whole}), arc = shape_of({piece_of(whole, {2, 4})});
    const Shape rest = difference(circle, arc, tolerance);
    EXPECT_EQ(difference_to(rest.elements, {piece_of(whole, {4, 2 + 2 * elementary::pi})}, 1e-12), "");
    EXPECT_TRUE(are_equal(sum(rest, arc, tolerance), circle, tolerance));
    EXPECT_TRUE(product(rest, arc, tolerance).elements.empty());
    // An arc that meets another at both of its ends.
    const Shape both = product(shape_of({piece_of(whole, {0, 4})}), shape_of({piece_of(whole, {3, 7})}), tolerance);
    EXPECT_EQ(
        difference_to(both.elements, {piece_of(whole, {3, 4}), piece_of(whole, {0, 7 - 2 * elementary::pi})}, 1e-12),
        "");
}

TEST(Algebra, DropsWhatIsShorterThanTheTolerance) {
    const auto line = [](double from, double to) { return shape_of({line_element({from, 0}, {to, 0})}); };
    const double small = 0.9 * tolerance;
    EXPECT_TRUE(difference(line(0, 1), line(small, 1 - small), tolerance).elements.empty());
    EXPECT_TRUE(are_equal(line(0, 1), line(small, 1 + small), tolerance));
    EXPECT_FALSE(are_equal(line(0, 1), line(1.2 * tolerance, 1), tolerance));
    EXPECT_TRUE(product(line(0, 1), line(1 - small, 2), tolerance).elements.empty());
    EXPECT_EQ(difference(line(0, 1), line(1 - small, 2), tolerance), line(0, 1));
}

TEST(Algebra, TellsNearDecisions) {
    const auto line = [](double from, double to, double y = 0) { return shape_of({line_element({from, y}, {to, y})}); };
    Ambiguities doubts;
    difference(line(0, 2), line(5 * tolerance, 1), tolerance, &doubts);
    ASSERT_EQ(doubts.found.size(), 1U);
    EXPECT_EQ(doubts.found[0].what, Doubt::rest);
    EXPECT_NEAR(doubts.found[0].tolerances, 5, 1e-6);
    doubts = {};
    product(line(0, 1), line(1 - 3 * tolerance, 2), tolerance, &doubts);
    ASSERT_EQ(doubts.found.size(), 1U);
    EXPECT_EQ(doubts.found[0].what, Doubt::overlap);
    doubts = {};
    EXPECT_FALSE(is_part_of(line(0, 1, 4 * tolerance), line(0, 2), tolerance, &doubts));
    ASSERT_EQ(doubts.found.size(), 1U);
    EXPECT_EQ(doubts.found[0].what, Doubt::descriptor);
    EXPECT_NEAR(doubts.found[0].tolerances, 4, 1e-6);
    doubts = {};
    difference(line(0, 2), line(0.5, 1), tolerance, &doubts);
    difference(line(0, 2), line(0, 1, 11 * tolerance), tolerance, &doubts);
    EXPECT_TRUE(doubts.found.empty());
}

// Every operation is one on arrays; the laws then hold of the arrays, and of what the algebra makes.
TEST(Algebra, DoesWhatItDoesToArrays) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(); ++seed) {
        CaseRandom random(seed);
        SCOPED_TRACE(seed);
        const World world = random_world(random, random.coin() ? Coordinates::any : Coordinates::dyadic);
        const std::uint32_t weights = 1 + random.below(3);
        const Cells x = random_cells(random, world, weights), y = random_cells(random, world, weights);
        const Shape a = shape_of(drawn(random, world, x)), b = shape_of(drawn(random, world, y));
        const auto expect = [&](const Shape& found, double (*by)(double, double)) {
            EXPECT_EQ(difference_to(found.elements, runs_of(world, combined(x, y, by)), 1e-9), "");
            EXPECT_EQ(merged(found.elements, tolerance), found);
        };
        Ambiguities doubts;
        expect(sum(a, b, tolerance, &doubts), [](double p, double q) { return std::max(p, q); });
        expect(product(a, b, tolerance, &doubts), [](double p, double q) { return std::min(p, q); });
        expect(difference(a, b, tolerance, &doubts), [](double p, double q) { return p > q ? p : 0; });
        expect(erased(a, b, tolerance, &doubts), [](double p, double q) { return q > 0 ? 0 : p; });
        const Cells beyond = combined(x, y, [](double p, double q) { return p > q ? 1 : 0; });
        EXPECT_EQ(is_part_of(a, b, tolerance, &doubts), runs_of(world, beyond).empty());
        EXPECT_EQ(are_equal(a, b, tolerance, &doubts), x == y);
        EXPECT_TRUE(doubts.found.empty());
        EXPECT_EQ(sum(a, b, tolerance), sum(b, a, tolerance));
        EXPECT_EQ(product(a, b, tolerance), product(b, a, tolerance));
        EXPECT_EQ(sum(a, a, tolerance), a);
        EXPECT_EQ(product(a, a, tolerance), a);
        EXPECT_TRUE(are_equal(sum(a, product(a, b, tolerance), tolerance), a, tolerance));
        EXPECT_TRUE(are_equal(product(a, sum(a, b, tolerance), tolerance), a, tolerance));
        const Shape part = product(a, b, tolerance);
        EXPECT_TRUE(is_part_of(part, a, tolerance));
        EXPECT_TRUE(are_equal(sum(difference(a, part, tolerance), part, tolerance), a, tolerance));
        EXPECT_TRUE(are_equal(sum(erased(a, part, tolerance), a, tolerance), a, tolerance));
        if (weights == 1) {
            EXPECT_TRUE(product(difference(a, b, tolerance), b, tolerance).elements.empty());
        }
        const Transform by = random_similarity(random);
        const double scaled = tolerance * std::sqrt(std::fabs(determinant(by)));
        EXPECT_TRUE(are_equal(transformed(sum(a, b, tolerance), by),
                              sum(transformed(a, by), transformed(b, by), scaled), scaled));
        EXPECT_TRUE(are_equal(transformed(difference(a, b, tolerance), by),
                              difference(transformed(a, by), transformed(b, by), scaled), scaled));
        if (::testing::Test::HasFailure()) break;
    }
}

// At a tolerance at which short pieces are straight, and with noise below it: what was taken away and put back merges.
TEST(Algebra, PutsBackWhatWasTaken) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(); ++seed) {
        CaseRandom random(seed);
        SCOPED_TRACE(seed);
        constexpr double coarse = 1e-3, noise = 1e-6;
        const World world = random_world(random, Coordinates::any);
        const Cells x = random_cells(random, world);
        const Cells y = combined(x, random_cells(random, world), [](double p, double q) { return std::min(p, q); });
        const Shape a = merged(runs_of(world, x), coarse);
        std::vector<Element> noisy = runs_of(world, y);
        for (Element& e : noisy) e = *own_form(shaken(e, random, noise), 0);
        const Shape b = merged(noisy, coarse);
        const Shape rest = difference(a, b, coarse);
        EXPECT_EQ(
            difference_to(rest.elements,
                          runs_of(world, combined(x, y, [](double p, double q) { return p > q ? p : 0; })), coarse),
            "");
        EXPECT_EQ(difference_to(sum(rest, b, coarse).elements, runs_of(world, x), coarse), "");
        EXPECT_TRUE(product(rest, b, coarse).elements.empty());
        if (::testing::Test::HasFailure()) break;
    }
}

TEST(Snapped, MovesEndsOntoPlaces) {
    const Shape shape = shape_of({line_element({0, 0}, {1, 0}), parabola_element({1, 1}, {2, 1}, {3, 2})});
    const std::array<Vec, 4> places = {Vec{1 + 0.5 * tolerance, 0}, Vec{0.5, 0}, Vec{3, 2 + 0.9 * tolerance},
                                       Vec{1, 1 + 2 * tolerance}};
    const Shape moved = snapped(shape, places, tolerance);
    ASSERT_EQ(moved.elements.size(), 2U);
    EXPECT_EQ(moved.elements[0], line_element({0, 0}, places[0]));
    const auto [first, last] = ends_of(moved.elements[1]);
    EXPECT_EQ(first, (Vec{1, 1}));
    EXPECT_NE(last, (Vec{3, 2}));
    EXPECT_LT(length(last - places[2]), 0.9 * tolerance);
    EXPECT_TRUE(lies_on(piece_of(shape.elements[1], {0, 1.01}), last, 1e-13));
    EXPECT_EQ(snapped(moved, places, tolerance), moved);
}

// As the whole design at once would have it.
TEST(Replaced, ChangesWhatIsNear) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(); ++seed) {
        CaseRandom random(seed);
        SCOPED_TRACE(seed);
        const World world = random_world(random, Coordinates::any);
        const std::uint32_t weights = 1 + random.below(3);
        const Cells x = random_cells(random, world, weights), y = random_cells(random, world, weights),
                    z = random_cells(random, world, weights);
        const Shape design = shape_of(runs_of(world, x)), taken = shape_of(runs_of(world, y)),
                    put = shape_of(runs_of(world, z));
        const Cells rest = combined(x, y, [](double p, double q) { return q > 0 ? 0 : p; });
        const Cells wanted = combined(rest, z, [](double p, double q) { return std::max(p, q); });
        Ambiguities doubts;
        const Shape after = replaced(design, taken, put, tolerance, &doubts);
        EXPECT_EQ(difference_to(after.elements, runs_of(world, wanted), 1e-9), "");
        EXPECT_TRUE(doubts.found.empty());
        EXPECT_EQ(merged(after.elements, tolerance), after);
        const Change change = change_by(design, taken, put, tolerance);
        Shape back = after;
        apply(inverse(change), back);
        EXPECT_EQ(back, design);
        std::vector<std::uint32_t> all(design.elements.size());
        for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
        const Change of_all = change_by(design, all, taken, put, tolerance);
        EXPECT_EQ(difference_to(of_all.added, change.added, 1e-12), "");
        EXPECT_EQ(of_all.removed, change.removed);
        EXPECT_EQ(replaced(after, {}, {}, tolerance), after);
        if (::testing::Test::HasFailure()) break;
    }
}

// A rule and its inverse, under maps that are known to rounding only, a thousand times.
TEST(Replaced, StaysWhereItWas) {
    const std::uint64_t count = std::max<std::uint64_t>(case_count() / 100, 1);
    for (std::uint64_t seed = first_seed(); seed < first_seed() + count; ++seed) {
        CaseRandom random(seed);
        SCOPED_TRACE(seed);
        const World world = random_world(random, Coordinates::any);
        const Cells x = random_cells(random, world), y = random_cells(random, world), z = random_cells(random, world);
        const Cells taken = combined(x, y, [](double p, double q) { return std::min(p, q); });
        const Cells put = combined(x, z, [](double p, double q) { return p > 0 ? 0 : q; });
        const Shape start = shape_of(runs_of(world, x));
        const Shape left = shape_of(runs_of(world, taken)), right = shape_of(runs_of(world, put));
        Shape design = start;
        // The rule in its own plane, and the design's map from there, with the noise that a search for matches leaves.
        const auto placed = [&](const Shape& shape) {
            const Transform away = random_similarity(random);
            Transform back = inverse(away);
            back.e += random.between(-1, 1) * 1e-11;
            back.f += random.between(-1, 1) * 1e-11;
            return transformed(transformed(shape, away), back);
        };
        for (int step = 0; step < 500; ++step) {
            design = replaced(design, placed(left), placed(right), tolerance);
            design = replaced(design, placed(right), placed(left), tolerance);
        }
        ASSERT_EQ(difference_to(design.elements, start.elements, 2 * tolerance), "");
    }
}

TEST(Change, IsInOrder) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(); ++seed) {
        CaseRandom random(seed);
        SCOPED_TRACE(seed);
        const auto numbers = [&](double offset, std::size_t most) {
            std::vector<Element> elements;
            for (std::size_t i = random.index(most); i > 0; --i) {
                elements.push_back(point_element({offset + 2.0 * random.below(20), 0}));
            }
            std::sort(elements.begin(), elements.end(), comes_before);
            elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
            return elements;
        };
        Shape design{numbers(0, 30)};
        Change change;
        for (const Element& e : design.elements) {
            if (random.below(3) == 0) change.removed.push_back(e);
        }
        change.added = numbers(1, 10);
        std::vector<Element> wanted;
        std::set_difference(design.elements.begin(), design.elements.end(), change.removed.begin(),
                            change.removed.end(), std::back_inserter(wanted), comes_before);
        wanted.insert(wanted.end(), change.added.begin(), change.added.end());
        std::sort(wanted.begin(), wanted.end(), comes_before);
        apply(change, design);
        EXPECT_EQ(design.elements, wanted);
    }
}

}  // namespace
}  // namespace filigree::curves
