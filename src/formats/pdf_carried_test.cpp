#include "formats/pdf_carried.h"

#include <gtest/gtest.h>

#include "base/test_cases.h"
#include "formats/pdf_test_reader.h"
#include "formats/pdf_write.h"
#include "formats/test_drawings.h"

namespace filigree {
namespace {

std::string pdf_with(const CarriedDocument& carried) {
    PdfOptions options;
    options.carried = &carried;
    return to_pdf(drawing_of(polygons_of({rectangle_ring(0, 0, 5, 5)}), filled(black), {10, 10}), options);
}

void expect_back(const CarriedDocument& carried) {
    const Result<std::optional<CarriedDocument>> back = carried_document_of_pdf(pdf_with(carried));
    ASSERT_TRUE(back) << back.diagnostics()[0].message;
    ASSERT_TRUE(back->has_value());
    EXPECT_TRUE(**back == carried);
}

TEST(PdfCarried, ComesBackByteForByte) {
    expect_back({{"leaf.fil", "grammar tangle\nseed 2016\n"}, {}});
    expect_back({{"", ""}, {}});
    expect_back({{"a/b (c)\\.fil", std::string("\0\xff\r\n>> endobj", 12)}, {{"", "x"}, {"\xff\xfe", ""}}});
    expect_back({{"long", std::string(3'000'000, 'x')}, std::vector<CarriedFile>(30, {"leaf.svg", "<svg/>"})});
    // A PDF that carries a document may be carried itself.
    expect_back({{"outer.fil", "seed 1"}, {{"inner.pdf", pdf_with({{"inner.fil", "seed 2"}, {{"a", "b"}}})}}});
}

TEST(PdfCarried, ViewersFindTheAttachments) {
    const TestPdf pdf = read_test_pdf(pdf_with({{"dir/leaf.fil", "seed 1"}, {{"\xC3\xA4.svg", "<svg/>"}}}));
    const std::string catalog = pdf.catalog();
    const std::string list = "/EmbeddedFiles << /Names [(00000000) ";
    const std::size_t at = catalog.find(list);
    ASSERT_NE(at, std::string::npos) << catalog;
    const std::string first = pdf.object(catalog.substr(at + list.size()));
    EXPECT_EQ(TestPdf::value(first, "/UF"), "(leaf.fil)");
    EXPECT_EQ(TestPdf::stream(pdf.object(TestPdf::value(first, "/EF << /F"))), "seed 1");
    const std::size_t next = catalog.find("(00000001) ");
    ASSERT_NE(next, std::string::npos);
    const std::string second = pdf.object(catalog.substr(next + 11));
    EXPECT_EQ(TestPdf::value(second, "/UF"), "<FEFF00E4002E007300760067");
    EXPECT_EQ(TestPdf::stream(pdf.object(TestPdf::value(second, "/EF << /F"))), "<svg/>");
}

TEST(PdfCarried, NoticesDamage) {
    const auto code_of = [](const std::string& pdf) -> std::string {
        const Result<std::optional<CarriedDocument>> back = carried_document_of_pdf(pdf, 4);
        if (back) return back->has_value() ? "there" : "none";
        EXPECT_EQ(back.diagnostics()[0].span.file, 4U);
        return back.diagnostics()[0].code;
    };
    const std::string pdf = pdf_with({{"leaf.fil", "seed 2016, and some more text"}, {{"leaf.svg", "<svg/>"}}});
    const auto replaced = [&](const std::string& what, const std::string& by) {
        std::string text = pdf;
        return text.replace(text.rfind(what), what.size(), by);
    };
    EXPECT_EQ(code_of(pdf), "there");
    EXPECT_EQ(code_of(""), "none");
    EXPECT_EQ(code_of(to_pdf(Drawing{}, {})), "none");
    EXPECT_EQ(code_of(replaced("/Version 1", "/Version 2")), "pdf.carried-version");
    EXPECT_EQ(code_of(replaced("/Version 1", "/Version x")), "pdf.carried-damaged");
    EXPECT_EQ(code_of(replaced("/FiligreeName <6C", "/FiligreeName <6D")), "pdf.carried-damaged");
    EXPECT_EQ(code_of(replaced("/Size 6 ", "/Size 7 ")), "pdf.carried-damaged");
    EXPECT_EQ(code_of(replaced("startxref", "startyref")), "pdf.carried-damaged");
    EXPECT_EQ(code_of(" " + pdf), "pdf.carried-damaged");
    EXPECT_EQ(code_of(pdf.substr(0, pdf.size() - 40)), "pdf.carried-damaged");
}

TEST(PdfCarried, RandomDamageIsNoticedOrHarmless) {
    const CarriedDocument carried{{"leaf.fil", "seed 2016\nstart rectangle(10, 10)\n"}, {{"leaf.svg", "<svg/>"}}};
    const std::string pdf = pdf_with(carried);
    std::uint64_t noticed = 0;
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed);
        std::string damaged = pdf;
        if (random.below(4) == 0) damaged.resize(random.index(damaged.size()));
        for (std::uint32_t i = 1 + random.below(3); i > 0 && !damaged.empty(); --i) {
            damaged[random.index(damaged.size())] = static_cast<char>(random.below(256));
        }
        const Result<std::optional<CarriedDocument>> back = carried_document_of_pdf(damaged);
        if (!back) ++noticed;
        if (!back || !back->has_value()) continue;
        // A file may fall off the list; what comes back is what was carried.
        EXPECT_TRUE((*back)->document == carried.document || (*back)->document == carried.inputs[0]) << "seed " << seed;
    }
    EXPECT_GT(noticed, 0U);
}

}  // namespace
}  // namespace filigree
