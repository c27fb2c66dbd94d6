#include "plane/inset.h"

#include <geos_c.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "base/test_cases.h"
#include "plane/inset_general.h"
#include "plane/inset_test_shapes.h"
#include "plane/verify.h"

namespace filigree {
namespace {

std::vector<Point> ring_of(const std::vector<Vec>& corners) {
    std::vector<Point> ring;
    for (const Vec v : corners) ring.push_back(snap(v));
    return ring;
}

Polygons shape_of(const std::vector<std::vector<Vec>>& rings) {
    std::vector<std::vector<Point>> points;
    for (const auto& ring : rings) points.push_back(ring_of(ring));
    return test_shapes::one_polygon(points);
}

Polygons rectangle(double width, double height) {
    return shape_of({{{0, 0}, {width, 0}, {width, height}, {0, height}}});
}

std::vector<Vec> circle(Vec centre, double radius, int count) {
    std::vector<Vec> ring;
    for (int i = 0; i < count; ++i) {
        const elementary::CosSin at = elementary::cos_sin(2 * elementary::pi * i / count);
        ring.push_back(centre + Vec{at.cos, at.sin} * radius);
    }
    return ring;
}

Inset inset_by(const Polygons& shape, double distance, Join join = Join::mitre, double tolerance = 0.25) {
    InsetOptions options;
    options.distance = distance;
    options.join = join;
    options.tolerance = tolerance;
    return inset(shape[0], options);
}

Polygons generally(const Polygons& shape, double distance, Join join = Join::mitre, double tolerance = 0.25) {
    InsetOptions options;
    options.distance = distance;
    options.join = join;
    options.tolerance = tolerance;
    return general_inset(shape[0], Point{}, distance, join_rule(options, distance));
}

double distance_to_segment(Vec p, Vec a, Vec b) {
    const Vec ab = b - a;
    double t = dot(p - a, ab) / dot(ab, ab);
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    return length(p - (a + ab * t));
}

double distance_to_boundary(PolygonView shape, Vec p) {
    double least = 1e300;
    for (std::size_t r = 0; r < shape.ring_count(); ++r) {
        const RingView ring = shape.ring(r);
        for (std::size_t i = 0; i < ring.size(); ++i) {
            least = std::min(least, distance_to_segment(p, to_px(ring[i]), to_px(ring[(i + 1) % ring.size()])));
        }
    }
    return least;
}

// All that must hold of an inset, with nothing of its own code.
void expect_sound(const Polygons& shape, const Inset& result, double distance) {
    for (std::size_t i = 0; i < result.inner.size(); ++i) {
        const PolygonView inner = result.inner[i];
        const auto flaw = find_flaw(inner);
        EXPECT_FALSE(flaw.has_value()) << *flaw;
        for (std::size_t r = 0; r < inner.ring_count(); ++r) {
            EXPECT_EQ(area(inner.ring(r)) > 0, r == 0);
            const RingView ring = inner.ring(r);
            for (std::size_t k = 0; k < ring.size(); ++k) {
                ASSERT_EQ(locate(shape[0], ring[k]), 1);
                const Vec from = to_px(ring[k]);
                const Vec to = to_px(ring[(k + 1) % ring.size()]);
                ASSERT_GE(distance_to_boundary(shape[0], from), distance - 1e-6);
                ASSERT_GE(distance_to_boundary(shape[0], (from + to) * 0.5), distance - 1e-6);
            }
        }
    }
    const auto overlap = find_overlap(result.inner);
    EXPECT_FALSE(overlap.has_value()) << *overlap;
    const Polygons band = without(shape[0], result.inner);
    EXPECT_NEAR(area(band) + area(result.inner), area(shape), 1e-9 * area(shape));
    for (std::size_t i = 0; i < band.size(); ++i) {
        const auto flaw = find_flaw(band[i]);
        EXPECT_FALSE(flaw.has_value()) << "the band: " << *flaw;
    }
}

TEST(Inset, RectangleShrinksByTheDistance) {
    const Polygons shape = rectangle(40, 30);
    for (const Join join : {Join::mitre, Join::round}) {
        const Inset result = inset_by(shape, 5, join);
        ASSERT_EQ(result.inner.size(), 1U);
        EXPECT_FALSE(result.took_general_way);
        EXPECT_EQ(bounds(result.inner), (Box{snap({5, 5}), snap({35, 25})}));
        EXPECT_DOUBLE_EQ(area(result.inner), 30.0 * 20.0);
        expect_sound(shape, result, 5);
    }
}

TEST(Inset, VanishesFromHalfTheWidthOn) {
    const Polygons shape = rectangle(40, 30);
    EXPECT_EQ(inset_by(shape, 14.999).inner.size(), 1U);
    for (const double distance : {15.0, 15.001, 40.0, 1e9, 1e300}) EXPECT_TRUE(inset_by(shape, distance).inner.empty());
    const Inset result = inset_by(shape_of({circle({0, 0}, 10, 60)}), 9.9999);
    EXPECT_TRUE(result.inner.empty());
    EXPECT_FALSE(result.took_general_way);
}

TEST(Inset, RegularPolygonStaysRegular) {
    for (const int count : {3, 4, 5, 6, 17, 100}) {
        const Polygons shape = shape_of({circle({3, 4}, 50, count)});
        const double apothem = 50 * elementary::cos_sin(elementary::pi / count).cos;
        for (const double part : {0.01, 0.5, 0.99}) {
            const Inset result = inset_by(shape, apothem * part);
            ASSERT_EQ(result.inner.size(), 1U) << count;
            EXPECT_NEAR(area(result.inner), area(shape) * (1 - part) * (1 - part), 1e-5);
            EXPECT_EQ(result.inner.points.size(), static_cast<std::size_t>(count));
            expect_sound(shape, result, apothem * part);
        }
    }
}

TEST(Inset, ReflexCornersAreMitredRoundedOrCut) {
    // An L of two arms 10 wide: one reflex corner of a quarter turn.
    const Polygons shape = shape_of({{{0, 0}, {30, 0}, {30, 10}, {10, 10}, {10, 30}, {0, 30}}});
    const double d = 2;
    const Inset mitred = inset_by(shape, d);
    EXPECT_NEAR(area(mitred.inner), 26 * 6 + 6 * 20, 1e-6);
    const Inset rounded = inset_by(shape, d, Join::round, 1e-4);
    EXPECT_NEAR(area(rounded.inner), 26 * 6 + 6 * 20 + d * d * (1 - elementary::pi / 4), 2e-4);
    InsetOptions options;
    options.distance = d;
    options.mitre_limit = 1;
    const Inset cut = inset(shape[0], options);
    const double edge = 2 * (std::sqrt(2.0) - 1) * d;  // the side of a square's corner cut at the distance
    EXPECT_NEAR(area(cut.inner), 26 * 6 + 6 * 20 + edge * edge / 4, 1e-5);
    EXPECT_EQ(cut.inner.points.size(), 7U);
    for (const Inset& result : {mitred, rounded, cut}) {
        EXPECT_FALSE(result.took_general_way);
        expect_sound(shape, result, d);
    }
}

TEST(Inset, HolesGrow) {
    const Polygons shape =
        shape_of({{{0, 0}, {100, 0}, {100, 100}, {0, 100}}, {{40, 40}, {60, 40}, {60, 60}, {40, 60}}});
    const Inset result = inset_by(shape, 5);
    ASSERT_EQ(result.inner.size(), 1U);
    ASSERT_EQ(result.inner[0].ring_count(), 2U);
    EXPECT_DOUBLE_EQ(area(result.inner), 90.0 * 90.0 - 30.0 * 30.0);
    EXPECT_FALSE(result.took_general_way);
    expect_sound(shape, result, 5);
    const Polygons band = without(shape[0], result.inner);
    EXPECT_EQ(band.size(), 2U);
}

TEST(Inset, AnnulusVanishesWhenItsBandIsTooThin) {
    const Polygons shape = shape_of({circle({0, 0}, 50, 120), circle({0, 0}, 40, 120)});
    EXPECT_EQ(inset_by(shape, 4.9, Join::round, 0.01).inner.size(), 1U);
    EXPECT_TRUE(inset_by(shape, 5.1, Join::round, 0.01).inner.empty());
    EXPECT_TRUE(inset_by(shape, 5.1).inner.empty());
}

TEST(Inset, HolesThatMeetBecomeOne) {
    const Polygons shape = shape_of({{{0, 0}, {100, 0}, {100, 100}, {0, 100}},
                                     {{30, 40}, {45, 40}, {45, 60}, {30, 60}},
                                     {{51, 40}, {70, 40}, {70, 60}, {51, 60}}});
    const Inset result = inset_by(shape, 4);
    ASSERT_EQ(result.inner.size(), 1U);
    EXPECT_TRUE(result.took_general_way);
    EXPECT_EQ(result.inner[0].ring_count(), 2U);
    EXPECT_NEAR(area(result.inner), 92.0 * 92.0 - 48.0 * 28.0, 1e-6);
    expect_sound(shape, result, 4);
}

TEST(Inset, HoleThatMeetsTheOuterRingOpens) {
    const Polygons shape = shape_of({{{0, 0}, {100, 0}, {100, 100}, {0, 100}}, {{40, 5}, {60, 5}, {60, 60}, {40, 60}}});
    const Inset result = inset_by(shape, 4);
    ASSERT_EQ(result.inner.size(), 1U);
    EXPECT_EQ(result.inner[0].ring_count(), 1U);
    EXPECT_NEAR(area(result.inner), 92.0 * 92.0 - 28.0 * 60.0, 1e-6);
    expect_sound(shape, result, 4);
}

TEST(Inset, DumbbellFallsApart) {
    const Polygons shape = shape_of({{{0, 0},
                                      {30, 0},
                                      {30, 12},
                                      {50, 12},
                                      {50, 0},
                                      {80, 0},
                                      {80, 30},
                                      {50, 30},
                                      {50, 18},
                                      {30, 18},
                                      {30, 30},
                                      {0, 30}}});
    const Inset whole = inset_by(shape, 2.9);
    ASSERT_EQ(whole.inner.size(), 1U);
    EXPECT_FALSE(whole.took_general_way);
    for (const double distance : {3.0, 3.1, 14.0}) {
        const Inset parts = inset_by(shape, distance);
        ASSERT_EQ(parts.inner.size(), 2U) << distance;
        EXPECT_NEAR(area(parts.inner), 2 * (30 - 2 * distance) * (30 - 2 * distance), 1e-5);
        expect_sound(shape, parts, distance);
    }
    EXPECT_TRUE(inset_by(shape, 15.1).inner.empty());
}

TEST(Inset, CorridorsCloseAtOnce) {
    // A room with a corridor of parallel walls, and one with walls that open by a hair.
    const Polygons parallel = shape_of({{{0, 0}, {100, 0}, {100, 6}, {30, 6}, {30, 30}, {0, 30}}});
    for (const double distance : {3.0, 3.5}) {
        const Inset result = inset_by(parallel, distance);
        ASSERT_EQ(result.inner.size(), 1U);
        EXPECT_NEAR(area(result.inner), (30 - 2 * distance) * (30 - 2 * distance), 1e-6);
        expect_sound(parallel, result, distance);
    }
    const Polygons hair = shape_of({{{0, 0}, {100, 0}, {100, 6}, {30, 6.00001}, {30, 30}, {0, 30}}});
    const Inset result = inset_by(hair, 3.5);
    ASSERT_EQ(result.inner.size(), 1U);
    EXPECT_NEAR(area(result.inner), 23.0 * 23.0, 1e-3);
    expect_sound(hair, result, 3.5);
}

TEST(Inset, SmallDistances) {
    CaseRandom random(3);
    const Polygons shape = test_shapes::wobbly_shape(random, 100, 60, 0);
    for (const double distance : {1e-3, 1e-5, 1e-6}) {
        const Inset result = inset_by(shape, distance);
        ASSERT_EQ(result.inner.size(), 1U);
        EXPECT_LT(area(result.inner), area(shape));
        expect_sound(shape, result, distance);
    }
    // What is no distance counts as the least.
    for (const double distance : {0.0, -4.0, std::nan("")}) {
        const Inset result = inset_by(shape, distance);
        EXPECT_EQ(result.inner.size(), 1U);
        expect_sound(shape, result, 0x1p-20);
    }
}

TEST(Inset, OddOptionsAreHarmless) {
    const Polygons shape = shape_of({{{0, 0}, {30, 0}, {30, 10}, {10, 10}, {10, 30}, {0, 30}}});
    for (const double odd : {0.0, -1.0, std::nan(""), 1e300, 1e-300}) {
        for (const Join join : {Join::mitre, Join::round}) {
            InsetOptions options;
            options.distance = 2;
            options.join = join;
            options.mitre_limit = odd;
            options.tolerance = odd;
            const Inset result = inset(shape[0], options);
            EXPECT_EQ(result.inner.size(), 1U);
            expect_sound(shape, result, 2);
        }
    }
    EXPECT_TRUE(inset(PolygonView{}, {}).inner.empty());
}

TEST(Inset, FarAwayShapesComeOutTheSame) {
    CaseRandom random(12);
    const Polygons shape = test_shapes::wobbly_shape(random, 100, 60, 3);
    const Inset here = inset_by(shape, 3);
    const std::int64_t away = grid_limit - (std::int64_t{1} << 40);
    Polygons moved = shape;
    for (Point& p : moved.points) p = {p.x + away, p.y - away};
    Inset there = inset_by(moved, 3);
    for (Point& p : there.inner.points) p = {p.x - away, p.y + away};
    EXPECT_EQ(there.inner, here.inner);
}

TEST(Inset, HugeShapes) {
    const double half = 0x1p29;
    const Polygons shape = shape_of({{{-half, -half}, {half, -half}, {half, half}, {0, half}, {0, 0}, {-half, 0}}});
    for (const double distance : {1.0, 1e6}) {
        const Inset result = inset_by(shape, distance);
        ASSERT_EQ(result.inner.size(), 1U);
        const double side = half - 2 * distance;
        const double expected = (2 * half - 2 * distance) * side + (half - 2 * distance) * half;
        EXPECT_NEAR(area(result.inner) / expected, 1, 1e-6);
    }
}

// Section by section the inputs that other libraries stumble over.
TEST(Inset, DegenerateInputs) {
    struct Row {
        const char* name;
        std::vector<std::vector<Vec>> rings;
        double area_at_2;  // below 0: only soundness counts
    };
    std::vector<Vec> comb{{0, 0}, {100, 0}};
    for (int i = 9; i >= 0; --i) {
        comb.push_back({10.0 * i + 10, 40});
        comb.push_back({10.0 * i + 5, 40});
        comb.push_back({10.0 * i + 5, 10});
        comb.push_back({10.0 * i, 10});
    }
    const std::vector<Row> rows{
        {"square", {{{0, 0}, {100, 0}, {100, 100}, {0, 100}}}, 96.0 * 96},
        {"duplicate vertices",
         {{{0, 0}, {0, 0}, {100, 0}, {100, 0}, {100, 0}, {100, 100}, {0, 100}, {0, 0}}},
         96.0 * 96},
        {"collinear vertices", {{{0, 0}, {50, 0}, {50.0001, 0}, {100, 0}, {100, 100}, {30, 100}, {0, 100}}}, 96.0 * 96},
        {"jitter", {{{0, 0}, {50, 1e-7}, {50.0000001, -1e-7}, {100, 0}, {100, 100}, {0, 100}}}, -1},
        {"step of a hair", {{{0, 0}, {50, 0}, {50, 1e-6}, {100, 1e-6}, {100, 100}, {0, 100}}}, 96.0 * 96},
        {"comb", {comb}, -1},
        {"spike outwards", {{{0, 0}, {50, 0}, {50, -30}, {50, 0}, {100, 0}, {100, 100}, {0, 100}}}, -1},
        {"slit inwards", {{{0, 0}, {50, 0}, {50, 30}, {50, 0}, {100, 0}, {100, 100}, {0, 100}}}, -1},
        {"thin spike", {{{0, 0}, {49.9999999, 0}, {50, -30}, {50.0000001, 0}, {100, 0}, {100, 100}, {0, 100}}}, -1},
        {"thin slit", {{{0, 0}, {49.9999999, 0}, {50, 30}, {50.0000001, 0}, {100, 0}, {100, 100}, {0, 100}}}, -1},
        {"hole touching at a vertex",
         {{{0, 0}, {100, 0}, {100, 100}, {0, 100}}, {{0, 50}, {15, 35}, {30, 50}, {15, 65}}},
         -1},
        {"hole sharing an edge piece",
         {{{0, 0}, {100, 0}, {100, 100}, {0, 100}}, {{0, 40}, {10, 40}, {10, 60}, {0, 60}}},
         96.0 * 96 - 24 * 10.0},
        {"pinched", {{{0, 0}, {50, 50}, {100, 0}, {100, 100}, {50, 50}, {0, 100}}}, -1},
        {"bow-tie", {{{0, 0}, {100, 100}, {100, 0}, {0, 100}}}, -1},
        {"no area", {{{0, 0}, {50, 0}, {100, 0}}}, 0},
    };
    for (const Row& row : rows) {
        for (const double angle : {0.0, elementary::pi / 4, 0.1}) {
            SCOPED_TRACE(std::string(row.name) + " turned by " + std::to_string(angle));
            const elementary::CosSin by = elementary::cos_sin(angle);
            std::vector<std::vector<Vec>> rings = row.rings;
            for (auto& ring : rings) {
                for (Vec& v : ring) v = {v.x * by.cos - v.y * by.sin, v.x * by.sin + v.y * by.cos};
            }
            const Polygons shape = shape_of(rings);
            for (const double distance : {1e-3, 2.0, 7.0, 49.0}) {
                for (const Join join : {Join::mitre, Join::round}) {
                    const Inset result = inset_by(shape, distance, join);
                    for (std::size_t i = 0; i < result.inner.size(); ++i) {
                        const auto flaw = find_flaw(result.inner[i]);
                        EXPECT_FALSE(flaw.has_value()) << *flaw << " at " << distance;
                    }
                    for (const Point p : result.inner.points) {
                        EXPECT_GE(distance_to_boundary(shape[0], to_px(p)), distance - 1e-6) << distance;
                    }
                    if (distance == 2 && join == Join::mitre && row.area_at_2 >= 0) {
                        EXPECT_NEAR(area(result.inner), row.area_at_2, 1e-4);
                    }
                }
            }
        }
    }
}

Polygons random_shape(CaseRandom& random) {
    const int kind = random.whole(0, 9);
    if (kind < 3) {
        const std::vector<Point> ring = test_shapes::wild_ring(random, {0, 0}, 100, random.whole(4, 30));
        if (ring.size() >= 3 && doubled_area(ring) > 0) return test_shapes::one_polygon({ring});
    }
    return test_shapes::wobbly_shape(random, 100, random.whole(8, 120), kind < 6 ? 0 : 6);
}

TEST(Inset, SoundForRandomShapesAndDistances) {
    std::uint64_t general = 0;
    const std::uint64_t count = case_count(1500);
    for (std::uint64_t seed = 0; seed < count && !::testing::Test::HasFailure(); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        CaseRandom random(seed);
        const Polygons shape = random_shape(random);
        const double distance = random.whole(0, 4) == 0 ? random.between(0.001, 0.1) : random.between(0.1, 25);
        const Join join = random.whole(0, 1) == 0 ? Join::mitre : Join::round;
        const Inset result = inset_by(shape, distance, join, random.between(0.001, 0.5));
        general += result.took_general_way;
        expect_sound(shape, result, distance);
    }
    RecordProperty("general", std::to_string(general));
}

// Nothing that is left of the shape is missing: compared by random points with the definition. Rounded corners lie
// within the tolerance of the true border; what is farther off than that must agree.
TEST(Inset, HoldsExactlyThePointsThatAreFarEnough) {
    const std::uint64_t count = case_count(1500);
    for (std::uint64_t seed = 0; seed < count && !::testing::Test::HasFailure(); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        CaseRandom random(seed);
        const Polygons shape = random_shape(random);
        const double distance = random.between(0.1, 12);
        const double tolerance = 0.01;
        const Inset result = inset_by(shape, distance, Join::round, tolerance);
        for (int i = 0; i < 60; ++i) {
            const double x = random.between(-110, 110);
            const double y = random.between(-110, 110);
            const Point p = snap({x, y});
            if (locate(shape[0], p) <= 0) continue;
            const double far = distance_to_boundary(shape[0], to_px(p));
            // A tolerance off an arc's corner, a band is gone where two arcs meet at a sharp angle.
            if (std::fabs(far - distance) < 3 * tolerance) continue;
            bool is_inside = false;
            for (std::size_t k = 0; k < result.inner.size(); ++k)
                is_inside = is_inside || locate(result.inner[k], p) > 0;
            EXPECT_EQ(is_inside, far > distance)
                << x << ", " << y << " is " << far << " from the border, not " << distance;
        }
    }
}

class Geos {
public:
    Geos() : context_(GEOS_init_r()) {}
    ~Geos() { GEOS_finish_r(context_); }
    Geos(const Geos&) = delete;
    Geos& operator=(const Geos&) = delete;

