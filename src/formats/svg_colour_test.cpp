#include "formats/svg_colour.h"

#include <gtest/gtest.h>

#include <string>

namespace filigree {
namespace {

std::string colour_of(std::string_view text) {
    const std::optional<Colour> colour = parse_css_colour(text);
    return colour ? to_text(*colour) : "none";
}

TEST(SvgColour, Hexadecimal) {
    EXPECT_EQ(colour_of("#1aF"), "#11aaff");
    EXPECT_EQ(colour_of("#1aF8"), "#11aaff88");
    EXPECT_EQ(colour_of(" #102030 "), "#102030");
    EXPECT_EQ(colour_of("#10203040"), "#10203040");
    for (const char* text : {"#", "#1", "#12", "#12345", "#1234567", "#123456789", "#12g", "# 123"}) {
        EXPECT_EQ(colour_of(text), "none") << text;
    }
}

TEST(SvgColour, Functions) {
    EXPECT_EQ(colour_of("rgb(1,2,3)"), "#010203");
    EXPECT_EQ(colour_of("RGB( 1 , 2 , 3 )"), "#010203");
    EXPECT_EQ(colour_of("rgb(100%, 50%, 0%)"), "#ff8000");
    EXPECT_EQ(colour_of("rgb(300,-5,9.6)"), "#ff000a");
    EXPECT_EQ(colour_of("rgba(1,2,3,.5)"), "#01020380");
    EXPECT_EQ(colour_of("rgb(1 2 3 / 50%)"), "#01020380");
    EXPECT_EQ(colour_of("rgb(1e300, 0, 0)"), "#ff0000");
    for (const char* text :
         {"rgb(", "rgb()", "rgb(1,2)", "rgb(1,2,3,4,5)", "rgb(1,2,x)", "rgb(1,2,3", "hsl(0,0%,0%)"}) {
        EXPECT_EQ(colour_of(text), "none") << text;
    }
}

TEST(SvgColour, Names) {
    EXPECT_EQ(colour_of("aliceblue"), "#f0f8ff");
    EXPECT_EQ(colour_of("RebeccaPurple"), "#663399");
    EXPECT_EQ(colour_of("yellowgreen"), "#9acd32");
    EXPECT_EQ(colour_of("grey"), colour_of("gray"));
    EXPECT_EQ(colour_of("tan"), "#d2b48c");
    for (const char* text : {"", "none", "currentColor", "inherit", "blac", "blackk"}) {
        EXPECT_EQ(colour_of(text), "none") << text;
    }
}

}  // namespace
}  // namespace filigree
