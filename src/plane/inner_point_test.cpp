#include "plane/inner_point.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "plane/edge_tree.h"
#include "plane/level_cut_test_shapes.h"

namespace filigree {
namespace {

using namespace level_cut_shapes;

double clearance(PolygonView shape, Vec p) {
    double least = 1e300;
    for (std::size_t r = 0; r < shape.ring_count(); ++r) {
        const RingView ring = shape.ring(r);
        for (std::size_t i = 0; i < ring.size(); ++i) {
            least = std::min(least, squared_distance({to_px(ring[i]), to_px(ring[(i + 1) % ring.size()])}, p));
        }
    }
    return std::sqrt(least) * locate(shape, snap(p));
}

TEST(InnerPoint, IsTheCentreOfALargeCircle) {
    const Polygons square = polygon_of({{{0, 0}, {100, 0}, {100, 100}, {0, 100}}});
    EXPECT_GE(clearance(square[0], inner_point(square[0])), 49.5);
    const Polygons needle = polygon_of({{{0, 0}, {1000, 0}, {1000, 1}, {0, 1}}});
    EXPECT_GE(clearance(needle[0], inner_point(needle[0])), 0.495);
    // Of a U, whose centroid lies outside, in the thick foot.
    const Polygons u = polygon_of({{{0, 0}, {10, 0}, {10, 70}, {90, 70}, {90, 0}, {100, 0}, {100, 100}, {0, 100}}});
    EXPECT_GE(clearance(u[0], inner_point(u[0])), 14.85);
    EXPECT_EQ(inner_point({}), (Vec{0, 0}));
}

TEST(InnerPoint, SliversGiveAPointOfTheirs) {
    Polygons sliver;
    sliver.points = {{0, 0}, {std::int64_t{1} << 40, 1}, {std::int64_t{1} << 40, 2}};
    sliver.end_ring();
    sliver.end_polygon();
    for (const Vec p : {inner_point(sliver[0]), quick_inner_point(sliver[0])}) {
        EXPECT_LE(std::fabs(p.y), 2 / grid_per_px);
        EXPECT_GE(p.x, 0);
        EXPECT_LE(p.x, 0x1p14);
    }
}

TEST(InnerPoint, LiesAsDeepAsAnyPointOfAFineLattice) {
    for (std::uint64_t seed = 0; seed < case_count(200); ++seed) {
        CaseRandom random(seed);
        const Polygons shape =
            polygon_of(random.coin() ? wobbly_shape(random) : cell_shape(random, 6, 8, random.coin()));
        EXPECT_GT(clearance(shape[0], quick_inner_point(shape[0])), 0) << "seed " << seed;
        const double found = clearance(shape[0], inner_point(shape[0]));
        const Box box = bounds(shape);
        const Vec low = to_px(box.min), size = to_px(box.max) - low;
        double greatest = 0;
        for (int x = 1; x < 60; ++x) {
            for (int y = 1; y < 60; ++y) {
                greatest = std::max(greatest, clearance(shape[0], low + Vec{size.x * x / 60, size.y * y / 60}));
            }
        }
        EXPECT_GE(found * 1.0101, greatest) << "seed " << seed;
        // Where rings start does not matter.
        Polygons turned;
        for (std::size_t r = 0; r < shape[0].ring_count(); ++r) {
            std::vector<Point> ring(shape[0].ring(r).begin(), shape[0].ring(r).end());
            std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(random.index(ring.size())),
                        ring.end());
            turned.add_ring(ring);
        }
        turned.end_polygon();
        EXPECT_EQ(quick_inner_point(turned[0]), quick_inner_point(shape[0])) << "seed " << seed;
    }
}

}  // namespace
}  // namespace filigree
