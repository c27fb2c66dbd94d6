#include "formats/svg_values.h"

#include <gtest/gtest.h>

#include <string>

#include "base/random.h"
#include "base/test_cases.h"

namespace filigree {
namespace {

using Numbers = std::vector<double>;

TEST(SvgValues, NumberLists) {
    EXPECT_EQ(parse_number_list("1 2,3 , 4\n-5+6.5.5-.25e1 7E-1 2."),
              (Numbers{1, 2, 3, 4, -5, 6.5, 0.5, -2.5, 0.7, 2}));
    EXPECT_EQ(parse_number_list(" \t"), Numbers{});
    for (const char* wrong : {",1", "1,", "1,,2", "1 x", "nan", "inf", "1e999", "--1", ".", "e5", "1e5e", "0x10"}) {
        EXPECT_FALSE(parse_number_list(wrong).has_value()) << wrong;
    }
}

TEST(SvgValues, Lengths) {
    const auto px = [](const char* text) { return parse_length(text).value().value; };
    EXPECT_EQ(px(" 12.5 "), 12.5);
    EXPECT_EQ(px("12px"), 12);
    EXPECT_EQ(px("1in"), 96);
    EXPECT_DOUBLE_EQ(px("25.4mm"), 96);
    EXPECT_DOUBLE_EQ(px("2.54cm"), 96);
    EXPECT_DOUBLE_EQ(px("101.6Q"), 96);
    EXPECT_DOUBLE_EQ(px("72pt"), 96);
    EXPECT_EQ(px("6pc"), 96);
    EXPECT_EQ(px("2em"), 32);
    EXPECT_EQ(px("1e1MM"), 10 * 96 / 25.4);
    EXPECT_TRUE(parse_length("40%")->is_percentage);
    EXPECT_EQ(parse_length("40%")->value, 40);
    for (const char* wrong : {"", "px", "1 px", "1vw", "1mmm", "1,2", "1%%", "1e400"}) {
        EXPECT_FALSE(parse_length(wrong).has_value()) << wrong;
    }
}

void expect_near(const Transform& a, const Transform& b) {
    EXPECT_NEAR(a.a, b.a, 1e-12);
    EXPECT_NEAR(a.b, b.b, 1e-12);
    EXPECT_NEAR(a.c, b.c, 1e-12);
    EXPECT_NEAR(a.d, b.d, 1e-12);
    EXPECT_NEAR(a.e, b.e, 1e-12);
    EXPECT_NEAR(a.f, b.f, 1e-12);
}

TEST(SvgValues, Transforms) {
    expect_near(parse_transform_list("").value(), {});
    expect_near(parse_transform_list("none").value(), {});
    expect_near(parse_transform_list("matrix(1 2 3 4 5 6)").value(), {1, 2, 3, 4, 5, 6});
    expect_near(parse_transform_list("translate(5)").value(), {1, 0, 0, 1, 5, 0});
    expect_near(parse_transform_list(" scale ( 2 , 3 ) ,translate(1,1)").value(), {2, 0, 0, 3, 2, 3});
    expect_near(parse_transform_list("scale(2)").value(), {2, 0, 0, 2, 0, 0});
    expect_near(parse_transform_list("rotate(90)").value(), {0, 1, -1, 0, 0, 0});
    expect_near(parse_transform_list("rotate(180 5 7)").value(), {-1, 0, 0, -1, 10, 14});
    expect_near(parse_transform_list("skewX(45)").value(), {1, 0, 1, 1, 0, 0});
    expect_near(parse_transform_list("skewY(45)").value(), {1, 1, 0, 1, 0, 0});
    for (const char* wrong : {"scale", "scale(", "scale()", "scale(1 2 3)", "rotate(1 2)", "matrix(1 2 3 4 5)",
                              "turn(1)", "scale(1),", "scale(1) x", "scale(a)", "rotate(1deg)", ",scale(1)"}) {
        EXPECT_FALSE(parse_transform_list(wrong).has_value()) << wrong;
    }
}

TEST(SvgValues, TransformListsCompose) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        const auto one = [&](std::uint64_t i) {
            const auto number = [&](const char* name) {
                return std::to_string(static_cast<int>(to_whole(random_bits(seed, Key{i}, name), 19)) - 9);
            };
            switch (to_whole(random_bits(seed, Key{i}, "kind"), 5)) {
                case 0:
                    return "translate(" + number("x") + "," + number("y") + ")";
                case 1:
                    return "scale(" + number("x") + " " + number("y") + ")";
                case 2:
                    return "rotate(" + number("a") + " " + number("x") + " " + number("y") + ")";
                case 3:
                    return "skewX(" + number("a") + ")";
                default:
                    return "matrix(1 0 " + number("c") + " 1 0 " + number("f") + ")";
            }
        };
        const std::string a = one(1), b = one(2);
        const Transform both = parse_transform_list(a + b).value();
        const Transform composed = compose(parse_transform_list(a).value(), parse_transform_list(b).value());
        ASSERT_EQ(both, composed) << "seed " << seed;
    }
}

TEST(SvgValues, ViewBoxesFit) {
    const ViewBox box = parse_view_box("10 20 100 50").value();
    EXPECT_FALSE(parse_view_box("0 0 0 5").has_value());
    EXPECT_FALSE(parse_view_box("0 0 5 -5").has_value());
    EXPECT_FALSE(parse_view_box("0 0 5").has_value());
    const auto corners = [&](const char* ratio) {
        const Transform t = fit(box, {200, 200}, parse_aspect_ratio(ratio).value());
        return std::vector<Vec>{apply(t, {10, 20}), apply(t, {110, 70})};
    };
    using Corners = std::vector<Vec>;
    EXPECT_EQ(corners("none"), (Corners{{0, 0}, {200, 200}}));
    EXPECT_EQ(corners("xMidYMid"), (Corners{{0, 50}, {200, 150}}));
    EXPECT_EQ(corners("xMinYMin meet"), (Corners{{0, 0}, {200, 100}}));
    EXPECT_EQ(corners("xMaxYMax meet"), (Corners{{0, 100}, {200, 200}}));
    EXPECT_EQ(corners("xMidYMid slice"), (Corners{{-100, 0}, {300, 200}}));
    EXPECT_EQ(corners("xMinYMax slice"), (Corners{{0, 0}, {400, 200}}));
    EXPECT_EQ(corners("defer xMaxYMid slice"), (Corners{{-200, 0}, {200, 200}}));
    for (const char* wrong : {"", "meet", "xMidYMid cut", "xmidymid", "xMidYMidd", "none none"}) {
        EXPECT_FALSE(parse_aspect_ratio(wrong).has_value()) << wrong;
    }
}

}  // namespace
}  // namespace filigree
