#include "scene/arrange.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
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
const Style red_fill{red, {}, 1, Corner::round};

std::vector<Point> rectangle(double x, double y, double width, double height) {
    return {snap({x, y}), snap({x + width, y}), snap({x + width, y + height}), snap({x, y + height})};
}

void add_rectangle(Polygons& polygons, double x, double y, double width, double height) {
    polygons.add_ring(rectangle(x, y, width, height));
    polygons.end_polygon();
}

// A blob with a hole.
void add_blob(Polygons& polygons, CaseRandom& random, double largest = 30) {
    const Vec centre{random.between(-80, 80), random.between(-80, 80)};
    const double size = random.between(2, largest);
    for (const double side : {1.0, -1.0}) {
        std::vector<Point> ring;
        for (int i = 0; i < 12; ++i) {
            const elementary::CosSin to = elementary::cos_sin_degrees(side * 30 * i);
            const double radius = size * (side > 0 ? random.between(0.6, 1) : random.between(0.2, 0.5));
            ring.push_back(snap(centre + radius * Vec{to.cos, to.sin}));
        }
        polygons.add_ring(ring);
    }
    polygons.end_polygon();
}

// Groups in a random tree, with shapes and overlays in ranges as engines fill them: all shapes, then all overlays.
Drawing random_drawing(CaseRandom& random, std::uint64_t first_key) {
    Drawing drawing;
    for (std::uint32_t n = 1 + random.below(3); n > 0; --n) {
        Polygons polygons;
        for (std::uint32_t k = 1 + random.below(4); k > 0; --k) add_blob(polygons, random);
        drawing.geometry.push_back(std::make_shared<const Polygons>(std::move(polygons)));
    }
    for (std::uint32_t n = 1 + random.below(3); n > 0; --n) {
        drawing.styles.push_back(
            {random.coin() ? std::optional(red) : std::nullopt, ink, 0.5 * random.below(4), Corner::round});
    }
    const auto add_shapes = [&](std::uint32_t most) {
        for (std::uint32_t n = random.below(most + 1); n > 0; --n) {
            const std::uint32_t geometry = random.below(static_cast<std::uint32_t>(drawing.geometry.size()));
            const auto polygons = static_cast<std::uint32_t>(drawing.geometry[geometry]->size());
            const std::uint32_t style = random.below(static_cast<std::uint32_t>(drawing.styles.size()));
            drawing.shapes.push_back({geometry, random.below(polygons), style, Key{first_key + drawing.shapes.size()}});
        }
        return static_cast<std::uint32_t>(drawing.shapes.size());
    };
    drawing.groups.resize(1 + random.below(6));
    for (std::uint32_t g = 0; g < drawing.groups.size(); ++g) {
        DrawingGroup& group = drawing.groups[g];
        if (g > 0) {
            group.path = "g" + std::to_string(g);
            drawing.groups[random.below(g)].children.push_back(g);
        }
        group.first_shape = static_cast<std::uint32_t>(drawing.shapes.size());
        group.end_shape = add_shapes(3);
    }
    for (DrawingGroup& group : drawing.groups) {
        group.first_overlay = static_cast<std::uint32_t>(drawing.shapes.size());
        group.end_overlay = add_shapes(2);
    }
    return drawing;
}

// The first broken convention of drawing.h or polygon.h, or nothing.
std::string flaw_of(const Drawing& drawing) {
    std::vector<int> parents(drawing.groups.size()), owners(drawing.shapes.size());
    for (std::uint32_t g = 0; g < drawing.groups.size(); ++g) {
        const DrawingGroup& group = drawing.groups[g];
        for (const std::uint32_t child : group.children) {
            if (child <= g || child >= drawing.groups.size()) return "a child stands before its parent";
            ++parents[child];
        }
        if (group.first_shape > group.end_shape || group.first_overlay > group.end_overlay) return "a range runs back";
        if (std::max(group.end_shape, group.end_overlay) > drawing.shapes.size()) return "a range is too long";
        for (std::uint32_t s = group.first_shape; s < group.end_shape; ++s) ++owners[s];
        for (std::uint32_t s = group.first_overlay; s < group.end_overlay; ++s) ++owners[s];
        if (g > 0 && parents[g] != 1) return "a group has no parent, or several";
    }
    for (const int count : owners) {
        if (count != 1) return "a shape is in no group, or in several";
    }
    for (const DrawnShape& shape : drawing.shapes) {
        if (shape.geometry >= drawing.geometry.size() || shape.style >= drawing.styles.size()) return "an index is off";
        const Polygons& polygons = *drawing.geometry[shape.geometry];
        if (shape.polygon >= polygons.size()) return "a polygon is missing";
        if (const auto flaw = find_flaw(polygons[shape.polygon])) return *flaw;
    }
    return {};
}

