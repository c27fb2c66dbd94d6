#include "plane/winding_check.h"

#include <gtest/gtest.h>

#include <vector>

#include "base/test_cases.h"

namespace filigree {
namespace {

using Ring = std::vector<Point>;

std::vector<DirectedEdge> edges_of(const std::vector<Ring>& rings) {
    std::vector<DirectedEdge> edges;
    for (const Ring& ring : rings) {
        for (std::size_t i = 0; i < ring.size(); ++i) edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
    }
    return edges;
}

// The turns around a place by quadrants: another way to the same number.
int winding_by_quadrants(const Ring& ring, Vec at) {
    const auto quadrant = [&](Point p) {
        const Vec d = to_px(p) - at;
        return d.x > 0 ? (d.y > 0 ? 0 : 3) : (d.y > 0 ? 1 : 2);
    };
    int quarters = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point a = ring[i], b = ring[(i + 1) % ring.size()];
        const int step = (quadrant(b) - quadrant(a) + 4) % 4;
        if (step == 1) quarters += 1;
        if (step == 3) quarters -= 1;
        if (step == 2) quarters += cross(to_px(a) - at, to_px(b) - at) > 0 ? 2 : -2;
    }
    return quarters / 4;
}

int winding_by_quadrants(const std::vector<Ring>& rings, Vec at) {
    int count = 0;
    for (const Ring& ring : rings) count += winding_by_quadrants(ring, at);
    return count;
}

TEST(Winding, CountsTurns) {
    const Ring twice = {{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {9, 0}, {9, 9}, {0, 9}};
    EXPECT_EQ(winding(twice, to_fine({4, 4})), 2);
    EXPECT_EQ(winding(twice, to_fine({-4, 4})), 0);
    EXPECT_EQ(winding(twice, to_fine({14, 4})), 0);
    const Ring reversed = {{0, 9}, {9, 9}, {9, 0}, {0, 0}};
    EXPECT_EQ(winding(reversed, {1, 1}), -1);
    EXPECT_EQ(winding(reversed, {-1, 1}), 0);
    EXPECT_EQ(winding({}, {0, 0}), 0);
}

TEST(Winding, PassesWhatIsEmpty) {
    EXPECT_FALSE(find_wrong_winding({}, {}));
    EXPECT_FALSE(find_wrong_winding(edges_of({{{5, 5}}}), {}));
    EXPECT_FALSE(find_wrong_winding(edges_of({{{5, 5}, {90, 90}}}), {}));
}

// A strip of wrong winding is found from the tolerance on, whatever its size and place.
TEST(Winding, MeasuresWidths) {
    for (const std::int64_t offset : {std::int64_t{0}, std::int64_t{1} << 40, -(std::int64_t{1} << 54)}) {
        for (const std::int64_t width : {std::int64_t{8}, std::int64_t{64}, std::int64_t{4096}}) {
            const std::int64_t o = offset, w = width, far = 100'000;
            const std::vector<Ring> strip = {{{o, o}, {o, o + w}, {o + far, o + w}, {o + far, o}}};
            const double px = static_cast<double>(width) / grid_per_px;
            EXPECT_TRUE(find_wrong_winding(edges_of(strip), {0, 1, px * 0.9, {}})) << offset << " " << width;
            EXPECT_FALSE(find_wrong_winding(edges_of(strip), {0, 1, px * 1.1, {}})) << offset << " " << width;
            EXPECT_FALSE(find_wrong_winding(edges_of(strip), {-1, 0, 0, {}}));
        }
    }
}

TEST(Winding, FindsRuns) {
    const std::int64_t px = std::int64_t{1} << 26;
    const std::vector<Ring> spike = {
        {{0, 0}, {4 * px, 0}, {4 * px, 2 * px}, {5 * px, 2 * px}, {4 * px, 2 * px}, {0, 4 * px}}};
    EXPECT_FALSE(find_wrong_winding(edges_of(spike), {0, 1, 0x1p-20, {}}));
    EXPECT_FALSE(find_wrong_winding(edges_of(spike), {0, 1, 0x1p-20, 1.01}));
    const auto flaw = find_wrong_winding(edges_of(spike), {0, 1, 0x1p-20, 0.99});
    ASSERT_TRUE(flaw);
    EXPECT_TRUE(flaw->is_run);
    EXPECT_EQ(to_px(flaw->at), (Vec{4.5, 2}));
}

TEST(Winding, TakesTheWholePlane) {
    const std::int64_t m = grid_limit;
    const std::vector<Ring> square = {{{-m, -m}, {m, -m}, {m, m}, {-m, m}}};
    EXPECT_FALSE(find_wrong_winding(edges_of(square), {}));
    EXPECT_TRUE(find_wrong_winding(edges_of(square), {0, 0, 0, {}}));
    EXPECT_TRUE(find_wrong_winding(edges_of({{{-m, -m}, {m, m}, {m, -m}, {-m, m}}}), {}));
    for (const double strange : {-1.0, 1e300, static_cast<double>(INFINITY), static_cast<double>(NAN)}) {
        EXPECT_FALSE(find_wrong_winding(edges_of(square), {0, 1, strange, {}}));
    }
}

// Random chains on a coarse lattice touch, cross and cover themselves in every way: what is reported must be
// wrong by another count, and where nothing is reported random places must be right.
TEST(Winding, AgreesWithCountingAtRandomPlaces) {
    std::uint64_t wrong = 0, right = 0;
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed);
        const std::int64_t unit = std::int64_t{1} << random.whole(22, 34);
        const std::int64_t lattice = random.whole(2, 12);
        std::vector<Ring> rings(static_cast<std::size_t>(random.whole(1, 3)));
        for (Ring& ring : rings) {
            ring.resize(static_cast<std::size_t>(random.whole(3, random.whole(3, 40))));
            for (Point& p : ring) p = {unit * random.whole(0, lattice), unit * random.whole(0, lattice)};
        }
        WindingRange range;
        range.least = random.whole(-3, 0);
        range.most = random.whole(0, 4);
        range.tolerance = 0x1p-20;
        const auto is_wrong = [&](Vec at) {
            const int count = winding_by_quadrants(rings, at);
            return count < range.least || count > range.most;
        };
        const auto flaw = find_wrong_winding(edges_of(rings), range);
        if (flaw) {
            ++wrong;
            int count = 0;
            for (const Ring& ring : rings) count += winding(ring, flaw->at);
            ASSERT_TRUE(count < range.least || count > range.most) << "seed " << seed;
            ASSERT_EQ(count, winding_by_quadrants(rings, to_px(flaw->at))) << "seed " << seed;
            continue;
        }
        ++right;
        for (int sample = 0; sample < 2000; ++sample) {
            const Point at{random.whole(0, 1 << 20), random.whole(0, 1 << 20)};
            const double scale = static_cast<double>(unit * lattice) / grid_per_px / (1 << 20);
            // Off the lattice's lines, where rounding could decide.
            const Vec place{(static_cast<double>(at.x) + 0.123456) * scale,
                            (static_cast<double>(at.y) + 0.654321) * scale};
            ASSERT_FALSE(is_wrong(place)) << "seed " << seed << " at " << place.x << " " << place.y;
        }
    }
    if (case_count() < 100) return;
    EXPECT_GT(wrong, case_count() / 10);
    EXPECT_GT(right, case_count() / 10);
}

// Whether there is a flaw does not depend on order, start or mirroring.
TEST(Winding, DoesNotDependOnOrder) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed);
        const std::int64_t unit = std::int64_t{1} << 24;
        Ring ring(static_cast<std::size_t>(random.whole(3, 30)));
        for (Point& p : ring) p = {unit * random.whole(0, 20), unit * random.whole(0, 20)};
        const WindingRange range{-2, 2, 0x1p-20, {}};
        const bool found = find_wrong_winding(edges_of({ring}), range).has_value();

        std::vector<DirectedEdge> shuffled = edges_of({ring});
        for (std::size_t i = shuffled.size(); i > 1; --i) {
            std::swap(shuffled[i - 1], shuffled[random.index(i)]);
        }
        EXPECT_EQ(find_wrong_winding(shuffled, range).has_value(), found) << "seed " << seed;
        for (DirectedEdge& edge : shuffled) edge = {{-edge.from.x, edge.from.y}, {-edge.to.x, edge.to.y}};
        EXPECT_EQ(find_wrong_winding(shuffled, range).has_value(), found) << "seed " << seed;
    }
}

}  // namespace
}  // namespace filigree
