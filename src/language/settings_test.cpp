#include "language/settings.h"

#include <set>

#include "base/number_text.h"
#include "language/text_evaluation.h"

namespace filigree {
namespace {

std::string global(const Settings& settings, std::string_view name) {
    const Value* value = settings.globals.find(name);
    return value == nullptr ? "nothing" : to_text(*value);
}

// The diagnostics of a document that goes on from "grammar tangle".
std::string complaints(const std::string& text, const std::map<std::string, std::string>& included = {}) {
    const Document document = document_of("grammar tangle\n" + text, included);
    const Result<Settings> settings = read_settings(document);
    EXPECT_EQ(static_cast<bool>(settings), !has_errors(settings.diagnostics()));
    return codes_of(settings.diagnostics(), document);
}

TEST(ReadingSettings, TakesEverythingInOrder) {
    const Document document = document_of(R"(filigree 1
grammar tangle
seed 2016
unit mm
resolution 0.1
page 210mm x 297mm margin 10mm
param spacing = 25 in 10..60 step 1 "centre to centre of the blobs"
let rows = floor(page.height / spacing)
let gap = spacing / 5
palette ink = [#1a1a1a, red, #a03020]
limit elements 2000000
limit memory 4GB
limit depth 50
symmetry p4m
start big = rectangle(gap * 10, 50px, corner: 3mm)
start from "portrait.svg"
style big { fill: ink(2) }
outline(gap) : big -> in, out
)");
    const Result<Settings> read = read_settings(document);
    ASSERT_TRUE(read) << to_text(read.diagnostics(), document.sources);
    EXPECT_TRUE(read.diagnostics().empty());
    const Settings& settings = *read;
    EXPECT_EQ(settings.engine, "tangle");
    EXPECT_EQ(settings.seed, 2016U);
    EXPECT_DOUBLE_EQ(settings.resolution, 0.1 * 96 / 25.4);
    EXPECT_EQ(settings.page.kind, PageStatement::Kind::size);
    EXPECT_DOUBLE_EQ(settings.page.width, 210 * 96 / 25.4);
    EXPECT_DOUBLE_EQ(*settings.page.margin, 10 * 96 / 25.4);
    EXPECT_TRUE(settings.page.in_mm);
    EXPECT_EQ(global(settings, "spacing"), "25");
    EXPECT_EQ(global(settings, "gap"), "5");
    EXPECT_DOUBLE_EQ(*as_length(*settings.globals.find("rows"), document), 11 * 96 / 25.4);
    EXPECT_EQ(global(settings, "ink"), "[#1a1a1a, #ff0000, #a03020]");
    EXPECT_EQ(settings.limits.elements, 2000000U);
    EXPECT_EQ(settings.limits.memory_bytes, 4000000000U);
    EXPECT_EQ(settings.limits.depth, 50U);
    EXPECT_EQ(settings.symmetry->text, "p4m");
    EXPECT_EQ(settings.styles.size(), 1U);
    EXPECT_EQ(settings.rules.size(), 1U);
    EXPECT_EQ(settings.rule_spans.size(), 1U);
}

TEST(ReadingSettings, ReportsEveryProblemAtItsPlace) {
    const Document none = document_of("seed 1\n");
    EXPECT_EQ(codes_of(read_settings(none).diagnostics(), none), "language.no-grammar@\n");
    EXPECT_EQ(complaints(""), "");
    EXPECT_EQ(complaints("grammar tangle"), "language.repeated-statement@grammar tangle\n");
    EXPECT_EQ(complaints("let a = 1\nlet a = 2"), "language.doubled-name@a\n");
    EXPECT_EQ(complaints("let a = 1\npalette a = [#000]"), "language.doubled-name@a\n");
    EXPECT_EQ(complaints("let a = b\nlet b = 2\nlet c = a"), "language.used-before-definition@b\n");
    EXPECT_EQ(complaints("let a = a + 1"), "language.used-before-definition@a\n");
    EXPECT_EQ(complaints("let a = foo\nlet b = a"), "language.unknown-name@foo\n");
    EXPECT_EQ(complaints("let a = true ? 1 : foo"), "language.unknown-name@foo\n");
    EXPECT_EQ(complaints("let a = page.width"), "language.unknown-name@page.width\n");
    EXPECT_EQ(complaints("let a = page.width\npage a4"), "language.used-before-definition@page.width\n");
    EXPECT_EQ(complaints("page a4\nlet a = page.width"), "");
    EXPECT_EQ(complaints("page a44"), "language.unknown-page@a44\n");
    EXPECT_EQ(complaints("page 0 x 10"), "language.out-of-range@0\n");
    EXPECT_EQ(complaints("page 10 x 10 margin 5"), "language.out-of-range@5\n");
    EXPECT_EQ(complaints("page fit margin -1"), "language.out-of-range@-1\n");
    EXPECT_EQ(complaints("page a4\npage a5"), "language.repeated-statement@page a5\n");
    EXPECT_EQ(complaints("limit elemnts 5"), "language.unknown-limit@elemnts\n");
    EXPECT_EQ(complaints("limit elements 0"), "language.out-of-range@0\n");
    EXPECT_EQ(complaints("limit depth 2.5"), "language.out-of-range@2.5\n");
    EXPECT_EQ(complaints("limit depth 2mm"), "language.wrong-kind@2mm\n");
    EXPECT_EQ(complaints("resolution 0"), "language.out-of-range@0\n");
    EXPECT_EQ(complaints("resolution 3deg"), "language.wrong-kind@3deg\n");
    EXPECT_EQ(complaints("param a = 9 in 1..5"), "language.out-of-range@9\n");
    EXPECT_EQ(complaints("param a = 9mm in 1cm..5cm"), "language.out-of-range@9mm\n");
    EXPECT_EQ(complaints("param a = 9deg in 1cm..5cm"), "language.wrong-kind@9deg\n");
    EXPECT_EQ(complaints("param a = 1 in 5..1"), "language.empty-range@5..1\n");
    EXPECT_EQ(complaints("param a = 1 in 5"), "language.wrong-kind@5\n");
    EXPECT_EQ(complaints("param a = 1..6 in 1..5"), "language.out-of-range@6\n");
    EXPECT_EQ(complaints("param a = 1 in 1..5 step 0"), "language.wrong-kind@0\n");
    EXPECT_EQ(complaints("param a = 3 in [1, 2]"), "language.out-of-range@3\n");
    EXPECT_EQ(complaints("param a = 2 in [1, 2]\nparam b = wave in [line, wave]"), "");
    EXPECT_EQ(complaints("palette a = #000"), "language.wrong-kind@#000\n");
    EXPECT_EQ(complaints("palette a = [#000, rde, 5]"), "language.unknown-name@rde\n");
    EXPECT_EQ(complaints("palette a = [#000, 5]"), "language.wrong-kind@5\n");
    EXPECT_EQ(complaints("palette max = [#000]"), "language.reserved-name@max\n");
    EXPECT_EQ(complaints("let area = 5"), "language.hidden-name@area\n");
    EXPECT_EQ(complaints("let a = 1\nlet a = 2\nlet b = foo\nlimit x 3"),
              "language.doubled-name@a\nlanguage.unknown-name@foo\nlanguage.unknown-limit@x\n");
}

TEST(ReadingSettings, MessagesSayWhereAndWhat) {
    const Document document =
        document_of("grammar tangle\nlet a = b\nlet b = 2\nparam c = 9mm in 1cm..5cm\nlet b = 3\n");
    const Result<Settings> settings = read_settings(document);
    ASSERT_EQ(settings.diagnostics().size(), 3U);
    EXPECT_EQ(settings.diagnostics()[0].message, "'b' is used before it is defined");
    EXPECT_EQ(settings.diagnostics()[0].hints, std::vector<std::string>{"it is defined on line 3"});
    EXPECT_EQ(settings.diagnostics()[2].hints, std::vector<std::string>{"it is defined on line 3"});
    const Document page = document_of("grammar tangle\npage latter");
    EXPECT_EQ(read_settings(page).diagnostics()[0].hints, std::vector<std::string>{"did you mean 'letter'?"});
}

TEST(ReadingSettings, IncludedLengthsKeepTheirUnit) {
    const Document document =
        document_of("include \"mm.fil\"\ngrammar tangle\nunit px\nlet twice = gap * 2\n",
                    {{"mm.fil", "unit mm\nlet gap = 25.4\nresolution 1\nparam size = 254 in 1..300\npage a4"}});
    const Result<Settings> settings = read_settings(document);
    ASSERT_TRUE(settings) << to_text(settings.diagnostics(), document.sources);
    EXPECT_DOUBLE_EQ(*as_length(*settings->globals.find("gap"), document), 96);
    EXPECT_DOUBLE_EQ(*as_length(*settings->globals.find("twice"), document), 192);
    EXPECT_DOUBLE_EQ(settings->resolution, 96 / 25.4);
    EXPECT_EQ(settings->page.kind, PageStatement::Kind::fit);
    EXPECT_EQ(complaints("include \"a.fil\"\nlet gap = 3", {{"a.fil", "let gap = 5"}}), "language.doubled-name@gap\n");
    EXPECT_EQ(complaints("include \"a.fil\"\nresolution 3", {{"a.fil", "resolution 5"}}), "");
}

TEST(ReadingSettings, PagesAreMetricByNameOrUnit) {
    const auto page = [](const std::string& text) {
        const Document document = document_of("grammar tangle\n" + text);
        const Result<Settings> settings = read_settings(document);
        EXPECT_TRUE(settings) << text;
        return settings ? settings->page : Page{};
    };
    EXPECT_TRUE(page("page a4").in_mm);
    EXPECT_DOUBLE_EQ(page("page a4").height, 297 * 96 / 25.4);
    EXPECT_DOUBLE_EQ(page("page letter").width, 8.5 * 96);
    EXPECT_TRUE(page("unit mm\npage 100 x 100").in_mm);
    EXPECT_FALSE(page("page 100 x 100").in_mm);
    EXPECT_FALSE(page("unit mm\npage 1in x 100px").in_mm);
    EXPECT_TRUE(page("page 10cm x 100mm").in_mm);
    EXPECT_EQ(page("page tile 100 x 50").kind, PageStatement::Kind::tile);
    EXPECT_EQ(page("").kind, PageStatement::Kind::fit);
}

TEST(ReadingSettings, ChoicesAreDrawnOnceUnderTheirName) {
    std::set<std::string> values;
    for (int seed = 0; seed < 30; ++seed) {
        const std::string head = "grammar tangle\nseed " + std::to_string(seed) + "\n";
        const Document document = document_of(head +
                                              "let a = 0..1\nlet b = a + a - 2 * a\nparam n = 5..9 in 1..20 step 1\n"
                                              "param m = normal(5, 9) in 4..6\n");
        const Result<Settings> settings = read_settings(document);
        ASSERT_TRUE(settings) << to_text(settings.diagnostics(), document.sources);
        EXPECT_EQ(global(*settings, "b"), "0");
        const double n = *as_number(*settings->globals.find("n")), m = *as_number(*settings->globals.find("m"));
        EXPECT_TRUE(n == 5 || n == 6 || n == 7 || n == 8 || n == 9);
        EXPECT_TRUE(m >= 4 && m <= 6);
        values.insert(global(*settings, "a"));
        // What else the document holds changes nothing.
        const Document other = document_of(head + "let z = 3..4\nlet a = 0..1\n");
        EXPECT_EQ(global(*read_settings(other), "a"), global(*settings, "a"));
    }
    EXPECT_EQ(values.size(), 30U);
}

}  // namespace
}  // namespace filigree
