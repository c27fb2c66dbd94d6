#include "engines/shape/drawn_rules.h"

#include <gtest/gtest.h>

#include <string>

#include "base/number_text.h"
#include "formats/files.h"

namespace filigree::shape {
namespace {

// As Inkscape begins a file.
std::string svg(const std::string& inside) {
    return "<svg width='210' height='297' viewBox='0 0 210 297' version='1.1' id='svg1' "
           "xmlns:inkscape='http://www.inkscape.org/namespaces/inkscape' "
           "xmlns:sodipodi='http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd' xmlns='http://www.w3.org/2000/svg'>"
           "<sodipodi:namedview id='namedview1' pagecolor='#ffffff'/><defs id='defs1'/>" +
           inside + "</svg>";
}
std::string group(const std::string& label, const std::string& inside, const std::string& more = "") {
    return "<g inkscape:label='" + label + "' " + more + ">" + inside + "</g>";
}
std::string path(const std::string& data, const std::string& more = "style='fill:none;stroke:#000000'") {
    return "<path d='" + data + "' " + more + "/>";
}
std::string rule(const std::string& inside, const std::string& name = "slide") { return svg(group(name, inside)); }

SvgPicture picture_of(const std::string& text) {
    Result<SvgPicture> picture = read_svg(text, 0, SvgPurpose::drawing);
    EXPECT_TRUE(picture) << text << "\n" << (picture ? "" : picture.diagnostics()[0].message);
    return picture ? *std::move(picture) : SvgPicture{};
}

// "M0 0L1 0 #ff0000 2, 'a' 3 4": what is not usual of colour and weight.
std::string text_of(const DrawnSide& side) {
    std::string text;
    const auto next = [&] { text += text.empty() ? "" : ", "; };
    for (const DrawnPath& one : side.paths) {
        next();
        text += to_path_data(one.path);
        if (one.colour) text += " " + to_text(*one.colour);
        if (one.weight != 1) text += " " + to_text(one.weight);
    }
    for (const DrawnLabel& label : side.labels) {
        next();
        text += "'" + label.text + "' " + to_text(label.place.x) + " " + to_text(label.place.y);
    }
    return text;
}
std::string text_of(const DrawnRule& rule) {
    std::string text = rule.name + ": " + text_of(rule.left) + " -> " + text_of(rule.right);
    for (const DrawnSide& condition : rule.conditions) text += "; unless " + text_of(condition);
    for (const Path& region : rule.regions) text += "; void " + to_path_data(region);
    return text;
}
// The rules of a text, a line each, or what is wrong; warnings behind.
std::string rules_of(const std::string& text, const DrawnOptions& options = {}) {
    const auto rules = drawn_rules(picture_of(text), options);
    std::string all;
    if (rules) {
        for (const DrawnRule& one : *rules) all += (all.empty() ? "" : "\n") + text_of(one);
    }
    for (const Diagnostic& diagnostic : rules.diagnostics()) {
        all += (all.empty() ? "" : "\n") + diagnostic.code + ": " + diagnostic.message;
    }
    return all;
}
std::string below(const std::string& text, const std::string& name, const DrawnOptions& options = {}) {
    const auto side = drawn_below(picture_of(text), name, options);
    return side ? text_of(*side) : side.diagnostics()[0].message;
}

const std::string left = group("left", path("M0 0H2")), right = group("right", path("M0 0V2"));
const std::string usual = "slide: M0 0L2 0 -> M0 0L0 2";

// A mark at (x, 0).
std::string mark(int x) {
    return "<rect inkscape:label='origin' x='" + std::to_string(x - 1) + "' y='-1' width='2' height='2'/>";
}

TEST(DrawnRules, NamesOfSides) {
    EXPECT_EQ(rules_of(rule(left + right)), usual);
    EXPECT_EQ(rules_of(rule(right + left)), usual);
    EXPECT_EQ(rules_of(rule(group("Right", path("M0 0V2")) + group(" LEFT", path("M0 0H2")))), usual);
    for (const auto& [a, b] :
         {std::pair("a", "b"), {"alpha", "beta"}, {"lhs", "rhs"}, {"α", "β"}, {"left-3", "right_2"}}) {
        EXPECT_EQ(rules_of(rule(group(b, path("M0 0V2")) + group(a, path("M0 0H2")))), usual) << a;
    }
    // By id, and by their order.
    EXPECT_EQ(rules_of(rule("<g id='right-7'>" + path("M0 0V2") + "</g><g id='left-7'>" + path("M0 0H2") + "</g>")),
              usual);
    EXPECT_EQ(rules_of(rule("<g id='g2'>" + path("M0 0H2") + "</g><g id='g1'>" + path("M0 0V2") + "</g>")), usual);
    // A side may be empty on the right.
    EXPECT_EQ(rules_of(rule(left + "<g inkscape:label='right'/>")), "slide: M0 0L2 0 -> ");
}

TEST(DrawnRules, NamesOfRules) {
    EXPECT_EQ(rules_of(svg("<g id='g5' inkscape:label=' my rule '>" + left + right + "</g>")),
              "my rule: M0 0L2 0 -> M0 0L0 2");
    EXPECT_EQ(rules_of(svg("<g id='g5'>" + left + right + "</g>")), "g5: M0 0L2 0 -> M0 0L0 2");
    EXPECT_EQ(rules_of(svg(group("x", left + right) + "<g>" + left + right + "</g>")),
              "x: M0 0L2 0 -> M0 0L0 2\nrule2: M0 0L2 0 -> M0 0L0 2");
}

TEST(DrawnRules, WhereRulesStand) {
    const std::string layer = "inkscape:groupmode='layer' id='layer1'",
                      plain = "<g>" + path("M0 0H2") + "</g><g>" + path("M0 0V2") + "</g>";
    // In layers, in groups of rules, or as layers whose layers are the sides.
    EXPECT_EQ(rules_of(svg(group("all", group("slide", plain) + group("turn", plain), layer))),
              usual + "\nturn: M0 0L2 0 -> M0 0L0 2");
    EXPECT_EQ(rules_of(svg(group("page", group("slide", left + right) + group("turn", left + right)))),
              usual + "\nturn: M0 0L2 0 -> M0 0L0 2");
    EXPECT_EQ(
        rules_of(svg(group("slide", group("left", path("M0 0H2"), layer) + group("right", path("M0 0V2")), layer))),
        usual);
    EXPECT_EQ(rules_of(svg("<g transform='scale(2)'>" + group("slide", plain) + "</g>")),
              "slide: M0 0L4 0 -> M0 0L0 4");
    // Groups in sides are no rules.
    EXPECT_EQ(rules_of(rule("<g>" + plain + "</g><g>" + path("M0 0V2") + "</g>")),
              "slide: M0 0L2 0, M0 0L0 2 -> M0 0L0 2");
    EXPECT_EQ(rules_of(svg(group("notes", group("x", left + right)) + group("slide", left + right))), usual);
    // Shapes of their own.
    EXPECT_EQ(rules_of(svg(group("petal", path("M5 5H6")) + path("M7 7H8") + group("slide", left + right))), usual);
}

TEST(DrawnRules, TransformsAreApplied) {
    EXPECT_EQ(rules_of(svg("<g inkscape:groupmode='layer' transform='translate(10,20)'><g inkscape:label='slide' "
                           "transform='scale(2)'><g inkscape:label='left' transform='matrix(0,1,-1,0,0,0)'>" +
                           path("M1 2L3 4") + "</g>" + group("right", path("M1 2L3 4", "transform='translate(-4)'")) +
                           "</g></g>")),
              "slide: M6 22L2 26 -> M4 24L8 28");
}

TEST(DrawnRules, OriginsOfSides) {
    const auto cross = [](int x, int y) {
        const std::string at = std::to_string(x), on = std::to_string(y);
        return group("origin",
                     "<g>" + path("M" + at + " " + on + "m-3 0h6") + "</g>" + path("M" + at + " " + on + "m0 -4v8"));
    };
    const std::string l = path("M12 10H14"), r = path("M50 10V12");
    EXPECT_EQ(rules_of(rule(group("left", cross(10, 10) + l) + group("right", r + cross(50, 9)))),
              "slide: M2 0L4 0 -> M0 1L0 3");
    // Any shape, by its box; also by id, made unique; a text by its place.
    EXPECT_EQ(rules_of(rule(group("left", l + "<path id='origin' d='M8 10Q10 6 12 10A2 2 0 0 1 8 10'/>") +
                            group("right", r + "<circle id='origin-5' cx='50' cy='9' r='3'/>"))),
              "slide: M2 0L4 0 -> M0 1L0 3");
    EXPECT_EQ(rules_of(rule(group("left", l + "<text id='Origin' x='10' y='10'>+</text>") +
                            group("right", r + "<text id='origin2' x='50' y='9'>+</text>"))),
              "slide: M2 0L4 0 -> M0 1L0 3");
    // One beside the sides serves both; a side's own goes before.
    EXPECT_EQ(rules_of(rule(group("left", l) + cross(10, 10) + group("right", r))), "slide: M2 0L4 0 -> M40 0L40 2");
    EXPECT_EQ(rules_of(rule(group("left", l) + cross(10, 10) + group("right", r + cross(50, 9)))),
              "slide: M2 0L4 0 -> M0 1L0 3");
    EXPECT_EQ(rules_of(rule(group("left", l) + group("right", r + cross(50, 9)))),
              "shape.one-origin: of the rule 'slide' only the right side has a mark 'origin'");
}

TEST(DrawnRules, SidesThatLieApart) {
    EXPECT_EQ(rules_of(rule(left + group("right", path("M50 0V2")))),
              "slide: M0 0L2 0 -> M50 0L50 2\n"
              "shape.sides-apart: the sides of the rule 'slide' lie apart on the page, and so will they be put");
}

TEST(DrawnRules, WhatBelongsToBothSides) {
    EXPECT_EQ(rules_of(rule(path("M5 5H6") + left + group("frame", path("M7 7H8")) + right)),
              "slide: M5 5L6 5, M7 7L8 7, M0 0L2 0 -> M5 5L6 5, M7 7L8 7, M0 0L0 2");
    // It lies as the left side does.
    EXPECT_EQ(rules_of(rule(path("M11 0H12") + group("left", mark(10) + path("M10 0H12")) +
                            group("right", mark(50) + path("M50 0V2")))),
              "slide: M1 0L2 0, M0 0L2 0 -> M1 0L2 0, M0 0L0 2");
    EXPECT_EQ(rules_of(rule(path("M5 5H6") + "<g inkscape:label='left'/>" + right)),
              "slide: M5 5L6 5 -> M5 5L6 5, M0 0L0 2");
}

TEST(DrawnRules, ConditionsAndRegions) {
    EXPECT_EQ(rules_of(rule(left + right + group("unless there", path("M1 0H2") + path("M1 1H2")) +
                            group("void", path("M3 3h1v1z")) + path("M9 9H8", "inkscape:label='Unless 2'"))),
              usual + "; unless M1 0L2 0, M1 1L2 1; unless M9 9L8 9; void M3 3L4 3L4 4Z");
    // Where they lie: as the side around them, else as the left one, else by a mark of their own.
    const std::string l = mark(10) + path("M10 0H12"), r = mark(50) + path("M50 0V2");
    const std::string moved = "slide: M0 0L2 0 -> M0 0L0 2; ";
    EXPECT_EQ(rules_of(rule(group("left", l) + group("right", r) + group("unless", path("M11 0H12")))),
              moved + "unless M1 0L2 0");
    EXPECT_EQ(rules_of(rule(group("left", l) + group("right", r + group("unless", path("M51 0H52"))))),
              moved + "unless M1 0L2 0");
    EXPECT_EQ(rules_of(rule(group("left", l + "<rect inkscape:label='void' x='12' y='1' width='1' height='2'/>") +
                            group("right", r))),
              moved + "void M2 1L3 1L3 3L2 3Z");
    EXPECT_EQ(rules_of(rule(group("left", l) + group("right", r) +
                            group("unless", mark(90) + "<text x='91' y='2'>k</text>"))),
              moved + "unless 'k' 1 2");
    EXPECT_EQ(rules_of(rule(left + right + group("unless", ""))), usual);
    // Closed by their data alone, or not.
    EXPECT_EQ(rules_of(rule(left + right + path("M3 3h1v1L3 3M0 0H1H0", "id='void5'"))),
              usual + "; void M3 3L4 3L4 4L3 3M0 0L1 0L0 0");
    for (const char* open : {"M3 3h1v1", "M3 3h1v1zM0 0H1", "M0 0H1M3 3h1v1z", "M3 3h1v1zL5 5"}) {
        EXPECT_EQ(rules_of(rule(left + right + path(open, "id='void5'"))),
                  "shape.open-region: a void region of the rule 'slide' is no closed path")
            << open;
    }
}

TEST(DrawnRules, LabelsAndNotes) {
    const std::string p = "<text x='1' y='2'><tspan sodipodi:role='line' x='3' y='4'>p</tspan></text>";
    EXPECT_EQ(rules_of(rule("<text>slide: moves it</text><text x='9'>→</text>" + group("left", p) +
                            group("right", path("M0 0V2") + p))),
              "slide: 'p' 3 4 -> M0 0L0 2, 'p' 3 4");
    EXPECT_EQ(rules_of(rule(group("notes", path("M9 9H8") + p) +
                            group("left", path("M0 0H2") + path("M9 9H8", "id='note-1'")) + right +
                            path("M4 4H5", "inkscape:label='Notes'"))),
              usual);
    EXPECT_EQ(rules_of(rule(group("left", path("M0 0H2") + group("notes", group("void", path("M0 0H2")) +
                                                                              group("origin", path("M0 0H2")))) +
                            right)),
              usual);
}

TEST(DrawnRules, ColoursAndWidths) {
    const std::string red = "stroke='red' stroke-width='3'", blue = "style='stroke:blue;stroke-width:0.5'";
    // One colour is none; those of notes, marks and regions do not count.
    EXPECT_EQ(rules_of(rule(group("left", path("M0 0H2", red)) +
                            group("right", path("M0 0V2", red) + path("M0 0V3", "fill='red'")) +
                            group("notes", path("M0 0H2", blue)) + group("void", path("M0 0H2z", blue)))),
              "slide: M0 0L2 0 -> M0 0L0 2, M0 0L0 3; void M0 0L2 0Z");
    const std::string two =
        rule(group("left", path("M0 0H2", red)) + group("right", path("M0 0V2", blue) + path("M0 0V3", "fill='red'")));
    EXPECT_EQ(rules_of(two), "slide: M0 0L2 0 #ff0000 -> M0 0L0 2 #0000ff, M0 0L0 3");
    EXPECT_EQ(rules_of(two, {true}), "slide: M0 0L2 0 #ff0000 3 -> M0 0L0 2 #0000ff 0.5, M0 0L0 3");
    // Of the whole file.
    EXPECT_EQ(rules_of(svg(group("slide", left + right) + path("M7 7H8", red))),
              "slide: M0 0L2 0 #000000 -> M0 0L0 2 #000000");
}

TEST(DrawnRules, WhatIsWrong) {
    EXPECT_EQ(rules_of(svg("")), "shape.no-drawn-rule: no group of the drawing is a rule");
    EXPECT_EQ(rules_of(svg(path("M0 0H2"))), "shape.no-drawn-rule: no group of the drawing is a rule");
    EXPECT_EQ(rules_of(rule(left)), "shape.one-side: the group 'slide' has no group 'right'");
    EXPECT_EQ(rules_of(rule(right + "<g/>")), "shape.one-side: the group 'slide' has no group 'left'");
    EXPECT_EQ(rules_of(rule(left + right + right)), "shape.side-twice: the group 'slide' has two groups 'right'");
    EXPECT_EQ(rules_of(rule("<g inkscape:label='left'/>" + right)),
              "shape.empty-left-side: the left side of the rule 'slide' is empty");
    EXPECT_EQ(rules_of(svg(group("slide", left + right) + group("slide", left + right))),
              "shape.rule-twice: there are two rules 'slide' in the drawing");
    // All at once; what may be no rule is a warning.
    EXPECT_EQ(
        rules_of(svg(group("slide", left) + "<g>" + right + "</g>" + group("petals", "<g/>") +
                     group("three", "<g/><g/><g/>"))),
        "shape.one-side: the group 'slide' has no group 'right'\n"
        "shape.one-side: a group without a name has no group 'left'\n"
        "shape.no-sides: the group 'petals' holds 1 group, none called 'left' or 'right', and is taken for no rule\n"
        "shape.no-sides: the group 'three' holds 3 groups, none called 'left' or 'right', and is taken for no rule");
    EXPECT_EQ(rules_of(svg(group("petals", "<g/>") + group("slide", left + right))),
              usual +
                  "\nshape.no-sides: the group 'petals' holds 1 group, none called 'left' or 'right', and is taken for "
                  "no rule");
    const std::string text = svg(group("slide", left));
    const auto rules = drawn_rules(picture_of(text));
    ASSERT_FALSE(rules);
    EXPECT_EQ(rules.diagnostics()[0].span.begin, text.find("g inkscape:label='slide'"));
}

TEST(DrawnBelow, ByIdLabelOrGroup) {
    const std::string text = svg("<g id='g1' inkscape:label='petal'>" + path("M0 0H2", "id='p'") + "<g id='g2'>" +
                                 path("M0 0V2", "inkscape:label='p'") + "</g><text x='1' y='2' id='t'>k</text></g>" +
                                 path("M5 5H6") + "<g id='empty'/>");
    EXPECT_EQ(below(text, "petal"), "M0 0L2 0, M0 0L0 2, 'k' 1 2");
    EXPECT_EQ(below(text, "g1"), below(text, "petal"));
    EXPECT_EQ(below(text, "g2"), "M0 0L0 2");
    EXPECT_EQ(below(text, "p"), "M0 0L2 0, M0 0L0 2");
    EXPECT_EQ(below(text, "t"), "'k' 1 2");
    EXPECT_EQ(below(text, ""), "M0 0L2 0, M0 0L0 2, M5 5L6 5, 'k' 1 2");
    EXPECT_EQ(below(text, "empty"), "the drawing has nothing called 'empty'");
    EXPECT_EQ(below(svg(""), ""), "the drawing is empty");
    const auto wrong = drawn_below(picture_of(text), "pteal");
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.diagnostics()[0].hints, (std::vector<std::string>{"did you mean 'petal'?"}));
}

TEST(DrawnBelow, MarksAndNotes) {
    const std::string text =
        svg(group("petal", path("M10 20H12") + group("origin", path("M5 20h10")) + group("notes", path("M0 0H2")) +
                               group("unless", path("M0 0H2")) + path("M0 0H2", "id='void'")));
    EXPECT_EQ(below(text, "petal"), "M0 0L2 0");
    // What is asked for is drawn, whatever it is called.
    EXPECT_EQ(below(text, "notes"), "M0 0L2 0");
    EXPECT_EQ(below(text, "origin"), "M5 20L15 20");
    EXPECT_EQ(below(svg(path("M0 0H2", "stroke='red' stroke-width='3'")), "", {true}), "M0 0L2 0 3");
}

TEST(DrawnRules, TheExample) {
    const auto text = read_file(FILIGREE_SOURCE_DIR "/examples/shape/petal-rules.svg");
    ASSERT_TRUE(text);
    const Result<SvgPicture> picture = read_svg(*text, 0, SvgPurpose::drawing);
    ASSERT_TRUE(picture);
    EXPECT_TRUE(picture.diagnostics().empty());
    const auto rules = drawn_rules(*picture);
    ASSERT_TRUE(rules);
    EXPECT_TRUE(rules.diagnostics().empty());
    ASSERT_EQ(rules->size(), 2U);
    const auto expect_like = [](const DrawnSide& side, const std::string& data) {
        const Result<Path> wanted = parse_path_data(data);
        ASSERT_TRUE(wanted);
        Path all;
        for (const DrawnPath& one : side.paths) {
            EXPECT_FALSE(one.colour);
            all.verbs.insert(all.verbs.end(), one.path.verbs.begin(), one.path.verbs.end());
            all.points.insert(all.points.end(), one.path.points.begin(), one.path.points.end());
        }
        EXPECT_TRUE(side.labels.empty());
        ASSERT_EQ(all.verbs, wanted->verbs);
        for (std::size_t i = 0; i < all.points.size(); ++i) {
            EXPECT_LT(length(all.points[i] - wanted->points[i]), 1e-14) << data;
        }
    };
    EXPECT_EQ((*rules)[0].name, "slide");
    expect_like((*rules)[0].left, "M-1 -1Q1 -3 3 3M-1 -1Q-3 1 3 3");
    expect_like((*rules)[0].right, "M-3 -3Q-1 -5 1 1M-3 -3Q-5 -1 1 1");
    EXPECT_EQ((*rules)[1].name, "grow");
    expect_like((*rules)[1].left, "M-1 -1Q0 -2 1 -1Q2 0 1 1Q0 2 -1 1Q-2 0 -1 -1Z");
    const double r = 1.5 * 1.4142135623730951;
    const std::string n = to_text(r), m = to_text(-r);
    expect_like((*rules)[1].right, "M0 " + m + "Q" + n + " " + m + " " + n + " 0Q" + n + " " + n + " 0 " + n + "Q" + m +
                                       " " + n + " " + m + " 0Q" + m + " " + m + " 0 " + m + "Z");
}

}  // namespace
}  // namespace filigree::shape
