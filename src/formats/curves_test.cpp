// Curves in files: SVG, PDF and PNG draw the same path.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/elementary.h"
#include "base/test_cases.h"
#include "formats/pdf_test_reader.h"
#include "formats/pdf_write.h"
#include "formats/png_test_reader.h"
#include "formats/png_write.h"
#include "formats/svg_path_data.h"
#include "formats/svg_read.h"
#include "formats/svg_write.h"
#include "formats/test_drawings.h"
#include "scene/curves.h"

namespace filigree {
namespace {

const Style outlined{red, black, 2, Corner::mitre};

Path path_of(std::string_view data) {
    const Result<Path> path = parse_path_data(data);
    EXPECT_TRUE(path) << data;
    return path ? *path : Path{};
}
Drawing drawn(const Path& path, const Style& style, Vec size = {100, 100}) {
    Drawing drawing;
    drawing.canvas.size = size;
    add_curve(drawing, path, style, Key{7}, 0.01);
    drawing.groups = {{"start", 0, static_cast<std::uint32_t>(drawing.shapes.size()), 0, 0, {}}};
    return drawing;
}
Drawing drawn(std::string_view data, const Style& style, Vec size = {100, 100}) {
    return drawn(path_of(data), style, size);
}
std::string data_of(std::string_view path, int decimals = 3) {
    TextBuffer out;
    put_curve_data(out, path_of(path), decimals);
    return std::move(out).take();
}

double distance(Vec p, const Polyline& line) {
    double nearest = 1e300;
    const std::size_t count = line.points.size() - (line.closed ? 0 : 1);
    for (std::size_t i = 0; i < count; ++i) {
        const Vec a = line.points[i], along = line.points[(i + 1) % line.points.size()] - a;
        const double squared = dot(along, along);
        const double part = squared > 0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0;
        nearest = std::min(nearest, length(p - a - part * along));
    }
    return nearest;
}
// How far points of each path lie from the other, at most, to within the fineness to which that is flattened.
double distance(const Path& a, const Path& b, double fineness) {
    constexpr double coarse = 0.3;
    const auto one_way = [&](const Path& from, const Path& to) {
        const std::vector<Polyline> points = flatten(from, coarse), lines = flatten(to, fineness);
        if (points.size() != lines.size()) return 1e300;
        double farthest = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (points[i].closed != lines[i].closed) return 1e300;
            for (const Vec p : points[i].points) farthest = std::max(farthest, distance(p, lines[i]));
        }
        return farthest;
    };
    return std::max(one_way(a, b), one_way(b, a));
}

// --- path data ---

TEST(CurveData, HasThePathsOwnCommands) {
    EXPECT_EQ(data_of("M1 2Q3 4 5 2L9 2V7L8 8C9 9 9.5 9 9.5 8.25A4 3 30 0 1 5 5Z"),
              "m1 2q2 2 4 0h4v5l-1 1c1 1 1.5 1 1.5.25a4 3 30 0 1-4.5-3.25z");
    // Equal commands follow each other, and what rounds to nothing is left out.
    EXPECT_EQ(data_of("M0 0Q1 0 1 1Q1 2 2 2L2.0001 2.0001C2 2 2 2 2.0001 2A1 1 9 0 0 3 3A1 1 0 1 0 2 2"),
              "m0 0q1 0 1 1 0 1 1 1a1 1 0 0 0 1 1 1 1 0 1 0-1-1");
    EXPECT_EQ(data_of("M1 1L1 1M2 2Q2 2 2 2M3 3Z"), "m1 1h0m1 1h0m1 1z");
    EXPECT_EQ(data_of("M1.26 1Q2 2 3.34 3", 1), "m1.3 1q.7 1 2 2");
    // After a close the path stands where its subpath began.
    EXPECT_EQ(data_of("M1 1L5 1L5 5ZM2 2L3 3"), "m1 1h4v4zm1 1 1 1");
    TextBuffer out;
    EXPECT_EQ(put_curve_data(out, path_of("M1 1L5 1L5 5Z"), 2, {300, 0}), (Point{100, 100}));
    EXPECT_EQ(std::move(out).take(), "m-2 1h4v4z");
}

TEST(CurveData, ArcsThatLinesAreAsGoodAsAreLines) {
    EXPECT_EQ(data_of("M0 0A0 5 0 0 1 3 0"), "m0 0h3");
    EXPECT_EQ(data_of("M0 0A5 5 0 0 1 0 0L1 1"), "m0 0 1 1");
}

TEST(CurveData, HalvesOfCirclesAreOneArc) {
    for (std::uint64_t n = 0; n < case_count(200); ++n) {
        CaseRandom random(n);
        const Vec centre{random.between(-500, 500), random.between(-500, 500)};
        const elementary::CosSin to = elementary::cos_sin_degrees(random.between(0, 360));
        const double radius = random.between(0.1, 400);
        const Vec out = radius * Vec{to.cos, to.sin};
        Path path{{Verb::move, Verb::arc, Verb::arc, Verb::close}, {centre - out}};
        for (const Vec end : {centre + out, centre - out}) {
            path.points.insert(path.points.end(), {{radius, radius}, {0, 2}, end});
        }
        TextBuffer text;
        put_curve_data(text, path, 3);
        const Path read = path_of(std::move(text).take());
        EXPECT_EQ(read.verbs, path.verbs) << n;
        EXPECT_LT(distance(path, read, 1e-3), 3e-3) << n;
    }
}

// Also where an arc is nearly half a turn, or nearly a whole one.
TEST(CurveData, ArcsStayWhereTheyAre) {
    std::size_t split = 0, as_cubics = 0;
    for (std::uint64_t n = 0; n < case_count(300); ++n) {
        CaseRandom random(n);
        const int decimals = random.whole(0, 5);
        const double unit = std::pow(10.0, -decimals);
        const double radius = random.between(5, 500), ratio = random.coin() ? 1 : random.between(0.001, 1);
        const double close = std::pow(10.0, random.between(-6, 2));
        const double from = random.between(0, 360);
        const double turn = random.below(3) == 0 ? random.between(0.1, 359) : 180.0 * (1 + random.below(2)) - close;
        const double tilt = random.between(-90, 90);
        const Transform place = compose(translation({random.between(-99, 99), random.between(-99, 99)}),
                                        compose(rotation_degrees(tilt), scaling(radius, ratio * radius)));
        const bool is_sweep = random.coin();
        Path path{{Verb::move, Verb::arc}, {apply(place, unit_at_degrees(from))}};
        path.points.insert(path.points.end(), {{radius, ratio * radius},
                                               {tilt, (turn > 180 ? 1.0 : 0.0) + (is_sweep ? 2.0 : 0.0)},
                                               apply(place, unit_at_degrees(is_sweep ? from + turn : from - turn))});
        TextBuffer text;
        put_curve_data(text, path, decimals);
        const std::string data = std::move(text).take();
        const Path read = path_of(data);
        split += read.verbs.size() > 2 ? 1 : 0;
        as_cubics += read.verbs[1] == Verb::cubic ? 1 : 0;
        EXPECT_LT(distance(path, read, 0.2 * unit + 1e-5), 2.5 * unit + 1e-5)
            << "case " << n << ": " << to_path_data(path) << " as " << data;
    }
    EXPECT_GT(split, 0U);
    EXPECT_GT(as_cubics, 0U);
    EXPECT_LT(as_cubics, case_count(300) / 10);
}

// --- SVG ---

// Paths whose numbers are whole thousandths come back as they were.
Path random_path(CaseRandom& random, bool is_closed) {
    const auto thousandths = [&](double low, double high) {
        return std::round(1000 * random.between(low, high)) / 1000;
    };
    const auto point = [&] { return Vec{thousandths(-99, 99), thousandths(-99, 99)}; };
    Path path{{Verb::move}, {point()}};
    for (std::uint32_t n = 1 + random.below(5); n > 0; --n) {
        Vec to = point();
        switch (random.below(4)) {
            case 0:
                path.verbs.push_back(Verb::line);
                break;
            case 1:
                path.verbs.push_back(Verb::quadratic);
                path.points.push_back(point());
                break;
            case 2:
                path.verbs.push_back(Verb::cubic);
                path.points.insert(path.points.end(), {point(), point()});
                break;
            default: {  // of at most a third of a turn
                path.verbs.push_back(Verb::arc);
                const double radius = thousandths(20, 60);
                to = path.points.back() + Vec{thousandths(-20, 20), thousandths(-20, 20)};
                to = {std::round(to.x * 1000) / 1000, std::round(to.y * 1000) / 1000};
                path.points.insert(path.points.end(), {{radius, radius}, {0, random.coin() ? 2.0 : 0.0}});
            }
        }
        path.points.push_back(to);
    }
    if (is_closed) path.verbs.push_back(Verb::close);
    return path;
}

TEST(CurvesInSvg, ComeBackAsTheyWere) {
    const Style stroke = stroked(black, 1);
    for (std::uint64_t n = 0; n < case_count(300); ++n) {
        CaseRandom random(n);
        const Path path = random_path(random, random.coin());
        const Result<SvgPicture> picture = read_svg(to_svg(drawn(path, stroke), {}));
        ASSERT_TRUE(picture) << n;
        ASSERT_EQ(picture->shapes.size(), 1U) << n;
        const Path& read = picture->shapes[0].path;
        ASSERT_EQ(read.verbs, path.verbs) << n;
        for (std::size_t i = 0; i < path.points.size(); ++i) {
            EXPECT_NEAR(read.points[i].x, path.points[i].x, 1e-9) << n;
            EXPECT_NEAR(read.points[i].y, path.points[i].y, 1e-9) << n;
        }
        EXPECT_FALSE(picture->shapes[0].filled);
    }
}

TEST(CurvesInSvg, AreFilledByTheEvenOddRule) {
    const std::string ring = "M0 0A50 50 0 0 1 100 0A50 50 0 0 1 0 0ZM20 0A30 30 0 0 1 80 0A30 30 0 0 1 20 0Z";
    const Drawing drawing = drawn(ring, outlined);
    const std::string svg = to_svg(drawing, {});
    EXPECT_NE(svg.find("<g fill-rule=\"evenodd\" data-path=\"start\" fill=\"#ff0000\" stroke=\"#000000\""),
              std::string::npos)
        << svg;
    EXPECT_NE(svg.find("d=\"m0 0a50 50 0 0 1 100 0 50 50 0 0 1-100 0zm20 0a30 30 0 0 1 60 0 30 30 0 0 1-60 0z\"/>"),
              std::string::npos)
        << svg;
    // Lean files fill everything else by the other rule.
    Drawing three = drawn(ring, filled(red));
    for (int i = 0; i < 2; ++i) add_curve(three, path_of(ring), filled(red), Key{8}, 0.01);
    three.shapes[2].curve = DrawnShape::no_curve;
    three.shapes.push_back(three.shapes[2]);
    three.groups[0].end_shape = 4;
    SvgOptions options;
    options.lean = true;
    const Result<SvgPicture> picture = read_svg(to_svg(three, options));
    ASSERT_TRUE(picture);
    ASSERT_EQ(picture->shapes.size(), 3U);
    EXPECT_EQ(picture->shapes[0].fill_rule, FillRule::even_odd);
    EXPECT_EQ(picture->shapes[1].fill_rule, FillRule::even_odd);
    EXPECT_EQ(picture->shapes[2].fill_rule, FillRule::nonzero);
    for (const SvgShape& shape : picture->shapes) {
        EXPECT_NEAR(area(clean(flatten(shape.path, 0.01), shape.fill_rule)), elementary::pi * 1600, 20);
    }
    // What is not filled joins as all lines do.
    Drawing lines = drawn("M0 0Q5 5 9 0", stroked(black, 1));
    add_curve(lines, path_of("M0 9Q5 5 9 9"), stroked(black, 1), Key{8}, 0.01);
    lines.groups[0].end_shape = 2;
    const std::string lean = to_svg(lines, options);
    EXPECT_NE(lean.find("d=\"m0 0q5 5 9 0m-9 9q5-4 9 0\"/>"), std::string::npos) << lean;
}

// --- PDF ---

std::vector<PdfOperator> painted(const Drawing& drawing) {
    return pdf_operators(read_test_pdf(to_pdf(drawing, {})).content());
}
std::string names(const std::vector<PdfOperator>& operators) {
    std::string text;
    for (const PdfOperator& o : operators) text += (text.empty() ? "" : " ") + o.name;
    return text;
}
// What is painted first, in px.
Path painted_path(const std::vector<PdfOperator>& operators) {
    Path path;
    for (const PdfOperator& o : operators) {
        if (o.name == "S" || o.name == "f*" || o.name == "B*") break;
        const bool is_path = o.name == "m" || o.name == "l" || o.name == "c" || o.name == "h";
        if (!is_path) continue;
        path.verbs.push_back(o.name == "m"   ? Verb::move
                             : o.name == "l" ? Verb::line
                             : o.name == "c" ? Verb::cubic
                                             : Verb::close);
        for (std::size_t i = 0; i < o.operands.size(); i += 2) {
            path.points.push_back(0.001 * Vec{o.number(i), o.number(i + 1)});
        }
    }
    return path;
}

TEST(CurvesInPdf, AreCubics) {
    const std::vector<PdfOperator> open = painted(drawn("M0 0Q30 0 30 30C40 40 50 40 60 30L9 9", stroked(black, 1)));
    EXPECT_EQ(names(open), "q cm M gs RG w J j m c c l S Q");
    EXPECT_EQ(open[9].operands, (std::vector<std::string>{"20000", "0", "30000", "10000", "30000", "30000"}));
    EXPECT_EQ(names(painted(drawn("M0 0Q30 0 30 30Z", outlined))), "q cm M gs rg RG w j m c h B* Q");
    EXPECT_EQ(names(painted(drawn("M0 0Q30 0 30 30Z", filled(red)))), "q cm M gs rg m c h f* Q");
    Style translucent = outlined;
    translucent.stroke->alpha = 99;
    EXPECT_EQ(names(painted(drawn("M0 0Q30 0 30 30Z", translucent))), "q cm M gs rg RG w j m c h f* m c h S Q");
    // Control points far out cost digits, as far shapes do.
    EXPECT_EQ(painted(drawn("M0 0Q6e6 0 0 9", stroked(black, 1)))[1].operands[0], "0.0075");
}

TEST(CurvesInPdf, LieWhereThePathDoes) {
    for (std::uint64_t n = 0; n < case_count(100); ++n) {
        CaseRandom random(n);
        const Path path = random_path(random, random.coin());
        EXPECT_LT(distance(path, painted_path(painted(drawn(path, stroked(black, 1)))), 0.01), 0.022) << n;
    }
}

// --- PNG ---

TEST(CurvesInPng, ACircleOfArcsIsRound) {
    // Drawn from arcs; the polygon that stands for it elsewhere has few corners.
    Drawing drawing;
    drawing.canvas.size = {200, 200};
    add_curve(drawing, path_of("M10 100A90 90 0 0 1 190 100A90 90 0 0 1 10 100Z"), filled(black), Key{7}, 9);
    drawing.groups = {{"start", 0, 1, 0, 0, {}}};
    ASSERT_LT(polygon_of(drawing, drawing.shapes[0]).point_count(), 9U);
    const DecodedPng picture = decode_png(*to_png(drawing, {2}));
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const double off = length(0.5 * Vec{x + 0.5, y + 0.5} - Vec{100, 100}) - 90;
            const std::uint32_t pixel = picture.at(x, y) & 0xFFFFFFU;
            if (std::fabs(off) < 0.5) continue;
            ASSERT_EQ(pixel, off > 0 ? 0xFFFFFFU : 0U) << x << " " << y;
        }
    }
    drawing.shapes[0].curve = DrawnShape::no_curve;
    EXPECT_EQ(decode_png(*to_png(drawing, {2})).at(100, 30) & 0xFFFFFFU, 0xFFFFFFU);
}

TEST(CurvesInPng, OpenOnesAreStrokedAndFarOnesArePolygons) {
    const DecodedPng picture = decode_png(*to_png(drawn("M10 10C10 90 90 90 90 10", stroked(black, 2)), {1}));
    EXPECT_EQ(picture.at(50, 69) & 0xFFFFFFU, 0U);
    EXPECT_EQ(picture.at(50, 10) & 0xFFFFFFU, 0xFFFFFFU);  // where it would close
    EXPECT_EQ(picture.at(50, 50) & 0xFFFFFFU, 0xFFFFFFU);
    // The control point is far out, then the whole curve is.
    const DecodedPng far = decode_png(*to_png(drawn("M50 0C50 4e7 51 -4e7 50 100", stroked(black, 2)), {1}));
    EXPECT_EQ(far.at(50, 50) & 0xFFFFFFU, 0U);
    const DecodedPng line = decode_png(*to_png(drawn("M-4e7 50Q0 50 4e7 50", stroked(black, 2)), {1}));
    EXPECT_EQ(line.at(20, 50) & 0xFFFFFFU, 0U);
    EXPECT_EQ(line.at(20, 20) & 0xFFFFFFU, 0xFFFFFFU);
}

}  // namespace
}  // namespace filigree
