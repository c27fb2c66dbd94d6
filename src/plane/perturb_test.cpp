#include "plane/perturb.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/test_cases.h"
#include "plane/edge_tree.h"
#include "plane/test_rings.h"
#include "plane/verify.h"
#include "plane/weld.h"

namespace filigree {
namespace {

Ring rectangle(double x, double y, double width, double height) {
    return {snap({x, y}), snap({x + width, y}), snap({x + width, y + height}), snap({x, y + height})};
}
WobblyShapes all_with(Polygons polygons, Wobble wobble) {
    const std::size_t count = polygons.size();
    return {std::move(polygons), std::vector<Wobble>(count, wobble)};
}

// How far the farthest point of the one is from the border of the other.
double farthest(PolygonView from, PolygonView to) {
    const Point origin = to.outer()[0];
    const EdgeTree tree(edges_of(to, origin));
    double most = 0;
    for (std::size_t r = 0; r < from.ring_count(); ++r) {
        for (const Point p : from.ring(r)) most = std::max(most, tree.place(to_px(p, origin), 1e9, 1e9).distance);
    }
    return most;
}

// A square cut into parts again and again, each part on its own, so that borders have T-junctions.
struct Partition {
    Ring start;
    std::vector<Ring> parts;
};
Partition random_partition(CaseRandom& random, double thinnest) {
    Partition partition;
    partition.start = rectangle(random.between(-500, 500), random.between(-500, 500), random.between(50, 300),
                                random.between(50, 300));
    std::vector<std::pair<Ring, int>> waiting = {{partition.start, random.whole(1, 7)}};
    while (!waiting.empty()) {
        auto [ring, splits] = waiting.back();
        waiting.pop_back();
        if (splits == 0) {
            partition.parts.push_back(ring);
            continue;
        }
        std::size_t first = 0;
        const auto edge_length = [&](std::size_t i) {
            return length(to_px(ring[(i + 1) % ring.size()]) - to_px(ring[i]));
        };
        for (std::size_t i = 1; i < ring.size(); ++i) {
            if (edge_length(i) > edge_length(first)) first = i;
        }
        std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(first), ring.end());
        const std::size_t across = std::max<std::size_t>(1, ring.size() / 2);
        const auto place_on = [&](std::size_t i) {
            const Vec a = to_px(ring[i]), b = to_px(ring[(i + 1) % ring.size()]);
            return snap(a + random.between(thinnest, 1 - thinnest) * (b - a));
        };
        const Point p = place_on(0), q = place_on(across);
        Ring low = {p}, high = {q};
        low.insert(low.end(), ring.begin() + 1, ring.begin() + static_cast<std::ptrdiff_t>(across) + 1);
        low.push_back(q);
        high.insert(high.end(), ring.begin() + static_cast<std::ptrdiff_t>(across) + 1, ring.end());
        high.push_back(ring[0]);
        high.push_back(p);
        for (Ring* part : {&low, &high}) {
            part->erase(std::unique(part->begin(), part->end()), part->end());
            if (part->size() < 3 || area(*part) < 1e-6) return random_partition(random, thinnest);
        }
        waiting.push_back({low, splits - 1});
        waiting.push_back({high, splits - 1 - random.whole(0, splits > 1 ? 1 : 0)});
    }
    return partition;
}

using EdgeCounts = std::map<std::pair<Point, Point>, int>;
EdgeCounts count_edges(const Polygons& polygons) {
    EdgeCounts counts;
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        for (std::size_t r = 0; r < polygons[i].ring_count(); ++r) {
            const RingView ring = polygons[i].ring(r);
            for (std::size_t k = 0; k < ring.size(); ++k) ++counts[{ring[k], ring[(k + 1) % ring.size()]}];
        }
    }
    return counts;
}

void expect_partition(const Polygons& faces, const Polygons& outline) {
    for (std::size_t i = 0; i < faces.size(); ++i) ASSERT_EQ(find_flaw(faces[i]).value_or(""), "") << "face " << i;
    ASSERT_EQ(find_overlap(faces).value_or(""), "");
    ASSERT_NEAR(area(faces), area(outline), 1e-9 * area(outline));
    // Every edge has a face on its other side or is the outline's.
    const EdgeCounts rim = count_edges(outline), edges = count_edges(faces);
    std::size_t on_rim = 0;
    for (const auto& [edge, count] : edges) {
        ASSERT_EQ(count, 1);
        if (edges.contains({edge.second, edge.first})) continue;
        ASSERT_TRUE(rim.contains(edge));
        ++on_rim;
    }
    ASSERT_EQ(on_rim, rim.size());
}

