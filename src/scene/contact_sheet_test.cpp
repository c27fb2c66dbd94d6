#include "scene/contact_sheet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "base/test_cases.h"
#include "plane/verify.h"
#include "scene/lettering.h"

namespace filigree {
namespace {

constexpr Colour ink{0, 0, 0, 255}, blue{10, 40, 200, 255}, white{255, 255, 255, 255};

Drawing rectangle_on(Vec origin, Vec size, Vec min, Vec max, double pen = 1) {
    Polygons polygons;
    polygons.add_ring(std::vector<Point>{snap(min), snap({max.x, min.y}), snap(max), snap({min.x, max.y})});
    polygons.end_polygon();
    Drawing drawing;
    drawing.canvas.origin = origin;
    drawing.canvas.size = size;
    drawing.styles = {{blue, ink, pen, Corner::round}};
    drawing.shapes = {{0, 0, 0, Key{1}}};
    drawing.geometry = {std::make_shared<const Polygons>(std::move(polygons))};
    drawing.groups = {{"start", 0, 1, 0, 0, {}}};
    return drawing;
}

// A canvas with a shape that fills it but for `margin` px.
Drawing framed(double width, double height, double margin = 5) {
    const Vec origin{-7, 300}, size{width, height}, inset{margin, margin};
    return rectangle_on(origin, size, origin + inset, origin + size - inset);
}

struct Extent {  // px
    Vec min{1e9, 1e9}, max{-1e9, -1e9};

