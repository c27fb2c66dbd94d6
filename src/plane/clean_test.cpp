#include "plane/clean.h"

#include <gtest/gtest.h>

#include <ctime>
#include <limits>
#include <set>

#include "base/elementary.h"
#include "base/test_cases.h"
#include "plane/clean_test_oracle.h"
#include "plane/verify.h"

namespace filigree {
namespace {

using namespace oracle;

constexpr double units_per_px2 = 0x1p52;

Polygons clean_px(const Rings& rings, FillRule rule) {
    Rings on_grid;
    for (const Ring& ring : rings) on_grid.push_back(scaled(ring));
    return clean(on_grid, rule);
}

// Everything that clean.h promises of its output and that does not depend on the input.
std::string flaw_of(const Polygons& polygons) {
    const Rings rings = rings_of(polygons);
    if (has_crossing(rings)) return "rings cross or share an edge";
    Point last{INT64_MIN, INT64_MIN};
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        for (std::size_t r = 0; r < polygons[i].ring_count(); ++r) {
            const RingView ring = polygons[i].ring(r);
            if (std::set<Point>(ring.begin(), ring.end()).size() != ring.size()) return "a ring visits a point twice";
            if ((doubled_area(ring) > 0) != (r == 0)) return "a ring has the wrong orientation";
            for (std::size_t k = 0; k < ring.size(); ++k) {
                const Point a = ring[k], b = ring[(k + 1) % ring.size()], c = ring[(k + 2) % ring.size()];
                if (orientation(a, b, c) == 0) return "a point lies on a straight line";
                if (ring[k].y < ring[0].y || (ring[k].y == ring[0].y && ring[k].x < ring[0].x))
                    return "a ring starts low";
            }
            for (const Point p : ring) {
                if (r > 0 && locate(polygons[i].outer(), p) < 0) return "a hole lies outside";
            }
        }
        const Point first = polygons[i].outer()[0];
        if (first.y < last.y || (first.y == last.y && first.x < last.x)) return "polygons are out of order";
        last = first;
        if (const auto flaw = find_flaw(polygons[i])) return *flaw;
    }
    return find_overlap(polygons).value_or("");
}

long double perimeter(const Rings& rings) {
    long double sum = 0;
    for (const Ring& ring : rings) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point a = ring[i], b = ring[(i + 1) % ring.size()];
            sum += std::hypot(static_cast<long double>(b.x - a.x), static_cast<long double>(b.y - a.y));
        }
    }
    return sum;
}

// Rounding moves edges by less than a grid unit, so areas by less than the length of the boundary.
void expect_area(const Polygons& polygons, long double expected_units, long double boundary, const std::string& where) {
    Int128 doubled = 0;
    for (const Ring& ring : rings_of(polygons)) doubled += doubled_area(ring);
    const long double slack = boundary + 64 + expected_units * 1e-15L;
    EXPECT_NEAR(static_cast<double>(static_cast<long double>(doubled) / 2 - expected_units), 0,
                static_cast<double>(slack))
        << where;
}

TEST(Clean, BowTie) {
    const Rings bow_tie{{{0, 0}, {100, 100}, {100, 0}, {0, 100}}};
    for (const FillRule rule : {FillRule::nonzero, FillRule::even_odd}) {
        const Polygons polygons = clean_px(bow_tie, rule);
        ASSERT_EQ(polygons.size(), 2U);
        EXPECT_EQ(area(polygons), 5000.0);
        EXPECT_EQ(rings_of(polygons),
                  (Rings{scaled({{0, 0}, {50, 50}, {0, 100}}), scaled({{100, 0}, {100, 100}, {50, 50}})}));
        EXPECT_EQ(flaw_of(polygons), "");
    }
}