TEST(Perturb, MovesNothingWithoutAmplitude) {
    const Polygons squares = polygons_of({rectangle(0, 0, 50, 50), rectangle(50, 20, 50, 50)});
    EXPECT_EQ(perturb({all_with(squares, {0, 60}), {}, {}, 1}).faces, weld(squares));
    EXPECT_EQ(perturb({all_with(squares, follows_neighbours), {}, {}, 1}).faces, weld(squares));
    EXPECT_EQ(perturb({}).faces, Polygons());
    PerturbInput marks;
    marks.marks = all_with(squares, {0, 60});
    EXPECT_EQ(perturb(marks).marks, squares);
}

TEST(Perturb, MovesByTheAmplitudeAndSoftensCorners) {
    for (const double amplitude : {0.5, 1.5, 3.0}) {
        const Polygons square = polygons_of({rectangle(10, 20, 200, 100)});
        const Perturbed moved = perturb({all_with(square, {amplitude, 60}), {}, {}, 5});
        const double most = std::max(farthest(moved.faces[0], square[0]), farthest(square[0], moved.faces[0]));
        EXPECT_GT(most, 0.3 * amplitude);
        EXPECT_LT(most, 2 * amplitude);
        EXPECT_GT(moved.faces.points.size(), 100U);
        const Perturbed other = perturb({all_with(square, {amplitude, 60}), {}, {}, 6});
        EXPECT_NE(moved.faces, other.faces);
        // A right angle is spread over three vertices.
        std::size_t sharp = 0;
        const RingView ring = moved.faces[0].outer();
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Vec at = to_px(ring[i]), before = at - to_px(ring[(i + ring.size() - 1) % ring.size()]),
                      after = to_px(ring[(i + 1) % ring.size()]) - at;
            if (dot(before, after) < 0.3 * length(before) * length(after)) ++sharp;
        }
        if (amplitude < 3) {
            EXPECT_EQ(sharp, 0U);
        }
    }
    const Polygons square = polygons_of({rectangle(0, 0, 100, 100)});
    EXPECT_EQ(perturb({all_with(square, {1000, 60}), {}, {}, 5}).faces,
              perturb({all_with(square, {3, 60}), {}, {}, 5}).faces)
        << "no more than a twentieth of the wavelength";
}

// The still square stays as it is, the other one's common border with it too, and the rest comes away gradually.
TEST(Perturb, LeastAmplitudeCounts) {
    PerturbInput input;
    input.faces.polygons = polygons_of({rectangle(0, 0, 100, 100), rectangle(100, 0, 100, 100)});
    input.faces.wobbles = {{0, 60}, {3, 60}};
    const Perturbed moved = perturb(input);
    EXPECT_EQ(moved.faces[0].point_count(), 4U);
    EXPECT_LT(farthest(moved.faces[0], input.faces.polygons[0]), 1e-9);
    EXPECT_GT(farthest(moved.faces[1], input.faces.polygons[1]), 0.5);
    for (const Point p : moved.faces[1].outer()) {
        const Vec at = to_px(p);
        const double off = std::min(std::fabs(at.y), std::fabs(at.y - 100)), from_border = at.x - 100;
        if (at.x < 190) {
            EXPECT_LE(off, 0.25 * std::max(from_border, 0.0) + 1e-6) << at.x;
        }
    }
    input.faces.wobbles[0] = follows_neighbours;
    EXPECT_GT(farthest(perturb(input).faces[0], input.faces.polygons[0]), 0.3);
}

