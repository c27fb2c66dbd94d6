#include "curves/along.h"

#include <gtest/gtest.h>

#include "curves/test_shapes.h"

namespace filigree::curves {
namespace {

// A piece of an element's descriptor and where it was cut: somewhere from a length before it to a length behind it, no
// longer than the element.
struct Piece {
    Element element;
    Interval on;
};
Piece random_piece(CaseRandom& random, const Element& e) {
    const Interval own = interval_of(e);
    const double size = own.to - own.from;
    double from = own.from + size * random.between(-0.9, 1.8), to = own.from + size * random.between(-0.9, 1.8);
    if (from > to) std::swap(from, to);
    to = std::min(std::max(to, from + 0.05 * size), from + 0.99 * size);
    Element piece = piece_of(e, {from, to});
    if (random.coin()) piece = reversed(piece);
    return {piece, {from, to}};
}

TEST(Along, FindsPiecesOfOneDescriptor) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(); ++seed) {
        CaseRandom random(seed);
        SCOPED_TRACE(seed);
        for (const ElementKind kind : all_kinds) {
            if (kind == ElementKind::point) continue;
            const Element carrier = random_element(random, kind);
            if (is_closed(carrier)) continue;
            const auto [piece, on] = random_piece(random, carrier);
            if (rough_length(piece) > 3 * rough_length(carrier)) continue;
            const auto found = along(carrier, piece, 1e-9);
            ASSERT_TRUE(found) << static_cast<int>(kind);
            const double shift = kind == ElementKind::arc
                                     ? std::round((found->on.from - on.from) / 6.283185307179586) * 6.283185307179586
                                     : 0;
            EXPECT_NEAR(found->on.from - shift, on.from, 1e-8);
            EXPECT_NEAR(found->on.to - shift, on.to, 1e-8);
            EXPECT_LE(found->distance, 1e-10);
            if (kind != ElementKind::arc) {
                EXPECT_EQ(found->is_reversed, length(ends_of(piece).first - point_at(carrier, on.to)) < 1e-9);
            }
            EXPECT_NEAR(parameter_near(carrier, point_at(carrier, on.from), on.from + 0.01), on.from, 1e-9);
        }
    }
}

TEST(Along, ForgivesWhatIsOffByLess) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(); ++seed) {
        CaseRandom random(seed);
        SCOPED_TRACE(seed);
        for (const ElementKind kind : all_kinds) {
            Element carrier = random_element(random, kind);
            if (is_closed(carrier)) continue;
            // Shallow ones, too, down to a sagitta of some thousandth.
            const double thin = kind == ElementKind::parabola ? std::exp2(random.between(-8, 0)) : 1;
            const Transform flattened = compose(rotation_degrees(random.between(0, 360)), scaling(1, thin));
            carrier = transformed(carrier, flattened);
            if (kind == ElementKind::point) {
                EXPECT_TRUE(along(carrier, shaken(carrier, random, 1e-7), 1e-6));
                continue;
            }
            const Interval own = interval_of(carrier);
            const double middle = own.from + (own.to - own.from) * random.between(0.2, 0.8);
            const Element piece = piece_of(carrier, {middle, own.to});
            EXPECT_TRUE(along(shaken(carrier, random, 1e-8), shaken(piece, random, 1e-8), 1e-6))
                << static_cast<int>(kind);
        }
    }
}

TEST(Along, RefusesWhatIsOffByMore) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(); ++seed) {
        CaseRandom random(seed);
        SCOPED_TRACE(seed);
        for (const ElementKind kind : all_kinds) {
            const Element e = random_element(random, kind);
            const double reach = 1e-4;
            if (kind == ElementKind::point) {
                EXPECT_FALSE(along(e, point_element(e.at[0] + Vec{1.1e-4, 0}), reach));
                continue;
            }
            // Moved across itself at its middle, or bent.
            const Interval own = interval_of(e);
            const Vec way = velocity_at(e, 0.5 * (own.from + own.to));
            const Vec across = perpendicular(way) * (1 / length(way));
            EXPECT_FALSE(along(e, transformed(e, translation(across * (3 * reach))), reach));
            Element other_layer = e;
            other_layer.layer = 1;
            EXPECT_FALSE(along(e, other_layer, reach));
            if (kind == ElementKind::parabola || kind == ElementKind::cubic) {
                Element bent = e;
                bent.at[1] = bent.at[1] + across * 0.01;
                EXPECT_FALSE(along(e, bent, reach));
            }
            for (const ElementKind other : all_kinds) {
                if (other != kind) {
                    EXPECT_FALSE(along(e, random_element(random, other), 100));
                }
            }
        }
    }
}

