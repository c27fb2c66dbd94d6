#include "formats/font.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <set>

#include "base/test_cases.h"

namespace filigree {
namespace {

std::string file(const std::string& name) {
    std::ifstream stream(FILIGREE_SOURCE_DIR "/" + name, std::ios::binary);
    EXPECT_TRUE(stream) << name;
    return {std::istreambuf_iterator<char>(stream), {}};
}
// TrueType; an em is 2048 units. Letters: A V T o e f i l 1 2 ( ) -, space, acute; alef bet gimel shin; alef beh seen
// lam meem fatha.
const std::string& sans() {
    static const std::string bytes = file("tests/data/fonts/dejavu_sans_subset.ttf");
    return bytes;
}
// OpenType with cubic outlines; an em is 1000 units.
const std::string& display() {
    static const std::string bytes = file("examples/tangle/starts/LeagueSpartan-Black.otf");
    return bytes;
}

std::vector<Glyph> outlines(const std::string& text, double size = 2048, const TextOptions& options = {}) {
    const Result<std::vector<Glyph>> glyphs = text_outlines(sans(), text, size, options);
    EXPECT_TRUE(glyphs) << (glyphs ? "" : glyphs.diagnostics()[0].message);
    EXPECT_TRUE(glyphs.diagnostics().empty());
    return glyphs ? *glyphs : std::vector<Glyph>{};
}

struct Extent {
    Vec min{HUGE_VAL, HUGE_VAL}, max{-HUGE_VAL, -HUGE_VAL};
};
Extent extent(const Glyph& glyph) {  // of its points; here the curves reach them
    Extent e;
    for (const Vec p : glyph.path.points) {
        e.min = {std::min(e.min.x, p.x), std::min(e.min.y, p.y)};
        e.max = {std::max(e.max.x, p.x), std::max(e.max.y, p.y)};
    }
    return e;
}
double left(const Glyph& glyph) { return extent(glyph).min.x; }
double right(const Glyph& glyph) { return extent(glyph).max.x; }

std::vector<std::string> letters(const std::vector<Glyph>& glyphs) {
    std::vector<std::string> texts;
    for (const Glyph& glyph : glyphs) texts.push_back(glyph.text);
    return texts;
}
using Letters = std::vector<std::string>;

std::string code_of(std::string_view font, const std::string& text = "A", double size = 10,
                    const TextOptions& options = {}) {
    const Result<std::vector<Glyph>> glyphs = text_outlines(font, text, size, options);
    return glyphs ? "ok" : glyphs.diagnostics()[0].code;
}

TEST(Font, OutlinesAreTheFontsOwnNumbers) {
    const std::vector<Glyph> glyphs = outlines("l");  // a bar from (193, 0) to (377, 1556)
    ASSERT_EQ(glyphs.size(), 1U);
    const std::vector<Vec> corners = {{193, -1556}, {377, -1556}, {377, 0}, {193, 0}};
    for (const Vec p : glyphs[0].path.points) {
        EXPECT_TRUE(std::find(corners.begin(), corners.end(), p) != corners.end()) << p.x << " " << p.y;
    }
    EXPECT_EQ(glyphs[0].path.verbs.front(), Verb::move);
    EXPECT_EQ(glyphs[0].path.verbs.back(), Verb::close);
    const std::vector<Glyph> small = outlines("l", 20.48);
    for (std::size_t i = 0; i < small[0].path.points.size(); ++i) {
        EXPECT_DOUBLE_EQ(small[0].path.points[i].x, glyphs[0].path.points[i].x * 0.01);
        EXPECT_DOUBLE_EQ(small[0].path.points[i].y, glyphs[0].path.points[i].y * 0.01);
    }
}

TEST(Font, CurvesStayCurves) {
    const std::vector<Glyph> round = outlines("o");
    ASSERT_EQ(round.size(), 1U);
    const auto count = [](const Path& path, Verb verb) {
        return std::count(path.verbs.begin(), path.verbs.end(), verb);
    };
    EXPECT_EQ(count(round[0].path, Verb::close), 2);
    EXPECT_GE(count(round[0].path, Verb::quadratic), 8);
    EXPECT_EQ(count(round[0].path, Verb::cubic), 0);
    const Result<std::vector<Glyph>> cubic = text_outlines(display(), "o", 1000);
    ASSERT_TRUE(cubic);
    ASSERT_EQ(cubic->size(), 1U);
    EXPECT_EQ(count((*cubic)[0].path, Verb::close), 2);
    EXPECT_GE(count((*cubic)[0].path, Verb::cubic), 8);
    double area = 0;
    for (const Polyline& line : flatten((*cubic)[0].path, 0.1)) {
        EXPECT_TRUE(line.closed);
        for (std::size_t i = 0; i < line.points.size(); ++i) {
            area += cross(line.points[i], line.points[(i + 1) % line.points.size()]) / 2;
        }
    }
    EXPECT_GT(std::fabs(area), 100'000);  // the hole turns against the outline
    EXPECT_LT(std::fabs(area), 600 * 600);
}

TEST(Font, LigaturesKerningAndMarks) {
    EXPECT_EQ(letters(outlines("ofi ffil")), (Letters{"o", "fi", "ffi", "l"}));
    EXPECT_EQ(outlines("o fi")[1].begin, 2U);
    EXPECT_LT(left(outlines("AV")[1]), right(outlines("AV")[0]));  // kerned: V reaches over A
    EXPECT_GT(left(outlines("VV")[1]), right(outlines("VV")[0]));
    // A mark is a part of its letter, above it.
    const std::vector<Glyph> accented = outlines("Ae\xCC\x81l"), plain = outlines("Ael");
    EXPECT_EQ(letters(accented), (Letters{"A", "e\xCC\x81", "l"}));
    EXPECT_LT(extent(accented[1]).min.y, extent(plain[1]).min.y - 200);
    EXPECT_EQ(left(accented[2]), left(plain[2]));
    EXPECT_EQ(accented[2].begin, 4U);
}

TEST(Font, LetterSpacing) {
    TextOptions spaced;
    spaced.letter_spacing = 100;
    EXPECT_EQ(letters(outlines("fil", 2048, spaced)), (Letters{"f", "i", "l"}));
    const std::vector<Glyph> loose = outlines("ill", 2048, spaced), tight = outlines("ill");
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(left(loose[i]), left(tight[i]) + 100 * static_cast<double>(i));
    }
    spaced.align = TextAlign::right;
    TextOptions right_aligned;
    right_aligned.align = TextAlign::right;
    EXPECT_EQ(left(outlines("ill", 2048, spaced)[2]), left(outlines("ill", 2048, right_aligned)[2]));
    // What joins stays together.
    const std::string salam = "\xD8\xB3\xD9\x84\xD8\xA7\xD9\x85";
    spaced.align = TextAlign::left;
    EXPECT_EQ(outlines(salam, 2048, spaced)[0].path, outlines(salam)[0].path);
}

TEST(Font, RightToLeft) {
    const std::string shin = "\xD7\xA9", bet = "\xD7\x91", alef = "\xD7\x90";
    const std::vector<Glyph> hebrew = outlines(shin + bet + alef);
    EXPECT_EQ(letters(hebrew), (Letters{alef, bet, shin}));
    EXPECT_EQ(hebrew[0].begin, 4U);
    EXPECT_LT(right(hebrew[0]), left(hebrew[1]));
    EXPECT_LT(right(hebrew[1]), left(hebrew[2]));
    // Numbers and Latin inside run from left to right, brackets are mirrored.
    EXPECT_EQ(letters(outlines(shin + " 12 " + alef + " (Ao)")), (Letters{")", "A", "o", "(", alef, "1", "2", shin}));
    EXPECT_EQ(letters(outlines("A " + shin + bet + " V")), (Letters{"A", bet, shin, "V"}));
    const Glyph opening = outlines("(")[0];
    const std::vector<Glyph> bracketed = outlines(shin + "(" + alef + ")");
    ASSERT_EQ(bracketed.size(), 4U);
    EXPECT_EQ(bracketed[0].text, ")");
    EXPECT_EQ(bracketed[0].path, opening.path);  // it looks like an opening one at the left end
    // Each line has its own direction.
    EXPECT_EQ(letters(outlines("A1\n" + shin + "1")), (Letters{"A", "1", "1", shin}));
}

TEST(Font, ArabicLettersJoin) {
    const std::string beh = "\xD8\xA8", seen = "\xD8\xB3", lam = "\xD9\x84", alef = "\xD8\xA7", meem = "\xD9\x85";
    const std::vector<Glyph> alone = outlines(beh), joined = outlines(beh + beh + beh);
    ASSERT_EQ(joined.size(), 3U);
    std::set<std::size_t> forms;  // first, middle, last, alone
    for (const Glyph& glyph : joined)
        forms.insert(glyph.path.points.size() * 10'000 + static_cast<std::size_t>(right(glyph) - left(glyph)));
    forms.insert(alone[0].path.points.size() * 10'000 + static_cast<std::size_t>(right(alone[0]) - left(alone[0])));
    EXPECT_EQ(forms.size(), 4U);
    EXPECT_GE(right(joined[0]), left(joined[1]));
    EXPECT_EQ(letters(outlines(seen + lam + alef + meem)), (Letters{meem, lam + alef, seen}));  // lam and alef are one
    EXPECT_EQ(letters(outlines(seen + "\xD9\x8E")), (Letters{seen + "\xD9\x8E"}));
}

TEST(Font, LinesAndAlignment) {
    const auto set = [](TextAlign align, const std::string& text) {
        TextOptions options;
        options.align = align;
        options.line_height = 1.5;
        return outlines(text, 2048, options);
    };
    const double advance = left(outlines("ll")[1]) - left(outlines("ll")[0]);
    const std::vector<Glyph> at_left = set(TextAlign::left, "lll\n\nl\r\nl");
    ASSERT_EQ(at_left.size(), 5U);
    EXPECT_EQ(extent(at_left[2]).max.y, 0);
    EXPECT_EQ(extent(at_left[3]).max.y, 2 * 1.5 * 2048);
    EXPECT_EQ(extent(at_left[4]).max.y, 3 * 1.5 * 2048);
    EXPECT_EQ(left(at_left[3]), left(at_left[0]));
    EXPECT_EQ(at_left[4].begin, 8U);
    const std::vector<Glyph> centred = set(TextAlign::centre, "lll\nl"), at_right = set(TextAlign::right, "lll\nl");
    EXPECT_EQ(left(centred[0]), left(at_left[0]) - 1.5 * advance);
    EXPECT_EQ(left(centred[3]), left(at_left[0]) - 0.5 * advance);
    EXPECT_EQ(left(at_right[0]), left(at_left[0]) - 3 * advance);
    EXPECT_EQ(left(at_right[3]), left(at_left[0]) - advance);
    EXPECT_TRUE(outlines("").empty());
    EXPECT_TRUE(outlines(" \n\t\n").empty());
}

TEST(Font, NamesTheLettersThatAreMissing) {
    const Result<std::vector<Glyph>> glyphs = text_outlines(sans(), "lZl\xE2\x82\xACZ", 2048);
    ASSERT_TRUE(glyphs);
    EXPECT_EQ(letters(*glyphs), (Letters{"l", "l"}));
    ASSERT_EQ(glyphs.diagnostics().size(), 1U);
    EXPECT_EQ(glyphs.diagnostics()[0].severity, Severity::warning);
    EXPECT_EQ(glyphs.diagnostics()[0].code, "font.no-letter");
    EXPECT_EQ(glyphs.diagnostics()[0].message, "the font has no letter for 'Z', '\xE2\x82\xAC'");
    const Result<std::vector<Glyph>> many = text_outlines(sans(), "abcdghjkmnpqrs", 2048);
    ASSERT_TRUE(many);
    EXPECT_TRUE(many.diagnostics()[0].message.ends_with(" and 4 more")) << many.diagnostics()[0].message;
}

TEST(Font, RefusesBadFontsAndArguments) {
    EXPECT_EQ(code_of(sans()), "ok");
    EXPECT_EQ(code_of(display()), "ok");
    EXPECT_EQ(code_of(""), "font.unknown-format");
    EXPECT_EQ(code_of("wOF2 and so on"), "font.unknown-format");
    EXPECT_EQ(code_of(sans().substr(0, 8)), "font.cut-off");
    EXPECT_EQ(code_of(sans().substr(0, 40)), "font.cut-off");
    EXPECT_EQ(code_of(std::string_view(sans()).substr(0, sans().size() - 4)), "font.cut-off");
    const auto without = [](std::string font, const std::string& table) {
        font.replace(font.find(table), 4, "xxxx");
        return font;
    };
    EXPECT_EQ(code_of(without(sans(), "glyf")), "font.no-outlines");
    EXPECT_EQ(code_of(without(sans(), "cmap")), "font.broken");
    EXPECT_EQ(code_of(without(display(), "CFF ")), "font.no-outlines");
    for (const double size : {0.0, -1.0, 2e6, std::nan("")}) EXPECT_EQ(code_of(sans(), "A", size), "font.bad-size");
    TextOptions options;
    options.letter_spacing = std::nan("");
    EXPECT_EQ(code_of(sans(), "A", 10, options), "font.bad-spacing");
    EXPECT_EQ(code_of(sans(), "\xFF"), "font.bad-text");
    EXPECT_EQ(code_of(sans(), std::string(100'001, 'l')), "font.long-text");
    EXPECT_EQ(code_of(sans(), std::string(100'000, 'l')), "ok");
    EXPECT_EQ(code_of(sans(), std::string(100'000, 'l'), 1e6), "font.too-large");
}

TEST(Font, ReadsTheFirstFontOfACollection) {
    // The same font behind the head of a collection; its tables lie that much further on.
    std::string collection("ttcf\0\1\0\0\0\0\0\1\0\0\0\x10", 16);
    std::string font = sans();
    const auto count = static_cast<std::size_t>(static_cast<unsigned char>(font[5]));
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = 12 + 16 * i + 8;
        std::uint32_t offset = 16;
        for (std::size_t b = 0; b < 4; ++b)
            offset += std::uint32_t{static_cast<unsigned char>(font[at + b])} << (24 - 8 * b);
        for (std::size_t b = 0; b < 4; ++b) font[at + b] = static_cast<char>(offset >> (24 - 8 * b) & 255);
    }
    collection += font;
    const Result<std::vector<Glyph>> glyphs = text_outlines(collection, "fi", 2048);
    ASSERT_TRUE(glyphs);
    EXPECT_EQ((*glyphs)[0].path, outlines("fi")[0].path);
    EXPECT_EQ(code_of(collection.substr(0, 14)), "font.cut-off");
    EXPECT_EQ(code_of(collection.substr(0, 24)), "font.cut-off");
}

TEST(Font, DamagedFontsNeverCrash) {
    std::uint64_t refused = 0, drawn = 0;
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed);
        std::string font = random.coin() ? sans() : display();
        if (random.below(4) == 0) font.resize(random.index(font.size()));
        const std::uint32_t flips = random.below(12);
        // The tables that matter most lie in front as often as not.
        const std::size_t reach = random.coin() ? font.size() : std::min<std::size_t>(font.size(), 400);
        for (std::uint32_t i = 0; i < flips && reach > 0; ++i) {
            font[random.index(reach)] = static_cast<char>(random.below(256));
        }
        const Result<std::vector<Glyph>> glyphs =
            text_outlines(font, "AVffi(e\xCC\x81) \xD7\xA9 \xD8\xB3\xD9\x84\xD8\xA7", 50);
        if (!glyphs) {
            ASSERT_FALSE(glyphs.diagnostics().empty());
            ++refused;
        } else {
            ++drawn;
            for (const Glyph& glyph : *glyphs) {
                for (const Vec p : glyph.path.points) ASSERT_TRUE(is_on_plane(p));
            }
        }
    }
    EXPECT_GT(refused, 0U);
    EXPECT_GT(drawn, 0U);
}

}  // namespace
}  // namespace filigree
