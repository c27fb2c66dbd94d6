#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/elementary.h"
#include "base/test_cases.h"
#include "plane/arc.h"
#include "plane/clean.h"
#include "plane/clean_test_oracle.h"
#include "plane/path.h"

namespace filigree {
namespace {

Path parsed(std::string_view data) { return *parse_path_data(data); }

double enclosed_area(std::string_view data, double tolerance) {
    return area(clean(flatten(parsed(data), tolerance), FillRule::nonzero));
}

double distance(Vec p, Vec a, Vec b) {
    const Vec d = b - a;
    const double squared = dot(d, d);
    const double part = squared == 0 ? 0 : std::clamp(dot(p - a, d) / squared, 0.0, 1.0);
    return length(p - (a + part * d));
}
double distance(Vec p, const Polyline& line) {
    double least = length(p - line.points[0]);
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
        least = std::min(least, distance(p, line.points[i], line.points[i + 1]));
    }
    return least;
}

// A point of a curve by de Casteljau's construction.
Vec on_bezier(std::vector<Vec> points, double t) {
    for (std::size_t left = points.size() - 1; left > 0; --left) {
        for (std::size_t i = 0; i < left; ++i) points[i] = points[i] * (1 - t) + points[i + 1] * t;
    }
    return points[0];
}

// A point of an arc word for word as SVG 1.1's appendix F.6.5 has it.
Vec on_svg_arc(Vec from, double rx, double ry, double rotation, bool large, bool sweep, Vec to, double t) {
    const long double phi = rotation * 3.14159265358979323846264L / 180;
    const long double c = std::cos(phi), s = std::sin(phi);
    const long double hx = (static_cast<long double>(from.x) - to.x) / 2,
                      hy = (static_cast<long double>(from.y) - to.y) / 2;
    const long double x = c * hx + s * hy, y = c * hy - s * hx;
    long double a = rx, b = ry;
    const long double reach = x * x / (a * a) + y * y / (b * b);
    if (reach > 1) a *= std::sqrt(reach), b *= std::sqrt(reach);
    const long double rest = a * a * b * b - a * a * y * y - b * b * x * x;
    long double k = std::sqrt(std::max(0.0L, rest) / (a * a * y * y + b * b * x * x));
    if (large == sweep) k = -k;
    const long double cx = k * a * y / b, cy = -k * b * x / a;
    const long double start = std::atan2((y - cy) / b, (x - cx) / a);
    long double turn = std::atan2((-y - cy) / b, (-x - cx) / a) - start;
    const long double full = 2 * 3.14159265358979323846264L;
    if (sweep && turn < 0) turn += full;
    if (!sweep && turn > 0) turn -= full;
    const long double at = start + turn * t;
    const long double px = a * std::cos(at) + cx, py = b * std::sin(at) + cy;
    return {static_cast<double>(c * px - s * py + (static_cast<long double>(from.x) + to.x) / 2),
            static_cast<double>(s * px + c * py + (static_cast<long double>(from.y) + to.y) / 2)};
}

TEST(Flatten, LinesAreKept) {
    const auto lines = flatten(parsed("M1 2L3 4 3 4 5 6M7 8M0 0H4V4H0V0ZL9 9M1 1Z"), 0.1);
    ASSERT_EQ(lines.size(), 4U);
    EXPECT_EQ(lines[0], (Polyline{{{1, 2}, {3, 4}, {5, 6}}, false}));
    EXPECT_EQ(lines[1], (Polyline{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, true}));
    EXPECT_EQ(lines[2], (Polyline{{{0, 0}, {9, 9}}, false}));
    EXPECT_EQ(lines[3], (Polyline{{{1, 1}}, true}));
    EXPECT_TRUE(flatten({}, 0.1).empty());
    EXPECT_TRUE(flatten(parsed("M1 1"), 0.1).empty());
}

TEST(Flatten, CircleByArcs) {
    const double circle = elementary::pi * 2500;
    for (const std::string_view data :
         {"M0 50A50 50 0 0 1 100 50A50 50 0 0 1 0 50Z", "M0 50A50 50 0 1 1 100 50 50 50 0 1 1 0 50",
          "M0 50A50 50 0 0 0 100 50A50 50 0 0 0 0 50Z", "M0 50A50 50 30 1 1 50 100A50 50 77 0 1 0 50",
          "M0 50A1 1 0 0 1 100 50A.1 .1 0 0 1 0 50Z" /* radii that do not reach */}) {
        EXPECT_NEAR(enclosed_area(data, 1e-6), circle, 50 * 7 * 1e-6) << data;
        EXPECT_LE(enclosed_area(data, 1), circle);
    }
    EXPECT_NEAR(enclosed_area("M0 0A30 10 0 0 1 60 0A30 10 0 0 1 0 0", 1e-6), elementary::pi * 300, 2e-4);
    EXPECT_NEAR(enclosed_area("M0 0A30 10 90 0 1 20 0A30 10 90 0 1 0 0", 1e-6), elementary::pi * 300, 2e-4);
    const double sector = 2500 * (elementary::pi / 4 - 0.5);  // between a quarter circle and its chord
    EXPECT_NEAR(enclosed_area("M50 0A50 50 0 0 1 0 50", 1e-6), sector, 1e-4);
    EXPECT_NEAR(enclosed_area("M50 0A50 50 0 1 0 0 50", 1e-6), circle - sector, 4e-4);
}

TEST(Flatten, AreasUnderBeziers) {
    EXPECT_NEAR(enclosed_area("M0 0Q50 100 100 0", 1e-6), 100 * 100 / 3.0, 2e-4);     // two thirds of the triangle
    EXPECT_NEAR(enclosed_area("M0 0C0 100 100 100 100 0", 1e-6), 0.6 * 10000, 2e-4);  // 3/20 of the sum of crosses
    const double k = 4.0 / 3 * 0.41421356237309503;                                   // a circle by four cubics
    const double quarter = 0.05 * (10 + 12 * k - 3 * k * k);
    const Path circle{{Verb::move, Verb::cubic, Verb::cubic, Verb::cubic, Verb::cubic, Verb::close},
                      {{100, 0},
                       {100, 100 * k},
                       {100 * k, 100},
                       {0, 100},
                       {-100 * k, 100},
                       {-100, 100 * k},
                       {-100, 0},
                       {-100, -100 * k},
                       {-100 * k, -100},
                       {0, -100},
                       {100 * k, -100},
                       {100, -100 * k},
                       {100, 0}}};
    EXPECT_NEAR(area(clean(flatten(circle, 1e-6), FillRule::nonzero)), 4e4 * quarter, 1e-3);
    EXPECT_NEAR(4 * quarter, elementary::pi, 1e-3);
}

TEST(Flatten, DegenerateCurves) {
    const auto points = [](std::string_view data) { return flatten(parsed(data), 0.01).at(0).points; };
    EXPECT_EQ(points("M1 1C1 1 1 1 1 1"), (std::vector<Vec>{{1, 1}}));
    EXPECT_EQ(points("M1 1L1 1L5 5L5 5"), (std::vector<Vec>{{1, 1}, {5, 5}}));
    EXPECT_EQ(points("M0 0A0 5 0 0 1 9 9"), (std::vector<Vec>{{0, 0}, {9, 9}}));
    EXPECT_EQ(points("M0 0A5 0 0 0 1 9 9"), (std::vector<Vec>{{0, 0}, {9, 9}}));
    EXPECT_EQ(points("M4 4A5 5 0 1 1 4 4"), (std::vector<Vec>{{4, 4}}));
    EXPECT_EQ(points("M0 0A1e300 1e300 0 0 1 9 9"), (std::vector<Vec>{{0, 0}, {9, 9}}));
    EXPECT_EQ(points("M0 0A1e300 1e300 0 1 1 9 9"), (std::vector<Vec>{{0, 0}, {9, 9}})) << "off the plane";
    EXPECT_EQ(points("M0 0C1e300 0 0 1e300 9 9"), (std::vector<Vec>{{0, 0}, {9, 9}}));
    EXPECT_EQ(points("M0 0A-5 -5 1e308 0 1 10 0").back(), (Vec{10, 0}));
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
    for (const double bad : {nan, infinite, -infinite}) {
        for (const Verb verb : {Verb::line, Verb::quadratic, Verb::cubic, Verb::arc}) {
            for (std::size_t place = 0; place < 2 * point_count(verb); ++place) {
                Path path{{Verb::move, verb, Verb::close}, {{1, 2}}};
                for (std::size_t i = 0; i < point_count(verb); ++i) path.points.push_back({3, 1});
                (place % 2 == 0 ? path.points[1 + place / 2].x : path.points[1 + place / 2].y) = bad;
                EXPECT_LE(flatten(path, 0.1).at(0).points.size(), 1000U);
                EXPECT_GE(transformed(path, {bad, 1, 0, bad, 1, 0}).points.size(), 2U);
                clean(flatten(path, 0.1), FillRule::nonzero);
            }
        }
    }
    for (const double bad : {nan, 0.0, -1.0, infinite}) {
        const std::size_t count = flatten(parsed("M0 0Q50 100 100 0"), bad).at(0).points.size();
        EXPECT_TRUE(bad == infinite ? count == 2 : count > 10000 && count <= 1000001) << bad;
    }
}

TEST(Flatten, BrokenPaths) {
    EXPECT_EQ(flatten({{Verb::line}, {{3, 4}}}, 1).at(0).points, (std::vector<Vec>{{0, 0}, {3, 4}}));
    EXPECT_TRUE(flatten({{Verb::move, Verb::cubic}, {{3, 4}, {5, 6}}}, 1).empty());
    EXPECT_EQ(transformed({{Verb::move, Verb::arc}, {{3, 4}, {5, 6}}}, {}).verbs.size(), 1U);
    EXPECT_EQ(to_path_data({{Verb::line, Verb::line}, {{3, 4}}}), "M0 0L3 4");
    EXPECT_EQ(flatten({{Verb::close}, {}}, 1).size(), 1U);
}

// One curve at random; `at` gives its true points.
struct Curve {
    Path path;
    double size = 1;
    std::vector<Vec> bezier;
    double rx = 0, ry = 0, rotation = 0;
    bool large = false, sweep = false;