TEST(Perturb, KeepsPartitions) {
    for (std::uint64_t seed = 0; seed < case_count(400); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        CaseRandom random(seed);
        const Partition partition = random_partition(random, random.coin() ? 0.2 : 0.01);
        PerturbInput input;
        input.faces.polygons = polygons_of(partition.parts);
        const Wobble common{random.between(0.1, 20), random.between(5, 100)};
        const int mood = random.whole(0, 2);
        for (std::size_t i = 0; i < partition.parts.size(); ++i) {
            Wobble own = common;
            if (mood == 1) own.amplitude = random.coin() ? 0 : random.between(0, 6);
            if (mood == 2) own = {random.between(0, 5), random.coin() ? 30.0 : 90.0};
            input.faces.wobbles.push_back(own);
        }
        input.borders = all_with(polygons_of({partition.start}), common);
        input.seed = seed;
        const Perturbed moved = perturb(input);
        expect_partition(moved.faces, moved.borders);
        if (HasFatalFailure()) return;

        // In another order: the same polygons.
        std::vector<std::size_t> order(partition.parts.size());
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
        for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.index(i)]);
        PerturbInput shuffled = input;
        Polygons expected;
        shuffled.faces = {};
        for (const std::size_t i : order) {
            shuffled.faces.polygons.add(input.faces.polygons[i]);
            shuffled.faces.wobbles.push_back(input.faces.wobbles[i]);
            expected.add(moved.faces[i]);
        }
        ASSERT_EQ(perturb(shuffled).faces, expected);
    }
}

// Strips far thinner than the noise moves them, beside each other, with rows of squares of another wavelength.
TEST(Perturb, UntanglesWhatIsThin) {
    for (const double width : {3.0, 0.1, 0.001}) {
        std::vector<Ring> rings;
        for (int i = 0; i < 60; ++i) rings.push_back(rectangle(0, i * width, 200, width));
        for (int i = 0; i < 40; ++i) rings.push_back(rectangle(i * 5.0, 60 * width, 5, 5));
        PerturbInput input{all_with(polygons_of(rings), {8, 12}), {}, {}, 3};
        for (std::size_t i = 60; i < rings.size(); ++i) input.faces.wobbles[i] = {4, 100};
        input.borders = all_with(polygons_of({rectangle(0, 0, 200, 60 * width + 5)}), {});
        const Perturbed moved = perturb(input);
        expect_partition(moved.faces, moved.borders);
        EXPECT_GT(farthest(moved.faces[30], input.faces.polygons[30]), 0.2) << width;
    }
}

// A hole and what lies in it keep their places in each other, however small and differently they move.
TEST(Perturb, KeepsHolesInside) {
    for (std::uint64_t seed = 0; seed < case_count(200); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        CaseRandom random(seed);
        PerturbInput input;
        input.faces.polygons.add_ring(rectangle(0, 0, 60, 60));
        std::vector<Ring> inner;
        const double size = random.between(0.01, 4), gap = random.between(0.01, 3);
        for (double x = gap; x + size < 60 && inner.size() < 30; x += size + gap) {
            inner.push_back(rectangle(x, gap, size, size));
        }
        for (const Ring& ring : inner) input.faces.polygons.add_ring(Ring(ring.rbegin(), ring.rend()));
        input.faces.polygons.end_polygon();
        input.faces.polygons.add_all(polygons_of(inner));
        for (std::size_t i = 0; i < input.faces.polygons.size(); ++i) {
            input.faces.wobbles.push_back({random.coin() ? 0 : 5.0, 60});
        }
        input.borders = all_with(polygons_of({rectangle(0, 0, 60, 60)}), {});
        const Perturbed moved = perturb(input);
        expect_partition(moved.faces, moved.borders);
        if (HasFatalFailure()) return;
    }
}

TEST(Perturb, MovesMarksWithoutMorePoints) {
    std::vector<Ring> rings;
    for (int i = 0; i < 400; ++i) rings.push_back(rectangle(i % 20 * 5, i / 20 * 5, 1, 1));
    PerturbInput input;
    input.marks = all_with(polygons_of(rings), {2, 40});
    const Perturbed moved = perturb(input);
    EXPECT_EQ(moved.marks.points.size(), 1600U);
    double most = 0;
    for (std::size_t i = 0; i < rings.size(); ++i) {
        ASSERT_EQ(find_flaw(moved.marks[i]).value_or(""), "");
        EXPECT_NEAR(area(moved.marks[i]), 1, 0.7);
        most = std::max(most, length(centroid(moved.marks[i]) - centroid(input.marks.polygons[i])));
    }
    EXPECT_GT(most, 0.6);
    EXPECT_LT(most, 2);
}

TEST(Perturb, StaysOnThePlane) {
    const double far = 0x1p30;
    const Polygons corner = polygons_of({rectangle(far - 100, far - 100, 100, 100), rectangle(-far, -far, 2, 2 * far)});
    const Perturbed moved = perturb({all_with(corner, {5, 60}), {}, {}, 1});
    for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(find_flaw(moved.faces[i]).value_or(""), "");
}

}  // namespace
}  // namespace filigree