    double inset_area(PolygonView shape, double distance, Join join) const {
        std::vector<GEOSGeometry*> holes;
        for (std::size_t r = 1; r < shape.ring_count(); ++r) holes.push_back(ring(shape.ring(r)));
        GEOSGeometry* polygon =
            GEOSGeom_createPolygon_r(context_, ring(shape.outer()), holes.data(), static_cast<unsigned>(holes.size()));
        const int style = join == Join::mitre ? GEOSBUF_JOIN_MITRE : GEOSBUF_JOIN_ROUND;
        GEOSGeometry* inner = GEOSBufferWithStyle_r(context_, polygon, -distance, 64, GEOSBUF_CAP_ROUND, style, 4);
        double area = -1;
        GEOSArea_r(context_, inner, &area);
        GEOSGeom_destroy_r(context_, inner);
        GEOSGeom_destroy_r(context_, polygon);
        return area;
    }

private:
    GEOSGeometry* ring(RingView points) const {
        GEOSCoordSequence* sequence = GEOSCoordSeq_create_r(context_, static_cast<unsigned>(points.size() + 1), 2);
        for (std::size_t i = 0; i <= points.size(); ++i) {
            const Vec p = to_px(points[i % points.size()]);
            GEOSCoordSeq_setXY_r(context_, sequence, static_cast<unsigned>(i), p.x, p.y);
        }
        return GEOSGeom_createLinearRing_r(context_, sequence);
    }

