#include "formats/csv_read.h"

#include <gtest/gtest.h>

#include "base/test_cases.h"

namespace filigree {
namespace {

using Cells = std::vector<std::vector<std::string>>;

Cells cells(std::string_view text) {
    Cells all;
    const Result<std::vector<CsvRow>> rows = read_csv(text);
    EXPECT_TRUE(rows) << text;
    if (!rows) return all;
    for (const CsvRow& row : *rows) all.push_back(row.cells);
    return all;
}
std::string complaint(std::string_view text) {
    const Result<std::vector<CsvRow>> rows = read_csv(text);
    return rows ? "" : rows.diagnostics().front().code + ": " + rows.diagnostics().front().message;
}

TEST(CsvRead, RowsAndCells) {
    EXPECT_EQ(cells("ab,P+C\nbbc,\n"), (Cells{{"ab", "P+C"}, {"bbc", ""}}));
    EXPECT_EQ(cells("\xEF\xBB\xBF\xC3\xB1,b\r\nc, d "), (Cells{{"\xC3\xB1", "b"}, {"c", " d "}}));
    EXPECT_EQ(cells("\"a,b\",\"c\"\"d\ne\"\nf,g\"h"), (Cells{{"a,b", "c\"d\ne"}, {"f", "g\"h"}}));
    EXPECT_EQ(cells("a\n\nb\n"), (Cells{{"a"}, {""}, {"b"}})) << "an empty line is an empty cell";
    EXPECT_EQ(cells("\"\""), (Cells{{""}}));
    EXPECT_EQ((*read_csv("\"a\nb\"\nc"))[1].line, 3U);
}

TEST(CsvRead, WhatIsWrongNamesItsLine) {
    EXPECT_EQ(complaint(""), "csv.empty: the table has no cells");
    EXPECT_EQ(complaint("a,b\nc,d\ne\n"), "csv.ragged: line 3 has 1 cell, where the first has 2 cells");
    EXPECT_EQ(complaint("a\n\"b\nc"), "csv.unclosed-quote: line 2 opens a quote that nothing closes");
    EXPECT_EQ(complaint("a\n\"b\" ,c"), "csv.text-behind-quote: line 2 goes on behind a closing quote");
    EXPECT_EQ(complaint("a\nb\xFF\n"), "csv.not-utf8: line 2 is no valid UTF-8");
}

TEST(CsvRead, ReadsWhatIsWritten) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed);
        const std::size_t columns = 1 + random.below(4);
        Cells written(1 + random.below(4));
        std::string text;
        for (std::vector<std::string>& row : written) {
            for (std::size_t c = 0; c < columns; ++c) {
                std::string cell, quoted;
                for (std::uint32_t left = random.below(5); left > 0; --left) {
                    cell += "ab,\"\n\r+ "[random.index(8)];
                    quoted += cell.back() == '"' ? "\"\"" : cell.substr(cell.size() - 1);
                }
                text += (c > 0 ? ",\"" : "\"") + quoted + '"';
                row.push_back(cell);
            }
            text += random.coin() ? "\n" : "\r\n";
        }
        ASSERT_EQ(cells(text), written) << text;
    }
}

TEST(CsvRead, AnyBytesAreReadOrRefused) {
    for (std::uint64_t seed = 0; seed < case_count(); ++seed) {
        CaseRandom random(seed);
        std::string text;
        for (std::uint32_t left = random.below(30); left > 0; --left) text += "a,\"\n\r\xC3\xB1\xEF"[random.index(8)];
        const Result<std::vector<CsvRow>> rows = read_csv(text);
        if (!rows) continue;
        for (const CsvRow& row : *rows) ASSERT_EQ(row.cells.size(), rows->front().cells.size());
    }
}

}  // namespace
}  // namespace filigree
