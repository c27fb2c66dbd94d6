#include "plane/polygon.h"

#include <gtest/gtest.h>

#include <ctime>

#include "base/test_cases.h"
#include "plane/clean_test_oracle.h"

namespace filigree {
namespace {

using namespace oracle;

const Ring square{{0, 0}, {9, 0}, {9, 9}, {0, 9}};
const Ring small_hole{{3, 3}, {3, 6}, {6, 6}, {6, 3}};

Polygons polygon_of(const Rings& rings) {
    Polygons polygons;
    for (const Ring& ring : rings) polygons.add_ring(ring);
    polygons.end_polygon();
    return polygons;
}

TEST(Polygons, HoldRingsAndCopiesOfOthers) {
    Polygons one = polygon_of({square, small_hole});
    Polygons all;
    all.add_all(one);
    all.add(one[0]);
    all.add_all(all);
    ASSERT_EQ(all.size(), 4U);
    for (std::size_t i = 0; i < all.size(); ++i) {
        ASSERT_EQ(all[i].ring_count(), 2U);
        EXPECT_EQ(all[i].point_count(), 8U);
        EXPECT_TRUE(std::equal(all[i].ring(1).begin(), all[i].ring(1).end(), small_hole.begin(), small_hole.end()));
    }
    EXPECT_EQ(Polygons{}.size(), 0U);
    EXPECT_EQ(PolygonView{}.point_count(), 0U);
}

TEST(Polygons, Areas) {
    EXPECT_TRUE(doubled_area(square) == 162);
    EXPECT_TRUE(doubled_area(small_hole) == -18);
    EXPECT_TRUE(doubled_area(Ring{}) == 0);
    EXPECT_TRUE(doubled_area(Ring{{1, 1}, {5, 5}}) == 0);
    EXPECT_EQ(area(RingView(scaled(square))), 81.0);
    const Polygons polygons = polygon_of({scaled(square), scaled(small_hole)});
    EXPECT_EQ(area(polygons[0]), 72.0);
    Polygons two = polygons;
    two.add_all(polygons);
    EXPECT_EQ(area(two), 144.0);
    EXPECT_EQ(area(Polygons{}), 0.0);
}

TEST(Polygons, AreaIsExactAtTheEdgeOfThePlane) {
    const std::int64_t far = grid_limit;
    const Ring plane{{-far, -far}, {far, -far}, {far, far}, {-far, far}};
    EXPECT_TRUE(doubled_area(plane) == Int128{8} * far * far);
    EXPECT_EQ(area(RingView(plane)), 0x1p62);
    const Ring corner{{far - 1, far - 1}, {far, far - 1}, {far, far}};
    EXPECT_TRUE(doubled_area(corner) == 1);
    // Round the plane ten thousand times out and back in between: the sums on the way leave 128 bits.
    Ring often;
    for (int i = 0; i < 10000; ++i) often.insert(often.end(), plane.begin(), plane.end());
    for (int i = 0; i < 9999; ++i) often.insert(often.end(), {plane[0], plane[3], plane[2], plane[1]});
    EXPECT_TRUE(doubled_area(often) == Int128{8} * far * far);
    Polygons many;
    for (int i = 0; i < 5000; ++i) many.add_all(polygon_of({plane}));
    EXPECT_EQ(area(many), 5000 * 0x1p62);
}

TEST(Polygons, BoundsAndCentroid) {
    const Polygons polygons = polygon_of({scaled(square), scaled({{1, 1}, {1, 3}, {3, 3}, {3, 1}})});
    EXPECT_EQ(bounds(polygons), (Box{{0, 0}, {9 * px, 9 * px}}));
    EXPECT_TRUE(is_empty(bounds(Polygons{})));
    const Vec centre = centroid(polygons[0]);
    EXPECT_NEAR(centre.x, (81 * 4.5 - 4 * 2) / 77, 1e-12);
    EXPECT_NEAR(centre.y, (81 * 4.5 - 4 * 2) / 77, 1e-12);
    EXPECT_EQ(centroid(polygon_of({scaled({{0, 0}, {4, 4}, {2, 2}})})[0]), (Vec{2, 2}));
    EXPECT_EQ(centroid(PolygonView{}), Vec{});
    const std::int64_t far = grid_limit;
    const Vec there = centroid(polygon_of({{{far - 3 * px, far - 3 * px}, {far, far - 3 * px}, {far, far}}})[0]);
    EXPECT_NEAR(there.x, 0x1p30 - 1, 1e-6);
    EXPECT_NEAR(there.y, 0x1p30 - 2, 1e-6);
}

TEST(Locate, SquareWithAHole) {
    const Polygons polygons = polygon_of({square, small_hole});
    for (std::int64_t x = -1; x <= 10; ++x) {
        for (std::int64_t y = -1; y <= 10; ++y) {
            const std::int64_t outside = std::max(std::max(-x, x - 9), std::max(-y, y - 9));
            const std::int64_t in_hole = std::min(std::min(x - 3, 6 - x), std::min(y - 3, 6 - y));
            const int expected = outside > 0 || in_hole > 0 ? -1 : outside == 0 || in_hole == 0 ? 0 : 1;
            EXPECT_EQ(locate(polygons[0], {x, y}), expected) << x << ", " << y;
        }
    }
    EXPECT_EQ(locate(RingView(small_hole), {4, 4}), 1) << "orientation does not matter";
    EXPECT_EQ(locate(RingView{}, {0, 0}), -1);
    EXPECT_EQ(locate(PolygonView{}, {0, 0}), -1);
    EXPECT_EQ(locate(polygons[0], {INT64_MAX, 5}), -1);
    EXPECT_EQ(locate(polygons[0], {INT64_MIN, INT64_MIN}), -1);
}

TEST(Locate, AgreesWithARayTheOtherWay) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed);
        const std::int64_t step = random.unit() < 0.5 ? 1 : grid_limit / 8;
        const Ring ring = random_ring(random, random.whole(3, 12), 8, step);
        for (std::int64_t x = 0; x <= 8; ++x) {
            for (std::int64_t y = 0; y <= 8; ++y) {
                const Winding winding = winding_at({ring}, {x * step, y * step});
                bool on_edge = false;
                for (std::size_t i = 0; i < ring.size(); ++i) {
                    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
                    const std::int64_t ax = a.x / step - x, ay = a.y / step - y;
                    const std::int64_t bx = b.x / step - x, by = b.y / step - y;
                    on_edge |= ax * by == ay * bx && ax * bx + ay * by <= 0;
                }
                const int expected = on_edge ? 0 : winding.number % 2 != 0 ? 1 : -1;
                ASSERT_EQ(locate(RingView(ring), {x * step, y * step}), expected) << "seed " << seed;
            }
        }
    }
}

