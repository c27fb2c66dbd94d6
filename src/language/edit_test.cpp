#include "language/edit.h"

#include <gtest/gtest.h>

#include <limits>

#include "base/test_cases.h"
#include "language/parse.h"
#include "language/random_text.h"
#include "language/unparse.h"

namespace filigree {
namespace {

Parsed parsed(std::string_view text) { return parse_document("case.fil", text, nullptr); }
std::string seeded(std::string_view text, std::uint64_t seed) { return with_seed(parsed(text).document, seed); }

std::string edited(std::string_view text, std::string_view name, std::string_view value) {
    const Result<std::string> result = with_parameter(parsed(text).document, name, value);
    if (result) return *result;
    const Diagnostic& problem = result.diagnostics().front();
    return problem.code + (problem.hints.empty() ? "" : " " + problem.hints.front());
}

TEST(WithSeed, ReplacesTheDigitsAlone) {
    EXPECT_EQ(seeded("grammar tangle\nseed   7 # why\n", 12), "grammar tangle\nseed   12 # why\n");
    EXPECT_EQ(seeded("seed 7;grammar tangle", 18446744073709551615U), "seed 18446744073709551615;grammar tangle");
    EXPECT_EQ(seeded("unit mm ; seed\t7", 0), "unit mm ; seed\t0");
}

TEST(WithSeed, AddsAStatementBehindGrammar) {
    EXPECT_EQ(seeded("grammar tangle\nunit mm\n", 5), "grammar tangle\nseed 5\nunit mm\n");
    EXPECT_EQ(seeded("grammar tangle # kind\r\nunit mm\r\n", 5), "grammar tangle # kind\r\nseed 5\r\nunit mm\r\n");
    EXPECT_EQ(seeded("grammar tangle", 5), "grammar tangle\nseed 5");
    EXPECT_EQ(seeded("filigree 1\r\ngrammar tangle # kind", 5), "filigree 1\r\ngrammar tangle # kind\r\nseed 5");
    EXPECT_EQ(seeded("grammar tangle; start a = f(\n2)\n", 5), "grammar tangle; seed 5; start a = f(\n2)\n");
    EXPECT_EQ(seeded("grammar tangle ;", 5), "grammar tangle; seed 5 ;");
}

TEST(WithSeed, AddsAStatementWithoutGrammar) {
    EXPECT_EQ(seeded("", 5), "seed 5\n");
    EXPECT_EQ(seeded("unit mm\r\n", 5), "seed 5\r\nunit mm\r\n");
    EXPECT_EQ(seeded("\xEF\xBB\xBFunit mm\n", 5), "\xEF\xBB\xBFseed 5\nunit mm\n");
    EXPECT_EQ(seeded("filigree 1\nunit mm\n", 5), "filigree 1\nseed 5\nunit mm\n");
}

TEST(WithSeed, LeavesIncludedFilesAlone) {
    const IncludeLoader loader = [](std::string_view) {
        return Result<std::string>(std::string("grammar tangle\nseed 3\nlet a = 1"));
    };
    const Parsed document = parse_document("case.fil", "include \"a.fil\"\n", loader);
    EXPECT_EQ(with_seed(document.document, 5), "seed 5\ninclude \"a.fil\"\n");
}

TEST(WithParameter, ReplacesTheValueAlone) {
    EXPECT_EQ(edited("param gap = 25 in 10..60 step 1 \"why\" # note\r\n", "gap", "30"),
              "param gap = 30 in 10..60 step 1 \"why\" # note\r\n");
    EXPECT_EQ(edited("unit mm;param gap=25;let a=gap", "gap", "30"), "unit mm;param gap=30;let a=gap");
    EXPECT_EQ(edited("param gap = 25", "gap", "  width / 40 # note\n"), "param gap = width / 40");
    EXPECT_EQ(edited("param p\xC3\xA9 = 25", "pe\xCC\x81", "30"), "param p\xC3\xA9 = 30");
}

TEST(WithParameter, KeepsTheValueApartFromWhatFollows) {
    EXPECT_EQ(edited("param gap = (25)in 10..60", "gap", "30"), "param gap = 30 in 10..60");
    EXPECT_EQ(edited("param gap = (25)\"why\"", "gap", "30"), "param gap = 30 \"why\"");
    EXPECT_EQ(edited("param gap = 25 in 10..60", "gap", "a ? 20 : 30"), "param gap = (a ? 20 : 30) in 10..60");
    EXPECT_EQ(edited("param gap = 25", "gap", "(a) ? (20) : (30)"), "param gap = ((a) ? (20) : (30))");
    EXPECT_EQ(edited("param gap = 25", "gap", "(a ? 20 : 30)"), "param gap = (a ? 20 : 30)");
    EXPECT_EQ(edited("param gap = 25", "gap", "normal(20, 3) in 15..25"), "param gap = (normal(20, 3) in 15..25)");
    EXPECT_EQ(edited("param gap = 25\n", "gap", "max(20, # one\n 30)"), "param gap = max(20, # one\n 30)\n");
}

TEST(WithParameter, RefusesWhatIsNoParameterOrExpression) {
    EXPECT_EQ(edited("param spacing = 25", "spacign", "30"), "edit.unknown-parameter did you mean 'spacing'?");
    EXPECT_EQ(edited("param gap = 25", "gap", "30 +"), "language.missing-value");
    EXPECT_EQ(edited("param gap = 25", "gap", ""), "language.missing-value");
    EXPECT_EQ(edited("param gap = 25", "gap", "30; seed 5"), "language.unexpected-token");
    EXPECT_EQ(edited("param gap = 25", "gap", "30\nseed 5"), "language.unexpected-token");
    const IncludeLoader loader = [](std::string_view) { return Result<std::string>(std::string("param gap = 25")); };
    const Parsed document = parse_document("case.fil", "include \"a.fil\"\n", loader);
    EXPECT_EQ(with_parameter(document.document, "gap", "30").diagnostics().at(0).code, "edit.included-parameter");
}

TEST(WithParameter, KeepsToTheDomain) {
    constexpr std::string_view range = "unit mm\nparam gap = 25 in 10..60\n";
    for (const std::string_view value : {"10", "60", "35mm", "1cm", "10..60", "width", "59 + 1", "normal(90, 1)"}) {
        EXPECT_NE(edited(range, "gap", value), "language.out-of-range") << value;
    }
    for (const std::string_view value : {"9.999", "61", "-10", "7cm", "5..20", "20..70", "30 * 3"}) {
        EXPECT_EQ(edited(range, "gap", value), "language.out-of-range") << value;
    }
    EXPECT_EQ(edited("param gap = 25mm in 10mm..60mm", "gap", "30deg"), "language.wrong-kind");
    constexpr std::string_view words = "let other = 5; param way = line in [line, wave]";
    EXPECT_EQ(edited(words, "way", "wave"), "let other = 5; param way = wave in [line, wave]");
    EXPECT_EQ(edited(words, "way", "other"), "let other = 5; param way = other in [line, wave]");
    EXPECT_EQ(edited(words, "way", "zigzag"), "language.out-of-range");
    EXPECT_EQ(edited("param n = 1 in one_of(1, 3: 2)", "n", "3"), "param n = 3 in one_of(1, 3: 2)");
    EXPECT_EQ(edited("param n = 1 in [1, 3]", "n", "2"), "language.out-of-range");
}

// The new text differs in one place alone, and parses to the same statements but for the value.
TEST(Edits, ChangeTheSplicedBytesAlone) {
    const std::uint64_t cases = case_count();
    for (std::uint64_t seed = 0; seed < cases; ++seed) {
        RandomText random(seed);
        const RandomDocument wanted = random.document();
        const Document document = parsed(wanted.text).document;
        const std::uint64_t new_seed = random.bits() >> random.below(64);
        const std::string text = with_seed(document, new_seed);
        const Parsed again = parsed(text);
        ASSERT_TRUE(again.diagnostics.empty()) << "seed " << seed << "\n" << text;
        EXPECT_EQ(with_seed(again.document, new_seed), text) << "seed " << seed;

        std::vector<std::string> before, after;
        for (const Statement& statement : document.statements) {
            if (!std::holds_alternative<SeedStatement>(statement.node)) before.push_back(unparse(statement));
        }
        std::size_t seeds = 0;
        for (const Statement& statement : again.document.statements) {
            const SeedStatement* node = std::get_if<SeedStatement>(&statement.node);
            if (node == nullptr) {
                after.push_back(unparse(statement));
            } else {
                ++seeds;
                EXPECT_EQ(node->seed, new_seed) << "seed " << seed;
            }
        }
        EXPECT_EQ(before, after) << "seed " << seed;
        EXPECT_EQ(seeds, 1U) << "seed " << seed;
    }
}

TEST(Edits, ChangeOneParameterAlone) {
    const std::uint64_t cases = case_count();
    std::uint64_t edits = 0;
    for (std::uint64_t seed = 0; seed < cases; ++seed) {
        RandomText random(seed);
        const RandomDocument wanted = random.document();
        if (wanted.parameters.empty()) continue;
        const std::string name = wanted.parameters[random.below(static_cast<std::uint32_t>(wanted.parameters.size()))];
        const std::string value = random.expression(2);
        const Document document = parsed(wanted.text).document;
        const Result<std::string> text = with_parameter(document, name, value);
        if (!text) {
            const std::string code = text.diagnostics().front().code;
            EXPECT_TRUE(code == "language.out-of-range" || code == "language.wrong-kind") << "seed " << seed << code;
            continue;
        }
        ++edits;
        const Parsed again = parsed(*text);
        ASSERT_TRUE(again.diagnostics.empty()) << "seed " << seed << "\n"
                                               << to_text(again.diagnostics, again.document.sources);
        ASSERT_EQ(again.document.statements.size(), document.statements.size()) << "seed " << seed;
        for (std::size_t i = 0; i < document.statements.size(); ++i) {
            const Statement& old = document.statements[i];
            Statement now = again.document.statements[i];
            if (ParamStatement* param = std::get_if<ParamStatement>(&now.node);
                param != nullptr && param->name.text == name) {
                EXPECT_EQ(unparse(param->value), unparse(*parse_expression(value))) << "seed " << seed;
                const ParamStatement& was = std::get<ParamStatement>(old.node);
                param->value = was.value;
                const std::string_view before = document.text(), after = *text;
                EXPECT_EQ(before.substr(0, was.value->span.begin), after.substr(0, was.value->span.begin));
                EXPECT_TRUE(after.ends_with(before.substr(was.value->span.end))) << "seed " << seed;
            }
            EXPECT_EQ(unparse(now), unparse(old)) << "seed " << seed;
        }
    }
    EXPECT_GT(edits, cases / 4);
}

}  // namespace
}  // namespace filigree
