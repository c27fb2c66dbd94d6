#include "scene/repeat.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/elementary.h"
#include "base/test_cases.h"
#include "plane/clean.h"
#include "plane/verify.h"

namespace filigree {
namespace {

constexpr Colour ink{0, 0, 0, 255}, red{255, 0, 0, 255};

Symmetry symmetry_of(std::string_view name, Vec tile) {
    SymmetryGroup group = *find_symmetry(name);
    const Point fitted = is_rosette(group) ? Point{} : *fit_tile(group, tile);
    return Symmetry(std::move(group), fitted);
}

Canvas tile_canvas(const Symmetry& symmetry) {
    const Vec size = to_px(symmetry.tile());
    return {-0.5 * size, size, false, {}};
}

// Each polygon a shape, in two groups.
Drawing drawing_of(Polygons polygons, const Style& style) {
    Drawing drawing;
    const auto count = static_cast<std::uint32_t>(polygons.size());
    for (std::uint32_t p = 0; p < count; ++p) drawing.shapes.push_back({0, p, 0, Key{p + 1}});
    drawing.styles = {style};
    drawing.geometry = {std::make_shared<const Polygons>(std::move(polygons))};
    drawing.groups = {{"", 0, count / 2, 0, 0, {1}}, {"big_poly/outline", count / 2, count, 0, 0, {}}};
    return drawing;
}

// Triangles or quadrangles that share their corners and cover a polygon of three or four corners; those on its sides
// are rounded to the grid beside them.
Polygons cut_finely(PolygonView domain, CaseRandom& random) {
    std::vector<Vec> corners;
    for (const Point p : domain.outer()) corners.push_back(to_px(p));
    if (corners.size() == 3) corners.push_back(corners[2]);
    const int n = random.whole(2, 6);
    std::vector<double> at{0};
    for (int i = 1; i < n; ++i) at.push_back((i + random.between(-0.3, 0.3)) / n);
    at.push_back(1);
    const auto corner = [&](std::size_t i, std::size_t j) {
        const Vec top = corners[0] + at[i] * (corners[1] - corners[0]);
        const Vec bottom = corners[3] + at[i] * (corners[2] - corners[3]);
        return snap(top + at[j] * (bottom - top));
    };
    Polygons pieces;
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
        for (std::size_t j = 0; j + 1 < at.size(); ++j) {
            std::vector<Point> ring{corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)};
            ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
            pieces.add_ring(ring);
            pieces.end_polygon();
        }
    }
    return pieces;
}

// The area of a drawing's shapes inside its canvas.
double area_inside(const Drawing& drawing) {
    Polygons canvas;
    const Vec low = drawing.canvas.origin, high = low + drawing.canvas.size;
    canvas.add_ring(std::vector<Point>{snap(low), snap({high.x, low.y}), snap(high), snap({low.x, high.y})});
    canvas.end_polygon();
    double sum = 0;
    for (const DrawnShape& shape : drawing.shapes) {
        Polygons one;
        one.add(polygon_of(drawing, shape));
        sum += area(intersect(one, canvas));
    }
    return sum;
}

Polygons all_polygons(const Drawing& drawing) {
    Polygons all;
    for (const DrawnShape& shape : drawing.shapes) all.add(polygon_of(drawing, shape));
    return all;
}

std::vector<std::string_view> wallpapers() {
    std::vector<std::string_view> names = wallpaper_names();
    for (const std::string_view turned : {"p11m", "p11g", "c11m", "pgm"}) names.push_back(turned);
    return names;
}

TEST(Repeat, ACutDomainCoversTheTileOnce) {
    for (const std::string_view name : wallpapers()) {
        for (std::uint64_t n = 0; n < case_count(6); ++n) {
            CaseRandom random(n);
            const Symmetry symmetry = symmetry_of(name, {random.between(60, 300), random.between(60, 300)});
            const Drawing motif = drawing_of(cut_finely(domain_of(symmetry, 0, 0.1)[0], random), {red, {}, 1, {}});
            RepeatOptions options;
            options.canvas = tile_canvas(symmetry);
            const Result<Drawing> drawing = repeated(motif, symmetry, options);
            ASSERT_TRUE(drawing) << name;
            const Vec size = options.canvas.size;
            EXPECT_NEAR(area_inside(*drawing) / (size.x * size.y), 1, 1e-9) << name;
            const Polygons all = all_polygons(*drawing);
            EXPECT_EQ(find_overlap(all), std::nullopt) << name;
            for (std::size_t i = 0; i < all.size(); ++i) ASSERT_EQ(find_flaw(all[i]), std::nullopt) << name;
        }
    }
}

