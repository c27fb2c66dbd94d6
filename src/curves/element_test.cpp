#include "curves/element.h"

#include <gtest/gtest.h>

#include <numbers>

#include "curves/test_shapes.h"

namespace filigree::curves {
namespace {

constexpr double pi = std::numbers::pi;

void expect_near(Vec a, Vec b, double within) { EXPECT_LE(length(a - b), within) << a.x << ' ' << a.y; }

TEST(Element, ArcsAreOneFormWhateverTheirAxes) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(); ++seed) {
        CaseRandom random(seed);
        SCOPED_TRACE(seed);
        const Vec centre = random_place(random, Coordinates::any), u = random_place(random, Coordinates::any);
        const Vec v = random.coin() ? random_place(random, Coordinates::any) : perpendicular(u);
        if (std::fabs(cross(u, v)) < 0.1) continue;
        const double from = random.between(-9, 9), to = from + random.between(-6.2, 6.2);
        const Element arc = arc_element(centre, u, v, from, to);
        EXPECT_GE(length(arc.at[1]), length(arc.at[2]) * (1 - 1e-9));
        EXPECT_NEAR(dot(arc.at[1], arc.at[2]), 0, 1e-12 * dot(arc.at[1], arc.at[1]));
        EXPECT_GT(cross(arc.at[1], arc.at[2]), 0);
        EXPECT_GE(arc.from, -pi);
        EXPECT_LT(arc.from, pi);
        EXPECT_NEAR(arc.to - arc.from, std::fabs(to - from), 1e-12);
        for (int i = 0; i <= 10; ++i) {
            const double t = from + (to - from) * i / 10;
            const Vec p = centre + u * std::cos(t) + v * std::sin(t);
            EXPECT_LE(std::min(length(point_at(arc, arc.from + (arc.to - arc.from) * i / 10) - p),
                               length(point_at(arc, arc.to - (arc.to - arc.from) * i / 10) - p)),
                      1e-11);
        }
        EXPECT_EQ(arc_element(arc.at[0], arc.at[1], arc.at[2], arc.from, arc.to), arc);
    }
}

TEST(Element, ArcsKeepTheirFormAtTheSeam) {
    for (const double from :
         {-pi, std::nextafter(pi, 0), pi, std::nextafter(-pi, 0), std::nextafter(-pi, -4), 3 * pi}) {
        const Element arc = arc_element({1, 2}, {3, 0}, {0, 3}, from, from + 1);
        EXPECT_GE(arc.from, -pi);
        EXPECT_LT(arc.from, pi);
        EXPECT_NEAR(arc.to - arc.from, 1, 1e-12);
        EXPECT_EQ(arc_element(arc.at[0], arc.at[1], arc.at[2], arc.from, arc.to), arc);
    }
    EXPECT_TRUE(is_closed(arc_element({}, {2, 0}, {0, 1}, 5, 5 + 2 * pi)));
    EXPECT_EQ(arc_element({}, {2, 0}, {0, 1}, 5, 5 + 2 * pi), arc_element({}, {2, 0}, {0, 1}, -9, 9));
}

TEST(Element, PiecesFollowTheDescriptor) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(); ++seed) {
        CaseRandom random(seed);
        SCOPED_TRACE(seed);
        for (const ElementKind kind : all_kinds) {
            const Element e = random_element(random, kind);
            if (kind == ElementKind::point || is_closed(e)) continue;
            const Interval own = interval_of(e);
            const double size = own.to - own.from;
            const double u = own.from + size * random.between(-0.5, 1.5), v = u + random.between(-0.9, 0.9);
            const Element piece = piece_of(e, {u, v});
            const Interval on = interval_of(piece);
            for (int i = 0; i <= 8; ++i) {
                const Vec p = point_at(e, u + (v - u) * i / 8);
                const Vec same = point_at(piece, on.from + (on.to - on.from) * i / 8);
                const Vec other = point_at(piece, on.from + (on.to - on.from) * (8 - i) / 8);
                EXPECT_LE(kind == ElementKind::arc ? std::min(length(same - p), length(other - p)) : length(same - p),
                          1e-11);
            }
        }
    }
}