    GEOSContextHandle_t context_;
};

TEST(Inset, AgreesWithAnotherLibrary) {
    const Geos geos;
    const std::uint64_t count = case_count(1000);
    for (std::uint64_t seed = 0; seed < count && !::testing::Test::HasFailure(); ++seed) {
        CaseRandom random(seed);
        const Polygons wobbly = test_shapes::wobbly_shape(random, 100, random.whole(20, 120), 6);
        const Polygons any = random_shape(random);
        for (const Join join : {Join::mitre, Join::round}) {
            // Corners past the mitre limit are cut off in different ways, so these must not be too sharp.
            const Polygons& shape = join == Join::mitre ? wobbly : any;
            const double distance = random.between(0.1, 20);
            SCOPED_TRACE("seed " + std::to_string(seed) + " distance " + std::to_string(distance) + " join " +
                         std::to_string(static_cast<int>(join)));
            const double theirs = geos.inset_area(shape[0], distance, join);
            const Inset ours = inset_by(shape, distance, join, 0.001);
            const double margin = 1e-3 * theirs + 1e-6 * area(shape);
            EXPECT_NEAR(area(ours.inner), theirs, margin) << (ours.took_general_way ? "general" : "fast");
            EXPECT_NEAR(area(generally(shape, distance, join, 0.001)), theirs, margin) << "general";
        }
    }
}

TEST(Without, LeavesHolesWhereInnerPolygonsAre) {
    const Polygons shape = rectangle(100, 100);
    Polygons inner;
    for (int i = 0; i < 9; ++i) {
        const double x = 10 + 10.0 * (i % 3) * 3;
        const double y = 10 + 10.0 * (i / 3) * 3;
        inner.add_ring(ring_of({{x, y}, {x + 10, y}, {x + 10, y + 10}, {x, y + 10}}));
        inner.end_polygon();
    }
    const Polygons band = without(shape[0], inner);
    ASSERT_EQ(band.size(), 1U);
    EXPECT_EQ(band[0].ring_count(), 10U);
    EXPECT_DOUBLE_EQ(area(band), 10000.0 - 900);
    EXPECT_FALSE(find_flaw(band[0]).has_value());
}

TEST(Without, NothingTakenLeavesTheShape) {
    const Polygons shape = rectangle(10, 20);
    EXPECT_EQ(without(shape[0], Polygons{}), shape);
}

TEST(Without, IslandsInHolesOfInnerPolygonsStay) {
    const Polygons shape = rectangle(100, 100);
    Polygons inner = shape_of({{{10, 10}, {90, 10}, {90, 90}, {10, 90}}, {{20, 20}, {80, 20}, {80, 80}, {20, 80}}});
    inner.add_ring(ring_of({{40, 40}, {60, 40}, {60, 60}, {40, 60}}));
    inner.end_polygon();
    const Polygons band = without(shape[0], inner);
    ASSERT_EQ(band.size(), 2U);
    EXPECT_DOUBLE_EQ(area(band), 10000.0 - 6400 + 3600 - 400);
    for (std::size_t i = 0; i < band.size(); ++i) EXPECT_FALSE(find_flaw(band[i]).has_value());
}

TEST(Without, ThousandsOfDiscsAreFast) {
    const Polygons shape = rectangle(2100, 2100);
    Polygons inner;
    for (int i = 0; i < 10000; ++i) {
        const Vec centre{20.0 * (i % 100) + 30, 20.0 * (i / 100) + 30};
        inner.add_ring(ring_of(circle(centre, 8, 24)));
        inner.end_polygon();
    }
    const Polygons band = without(shape[0], inner);
    ASSERT_EQ(band.size(), 1U);
    EXPECT_NEAR(area(band) + area(inner), area(shape), 1e-9 * area(shape));
    // And once more around the discs: an inset of what remains, and its band, each with 10,000 rings.
    const Inset outline = inset_by(band, 1);
    EXPECT_FALSE(outline.took_general_way);
    ASSERT_EQ(outline.inner.size(), 1U);
    EXPECT_EQ(outline.inner[0].ring_count(), 10001U);
    const Polygons rings = without(band[0], outline.inner);
    EXPECT_EQ(rings.size(), 10001U);
    EXPECT_NEAR(area(rings) + area(outline.inner), area(band), 1e-9 * area(band));
}

}  // namespace
}  // namespace filigree
