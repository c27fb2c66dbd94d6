#include "language/wrong_documents.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

#include "language/parse.h"
#include "language/settings.h"
#include "language/shape_rules.h"

namespace filigree {
namespace {

// Every code that parsing may give.
constexpr std::array<std::string_view, 53> parse_codes = {
    "language.bad-colour",        "language.bad-escape",        "language.bad-ordinal",
    "language.bad-page",          "language.bad-path",          "language.bad-point",
    "language.bad-seed",          "language.bad-tag",           "language.bad-target",
    "language.bad-times",         "language.bad-unit",          "language.comment-blank",
    "language.include-cycle",     "language.include-depth",     "language.include-in-system",
    "language.lone-equals",       "language.long-chain",        "language.long-name",
    "language.missing-arguments", "language.missing-arrow",     "language.missing-brace",
    "language.missing-colon",     "language.missing-equals",    "language.missing-from",
    "language.missing-name",      "language.missing-place",     "language.missing-side",
    "language.unknown-clause",    "language.missing-operator",  "language.missing-path",
    "language.missing-tag",       "language.missing-text",      "language.missing-to",
    "language.missing-value",     "language.nesting",           "language.no-include",
    "language.no-such-sign",      "language.not-a-rule",        "language.not-utf8",
    "language.number-too-large",  "language.repeated-clause",   "language.repeated-statement",
    "language.stray-character",   "language.too-large",         "language.too-many-errors",
    "language.trailing-comma",    "language.unclosed-bracket",  "language.unexpected-token",
    "language.unknown-statement", "language.unknown-unit",      "language.unknown-version",
    "language.unmatched-bracket", "language.unterminated-text",
};
// Those that need more than a short document: parse_test.cpp has them.
const std::set<std::string_view> tested_elsewhere = {
    "language.include-cycle", "language.include-depth", "language.long-chain", "language.long-name",
    "language.nesting",       "language.no-include",    "language.too-large",  "language.too-many-errors",
};

bool is_parse_code(std::string_view code) {
    return std::find(parse_codes.begin(), parse_codes.end(), code) != parse_codes.end();
}

std::vector<WrongDocument> all_cases() {
    return read_wrong_documents(FILIGREE_SOURCE_DIR "/tests/data/wrong_documents.txt");
}

TEST(WrongDocuments, ParsingSaysWhatIsExpected) {
    int checked = 0;
    for (const WrongDocument& wrong : all_cases()) {
        // What is repeated may be for a later layer to see.
        const bool is_about_parsing =
            std::any_of(wrong.expected.begin(), wrong.expected.end(), [](const ExpectedDiagnostic& expected) {
                return is_parse_code(expected.code) && expected.code != "language.repeated-statement";
            });
        const Parsed parsed = parse_document("case.fil", wrong.text, nullptr);
        if (is_about_parsing || !parsed.diagnostics.empty()) {
            EXPECT_EQ(difference(wrong, parsed.diagnostics, parsed.document.sources), "");
            ++checked;
        }
        EXPECT_EQ(wrong.malformed, "") << wrong.name;
        EXPECT_EQ(parsed.document.text(), wrong.text);
    }
    EXPECT_GE(checked, 100);
}

// What is wrong with names and kinds of a shape grammar that parses.
TEST(WrongDocuments, ReadingRulesOfShapesSaysWhatIsExpected) {
    int checked = 0;
    for (const WrongDocument& wrong : all_cases()) {
        const Parsed parsed = parse_document("case.fil", wrong.text, nullptr);
        if (!wrong.text.starts_with("grammar shape\n") || !parsed.diagnostics.empty()) continue;
        const Result<Settings> settings = read_settings(parsed.document);
        Diagnostics found = settings.diagnostics();
        if (settings) append(found, read_shape_rules(parsed.document, settings->globals).diagnostics());
        std::sort(found.begin(), found.end(),
                  [](const Diagnostic& one, const Diagnostic& other) { return one.span.begin < other.span.begin; });
        EXPECT_EQ(difference(wrong, found, parsed.document.sources), "");
        ++checked;
    }
    EXPECT_GE(checked, 9);
}

TEST(WrongDocuments, EveryCaseHasANameOfItsOwnAndExpectsSomething) {
    std::set<std::string> names;
    for (const WrongDocument& wrong : all_cases()) {
        EXPECT_TRUE(names.insert(wrong.name).second) << wrong.name;
        EXPECT_FALSE(wrong.expected.empty()) << wrong.name;
    }
}

TEST(WrongDocuments, EveryCodeOfParsingHasACase) {
    std::set<std::string> seen;
    for (const WrongDocument& wrong : all_cases()) {
        for (const ExpectedDiagnostic& expected : wrong.expected) seen.insert(expected.code);
    }
    for (const std::string_view code : parse_codes) {
        EXPECT_TRUE(tested_elsewhere.count(code) == 1 || seen.count(std::string(code)) == 1) << code;
    }
}

TEST(WrongDocuments, TheComparisonCanFail) {
    WrongDocument wrong{"none", "grammar tangle\nsed 5\n", {{{2, 1}, "language.unknown-statement", "'seed'"}}, ""};
    const Parsed parsed = parse_document("case.fil", wrong.text, nullptr);
    const auto differs = [&](const WrongDocument& with) {
        return !difference(with, parsed.diagnostics, parsed.document.sources).empty();
    };
    EXPECT_FALSE(differs(wrong));
    WrongDocument other = wrong;
    other.expected[0].place.column = 2;
    EXPECT_TRUE(differs(other));
    other = wrong;
    other.expected[0].code = "language.bad-seed";
    EXPECT_TRUE(differs(other));
    other = wrong;
    other.expected[0].hint = "'start'";
    EXPECT_TRUE(differs(other));
    other = wrong;
    other.expected.push_back(wrong.expected[0]);
    EXPECT_TRUE(differs(other));
    other = wrong;
    other.expected.clear();
    EXPECT_TRUE(differs(other));
    other = wrong;
    other.malformed = "x";
    EXPECT_TRUE(differs(other));
}

}  // namespace
}  // namespace filigree