    Vec at(double t) const {
        if (!bezier.empty()) return on_bezier(bezier, t);
        return on_svg_arc(path.points[0], rx, ry, rotation, large, sweep, path.points[3], t);
    }
};
Curve random_curve(CaseRandom& random) {
    Curve curve;
    curve.size = std::ldexp(1, random.whole(-3, 12));
    const auto point = [&] {
        const double x = random.between(-curve.size, curve.size), y = random.between(-curve.size, curve.size);
        return Vec{x, y};
    };
    curve.path = {{Verb::move}, {point()}};
    const std::int64_t kind = random.whole(0, 2);
    if (kind == 2) {
        curve.rx = random.between(0.01, 1) * curve.size;
        curve.ry = random.unit() < 0.3 ? curve.rx : random.between(0.01, 1) * curve.size;
        curve.rotation = random.between(-400, 400);
        curve.large = random.unit() < 0.5;
        curve.sweep = random.unit() < 0.5;
        curve.path.verbs.push_back(Verb::arc);
        curve.path.points.push_back({curve.rx, curve.ry});
        curve.path.points.push_back({curve.rotation, (curve.large ? 1.0 : 0.0) + (curve.sweep ? 2.0 : 0.0)});
        curve.path.points.push_back(point());
    } else {
        curve.path.verbs.push_back(kind == 0 ? Verb::quadratic : Verb::cubic);
        for (std::size_t i = 0; i < point_count(curve.path.verbs[1]); ++i) curve.path.points.push_back(point());
        curve.bezier = curve.path.points;
    }
    return curve;
}

TEST(Flatten, StaysWithinTheTolerance) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed);
        const Curve curve = random_curve(random);
        const double tolerance = curve.size * std::ldexp(1, -random.whole(2, 14));
        const auto lines = flatten(curve.path, tolerance);
        ASSERT_EQ(lines.size(), 1U);
        ASSERT_EQ(lines[0].points.front(), curve.path.points.front()) << "seed " << seed;
        ASSERT_EQ(lines[0].points.back(), curve.path.points.back()) << "seed " << seed;
        for (int i = 0; i <= 300; ++i) {
            ASSERT_LE(distance(curve.at(i / 300.0), lines[0]), tolerance * (1 + 1e-9) + 1e-9 * curve.size)
                << "seed " << seed << " " << to_path_data(curve.path);
        }
        ASSERT_LE(static_cast<double>(lines[0].points.size()), 8 + 20 * std::sqrt(curve.size / tolerance))
            << "seed " << seed;
    }
}

