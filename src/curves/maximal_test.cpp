#include "curves/maximal.h"

#include <gtest/gtest.h>

#include "curves/test_cells.h"

namespace filigree::curves {
namespace {

constexpr double tolerance = 1e-7;

// The page's vector: pieces of a parabola that overlap are the parabola again.
TEST(Maximal, JoinsPiecesThatOverlap) {
    const Element whole = parabola_element({0, 0}, {1, 0}, {2, 1});
    const Shape shape = maximal({piece_of(whole, {0, 0.6}), piece_of(whole, {1, 0.4})}, tolerance);
    ASSERT_EQ(shape.elements.size(), 1U);
    EXPECT_EQ(difference_to(shape.elements, {whole}, 1e-14), "");
}

TEST(Maximal, JoinsWhatTouchesOnly) {
    for (const ElementKind kind : {ElementKind::line, ElementKind::parabola, ElementKind::arc, ElementKind::cubic}) {
        CaseRandom random(3);
        Element whole = random_element(random, kind);
        while (is_closed(whole)) whole = random_element(random, kind);
        const Interval own = interval_of(whole);
        const double middle = 0.5 * (own.from + own.to), speed = length(velocity_at(whole, middle));
        const auto count = [&](double gap) {
            return maximal({piece_of(whole, {own.from, middle}), piece_of(whole, {middle + gap / speed, own.to})},
                           tolerance)
                .elements.size();
        };
        EXPECT_EQ(count(-0.1), 1U);
        EXPECT_EQ(count(0), 1U);
        EXPECT_EQ(count(0.9 * tolerance), 1U);
        EXPECT_EQ(count(1.1 * tolerance), 2U);
    }
}

TEST(Maximal, ClosesCircles) {
    constexpr double pi = elementary::pi;
    const Vec u{3, 0}, v{0, 3};
    for (const double narrow : {1.0, 0.5}) {
        const auto arc = [&](double from, double to) { return arc_element({1, 2}, u, v * narrow, from, to); };
        const Element whole = arc(0, 2 * pi);
        EXPECT_EQ(difference_to(maximal({arc(0, 3), arc(3, 2 * pi)}, tolerance).elements, {whole}, 1e-12), "");
        EXPECT_EQ(difference_to(maximal({arc(0, 3), arc(2, 5), arc(4, 7)}, tolerance).elements, {whole}, 1e-12), "");
        EXPECT_EQ(maximal({arc(0, 3), arc(3.01, 2 * pi)}, tolerance).elements.size(), 1U);
        EXPECT_EQ(maximal({arc(0, 3), arc(3.01, 6.1)}, tolerance).elements.size(), 2U);
        EXPECT_EQ(maximal({whole, arc(1, 2), whole, arc(-1, 3)}, tolerance).elements, (std::vector{whole}));
    }
}

TEST(Maximal, ShowsTheHeavier) {
    const auto line = [](double from, double to, double weight) {
        Element e = line_element({from, 0}, {to, 0});
        e.weight = weight;
        return e;
    };
    const auto shown = [](std::vector<Element> elements) { return maximal(std::move(elements), tolerance).elements; };
    EXPECT_EQ(shown({line(0, 4, 1), line(1, 2, 2)}), (std::vector{line(0, 1, 1), line(1, 2, 2), line(2, 4, 1)}));
    EXPECT_EQ(shown({line(0, 4, 2), line(1, 2, 1)}), (std::vector{line(0, 4, 2)}));
    EXPECT_EQ(shown({line(0, 3, 1), line(1, 4, 2), line(2, 5, 3)}),
              (std::vector{line(0, 1, 1), line(1, 2, 2), line(2, 5, 3)}));
    EXPECT_EQ(shown({line(0, 2, 1), line(2, 4, 2)}), (std::vector{line(0, 2, 1), line(2, 4, 2)}));
    Element light = point_element({1, 1}), heavy = light;
    heavy.weight = 2;
    heavy.at[0].x += 0.5 * tolerance;
    EXPECT_EQ(shown({light, heavy, light}), (std::vector{heavy}));
}

TEST(Maximal, KeepsLayersApart) {
    Element a = line_element({0, 0}, {2, 0}), b = line_element({1, 0}, {3, 0});
    b.layer = 1;
    EXPECT_EQ(maximal({a, b}, tolerance).elements, (std::vector{a, b}));
    Element p = point_element({0, 0}), q = p;
    q.layer = 1;
    EXPECT_EQ(maximal({p, q, p}, tolerance).elements, (std::vector{p, q}));
}

// Pieces that are straight to within the tolerance each make the curve that they were cut from.
TEST(Maximal, PutsTheFlattestPiecesTogether) {
    constexpr double coarse = 1e-2;
    CaseRandom random(5);
    for (const ElementKind kind : {ElementKind::parabola, ElementKind::arc, ElementKind::cubic}) {
        const Element whole = *normal_form(random_element(random, kind), coarse);
        const Interval own = interval_of(whole);
        std::vector<Element> pieces;
        constexpr int count = 300;
        for (int i = 0; i < count; ++i) {
            pieces.push_back(piece_of(
                whole, {own.from + (own.to - own.from) * i / count, own.from + (own.to - own.from) * (i + 1) / count}));
        }
        EXPECT_EQ(difference_to(maximal(pieces, coarse).elements, {whole}, 3 * coarse), "");
    }
}

// Errors do not grow from piece to piece.
TEST(Maximal, MakesOneOfThousandsOfPieces) {
    CaseRandom random(7);
    for (const ElementKind kind : {ElementKind::line, ElementKind::parabola, ElementKind::arc, ElementKind::cubic}) {
        const Element whole = *normal_form(random_element(random, kind), tolerance);
        const Interval own = interval_of(whole);
        std::vector<Element> pieces;
        constexpr int count = 5000;
        for (int i = 0; i < count; ++i) {
            pieces.push_back(piece_of(
                whole, {own.from + (own.to - own.from) * i / count, own.from + (own.to - own.from) * (i + 1) / count}));
        }
        EXPECT_EQ(difference_to(maximal(pieces, tolerance).elements, {whole}, tolerance), "");
    }
}

TEST(Maximal, SimplifiesWhatIsWhole) {
    const Shape shape = maximal({cubic_element({0, 0}, {1, 0}, {2, 0}, {3, 0}), line_element({3, 0}, {5, 0}),
                                 parabola_element({5, 0}, {5.5, 0}, {6, 0})},
                                tolerance);
    EXPECT_EQ(shape.elements, (std::vector{line_element({0, 0}, {6, 0})}));
    EXPECT_TRUE(maximal({line_element({0, 0}, {0.5 * tolerance, 0})}, tolerance).elements.empty());
    EXPECT_TRUE(maximal({}, tolerance).elements.empty());
}

TEST(Maximal, TellsNearDecisions) {
    const auto doubts = [](std::vector<Element> elements) {
        Ambiguities found;
        const Shape with = maximal(elements, tolerance, &found);
        EXPECT_EQ(with, maximal(elements, tolerance));
        return found.found;
    };
    EXPECT_TRUE(doubts({line_element({0, 0}, {1, 0}), line_element({1, 0}, {2, 0})}).empty());
    EXPECT_TRUE(doubts({line_element({0, 0}, {1, 0}), line_element({1 + 11 * tolerance, 0}, {2, 0})}).empty());
    const auto gap = doubts({line_element({0, 0}, {1, 0}), line_element({1 + 5 * tolerance, 0}, {2, 0})});
    ASSERT_EQ(gap.size(), 1U);
    EXPECT_EQ(gap[0].what, Doubt::gap);
    EXPECT_NEAR(gap[0].tolerances, 5, 1e-6);
    EXPECT_NEAR(gap[0].where.x, 1, 1e-5);
    const auto off = doubts({line_element({0, 0}, {1, 0}), line_element({0.5, 0}, {2, 4 * tolerance})});
    ASSERT_EQ(off.size(), 1U);
    EXPECT_EQ(off[0].what, Doubt::descriptor);
    const auto place = doubts({point_element({0, 0}), point_element({0, 3 * tolerance})});
    ASSERT_EQ(place.size(), 1U);
    EXPECT_EQ(place[0].what, Doubt::place);
    const auto flat = doubts({parabola_element({0, 0}, {1, 8 * tolerance}, {2, 0})});
    ASSERT_EQ(flat.size(), 1U);
    EXPECT_EQ(flat[0].what, Doubt::flatness);
    EXPECT_NEAR(flat[0].tolerances, 4, 0.1);
}

// The laws: what is drawn as pieces, in whatever way, is what was cut.
TEST(Maximal, MakesTheCurvesThatWereCut) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(); ++seed) {
        CaseRandom random(seed);
        SCOPED_TRACE(seed);
        const Coordinates in = random.coin() ? Coordinates::any : Coordinates::dyadic;
        const World world = random_world(random, in);
        const Cells cells = random_cells(random, world, 1 + random.below(3));
        std::vector<Element> pieces = drawn(random, world, cells);
        Ambiguities doubts;
        const Shape shape = maximal(pieces, tolerance, &doubts);
        ASSERT_EQ(difference_to(shape.elements, runs_of(world, cells), 1e-9), "");
        EXPECT_TRUE(doubts.found.empty());
        EXPECT_TRUE(std::is_sorted(shape.elements.begin(), shape.elements.end(), comes_before));
        EXPECT_EQ(maximal(shape.elements, tolerance), shape);
        EXPECT_EQ(merged(shape.elements, tolerance), shape);
        for (std::size_t i = pieces.size(); i > 1; --i) std::swap(pieces[i - 1], pieces[random.index(i)]);
        for (Element& e : pieces) {
            if (random.coin()) e = reversed(e);
        }
        EXPECT_EQ(maximal(pieces, tolerance), shape);

        const Transform by = random_similarity(random, in);
        const double scale = std::sqrt(std::fabs(determinant(by)));
        for (Element& e : pieces) e = transformed(e, by);
        std::vector<Element> moved = shape.elements;
        for (Element& e : moved) e = transformed(e, by);
        ASSERT_EQ(difference_to(maximal(pieces, tolerance * scale).elements, moved, 1e-9), "");
    }
}

// Pieces that lie beside each other by a share of the tolerance, as those of a file with few decimals do.
TEST(Maximal, ForgivesNoise) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(); ++seed) {
        CaseRandom random(seed);
        SCOPED_TRACE(seed);
        const World world = random_world(random, Coordinates::any);
        const Cells cells = random_cells(random, world, 1 + random.below(3));
        constexpr double coarse = 1e-3, noise = 1e-6;
        const Shape shape = merged(maximal(drawn(random, world, cells, noise), 1e-9).elements, coarse);
        ASSERT_EQ(difference_to(shape.elements, runs_of(world, cells), coarse), "");
        EXPECT_EQ(merged(shape.elements, coarse), shape);
    }
}

}  // namespace
}  // namespace filigree::curves
