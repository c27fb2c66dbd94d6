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
    EXPECT_EQ(sheets.rule_count(), 0U);
}

TEST(SvgStyle, Inheritance) {
    const auto say = [](SvgPaint parent, CssProperty property, std::string_view value) {
        CssValues said;
        said.of[static_cast<std::size_t>(property)] = value;
        return inherited(parent, said);
    };
    SvgPaint none{false, FillRule::even_odd, false};
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

}  // namespace
}  // namespace filigree
