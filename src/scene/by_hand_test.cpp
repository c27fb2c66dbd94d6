#include "scene/by_hand.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <set>

#include "plane/verify.h"

namespace filigree {
namespace {

constexpr Colour ink{0, 0, 0, 255};
constexpr Colour paper{255, 255, 255, 255};
constexpr Colour red{255, 0, 0, 255};

// Two squares side by side, each in a group of its own, and the border of both over them.
struct Page {
    Drawing drawing;
    std::vector<HandShape> shapes;

    Page() {
        auto geometry = std::make_shared<Polygons>();
        const auto add = [&](double x, double width) {
            geometry->add_ring(
                std::vector<Point>{snap({x, 0}), snap({x + width, 0}), snap({x + width, 50}), snap({x, 50})});
            geometry->end_polygon();
        };
        add(0, 50);
        add(50, 50);
        add(0, 100);
        drawing.geometry = {geometry};
        drawing.styles = {{paper, ink, 1, Corner::round}, {{}, red, 3, Corner::round}};
        drawing.groups.resize(3);
        drawing.groups[0].children = {1, 2};
        for (std::uint32_t i = 0; i < 2; ++i) {
            drawing.groups[i + 1].first_shape = i;
            drawing.groups[i + 1].end_shape = i + 1;
            drawing.groups[i + 1].first_overlay = drawing.groups[i + 1].end_overlay = 2;
            drawing.shapes.push_back({0, i, 0, Key{i + 1}});
            shapes.push_back({0, i, i, HandRole::face, {}});
        }
        drawing.groups[0].first_overlay = 2;
        drawing.groups[0].end_overlay = 3;
        drawing.shapes.push_back({0, 2, 1, Key{3}});
        shapes.push_back({0, 2, 2, HandRole::border, {}});
    }