Ring rectangle(std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1, bool is_hole = false) {
    Ring ring{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
    if (is_hole) std::reverse(ring.begin(), ring.end());
    return ring;
}

TEST(NestRings, AnyDepth) {
    Rings rings;
    for (std::int64_t i = 0; i < 6; ++i) rings.push_back(rectangle(i, i, 20 - i, 20 - i, i % 2 == 1));
    const Polygons polygons = nest_rings(rings);
    ASSERT_EQ(polygons.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        ASSERT_EQ(polygons[i].ring_count(), 2U);
        EXPECT_EQ(polygons[i].outer()[0].x, static_cast<std::int64_t>(2 * i));
        EXPECT_EQ(bounds(polygons[i].ring(1)).min.x, static_cast<std::int64_t>(2 * i + 1));
    }
}

TEST(NestRings, DropsWhatHasNoPlace) {
    const Polygons polygons = nest_rings({rectangle(0, 0, 4, 4, true), {}, {{1, 1}}, {{0, 0}, {5, 5}, {2, 2}}});
    EXPECT_TRUE(polygons.empty());
    EXPECT_TRUE(nest_rings({}).empty());
}

TEST(NestRings, TouchingAtPoints) {
    // A hole that touches its outer in the outer's lowest point, and an outer that touches that hole there.
    const Ring outer{{0, 0}, {30, -30}, {60, 0}, {30, 30}};
    const Ring hole{{0, 0}, {20, 10}, {40, 0}, {20, -10}};
    const Ring inner{{0, 0}, {20, -5}, {30, 0}, {20, 5}};
    const Ring beside{{60, 0}, {70, -5}, {70, 5}};
    Rings rings{beside, inner, hole, outer};
    std::vector<std::size_t> order{0, 1, 2, 3};
    do {
        Rings shuffled;
        for (const std::size_t i : order) shuffled.push_back(rings[i]);
        const Polygons polygons = nest_rings(shuffled);
        ASSERT_EQ(polygons.size(), 3U);
        for (std::size_t i = 0; i < 3; ++i) {
            const bool is_outer = polygons[i].outer()[2] == Point{60, 0};
            EXPECT_EQ(polygons[i].ring_count(), is_outer ? 2U : 1U);
        }
    } while (std::next_permutation(order.begin(), order.end()));
}

TEST(NestRings, SharedEdges) {
    // A hole that another outer fills, and outers side by side with a hole each.
    const Polygons filled =
        nest_rings({rectangle(3, 3, 6, 6), rectangle(3, 3, 6, 6, true), rectangle(0, 0, 9, 9), rectangle(9, 0, 18, 9),
                    rectangle(9, 3, 12, 6, true), rectangle(3, 4, 4, 5, true)});
    ASSERT_EQ(filled.size(), 3U);
    EXPECT_EQ(filled[0].ring_count(), 2U);
    EXPECT_EQ(filled[0].ring(1)[0], (Point{3, 5}));
    EXPECT_EQ(filled[1].ring_count(), 2U);
    EXPECT_EQ(filled[1].ring(1)[0], (Point{3, 6}));
    EXPECT_EQ(filled[2].ring_count(), 2U);
}

struct Nest {
    Rings rings;
    std::vector<std::size_t> holders;  // of every ring, the outer that holds it
};
void fill(Nest& nest, CaseRandom& random, Box room, bool is_hole, std::size_t holder, int depth) {
    const std::int64_t columns = random.whole(1, 3), rows = random.whole(1, 3);
    const std::int64_t width = (room.max.x - room.min.x) / columns, height = (room.max.y - room.min.y) / rows;
    if (width < 8 || height < 8) return;
    for (std::int64_t i = 0; i < columns; ++i) {
        for (std::int64_t j = 0; j < rows; ++j) {
            if (random.unit() < 0.2) continue;
            const std::int64_t x0 = room.min.x + i * width, y0 = room.min.y + j * height;
            const Box box{{x0 + 1, y0 + 1}, {x0 + width - 1, y0 + height - 1}};
            const std::size_t index = nest.rings.size();
            // A diamond now and then: it touches its neighbours' corners and the walls.
            if (random.unit() < 0.3) {
                const Point middle{x0 + width / 2, y0 + height / 2};
                Ring diamond{{x0, middle.y}, {middle.x, y0}, {x0 + width, middle.y}, {middle.x, y0 + height}};
                if (is_hole) std::reverse(diamond.begin(), diamond.end());
                nest.rings.push_back(diamond);
                nest.holders.push_back(holder);
                continue;
            }
            nest.rings.push_back(rectangle(box.min.x, box.min.y, box.max.x, box.max.y, is_hole));
            nest.holders.push_back(holder);
            if (depth > 0) fill(nest, random, box, !is_hole, is_hole ? holder : index, depth - 1);
        }
    }
}

TEST(NestRings, RandomNests) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed);
        Nest nest;
        fill(nest, random, {{0, 0}, {1000, 1000}}, false, SIZE_MAX, 4);
        std::vector<std::size_t> order(nest.rings.size());
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
        for (std::size_t i = order.size(); i > 1; --i) {
            std::swap(order[i - 1], order[random.index(i)]);
        }
        Rings shuffled;
        Polygons expected;
        for (const std::size_t i : order) shuffled.push_back(nest.rings[i]);
        for (const std::size_t i : order) {
            if (doubled_area(nest.rings[i]) < 0) continue;
            expected.add_ring(nest.rings[i]);
            for (const std::size_t j : order) {
                if (nest.holders[j] == i && doubled_area(nest.rings[j]) < 0) expected.add_ring(nest.rings[j]);
            }
            expected.end_polygon();
        }
        ASSERT_EQ(nest_rings(shuffled), expected) << "seed " << seed;
    }
}