// What is painted, in order: keys, and 0 where `group` has painted all its children.
std::vector<std::uint64_t> painted(const Drawing& drawing, std::uint32_t group) {
    std::vector<std::uint64_t> keys;
    const std::function<void(std::uint32_t)> paint = [&](std::uint32_t g) {
        const DrawingGroup& at = drawing.groups[g];
        for (std::uint32_t s = at.first_shape; s < at.end_shape; ++s) keys.push_back(drawing.shapes[s].key.value);
        for (const std::uint32_t child : at.children) paint(child);
        if (g == group) keys.push_back(0);
        for (std::uint32_t s = at.first_overlay; s < at.end_overlay; ++s) keys.push_back(drawing.shapes[s].key.value);
    };
    paint(0);
    return keys;
}

// The keys in the order of painting_steps.
std::vector<std::uint64_t> painted_by_steps(const Drawing& drawing) {
    std::vector<std::uint64_t> keys;
    for (const PaintStep& step : painting_steps(drawing)) {
        for (std::uint32_t s = step.first; s < step.end; ++s) keys.push_back(drawing.shapes[s].key.value);
    }
    return keys;
}

constexpr std::uint32_t no_group = UINT32_MAX;

Transform random_transform(CaseRandom& random) {
    const Transform turned =
        compose(rotation_degrees(random.between(0, 360)),
                scaling(random.between(0.05, 3) * (random.coin() ? 1 : -1), random.between(0.05, 3)));
    return compose(translation({random.between(-50, 50), random.between(-50, 50)}), turned);
}

Drawing drawing_of(Polygons polygons, const Style& style) {
    Drawing drawing;
    const auto count = static_cast<std::uint32_t>(polygons.size());
    for (std::uint32_t p = 0; p < count; ++p) drawing.shapes.push_back({0, p, 0, Key{p + 1}});
    drawing.styles = {style};
    drawing.geometry = {std::make_shared<const Polygons>(std::move(polygons))};
    drawing.groups = {{"start", 0, count, 0, 0, {}}};
    return drawing;
}

Drawing some_squares() {
    Polygons polygons;
    for (int i = 0; i < 4; ++i) add_rectangle(polygons, 20 * i, 0, 10, 10);
    return drawing_of(std::move(polygons), {red, ink, 2, Corner::round});
}

TEST(Arrange, ComesAsTheLastChildOfItsParent) {
    for (std::uint64_t n = 0; n < case_count(1000); ++n) {
        CaseRandom random(n);
        const Drawing before = random_drawing(random, 1000), from = random_drawing(random, 5000);
        Drawing to = before;
        Placement placement;
        placement.parent = random.below(static_cast<std::uint32_t>(to.groups.size()));
        placement.pen_scale = random.coin() ? 1 : 0.5;
        if (random.coin()) placement.transform = random_transform(random);
        if (random.coin()) placement.path_prefix = "motif/2";
        place_drawing(to, from, placement);
        ASSERT_EQ(flaw_of(to), "");
        ASSERT_EQ(to.shapes.size(), before.shapes.size() + from.shapes.size());

        std::vector<std::uint64_t> expected = painted(before, placement.parent);
        const std::vector<std::uint64_t> inner = painted(from, no_group);
        const auto gap = expected.erase(std::find(expected.begin(), expected.end(), 0U));
        expected.insert(gap, inner.begin(), inner.end());
        EXPECT_EQ(painted_by_steps(to), expected);
        EXPECT_EQ(painted(to, no_group), expected);

        // What was there is as it was, but for the one new child.
        for (std::uint32_t g = 0; g < before.groups.size(); ++g) {
            EXPECT_EQ(to.groups[g].path, before.groups[g].path);
            EXPECT_EQ(to.groups[g].children.size(), before.groups[g].children.size() + (g == placement.parent ? 1 : 0));
        }
        for (std::uint32_t g = 0; g < from.groups.size(); ++g) {
            const std::string& path = from.groups[g].path;
            const std::string prefixed = path.empty() ? "motif/2" : "motif/2/" + path;
            EXPECT_EQ(to.groups[before.groups.size() + g].path, placement.path_prefix.empty() ? path : prefixed);
        }
        for (std::size_t s = 0; s < from.shapes.size(); ++s) {
            Style style = from.styles[from.shapes[s].style];
            style.pen *= placement.pen_scale;
            EXPECT_EQ(to.styles[to.shapes[before.shapes.size() + s].style], style);
        }
        EXPECT_EQ(to.canvas, before.canvas);
    }
}