TEST(Clean, DuplicatedOutline) {
    const Ring square{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
    Ring reversed = square;
    std::reverse(reversed.begin(), reversed.end());
    EXPECT_EQ(rings_of(clean_px({square, square}, FillRule::nonzero)), Rings{scaled(square)});
    EXPECT_TRUE(clean_px({square, square}, FillRule::even_odd).empty());
    EXPECT_EQ(rings_of(clean_px({square, square, reversed}, FillRule::even_odd)), Rings{scaled(square)});
    EXPECT_TRUE(clean_px({square, reversed}, FillRule::nonzero).empty());
    EXPECT_EQ(rings_of(clean_px({reversed}, FillRule::nonzero)), Rings{scaled(square)});
    Ring twice = square;
    twice.insert(twice.end(), square.begin(), square.end());
    EXPECT_EQ(rings_of(clean_px({twice}, FillRule::nonzero)), Rings{scaled(square)});
    EXPECT_TRUE(clean_px({twice}, FillRule::even_odd).empty());
}

TEST(Clean, SpikesAndRepeatsAndStraightPoints) {
    const Ring square = scaled({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
    const Ring spiked{{0, 0},  {0, 0},  {5, 0},   {5, -7}, {5, 0}, {10, 0}, {10, 5}, {10, 5}, {20, 5}, {15, 5},
                      {10, 5}, {10, 9}, {10, 10}, {7, 10}, {7, 4}, {7, 10}, {0, 10}, {0, 3},  {0, 8},  {0, 0}};
    for (const FillRule rule : {FillRule::nonzero, FillRule::even_odd}) {
        EXPECT_EQ(rings_of(clean_px({spiked}, rule)), Rings{square});
    }
}

TEST(Clean, NothingLeft) {
    for (const FillRule rule : {FillRule::nonzero, FillRule::even_odd}) {
        EXPECT_TRUE(clean_px({}, rule).empty());
        EXPECT_TRUE(clean_px({{}, {{1, 1}}, {{1, 1}, {2, 2}}}, rule).empty());
        EXPECT_TRUE(clean_px({{{0, 0}, {9, 3}, {3, 1}, {6, 2}, {0, 0}, {-3, -1}}}, rule).empty());
        EXPECT_TRUE(clean_px({{{5, 5}, {5, 5}, {5, 5}, {5, 5}}}, rule).empty());
    }
}

TEST(Clean, Comb) {
    Ring comb;
    for (std::int64_t tooth = 0; tooth < 50; ++tooth) {
        comb.insert(comb.end(), {{4 * tooth, 0}, {4 * tooth + 2, 0}, {4 * tooth + 2, 100}, {4 * tooth + 4, 100}});
    }
    comb.insert(comb.end(), {{200, 110}, {0, 110}});
    const Polygons polygons = clean_px({comb}, FillRule::nonzero);
    EXPECT_EQ(area(polygons), 50 * 200 + 2000.0);
    EXPECT_EQ(flaw_of(polygons), "");
    // Every tooth crossed by one bar.
    const Ring bar{{-10, 40}, {300, 40}, {300, 60}, {-10, 60}};
    EXPECT_EQ(area(clean_px({comb, bar}, FillRule::nonzero)), 12000 + 310 * 20 - 50 * 2 * 20.0);
    const Polygons crossed = clean_px({comb, bar}, FillRule::even_odd);
    EXPECT_EQ(area(crossed), 12000 + 310 * 20 - 2 * 50 * 2 * 20.0);
    EXPECT_EQ(flaw_of(crossed), "");
}

TEST(Clean, HoleThatTouchesItsOuter) {
    const Ring outer{{0, 0}, {100, 0}, {100, 100}, {0, 100}};
    const Ring at_edge{{0, 50}, {30, 80}, {60, 50}, {30, 20}};
    const Ring at_corner{{0, 0}, {20, 40}, {40, 20}};
    const Ring shares_piece{{0, 20}, {30, 50}, {0, 80}};
    for (const FillRule rule : {FillRule::nonzero, FillRule::even_odd}) {
        Ring clockwise = at_edge;
        std::reverse(clockwise.begin(), clockwise.end());
        const Polygons touching = clean_px({outer, doubled_area(at_edge) < 0 ? at_edge : clockwise}, rule);
        ASSERT_EQ(touching.size(), 1U);
        EXPECT_EQ(touching[0].ring_count(), 2U);
        EXPECT_EQ(area(touching), 10000 - 1800.0);
        EXPECT_EQ(flaw_of(touching), "");
    }
    const Polygons corner = clean_px({outer, at_corner}, FillRule::even_odd);
    ASSERT_EQ(corner.size(), 1U);
    EXPECT_EQ(corner[0].ring_count(), 2U);
    EXPECT_EQ(area(corner), 10000 - 600.0);
    EXPECT_EQ(flaw_of(corner), "");
    const Polygons notched = clean_px({outer, shares_piece}, FillRule::even_odd);
    ASSERT_EQ(notched.size(), 1U);
    EXPECT_EQ(notched[0].ring_count(), 1U);
    EXPECT_EQ(area(notched), 10000 - 900.0);
    // A hole that touches itself and its outer at corners: three rings that meet.
    const Polygons pinched =
        clean_px({{{0, 0}, {90, 0}, {90, 90}, {0, 90}}, {{0, 0}, {30, 60}, {60, 60}, {30, 30}, {60, 60}, {60, 30}}},
                 FillRule::even_odd);
    EXPECT_EQ(flaw_of(pinched), "");
}

TEST(Clean, RingsThatMeetInOnePoint) {
    // Eight petals about the origin, outlines in one stroke; then with every other one wound the other way.
    for (const bool alternating : {false, true}) {
        Ring petals;
        const Ring around{{8, 0}, {6, 6}, {0, 8}, {-6, 6}, {-8, 0}, {-6, -6}, {0, -8}, {6, -6}};
        for (std::size_t i = 0; i < 8; ++i) {
            const Point a = around[i], b = {around[i].x + (around[(i + 1) % 8].x - around[i].x) / 2,
                                            around[i].y + (around[(i + 1) % 8].y - around[i].y) / 2};
            const bool turn = alternating && i % 2 == 1;
            petals.insert(petals.end(), {{0, 0}, turn ? b : a, turn ? a : b});
        }
        const Polygons polygons = clean_px({petals}, FillRule::nonzero);
        EXPECT_EQ(polygons.size(), 8U);
        EXPECT_EQ(flaw_of(polygons), "");
        Ring frame{{-20, -20}, {20, -20}, {20, 20}, {-20, 20}};
        const Polygons pierced = clean_px({frame, petals}, FillRule::even_odd);
        ASSERT_EQ(pierced.size(), 1U);
        EXPECT_EQ(pierced[0].ring_count(), 9U);
        EXPECT_EQ(flaw_of(pierced), "");
        EXPECT_EQ(area(pierced) + area(polygons), 1600.0);
    }
}

TEST(Clean, SpiralThatOverlapsItself) {
    Ring spiral;
    for (int i = 0; i < 720; ++i) {
        const elementary::CosSin turn = elementary::cos_sin_degrees(3 * i);
        const double radius = 50 + 0.05 * i;
        spiral.push_back(snap({radius * turn.cos, radius * turn.sin}));
    }
    const Polygons whole = clean(Rings{spiral}, FillRule::nonzero);
    EXPECT_EQ(whole.size(), 1U);
    expect_area(whole, area_nonzero({spiral}), perimeter(rings_of(whole)), "nonzero");
    EXPECT_EQ(flaw_of(whole), "");
    const Polygons stripes = clean(Rings{spiral}, FillRule::even_odd);
    expect_area(stripes, area_even_odd({spiral}), perimeter(rings_of(stripes)), "even-odd");
    EXPECT_EQ(flaw_of(stripes), "");
    EXPECT_GT(area(whole), area(stripes));
}

TEST(Clean, OutersInHolesAreTheirOwn) {
    const Polygons polygons = clean_px({{{0, 0}, {90, 0}, {90, 90}, {0, 90}},
                                        {{10, 10}, {80, 10}, {80, 80}, {10, 80}},
                                        {{20, 20}, {70, 20}, {70, 70}, {20, 70}},
                                        {{30, 30}, {60, 30}, {60, 60}, {30, 60}}},
                                       FillRule::even_odd);
    ASSERT_EQ(polygons.size(), 2U);
    EXPECT_EQ(polygons[0].ring_count(), 2U);
    EXPECT_EQ(polygons[1].ring_count(), 2U);
    EXPECT_EQ(area(polygons), 8100 - 4900 + 2500 - 900.0);
}

TEST(Clean, LeavesOutOutlinesOffThePlane) {
    const double infinite = std::numeric_limits<double>::infinity();
    const Polyline square{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, true};
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), infinite, -infinite, 0x1p31, -1e300}) {
        const std::vector<Polyline> outlines{
            {{{0, 0}, {50, bad}, {50, 0}}, true}, square, {{{bad, 0}, {5, 5}, {1, 0}}, false}};
        EXPECT_EQ(area(clean(outlines, FillRule::nonzero)), 100.0);
    }
    EXPECT_EQ(area(clean(std::vector<Polyline>{{square.points, false}}, FillRule::nonzero)), 100.0) << "open is closed";
    EXPECT_EQ(area(clean(Rings{{{0, 0}, {INT64_MAX, 5}, {3, INT64_MIN}}, scaled({{0, 0}, {2, 0}, {2, 2}})},
                         FillRule::nonzero)),
              2.0);
    const std::int64_t far = grid_limit;
    const Polygons crossed = clean(Rings{{{-far, -far}, {far, far}, {far, -far}, {-far, far}}}, FillRule::nonzero);
    EXPECT_EQ(area(crossed), 0x1p61);
    EXPECT_EQ(flaw_of(crossed), "");
}