// Each directed side that does not run back along another one.
std::vector<std::pair<Point, Point>> lonely_sides(const Drawing& drawing) {
    std::map<std::pair<Point, Point>, int> sides;
    for (const DrawnShape& shape : drawing.shapes) {
        const RingView ring = polygon_of(drawing, shape).outer();
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point a = ring[i], b = ring[(i + 1) % ring.size()];
            ++sides[{a, b}];
            --sides[{b, a}];
        }
    }
    std::vector<std::pair<Point, Point>> lonely;
    for (const auto& [side, count] : sides) {
        if (count > 0) lonely.push_back(side);
    }
    return lonely;
}

// Where all sides of the domain are mirrors, every side of a piece is one of its neighbour too, point by point.
TEST(Repeat, PiecesMeetTheirReflectionsExactly) {
    for (const std::string_view name : {"pmm", "p4m", "p3m1", "p6m"}) {
        for (std::uint64_t n = 0; n < case_count(10); ++n) {
            CaseRandom random(n);
            const Symmetry symmetry = symmetry_of(name, {random.between(60, 300), random.between(60, 300)});
            const Drawing motif = drawing_of(cut_finely(domain_of(symmetry, 0, 0.1)[0], random), {red, {}, 1, {}});
            RepeatOptions options;
            options.canvas = tile_canvas(symmetry);
            const Vec low = options.canvas.origin, high = low + options.canvas.size;
            for (const auto& [a, b] : lonely_sides(*repeated(motif, symmetry, options))) {
                // Beyond the canvas what would be beside it is left out.
                const Vec at = 0.5 * (to_px(a) + to_px(b));
                EXPECT_FALSE(low.x < at.x && at.x < high.x && low.y < at.y && at.y < high.y) << name;
            }
        }
    }
}

// The same for sectors of a rosette, but for their rims.
TEST(Repeat, SectorsMeetTheirReflectionsExactly) {
    for (std::uint32_t turns = 2; turns < 30; ++turns) {
        for (std::uint64_t n = 0; n < case_count(3); ++n) {
            CaseRandom random(n);
            const Symmetry symmetry = symmetry_of("d" + std::to_string(turns), {});
            const elementary::CosSin to = elementary::cos_sin_degrees(180.0 / turns - 90);
            const double radius = random.between(20, 300);
            Polygons sector;
            sector.add_ring(std::vector<Point>{{0, 0}, snap({0, -radius}), snap({radius * to.cos, radius * to.sin})});
            sector.end_polygon();
            const Polygons pieces = cut_finely(sector[0], random);
            const auto rim = static_cast<std::size_t>(std::lround(std::sqrt(pieces.size())));
            RepeatOptions options;
            options.canvas = {{-400, -400}, {800, 800}, false, {}};
            const Drawing drawing = *repeated(drawing_of(pieces, {red, {}, 1, {}}), symmetry, options);
            EXPECT_EQ(drawing.shapes.size(), 2 * turns * pieces.size());
            EXPECT_EQ(lonely_sides(drawing).size(), 2 * turns * rim) << turns;
        }
    }
}

// A motif of blobs with holes, larger than its place and across its borders.
Drawing random_motif(CaseRandom& random, double reach) {
    Polygons polygons;
    for (std::uint32_t count = 2 + random.below(4); count > 0; --count) {
        const Vec centre{random.between(-reach, reach), random.between(-reach, reach)};
        const double size = random.between(reach / 20, reach);
        for (const double side : {1.0, -1.0}) {
            std::vector<Point> ring;
            for (int i = 0; i < 9; ++i) {
                const elementary::CosSin to = elementary::cos_sin_degrees(side * 40 * i);
                const double radius = size * (side > 0 ? random.between(0.6, 1) : random.between(0.2, 0.4));
                ring.push_back(snap(centre + radius * Vec{to.cos, to.sin}));
            }
            polygons.add_ring(ring);
        }
        polygons.end_polygon();
    }
    Drawing drawing = drawing_of(std::move(polygons), {red, ink, random.between(0, 3), Corner::round});
    if (random.coin()) drawing.styles[0].stroke.reset();
    return drawing;
}

