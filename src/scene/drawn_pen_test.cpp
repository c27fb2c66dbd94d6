#include "scene/drawn_pen.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/elementary.h"
#include "base/test_cases.h"
#include "plane/verify.h"
#include "plane/weld.h"

namespace filigree {
namespace {

using Ring = std::vector<Point>;

Ring points_of(const std::vector<Vec>& line) {
    Ring points;
    for (const Vec v : line) points.push_back(snap(v));
    return points;
}

// --- paths ------------------------------------------------------------------------------------------------------

Polygons squares(int columns, int rows) {
    Polygons all;
    for (int i = 0; i < columns; ++i) {
        for (int j = 0; j < rows; ++j) {
            const double x = i * 10, y = j * 10;
            all.add_ring(points_of({{x, y}, {x + 10, y}, {x + 10, y + 10}, {x, y + 10}}));
            all.end_polygon();
        }
    }
    return all;
}

std::vector<std::uint32_t> one_pen(const BorderMap& map) { return std::vector<std::uint32_t>(map.edges.size(), 0); }

// That each edge with a pen is on one path, which keeps its pen and goes from vertex to vertex.
void expect_whole(const BorderMap& map, const std::vector<std::uint32_t>& pens, const std::vector<PenPath>& paths) {
    std::multiset<std::uint32_t> used;
    for (const PenPath& path : paths) {
        ASSERT_EQ(path.vertices.size(), path.edges.size() + (path.is_closed ? 0 : 1));
        for (std::size_t i = 0; i < path.edges.size(); ++i) {
            const BorderMap::Edge& edge = map.edges[path.edges[i]];
            const std::uint32_t from = path.vertices[i], to = path.vertices[(i + 1) % path.vertices.size()];
            ASSERT_TRUE((edge.low == from && edge.high == to) || (edge.low == to && edge.high == from));
            ASSERT_EQ(pens[path.edges[i]], pens[path.edges[0]]);
            used.insert(path.edges[i]);
        }
    }
    std::size_t wanted = 0;
    for (std::uint32_t e = 0; e < pens.size(); ++e) {
        ASSERT_EQ(used.count(e), pens[e] == no_pen ? 0U : 1U);
        wanted += pens[e] == no_pen ? 0 : 1;
    }
    ASSERT_EQ(used.size(), wanted);
}

TEST(PenPaths, GoStraightThroughCrossings) {
    const BorderMap map = border_map(squares(4, 3));
    const std::vector<PenPath> paths = pen_paths(map, one_pen(map));
    expect_whole(map, one_pen(map), paths);
    EXPECT_EQ(paths.size(), 3U + 2 + 1) << "the lines between, and the rim";
    const auto rim = std::find_if(paths.begin(), paths.end(), [](const PenPath& path) { return path.is_closed; });
    ASSERT_TRUE(rim != paths.end());
    EXPECT_EQ(rim->edges.size(), 14U);
    EXPECT_EQ(map.vertices[rim->vertices[0]], (Point{0, 0})) << "at the first of the sharpest corners";
}

TEST(PenPaths, KeepTheirPens) {
    const BorderMap map = border_map(squares(4, 3));
    for (std::uint64_t seed = 0; seed < case_count(200); ++seed) {
        CaseRandom random(seed);
        std::vector<std::uint32_t> pens = one_pen(map);
        for (std::uint32_t& pen : pens) pen = random.below(4) == 0 ? no_pen : random.below(2);
        expect_whole(map, pens, pen_paths(map, pens));
        if (HasFatalFailure()) return;
    }
    EXPECT_TRUE(pen_paths(map, std::vector<std::uint32_t>(map.edges.size(), no_pen)).empty());
}

TEST(PenPaths, TakeRandomMaps) {
    for (std::uint64_t seed = 0; seed < case_count(200); ++seed) {
        CaseRandom random(seed);
        Polygons triangles;
        for (int i = random.whole(1, 40); i > 0; --i) {
            for (int k = 0; k < 3; ++k)
                triangles.points.push_back({random.whole(0, 9) << 26, random.whole(0, 9) << 26});
            triangles.end_ring();
            triangles.end_polygon();
        }
        const BorderMap map = border_map(weld(triangles));
        expect_whole(map, one_pen(map), pen_paths(map, one_pen(map)));
        if (HasFatalFailure()) return;
    }
}

// --- strokes ----------------------------------------------------------------------------------------------------

TEST(DrawnStroke, IsAboutAsWideAsItsPen) {
    double least = 1e9, most = 0;
    for (std::uint64_t key = 0; key < 50; ++key) {
        const Polygons stroke = drawn_stroke(points_of({{10, 10}, {210, 60}}), false, 2, Key{key});
        ASSERT_EQ(stroke.size(), 1U);
        ASSERT_EQ(find_flaw(stroke[0]).value_or(""), "");
        const double expected = 2 * length({200, 50});
        EXPECT_NEAR(area(stroke), expected, 0.2 * expected);
        const Box box = bounds(stroke);
        const double reach = length(to_px(box.max) - to_px(box.min));
        least = std::min(least, reach);
        most = std::max(most, reach);
    }
    EXPECT_GT(most - least, 1) << "some go farther than others";
    EXPECT_NE(drawn_stroke(points_of({{0, 0}, {90, 0}}), false, 2, Key{1}),
              drawn_stroke(points_of({{0, 0}, {90, 0}}), false, 2, Key{2}));
}

TEST(DrawnStroke, DoesNotQuiteClose) {
    std::vector<Vec> circle;
    for (int i = 0; i < 60; ++i) {
        const elementary::CosSin turn = elementary::cos_sin_degrees(6.0 * i);
        circle.push_back(40.0 * Vec{turn.cos, turn.sin});
    }
    std::size_t open = 0, closed = 0;
    for (std::uint64_t key = 0; key < 60; ++key) {
        const Polygons stroke = drawn_stroke(points_of(circle), true, 1.5, Key{key});
        ASSERT_EQ(stroke.size(), 1U);
        ASSERT_EQ(find_flaw(stroke[0]).value_or(""), "");
        ASSERT_NEAR(area(stroke), 1.5 * 2 * elementary::pi * 40, 60);
        ++(stroke[0].ring_count() == 1 ? open : closed);
    }
    EXPECT_GT(open, 5U);
    EXPECT_GT(closed, 5U);
}

TEST(DrawnStroke, IsCleanWhateverTheLine) {
    for (std::uint64_t seed = 0; seed < case_count(500); ++seed) {
        CaseRandom random(seed);
        Ring line;
        const double step = random.between(0.01, 30);
        Vec at{random.between(-1e6, 1e6), random.between(-1e6, 1e6)};
        for (int i = random.whole(1, 40); i > 0; --i) {
            line.push_back(snap(at));
            at = at + Vec{random.between(-step, step), random.between(-step, step)};
        }
        const bool is_closed = random.coin();
        const Polygons stroke = drawn_stroke(line, is_closed, random.between(0.05, 5), Key{seed});
        for (std::size_t i = 0; i < stroke.size(); ++i) {
            ASSERT_EQ(find_flaw(stroke[i]).value_or(""), "") << "seed " << seed;
        }
        ASSERT_EQ(stroke.empty(), line.size() < 2) << "seed " << seed;
    }
    EXPECT_TRUE(drawn_stroke({}, false, 1, Key{1}).empty());
    EXPECT_TRUE(drawn_stroke(Ring(5, Point{7, 7}), true, 1, Key{1}).empty());
    EXPECT_TRUE(drawn_stroke(Ring{{0, 0}, {1 << 27, 0}}, false, 0, Key{1}).empty());
}

}  // namespace
}  // namespace filigree