struct Scale {
    const char* name;
    std::int64_t size, step;
};
// Wide and in general position; integer drawings, full of coincidences; and the grid itself.
constexpr Scale scales[] = {
    {"wide", 1000 * px, 1}, {"integers", 10, px},     {"few integers", 4, px},       {"units", 10, 1},
    {"small", 1000, 1},     {"quarters", 30, px / 4}, {"plane", 64, grid_limit / 64}};

TEST(Clean, RandomOutlines) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        const Scale& scale = scales[seed % std::size(scales)];
        CaseRandom random(seed);
        Rings rings;
        for (std::int64_t i = random.whole(1, 3); i > 0; --i) {
            rings.push_back(random_ring(random, random.whole(3, 12), scale.size, scale.step));
        }
        for (const FillRule rule : {FillRule::nonzero, FillRule::even_odd}) {
            const bool nonzero = rule == FillRule::nonzero;
            const std::string where =
                "seed " + std::to_string(seed) + " " + scale.name + (nonzero ? " nonzero" : " even-odd");
            const Polygons polygons = clean(rings, rule);
            ASSERT_EQ(flaw_of(polygons), "") << where;
            expect_area(polygons, nonzero ? area_nonzero(rings) : area_even_odd(rings), perimeter(rings_of(polygons)),
                        where);
            ASSERT_EQ(clean(rings_of(polygons), rule), polygons) << where;
            for (int i = 0; i < 8; ++i) {
                const Point p{random.whole(0, scale.size) * scale.step, random.whole(0, scale.size) * scale.step};
                const Winding winding = winding_at(rings, p);
                if (winding.distance < 3) continue;
                int found = -1;
                for (std::size_t k = 0; k < polygons.size(); ++k) found = std::max(found, locate(polygons[k], p));
                const bool expected = nonzero ? winding.number != 0 : winding.number % 2 != 0;
                ASSERT_EQ(found, expected ? 1 : -1) << where;
            }
            if (testing::Test::HasFailure()) return;
        }
    }
}