// What is seen at one side of a tile, in the order of painting and moved to its origin: points and keys.
using Seen = std::vector<std::vector<Point>>;
Seen seen_at(const Drawing& drawing, Point low, Point high) {
    Seen seen;
    for (const PaintStep& step : painting_steps(drawing)) {
        for (std::uint32_t s = step.first; s < step.end; ++s) {
            const PolygonView polygon = polygon_of(drawing, drawing.shapes[s]);
            const Box box = bounds(polygon);
            if (box.max.x <= low.x || high.x <= box.min.x || box.max.y <= low.y || high.y <= box.min.y) continue;
            std::vector<Point> points;
            for (std::size_t r = 0; r < polygon.ring_count(); ++r) {
                for (const Point p : polygon.ring(r)) points.push_back({p.x - low.x, p.y - low.y});
            }
            seen.push_back(std::move(points));
        }
    }
    return seen;
}

// What lies along the left edge of a tile is what would come behind its right edge, and in the same order.
TEST(Repeat, TilesAreSeamless) {
    std::vector<std::string_view> names = wallpapers();
    names.insert(names.end(), {"c1", "c5", "d3"});
    for (const std::string_view name : names) {
        for (std::uint64_t n = 0; n < case_count(20); ++n) {
            CaseRandom random(n);
            SymmetryGroup group = *find_symmetry(name);
            const bool is_ros = is_rosette(group);
            const Point tile = is_ros ? snap({random.between(30, 90), random.between(30, 90)})
                                      : *fit_tile(group, {random.between(30, 90), random.between(30, 90)});
            const Symmetry symmetry(std::move(group), tile);
            const Drawing motif = random_motif(random, random.between(5, 60));
            RepeatOptions options;
            options.canvas = tile_canvas(symmetry);
            options.canvas.origin = to_px(snap(options.canvas.origin));
            const Drawing drawing = *repeated(motif, symmetry, options);
            const Point low = snap(options.canvas.origin), high{low.x + tile.x, low.y + tile.y};
            // A strip one unit wide on each side of the edges: inside the one, and inside the other moved by a tile.
            EXPECT_EQ(seen_at(drawing, {low.x, low.y}, {low.x, high.y}).empty(),
                      seen_at(drawing, {high.x, low.y}, {high.x, high.y}).empty());
            EXPECT_EQ(seen_at(drawing, low, {low.x, high.y}), seen_at(drawing, {high.x, low.y}, high)) << name;
            EXPECT_EQ(seen_at(drawing, low, {high.x, low.y}), seen_at(drawing, {low.x, high.y}, high)) << name;
            // A larger canvas shows the same in each of its tiles.
            options.canvas.origin = to_px(Point{low.x - tile.x, low.y});
            options.canvas.size = {2 * options.canvas.size.x, options.canvas.size.y};
            const Drawing two = *repeated(motif, symmetry, options);
            const Seen left = seen_at(two, {low.x - tile.x, low.y}, {low.x, high.y});
            EXPECT_EQ(left, seen_at(two, low, high)) << name;
            EXPECT_EQ(left, seen_at(drawing, low, high)) << name;
        }
    }
}

TEST(Repeat, ASeamlessTileNeedsItsOrder) {
    // The test above is about order too: with two shapes exchanged, it fails.
    CaseRandom random(3);
    const Symmetry symmetry = symmetry_of("p2", {40, 40});
    RepeatOptions options;
    options.canvas = tile_canvas(symmetry);
    Drawing drawing = *repeated(random_motif(random, 60), symmetry, options);
    const Point low = snap(options.canvas.origin), high = snap(options.canvas.origin + options.canvas.size);
    const Seen before = seen_at(drawing, low, {low.x, high.y});
    ASSERT_GT(before.size(), 1U);
    std::reverse(drawing.groups[0].children.begin(), drawing.groups[0].children.end());
    EXPECT_NE(seen_at(drawing, low, {low.x, high.y}), before);
}

