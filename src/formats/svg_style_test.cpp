#include "formats/svg_style.h"

#include <gtest/gtest.h>

namespace filigree {
namespace {

// What the sheet and the element together say for `fill`.
std::string fill_of(const char* sheet, const char* element) {
    CssSheets sheets;
    sheets.add(sheet);
    pugi::xml_document document;
    EXPECT_TRUE(document.load_string(element));
    return std::string(sheets.values_at(document.document_element())[CssProperty::fill]);
}

TEST(SvgStyle, Cascade) {
    EXPECT_EQ(fill_of("", "<rect fill='red'/>"), "red");
    EXPECT_EQ(fill_of("rect{fill:blue}", "<rect fill='red'/>"), "blue");
    EXPECT_EQ(fill_of("*{fill:blue}", "<rect fill='red'/>"), "blue");
    EXPECT_EQ(fill_of("rect{fill:blue}", "<rect fill='red' style='fill:green'/>"), "green");
    EXPECT_EQ(fill_of("rect{fill:blue!important}", "<rect style='fill:green'/>"), "blue");
    EXPECT_EQ(fill_of("rect{fill:blue ! IMPORTANT}", "<rect style='fill:green !important'/>"), "green");
    EXPECT_EQ(fill_of("rect{fill:blue} .a{fill:a} #i{fill:i}", "<rect class='a' id='i'/>"), "i");
    EXPECT_EQ(fill_of("#i{fill:i} .a{fill:a} rect{fill:blue}", "<rect class='a' id='i'/>"), "i");
    EXPECT_EQ(fill_of(".a{fill:a} .b{fill:b}", "<rect class='b a'/>"), "b");
    EXPECT_EQ(fill_of(".a.b{fill:ab} .b{fill:b}", "<rect class=' b\ta '/>"), "ab");
    EXPECT_EQ(fill_of("rect.a{fill:ra} .a{fill:a}", "<rect class='a'/>"), "ra");
    EXPECT_EQ(fill_of("circle.a{fill:ra} .a{fill:a}", "<rect class='a'/>"), "a");
    EXPECT_EQ(fill_of("circle, rect , .x{fill:one}", "<rect/>"), "one");
    EXPECT_EQ(fill_of("rect{fill:one;fill:two}", "<rect/>"), "two");
    EXPECT_EQ(fill_of("rect{fill:one} rect{stroke:red}", "<rect/>"), "one");
    EXPECT_EQ(fill_of(".ab{fill:one}", "<rect class='a b'/>"), "");
}

TEST(SvgStyle, Syntax) {
    EXPECT_EQ(fill_of("/* rect{fill:no} */ rect{/*x*/fill/**/:/*y*/ one /*z*/}", "<rect/>"), "one");
    EXPECT_EQ(fill_of("<!-- rect{FILL:one} -->", "<rect/>"), "one");
    EXPECT_EQ(fill_of("rect{font:'a;}fill:no';fill:url(\"a;b}\")}", "<rect/>"), "url(\"a;b}\")");
    EXPECT_EQ(fill_of("@import url(x;y.css); @media print{rect{fill:no}} rect{fill:one", "<rect/>"), "one");
    EXPECT_EQ(fill_of("@font-face{src:url('}')} rect{fill:one}", "<rect/>"), "one");
    EXPECT_EQ(fill_of("rect{fill;fill:;:x;fill:one;;}", "<rect/>"), "one");
    EXPECT_EQ(fill_of("}} rect{fill:one}", "<rect/>"), "one");
    EXPECT_EQ(fill_of("", "<rect style='/*a*/ fill : one /*b*/; stroke:x'/>"), "one");
    EXPECT_EQ(fill_of("rect{", "<rect/>"), "");
    EXPECT_EQ(fill_of("rect{fill:", "<rect/>"), "");
    EXPECT_EQ(fill_of("{fill:no}", "<rect/>"), "");
}

TEST(SvgStyle, NamesWhatIsLeftOut) {
    CssSheets sheets;
    sheets.add(
        "g rect{fill:a} g>rect{fill:a} rect:hover{fill:a} a[b='c,d']{fill:a} g rect{fill:b} @media print{} h1 "
        "p{color:red}");
    EXPECT_EQ(sheets.left_out(),
              (std::vector<std::string>{"g rect", "g>rect", "rect:hover", "a[b='c,d']", "@media print"}));
    EXPECT_EQ(sheets.strokes_left_out(), (std::vector<std::string>{"h1 p"}));
    EXPECT_EQ(sheets.rule_count(), 0U);
}

TEST(SvgStyle, Inheritance) {
    const auto say = [](SvgPaint parent, CssProperty property, std::string_view value) {
        CssValues said;
        said.of[static_cast<std::size_t>(property)] = value;
        return inherited(parent, said);
    };
    SvgPaint none;
    none.filled = none.visible = false;
    none.fill_rule = FillRule::even_odd;
    EXPECT_EQ(inherited(none, {}), none);
    EXPECT_TRUE(say(none, CssProperty::fill, "#fff").filled);
    EXPECT_TRUE(say(none, CssProperty::fill, "initial").filled);
    EXPECT_FALSE(say(none, CssProperty::fill, "inherit").filled);
    EXPECT_FALSE(say({}, CssProperty::fill, "None").filled);
    EXPECT_FALSE(say({}, CssProperty::fill, "transparent").filled);
    EXPECT_EQ(say(none, CssProperty::fill_rule, "nonzero").fill_rule, FillRule::nonzero);
    EXPECT_EQ(say({}, CssProperty::fill_rule, "evenodd").fill_rule, FillRule::even_odd);
    EXPECT_TRUE(say(none, CssProperty::visibility, "visible").visible);
    EXPECT_FALSE(say({}, CssProperty::visibility, "collapse").visible);
}

TEST(SvgStyle, Strokes) {
    const auto stroke_of = [](std::string_view value, const SvgPaint& parent = {}) {
        CssValues said;
        said.of[static_cast<std::size_t>(CssProperty::stroke)] = value;
        const auto stroke = inherited(parent, said).stroke;
        return stroke ? to_text(*stroke) : "none";
    };
    SvgPaint red;
    red.stroke = Colour{255, 0, 0, 255};
    red.current = {0, 0, 255, 255};
    EXPECT_EQ(stroke_of(""), "none");
    EXPECT_EQ(stroke_of("#0a0"), "#00aa00");
    for (const char* value : {"", "inherit", "unset", "nonsense"}) EXPECT_EQ(stroke_of(value, red), "#ff0000") << value;
    for (const char* value : {"None", "initial", "transparent", "rgba(1,2,3,0)"}) {
        EXPECT_EQ(stroke_of(value, red), "none") << value;
    }
    EXPECT_EQ(stroke_of("currentColor", red), "#0000ff");
    EXPECT_EQ(stroke_of("currentColor"), "#000000");
    EXPECT_EQ(stroke_of("url(#g)", red), "#000000");
    EXPECT_EQ(stroke_of("url(#g) lime", red), "#00ff00");

    const auto width_of = [](std::string_view value) {
        CssValues said;
        said.of[static_cast<std::size_t>(CssProperty::stroke_width)] = value;
        SvgPaint parent;
        parent.stroke_width = {7, false};
        return inherited(parent, said).stroke_width;
    };
    EXPECT_EQ(width_of(""), (SvgLength{7, false}));
    EXPECT_EQ(width_of("3pt"), (SvgLength{4, false}));
    EXPECT_EQ(width_of("5%"), (SvgLength{5, true}));
    EXPECT_EQ(width_of("initial"), (SvgLength{1, false}));
    EXPECT_EQ(width_of("-1"), (SvgLength{7, false}));
    EXPECT_EQ(width_of("wide"), (SvgLength{7, false}));
}

}  // namespace
}  // namespace filigree
