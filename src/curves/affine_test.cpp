#include "curves/affine.h"

#include <gtest/gtest.h>

#include "curves/curve_test_shapes.h"
#include "curves/test_shapes.h"

namespace filigree::curves {
namespace {

using test_shapes::flower;
using test_shapes::moved;
using test_shapes::petal;
using test_shapes::shape_of;

constexpr double tolerance = 1e-6;

AffineMatches matches_of(const Shape& left, const Shape& design, const MatchOptions& options = {}) {
    return find_affine_matches(left, MatchIndex(design, options.tolerance), options);
}

Shape polygon(const std::vector<Vec>& corners) {
    std::vector<Element> sides;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        sides.push_back(line_element(corners[i], corners[(i + 1) % corners.size()]));
    }
    return shape_of(sides);
}
Shape joined(const std::vector<Shape>& shapes) {
    std::vector<Element> elements;
    for (const Shape& shape : shapes) elements.insert(elements.end(), shape.elements.begin(), shape.elements.end());
    return shape_of(elements);
}

const Transform skew = compose(translation({31, -12}), Transform{1.5, 0.4, -0.9, 0.7, 0, 0});

TEST(Affine, ATriangleIsFoundInEveryTriangle) {
    const Shape triangle = polygon({{0, 0}, {4, 0}, {1, 3}});
    const Shape design = joined({polygon({{10, 10}, {30, 12}, {14, 11}}), polygon({{-5, 0}, {-9, 1}, {-3, 17}})});
    EXPECT_EQ(affine_symmetries(triangle, {}).size(), 6U);
    const AffineMatches found = matches_of(triangle, design);
    EXPECT_FALSE(found.is_indeterminate);
    ASSERT_EQ(found.matches.found.size(), 2U);
    for (const Match& match : found.matches.found) {
        EXPECT_FALSE(match.is_reflected);
        EXPECT_LT(match.misfit, 1e-6);
        EXPECT_NEAR(match.scale * match.scale, std::fabs(determinant(match.by)), 1e-9);
    }
    MatchOptions large;
    large.min_scale = 1.5;
    EXPECT_EQ(matches_of(triangle, design, large).matches.found.size(), 1U);
}

// Four lines in general position make four triangles.
TEST(Affine, TrianglesThatNobodyDrewAreFound) {
    const Shape design = shape_of({line_element({0, 0}, {20, 1}), line_element({0, 9}, {20, -5}),
                                   line_element({3, -8}, {9.9, 15}), line_element({16, -8}, {9.1, 15})});
    EXPECT_EQ(matches_of(polygon({{0, 0}, {4, 0}, {1, 3}}), design).matches.found.size(), 4U);
}

TEST(Affine, AParallelogramIsFoundInParallelogramsOnly) {
    const Shape square = polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    EXPECT_EQ(affine_symmetries(square, {}).size(), 8U);
    MatchOptions direct;
    direct.with_reflections = false;
    EXPECT_EQ(affine_symmetries(square, direct).size(), 4U);
    const Shape design = joined({moved(square, skew), polygon({{-9, 0}, {-4, 0}, {-4, 5}, {-9, 4}})});
    const AffineMatches found = matches_of(square, design);
    ASSERT_EQ(found.matches.found.size(), 1U);
    EXPECT_NEAR(found.matches.found[0].centroid.x, apply(skew, {0.5, 0.5}).x, 1e-9);
    EXPECT_EQ(matches_of(square, design, direct).matches.found.size(), 1U);
}

TEST(Affine, APetalIsFoundByWhereItsTangentsMeet) {
    const Shape design = moved(flower(), skew);
    const AffineMatches found = matches_of(petal(), design);
    EXPECT_FALSE(found.is_indeterminate);
    EXPECT_EQ(affine_symmetries(petal(), {}).size(), 2U);
    EXPECT_EQ(found.matches.found.size(), 4U);
    for (const Match& match : found.matches.found) EXPECT_LT(match.misfit, 1e-3);
}

TEST(Affine, CirclesBecomeEllipses) {
    const Shape left =
        shape_of({circle_element({0, 0}, 2), line_element({-3, 1}, {3, 1}), line_element({1, -3}, {1, 3})});
    const Shape design = joined({moved(left, skew), shape_of({circle_element({5, 50}, 2)})});
    ASSERT_EQ(matches_of(left, design).matches.found.size(), 1U);
    EXPECT_EQ(matches_of(left, design).matches.found[0].carriers.size(), 3U);
}

TEST(Affine, LabelledPointsFixAMapByThemselves) {
    const Shape left = shape_of({point_element({0, 0}), point_element({1, 0}), point_element({0, 1})});
    const Shape design =
        shape_of({point_element({5, 5}), point_element({9, 6}), point_element({4, 12}), point_element({3, 1})});
    EXPECT_EQ(affine_symmetries(left, {}).size(), 6U);
    EXPECT_EQ(matches_of(left, design).matches.found.size(), 4U);
    Shape labelled = left, marked = design;
    labelled.elements[1].layer = 3;
    marked.elements[2].layer = 3;
    EXPECT_EQ(matches_of(labelled, marked).matches.found.size(), 3U);
}

TEST(Affine, WhatDoesNotFixAMapIsSaid) {
    const auto is_indeterminate = [](const Shape& left) {
        const AffineMatches found = matches_of(left, joined({left, flower()}));
        EXPECT_TRUE(found.matches.found.empty());
        return found.is_indeterminate;
    };
    EXPECT_TRUE(is_indeterminate(shape_of({line_element({0, 0}, {1, 0})})));
    EXPECT_TRUE(is_indeterminate(shape_of({parabola_element({0, 0}, {10, 0}, {10, 5})})));
    EXPECT_TRUE(is_indeterminate(shape_of({line_element({0, 0}, {1, 0}), line_element({0, -1}, {1, 2})})));
    // A ladder with one rung.
    EXPECT_TRUE(is_indeterminate(
        shape_of({line_element({0, 0}, {50, 0}), line_element({0, 10}, {50, 10}), line_element({20, 0}, {21, 10})})));
    EXPECT_FALSE(matches_of(polygon({{0, 0}, {4, 0}, {1, 3}}), {}).is_indeterminate);
}

TEST(Affine, LayersAndWeightsTellElementsApart) {
    Shape left = polygon({{0, 0}, {4, 0}, {1, 3}});
    Shape design = moved(left, skew);
    left.elements[0].layer = 2;
    EXPECT_EQ(affine_symmetries(left, {}).size(), 2U);
    EXPECT_EQ(matches_of(left, design).matches.found.size(), 0U);
    design.elements[1].layer = 2;
    EXPECT_EQ(matches_of(left, design).matches.found.size(), 1U);
    left.elements[0].weight = 2;
    EXPECT_EQ(matches_of(left, design).matches.found.size(), 0U);
}

// Whether a line ends at another or a little past it may look different where the map flattens it.
TEST(Affine, ALineThatEndsALittlePastAnotherIsFoundWhereItIsFlattened) {
    const Shape left =
        shape_of({line_element({0, 0}, {4, 0}), line_element({4, 0}, {1, 3}), line_element({1, 3}, {-1e-5, -3e-5})});
    ASSERT_EQ(left.elements.size(), 3U);
    for (const double flat : {1.0, 0.5, 0.2, 0.05}) {
        const Transform by = compose(rotation_degrees(20), scaling(1, flat));
        EXPECT_EQ(matches_of(left, moved(left, by)).matches.found.size(), 1U) << flat;
    }
}

// What follows knows lines alone, and nothing of the search.

std::optional<Vec> crossing(const Element& a, const Element& b) {
    const Vec u = a.at[1] - a.at[0], v = b.at[1] - b.at[0];
    const double turn = cross(u, v);
    if (std::fabs(turn) < 1e-9 * length(u) * length(v)) return std::nullopt;
    const double s = cross(b.at[0] - a.at[0], v) / turn, t = cross(b.at[0] - a.at[0], u) / turn;
    if (s < -1e-6 || s > 1 + 1e-6 || t < -1e-6 || t > 1 + 1e-6) return std::nullopt;
    return a.at[0] + u * s;
}
std::vector<Vec> crossings(const Shape& shape) {
    std::vector<Vec> found;
    for (std::size_t i = 0; i < shape.elements.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const auto at = crossing(shape.elements[i], shape.elements[j]);
            if (at && std::none_of(found.begin(), found.end(), [&](Vec p) { return length(p - *at) < 1e-6; })) {
                found.push_back(*at);
            }
        }
    }
    return found;
}
bool is_on_line(const Element& line, Vec p, double reach) {
    const Vec way = line.at[1] - line.at[0], off = p - line.at[0];
    const double size = length(way), along = dot(off, way) / size;
    return std::fabs(cross(off, way)) <= reach * size && along >= -reach && along <= size + reach;
}
bool is_covered(const Shape& left, const Transform& by, const Shape& design, double reach) {
    return std::all_of(left.elements.begin(), left.elements.end(), [&](const Element& e) {
        return std::any_of(design.elements.begin(), design.elements.end(), [&](const Element& carrier) {
            return is_on_line(carrier, apply(by, e.at[0]), reach) && is_on_line(carrier, apply(by, e.at[1]), reach);
        });
    });
}
Transform map_between(const std::array<Vec, 3>& from, const std::array<Vec, 3>& to) {
    const auto basis = [](const std::array<Vec, 3>& p) {
        return Transform{p[1].x - p[0].x, p[1].y - p[0].y, p[2].x - p[0].x, p[2].y - p[0].y, p[0].x, p[0].y};
    };
    return compose(basis(to), inverse(basis(from)));
}

