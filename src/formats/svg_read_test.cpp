#include "formats/svg_read.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/elementary.h"
#include "base/number_text.h"
#include "base/random.h"
#include "base/test_cases.h"
#include "formats/test_drawings.h"

namespace filigree {
namespace {

using elementary::pi;

std::string svg(const std::string& inside, const std::string& attributes = "width='100' height='100'") {
    return "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' "
           "xmlns:inkscape='http://www.inkscape.org/namespaces/inkscape' " +
           attributes + ">" + inside + "</svg>";
}

SvgPicture picture_of(const std::string& text) {
    Result<SvgPicture> picture = read_svg(text);
    EXPECT_TRUE(picture) << text << "\n" << (picture ? "" : picture.diagnostics()[0].message);
    return picture ? *std::move(picture) : SvgPicture{};
}

// The box of a shape in px, as text to compare: "x y width height" in thousandths.
std::string box_of(const SvgShape& shape) {
    Box box;
    for (const Polyline& line : flatten(shape.path, 0.001)) {
        for (const Vec p : line.points) extend(box, snap(p));
    }
    if (is_empty(box)) return "empty";
    const Vec min = to_px(box.min), size = to_px({box.max.x - box.min.x, box.max.y - box.min.y});
    std::string text;
    for (const double value : {min.x, min.y, size.x, size.y}) {
        if (!text.empty()) text += ' ';
        append_fixed(text, std::round(value * 100) / 100, 2);
    }
    return text;
}
std::string boxes_of(const std::string& text) {
    std::string boxes;
    for (const SvgShape& shape : picture_of(text).shapes) boxes += (boxes.empty() ? "" : ", ") + box_of(shape);
    return boxes;
}
double area_of(const SvgShape& shape) { return area(clean(flatten(shape.path, 1e-4), shape.fill_rule)); }
double area_of(const std::string& text) {
    double sum = 0;
    for (const SvgShape& shape : picture_of(text).shapes) sum += area_of(shape);
    return sum;
}
std::string ids_of(const std::string& text) {
    std::string all;
    for (const SvgShape& shape : picture_of(text).shapes) {
        if (!all.empty()) all += ' ';
        for (const std::string& group : shape.groups) all += group + "/";
        all += shape.id;
    }
    return all;
}

// The codes of what is wrong with a text, or of the warnings that it reads with.
std::string codes_of(const std::string& text) {
    const Result<SvgPicture> picture = read_svg(text);
    std::string codes = picture ? "ok" : "wrong";
    for (const Diagnostic& diagnostic : picture.diagnostics()) codes += " " + diagnostic.code.substr(4);
    return codes;
}

TEST(SvgRead, Shapes) {
    EXPECT_NEAR(area_of(svg("<rect x='1' y='2' width='30' height='20'/>")), 600, 1e-6);
    EXPECT_NEAR(area_of(svg("<rect x='1' y='2' width='30' height='20' rx='5' ry='4'/>")), 600 - (4 - pi) * 20, 1e-2);
    EXPECT_NEAR(area_of(svg("<rect width='30' height='20' rx='5'/>")), 600 - (4 - pi) * 25, 1e-2);
    EXPECT_NEAR(area_of(svg("<rect width='30' height='20' ry='5' rx='auto'/>")), 600 - (4 - pi) * 25, 1e-2);
    EXPECT_NEAR(area_of(svg("<rect width='30' height='20' rx='99' ry='99'/>")), pi * 150, 1e-2);
    EXPECT_NEAR(area_of(svg("<rect width='30' height='20' rx='5' ry='0'/>")), 600, 1e-6);
    EXPECT_NEAR(area_of(svg("<circle cx='5' cy='6' r='10'/>")), pi * 100, 1e-2);
    EXPECT_NEAR(area_of(svg("<ellipse cx='5' cy='6' rx='10' ry='3'/>")), pi * 30, 1e-2);
    EXPECT_NEAR(area_of(svg("<ellipse rx='10'/>")), pi * 100, 1e-2);
    EXPECT_NEAR(area_of(svg("<polygon points='0,0 10,0 10,10'/>")), 50, 1e-6);
    EXPECT_NEAR(area_of(svg("<polyline points='0 0 10 0 10 10'/>")), 50, 1e-6);
    EXPECT_NEAR(area_of(svg("<path d='M0 0H10V10h-10z M2 2h3v3h-3z' fill-rule='evenodd'/>")), 91, 1e-6);
    EXPECT_NEAR(area_of(svg("<path d='M0 0H10V10h-10z M2 2h3v3h-3z'/>")), 100, 1e-6);
    EXPECT_NEAR(area_of(svg("<path d='M0 0A10 10 0 0 1 20 0z'/>")), pi * 50, 1e-2);
    EXPECT_EQ(boxes_of(svg("<circle cx='5' cy='6' r='10'/>")), "-5 -4 20 20");
    EXPECT_EQ(boxes_of(svg("<line x1='1' y1='2' x2='5' y2='9'/>")), "1 2 4 7");
    // Percentages are of the viewport; lengths have units.
    EXPECT_EQ(boxes_of(svg("<rect x='10%' y='10%' width='50%' height='1in'/>", "width='200' height='100'")),
              "20 10 100 96");
    EXPECT_NEAR(area_of(svg("<circle r='10%'/>", "width='300' height='400'")), pi * 1250, 0.1);
}

TEST(SvgRead, NothingIsDrawnWithoutASize) {
    for (const char* shape : {"<rect width='0' height='5'/>", "<rect width='5'/>", "<circle r='0'/>", "<circle/>",
                              "<ellipse rx='5' ry='0'/>", "<path/>", "<path d=''/>", "<path d='none'/>", "<polygon/>",
                              "<polygon points=' '/>", "<rect width='5' height='5' transform='scale(0)'/>"}) {
        EXPECT_EQ(boxes_of(svg(shape)), "") << shape;
    }
}

TEST(SvgRead, FilledOrNot) {
    const auto filled = [](const std::string& shape) { return picture_of(svg(shape)).shapes.at(0).filled; };
    EXPECT_TRUE(filled("<path d='M0 0L5 5L5 0'/>"));  // open, but filled all the same
    EXPECT_FALSE(filled("<path d='M0 0L5 5L5 0' fill='none'/>"));
    EXPECT_FALSE(filled("<line x2='5' y2='5'/>"));
    EXPECT_FALSE(filled("<g fill='none'><path d='M0 0L5 5L5 0z'/></g>"));
    EXPECT_TRUE(filled("<g fill='none'><path d='M0 0L5 5L5 0z' style='fill:red'/></g>"));
    EXPECT_FALSE(filled("<style>.a{fill:none}</style><path class='a' d='M0 0L5 5L5 0z' fill='red'/>"));
    EXPECT_TRUE(filled("<path d='M0 0L5 5L5 0z' fill='url(#gradient)'/>"));
}

TEST(SvgRead, TransformsCompose) {
    EXPECT_EQ(
        boxes_of(svg("<g transform='translate(10 20)'><g transform='scale(2)'><rect x='1' y='1' width='3' height='4' "
                     "transform='translate(5,0)'/></g></g>")),
        "22 22 6 8");
    EXPECT_EQ(boxes_of(svg("<rect width='10' height='5' transform='rotate(90)'/>")), "-5 0 5 10");
    EXPECT_NEAR(area_of(svg("<circle r='10' transform='skewX(30) scale(1,2)'/>")), pi * 200, 0.05);
}

// Nested transforms place the points where one matrix does.
TEST(SvgRead, NestedTransformsAreOneMatrix) {
    for (std::uint64_t seed = 0; seed < case_count(300); ++seed) {
        Transform all;
        std::string open, close;
        for (std::uint64_t i = 0; i < 4; ++i) {
            const auto number = [&](const char* name, double size) {
                return size * (2 * to_unit(random_bits(seed, Key{i}, name)) - 1);
            };
            const Transform t{number("a", 2), number("b", 2), number("c", 2),
                              number("d", 2), number("e", 9), number("f", 9)};
            all = compose(all, t);
            std::string matrix = "matrix(";
            for (const double value : {t.a, t.b, t.c, t.d, t.e, t.f}) matrix += to_text(value) + " ";
            open += "<g transform='" + matrix + ")'>";
            close += "</g>";
        }
        const SvgPicture picture = picture_of(svg(open + "<path d='M3 4L-5 6 7-8z'/>" + close));
        ASSERT_EQ(picture.shapes.size(), 1U) << "seed " << seed;
        const std::vector<Vec> points{{3, 4}, {-5, 6}, {7, -8}};
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Vec apart = picture.shapes[0].path.points[i] - apply(all, points[i]);
            ASSERT_LT(length(apart), 1e-10) << "seed " << seed;
        }
    }
}

TEST(SvgRead, ViewportsAndUnits) {
    const auto viewport = [](const std::string& attributes) {
        const SvgPicture picture = picture_of(svg("<rect x='10' y='10' width='10' height='10'/>", attributes));
        std::string text;
        for (const double value : {picture.origin.x, picture.origin.y, picture.size.x, picture.size.y}) {
            append_fixed(text, value, 3);
            text += ' ';
        }
        return text + "| " + box_of(picture.shapes.at(0));
    };
    EXPECT_EQ(viewport("width='200' height='100'"), "0 0 200 100 | 10 10 10 10");
    EXPECT_EQ(viewport("viewBox='5 6 50 40'"), "5 6 50 40 | 10 10 10 10");
    EXPECT_EQ(viewport("width='100%' height='100%' viewBox='5 6 50 40'"), "5 6 50 40 | 10 10 10 10");
    EXPECT_EQ(viewport("width='auto' viewBox='5 6 50 40'"), "5 6 50 40 | 10 10 10 10");
    EXPECT_EQ(viewport("width='100' viewBox='0 0 50 40'"), "0 0 100 80 | 20 20 20 20");
    EXPECT_EQ(viewport("height='80' viewBox='0 0 50 40'"), "0 0 100 80 | 20 20 20 20");
    EXPECT_EQ(viewport("width='1in' height='1in' viewBox='0 0 48 48'"), "0 0 96 96 | 20 20 20 20");
    EXPECT_EQ(viewport("width='210mm' height='297mm' viewBox='0 0 210 297'"),
              "0 0 793.701 1122.52 | 37.8 37.8 37.8 37.8");
    EXPECT_EQ(viewport("width='100' height='100' viewBox='10 10 50 25'"), "20 -5 100 100 | 20 20 20 20");
    EXPECT_EQ(viewport("width='100' height='100' viewBox='10 10 50 25' preserveAspectRatio='xMinYMin'"),
              "20 20 100 100 | 20 20 20 20");
    EXPECT_EQ(viewport("width='100' height='100' viewBox='0 0 50 25' preserveAspectRatio='none'"),
              "0 0 100 100 | 20 40 20 40");
    EXPECT_EQ(viewport(""), "0 0 300 150 | 10 10 10 10");
}

TEST(SvgRead, NestedViewports) {
    EXPECT_EQ(boxes_of(svg("<svg x='10' y='20' width='50' height='50' viewBox='0 0 5 5'><rect width='1' height='1'/>"
                           "<rect x='100%' width='50%' height='1'/></svg>")),
              "10 20 10 10, 60 20 25 10");
    EXPECT_EQ(boxes_of(svg("<svg x='10'><rect width='50%' height='1'/></svg>")), "10 0 50 1");
    EXPECT_EQ(boxes_of(svg("<svg width='0'><rect width='50' height='1'/></svg>")), "");
}

TEST(SvgRead, Use) {
    EXPECT_EQ(boxes_of(svg("<defs><rect id='r' width='2' height='3'/></defs><use href='#r' x='10' y='20'/>"
                           "<use xlink:href='#r' transform='scale(2)' x='1'/>")),
              "10 20 2 3, 2 0 4 6");
    // Style comes from the use, not from where the target stands.
    const SvgPicture picture =
        picture_of(svg("<g fill='none' display='none'><rect id='r' width='2' height='3'/></g>"
                       "<use href='#r'/>"));
    ASSERT_EQ(picture.shapes.size(), 1U);
    EXPECT_TRUE(picture.shapes[0].filled);
    EXPECT_EQ(boxes_of(svg("<symbol id='s' viewBox='0 0 10 10'><rect width='10' height='5'/></symbol>"
                           "<use href='#s' x='5' width='20' height='40'/>")),
              "5 10 20 10");
    EXPECT_EQ(boxes_of(svg("<symbol id='s'><rect width='50%' height='5'/></symbol><use href='#s' width='20'/>")),
              "0 0 10 5");
    EXPECT_EQ(boxes_of(svg(
                  "<defs><svg id='s' x='1' width='10' height='10' viewBox='0 0 1 1'><rect width='1' height='1'/></svg>"
                  "</defs><use href='#s' x='5' width='20' height='20'/>")),
              "6 0 20 20");
    EXPECT_EQ(
        boxes_of(svg(
            "<g id='a'><rect width='1' height='1'/></g><g id='b'><use href='#a' x='5'/></g><use href='#b' y='5'/>")),
        "0 0 1 1, 5 0 1 1, 5 5 1 1");
}

TEST(SvgRead, UseThatShowsItself) {
    EXPECT_EQ(codes_of(svg("<use id='u' href='#u'/>")), "wrong use-cycle");
    EXPECT_EQ(codes_of(svg("<g id='a'><use href='#a'/></g>")), "wrong use-cycle");
    EXPECT_EQ(codes_of(svg("<g id='a'><use href='#b'/></g><g id='b'><use href='#a'/></g>")),
              "wrong use-cycle use-cycle");
    EXPECT_EQ(codes_of(svg("<symbol id='s'><use href='#s'/></symbol><use href='#s'/>")), "wrong use-cycle");
    EXPECT_EQ(codes_of(svg("<defs><g id='a'><use href='#a'/></g></defs>")), "ok");  // never shown
    EXPECT_EQ(codes_of(svg("<use href='#nothing'/>")), "ok no-such-id");
    EXPECT_EQ(codes_of(svg("<use href='other.svg#a'/>")), "wrong external-reference");
}

TEST(SvgRead, UseThatGrowsWithoutBound) {
    std::string bomb = "<rect id='a0' width='1' height='1'/>";
    for (int i = 1; i < 30; ++i) {
        const std::string before = "<use href='#a" + std::to_string(i - 1) + "'/>";
        bomb += "<g id='a" + std::to_string(i) + "'>" + before + before + before + "</g>";
    }
    const Result<SvgPicture> picture = read_svg(svg("<defs>" + bomb + "</defs><use href='#a29'/>"));
    ASSERT_FALSE(picture);
    EXPECT_EQ(picture.diagnostics()[0].code, "svg.too-many-elements");
    EXPECT_EQ(picture.diagnostics()[0].fault, Fault::limit);
    // The same with long data.
    const std::string data = "M0 0" + std::string(400'000, ' ') + "h1v1z";
    std::string copies;
    for (int i = 0; i < 5000; ++i) copies += "<use href='#p'/>";
    EXPECT_EQ(codes_of(svg("<defs><path id='p' d='" + data + "'/></defs>" + copies)), "wrong too-large");
}

TEST(SvgRead, WhatIsNotDisplayed) {
    const std::string r = "<rect width='1' height='1'/>";
    EXPECT_EQ(codes_of(svg("<defs>" + r + "</defs><symbol>" + r + "</symbol><clipPath>" + r + "</clipPath><marker>" +
                           r + "</marker><g display='none'>" + r + "</g><g style='display:none'>" + r + "</g>")),
              "ok");
    EXPECT_EQ(boxes_of(svg("<defs>" + r + "</defs><pattern>" + r + "</pattern><g display='none'>" + r + "</g>")), "");
    EXPECT_EQ(ids_of(svg("<g visibility='hidden'><rect id='a' width='1' height='1'/>"
                         "<rect id='b' width='1' height='1' visibility='visible'/></g>")),
              "b");
    EXPECT_EQ(
        ids_of(svg("<style>.off{display:none} #c{display:inline}</style><rect id='a' class='off' width='1' height='1'/>"
                   "<rect id='c' class='off' width='1' height='1'/>")),
        "c");
}

TEST(SvgRead, NamesOfGroups) {
    EXPECT_EQ(
        ids_of(
            svg("<g id='a'><g><a id='b'><rect id='r' width='1' height='1'/></a></g><rect width='1' height='1'/></g>")),
        "a/b/r a/");
    EXPECT_EQ(
        ids_of(svg("<g id='layer1' inkscape:groupmode='layer' inkscape:label='hair'><g id='g5' inkscape:label='lock'>"
                   "<g inkscape:label='curl'><rect width='1' height='1'/></g></g></g>")),
        "hair/layer1/g5/curl/");
    EXPECT_EQ(ids_of(svg(
                  "<defs><g id='d'><rect id='r' width='1' height='1'/></g></defs><g id='a'><use id='u' href='#d'/></g>",
                  "id='root' width='9' height='9'")),
              "a/u/d/r");
}

TEST(SvgRead, TheTreeOfGroups) {
    const std::string text =
        svg("<g id='layer1' inkscape:groupmode='layer' inkscape:label='rules'><g id='g5' inkscape:label='slide'>"
            "<g inkscape:label='left'><rect id='r' inkscape:label='box' width='1' height='1'/></g><g/></g></g>"
            "<use id='u' href='#r'/><g display='none'/><circle r='1'/>");
    const Result<SvgPicture> picture = read_svg(text, 3);
    ASSERT_TRUE(picture);
    std::string tree;
    for (const SvgGroup& group : picture->groups) {
        tree += (group.is_layer ? "layer " : "") + group.id + "/" + group.label + " in " +
                (group.parent ? std::to_string(*group.parent) : "none") + ", ";
        EXPECT_EQ(text.substr(group.span.begin - 1, 2), group.id == "u" ? "<u" : "<g");
        EXPECT_EQ(group.span.file, 3U);
    }
    EXPECT_EQ(tree, "layer layer1/rules in none, g5/slide in 0, /left in 1, / in 1, u/ in none, ");
    ASSERT_EQ(picture->shapes.size(), 3U);
    EXPECT_EQ(picture->shapes[0].label, "box");
    EXPECT_EQ(picture->shapes[0].group, 2U);
    EXPECT_EQ(picture->shapes[1].group, 4U);
    EXPECT_EQ(picture->shapes[2].group, std::nullopt);
}

TEST(SvgRead, Strokes) {
    const auto stroke_of = [](const std::string& inside, const std::string& attributes = "width='300' height='400'") {
        const SvgPicture picture = picture_of(svg(inside, attributes));
        const SvgShape& shape = picture.shapes.at(0);
        std::string text = shape.stroke ? to_text(*shape.stroke) + " " : "none ";
        append_fixed(text, shape.stroke_width, 3);
        return text;
    };
    const std::string path = "<path d='M0 0H5'/>";
    EXPECT_EQ(stroke_of(path), "none 0");
    EXPECT_EQ(stroke_of("<path d='M0 0H5' stroke='red'/>"), "#ff0000 1");
    EXPECT_EQ(stroke_of("<path d='M0 0H5' stroke='#12345680' stroke-width='2mm'/>"), "#12345680 7.559");
    EXPECT_EQ(stroke_of("<path d='M0 0H5' style='stroke-width:0.5;stroke:#00ff00;stroke-opacity:0.1'/>"),
              "#00ff00 0.5");
    EXPECT_EQ(stroke_of("<style>.a{stroke:blue;stroke-width:3}</style><g class='a'>" + path + "</g>"), "#0000ff 3");
    EXPECT_EQ(stroke_of("<g stroke='red' stroke-width='5'><path d='M0 0H5' stroke-width='0'/></g>"), "none 0");
    EXPECT_EQ(stroke_of("<g stroke='red' stroke-width='5'><path d='M0 0H5' stroke='none'/></g>"), "none 0");
    EXPECT_EQ(stroke_of("<path d='M0 0H5' stroke='url(#gradient)'/>"), "#000000 1");
    EXPECT_EQ(stroke_of("<g color='teal'><path d='M0 0H5' stroke='currentColor'/></g>"), "#008080 1");
    // Percentages are of the viewport's diagonal, transforms count by what they do to areas.
    EXPECT_EQ(stroke_of("<path d='M0 0H5' stroke='red' stroke-width='10%'/>"), "#ff0000 35.355");
    EXPECT_EQ(stroke_of("<g transform='scale(2,8)' stroke='red'><path d='M0 0H5' transform='rotate(30)'/></g>"),
              "#ff0000 4");
    EXPECT_EQ(stroke_of("<g transform='scale(1e9)'><path d='M0 0' stroke='red' stroke-width='1e300'/></g>"), "none 0");
    EXPECT_EQ(stroke_of("<g transform='scale(-3,3)' stroke='red'>" + path + "</g>"), "#ff0000 3");
    EXPECT_EQ(stroke_of("<path d='M0 0H5' stroke='red'/>", "width='100mm' height='100mm' viewBox='0 0 100 100'"),
              "#ff0000 3.78");
}

// The labels of a text: "groups/id 'text' x y".
std::string labels_of(const std::string& text) {
    const Result<SvgPicture> picture = read_svg(text, 0, SvgPurpose::drawing);
    if (!picture) return picture.diagnostics()[0].code;
    std::string all;
    for (const SvgLabel& label : picture->labels) {
        if (!all.empty()) all += ", ";
        for (const std::string& group : label.groups) all += group + "/";
        all += label.id + " '" + label.text + "' " + to_text(label.place.x) + " " + to_text(label.place.y);
    }
    for (const Diagnostic& diagnostic : picture.diagnostics()) all += "; " + diagnostic.code;
    return all;
}

TEST(SvgRead, Labels) {
    EXPECT_EQ(labels_of(svg("<text x='3' y='4'>a</text>")), " 'a' 3 4");
    EXPECT_EQ(labels_of(svg("<text id='t'> \n two  \t words </text>")), "t 'two words' 0 0");
    EXPECT_EQ(labels_of(svg("<g id='g' transform='translate(10,20)'><text id='t' x='3' y='4' "
                            "transform='scale(2)'>a</text></g>")),
              "g/t 'a' 16 28");
    // As Inkscape writes them.
    EXPECT_EQ(
        labels_of(svg("<text xml:space='preserve' style='font-size:4px' x='1' y='2' id='text1'>"
                      "<tspan sodipodi:role='line' id='tspan1' x='5' y='6'>first</tspan>"
                      "<tspan sodipodi:role='line' id='tspan2' x='5' y='11'>second<tspan>ly</tspan></tspan></text>",
                      "xmlns:sodipodi='urn:s' width='9' height='9'")),
        "text1 'first secondly' 5 6");
    // The first letter's place; where a tspan says one coordinate, the text says the other.
    EXPECT_EQ(labels_of(svg("<text x='1 2,3' y='2'><tspan x='9'/><tspan x='5'>a<tspan x='7'>b</tspan></tspan></text>")),
              " 'ab' 5 2");
    EXPECT_EQ(labels_of(svg("<text x='1,2' y='10%'>a<tspan x='5'>b</tspan></text>")), " 'ab' 1 10");
    EXPECT_EQ(labels_of(svg("<text>a<title>no</title><a href='#x'>b</a>&amp;<![CDATA[<]]></text>")), " 'ab&<' 0 0");
    EXPECT_EQ(labels_of(svg("<defs><text id='t'>a</text></defs><use id='u' href='#t' x='7'/>")), "u/t 'a' 7 0");
    EXPECT_EQ(labels_of(svg("<style>g text{stroke:red} h1 p{fill:red}</style>")),
              "; svg.style-left-out; svg.style-left-out");
    EXPECT_EQ(codes_of(svg("<style>g text{stroke:red} h1 p{fill:red}</style>")), "ok style-left-out");
    // What is not seen says nothing; what else is text is left out as ever.
    EXPECT_EQ(labels_of(svg("<text/><text> </text><text display='none'>a</text><text visibility='hidden'>a</text>"
                            "<defs><text>a</text></defs><flowRoot>a</flowRoot>")),
              "; svg.text-left-out");
    EXPECT_EQ(labels_of(svg("<text x='one'>a</text>")), "svg.bad-length");
    EXPECT_EQ(labels_of(svg("<text x='1e300'>a</text>")), "svg.out-of-range");
    EXPECT_TRUE(picture_of(svg("<text x='3' y='4'>a</text>")).labels.empty());
}

TEST(SvgRead, TextsThatGrowWithoutBound) {
    std::string spans, copies;
    for (int i = 0; i < 2000; ++i) spans += "<tspan/>";
    for (int i = 0; i < 1000; ++i) copies += "<use href='#t'/>";
    EXPECT_EQ(labels_of(svg("<defs><text id='t'>" + spans + "a</text></defs>" + copies)), "svg.too-many-elements");
    copies = "";
    for (int i = 0; i < 5000; ++i) copies += "<use href='#t'/>";
    EXPECT_EQ(labels_of(svg("<defs><text id='t'>" + std::string(400'000, ' ') + "a</text></defs>" + copies)),
              "svg.too-large");
}

TEST(SvgRead, Switch) {
    EXPECT_EQ(ids_of(svg("<switch><g requiredExtensions='http://x'><rect id='a' width='1' height='1'/></g>"
                         "<g systemLanguage='de, fr'><rect id='b' width='1' height='1'/></g>"
                         "<g systemLanguage='fr, en-GB'><rect id='c' width='1' height='1'/></g>"
                         "<rect id='d' width='1' height='1'/></switch>")),
              "c");
}

TEST(SvgRead, PrefixesAndForeignElements) {
    EXPECT_EQ(
        ids_of("<s:svg xmlns:s='http://www.w3.org/2000/svg'><s:g><s:rect id='a' width='1' height='1'/></s:g></s:svg>"),
        "a");
    EXPECT_EQ(ids_of("<svg><rect id='bare' width='1' height='1'/></svg>"), "bare");
    EXPECT_EQ(ids_of(svg("<x:rect xmlns:x='urn:x' id='a' width='1' height='1'/><g xmlns='urn:y'><rect id='b' width='1' "
                         "height='1'/></g>"
                         "<rect id='c' width='1' height='1'/>")),
              "c");
    // As Illustrator writes its files.
    EXPECT_EQ(
        ids_of("<?xml version='1.0'?><!DOCTYPE svg PUBLIC '-//W3C//DTD SVG 1.1//EN' 'x.dtd' [<!ENTITY ns_svg "
               "\"http://www.w3.org/2000/svg\">]><svg xmlns='&ns_svg;'><rect id='a' width='1' height='1'/></svg>"),
        "a");
}

TEST(SvgRead, EntitiesAreHarmless) {
    std::string bomb = "<!DOCTYPE svg [<!ENTITY a0 \"ha\">";
    for (int i = 1; i < 30; ++i) {
        const std::string before = "&a" + std::to_string(i - 1) + ";";
        bomb += "<!ENTITY a" + std::to_string(i) + " \"" + before + before + before + "\">";
    }
    EXPECT_EQ(ids_of(bomb + "<!ENTITY x SYSTEM \"file:///etc/passwd\">]>" +
                     svg("<rect id='&a29;&x;' width='1' height='1'/>")),
              "&a29;&x;");
}

TEST(SvgRead, ErrorsSayWhere) {
    const std::string text =
        svg("<rect id='ok' width='1' height='1'/><rect id='bad' width='one' height='-1'/>"
            "<path d='M0 0L5'/><g transform='turn(5)'/>");
    const Result<SvgPicture> picture = read_svg(text, 7);
    ASSERT_FALSE(picture);
    ASSERT_EQ(picture.diagnostics().size(), 4U);
    const auto& wrong = picture.diagnostics();
    const auto place = [&](std::size_t i) {
        return text.substr(wrong[i].span.begin, wrong[i].span.end - wrong[i].span.begin);
    };
    EXPECT_EQ(wrong[0].code, "svg.bad-length");
    EXPECT_EQ(wrong[0].message, "the width of rect 'bad' is no length: 'one'");
    EXPECT_EQ(place(0), "one");
    EXPECT_EQ(wrong[0].span.file, 7U);
    EXPECT_EQ(wrong[1].code, "svg.negative-size");
    EXPECT_EQ(place(1), "-1");
    const std::size_t data = text.find("M0 0L5");
    EXPECT_GE(wrong[2].span.begin, data);
    EXPECT_LE(wrong[2].span.end, data + 6);
    EXPECT_EQ(wrong[3].code, "svg.bad-transform");
    EXPECT_EQ(place(3), "turn(5)");
}

TEST(SvgRead, MalformedInput) {
    const Result<SvgPicture> picture = read_svg("<svg><g></svg>");
    ASSERT_FALSE(picture);
    EXPECT_EQ(picture.diagnostics()[0].code, "svg.bad-xml");
    EXPECT_NEAR(picture.diagnostics()[0].span.begin, 9, 3);
    for (const char* text : {"", "   ", "no xml", "<svg", "<svg><rect width='1", "<svg><!-- ", "<svg>&", "\xff\xfe<"}) {
        EXPECT_FALSE(read_svg(text)) << text;
    }
    EXPECT_EQ(codes_of("<html/>"), "wrong not-svg");
    EXPECT_EQ(codes_of("<svg xmlns='urn:x'/>"), "wrong not-svg");
    EXPECT_EQ(codes_of(svg("", "width='-5' height='5'")), "wrong negative-size");
    EXPECT_EQ(codes_of(svg("", "width='0' height='5'")), "wrong bad-size");
    EXPECT_EQ(codes_of(svg("", "viewBox='0 0 x 5'")), "wrong bad-view-box");
    EXPECT_EQ(codes_of(svg("", "viewBox='0 0 1e300 5'")), "wrong bad-size");
    EXPECT_EQ(codes_of(svg("", "viewBox='1e300 0 5 5'")), "wrong bad-size");
    EXPECT_EQ(codes_of(svg("<polygon points='1 2 3'/>")), "wrong odd-points");
    EXPECT_EQ(codes_of(svg("<polygon points='1 2 x 3'/>")), "wrong bad-number");
    EXPECT_EQ(codes_of(svg("<rect width='NaN' height='1'/>")), "wrong bad-length");
    EXPECT_EQ(codes_of(svg("<svg viewBox='0 0 0 0' preserveAspectRatio='so'/>")),
              "wrong bad-view-box bad-aspect-ratio");
}

TEST(SvgRead, CoordinatesBeyondThePlane) {
    for (const char* shape :
         {"<rect id='r' x='2e9' width='1' height='1'/>", "<rect id='r' x='1e308' width='1e308' height='1'/>",
          "<circle id='r' r='1e10'/>", "<path id='r' d='M0 0L1e300 0'/>", "<path id='r' d='M0 0A1e300 1 0 0 1 5 5'/>",
          "<rect id='r' width='1' height='1' transform='scale(1e300) scale(1e300)'/>",
          "<rect id='r' width='9' height='9' transform='translate(0,-1.1e9)'/>",
          "<path id='r' d='M0 0Q5 5e9 10 10'/>"}) {
        const Result<SvgPicture> picture = read_svg(svg(shape));
        ASSERT_FALSE(picture) << shape;
        EXPECT_EQ(picture.diagnostics()[0].code, "svg.out-of-range") << shape;
        EXPECT_NE(picture.diagnostics()[0].message.find("'r'"), std::string::npos) << shape;
    }
    EXPECT_EQ(codes_of(svg("<rect x='-1073741824' width='2147483648' height='1'/>")), "ok");
}

TEST(SvgRead, Warnings) {
    const Result<SvgPicture> picture =
        read_svg("<?xml-stylesheet href='a.css'?>" +
                 svg("<style>g rect{fill:none}</style><text>a</text><text>b</text><image href='http://x/y.png'/>"
                     "<g clip-path='url(#c)' style='mask:url(#m)'><rect width='1' height='1' filter='url(#f)'/></g>"
                     "<circel r='5'/><g style='transform:scale(2)'/>"));
    ASSERT_TRUE(picture);
    std::string all;
    for (const Diagnostic& warning : picture.diagnostics()) {
        EXPECT_EQ(warning.severity, Severity::warning);
        all += warning.code + ": " + warning.message + "\n";
    }
    EXPECT_EQ(all,
              "svg.external-style: a style sheet outside of this file is not read\n"
              "svg.text-left-out: text is left out (2 times)\n"
              "svg.image-left-out: 'image' is left out\n"
              "svg.effect-left-out: a clip path is left out: the shapes are taken whole\n"
              "svg.effect-left-out: a mask is left out: the shapes are taken whole\n"
              "svg.effect-left-out: a filter is left out: the shapes are taken whole\n"
              "svg.unknown-element: 'circel' is no element of SVG and left out\n"
              "svg.effect-left-out: a transform in a style is left out\n"
              "svg.style-left-out: this part of a style sheet is left out: 'g rect'\n");
}

TEST(SvgRead, Depth) {
    const auto nested = [](int levels) {
        std::string open, close;
        for (int i = 1; i < levels; ++i) {
            open += "<g>";
            close += "</g>";
        }
        return codes_of(svg(open + "<rect width='1' height='1'/>" + close));
    };
    EXPECT_EQ(nested(200), "ok");
    EXPECT_EQ(nested(201), "wrong too-deep");
    EXPECT_EQ(nested(100'000), "wrong too-deep");
}

}  // namespace
}  // namespace filigree