double seconds_for(const Rings& rings, std::size_t polygons) {
    const std::clock_t start = std::clock();
    EXPECT_EQ(nest_rings(rings).size(), polygons);
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

TEST(NestRings, ManyRingsInLittleTime) {
    Rings sieve{rectangle(0, 0, 1000, 1000)};  // holes side by side
    for (std::int64_t i = 0; i < 150; ++i) {
        for (std::int64_t j = 0; j < 150; ++j)
            sieve.push_back(rectangle(5 * i + 1, 5 * j + 1, 5 * i + 4, 5 * j + 4, true));
    }
    EXPECT_LT(seconds_for(sieve, 1), patience);
    Rings onion, angles;  // every box holds all smaller ones
    for (std::int64_t i = 0; i < 20000; ++i) onion.push_back(rectangle(i, i, 50000 - i, 50000 - i, i % 2 == 1));
    EXPECT_LT(seconds_for(onion, 10000), patience);
    for (std::int64_t i = 0; i < 20000; ++i) {
        const std::int64_t k = 10 * i + 10;
        angles.push_back(
            {{k, k}, {1000000 + k, k}, {1000000 + k, k + 4}, {k + 4, k + 4}, {k + 4, 1000000 + k}, {k, 1000000 + k}});
        angles.push_back({{k + 1, k + 3}, {k + 3, k + 3}, {k + 3, k + 1}, {k + 1, k + 1}});
    }
    EXPECT_LT(seconds_for(angles, 20000), patience);
}

}  // namespace
}  // namespace filigree