TEST(Flatten, ACurveAndItsReverseGiveTheSamePoints) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed);
        const Curve curve = random_curve(random);
        if (curve.bezier.empty()) continue;
        Path reversed = curve.path;
        std::reverse(reversed.points.begin(), reversed.points.end());
        std::vector<Vec> back = flatten(reversed, 0.01)[0].points;
        std::reverse(back.begin(), back.end());
        ASSERT_EQ(flatten(curve.path, 0.01)[0].points, back) << "seed " << seed;
    }
}

TEST(Transformed, CurvesGoWhereTheirPointsGo) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed);
        const Curve curve = random_curve(random);
        Transform by{random.between(-2, 2), random.between(-2, 2), random.between(-2, 2), random.between(-2, 2), 0, 0};
        switch (random.whole(0, 5)) {
            case 0:
                by = compose(rotation_degrees(random.between(-360, 360)), scaling(1.5, 1.5));
                break;
            case 1:
                by = compose(rotation_degrees(random.between(-360, 360)), scaling(-2, 2));
                break;
            case 2:
                by = scaling(random.between(-2, 2), random.between(-2, 2));
                break;
            case 3:
                by.c = by.a * 2, by.d = by.b * 2;
                break;  // to a line, about
            case 4:
                by = scaling(1, 0);
                break;
            default:
                break;
        }
        by.e = random.between(-1, 1) * curve.size;
        const double tolerance = curve.size * 1e-4;
        const auto lines = flatten(transformed(curve.path, by), tolerance);
        ASSERT_EQ(lines.size(), 1U);
        for (int i = 0; i <= 100; ++i) {
            ASSERT_LE(distance(apply(by, curve.at(i / 100.0)), lines[0]), tolerance * 1.01)
                << "seed " << seed << " " << to_path_data(curve.path);
        }
    }
}