// One map for each set of matches that differ by a symmetry.
std::vector<Transform> all_maps(const Shape& left, const Shape& design, double min_scale, double reach) {
    const std::vector<Vec> own = crossings(left), places = crossings(design);
    std::array<Vec, 3> from;
    double most = 0;
    for (const Vec p : own) {
        for (const Vec q : own) {
            for (const Vec r : own) {
                if (std::fabs(cross(q - p, r - p)) <= most) continue;
                most = std::fabs(cross(q - p, r - p));
                from = {p, q, r};
            }
        }
    }
    std::vector<Transform> found;
    for (const Vec p : places) {
        for (const Vec q : places) {
            for (const Vec r : places) {
                if (std::fabs(cross(q - p, r - p)) < 1e-2) continue;
                const Transform by = map_between(from, {p, q, r});
                if (!(std::fabs(determinant(by)) >= min_scale * min_scale)) continue;
                if (!is_covered(left, by, design, reach)) continue;
                const bool is_known = std::any_of(found.begin(), found.end(), [&](const Transform& other) {
                    return is_covered(left, compose(inverse(other), by), left, 100 * reach) &&
                           std::fabs(std::fabs(determinant(other) / determinant(by)) - 1) < 1e-4;
                });
                if (!is_known) found.push_back(by);
            }
        }
    }
    return found;
}