// The shortest pieces that a shape may hold still know themselves, although their axes are noise.
TEST(Along, KnowsTheFlattestPieces) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(); ++seed) {
        CaseRandom random(seed);
        SCOPED_TRACE(seed);
        for (const ElementKind kind : {ElementKind::parabola, ElementKind::arc, ElementKind::cubic}) {
            const Element e = transformed(random_element(random, kind), translation({100, -50}));
            const Interval own = interval_of(e);
            const double size = std::exp2(random.between(-24, -3)), from = random.between(own.from, own.to);
            const Element tiny = piece_of(e, {from, from + size}), next = piece_of(e, {from + size, from + 1.5 * size});
            const double sweep = kind == ElementKind::arc ? size : 1;
            const auto itself = along(tiny, tiny, 1e-9), after = along(tiny, next, 1e-9);
            ASSERT_TRUE(itself && after && along(e, tiny, 1e-9)) << static_cast<int>(kind) << ' ' << size;
            EXPECT_NEAR(itself->on.to - itself->on.from, sweep, 1e-4 * sweep);
            EXPECT_NEAR(after->on.to - after->on.from, 0.5 * sweep, 1e-4 * sweep);
        }
    }
    const Element straight = parabola_element({0, 0}, {1, 1}, {2, 2});
    const auto found = along(straight, parabola_element({2, 2}, {3, 3}, {4, 4}), 1e-9);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->on, (Interval{1, 2}));
}

TEST(Along, MeasuresWhatSticksOut) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(); ++seed) {
        CaseRandom random(seed);
        SCOPED_TRACE(seed);
        for (const ElementKind kind : all_kinds) {
            const Element e = random_element(random, kind);
            EXPECT_LE(misfit(e, e, 1e-9).value_or(1), 1e-10);
            if (kind == ElementKind::point || is_closed(e)) continue;
            const Interval own = interval_of(e);
            const double size = own.to - own.from;
            const Element inside = piece_of(e, {own.from + 0.3 * size, own.to - 0.2 * size});
            EXPECT_LE(misfit(e, inside, 1e-9).value_or(1), 1e-10);
            const Element outside = piece_of(e, {own.from + 0.3 * size, own.to + 1e-4 * size});
            const double by = length(point_at(e, own.to + 1e-4 * size) - point_at(e, own.to));
            EXPECT_FALSE(misfit(e, outside, 0.9 * by));
            EXPECT_NEAR(misfit(e, outside, 1.1 * by).value_or(0), by, 0.01 * by);
        }
    }
    // Whose control points coincide at an end, where it has no speed.
    const Element slow = cubic_element({0, 0}, {0, 0}, {3, 4}, {9, 0});
    EXPECT_FALSE(misfit(slow, piece_of(slow, {-0.1, 0.5}), 1e-3));
    EXPECT_FALSE(misfit(piece_of(slow, {0, 0.8}), slow, 1e-3));
}

TEST(Along, GoesRoundCircles) {
    constexpr double pi = elementary::pi;
    const Element whole = circle_element({1, 2}, 3), arc = arc_element({1, 2}, {3, 0}, {0, 3}, -0.5, 4);
    EXPECT_LE(misfit(whole, arc, 1e-9).value_or(1), 1e-12);
    EXPECT_FALSE(misfit(arc, whole, 1e-3));
    // Across the seam at half a turn.
    const auto found = along(arc, arc_element({1, 2}, {3, 0}, {0, 3}, 3, 4.5), 1e-9);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->on.from, 3, 1e-12);
    EXPECT_NEAR(found->on.to, 4.5, 1e-12);
    EXPECT_FALSE(misfit(arc, arc_element({1, 2}, {3, 0}, {0, 3}, 3, 4.5), 1));
    EXPECT_NEAR(misfit(arc, arc_element({1, 2}, {3, 0}, {0, 3}, 3, 4.1), 1).value_or(0), 0.3, 1e-12);
    const Element rest = arc_element({1, 2}, {3, 0}, {0, 3}, 4, 2 * pi - 0.5);
    const auto behind = along(arc, rest, 1e-9);
    ASSERT_TRUE(behind);
    EXPECT_NEAR(behind->on.to - behind->on.from, 2 * pi - 4.5, 1e-12);
}

}  // namespace
}  // namespace filigree::curves