TEST(Transformed, ArcsStayArcs) {
    const Path arc = parsed("M10 0A20 10 30 1 0 5 6");
    EXPECT_EQ(to_path_data(transformed(arc, translation({1, 2}))), "M11 2A20 10 30 1 0 6 8");
    EXPECT_EQ(to_path_data(transformed(arc, scaling(2, 2))), "M20 0A40 20 30 1 0 10 12");
    EXPECT_EQ(to_path_data(transformed(arc, rotation_degrees(90))), "M0 10A20 10 120 1 0-6 5");
    EXPECT_EQ(to_path_data(transformed(parsed("M1 0A2 1 0 0 1 3 0"), scaling(3, -5))), "M3 0A6 5 0 0 0 9 0");
    EXPECT_EQ(transformed(arc, skew_degrees(20, 0)).verbs, arc.verbs);
    EXPECT_EQ(transformed(arc, scaling(1, 1e-9)).verbs[1], Verb::cubic);
}

// Half circles are where end points tell the centre worst: turned and skewed, their middles must still agree.
TEST(Transformed, HalfCirclesKeepTheirMiddles) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed);
        const double radius = random.between(1, 100);
        const Vec centre{random.between(-500, 500), random.between(-500, 500)};
        const Path half{{Verb::move, Verb::arc},
                        {centre - Vec{radius, 0}, {radius, radius}, {0, 2}, centre + Vec{radius, 0}}};
        Transform by = rotation_degrees(random.between(0, 360));
        if (random.unit() < 0.5) by = compose(by, scaling(random.between(0.5, 2), random.between(0.5, 2)));
        const Path mapped = transformed(half, by);
        const Vec middle = point_at(centre_arc(mapped.points[0], &mapped.points[1], mapped.points[3]), 0.5);
        ASSERT_LE(length(middle - apply(by, centre - Vec{0, radius})), 1e-9 * radius) << "seed " << seed;
    }
}

}  // namespace
}  // namespace filigree
