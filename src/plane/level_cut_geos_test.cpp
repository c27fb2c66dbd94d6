// GEOS as an oracle that shares nothing with the level cut: every strip's area is that of the shape's
// intersection with the strip as a polygon.
#include <geos_c.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "base/test_cases.h"
#include "plane/level_cut.h"
#include "plane/level_cut_test_shapes.h"

namespace filigree {
namespace {

using namespace level_cut_shapes;

class Geos {
public:
    Geos() : context_(GEOS_init_r()) {}
    ~Geos() { GEOS_finish_r(context_); }
    Geos(const Geos&) = delete;
    Geos& operator=(const Geos&) = delete;

    struct Free {
        GEOSContextHandle_t context;
        void operator()(GEOSGeometry* geometry) const { GEOSGeom_destroy_r(context, geometry); }
    };
    using Geometry = std::unique_ptr<GEOSGeometry, Free>;

    Geometry polygon(const std::vector<std::vector<Vec>>& rings) const {
        std::vector<GEOSGeometry*> made;
        for (const std::vector<Vec>& ring : rings) {
            const auto count = static_cast<unsigned>(ring.size());
            GEOSCoordSequence* points = GEOSCoordSeq_create_r(context_, count + 1, 2);
            for (unsigned i = 0; i <= count; ++i) {
                GEOSCoordSeq_setX_r(context_, points, i, ring[i % count].x);
                GEOSCoordSeq_setY_r(context_, points, i, ring[i % count].y);
            }
            made.push_back(GEOSGeom_createLinearRing_r(context_, points));
        }
        return own(
            GEOSGeom_createPolygon_r(context_, made[0], made.data() + 1, static_cast<unsigned>(made.size() - 1)));
    }
    Geometry intersection(const Geometry& a, const Geometry& b) const {
        return own(GEOSIntersection_r(context_, a.get(), b.get()));
    }
    bool is_valid(const Geometry& a) const { return GEOSisValid_r(context_, a.get()) == 1; }
    double area(const Geometry& a) const {
        double result = -1;
        if (a) GEOSArea_r(context_, a.get(), &result);
        return result;
    }

private:
    Geometry own(GEOSGeometry* geometry) const { return {geometry, Free{context_}}; }
    GEOSContextHandle_t context_;
};

std::vector<std::vector<Vec>> rings_of(PolygonView shape) {
    std::vector<std::vector<Vec>> rings;
    for (std::size_t r = 0; r < shape.ring_count(); ++r) {
        rings.emplace_back();
        for (const Point p : shape.ring(r)) rings.back().push_back(to_px(p));
    }
    return rings;
}

// The curve of a level from u = -reach to reach.
std::vector<Vec> curve(const LevelFamily& family, double level, double reach) {
    std::vector<Vec> points;
    const Profile& profile = family.profile;
    if (profile.samples.empty()) {
        for (const double u : {-reach, reach}) points.push_back(from_frame(family.frame, {u, level}));
        return points;
    }
    const auto n = static_cast<std::int64_t>(profile.samples.size());
    const auto last = static_cast<std::int64_t>(reach / profile.step) + 1;
    for (std::int64_t k = -last; k <= last; ++k) {
        const double sample = profile.samples[static_cast<std::size_t>(((k % n) + n) % n)];
        points.push_back(from_frame(family.frame, {static_cast<double>(k) * profile.step, level + sample}));
    }
    return points;
}

TEST(LevelCutAgainstGeos, EveryStripHasItsArea) {
    const Geos geos;
    std::size_t strips = 0;
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed + 8000000);
        const bool aligned = random.whole(0, 2) == 0;
        const Polygons shape = polygon_of(aligned ? cell_shape(random, 6, 8, false) : wobbly_shape(random));
        LevelFamily family = random_family(random, shape[0]);
        if (aligned) {
            family.frame = {{0, 0}, turn({1, 0}, 45 * random.whole(0, 7))};
            family.levels.clear();
            for (int k = -12; k <= 12; ++k) family.levels.push_back(8 * k);
            family.first_strip = 0;
        }
        const LevelCut result = cut(shape[0], family);
        const Geos::Geometry whole = geos.polygon(rings_of(shape[0]));
        ASSERT_TRUE(geos.is_valid(whole)) << "seed " << seed;
        std::vector<double> areas(family.levels.size() + 1, 0);
        for (std::size_t i = 0; i < result.pieces.size(); ++i) {
            areas[static_cast<std::size_t>(result.strips[i] - family.first_strip)] += area(result.pieces[i]);
            // GEOS agrees that every piece is a valid polygon, but for corners that rounding has closed.
            EXPECT_NEAR(geos.area(geos.polygon(rings_of(result.pieces[i]))), area(result.pieces[i]),
                        1e-8 * area(shape));
        }
        const double reach = 600;
        for (std::size_t k = 0; k + 1 < family.levels.size(); ++k) {
            std::vector<Vec> strip = curve(family, family.levels[k], reach);
            const std::vector<Vec> upper = curve(family, family.levels[k + 1], reach);
            strip.insert(strip.end(), upper.rbegin(), upper.rend());
            const double expected = geos.area(geos.intersection(whole, geos.polygon({strip})));
            // A cut's points may lie 2^-23 px off its line, over some 400 px of both sides of a strip.
            EXPECT_NEAR(areas[k + 1], expected, 1e-9 * area(shape) + 1e-6 + 400 * 0x1p-23) << "strip " << k;
            ++strips;
        }
        if (testing::Test::HasFailure()) FAIL() << "seed " << seed;
    }
    EXPECT_GT(strips, case_count());
}

}  // namespace
}  // namespace filigree