    Page& with(std::size_t shape, HandStyle style) {
        shapes[shape].style = style;
        return *this;
    }
    const Drawing& drawn(std::uint64_t seed = 1) {
        draw_by_hand(drawing, shapes, seed);
        return drawing;
    }
};

// The strokes among what is painted, as shapes without the keys of the page.
std::vector<DrawnShape> strokes_of(const Drawing& drawing) {
    std::vector<DrawnShape> strokes;
    for (const DrawnShape& shape : drawing.shapes) {
        if (shape.key.value > 3) strokes.push_back(shape);
    }
    return strokes;
}

TEST(ByHand, PlainStylesChangeNothing) {
    Page page;
    const Page before = page;
    page.drawn();
    EXPECT_EQ(page.drawing.geometry, before.drawing.geometry);
    EXPECT_EQ(page.drawing.styles, before.drawing.styles);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(page.drawing.shapes[i].geometry, 0U);
}

TEST(ByHand, BordersFollowWhatTheyBorder) {
    Page page;
    const Drawing& drawing = page.with(0, {{1.5, 60}, false}).with(1, {{1.5, 60}, false}).drawn();
    ASSERT_EQ(drawing.shapes.size(), 3U);
    std::set<Point> faces;
    for (std::size_t i = 0; i < 2; ++i) {
        const RingView ring = polygon_of(drawing, drawing.shapes[i]).outer();
        EXPECT_GT(ring.size(), 20U);
        faces.insert(ring.begin(), ring.end());
        EXPECT_EQ(drawing.shapes[i].style, 0U);
    }
    for (const Point p : polygon_of(drawing, drawing.shapes[2]).outer()) EXPECT_TRUE(faces.contains(p));
    // A shape that is not drawn holds no line in its place, one that is drawn and does not wobble does.
    Page half;
    half.with(1, {{1.5, 60}, false}).with(0, {});
    const std::size_t still = polygon_of(half.drawn(), half.drawing.shapes[0]).point_count();
    EXPECT_EQ(still, 4U);
    Page alone;
    alone.with(1, {{1.5, 60}, false});
    alone.shapes[0].shape = HandShape::not_drawn;
    EXPECT_NE(polygon_of(alone.drawn(), alone.drawing.shapes[1]).point_count(),
              polygon_of(half.drawing, half.drawing.shapes[1]).point_count());
}

TEST(ByHand, DrawsCommonBordersOnce) {
    Page page;
    page.drawing.shapes.pop_back();  // without the border
    page.drawing.groups[0].end_overlay = 2;
    page.shapes.pop_back();
    const Drawing& drawing = page.with(0, {{}, true}).with(1, {{}, true}).drawn();
    const std::vector<DrawnShape> strokes = strokes_of(drawing);
    ASSERT_EQ(strokes.size(), 2U) << "the rim, and the line between";
    double inked = 0;
    for (const DrawnShape& stroke : strokes) {
        const Style& style = drawing.styles[stroke.style];
        EXPECT_EQ(style.fill, ink);
        EXPECT_FALSE(style.stroke);
        EXPECT_EQ(find_flaw(polygon_of(drawing, stroke)).value_or(""), "");
        inked += area(polygon_of(drawing, stroke));
    }
    EXPECT_NEAR(inked, 350, 40);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(drawing.styles[drawing.shapes[i].style].fill, paper);
        EXPECT_FALSE(drawing.styles[drawing.shapes[i].style].stroke);
    }
    // Both belong to the group that holds both squares, over them.
    EXPECT_EQ(drawing.groups[0].first_overlay, 2U);
    EXPECT_EQ(drawing.groups[0].end_overlay, 4U);
}

TEST(ByHand, WhatIsPaintedLastDraws) {
    Page page;
    page.with(0, {{}, true}).with(1, {{}, true}).with(2, {{}, true}).drawn();
    std::vector<DrawnShape> strokes = strokes_of(page.drawing);
    ASSERT_EQ(strokes.size(), 2U);
    std::multiset<std::string> colours;
    for (const DrawnShape& stroke : strokes) colours.insert(to_text(*page.drawing.styles[stroke.style].fill));
    EXPECT_EQ(colours, (std::multiset<std::string>{to_text(ink), to_text(red)}));
    EXPECT_EQ(page.drawing.shapes.size(), 4U) << "a border without a stroke is nothing";

    Page under_even;  // the even border draws the rim itself
    under_even.with(0, {{}, true}).with(1, {{}, true}).drawn();
    strokes = strokes_of(under_even.drawing);
    ASSERT_EQ(strokes.size(), 1U);
    EXPECT_NEAR(area(polygon_of(under_even.drawing, strokes[0])), 50, 12);
    EXPECT_EQ(under_even.drawing.shapes.back().key, Key{3}) << "over the strokes";
}

// A line that meets a stroke on its way changes nothing of it.
TEST(ByHand, StrokesKeepTheirKeys) {
    const auto strokes_with = [](bool divided) {
        Page page;
        auto geometry = std::make_shared<Polygons>(*page.drawing.geometry[0]);
        if (divided) {
            Polygons parts;
            for (const double x : {0.0, 20.0}) {
                parts.add_ring(std::vector<Point>{snap({x, 0}), snap({x == 0 ? 20.0 : 50.0, 0}),
                                                  snap({x == 0 ? 20.0 : 50.0, 50}), snap({x, 50})});
                parts.end_polygon();
            }
            geometry->add_all(parts);
            page.drawing.shapes[0].polygon = page.shapes[0].polygon = 3;
            page.drawing.shapes.insert(page.drawing.shapes.end() - 1, {0, 4, 0, Key{2}});
            page.shapes[2].shape = 3;
            page.drawing.groups[0].first_overlay = 2;
            page.drawing.groups[0].end_overlay = 4;
            page.shapes.push_back({0, 4, 2, HandRole::face, {{}, true}});
        }
        page.drawing.geometry[0] = geometry;
        page.with(0, {{}, true}).with(1, {{}, true}).with(2, {{}, true}).drawn();
        std::set<std::uint64_t> keys;
        for (const DrawnShape& stroke : strokes_of(page.drawing)) keys.insert(stroke.key.value);
        return keys;
    };
    const std::set<std::uint64_t> before = strokes_with(false), after = strokes_with(true);
    EXPECT_EQ(after.size(), before.size() + 1);
    EXPECT_TRUE(std::includes(after.begin(), after.end(), before.begin(), before.end()));
}

TEST(ByHand, MarksAreDrawnOnTheirOwn) {
    Page page;
    page.shapes[2].role = HandRole::mark;
    page.with(2, {{1, 60}, true}).drawn();
    const std::vector<DrawnShape> strokes = strokes_of(page.drawing);
    ASSERT_EQ(strokes.size(), 1U);
    EXPECT_NEAR(area(polygon_of(page.drawing, strokes[0])), 900, 120);
    EXPECT_EQ(polygon_of(page.drawing, page.drawing.shapes[0]).point_count(), 4U);
}

}  // namespace
}  // namespace filigree