TEST(Clean, OrderAndStartsAndDirectionsDoNotMatter) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed);
        const Scale& scale = scales[seed % std::size(scales)];
        Rings rings;
        for (int i = 0; i < 3; ++i) rings.push_back(random_ring(random, random.whole(3, 9), scale.size, scale.step));
        Rings turned{rings[2], rings[0], rings[1]};
        for (Ring& ring : turned) {
            std::rotate(ring.begin(), ring.begin() + random.whole(0, static_cast<std::int64_t>(ring.size()) - 1),
                        ring.end());
        }
        ASSERT_EQ(clean(rings, FillRule::nonzero), clean(turned, FillRule::nonzero)) << "seed " << seed;
        std::reverse(turned[1].begin(), turned[1].end());
        ASSERT_EQ(clean(rings, FillRule::even_odd), clean(turned, FillRule::even_odd)) << "seed " << seed;
    }
}

TEST(Booleans, Squares) {
    const Polygons a = clean_px({{{0, 0}, {10, 0}, {10, 10}, {0, 10}}}, FillRule::nonzero);
    const Polygons b = clean_px({{{5, 5}, {15, 5}, {15, 15}, {5, 15}}}, FillRule::nonzero);
    EXPECT_EQ(area(unite(a, b)), 175.0);
    EXPECT_EQ(area(subtract(a, b)), 75.0);
    EXPECT_EQ(area(intersect(a, b)), 25.0);
    EXPECT_EQ(unite(a, {}), a);
    EXPECT_EQ(subtract(a, {}), a);
    EXPECT_TRUE(subtract({}, a).empty());
    EXPECT_TRUE(subtract(a, a).empty());
    EXPECT_EQ(intersect(a, a), a);
    EXPECT_TRUE(intersect(a, {}).empty());
    const Polygons inner = clean_px({{{2, 2}, {4, 2}, {4, 4}, {2, 4}}}, FillRule::nonzero);
    EXPECT_EQ(subtract(a, inner)[0].ring_count(), 2U);
    EXPECT_EQ(unite(subtract(a, inner), inner), a) << "what was cut out fits back";
}

