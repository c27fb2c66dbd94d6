#include "base/diagnostic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/job.h"
#include "base/random.h"
#include "base/result.h"
#include "base/test_cases.h"
#include "base/unicode.h"

namespace filigree {
namespace {

SourceSpan span(std::uint32_t begin, std::uint32_t end, std::uint32_t file = 0) { return {file, begin, end}; }

// The lines that show the source: all but the first and the hints.
std::string excerpt(const std::string& text, std::uint32_t begin, std::uint32_t end) {
    const std::string out = to_text(error("a.b", "m", span(begin, end)), {{"f", text}});
    return out.substr(out.find('\n') + 1);
}

TEST(Diagnostic, IsPrintedWithItsPlaceSourceAndHints) {
    const std::string text =
        "grammar tangle\nseed 1\n\nstart in\n\nregularSpilt(line, 90, dual) : in -> quads\nregroup(2) : quads -> q\n";
    const Sources sources = {{"leaf.fil", text}};
    const auto begin = static_cast<std::uint32_t>(text.find("regularSpilt"));
    const Diagnostic diagnostic = error("tangle.unknown-operator", "there is no operator 'regularSpilt'",
                                        span(begin, begin + 12), {"did you mean 'regularSplit'?"});
    EXPECT_EQ(to_text(diagnostic, sources),
              "leaf.fil:6:1: error: there is no operator 'regularSpilt' [tangle.unknown-operator]\n"
              "    regularSpilt(line, 90, dual) : in -> quads\n"
              "    ^~~~~~~~~~~~\n"
              "  hint: did you mean 'regularSplit'?\n");
}

TEST(Diagnostic, WithoutAPlaceIsPrintedUnderTheProgramsName) {
    EXPECT_EQ(to_text(error("a.b", "it is wrong"), {}), "filigree: error: it is wrong [a.b]\n");
    EXPECT_EQ(to_text(warning("a.b", "it is odd", {}, {"one", "two"}), {{"f", "x"}}),
              "filigree: warning: it is odd [a.b]\n  hint: one\n  hint: two\n");
    EXPECT_EQ(to_text(error("a.b", "no such file", span(0, 1, 7)), {{"f", "x"}}),
              "filigree: error: no such file [a.b]\n");
    EXPECT_EQ(to_text(error("", "no code"), {}), "filigree: error: no code\n");
    EXPECT_EQ(to_text(Diagnostics{}, {}), "");
}

TEST(Diagnostic, FactoriesSetWhatTheySay) {
    EXPECT_EQ(error("a", "b").severity, Severity::error);
    EXPECT_EQ(error("a", "b").fault, Fault::document);
    EXPECT_EQ(warning("a", "b").severity, Severity::warning);
    EXPECT_EQ(fault(Fault::limit, "a", "b", span(1, 2)).fault, Fault::limit);
    EXPECT_EQ(fault(Fault::limit, "a", "b", span(1, 2)).span, span(1, 2));
    EXPECT_EQ(cancelled_diagnostic().code, "job.cancelled");
    EXPECT_FALSE(has_errors({}));
    EXPECT_FALSE(has_errors({warning("a", "b")}));
    EXPECT_TRUE(has_errors({warning("a", "b"), error("a", "b")}));
    Diagnostics all = {error("a", "1")};
    append(all, {});
    append(all, {error("a", "2"), error("a", "3")});
    ASSERT_EQ(all.size(), 3U);
    EXPECT_EQ(all[2].message, "3");
}

TEST(Diagnostic, SpansJoin) {
    EXPECT_EQ(span_over(span(3, 5), span(8, 9)), span(3, 9));
    EXPECT_EQ(span_over(span(8, 9), span(3, 5)), span(3, 9));
    EXPECT_EQ(span_over(span(0, 20), span(3, 5)), span(0, 20));
    EXPECT_EQ(span_over({}, span(3, 5)), span(3, 5));
    EXPECT_EQ(span_over(span(3, 5), {}), span(3, 5));
}

TEST(Diagnostic, PlacesCountLinesAndCharactersFromOne) {
    const std::string_view text = "ab\n\xC3\xA9\xE2\x82\xAC x\r\n\n\xFFz";
    EXPECT_EQ(line_column(text, 0), (LineColumn{1, 1}));
    EXPECT_EQ(line_column(text, 2), (LineColumn{1, 3}));  // the line's end belongs to it
    EXPECT_EQ(line_column(text, 3), (LineColumn{2, 1}));
    EXPECT_EQ(line_column(text, 4), (LineColumn{2, 1}));  // inside a character
    EXPECT_EQ(line_column(text, 5), (LineColumn{2, 2}));
    EXPECT_EQ(line_column(text, 7), (LineColumn{2, 2}));
    EXPECT_EQ(line_column(text, 8), (LineColumn{2, 3}));
    EXPECT_EQ(line_column(text, 12), (LineColumn{3, 1}));
    EXPECT_EQ(line_column(text, 13), (LineColumn{4, 1}));
    EXPECT_EQ(line_column(text, 14), (LineColumn{4, 2}));
    EXPECT_EQ(line_column(text, 15), (LineColumn{4, 3}));
    EXPECT_EQ(line_column(text, 9999), (LineColumn{4, 3}));
    EXPECT_EQ(line_column("", 0), (LineColumn{1, 1}));
    EXPECT_EQ(line_column("a\n", 2), (LineColumn{2, 1}));
}

TEST(Diagnostic, TheMarkerStandsUnderTheSpan) {
    EXPECT_EQ(excerpt("abc", 1, 2), "    abc\n     ^\n");
    EXPECT_EQ(excerpt("abc", 1, 1), "    abc\n     ^\n");
    EXPECT_EQ(excerpt("abc", 0, 3), "    abc\n    ^~~\n");
    EXPECT_EQ(excerpt("abc", 3, 3), "    abc\n       ^\n");
    EXPECT_EQ(excerpt("abc\ndef", 5, 7), "    def\n     ^~\n");
    EXPECT_EQ(excerpt("abc\ndef", 1, 6), "    abc\n     ^~\n");  // several lines: to the end of the first
    EXPECT_EQ(excerpt("abc\r\ndef", 1, 7), "    abc\n     ^~\n");
    EXPECT_EQ(excerpt("abc\r\ndef", 3, 3), "    abc\n       ^\n");
    EXPECT_EQ(excerpt("abc\r\ndef", 4, 4), "    abc\n       ^\n");
    EXPECT_EQ(excerpt("\xC3\xA9\xC3\xA9 caf\xC3\xA9 x", 5, 10), "    \xC3\xA9\xC3\xA9 caf\xC3\xA9 x\n       ^~~~\n");
    EXPECT_EQ(excerpt("\xC3\xA9\xC3\xA9", 1, 3), "    \xC3\xA9\xC3\xA9\n    ^~\n");  // ends inside characters
    EXPECT_EQ(excerpt("\tx\ty", 1, 4), "     x y\n     ^~~\n");
    EXPECT_EQ(excerpt("abc", 2, 1), "    abc\n      ^\n");  // a span the wrong way round
    EXPECT_EQ(excerpt("abc", 90, 99), "    abc\n       ^\n");
}

TEST(Diagnostic, EmptyLinesAreNotShown) {
    EXPECT_EQ(excerpt("", 0, 0), "");
    EXPECT_EQ(excerpt("a\n\nb", 2, 2), "");
    EXPECT_EQ(excerpt("a\n", 2, 2), "");
    EXPECT_EQ(excerpt("a\n\r\nb", 2, 2), "");
}

TEST(Diagnostic, NothingReachesTheTerminalThatCouldDriveIt) {
    EXPECT_EQ(excerpt("a\x1B[31mb", 0, 1), "    a?[31mb\n    ^\n");
    EXPECT_EQ(excerpt(std::string("a\0b\x7F", 4), 2, 3), "    a?b?\n      ^\n");
    EXPECT_EQ(excerpt("a\xC2\x9B"
                      "b",
                      3, 4),
              "    a?b\n      ^\n");
    EXPECT_EQ(excerpt("a\xE2\x80\xAE"
                      "b",
                      4, 5),
              "    a?b\n      ^\n");
    EXPECT_EQ(excerpt("a\xFF\xFE"
                      "b",
                      3, 4),
              "    a??b\n       ^\n");
    EXPECT_EQ(to_text(error("a.b", "name '\x1B\n'", span(0, 1), {"try\x07"}), {{"f\n", "x"}}),
              "f?:1:1: error: name '?\?' [a.b]\n    x\n    ^\n  hint: try?\n");
}

TEST(Diagnostic, LongLinesAreCutAroundTheSpan) {
    const std::string digits = "0123456789";
    std::string text;
    for (int i = 0; i < 10; ++i) text += digits;
    EXPECT_EQ(excerpt(text, 99, 100), "    " + text + "\n    " + std::string(99, ' ') + "^\n");
    text += text;
    EXPECT_EQ(excerpt(text, 3, 5), "    " + text.substr(0, 100) + "...\n       ^~\n");
    EXPECT_EQ(excerpt(text, 90, 95),
              "    ..." + text.substr(60, 100) + "...\n       " + std::string(30, ' ') + "^~~~~\n");
    EXPECT_EQ(excerpt(text, 195, 200), "    ..." + text.substr(165) + "\n       " + std::string(30, ' ') + "^~~~~\n");
    EXPECT_EQ(excerpt(text, 200, 200), "    ..." + text.substr(170) + "\n       " + std::string(30, ' ') + "^\n");
    EXPECT_EQ(excerpt(text, 50, 190),
              "    " + text.substr(0, 100) + "...\n    " + std::string(50, ' ') + "^" + std::string(49, '~') + "\n");
    // Characters of several bytes are never cut apart.
    std::string wide;
    for (int i = 0; i < 300; ++i) wide += "\xE2\x82\xAC";
    for (std::uint32_t at = 0; at <= 900; at += 1) {
        const std::string out = excerpt(wide, at, 900);
        ASSERT_EQ(unicode::find_invalid(out), std::string::npos) << at;
        ASSERT_EQ(out.find('?'), std::string::npos) << at;
    }
}

TEST(Diagnostic, AnySpanInAnyBytesIsPrinted) {
    for (std::uint64_t i = 1; i <= case_count(); ++i) {
        CaseRandom random(i);
        std::string text;
        const std::uint32_t length = random.below(i % 10 == 0 ? 2000 : 60);
        constexpr std::string_view alphabet = "ab \n\r\t\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80\xFF";
        for (std::uint32_t k = 0; k < length; ++k) text += alphabet[random.below(alphabet.size())];
        const std::uint32_t begin = random.below(length + 3), end = random.below(length + 3);
        const Sources sources = {{"f", text}};
        const std::string out = to_text(error("a.b", "m", span(begin, end)), sources);
        ASSERT_EQ(out.back(), '\n') << "case " << i;
        ASSERT_EQ(unicode::find_invalid(out), std::string::npos) << "case " << i;
        // The marker starts within one column of the line's end and ends within it.
        const std::string_view rest = std::string_view(out).substr(out.find('\n') + 1);
        if (rest.empty()) continue;
        const std::string_view line = rest.substr(0, rest.find('\n'));
        const std::string_view marker = rest.substr(line.size() + 1, rest.size() - line.size() - 2);
        std::size_t columns = 0;
        for (std::size_t k = 0; k < line.size(); k += unicode::decode(line, k).length) ++columns;
        ASSERT_LE(marker.find('^'), columns) << "case " << i << "\n" << out;
        ASSERT_LE(marker.size(), std::max(columns, marker.find('^') + 1)) << "case " << i << "\n" << out;
        // The column of the head line is the marker's, where the line is shown from its start.
        if (!line.starts_with("    ...") && line.find("...") == std::string_view::npos) {
            const LineColumn place = line_column(text, begin);
            ASSERT_LE(marker.find('^') - 4 + 1, place.column) << "case " << i << "\n" << out;
        }
    }
}

TEST(Diagnostics, ArePrintedInTheOrderOfPlacesAndOnce) {
    const Sources sources = {{"a", "one\ntwo\n"}, {"b", "three"}};
    const Diagnostics diagnostics = {
        error("x.no-place", "last"),
        error("x.b", "in b", span(0, 5, 1)),
        error("x.two", "second line", span(4, 7)),
        warning("x.late", "kept second", span(0, 1)),
        error("x.early", "kept third", span(0, 3)),
        error("x.two", "second line", span(4, 7)),
        error("x.no-place", "last"),
    };
    EXPECT_EQ(to_text(diagnostics, sources),
              "a:1:1: warning: kept second [x.late]\n    one\n    ^\n"
              "a:1:1: error: kept third [x.early]\n    one\n    ^~~\n"
              "a:2:1: error: second line [x.two]\n    two\n    ^~~\n"
              "b:1:1: error: in b [x.b]\n    three\n    ^~~~~\n"
              "filigree: error: last [x.no-place]\n");
}

TEST(Diagnostics, PrintTogetherWhatTheyPrintAlone) {
    for (std::uint64_t i = 1; i <= case_count() / 5; ++i) {
        CaseRandom random(i);
        std::string text;
        for (std::uint32_t k = 0; k < 200; ++k) text += "a\xC3\xA9\n\xFF"[random.below(5) % 5];
        const Sources sources = {{"f", text}};
        Diagnostics all;
        std::string wanted;
        std::uint32_t at = 0;
        while (at < 210) {
            all.push_back(error("a.b", "m", span(at, at + random.below(9))));
            wanted += to_text(all.back(), sources);
            at += 1 + random.below(20);
        }
        ASSERT_EQ(to_text(all, sources), wanted) << "case " << i;
        std::reverse(all.begin(), all.end());
        ASSERT_EQ(to_text(all, sources), wanted) << "case " << i;
    }
}

TEST(Diagnostics, ManyInALongTextTakeOnePass) {
    std::string text;
    Diagnostics all;
    for (std::uint32_t i = 0; i < 20'000; ++i) {
        all.push_back(error("a.b", "m", span(static_cast<std::uint32_t>(text.size()), 0)));
        text += "a line of some text that goes on for a while\n";
    }
    EXPECT_GT(to_text(all, {{"f", text}}).size(), text.size());
}

TEST(Result, HoldsAValueOrReasons) {
    const Result<int> good(5, {warning("a.b", "odd")});
    ASSERT_TRUE(good);
    EXPECT_EQ(*good, 5);
    EXPECT_EQ(good.diagnostics().size(), 1U);
    const Result<int> bad(error("a.b", "wrong"));
    EXPECT_FALSE(bad);
    EXPECT_EQ(bad.diagnostics()[0].message, "wrong");
}

}  // namespace
}  // namespace filigree