Transform random_affine(CaseRandom& random) {
    for (;;) {
        const Transform by{random.between(-2, 2), random.between(-2, 2),   random.between(-2, 2),
                           random.between(-2, 2), random.between(-30, 30), random.between(-30, 30)};
        if (std::fabs(determinant(by)) > 0.5) return by;
    }
}
Vec random_corner(CaseRandom& random) { return random_place(random, Coordinates::any, 8); }

// Lines of which each meets others, with three crossings that are not flat.
Shape random_lines(CaseRandom& random) {
    for (;;) {
        const Vec p = random_corner(random), q = random_corner(random), r = random_corner(random);
        if (std::fabs(cross(q - p, r - p)) < 20) continue;
        std::vector<Element> lines = {line_element(p, q), line_element(q, r), line_element(r, p)};
        if (random.coin()) lines.push_back(line_element((p + q) * 0.5, r * random.between(0.8, 1.2)));
        if (random.coin()) lines.push_back(line_element(p + (q - p) * 0.3, p + (r - p) * random.between(0.2, 0.9)));
        if (random.below(3) == 0) lines.erase(lines.begin() + random.whole(0, 2));
        const Shape shape = shape_of(lines);
        const std::vector<Vec> places = crossings(shape);
        double most = 0;
        for (const Vec b : places) {
            for (const Vec c : places) most = std::max(most, std::fabs(cross(b - places[0], c - places[0])));
        }
        if (most > 5) return shape;
    }
}