TEST(Arrange, GeometryIsSharedUnderTheIdentity) {
    const Drawing from = some_squares();
    Drawing to;
    to.canvas.background = red;
    for (int i = 0; i < 3; ++i) place_drawing(to, from, {});
    ASSERT_EQ(to.geometry.size(), 1U);
    EXPECT_EQ(to.geometry[0], from.geometry[0]);
    EXPECT_EQ(to.styles, from.styles);
    EXPECT_EQ(to.shapes.size(), 12U);
    EXPECT_EQ(to.groups.size(), 4U);
    EXPECT_EQ(to.groups[0].children, (std::vector<std::uint32_t>{1, 2, 3}));
    EXPECT_EQ(flaw_of(to), "");
}

TEST(Arrange, UnusedGeometryStaysBehind) {
    Drawing from = some_squares();
    from.geometry.insert(from.geometry.begin(), std::make_shared<const Polygons>());
    for (DrawnShape& shape : from.shapes) shape.geometry = 1;
    Drawing to;
    place_drawing(to, from, {});
    ASSERT_EQ(to.geometry.size(), 1U);
    EXPECT_EQ(to.geometry[0], from.geometry[1]);
}

TEST(Arrange, AreasFollowTheTransformAndMirrorsKeepOrientations) {
    for (std::uint64_t n = 0; n < case_count(500); ++n) {
        CaseRandom random(n);
        Polygons polygons;
        add_blob(polygons, random);
        const Drawing from = drawing_of(polygons, red_fill);
        Placement placement;
        placement.transform = random_transform(random);
        Drawing to;
        place_drawing(to, from, placement);
        ASSERT_EQ(flaw_of(to), "");
        ASSERT_EQ(to.shapes.size(), 1U);
        const PolygonView placed = (*to.geometry[0])[0];
        EXPECT_NEAR(area(placed), area(polygons[0]) * std::fabs(determinant(placement.transform)), 1e-4);
        ASSERT_EQ(placed.point_count(), polygons[0].point_count());
        const Vec mapped_centre = apply(placement.transform, centroid(polygons[0]));
        EXPECT_NEAR(length(centroid(placed) - mapped_centre), 0, 1e-5);
    }
}

TEST(Arrange, AShapeDrawnTwiceIsMappedOnce) {
    Drawing from = some_squares();
    from.groups[0].first_overlay = 4;
    from.groups[0].end_overlay = 6;
    from.shapes.push_back(from.shapes[1]);
    from.shapes.push_back(from.shapes[2]);
    Placement placement;
    placement.transform = scaling(2, 2);
    Drawing to;
    place_drawing(to, from, placement);
    ASSERT_EQ(to.geometry.size(), 1U);
    EXPECT_EQ(to.geometry[0]->size(), 4U);
    EXPECT_EQ(to.shapes[4].polygon, to.shapes[1].polygon);
    EXPECT_EQ(flaw_of(to), "");
}

TEST(Arrange, WhatCollapsesOrLeavesThePlaneIsDropped) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Transform transforms[] = {
        scaling(1e-12, 1e-12), scaling(1, 0), scaling(nan, 1), translation({2e9, 0}), {1, 1, 1, 1, 0, 0}};
    for (const Transform& transform : transforms) {
        Placement placement;
        placement.transform = transform;
        Drawing to;
        place_drawing(to, some_squares(), placement);
        EXPECT_TRUE(to.shapes.empty());
        EXPECT_TRUE(to.geometry.empty());
        EXPECT_EQ(flaw_of(to), "");
    }
    // A hole may collapse where its polygon stays, and a spike that has no width is taken back.
    Polygons polygons;
    polygons.add_ring(
        std::vector<Point>{{0, 0}, {1000, 0}, {1000, 499}, {9000, 500}, {1000, 501}, {1000, 1000}, {0, 1000}});
    polygons.add_ring(std::vector<Point>{{500, 500}, {500, 502}, {502, 502}, {502, 500}});
    polygons.end_polygon();
    Placement placement;
    placement.transform = scaling(0.01, 0.01);
    Drawing to;
    place_drawing(to, drawing_of(polygons, red_fill), placement);
    ASSERT_EQ(to.shapes.size(), 1U);
    const PolygonView placed = (*to.geometry[0])[0];
    EXPECT_EQ(placed.ring_count(), 1U);
    for (const Point p : placed.outer()) EXPECT_LE(p.x, 10);
}

