// What every cut by curves obeys, over random shapes and curves, with GEOS's polygonizer as an oracle that shares
// nothing with it.
#include <geos_c.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/test_cases.h"
#include "plane/curve_cut.h"
#include "plane/level_cut_test_laws.h"
#include "plane/verify.h"

namespace filigree {
namespace {

using namespace level_cut_shapes;

class Geos {
public:
    Geos() : context_(GEOS_init_r()) {}
    ~Geos() { GEOS_finish_r(context_); }
    Geos(const Geos&) = delete;
    Geos& operator=(const Geos&) = delete;

    // The areas of the faces of all lines together that lie inside the shape, least first.
    std::vector<double> face_areas(PolygonView shape, const std::vector<Polyline>& curves) const {
        std::vector<GEOSGeometry*> lines;
        for (std::size_t r = 0; r < shape.ring_count(); ++r) {
            std::vector<Vec> ring;
            for (const Point p : shape.ring(r)) ring.push_back(to_px(p));
            lines.push_back(line(ring, true));
        }
        for (const Polyline& curve : curves) {
            std::vector<Vec> points;
            for (const Vec p : curve.points) points.push_back(to_px(snap(p)));
            if (points.size() > 1) lines.push_back(line(points, curve.closed));
        }
        GEOSGeometry* all = GEOSGeom_createCollection_r(context_, GEOS_MULTILINESTRING, lines.data(),
                                                        static_cast<unsigned>(lines.size()));
        GEOSGeometry* noded = GEOSUnaryUnion_r(context_, all);
        GEOSGeometry* faces = GEOSPolygonize_r(context_, &noded, 1);
        std::vector<double> areas;
        for (int i = 0; i < GEOSGetNumGeometries_r(context_, faces); ++i) {
            const GEOSGeometry* face = GEOSGetGeometryN_r(context_, faces, i);
            double size = 0, x = 0, y = 0;
            GEOSArea_r(context_, face, &size);
            if (size < least_area) continue;
            GEOSGeometry* inside = GEOSPointOnSurface_r(context_, face);
            GEOSGeomGetX_r(context_, inside, &x);
            GEOSGeomGetY_r(context_, inside, &y);
            GEOSGeom_destroy_r(context_, inside);
            if (locate(shape, snap({x, y})) > 0) areas.push_back(size);
        }
        for (GEOSGeometry* geometry : {all, noded, faces}) GEOSGeom_destroy_r(context_, geometry);
        std::sort(areas.begin(), areas.end());
        return areas;
    }

    static constexpr double least_area = 1e-3;  // px^2: where lines meet in one point but for rounding

private:
    GEOSGeometry* line(const std::vector<Vec>& points, bool closed) const {
        const auto count = static_cast<unsigned>(points.size() + (closed ? 1 : 0));
        GEOSCoordSequence* sequence = GEOSCoordSeq_create_r(context_, count, 2);
        for (unsigned i = 0; i < count; ++i) {
            GEOSCoordSeq_setX_r(context_, sequence, i, points[i % points.size()].x);
            GEOSCoordSeq_setY_r(context_, sequence, i, points[i % points.size()].y);
        }
        return GEOSGeom_createLineString_r(context_, sequence);
    }
    GEOSContextHandle_t context_;
};

struct Case {
    Polygons shape;
    std::vector<Polyline> curves;
};

// Curves about the shape; on a lattice they run along borders and through vertices.
Polyline random_curve(CaseRandom& random, const Box& box, double lattice) {
    const Vec low = to_px(box.min) - Vec{20, 20}, high = to_px(box.max) + Vec{20, 20};
    const auto place = [&] {
        Vec p{random.between(low.x, high.x), random.between(low.y, high.y)};
        if (lattice > 0) p = {lattice * std::round(p.x / lattice), lattice * std::round(p.y / lattice)};
        return p;
    };
    Polyline curve;
    curve.closed = random.coin();
    switch (random.whole(0, 3)) {
        case 0:  // straight through
            curve.points = {place(), place()};
            break;
        case 1: {  // a scribble
            const int count = random.whole(2, 12);
            for (int i = 0; i < count; ++i) curve.points.push_back(place());
            break;
        }
        case 2: {  // steps along the axes
            Vec at = place();
            const double size = lattice > 0 ? lattice : random.between(1, 20);
            const int count = random.whole(2, 40);
            for (int i = 0; i < count; ++i) {
                curve.points.push_back(at);
                const double step = lattice > 0 ? random.whole(1, 4) : random.between(1, 4);
                at = at + turn({size * step, 0}, 90 * random.whole(0, 3));
            }
            break;
        }
        case 3: {  // a ring, or a part of one
            const Vec centre = place();
            const double radius = lattice > 0 ? 2 * lattice : random.between(1, 60);
            const int count = lattice > 0 ? 4 : random.whole(3, 60);
            const int drawn = random.coin() ? count : random.whole(2, count);
            for (int i = 0; i < drawn; ++i) curve.points.push_back(centre + turn({radius, 0}, 360.0 * i / count));
            break;
        }
    }
    return curve;
}

Case random_case(std::uint64_t seed) {
    CaseRandom random(seed);
    const int kind = random.whole(0, 2);
    Case result;
    result.shape = kind == 0 ? polygon_of(cell_shape(random, 6, 8, random.coin())) : polygon_of(wobbly_shape(random));
    const Box box = bounds(result.shape);
    const int count = random.whole(1, 12);
    for (int i = 0; i < count; ++i) {
        result.curves.push_back(random_curve(random, box, kind == 0 ? (random.coin() ? 4.0 : 8.0) : 0));
        if (random.whole(0, 9) == 0) result.curves.push_back(result.curves.back());
    }
    return result;
}

TEST(CurveCutProperties, PiecesPartitionTheShape) {
    std::size_t most = 0;
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        const auto [shape, curves] = random_case(seed);
        const Polygons pieces = cut_by_curves(shape[0], curves);
        EXPECT_NEAR(area(pieces), area(shape), 1e-9 * area(shape));
        EXPECT_NEAR(unmatched_length(pieces), perimeter(shape[0]), 1e-9 * perimeter(shape[0]));
        EXPECT_EQ(find_overlap(pieces).value_or(""), "");
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            EXPECT_EQ(find_flaw(pieces[i]).value_or(""), "") << "piece " << i;
            for (std::size_t r = 0; r < pieces[i].ring_count(); ++r) {
                const RingView ring = pieces[i].ring(r);
                EXPECT_EQ(*std::min_element(ring.begin(), ring.end()), ring[0]);
            }
            EXPECT_LE(pieces[i == 0 ? 0 : i - 1].outer()[0], pieces[i].outer()[0]);
        }
        most = std::max(most, pieces.size());
        if (testing::Test::HasFailure()) FAIL() << "seed " << seed;
    }
    EXPECT_GT(most, 50U);
}