TEST(AffineProperty, PlantedLinesAreFoundAndNothingElse) {
    const std::uint64_t first = first_seed(), count = case_count(200);
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        SCOPED_TRACE(seed);
        CaseRandom random(seed);
        const Shape left = random_lines(random);
        std::vector<Element> lines;
        const int copies = random.whole(0, 2);
        for (int copy = 0; copy < copies; ++copy) {
            const Transform by = random_affine(random);
            const std::size_t decoy = random.below(3) == 0 ? random.index(left.elements.size()) : left.elements.size();
            for (std::size_t i = 0; i < left.elements.size(); ++i) {
                const bool is_short = i == decoy;
                const double before = random.coin() ? 0 : random.between(0.01, 0.3);
                lines.push_back(piece_of(transformed(left.elements[i], by), {is_short ? 0.002 : -before, 1 + before}));
            }
        }
        const int others = random.whole(0, 3);
        for (int i = 0; i < others; ++i) lines.push_back(line_element(random_corner(random), random_corner(random)));
        const Shape design = shape_of(lines);
        MatchOptions options;
        options.min_scale = 0.3;
        const Matches found = matches_of(left, design, options).matches;
        const std::vector<Transform> maps = all_maps(left, design, options.min_scale, 2 * tolerance);
        EXPECT_EQ(found.found.size(), maps.size());
        for (const Match& match : found.found) EXPECT_TRUE(is_covered(left, match.by, design, 2 * tolerance));
        if (HasFailure()) break;
    }
}

TEST(AffineProperty, PlantedCurvesAreFound) {
    const std::uint64_t first = first_seed(), count = case_count(300);
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        SCOPED_TRACE(seed);
        CaseRandom random(seed);
        std::vector<Element> elements = random_lines(random).elements;
        elements.push_back(random_element(random, all_kinds[random.below(5)]));
        elements.push_back(random_element(random, all_kinds[random.below(5)]));
        const Shape left = shape_of(elements);
        const Transform by = random_affine(random);
        std::vector<Element> design = moved(left, by).elements;
        for (int i = 0; i < 5; ++i) design.push_back(random_element(random, all_kinds[random.below(5)]));
        const AffineMatches found = matches_of(left, shape_of(design));
        EXPECT_FALSE(found.is_indeterminate);
        const auto is_planted = [&](const Match& match) {
            return std::all_of(left.elements.begin(), left.elements.end(), [&](const Element& e) {
                const Interval on = interval_of(e);
                const Vec p = point_at(e, on.from), q = point_at(e, 0.3 * on.from + 0.7 * on.to);
                return length(apply(match.by, p) - apply(by, p)) < 1e-5 &&
                       length(apply(match.by, q) - apply(by, q)) < 1e-5;
            });
        };
        EXPECT_EQ(std::count_if(found.matches.found.begin(), found.matches.found.end(), is_planted), 1);
        if (HasFailure()) break;
    }
}

// Among thousands of lines triangles are found by what touches, not by all triples.
TEST(Affine, ThousandsOfLinesAreSearchedByWhatTouches) {
    std::vector<Shape> shapes;
    CaseRandom random(9);
    for (int i = 0; i < 40; ++i) {
        for (int j = 0; j < 40; ++j) {
            const Transform by = translation({20.0 * i, 20.0 * j});
            const Shape square = polygon({{0, 0}, {5, random.between(0, 2)}, {7, 7}, {random.between(0, 2), 6}});
            shapes.push_back(moved(square, by));
            if ((i + j) % 4 != 0) continue;
            const Vec corner{10 + random.between(0, 4), random.between(0, 4)};
            shapes.push_back(moved(polygon({{10, 10}, {17, 12}, corner}), by));
        }
    }
    const Shape design = joined(shapes);
    ASSERT_GT(design.elements.size(), 7000U);
    EXPECT_EQ(matches_of(polygon({{0, 0}, {4, 0}, {1, 3}}), design).matches.found.size(), 400U);
}

}  // namespace
}  // namespace filigree::curves