TEST(Element, BoundsAreThoseOfTheCurve) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(300); ++seed) {
        CaseRandom random(seed);
        SCOPED_TRACE(seed);
        for (const ElementKind kind : all_kinds) {
            const Element e = random_element(random, kind);
            const Bounds bounds = bounds_of(e);
            const Interval on = interval_of(e);
            Bounds sampled;
            for (int i = 0; i <= 2000; ++i) extend(sampled, point_at(e, on.from + (on.to - on.from) * i / 2000));
            EXPECT_NEAR(bounds.min.x, sampled.min.x, 1e-4);
            EXPECT_NEAR(bounds.min.y, sampled.min.y, 1e-4);
            EXPECT_NEAR(bounds.max.x, sampled.max.x, 1e-4);
            EXPECT_NEAR(bounds.max.y, sampled.max.y, 1e-4);
            EXPECT_LE(bounds.min.x, sampled.min.x + 1e-12);
            EXPECT_LE(bounds.min.y, sampled.min.y + 1e-12);
            EXPECT_GE(bounds.max.x, sampled.max.x - 1e-12);
            EXPECT_GE(bounds.max.y, sampled.max.y - 1e-12);
        }
    }
}

TEST(Element, LengthsAreThoseOfManyChords) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(300); ++seed) {
        CaseRandom random(seed);
        SCOPED_TRACE(seed);
        for (const ElementKind kind : all_kinds) {
            const Element e = random_element(random, kind);
            const Interval on = interval_of(e);
            double sum = 0;
            for (int i = 0; i < 4000; ++i) {
                sum += length(point_at(e, on.from + (on.to - on.from) * (i + 1) / 4000) -
                              point_at(e, on.from + (on.to - on.from) * i / 4000));
            }
            EXPECT_NEAR(length_of(e), sum, 3e-5);
            if (kind != ElementKind::point) {
                EXPECT_GE(rough_length(e), sum - 1e-9);
                EXPECT_NEAR(rough_length(e, {0.2, 0.2002}), length(point_at(e, 0.2002) - point_at(e, 0.2)), 1e-8);
            }
        }
    }
}

TEST(Element, MovesAllItsPoints) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(); ++seed) {
        CaseRandom random(seed);
        SCOPED_TRACE(seed);
        const Transform by{random.between(-2, 2), random.between(-2, 2), random.between(-2, 2),
                           random.between(-2, 2), random.between(-9, 9), random.between(-9, 9)};
        if (std::fabs(determinant(by)) < 0.1) continue;
        for (const ElementKind kind : all_kinds) {
            const Element e = random_element(random, kind), moved = transformed(e, by);
            if (is_closed(e)) {
                EXPECT_TRUE(is_closed(moved));
                continue;
            }
            const Interval from = interval_of(e), to = interval_of(moved);
            for (int i = 0; i <= 6; ++i) {
                const Vec p = apply(by, point_at(e, from.from + (from.to - from.from) * i / 6));
                const Vec same = point_at(moved, to.from + (to.to - to.from) * i / 6);
                const Vec other = point_at(moved, to.from + (to.to - to.from) * (6 - i) / 6);
                EXPECT_LE(kind == ElementKind::arc ? std::min(length(same - p), length(other - p)) : length(same - p),
                          1e-9);
            }
        }
    }
}

TEST(Element, HasASimplestForm) {
    constexpr double tolerance = 1e-3;
    const auto kind_of = [](const Element& e) {
        const auto form = normal_form(e, tolerance);
        return form ? static_cast<int>(form->kind) : -1;
    };
    constexpr int none = -1, line = static_cast<int>(ElementKind::line),
                  parabola = static_cast<int>(ElementKind::parabola), arc = static_cast<int>(ElementKind::arc),
                  cubic = static_cast<int>(ElementKind::cubic);
    EXPECT_EQ(kind_of(line_element({0, 0}, {0, 0.0009})), none);
    EXPECT_EQ(kind_of(line_element({0, 0}, {0, 0.0011})), line);
    EXPECT_EQ(kind_of(line_element({0, 0}, {std::nan(""), 1})), none);
    EXPECT_EQ(kind_of(parabola_element({0, 0}, {1, 0.0019}, {2, 0})), line);
    EXPECT_EQ(kind_of(parabola_element({0, 0}, {1, 0.0021}, {2, 0})), parabola);
    EXPECT_EQ(kind_of(parabola_element({0, 0}, {0.0001, 0}, {0, 0})), none);
    EXPECT_EQ(kind_of(cubic_element({0, 0}, {1, 1}, {2, 1}, {3, 0})), parabola);
    EXPECT_EQ(kind_of(cubic_element({0, 0}, {1, 1}, {2, 1.1}, {3, 0})), cubic);
    EXPECT_EQ(kind_of(cubic_element({0, 0}, {1, 0}, {2, 0}, {5, 0})), line);
    EXPECT_EQ(kind_of(circle_element({0, 0}, 2)), arc);
    EXPECT_EQ(kind_of(circle_element({0, 0}, 1e-4)), none);
    EXPECT_EQ(kind_of(arc_element({0, 0}, {2, 0}, {0, 1e-4}, 0, 3)), line);
    EXPECT_EQ(kind_of(arc_element({0, 0}, {2, 0}, {0, 2}, 0, 0.05)), line);
    EXPECT_EQ(kind_of(arc_element({0, 0}, {2, 0}, {0, 2}, 0, 0.1)), arc);

    // A curve that turns back on itself is seen to its turn.
    EXPECT_EQ(normal_form(parabola_element({0, 0}, {4, 0}, {0, 0}), tolerance), line_element({0, 0}, {2, 0}));
    EXPECT_EQ(own_form(parabola_element({0, 0}, {4, 0}, {0, 0}), tolerance), line_element({0, 0}, {2, 0}));
    const Element flat = parabola_element({0, 0}, {1, 1e-5}, {2, 0});
    EXPECT_EQ(own_form(flat, tolerance), flat);
    // Nearly round is round, and what ends where it began is whole.
    const auto round = normal_form(arc_element({0, 0}, {2.0003, 0}, {0, 2}, 0, 3), tolerance);
    ASSERT_TRUE(round);
    EXPECT_TRUE(is_circular(*round));
    const auto whole = normal_form(arc_element({0, 0}, {2, 0}, {0, 2}, 1, 1 + 2 * pi - 4e-4), tolerance);
    ASSERT_TRUE(whole);
    EXPECT_TRUE(is_closed(*whole));
    const auto open = normal_form(arc_element({0, 0}, {2, 0}, {0, 2}, 1, 1 + 2 * pi - 6e-4), tolerance);
    ASSERT_TRUE(open);
    EXPECT_FALSE(is_closed(*open));
    EXPECT_EQ(normal_form(line_element({-0.0, 1}, {3, -0.0}), tolerance)->at[0].x, 0);
}