// A spike may also lie where the ring closes.
TEST(Arrange, SpikesAreTakenBackWhereverARingStarts) {
    const std::vector<Point> ring{{0, 0}, {1000, 0}, {1000, 499}, {9000, 500}, {1000, 501}, {1000, 1000}, {0, 1000}};
    for (std::size_t first = 0; first < ring.size(); ++first) {
        std::vector<Point> turned = ring;
        std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(first), turned.end());
        Polygons polygons;
        polygons.add_ring(turned);
        polygons.end_polygon();
        Placement placement;
        placement.transform = scaling(0.01, -0.01);
        Drawing to;
        place_drawing(to, drawing_of(polygons, red_fill), placement);
        ASSERT_EQ(to.shapes.size(), 1U);
        const RingView placed = (*to.geometry[0])[0].outer();
        EXPECT_EQ(bounds(placed).max.x, 10);
        EXPECT_EQ(doubled_area(placed), 200);
        for (std::size_t i = 0; i < placed.size(); ++i) EXPECT_NE(placed[i], placed[(i + 1) % placed.size()]);
    }
}

TEST(Arrange, PensAreScaledAndEqualStylesJoined) {
    Drawing from = some_squares();
    from.styles = {{{}, ink, 2, Corner::round},
                   {{}, ink, 0.1, Corner::round},
                   {red, ink, 0, Corner::round},
                   {{}, ink, 2, Corner::round}};
    for (std::uint32_t s = 0; s < 4; ++s) from.shapes[s].style = s;
    Drawing to;
    to.styles = {{red, {}, 5, Corner::round}, {{}, ink, 1, Corner::round}};
    Placement placement;
    placement.pen_scale = 0.5;
    placement.least_pen = 0.25;
    place_drawing(to, from, placement);
    const std::vector<Style> expected{{red, {}, 5, Corner::round},
                                      {{}, ink, 1, Corner::round},
                                      {{}, ink, 0.25, Corner::round},
                                      {red, ink, 0, Corner::round}};
    EXPECT_EQ(to.styles, expected);
    EXPECT_EQ(to.shapes[0].style, 1U);
    EXPECT_EQ(to.shapes[3].style, 1U);
}

TEST(Arrange, ADrawingCanBePlacedIntoItself) {
    Drawing drawing = some_squares();
    Placement placement;
    placement.transform = translation({0, 20});
    for (int i = 0; i < 3; ++i) place_drawing(drawing, drawing, placement);
    EXPECT_EQ(drawing.shapes.size(), 32U);
    EXPECT_EQ(flaw_of(drawing), "");
}

TEST(Arrange, NothingComesOfNothing) {
    Drawing to = some_squares();
    place_drawing(to, Drawing{}, {});
    EXPECT_EQ(to.groups.size(), 1U);
    Drawing empty;
    empty.groups.resize(1);
    place_drawing(to, empty, {});
    EXPECT_EQ(to.groups.size(), 2U);
    EXPECT_EQ(flaw_of(to), "");
}

TEST(Arrange, ClipsCutEveryShape) {
    std::size_t kept = 0, cut = 0, dropped = 0;
    for (std::uint64_t n = 0; n < case_count(300); ++n) {
        CaseRandom random(n);
        Polygons clip;
        add_blob(clip, random, 200);
        if (random.coin()) {
            add_blob(clip, random, 200);
            clip = unite(clip, {});
        }
        Drawing from = random_drawing(random, 1);
        Placement placement;
        placement.clip = &clip;
        if (random.coin()) placement.transform = random_transform(random);
        Drawing moved, to;
        Placement unclipped = placement;
        unclipped.clip = nullptr;
        place_drawing(moved, from, unclipped);
        place_drawing(to, from, placement);
        ASSERT_EQ(flaw_of(to), "");
        for (std::size_t s = 0; s < moved.shapes.size(); ++s) {
            Polygons whole, pieces;
            whole.add((*moved.geometry[moved.shapes[s].geometry])[moved.shapes[s].polygon]);
            bool is_same = false;
            for (const DrawnShape& shape : to.shapes) {
                if (shape.key != moved.shapes[s].key) continue;
                EXPECT_EQ(to.styles[shape.style], moved.styles[moved.shapes[s].style]);
                pieces.add((*to.geometry[shape.geometry])[shape.polygon]);
                const bool is_shared = std::find(from.geometry.begin(), from.geometry.end(),
                                                 to.geometry[shape.geometry]) != from.geometry.end();
                is_same = is_same || is_shared;
            }
            const Polygons expected = intersect(whole, clip);
            EXPECT_NEAR(area(pieces), area(expected), 1e-9);
            EXPECT_EQ(bounds(pieces), bounds(expected));
            EXPECT_EQ(pieces.size(), expected.size());
            EXPECT_TRUE(!is_same || pieces == whole);
            kept += is_same ? 1 : 0;
            dropped += pieces.empty() ? 1 : 0;
            cut += !is_same && !pieces.empty() ? 1 : 0;
        }
    }
    EXPECT_GT(kept, 0U);
    EXPECT_GT(cut, 0U);
    EXPECT_GT(dropped, 0U);
}

