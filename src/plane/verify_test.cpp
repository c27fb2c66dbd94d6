#include "plane/verify.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "base/test_cases.h"

namespace filigree {
namespace {

constexpr std::int64_t px = std::int64_t{1} << 26;
constexpr std::int64_t tolerance_units = 64;  // verify_tolerance on the grid

using Ring = std::vector<Point>;
using Rings = std::vector<Ring>;

Polygons polygons_of(const std::vector<Rings>& all) {
    Polygons polygons;
    for (const Rings& rings : all) {
        for (const Ring& ring : rings) polygons.add_ring(ring);
        polygons.end_polygon();
    }
    return polygons;
}
std::string flaw_of(const Rings& rings, double tolerance = verify_tolerance) {
    return find_flaw(polygons_of({rings})[0], tolerance).value_or("");
}
std::string overlap_of(const std::vector<Rings>& all, double tolerance = verify_tolerance) {
    return find_overlap(polygons_of(all), tolerance).value_or("");
}

Ring scaled(Ring ring, std::int64_t by = px) {
    for (Point& p : ring) p = {p.x * by, p.y * by};
    return ring;
}
Ring moved(Ring ring, Point by) {
    for (Point& p : ring) p = {p.x + by.x, p.y + by.y};
    return ring;
}
Ring reversed(Ring ring) {
    std::reverse(ring.begin(), ring.end());
    return ring;
}
Ring box(std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1) {
    return scaled({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
}
Ring hole(std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1) { return reversed(box(x0, y0, x1, y1)); }

testing::AssertionResult says(const std::string& text, const std::string& part) {
    if (text.find(part) != std::string::npos) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "'" << text << "' does not say '" << part << "'";
}

// A simple ring around the origin: points by angle, radii in [low, high] px.
Ring star(CaseRandom& random, std::size_t count, std::int64_t low, std::int64_t high) {
    Ring ring;
    const auto half = [](Point p) { return p.y > 0 || (p.y == 0 && p.x > 0) ? 0 : 1; };
    const auto before = [&](Point a, Point b) {
        return half(a) != half(b) ? half(a) < half(b) : cross({0, 0}, a, b) > 0;
    };
    const auto same_ray = [&](Point a, Point b) { return half(a) == half(b) && cross({0, 0}, a, b) == 0; };
    Ring rays = {{1000, 0}, {0, 1000}, {-1000, 0}, {0, -1000}};  // so that the origin lies inside
    while (rays.size() < count) {
        const Point ray{random.whole(-1000, 1000), random.whole(-1000, 1000)};
        if (ray != Point{}) rays.push_back(ray);
    }
    std::sort(rays.begin(), rays.end(), before);
    rays.erase(std::unique(rays.begin(), rays.end(), same_ray), rays.end());
    for (const Point ray : rays) {
        const double radius = static_cast<double>(random.whole(low * 1000, high * 1000)) / 1000;
        const Vec at{static_cast<double>(ray.x), static_cast<double>(ray.y)};
        ring.push_back(snap(at * (radius / length(at))));
    }
    return ring;
}

// A star with up to four star-shaped holes, far enough apart.
Rings random_polygon(CaseRandom& random) {
    Rings rings = {star(random, static_cast<std::size_t>(random.whole(8, 60)), 70, 100)};
    const std::int64_t holes = random.whole(0, 4);
    for (std::int64_t i = 0; i < holes; ++i) {
        const Ring round = star(random, static_cast<std::size_t>(random.whole(4, 20)), 4, 15);
        rings.push_back(reversed(moved(round, {(i % 2 == 0 ? 20 : -20) * px, (i < 2 ? 20 : -20) * px})));
    }
    return rings;
}

// Whether two edges cross between their ends.
bool crosses_itself(const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            const Point a = ring[i], b = ring[(i + 1) % ring.size()], c = ring[k], d = ring[(k + 1) % ring.size()];
            if (orientation(a, b, c) * orientation(a, b, d) < 0 && orientation(c, d, a) * orientation(c, d, b) < 0) {
                return true;
            }
        }
    }
    return false;
}

TEST(FindFlaw, PassesGoodPolygons) {
    EXPECT_EQ(flaw_of({box(0, 0, 9, 9)}), "");
    EXPECT_EQ(flaw_of({{{0, 0}, {9, 0}, {9, 9}, {0, 9}}}), "");  // far smaller than the tolerance
    EXPECT_EQ(flaw_of({{{0, 0}, {9, 0}, {9, 9}, {0, 9}}}, 0), "");
    EXPECT_EQ(flaw_of({box(0, 0, 9, 9), hole(1, 1, 4, 4), hole(5, 5, 8, 8)}), "");
    EXPECT_EQ(flaw_of({scaled({{0, 0}, {3, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 2}})}), "");  // straight corners
}

TEST(FindFlaw, AllowsTouching) {
    // A hole touches the outer ring: vertex on vertex, vertex on edge.
    EXPECT_EQ(flaw_of({box(0, 0, 9, 9), reversed(scaled({{0, 0}, {4, 1}, {1, 4}}))}), "");
    EXPECT_EQ(flaw_of({box(0, 0, 9, 9), reversed(scaled({{0, 5}, {4, 3}, {4, 7}}))}), "");
    EXPECT_EQ(flaw_of({box(0, 0, 9, 9), reversed(scaled({{0, 5}, {4, 3}, {9, 5}, {4, 7}}))}), "");  // cuts it in two
    // Holes touch each other.
    EXPECT_EQ(flaw_of({box(0, 0, 9, 9), hole(1, 1, 4, 4), hole(4, 4, 8, 8)}), "");
    EXPECT_EQ(flaw_of({box(0, 0, 9, 9), hole(1, 1, 4, 8), reversed(scaled({{4, 5}, {8, 2}, {8, 8}}))}), "");
    // A ring touches itself: at a vertex twice, and with a vertex on an edge.
    EXPECT_EQ(flaw_of({scaled({{0, 0}, {2, 0}, {2, 2}, {4, 2}, {4, 4}, {2, 4}, {2, 2}, {0, 2}})}), "");
    EXPECT_EQ(flaw_of({scaled({{0, 0}, {8, 0}, {8, 8}, {4, 0}, {0, 8}})}), "");
}

TEST(FindFlaw, NamesBrokenRings) {
    EXPECT_TRUE(says(find_flaw(PolygonView()).value_or(""), "no rings"));
    EXPECT_TRUE(says(flaw_of({{}}), "ring 0 has 0 points"));
    EXPECT_TRUE(says(flaw_of({{{0, 0}, {9, 9}}}), "ring 0 has 2 points"));
    EXPECT_TRUE(says(flaw_of({box(0, 0, 9, 9), {{0, 0}}}), "ring 1 has 1 point"));
    EXPECT_TRUE(says(flaw_of({{{0, 0}, {9, 0}, {9, 0}, {0, 9}}}), "repeats its point 1"));
    EXPECT_TRUE(says(flaw_of({{{0, 0}, {9, 0}, {0, 9}, {0, 0}}}), "repeats its point 3"));
    EXPECT_TRUE(says(flaw_of({{{0, 0}, {INT64_MAX, 0}, {0, 9}}}), "off the plane"));
    EXPECT_TRUE(says(flaw_of({{{0, 0}, {INT64_MIN, INT64_MIN}, {0, 9}}}), "off the plane"));
    EXPECT_TRUE(says(flaw_of({scaled({{0, 0}, {9, 0}, {5, 0}})}), "no area"));
    EXPECT_TRUE(says(flaw_of({hole(0, 0, 9, 9)}), "negative area"));
    EXPECT_TRUE(says(flaw_of({box(0, 0, 9, 9), box(1, 1, 4, 4)}), "ring 1, a hole, has positive area"));
}

TEST(FindFlaw, NamesCrossings) {
    EXPECT_TRUE(says(flaw_of({scaled({{0, 0}, {8, 0}, {8, 8}, {6, -1}})}), "ring 0 crosses itself"));
    EXPECT_TRUE(says(flaw_of({scaled({{0, 0}, {8, 8}, {8, 0}, {0, 9}})}), "ring 0"));  // a bow
    // The path crosses at a vertex: every pair of edges only touches.
    EXPECT_TRUE(
        says(flaw_of({scaled({{0, 0}, {2, 0}, {2, 2}, {4, 4}, {4, 2}, {2, 2}, {0, 2}})}), "ring 0 crosses itself"));
    // Twice around.
    EXPECT_TRUE(says(flaw_of({scaled({{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {8, 1}, {8, 8}, {1, 8}})}),
                     "ring 0 crosses itself"));
    EXPECT_TRUE(says(flaw_of({box(0, 0, 9, 9), hole(1, 1, 5, 5), hole(4, 4, 8, 8)}), "rings 1 and 2"));
    EXPECT_TRUE(says(flaw_of({box(0, 0, 9, 9), hole(1, 1, 5, 5), hole(1, 1, 5, 5)}), "ring"));  // twice the same
    EXPECT_TRUE(says(flaw_of({box(0, 0, 9, 9), hole(1, 1, 8, 8), hole(2, 2, 5, 5)}), "rings 1 and 2"));  // nested
    EXPECT_TRUE(says(flaw_of({box(0, 0, 9, 9), hole(7, 1, 12, 5)}), "ring 1, a hole, reaches outside"));
    EXPECT_TRUE(says(flaw_of({box(0, 0, 9, 9), hole(10, 1, 12, 5)}), "ring 1, a hole, reaches outside"));
    EXPECT_TRUE(says(flaw_of({box(0, 0, 9, 9), hole(-1, -1, 10, 10)}), "ring 1, a hole, reaches outside"));
    EXPECT_TRUE(says(flaw_of({box(0, 0, 9, 9), reversed(scaled({{1, 1}, {4, 1}, {4, 4}, {3, -0}}))}), "ring 1"));
}

TEST(FindFlaw, NamesRuns) {
    const std::string run = "a ring runs along itself or another ring";
    EXPECT_TRUE(says(flaw_of({box(0, 0, 9, 9), hole(0, 0, 9, 9)}), run));                          // nothing left
    EXPECT_TRUE(says(flaw_of({box(0, 0, 9, 9), hole(0, 2, 4, 6)}), run));                          // along the border
    EXPECT_TRUE(says(flaw_of({box(0, 0, 9, 9), hole(1, 1, 4, 4), hole(4, 2, 8, 3)}), run));        // along a hole
    EXPECT_TRUE(says(flaw_of({scaled({{0, 0}, {8, 0}, {8, 4}, {12, 4}, {8, 4}, {0, 8}})}), run));  // a spike
    // Two boxes joined by a corridor of no width.
    EXPECT_TRUE(
        says(flaw_of({scaled(
                 {{0, 0}, {4, 0}, {4, 2}, {8, 2}, {8, 0}, {12, 0}, {12, 4}, {8, 4}, {8, 2}, {4, 2}, {4, 4}, {0, 4}})}),
             run));
    // The tip of a needle may coincide for less than a thousandth of a pixel.
    EXPECT_EQ(
        flaw_of({{{0, 0}, {8 * px, 0}, {8 * px, 4 * px}, {8 * px + 50'000, 4 * px}, {8 * px, 4 * px}, {0, 8 * px}}}),
        "");
}

TEST(FindFlaw, ForgivesWhatRoundingDoes) {
    for (const std::int64_t off : {std::int64_t{1}, tolerance_units / 2}) {
        const Ring over = {{0, 0}, {8 * px, 0}, {8 * px, 8 * px}, {4 * px, -off}, {0, 8 * px}};
        EXPECT_EQ(flaw_of({over}), "") << off;
        EXPECT_NE(flaw_of({over}, 0), "") << off;
        const Ring pushed = reversed({{-off, 2 * px}, {4 * px, 2 * px}, {4 * px, 6 * px}, {-off, 6 * px}});
        EXPECT_EQ(flaw_of({box(0, 0, 9, 9), pushed}), "") << off;
        EXPECT_NE(flaw_of({box(0, 0, 9, 9), pushed}, 0), "") << off;
    }
    const Ring deep =
        reversed({{-2 * tolerance_units, 2 * px}, {4 * px, 2 * px}, {4 * px, 6 * px}, {-2 * tolerance_units, 6 * px}});
    EXPECT_NE(flaw_of({box(0, 0, 9, 9), deep}), "");
}

TEST(FindFlaw, PassesRandomPolygonsAndFindsEachMutation) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed);
        const Rings good = random_polygon(random);
        ASSERT_EQ(flaw_of(good), "") << "seed " << seed;

        const std::size_t r = random.index(good.size());
        Rings bad = good;
        bad[r] = reversed(bad[r]);
        ASSERT_NE(flaw_of(bad), "") << "turned ring, seed " << seed;

        bad = good;
        const std::size_t at = random.index(bad[r].size());
        bad[r].insert(bad[r].begin() + static_cast<std::ptrdiff_t>(at), bad[r][at]);
        ASSERT_TRUE(says(flaw_of(bad), "repeats")) << "repeated point, seed " << seed;

        bad = good;
        std::swap(bad[0][at % bad[0].size()], bad[0][random.index(bad[0].size())]);
        if (crosses_itself(bad[0])) {
            ASSERT_NE(flaw_of(bad), "") << "swapped points, seed " << seed;
        }

        // A vertex pulled through the other side of the ring.
        bad = good;
        const Point p = bad[0][at % bad[0].size()];
        bad[0][at % bad[0].size()] = {-2 * p.x, -2 * p.y};
        ASSERT_NE(flaw_of(bad), "") << "pulled vertex, seed " << seed;

        if (good.size() > 1) {
            bad = good;
            bad[1] = moved(bad[1], {random.whole(-1000, 1000) * px, 300 * px});
            ASSERT_TRUE(says(flaw_of(bad), "ring 1, a hole, reaches outside")) << "far hole, seed " << seed;
            // Across the outer ring, around one of its vertices.
            bad = good;
            bad[1] = moved(bad[1], {bad[0][0].x - 20 * px, bad[0][0].y - 20 * px});
            ASSERT_TRUE(says(flaw_of(bad), "ring 1")) << "hole across, seed " << seed;
        }
        if (good.size() > 2) {
            bad = good;
            bad[2] = moved(bad[2], {random.whole(35, 45) * px, random.whole(-5, 5) * px});
            ASSERT_NE(flaw_of(bad), "") << "holes over one another, seed " << seed;
        }
    }
}

TEST(FindOverlap, PassesNeighbours) {
    EXPECT_EQ(overlap_of({}), "");
    EXPECT_EQ(overlap_of({{box(0, 0, 9, 9)}}), "");
    EXPECT_EQ(overlap_of({{box(0, 0, 9, 9)}, {box(9, 0, 18, 9)}, {box(9, 9, 18, 18)}}), "");
    EXPECT_EQ(overlap_of({{box(0, 0, 9, 9)}, {box(9, -3, 18, 20)}}), "");                 // part of a border
    EXPECT_EQ(overlap_of({{box(0, 0, 9, 9), hole(2, 2, 6, 6)}, {box(2, 2, 6, 6)}}), "");  // fills a hole
    EXPECT_EQ(overlap_of({{box(0, 0, 9, 9), hole(2, 2, 6, 6)}, {box(3, 3, 4, 4)}}), "");
    EXPECT_EQ(overlap_of({{scaled({{0, 0}, {4, 0}, {2, 3}})}, {scaled({{2, 3}, {4, 6}, {0, 6}})}}), "");
}

TEST(FindOverlap, NamesThePair) {
    EXPECT_TRUE(
        says(overlap_of({{box(0, 0, 9, 9)}, {box(20, 0, 29, 9)}, {box(8, 8, 12, 12)}}), "polygons 0 and 2 overlap"));
    EXPECT_TRUE(says(overlap_of({{box(0, 0, 9, 9)}, {box(0, 0, 9, 9)}}), "polygons 0 and 1 overlap"));  // the same
    EXPECT_TRUE(says(overlap_of({{box(0, 0, 9, 9)}, {box(3, 3, 5, 5)}}), "polygons 0 and 1 overlap"));  // inside
    EXPECT_TRUE(says(overlap_of({{box(0, 0, 9, 9)}, {box(0, 0, 9, 5)}}), "polygons 0 and 1 overlap"));  // shared edges
    EXPECT_TRUE(
        says(overlap_of({{box(0, 0, 9, 9)}, {box(3, -3, 5, 12)}}), "polygons 0 and 1 overlap"));  // no vertex inside
    // Vertices on borders only: a square and the same turned by 45 degrees.
    EXPECT_TRUE(says(overlap_of({{box(0, 0, 8, 8)}, {scaled({{4, 0}, {8, 4}, {4, 8}, {0, 4}})}}), "overlap"));
    EXPECT_TRUE(says(overlap_of({{box(0, 0, 9, 9), hole(2, 2, 6, 6)}, {box(2, 2, 7, 6)}}), "polygons 0 and 1 overlap"));
    EXPECT_TRUE(says(overlap_of({{box(0, 0, 9, 9)}, {hole(3, 3, 5, 5)}}), "polygons 0 and 1 overlap"));  // turned round
}

TEST(FindOverlap, MeasuresDepth) {
    const std::int64_t limit = tolerance_units;
    for (const std::int64_t depth : {std::int64_t{1}, limit / 2, limit * 3 / 4}) {
        EXPECT_EQ(overlap_of({{box(0, 0, 9, 9)}, {moved(box(9, 0, 18, 9), {-depth, 0})}}), "") << depth;
        EXPECT_NE(overlap_of({{box(0, 0, 9, 9)}, {moved(box(9, 0, 18, 9), {-depth, 0})}}, 0), "") << depth;
    }
    for (const std::int64_t depth : {limit * 3 / 2, limit * 100}) {
        EXPECT_NE(overlap_of({{box(0, 0, 9, 9)}, {moved(box(9, 0, 18, 9), {-depth, 0})}}), "") << depth;
    }
}

TEST(FindOverlap, IgnoresWhatIsNoPolygon) {
    EXPECT_EQ(overlap_of({{}, {{}}, {{{0, 0}, {9, 9}}}, {box(0, 0, 9, 9)}}), "");
    EXPECT_TRUE(says(overlap_of({{{{0, 0}, {INT64_MAX, 0}, {0, INT64_MIN}}}}), "off the plane"));
    EXPECT_TRUE(says(overlap_of({{scaled({{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {9, 0}, {9, 9}, {0, 9}})}}),
                     "polygon 0 overlaps itself"));
}

// A partition into triangles of jittered quadrilaterals; then one vertex moved, one polygon doubled.
TEST(FindOverlap, PassesRandomPartitionsAndFindsEachMutation) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed);
        const std::int64_t n = random.whole(1, 12), cell = 10 * px;
        const std::size_t side = static_cast<std::size_t>(n) + 1;
        Ring lattice;
        for (std::int64_t y = 0; y <= n; ++y) {
            for (std::int64_t x = 0; x <= n; ++x) {
                lattice.push_back({x * cell + random.whole(-px, px), y * cell + random.whole(-px, px)});
            }
        }
        std::vector<Rings> good;
        for (std::size_t y = 0; y + 1 < side; ++y) {
            for (std::size_t x = 0; x + 1 < side; ++x) {
                const std::size_t i = y * side + x;
                const Point a = lattice[i], b = lattice[i + 1], c = lattice[i + side + 1], d = lattice[i + side];
                if (random.whole(0, 1) == 0) {
                    good.push_back({{a, b, c}});
                    good.push_back({{a, c, d}});
                } else {
                    good.push_back({{a, b, c, d}});
                }
            }
        }
        ASSERT_EQ(overlap_of(good), "") << "seed " << seed;

        std::vector<Rings> bad = good;
        bad.push_back(bad[random.index(bad.size())]);
        ASSERT_TRUE(says(overlap_of(bad), "overlap")) << "doubled, seed " << seed;

        if (n < 2) continue;
        // One polygon's corner moved outwards from its middle reaches into a neighbour, unless on the rim.
        bad = good;
        const std::size_t middle = good.size() / 2;
        for (Point& p : bad[middle][0]) {
            const Point about = bad[middle][0][0];
            if (p != about) p = {p.x + (p.x - about.x) / 2, p.y + (p.y - about.y) / 2};
        }
        Box all;
        for (const Point p : lattice) extend(all, p);
        const bool inside = std::all_of(bad[middle][0].begin(), bad[middle][0].end(), [&](Point p) {
            return p.x > all.min.x + 3 * px && p.x < all.max.x - 3 * px && p.y > all.min.y + 3 * px &&
                   p.y < all.max.y - 3 * px;
        });
        if (inside) {
            ASSERT_TRUE(says(overlap_of(bad), "overlap")) << "grown, seed " << seed;
        }
    }
}

}  // namespace
}  // namespace filigree