    Vec size() const { return max - min; }
    Vec centre() const { return 0.5 * (min + max); }
};

Extent extent_of(const Drawing& drawing, std::uint32_t first, std::uint32_t end) {
    Extent extent;
    for (std::uint32_t s = first; s < end; ++s) {
        const Box box = bounds((*drawing.geometry[drawing.shapes[s].geometry])[drawing.shapes[s].polygon]);
        const Vec min = to_px(box.min), max = to_px(box.max);
        extent.min = {std::min(extent.min.x, min.x), std::min(extent.min.y, min.y)};
        extent.max = {std::max(extent.max.x, max.x), std::max(extent.max.y, max.y)};
    }
    return extent;
}

// Cell number i of a sheet: its group, its picture's, and their extents.
struct SeenCell {
    const DrawingGroup* cell = nullptr;
    const DrawingGroup* picture = nullptr;
    Extent drawn, label;  // the label with the cover, if there is one
};
SeenCell seen(const Drawing& sheet, std::size_t i) {
    SeenCell cell;
    cell.cell = &sheet.groups[sheet.groups[0].children[i]];
    cell.label = extent_of(sheet, cell.cell->first_overlay, cell.cell->end_overlay);
    if (cell.cell->children.empty()) return cell;
    cell.picture = &sheet.groups[cell.cell->children[0]];
    cell.drawn = extent_of(sheet, cell.picture->first_shape, cell.picture->end_shape);
    return cell;
}

bool are_apart(const Extent& a, const Extent& b) {
    return a.max.x < b.min.x || b.max.x < a.min.x || a.max.y < b.min.y || b.max.y < a.min.y;
}

TEST(ContactSheet, EqualCanvasesHaveEqualScales) {
    const Drawing small = framed(120, 90), other = framed(120, 90, 20);
    const Drawing sheet = contact_sheet({{&small, "a"}, {&other, "b"}, {&small, "c"}}, {});
    EXPECT_NEAR(seen(sheet, 0).drawn.size().x, 2 * 110, 1e-6);
    EXPECT_NEAR(seen(sheet, 1).drawn.size().x, 2 * 80, 1e-6);
    EXPECT_NEAR(seen(sheet, 2).drawn.size().y, 2 * 80, 1e-6);
    EXPECT_EQ(sheet.canvas.background, white);
    EXPECT_EQ(sheet.canvas.origin, (Vec{0, 0}));
    EXPECT_EQ(sheet.groups[sheet.groups[0].children[2]].path, "3");
    EXPECT_EQ(seen(sheet, 2).picture->path, "3/start");
}

TEST(ContactSheet, ColumnsAreNearSquareUnlessSaid) {
    const Drawing drawing = framed(100, 100);
    for (std::size_t count = 1; count <= 20; ++count) {
        const std::vector<SheetCell> cells(count, SheetCell{&drawing, "x"});
        for (const std::uint32_t wanted : {0U, 1U, 3U, 50U}) {
            SheetOptions options;
            options.columns = wanted;
            const Drawing sheet = contact_sheet(cells, options);
            const double top = seen(sheet, 0).drawn.min.y;
            std::size_t columns = 0;
            for (std::size_t i = 0; i < count; ++i) columns += seen(sheet, i).drawn.min.y == top ? 1 : 0;
            const auto square = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
            EXPECT_EQ(columns, wanted == 0 ? square : std::min<std::size_t>(wanted, count));
        }
    }
}

TEST(ContactSheet, NothingMeetsAnythingElseAndAllIsOnTheSheet) {
    for (std::uint64_t n = 0; n < case_count(100); ++n) {
        CaseRandom random(n);
        std::vector<Drawing> drawings;
        std::vector<SheetCell> cells;
        for (std::uint32_t k = 1 + random.below(9); k > 0; --k) {
            drawings.push_back(framed(random.between(20, 900), random.between(20, 900)));
            if (random.coin()) drawings.back().canvas.background = blue;
        }
        for (const Drawing& drawing : drawings) {
            std::string label;
            for (std::uint32_t k = random.below(60); k > 0; --k) label += static_cast<char>(' ' + random.below(95));
            cells.push_back({random.below(8) == 0 ? nullptr : &drawing, label});
        }
        SheetOptions options;
        options.columns = random.below(5);
        options.cell = random.between(80, 300);
        options.gap = random.between(10, 40);
        options.label_height = random.between(6, 12);
        if (random.coin()) options.title = "A title that may well be too long for a sheet of one column";
        const Drawing sheet = contact_sheet(cells, options);
        std::vector<Extent> extents;
        if (sheet.groups[0].end_shape > 0) extents.push_back(extent_of(sheet, 0, sheet.groups[0].end_shape));
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const SeenCell cell = seen(sheet, i);
            const bool has_picture = cell.picture != nullptr, has_label = cell.label.min.x < cell.label.max.x;
            EXPECT_EQ(has_picture, cells[i].drawing != nullptr);
            if (has_picture) {
                // All shapes here fill their canvases but for a margin.
                const Vec canvas = cells[i].drawing->canvas.size;
                const double scale = options.cell / std::max(canvas.x, canvas.y);
                EXPECT_NEAR(cell.drawn.size().x, (canvas.x - 10) * scale, 1e-6);
                EXPECT_NEAR(cell.drawn.size().y, (canvas.y - 10) * scale, 1e-6);
                extents.push_back(cell.drawn);
                EXPECT_EQ(cell.cell->end_shape - cell.cell->first_shape, cells[i].drawing->canvas.background ? 1U : 0U);
            }
            if (has_label) extents.push_back(cell.label);
            if (has_label && has_picture) {
                EXPECT_NEAR(cell.label.centre().x, cell.drawn.centre().x, options.label_height);
                EXPECT_GT(cell.label.min.y, cell.drawn.max.y);
            }
        }
        for (std::size_t a = 0; a < extents.size(); ++a) {
            EXPECT_GE(std::min(extents[a].min.x, extents[a].min.y), options.gap);
            EXPECT_LE(extents[a].max.x, sheet.canvas.size.x - options.gap);
            EXPECT_LE(extents[a].max.y, sheet.canvas.size.y - options.gap);
            for (std::size_t b = 0; b < a; ++b) EXPECT_TRUE(are_apart(extents[a], extents[b])) << "case " << n;
        }
    }
}

TEST(ContactSheet, BackgroundsCoverTheCanvasUnderThePicture) {
    Drawing drawing = framed(100, 50, 10);
    drawing.canvas.background = Colour{1, 2, 3, 128};
    const Drawing sheet = contact_sheet({{&drawing, ""}}, {});
    const SeenCell cell = seen(sheet, 0);
    ASSERT_EQ(cell.cell->end_shape, cell.cell->first_shape + 1);
    const Extent ground = extent_of(sheet, cell.cell->first_shape, cell.cell->end_shape);
    EXPECT_NEAR(ground.size().x, 240, 1e-6);
    EXPECT_NEAR(ground.size().y, 120, 1e-6);
    EXPECT_NEAR(length(ground.centre() - cell.drawn.centre()), 0, 1e-6);
    EXPECT_EQ(sheet.styles[sheet.shapes[cell.cell->first_shape].style].fill, drawing.canvas.background);
    EXPECT_EQ(cell.cell->first_overlay, cell.cell->end_overlay);  // no label, nothing cut
}

TEST(ContactSheet, PensAreScaledButNeverTooThin) {
    const Drawing fine = rectangle_on({0, 0}, {480, 480}, {50, 50}, {90, 90}, 0.4);
    const Drawing bold = rectangle_on({0, 0}, {480, 480}, {50, 50}, {90, 90}, 3);
    const Drawing sheet = contact_sheet({{&fine, ""}, {&bold, ""}}, {});
    const auto pen = [&](std::size_t i) {
        return sheet.styles[sheet.shapes[seen(sheet, i).picture->first_shape].style].pen;
    };
    EXPECT_EQ(pen(0), thinnest_sheet_pen);
    EXPECT_EQ(pen(1), 1.5);
}

TEST(ContactSheet, WhatReachesBeyondItsCanvasIsCutAndTheCutCovered) {
    const double pen = 2;
    const Drawing wide = rectangle_on({0, 0}, {240, 240}, {-500, 100}, {700, 140}, pen);
    const Drawing within = rectangle_on({0, 0}, {240, 240}, {1, 1}, {239, 239}, pen);
    const Drawing only_pen = rectangle_on({0, 0}, {240, 240}, {0.5, 0.5}, {239, 239}, pen);
    const Drawing sheet = contact_sheet({{&wide, ""}, {&within, ""}, {&only_pen, ""}}, {});
    const SeenCell cut = seen(sheet, 0);
    EXPECT_NEAR(cut.drawn.size().x, 240 + 2 * pen, 1e-6);
    EXPECT_NEAR(cut.drawn.size().y, 40, 1e-6);
    ASSERT_EQ(cut.cell->end_overlay, cut.cell->first_overlay + 1);
    const DrawnShape& shape = sheet.shapes[cut.cell->first_overlay];
    const PolygonView cover = (*sheet.geometry[shape.geometry])[shape.polygon];
    EXPECT_FALSE(find_flaw(cover));
    EXPECT_EQ(sheet.styles[shape.style].fill, white);
    EXPECT_FALSE(sheet.styles[shape.style].stroke);
    ASSERT_EQ(cover.ring_count(), 2U);
    // The canvas is free, the stroke along the cut and its corners are not.
    const Vec corner = cut.drawn.min + Vec{pen, -100};
    const Vec end = corner + Vec{240, 240};
    EXPECT_EQ(locate(cover, snap(corner + Vec{0.1, 0.1})), -1);
    EXPECT_EQ(locate(cover, snap(end - Vec{0.1, 0.1})), -1);
    for (const double out : {0.1, pen, 1.5 * pen, 2.9 * pen}) {
        EXPECT_EQ(locate(cover, snap({corner.x - out, corner.y + 120})), 1);
        EXPECT_EQ(locate(cover, snap(end + Vec{out, out})), 1);
    }
    EXPECT_EQ(seen(sheet, 1).cell->first_overlay, seen(sheet, 1).cell->end_overlay);
    EXPECT_EQ(seen(sheet, 2).cell->first_overlay + 1, seen(sheet, 2).cell->end_overlay);
}

TEST(ContactSheet, LongLabelsEndInDots) {
    const Drawing drawing = framed(240, 240);
    SheetOptions options;
    const double height = options.label_height;
    const auto label_of = [&](const std::string& text) {
        const Drawing sheet = contact_sheet({{&drawing, text}}, options);
        return seen(sheet, 0).label.size().x;
    };
    const auto ink_of = [&](const std::string& text) {
        const Box box = bounds(lettering(text, {0, 0}, {height, 0.09 * height}));
        return to_px(box.max).x - to_px(box.min).x;
    };
    EXPECT_NEAR(label_of("short"), ink_of("short"), 1e-6);
    for (const std::string word : {"wide and wider ", "illicit ", "a b c ", ".", "MW"}) {
        std::string text;
        while (lettering_width(text, height) <= 240) text += word;
        // The longest beginning that leaves room, less its blanks.
        std::string kept = text;
        while (lettering_width(kept + "...", height) > 240) kept.pop_back();
        while (kept.back() == ' ') kept.pop_back();
        EXPECT_NEAR(label_of(text), ink_of(kept + "..."), 1e-6);
        EXPECT_LT(label_of(text + text), 240);
    }
    std::string accents;  // cut between characters, not inside one
    for (int i = 0; i < 100; ++i) accents += "\xc3\xa9";
    const double box = lettering_width("\xc3\xa9", height);
    const auto whole = static_cast<std::size_t>((240 - lettering_width("...", height)) / box);
    EXPECT_NEAR(label_of(accents), ink_of(accents.substr(0, 2 * whole) + "..."), 1e-6);
}

TEST(ContactSheet, TakesWhatHasNoPicture) {
    Drawing broken = framed(100, 100);
    broken.canvas.size = {0, 10};
    Drawing endless = framed(100, 100);
    endless.canvas.size.x = std::numeric_limits<double>::infinity();
    const Drawing sheet = contact_sheet({{nullptr, "none"}, {&broken, "no width"}, {&endless, "too wide"}}, {});
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(seen(sheet, i).picture, nullptr);
        EXPECT_GT(seen(sheet, i).label.size().x, 10);
    }
    const Drawing empty = contact_sheet({}, {});
    EXPECT_TRUE(empty.shapes.empty());
    EXPECT_GT(empty.canvas.size.x, 0);
    EXPECT_GT(empty.canvas.size.y, 0);
}

}  // namespace
}  // namespace filigree