TEST(Arrange, PiecesOfACutShapeShareItsKeyAndRange) {
    Polygons polygons;  // a U, and a square after it
    polygons.add_ring(std::vector<Point>{snap({0, 0}), snap({4, 0}), snap({4, 10}), snap({6, 10}), snap({6, 0}),
                                         snap({10, 0}), snap({10, 14}), snap({0, 14})});
    polygons.end_polygon();
    add_rectangle(polygons, 20, 0, 5, 5);
    const Drawing from = drawing_of(std::move(polygons), red_fill);
    Polygons clip;
    add_rectangle(clip, -1, -1, 50, 6);
    Placement placement;
    placement.clip = &clip;
    Drawing to;
    place_drawing(to, from, placement);
    ASSERT_EQ(to.shapes.size(), 3U);
    EXPECT_EQ(to.shapes[0].key, Key{1});
    EXPECT_EQ(to.shapes[1].key, Key{1});
    EXPECT_EQ(to.shapes[2].key, Key{2});
    EXPECT_EQ(to.groups[1].first_shape, 0U);
    EXPECT_EQ(to.groups[1].end_shape, 3U);
    const Polygons none;
    placement.clip = &none;
    place_drawing(to, from, placement);
    EXPECT_EQ(to.shapes.size(), 3U);
    EXPECT_EQ(flaw_of(to), "");
}

void expect_same(const Drawing& a, const Drawing& b) {
    EXPECT_EQ(a.canvas, b.canvas);
    EXPECT_EQ(a.styles, b.styles);
    ASSERT_EQ(a.geometry.size(), b.geometry.size());
    for (std::size_t g = 0; g < a.geometry.size(); ++g) EXPECT_EQ(*a.geometry[g], *b.geometry[g]);
    ASSERT_EQ(a.shapes.size(), b.shapes.size());
    for (std::size_t s = 0; s < a.shapes.size(); ++s) {
        EXPECT_EQ(a.shapes[s].geometry, b.shapes[s].geometry);
        EXPECT_EQ(a.shapes[s].polygon, b.shapes[s].polygon);
        EXPECT_EQ(a.shapes[s].style, b.shapes[s].style);
        EXPECT_EQ(a.shapes[s].key, b.shapes[s].key);
    }
    ASSERT_EQ(a.groups.size(), b.groups.size());
    for (std::size_t g = 0; g < a.groups.size(); ++g) {
        EXPECT_EQ(a.groups[g].path, b.groups[g].path);
        EXPECT_EQ(a.groups[g].first_shape, b.groups[g].first_shape);
        EXPECT_EQ(a.groups[g].end_shape, b.groups[g].end_shape);
        EXPECT_EQ(a.groups[g].first_overlay, b.groups[g].first_overlay);
        EXPECT_EQ(a.groups[g].end_overlay, b.groups[g].end_overlay);
        EXPECT_EQ(a.groups[g].children, b.groups[g].children);
    }
}