TEST(Booleans, Laws) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed);
        const Scale& scale = scales[seed % std::size(scales)];
        const Polygons a =
            clean(Rings{random_ring(random, random.whole(3, 10), scale.size, scale.step)}, FillRule::even_odd);
        const Polygons b =
            clean(Rings{random_ring(random, random.whole(3, 10), scale.size, scale.step)}, FillRule::nonzero);
        const Polygons either = unite(a, b), both = intersect(a, b), rest = subtract(a, b);
        for (const Polygons* each : {&either, &both, &rest}) ASSERT_EQ(flaw_of(*each), "") << "seed " << seed;
        ASSERT_EQ(unite(b, a), either) << "seed " << seed;
        ASSERT_EQ(intersect(b, a), both) << "seed " << seed;
        Rings edges = rings_of(a);
        for (const Ring& ring : rings_of(b)) edges.push_back(ring);
        expect_area(either, static_cast<long double>((area(a) + area(b) - area(both)) * units_per_px2),
                    perimeter(edges), "union");
        expect_area(rest, static_cast<long double>((area(a) - area(both)) * units_per_px2), perimeter(edges),
                    "difference");
        if (testing::Test::HasFailure()) FAIL() << "seed " << seed << " " << scale.name;
    }
}

double seconds_for(const Rings& rings, FillRule rule) {
    const std::clock_t start = std::clock();
    EXPECT_FALSE(clean(rings, rule).empty());
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}
TEST(Clean, AMillionPoints) {
    Ring circle;
    for (int i = 0; i < 1000000; ++i) {
        const elementary::CosSin turn = elementary::cos_sin(2 * elementary::pi * i / 1000000);
        circle.push_back(snap({500 + 400 * turn.cos, 500 + 400 * turn.sin}));
    }
    const Rings rings{circle};
    const std::clock_t start = std::clock();
    const Polygons polygons = clean(rings, FillRule::nonzero);
    EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, patience);
    EXPECT_NEAR(area(polygons), elementary::pi * 160000, 1e-4);
}

TEST(Clean, ManyCopiesAndLongCombs) {
    Rings copies;
    CaseRandom random(7);
    const Ring ring = random_ring(random, 100, 1000, px);
    for (int i = 0; i < 1001; ++i) copies.push_back(ring);
    EXPECT_LT(seconds_for(copies, FillRule::even_odd), patience);
    Ring hatch;
    for (std::int64_t i = 0; i < 20000; ++i) hatch.insert(hatch.end(), {{10 * i, i}, {10 * i + 9, 1000000 + i}});
    EXPECT_LT(seconds_for({hatch}, FillRule::even_odd), patience);
}

}  // namespace
}  // namespace filigree