TEST(Repeat, KeysAreTheirOwnAndStay) {
    for (const std::string_view name : {"p1", "p4g", "p6m", "d5"}) {
        CaseRandom random(1);
        const Symmetry symmetry = symmetry_of(name, {60, 60});
        const Drawing motif = random_motif(random, 30);
        RepeatOptions options;
        std::map<std::uint64_t, std::vector<Point>> known;
        for (const double size : {180.0, 250.0, 400.0}) {
            options.canvas = {{-0.5 * size, -0.4 * size}, {size, size}, false, {}};
            const Drawing drawing = *repeated(motif, symmetry, options);
            std::set<std::uint64_t> keys;
            for (const DrawnShape& shape : drawing.shapes) {
                EXPECT_TRUE(keys.insert(shape.key.value).second) << name;
                const RingView ring = polygon_of(drawing, shape).outer();
                const auto [place, fresh] =
                    known.emplace(shape.key.value, std::vector<Point>(ring.begin(), ring.end()));
                if (!fresh) {
                    EXPECT_TRUE(std::equal(ring.begin(), ring.end(), place->second.begin(), place->second.end()));
                }
            }
            for (const DrawnShape& shape : motif.shapes) EXPECT_EQ(keys.count(shape.key.value), 1U) << name;
        }
    }
    EXPECT_EQ(key_of_copy(Key{5}, {}), Key{5});
    std::set<std::uint64_t> keys;
    for (std::uint32_t k = 0; k < 24; ++k) {
        for (int column = -4; column <= 4; ++column) {
            for (int row = -4; row <= 4; ++row) keys.insert(key_of_copy(Key{5}, {k, column, row}).value);
        }
    }
    EXPECT_EQ(keys.size(), 24U * 81U);
}

TEST(Repeat, GroupsStandBelowTheirCopies) {
    CaseRandom random(2);
    const Symmetry symmetry = symmetry_of("p2", {100, 100});
    Drawing motif = random_motif(random, 10);
    motif.groups[1].first_overlay = 0;
    RepeatOptions options;
    options.canvas = {{-100, -100}, {200, 200}, true, red};
    const Drawing drawing = *repeated(motif, symmetry, options);
    EXPECT_EQ(drawing.canvas, options.canvas);
    EXPECT_EQ(drawing.styles, motif.styles);
    std::set<std::string> paths;
    for (const std::uint32_t copy : drawing.groups[0].children) {
        const DrawingGroup& group = drawing.groups[copy];
        EXPECT_TRUE(paths.insert(group.path).second);
        ASSERT_EQ(group.children.size(), 1U);
        EXPECT_EQ(drawing.groups[group.children[0]].path, group.path + "/big_poly/outline");
    }
    EXPECT_EQ(paths.count("p2/0"), 1U);
    EXPECT_EQ(paths.count("p2/1/1,-1"), 1U);
    EXPECT_EQ(path_of_copy(symmetry, {1, 2, -3}), "p2/1/2,-3");
}

TEST(Repeat, TheMotifItselfSharesItsGeometry) {
    CaseRandom random(2);
    const Drawing motif = random_motif(random, 10);
    RepeatOptions options;
    options.canvas = {{-100, -100}, {200, 200}, false, {}};
    const Drawing drawing = *repeated(motif, symmetry_of("c3", {}), options);
    ASSERT_EQ(drawing.geometry.size(), 3U);
    EXPECT_EQ(drawing.geometry[0], motif.geometry[0]);
    EXPECT_EQ(drawing.shapes.size(), 3 * motif.shapes.size());
}