// Also where drawings come again, with geometry of others, or with what the growing one holds itself, and where
// that is added to in between.
TEST(Arrange, APlacerGivesWhatSinglePlacementsGive) {
    for (std::uint64_t n = 0; n < case_count(300); ++n) {
        CaseRandom random(n);
        Drawing one_by_one = random.coin() ? random_drawing(random, 1000) : Drawing{};
        Drawing together = one_by_one;
        DrawingPlacer placer(together);
        std::vector<Drawing> sources;
        for (std::uint64_t key = 5000; key < 8000; key += 1000) sources.push_back(random_drawing(random, key));
        sources[1].geometry.insert(sources[1].geometry.end(), sources[0].geometry.begin(), sources[0].geometry.end());
        for (DrawnShape& shape : sources[1].shapes) {
            if (random.coin()) continue;
            shape.geometry = static_cast<std::uint32_t>(sources[1].geometry.size() - 1);
            shape.polygon = 0;
        }
        Polygons clip;
        add_blob(clip, random, 200);
        for (int i = 0; i < 8; ++i) {
            if (random.below(4) == 0) {
                const auto geometry = sources[random.index(sources.size())].geometry.back();
                const Style style{red, {}, 0.25 * random.below(8), Corner::round};
                for (Drawing* drawing : {&one_by_one, &together}) {
                    drawing->geometry.push_back(geometry);
                    drawing->styles.push_back(style);
                }
            }
            Placement placement;
            if (random.coin()) placement.transform = random_transform(random);
            if (random.below(3) == 0) placement.clip = &clip;
            if (random.coin()) placement.path_prefix = "motif";
            if (random.coin()) placement.pen_scale = 0.5;
            if (!together.groups.empty()) {
                placement.parent = random.below(static_cast<std::uint32_t>(together.groups.size()));
            }
            if (i == 6) {
                place_drawing(one_by_one, one_by_one, placement);
                placer.place(together, placement);
                continue;
            }
            const Drawing& source = sources[random.index(sources.size())];
            place_drawing(one_by_one, source, placement);
            placer.place(source, placement);
        }
        ASSERT_EQ(flaw_of(together), "");
        expect_same(together, one_by_one);
        if (HasFailure()) return;
    }
}

// Four times as many take some four times as long, where they took sixteen times; the fastest of several runs
// count, as a machine may be busy.
TEST(Arrange, ManyPlacementsTakeWhatTheyAdd) {
    std::vector<Drawing> sources;
    for (int i = 0; i < 20000; ++i) {
        sources.push_back(some_squares());
        sources.back().styles[0].pen = i;
    }
    const auto seconds_of = [&](std::size_t count) {
        const auto begin = std::chrono::steady_clock::now();
        Drawing to;
        DrawingPlacer placer(to);
        for (std::size_t i = 0; i < count; ++i) placer.place(sources[i], {});
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
        EXPECT_EQ(to.geometry.size(), count);
        EXPECT_EQ(to.styles.size(), count);
        EXPECT_EQ(to.shapes.size(), 4 * count);
        return seconds.count();
    };
    double few = seconds_of(5000), many = seconds_of(20000);
    for (int run = 0; run < 4 && many > 10 * few; ++run) {
        few = std::min(few, seconds_of(5000));
        many = std::min(many, seconds_of(20000));
    }
    EXPECT_LT(many, 10 * few);
    RecordProperty("ratio", std::to_string(many / few));
}

TEST(Arrange, LinesStayOpenAndAreCutOff) {
    Drawing line;
    Polygons geometry;
    geometry.points = {snap({-5, 2}), snap({5, 2}), snap({5, 9}), snap({7, 9}), snap({7, 1})};
    geometry.end_ring();
    geometry.end_polygon();
    line.geometry = {std::make_shared<const Polygons>(geometry)};
    line.styles = {{{}, ink, 1, Corner::round, true}};
    line.shapes = {{0, 0, 0, Key{1}}};
    line.groups = {{"word", 0, 1, 0, 0, {}}};
    Polygons clip;
    add_rectangle(clip, 0, 0, 16, 16);
    Drawing all;
    place_drawing(all, line, {Transform{2, 0, 0, 2, 0, 0}, &clip, "", 0, 2, 0});
    ASSERT_EQ(all.shapes.size(), 2U);
    EXPECT_TRUE(all.styles[0].is_open);
    EXPECT_EQ(all.styles[0].pen, 2);
    const auto points = [&](std::size_t shape) {
        const RingView ring = polygon_of(all, all.shapes[shape]).outer();
        return std::vector<Point>(ring.begin(), ring.end());
    };
    EXPECT_EQ(points(0), (std::vector<Point>{snap({0, 4}), snap({10, 4}), snap({10, 16})}));
    EXPECT_EQ(points(1), (std::vector<Point>{snap({14, 16}), snap({14, 2})}));
    // A filled shape of the same look is another style.
    Drawing filled = line;
    filled.styles[0].is_open = false;
    place_drawing(all, filled, {});
    EXPECT_EQ(all.styles.size(), 2U);
}

}  // namespace
}  // namespace filigree
