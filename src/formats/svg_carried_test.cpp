#include "formats/svg_carried.h"

#include <gtest/gtest.h>

#include "base/random.h"
#include "base/test_cases.h"
#include "formats/svg_read.h"
#include "formats/test_drawings.h"

namespace filigree {
namespace {

std::string svg_with(const CarriedDocument& carried) {
    SvgOptions options;
    options.carried = &carried;
    return to_svg(drawing_of(polygons_of({rectangle_ring(0, 0, 5, 5)}), filled(black), {10, 10}), options);
}

void expect_back(const CarriedDocument& carried) {
    const Result<std::optional<CarriedDocument>> back = carried_document(svg_with(carried));
    ASSERT_TRUE(back) << back.diagnostics()[0].message;
    ASSERT_TRUE(back->has_value());
    EXPECT_TRUE(**back == carried);
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

TEST(SvgCarried, ComesBackByteForByte) {
    expect_back({{"leaf.fil", "grammar tangle\nseed 2016\n\ta & b < c > d \"e\" 'f'\n"}, {}});
    expect_back({{"", ""}, {}});
    expect_back({{"space.fil", "  \n"}, {{"\t\n", "\n"}}});
    expect_back({{"ende.fil", "]]>a]]>]]>]]"}, {{"]]>", "]]"}, {">", ">"}}});
    expect_back({{"windows.fil", "a\r\nb\r\n"}, {{"bytes", std::string("\0\x01\xff\xfe", 4)}}});
    expect_back(
        {{"Blätter \"schön\" & <größer>.fil", "# ünïcode \xF0\x9F\x8C\xBF\xEF\xBB\xBF"}, {{"\xff\x00name\r", "x"}}});
    expect_back({{"nonchar", "\xEF\xBF\xBE"}, {{"surrogate", "\xED\xA0\x80"}, {"entities", "&amp;&#10;&lt;![CDATA["}}});
    expect_back({{"long", std::string(9'000'000, 'x') + "\xC3\xA4"}, {{"zeros", std::string(5'000'000, '\0')}}});
    std::string umlauts = "a";
    for (int i = 0; i < 2'500'000; ++i) umlauts += "\xC3\xA4";
    expect_back({{"umlauts", umlauts}, {}});
}

TEST(SvgCarried, TextStaysReadable) {
    const std::string svg = svg_with({{"leaf.fil", "grammar tangle\n"}, {}});
    EXPECT_NE(svg.find("<![CDATA[grammar tangle\n]]>"), std::string::npos) << svg;
}

TEST(SvgCarried, AnSvgThatCarriesADocumentMayBeCarried) {
    CarriedDocument carried{{"leaf.fil", "seed 1"}, {}};
    for (int level = 0; level < 5; ++level) {
        expect_back(carried);
        carried = {{"outer " + std::to_string(level), "seed 2"}, {{"inner.svg", svg_with(carried)}, {"b", "]]>"}}};
    }
    const Result<SvgPicture> picture = read_svg(svg_with(carried));
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->shapes.size(), 1U);
}

TEST(SvgCarried, RandomBytesComeBack) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        const auto text = [&](std::uint64_t key, bool is_binary) {
            static constexpr std::string_view telling = "]]>]]><![CDATA[&amp;\n\t \"'x-->";
            std::string bytes;
            const std::uint64_t length = to_whole(random_bits(seed, Key{key}, "length"), 60);
            for (std::uint64_t i = 0; i < length; ++i) {
                const std::uint64_t bits = random_bits(seed, Key{key}, "byte", i);
                bytes += is_binary ? static_cast<char>(bits) : telling[to_whole(bits, telling.size())];
            }
            return bytes;
        };
        const bool is_binary = seed % 3 == 0;
        const CarriedDocument carried{{text(1, is_binary), text(2, false)}, {{text(3, false), text(4, is_binary)}}};
        const Result<std::optional<CarriedDocument>> back = carried_document(svg_with(carried));
        ASSERT_TRUE(back) << "seed " << seed;
        ASSERT_TRUE(back->has_value() && **back == carried) << "seed " << seed;
    }
}

TEST(SvgCarried, NoticesDamage) {
    const std::string svg =
        svg_with({{"leaf.fil", "seed 2016"}, {{"leaf.svg", "<svg/>"}, {"b.png", std::string(1, '\0')}}});
    const auto code_of = [](const std::string& damaged) -> std::string {
        const Result<std::optional<CarriedDocument>> back = carried_document(damaged, 4);
        if (back) return back->has_value() ? "there" : "none";
        EXPECT_EQ(back.diagnostics()[0].span.file, 4U);
        return back.diagnostics()[0].code;
    };
    EXPECT_EQ(code_of(svg), "there");
    EXPECT_EQ(code_of(replaced(svg, "seed 2016", "seed 2017")), "svg.carried-damaged");
    EXPECT_EQ(code_of(replaced(svg, "name=\"leaf.svg\"", "name=\"oak.svg\"")), "svg.carried-damaged");
    EXPECT_EQ(code_of(replaced(svg, "inputs=\"2\"", "inputs=\"3\"")), "svg.carried-damaged");
    EXPECT_EQ(code_of(replaced(svg, "AA==", "AB==")), "svg.carried-damaged");
    EXPECT_EQ(code_of(replaced(svg, "AA==", "AQ==")), "svg.carried-damaged");
    EXPECT_EQ(code_of(replaced(svg, "\"base64\"", "\"base99\"")), "svg.carried-damaged");
    EXPECT_EQ(code_of(replaced(svg, "version=\"1\" inputs", "version=\"2\" inputs")), "svg.carried-version");
    EXPECT_EQ(code_of(replaced(svg, "</filigree:carried>", "")), "svg.bad-xml");
    EXPECT_EQ(code_of(replaced(replaced(svg, "<metadata>", "<defs>"), "</metadata>", "</defs>")), "none");
    EXPECT_EQ(code_of("<svg xmlns='http://www.w3.org/2000/svg'/>"), "none");
    EXPECT_EQ(code_of("urn:x-filigree:carried"), "svg.bad-xml");
    EXPECT_EQ(code_of(""), "none");
}

TEST(SvgCarried, SurvivesOtherPrefixesAndQuotes) {
    // What a program that parses and writes XML makes of it.
    const std::string svg =
        "<svg:svg xmlns:svg='http://www.w3.org/2000/svg' xmlns:ns1='urn:x-filigree:carried'><svg:metadata>"
        "<other/><ns1:carried version='1' inputs='0'><ns1:document name='a' hash='HASH'>1 &lt; 2</ns1:document>"
        "</ns1:carried></svg:metadata></svg:svg>";
    const std::string ours = svg_with({{"a", "1 < 2"}, {}});
    const std::string hash = ours.substr(ours.find("hash=\"") + 6, 16);
    const Result<std::optional<CarriedDocument>> back = carried_document(replaced(svg, "HASH", hash));
    ASSERT_TRUE(back) << back.diagnostics()[0].message;
    ASSERT_TRUE(back->has_value());
    EXPECT_EQ((*back)->document.bytes, "1 < 2");
}

}  // namespace
}  // namespace filigree