// Shapes outside the canvas are left out, but not where their pens reach into it.
TEST(Repeat, OnlyWhatIsSeenIsThere) {
    Polygons squares;
    for (const double x : {0.0, 20.0}) {
        squares.add_ring(std::vector<Point>{snap({x, 0}), snap({x + 10, 0}), snap({x + 10, 10}), snap({x, 10})});
        squares.end_polygon();
    }
    const Symmetry symmetry = symmetry_of("p1", {100, 100});
    const auto count_of = [&](const Style& style, Canvas canvas) {
        RepeatOptions options;
        options.canvas = canvas;
        return repeated(drawing_of(squares, style), symmetry, options)->shapes.size();
    };
    const Canvas canvas{{10, 0}, {10, 10}, false, {}};
    EXPECT_EQ(count_of({red, {}, 3, Corner::round}, canvas), 0U);
    EXPECT_EQ(count_of({red, ink, 3, Corner::round}, canvas), 2U);
    EXPECT_EQ(count_of({red, {}, 3, Corner::round}, {{9, 0}, {10, 10}, false, {}}), 1U);
    EXPECT_EQ(count_of({red, {}, 3, Corner::round}, {{0, 0}, {100, 100}, false, {}}), 2U);
    EXPECT_EQ(count_of({red, {}, 3, Corner::round}, {{5, 0}, {100, 100}, false, {}}), 3U);
    EXPECT_EQ(count_of({red, {}, 3, Corner::round}, {{-195, -95}, {300, 200}, false, {}}), 21U);
    EXPECT_EQ(count_of({red, {}, 3, Corner::round}, {{std::nan(""), 0}, {10, 10}, false, {}}), 0U);
    Polygons clip;
    clip.add_ring(std::vector<Point>{snap({5, 0}), snap({8, 0}), snap({8, 10}), snap({5, 10})});
    clip.end_polygon();
    RepeatOptions options;
    options.canvas = {{0, 0}, {100, 100}, false, {}};
    options.clip = &clip;
    const Drawing drawing = *repeated(drawing_of(squares, {red, {}, 1, Corner::round}), symmetry, options);
    ASSERT_EQ(drawing.shapes.size(), 1U);
    EXPECT_NEAR(area(polygon_of(drawing, drawing.shapes[0])), 30, 1e-6);
}

TEST(Repeat, LimitsAndCancelling) {
    CaseRandom random(2);
    const Drawing motif = random_motif(random, 10);
    const Symmetry symmetry = symmetry_of("p4m", {2, 2});
    RepeatOptions options;
    options.canvas = {{-500, -500}, {1000, 1000}, false, {}};
    Result<Drawing> drawing = repeated(motif, symmetry, options);
    ASSERT_FALSE(drawing);
    EXPECT_EQ(drawing.diagnostics()[0].code, "limit.copies");
    EXPECT_EQ(drawing.diagnostics()[0].fault, Fault::limit);
    options.canvas.size = {1e9, 1e9};
    EXPECT_FALSE(repeated(motif, symmetry, options));
    options.canvas.size = {20, 20};
    EXPECT_TRUE(repeated(motif, symmetry, options));
    options.most_shapes = 100;
    drawing = repeated(motif, symmetry, options);
    ASSERT_FALSE(drawing);
    EXPECT_EQ(drawing.diagnostics()[0].code, "limit.elements");
    const std::atomic<bool> cancelled = true;
    options.job.cancel_flag = &cancelled;
    drawing = repeated(motif, symmetry, options);
    ASSERT_FALSE(drawing);
    EXPECT_EQ(drawing.diagnostics()[0].code, "job.cancelled");
    EXPECT_TRUE(repeated(Drawing{}, symmetry, options)->shapes.empty());
}

TEST(Repeat, RosettesReachAsFarAsTheirCopies) {
    Polygons motif;
    motif.add_ring(std::vector<Point>{snap({1, -10}), snap({2, -10}), snap({2, -5})});
    motif.end_polygon();
    EXPECT_EQ(bounds_of_copies(symmetry_of("c1", {}), motif), bounds(motif));
    EXPECT_EQ(bounds_of_copies(symmetry_of("d1", {}), motif), (Box{snap({-2, -10}), snap({2, -5})}));
    EXPECT_EQ(bounds_of_copies(symmetry_of("c4", {}), motif), (Box{snap({-10, -10}), snap({10, 10})}));
    EXPECT_TRUE(is_empty(bounds_of_copies(symmetry_of("c4", {}), {})));
}

}  // namespace
}  // namespace filigree