TEST(CurveCutProperties, PiecesAreTheFacesThatGeosFinds) {
    const Geos geos;
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        const auto [shape, curves] = random_case(seed + 1000000);
        const Polygons pieces = cut_by_curves(shape[0], curves);
        std::vector<double> areas;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            if (area(pieces[i]) >= Geos::least_area) areas.push_back(area(pieces[i]));
        }
        std::sort(areas.begin(), areas.end());
        const std::vector<double> expected = geos.face_areas(shape[0], curves);
        EXPECT_EQ(areas.size(), expected.size());
        for (std::size_t i = 0; i < std::min(areas.size(), expected.size()); ++i) {
            EXPECT_NEAR(areas[i], expected[i], 1e-4) << "face " << i;
        }
        if (testing::Test::HasFailure()) FAIL() << "seed " << seed;
    }
}

TEST(CurveCutProperties, OrderAndDirectionDoNotMatter) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        auto [shape, curves] = random_case(seed + 2000000);
        const Polygons pieces = cut_by_curves(shape[0], curves);
        CaseRandom random(seed);
        std::reverse(curves.begin(), curves.end());
        for (Polyline& curve : curves) {
            if (random.coin()) std::reverse(curve.points.begin(), curve.points.end());
            if (curve.closed) std::rotate(curve.points.begin(), curve.points.begin() + 1, curve.points.end());
        }
        Polygons turned;
        for (std::size_t r = 0; r < shape[0].ring_count(); ++r) {
            const RingView ring = shape[0].ring(r == 0 ? 0 : shape[0].ring_count() - r);
            const std::size_t first = random.index(ring.size());
            for (std::size_t i = 0; i < ring.size(); ++i) turned.points.push_back(ring[(first + i) % ring.size()]);
            turned.end_ring();
        }
        turned.end_polygon();
        EXPECT_EQ(cut_by_curves(turned[0], curves), pieces);
        if (testing::Test::HasFailure()) FAIL() << "seed " << seed;
    }
}

// Neighbours that are cut by the same curves, each on its own, share the new vertices on their common border.
TEST(CurveCutProperties, NeighboursShareTheirVertices) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        const Polygons shape = random_case(seed + 3000000).shape;
        CaseRandom random(seed);
        const Box box = bounds(shape);
        const Vec centre = 0.5 * (to_px(box.min) + to_px(box.max));
        // Without loose ends, which may cut one half and not the other.
        std::vector<Polyline> curves;
        for (int i = random.whole(1, 8); i > 0; --i) {
            const Vec at = centre + turn({random.between(0, 80), 0}, random.between(0, 360));
            const Vec reach =
                turn({300, 0}, random.whole(0, 3) == 0 ? 90 * random.whole(0, 1) : random.between(0, 180));
            Polyline& curve = curves.emplace_back();
            curve.closed = random.coin();
            if (!curve.closed) curve.points = {at - reach, at, at + reach};
            for (int k = 0; curve.closed && k < 20; ++k) curve.points.push_back(at + 0.1 * turn(reach, 18 * k));
        }
        const Vec along = turn({300, 0}, random.between(0, 360));
        const Polygons halves =
            cut_by_curves(shape[0], std::vector<Polyline>{{{centre - along, centre + along}, false}});
        Polygons pieces;
        for (std::size_t i = 0; i < halves.size(); ++i) pieces.add_all(cut_by_curves(halves[i], curves));
        EXPECT_NEAR(area(pieces), area(shape), 1e-9 * area(shape));
        // A crossing within a grid unit of a corner or another crossing may differ.
        EXPECT_NEAR(unmatched_length(pieces), unmatched_length(halves), 1e-5);
        if (testing::Test::HasFailure()) FAIL() << "seed " << seed;
    }
}

// Cutting the pieces once more by the same curves changes nothing.
TEST(CurveCutProperties, CuttingTwiceIsCuttingOnce) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        const auto [shape, curves] = random_case(seed + 4000000);
        const Polygons pieces = cut_by_curves(shape[0], curves);
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            if (area(pieces[i]) < 1e-3) continue;
            double greatest = 0;
            const Polygons again = cut_by_curves(pieces[i], curves);
            for (std::size_t k = 0; k < again.size(); ++k) greatest = std::max(greatest, area(again[k]));
            EXPECT_NEAR(greatest, area(pieces[i]), 1e-4) << "piece " << i;
        }
        if (testing::Test::HasFailure()) FAIL() << "seed " << seed;
    }
}

}  // namespace
}  // namespace filigree
