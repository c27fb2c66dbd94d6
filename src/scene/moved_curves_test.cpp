// Curves stay those of their polygons, whatever is done to a drawing.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/elementary.h"
#include "base/test_cases.h"
#include "scene/arrange.h"
#include "scene/by_hand.h"
#include "scene/contact_sheet.h"
#include "scene/curves.h"
#include "scene/repeat.h"

namespace filigree {
namespace {

constexpr Colour ink{0, 0, 0, 255}, red{255, 0, 0, 255};
const Style filled{red, {}, 1, Corner::round}, stroked{{}, ink, 2, Corner::round};
constexpr double tolerance = 0.05;

void add(Path& path, Verb verb, std::initializer_list<Vec> points) {
    path.verbs.push_back(verb);
    path.points.insert(path.points.end(), points);
}

// A petal of all kinds of curves, closed.
Path random_petal(CaseRandom& random, Vec at, double size) {
    const double turn = random.between(0, 360);
    const auto place = [&](double x, double y) {
        return apply(compose(translation(at), compose(rotation_degrees(turn), scaling(size, size))), {x, y});
    };
    Path path;
    add(path, Verb::move, {place(-1, 0)});
    add(path, Verb::quadratic, {place(-0.5, random.between(-0.9, -0.1)), place(0, -0.5)});
    add(path, Verb::cubic, {place(0.2, -0.5), place(0.9, random.between(-0.5, -0.3)), place(1, 0)});
    add(path, Verb::arc, {size * Vec{1, random.between(0.5, 1)}, {turn + random.between(-30, 30), 2}, place(0, 1)});
    add(path, Verb::line, {place(-0.8, 0.4)});
    add(path, Verb::close, {});
    return path;
}

// Petals, filled, stroked or open, each a shape with a curve.
Drawing random_curves(CaseRandom& random, double reach, std::uint32_t count) {
    Drawing drawing;
    drawing.canvas = {{-reach, -reach}, {2 * reach, 2 * reach}, false, {}};
    for (std::uint64_t key = 1; key <= count; ++key) {
        const Vec at{random.between(-reach, reach), random.between(-reach, reach)};
        Path path = random_petal(random, at, random.between(reach / 20, reach / 3));
        const bool is_filled = random.coin();
        if (!is_filled && random.coin()) path.verbs.pop_back();
        add_curve(drawing, path, is_filled ? filled : stroked, Key{key}, tolerance);
    }
    drawing.groups = {{"start", 0, static_cast<std::uint32_t>(drawing.shapes.size()), 0, 0, {}}};
    return drawing;
}

double distance(Vec p, const std::vector<Vec>& line) {
    double nearest = 1e300;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Vec along = line[i + 1] - line[i];
        const double squared = dot(along, along);
        const double part = squared > 0 ? std::clamp(dot(p - line[i], along) / squared, 0.0, 1.0) : 0;
        nearest = std::min(nearest, length(p - line[i] - part * along));
    }
    return nearest;
}

// How far a shape's polygon and its curve lie from each other, at most.
double distance(const Drawing& drawing, const DrawnShape& shape) {
    const std::vector<Polyline> lines = flatten(drawing.curves[shape.curve], tolerance);
    const PolygonView polygon = polygon_of(drawing, shape);
    if (lines.size() != 1 || polygon.ring_count() != 1) return 1e300;
    std::vector<Vec> curve = lines[0].points, ring;
    if (lines[0].closed) curve.push_back(curve.front());
    for (const Point p : polygon.outer()) ring.push_back(to_px(p));
    if (!drawing.styles[shape.style].is_open) ring.push_back(ring.front());
    double farthest = 0;
    for (const Vec p : ring) farthest = std::max(farthest, distance(p, curve));
    for (const Vec p : curve) farthest = std::max(farthest, distance(p, ring));
    return farthest;
}

// Checks all shapes; how many have curves.
std::size_t checked_curves(const Drawing& drawing, double most, const std::string& what) {
    std::size_t count = 0;
    for (const DrawnShape& shape : drawing.shapes) {
        if (!has_curve(shape)) continue;
        EXPECT_LT(distance(drawing, shape), most) << what;
        ++count;
    }
    return count;
}

Transform random_transform(CaseRandom& random) {
    const double x = random.between(0.1, 5), y = random.coin() ? x : random.between(0.1, 5);
    return compose(translation({random.between(-99, 99), random.between(-99, 99)}),
                   compose(rotation_degrees(random.between(0, 360)), scaling(random.coin() ? x : -x, y)));
}

TEST(MovedCurves, PlacedOnesFollowTheirPolygons) {
    std::size_t kept = 0, cut = 0;
    for (std::uint64_t n = 0; n < case_count(60); ++n) {
        CaseRandom random(n);
        const Drawing from = random_curves(random, 100, 5);
        ASSERT_EQ(checked_curves(from, 2 * tolerance, "as added"), 5U) << n;
        Placement placement;
        if (random.coin()) placement.transform = random_transform(random);
        Drawing whole;
        place_drawing(whole, from, placement);
        EXPECT_EQ(checked_curves(whole, 12 * tolerance, "placed"), 5U) << n;
        if (placement.transform == Transform{}) {
            EXPECT_EQ(whole.curves, from.curves);
        }
        // What a clip cuts is polygons.
        Polygons clip;
        const double side = random.between(50, 300);
        clip.add_ring(std::vector<Point>{snap({0, 0}), snap({side, 0}), snap({side, side}), snap({0, side})});
        clip.end_polygon();
        placement.clip = &clip;
        Drawing clipped;
        place_drawing(clipped, from, placement);
        checked_curves(clipped, 12 * tolerance, "clipped");
        for (const DrawnShape& shape : clipped.shapes) {
            const Box box = bounds(polygon_of(whole, whole.shapes[shape.key.value - 1]));
            const bool is_inside = box.min.x > 0 && box.min.y > 0 && to_px(box.max).x < side && to_px(box.max).y < side;
            EXPECT_EQ(has_curve(shape), is_inside) << n;
            ++(is_inside ? kept : cut);
        }
    }
    EXPECT_GT(kept, 0U);
    EXPECT_GT(cut, 0U);
}

TEST(MovedCurves, ThoseThatWouldLeaveThePlaneAreDropped) {
    Drawing from;
    add_curve(from, {{Verb::move, Verb::quadratic}, {{0, 0}, {1e6, 2e6}, {2e6, 0}}}, stroked, Key{1}, 1e5);
    from.groups.resize(1);
    from.groups[0].end_shape = 1;
    Placement placement;
    placement.transform = {1, 0, 0, 900, 0, 0};  // so that only the control point leaves it
    Drawing to;
    place_drawing(to, from, placement);
    ASSERT_EQ(to.shapes.size(), 1U);
    EXPECT_FALSE(has_curve(to.shapes[0]));
    EXPECT_TRUE(to.curves.empty());
}

TEST(MovedCurves, ShapesOfOneCurveShareIt) {
    CaseRandom random(1);
    Drawing from = random_curves(random, 100, 2);
    from.shapes.push_back(from.shapes[0]);
    from.groups[0].end_shape = 3;
    Placement placement;
    placement.transform = scaling(2, 2);
    Drawing to;
    for (int i = 0; i < 2; ++i) place_drawing(to, from, placement);
    EXPECT_EQ(to.curves.size(), 4U);
    EXPECT_EQ(to.shapes[2].curve, to.shapes[0].curve);
    EXPECT_EQ(to.shapes[5].curve, 2U);
    checked_curves(to, 4 * tolerance, "shared");
}

TEST(MovedCurves, CopiesOfASymmetryFollowTheirPolygons) {
    for (const std::string_view name : {"p1", "p2", "pm", "pg", "cm", "p2mg", "p4g", "p31m", "p6m", "c5", "d6"}) {
        for (std::uint64_t n = 0; n < case_count(4); ++n) {
            CaseRandom random(n);
            SymmetryGroup group = *find_symmetry(name);
            const Point tile = is_rosette(group) ? Point{} : *fit_tile(group, {120, 120});
            const Symmetry symmetry(std::move(group), tile);
            const Drawing motif = random_curves(random, 50, 4);
            RepeatOptions options;
            options.canvas = {{-400, -400}, {800, 800}, false, {}};
            const Drawing all = *repeated(motif, symmetry, options);
            const std::string what = std::string(name) + " " + std::to_string(n);
            // Also the lines that are open: nothing is cut, so every shape has a curve.
            EXPECT_EQ(checked_curves(all, 2 * tolerance, what), all.shapes.size()) << what;
            EXPECT_GE(all.shapes.size(), 4 * symmetry.operation_count()) << what;
            const auto lines_of = [](const Drawing& drawing) {
                return std::count_if(drawing.shapes.begin(), drawing.shapes.end(),
                                     [&](const DrawnShape& shape) { return drawing.styles[shape.style].is_open; });
            };
            EXPECT_GE(lines_of(all), lines_of(motif) * symmetry.operation_count()) << what;
            // What is outside the canvas is no curve, either.
            options.canvas = {{-60, -60}, {120, 120}, false, {}};
            const Drawing some = *repeated(motif, symmetry, options);
            EXPECT_EQ(checked_curves(some, 2 * tolerance, what), some.shapes.size()) << what;
            EXPECT_EQ(some.curves.size(), some.shapes.size()) << what;
        }
    }
}

TEST(MovedCurves, OnAContactSheetTheyAreScaled) {
    CaseRandom random(5);
    Drawing drawing = random_curves(random, 50, 6);
    drawing.canvas = {{-200, -200}, {400, 400}, false, {}};
    const Drawing sheet = contact_sheet({{&drawing, ""}, {&drawing, ""}}, {});
    EXPECT_EQ(checked_curves(sheet, 2 * tolerance, "sheet"), 12U);
}

TEST(MovedCurves, WhatWaversIsPolygons) {
    Drawing drawing;
    std::vector<HandShape> shapes;
    for (std::uint32_t i = 0; i < 3; ++i) {
        const Path path = *parse_path_data("M" + std::to_string(100 * i) + " 0c40-20 40-20 80 0v60h-80Z");
        add_curve(drawing, path, filled, Key{i}, tolerance);
        const DrawnShape& shape = drawing.shapes.back();
        shapes.push_back({shape.geometry, shape.polygon, i, HandRole::face, {}});
    }
    drawing.groups = {{"start", 0, 3, 0, 0, {}}};
    Drawing still = drawing;
    draw_by_hand(still, shapes, 1);
    EXPECT_EQ(checked_curves(still, 2 * tolerance, "still"), 3U);
    shapes[1].style.wobble.amplitude = 2;
    draw_by_hand(drawing, shapes, 1);
    EXPECT_EQ(checked_curves(drawing, 2 * tolerance, "wavering"), 2U);
    EXPECT_FALSE(has_curve(drawing.shapes[1]));
}

}  // namespace
}  // namespace filigree