// The points of each lie on the other, and the form of the form is the form.
TEST(Element, FormsLookTheSame) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(300); ++seed) {
        CaseRandom random(seed);
        SCOPED_TRACE(seed);
        for (const ElementKind kind : all_kinds) {
            Element e = random_element(random, kind);
            const double tolerance = std::exp2(random.between(-20, 0));
            // Flat ones, thin ones and short ones, too.
            if (kind != ElementKind::point) {
                const double thin = std::exp2(random.between(-11, 1)), small = std::exp2(random.between(-16, 1));
                const Transform turned = rotation_degrees(random.between(0, 360));
                e = transformed(e, compose(turned, scaling(small, small * thin)));
            }
            for (const bool own : {false, true}) {
                const auto form = own ? own_form(e, tolerance) : normal_form(e, tolerance);
                if (!form) {
                    const Bounds box = bounds_of(e);
                    EXPECT_LE(length(box.max - box.min), 2.9 * tolerance);
                    continue;
                }
                EXPECT_EQ(own ? own_form(*form, tolerance) : normal_form(*form, tolerance), *form);
                EXPECT_EQ(own_form(*form, tolerance), *form);
                for (const auto& [a, b] : {std::pair(e, *form), std::pair(*form, e)}) {
                    const Interval on = interval_of(a);
                    for (int i = 0; i <= 7; ++i) {
                        EXPECT_TRUE(
                            lies_on(b, point_at(a, on.from + (on.to - on.from) * i / 7), 1.01 * tolerance + 1e-14));
                    }
                }
            }
        }
    }
}

TEST(Element, StartsAtTheLesserEnd) {
    CaseRandom random(1);
    for (const ElementKind kind : {ElementKind::line, ElementKind::parabola, ElementKind::cubic}) {
        const Element e = random_element(random, kind);
        EXPECT_EQ(normal_form(e, 1e-9), normal_form(reversed(e), 1e-9));
        const auto [first, last] = ends_of(*normal_form(e, 1e-9));
        EXPECT_TRUE(first.x < last.x);
    }
    expect_near(ends_of(circle_element({1, 2}, 3)).first, {-2, 2}, 1e-12);
}

TEST(Element, OrderIsTotal) {
    CaseRandom random(1);
    std::vector<Element> all;
    for (int i = 0; i < 40; ++i) {
        Element e = random_element(random, all_kinds[random.index(5)], Coordinates::dyadic);
        e.layer = random.below(2);
        e.weight = 1 + random.below(2);
        all.push_back(e);
        if (random.coin()) all.push_back(all[random.index(all.size())]);
    }
    for (const Element& a : all) {
        for (const Element& b : all) {
            EXPECT_EQ(comes_before(a, b) || comes_before(b, a), !(a == b));
            EXPECT_FALSE(comes_before(a, b) && comes_before(b, a));
        }
    }
}

}  // namespace
}  // namespace filigree::curves
