#include "language/edit_presets.h"

#include <gtest/gtest.h>

#include "base/test_cases.h"
#include "language/choice_path.h"
#include "language/parse.h"
#include "language/random_text.h"
#include "language/unparse.h"

namespace filigree {
namespace {

Parsed parsed(std::string_view text) { return parse_document("case.fil", text, nullptr); }
std::string shown(const Result<std::string>& result) { return result ? *result : result.diagnostics().front().code; }
std::string preset(std::string_view text, std::string_view path, std::string_view value) {
    return shown(with_preset(parsed(text).document, path, value));
}
std::string unset(std::string_view text, std::string_view path) {
    return shown(without_preset(parsed(text).document, path));
}
std::string kept(std::string_view text, std::string_view path) { return shown(with_keep(parsed(text).document, path)); }
std::string unkept(std::string_view text, std::string_view path) {
    return shown(without_keep(parsed(text).document, path));
}
std::string rerolled(std::string_view text, std::string_view path, std::uint32_t more = 1) {
    return shown(with_reroll(parsed(text).document, path, more));
}
std::string applied(std::string_view text, std::string_view call, const std::vector<std::string>& targets,
                    std::string_view outputs = "") {
    return shown(with_apply(parsed(text).document, call, targets, outputs));
}

// --- set and default ---------------------------------------------------------------------------------------------

TEST(WithPreset, ReplacesTheLastValue) {
    EXPECT_EQ(preset("set a.b = 1\nset  a.b=2 # why\nset a.b = 3 when c\nset a.c = 4\n", "a.b", "5..9"),
              "set a.b = 1\nset  a.b=5..9 # why\nset a.b = 3 when c\nset a.c = 4\n");
    EXPECT_EQ(preset("set a[2,1]/**/**.b = max(1,\r\n  2);keep c", "a[1,2]/**.b", " (c ? 1 : 2) # note\n"),
              "set a[2,1]/**/**.b = (c ? 1 : 2);keep c");
    EXPECT_EQ(preset("default a.b = 1\n", "a.b", "2"), "default a.b = 1\nset a.b = 2\n");
    EXPECT_EQ(preset("system s { set a.b = 1 }\n", "a.b", "2"), "system s { set a.b = 1 }\nset a.b = 2\n");
    EXPECT_EQ(preset("set a.b = 1 when c", "a.b", "2"), "set a.b = 1 when c\nset a.b = 2\n");
}

TEST(WithPreset, AddsALine) {
    EXPECT_EQ(preset("", "a/**/**.b", "5"), "set a/**.b = 5\n");
    EXPECT_EQ(preset("\xEF\xBB\xBF", "a.b", "5"), "\xEF\xBB\xBFset a.b = 5\n");
    EXPECT_EQ(preset("unit mm", "a.b", "5"), "unit mm\nset a.b = 5\n");
    EXPECT_EQ(preset("unit mm\n", "a.b", "5"), "unit mm\nset a.b = 5\n");
    EXPECT_EQ(preset("unit mm\r\nseed 5\r\n", "a.b", "5"), "unit mm\r\nseed 5\r\nset a.b = 5\r\n");
    EXPECT_EQ(preset("unit mm\r\nseed 5", "a.b", "5"), "unit mm\r\nseed 5\r\nset a.b = 5\r\n");
    EXPECT_EQ(preset("unit mm;  # note", "a.b", "#a03"), "unit mm;  # note\nset a.b = #a03\n");
    EXPECT_EQ(preset("unit mm\n\n  ", "a.b", "5"), "unit mm\n\n  \nset a.b = 5\n");
}

TEST(WithPreset, AParametersNameMeansTheParameter) {
    constexpr std::string_view text = "param gap = 25 in 10..60 # why\nlet low = 3\n";
    EXPECT_EQ(preset(text, "gap", "30"), "param gap = 30 in 10..60 # why\nlet low = 3\n");
    EXPECT_EQ(preset(text, "let/gap", "30"), "param gap = 30 in 10..60 # why\nlet low = 3\n");
    EXPECT_EQ(preset(text, "gap", "70"), "language.out-of-range");
    EXPECT_EQ(preset(text, "low", "4"), std::string(text) + "set low = 4\n");
    EXPECT_EQ(preset(text, "gap~2", "4"), std::string(text) + "set gap~2 = 4\n");
    EXPECT_EQ(preset(text, "gap.x", "4"), std::string(text) + "set gap.x = 4\n");
    EXPECT_EQ(preset(text, "gap[1]", "4"), std::string(text) + "set gap[1] = 4\n");
    // What counts is the `set`, where there is one.
    EXPECT_EQ(preset("param gap = 25\nset let/gap = 3\n", "gap", "4"), "param gap = 25\nset let/gap = 4\n");
    const IncludeLoader loader = [](std::string_view) { return Result<std::string>(std::string("param gap = 25")); };
    const Parsed document = parse_document("case.fil", "include \"a.fil\"", loader);
    EXPECT_EQ(shown(with_preset(document.document, "gap", "30")), "include \"a.fil\"\nset gap = 30\n");
}

TEST(WithDefault, IsLikeSetButForParameters) {
    EXPECT_EQ(shown(with_default(parsed("set a.b = 1\ndefault a.b = 2\n").document, "a.b", "3")),
              "set a.b = 1\ndefault a.b = 3\n");
    EXPECT_EQ(shown(with_default(parsed("param gap = 25\n").document, "gap", "3")),
              "param gap = 25\ndefault gap = 3\n");
}

TEST(WithPreset, SaysWhatIsWrong) {
    EXPECT_EQ(preset("", "a//b", "5"), "language.bad-path");
    EXPECT_EQ(preset("", "a = 3; keep b", "5"), "language.unexpected-token");
    EXPECT_EQ(preset("", "a.b", "5; keep b"), "language.unexpected-token");
    EXPECT_EQ(preset("", "a.b", "5 when c"), "language.unexpected-token");
    EXPECT_EQ(preset("", "a.b", ""), "language.missing-value");
    const Result<std::string> wrong = with_preset(parsed("").document, "a.b", "5 +");
    EXPECT_EQ(wrong.diagnostics().at(0).span, (SourceSpan{SourceSpan::no_file, 3, 3}));
}

TEST(WithoutPreset, TakesTheLastOneOut) {
    EXPECT_EQ(unset("set a.b = 1\nset a.b = 2\nset a.b = 3 when c\n", "a.b"), "set a.b = 1\nset a.b = 3 when c\n");
    EXPECT_EQ(unset("set let/gap = 1\n", "gap"), "");
    EXPECT_EQ(unset("default a.b = 1", "a.b"), "edit.no-such-preset");
    EXPECT_EQ(unset("set a.b = 1 when c", "a.b"), "edit.no-such-preset");
    EXPECT_EQ(unset("system s { set a.b = 1 }", "a.b"), "edit.no-such-preset");
    EXPECT_EQ(unset("", "a//b"), "language.bad-path");
    const Result<std::string> wrong =
        without_preset(parsed("set leaf/outline.distance = 3").document, "leaf/outlin.distance");
    EXPECT_EQ(wrong.diagnostics().at(0).message, "the document has no 'set' of 'leaf/outlin.distance'");
    EXPECT_EQ(wrong.diagnostics().at(0).hints.at(0), "did you mean 'leaf/outline.distance'?");
}

// --- keep --------------------------------------------------------------------------------------------------------

TEST(WithKeep, AddsWhatIsNotThere) {
    EXPECT_EQ(kept("unit mm\n", "a/b[2,1]"), "unit mm\nkeep a/b[1,2]\n");
    EXPECT_EQ(kept("keep a/b[1,2] # note", "a/b[2,1]"), "keep a/b[1,2] # note");
    EXPECT_EQ(kept("keep a.b\n", "a"), "keep a.b\nkeep a\n");
    EXPECT_EQ(kept("system s { keep a }\n", "a"), "system s { keep a }\nkeep a\n");
    EXPECT_EQ(kept("keep let/gap\n", "gap"), "keep let/gap\nkeep gap\n");
    EXPECT_EQ(kept("", "a b"), "language.unexpected-token");
}

TEST(WithoutKeep, TakesTheStatementOut) {
    EXPECT_EQ(unkept("unit mm\nkeep a\nseed 5\n", "a"), "unit mm\nseed 5\n");
    EXPECT_EQ(unkept("unit mm\r\n  keep a \t\r\nseed 5\r\n", "a"), "unit mm\r\nseed 5\r\n");
    EXPECT_EQ(unkept("unit mm\nkeep a", "a"), "unit mm\n");
    EXPECT_EQ(unkept("keep a", "a"), "");
    EXPECT_EQ(unkept("\xEF\xBB\xBFkeep a\nunit mm", "a"), "\xEF\xBB\xBFunit mm");
    EXPECT_EQ(unkept("unit mm\n\n  keep a # note\n", "a"), "unit mm\n\n  # note\n");
    EXPECT_EQ(unkept("  keep a ; keep b\n", "a"), "  keep b\n");
    EXPECT_EQ(unkept("keep a; # note\n", "a"), "# note\n");
    EXPECT_EQ(unkept("keep a;\nunit mm\n", "a"), "unit mm\n");
    EXPECT_EQ(unkept(" ; keep a ;\nunit mm\n", "a"), "  ;\nunit mm\n");
    EXPECT_EQ(unkept(" ; keep a\nunit mm\n", "a"), "unit mm\n");
    EXPECT_EQ(unkept("unit mm; keep a; seed 5\n", "a"), "unit mm; seed 5\n");
    EXPECT_EQ(unkept("unit mm ; keep a # note\n", "a"), "unit mm  # note\n");
    EXPECT_EQ(unkept("unit mm;keep a", "a"), "unit mm");
    EXPECT_EQ(unkept("let a = f(\n2); keep a\r\nunit mm", "a"), "let a = f(\n2)\r\nunit mm");
    EXPECT_EQ(unkept("keep a; keep a\nkeep b; keep a\nkeep a.b\n", "a"), "keep b\nkeep a.b\n");
    EXPECT_EQ(unkept("system s { keep a }", "a"), "edit.no-such-keep");
    EXPECT_EQ(unkept("keep a.b", "a"), "edit.no-such-keep");
    const IncludeLoader loader = [](std::string_view) { return Result<std::string>(std::string("keep a")); };
    const Parsed document = parse_document("case.fil", "include \"a.fil\"", loader);
    EXPECT_EQ(shown(without_keep(document.document, "a")), "edit.no-such-keep");
}

// --- reroll ------------------------------------------------------------------------------------------------------

TEST(WithReroll, CountsOn) {
    EXPECT_EQ(rerolled("unit mm", "a/b"), "unit mm\nreroll a/b\n");
    EXPECT_EQ(rerolled("", "a/b", 3), "reroll a/b x 3\n");
    EXPECT_EQ(rerolled("reroll a/b;seed 5 # note\n", "a/b"), "reroll a/b x 2;seed 5 # note\n");
    // What stands before a keep is kept by it.
    EXPECT_EQ(rerolled("reroll a\nkeep a/b\n", "a"), "reroll a\nkeep a/b\nreroll a\n");
    EXPECT_EQ(rerolled("reroll a\nkeep a/b\nreroll a\n", "a"), "reroll a\nkeep a/b\nreroll a x 2\n");
    EXPECT_EQ(rerolled("reroll a/b  # note\n", "a/b", 5), "reroll a/b x 6  # note\n");
    EXPECT_EQ(rerolled("reroll a/b x  09 # note\n", "a/b"), "reroll a/b x  10 # note\n");
    EXPECT_EQ(rerolled("reroll a/b x3", "a/b", 4), "reroll a/b x7");
    EXPECT_EQ(rerolled("reroll a/b\nreroll a/b x 2\nreroll a.b", "a/b"), "reroll a/b\nreroll a/b x 3\nreroll a.b");
    EXPECT_EQ(rerolled("reroll a/b", "a/b", 0), "reroll a/b");
    EXPECT_EQ(rerolled("unit mm", "a/b", 0), "unit mm");
    EXPECT_EQ(rerolled("reroll a x 999999999", "a"), "reroll a x 1000000000");
    EXPECT_EQ(rerolled("reroll a x 999999999", "a", 2), "edit.too-many-rerolls");
    EXPECT_EQ(rerolled("reroll a x 1000000000", "a", UINT32_MAX), "edit.too-many-rerolls");
    EXPECT_EQ(rerolled("", "a", 1000000001), "edit.too-many-rerolls");
    EXPECT_EQ(rerolled("", "a/"), "language.bad-path");
}

// --- apply -------------------------------------------------------------------------------------------------------

TEST(WithApply, AddsALine) {
    EXPECT_EQ(applied("unit mm", "outline(5)", {"a/b"}), "unit mm\napply outline(5) to a/b\n");
    EXPECT_EQ(applied("", " rim = outline(5, # five\n x: 3) # note\n", {"a/b[2,1]", " **/c "},
                      " [<in>,\n port : <b>, _, <>]\n"),
              "apply rim = outline(5, # five\n x: 3) to a/b[1,2], **/c -> in, port: b, _, <>\n");
    EXPECT_EQ(applied("", "embed(\"x.fil\")", {"a"}, "  "), "apply embed(\"x.fil\") to a\n");
}

TEST(WithApply, SaysWhatIsWrong) {
    EXPECT_EQ(applied("", "outline", {"a"}), "language.missing-arguments");
    EXPECT_EQ(applied("", "outline(5) to b #", {"a"}), "language.unexpected-token");
    EXPECT_EQ(applied("", "outline(5)\nkeep b", {"a"}), "language.unexpected-token");
    EXPECT_EQ(applied("", "outline(5)", {}), "language.missing-path");
    EXPECT_EQ(applied("", "outline(5)", {"a", "a//b"}), "language.bad-path");
    EXPECT_EQ(applied("", "outline(5)", {"a", "a, b"}), "language.unexpected-token");
    EXPECT_EQ(applied("", "outline(5)", {"a.distance"}), "language.bad-target");
    EXPECT_EQ(applied("", "outline(5)", {"a~2"}), "language.bad-target");
    EXPECT_EQ(applied("", "outline(5)", {"a"}, "-> b"), "language.missing-tag");
    EXPECT_EQ(applied("", "outline(5)", {"a"}, "b; keep c"), "language.unexpected-token");
}

// --- properties --------------------------------------------------------------------------------------------------

std::vector<std::string> meanings(const Document& document) {
    std::vector<std::string> result;
    for (const Statement& statement : document.statements) result.push_back(unparse(statement));
    return result;
}
std::vector<std::string> right_meanings(const Result<std::string>& text) {
    if (!text) return {"an error: " + text.diagnostics().front().code};
    const Parsed result = parsed(*text);
    EXPECT_EQ(to_text(result.diagnostics, result.document.sources), "") << *text;
    return meanings(result.document);
}

TEST(EditPresetsProperty, WhatIsAddedIsAllThatIsNew) {
    const std::uint64_t cases = case_count();
    for (std::uint64_t seed = 0; seed < cases; ++seed) {
        RandomText random(seed);
        const std::string text = random.document().text;
        const Document document = parsed(text).document;
        // A path that no random document has.
        const std::string path = "nowhere/" + random.path(true), value = random.expression(2);
        const std::string normal = to_text(*parse_path(path));
        std::vector<std::string> expected = meanings(document);
        const auto with = [&](const std::string& last) {
            std::vector<std::string> all = expected;
            all.push_back(last);
            return all;
        };
        const Result<std::string> set = with_preset(document, path, value);
        ASSERT_EQ(right_meanings(set), with("set " + normal + " = " + unparse(*parse_expression(value)))) << text;
        ASSERT_TRUE(set->starts_with(text)) << text;
        ASSERT_EQ(right_meanings(with_default(document, path, value)),
                  with("default " + normal + " = " + unparse(*parse_expression(value))));
        ASSERT_EQ(right_meanings(with_reroll(document, path, 5)), with("reroll " + normal + " x 5"));
        const Result<std::string> keep = with_keep(document, path);
        ASSERT_EQ(right_meanings(keep), with("keep " + normal));
        // Each is taken back.
        const bool has_last_line_end = text.empty() || text.back() == '\n' || text == "\xEF\xBB\xBF";
        const std::string before = has_last_line_end ? text : set->substr(0, set->find('\n', text.size()) + 1);
        ASSERT_EQ(shown(without_preset(parsed(*set).document, path)), before) << "seed " << seed;
        ASSERT_EQ(shown(without_keep(parsed(*keep).document, path)), before) << "seed " << seed;
        // And what stands there already is changed in place.
        const std::string other = random.expression(2);
        ASSERT_EQ(right_meanings(with_preset(parsed(*set).document, path, other)),
                  with("set " + normal + " = " + unparse(*parse_expression(other))));
        ASSERT_EQ(shown(with_keep(parsed(*keep).document, path)), *keep);
    }
}

// Each statement of a random document is edited where it stands; the others stay as they are.
TEST(EditPresetsProperty, TheOthersStay) {
    const std::uint64_t cases = case_count();
    std::uint64_t sets = 0, keeps = 0, rerolls = 0;
    for (std::uint64_t seed = 0; seed < cases; ++seed) {
        RandomText random(seed);
        const Document document = parsed(random.document().text).document;
        const std::string value = random.expression(2);
        for (std::size_t i = 0; i < document.statements.size(); ++i) {
            std::vector<std::string> expected = meanings(document);
            if (const auto* set = std::get_if<PresetStatement>(&document.statements[i].node)) {
                if (set->condition || set->path.segments.size() < 2) continue;
                const std::string path = to_text(set->path);
                const auto edit = set->is_default ? with_default : with_preset;
                std::size_t last = i;
                for (std::size_t k = i + 1; k < document.statements.size(); ++k) {
                    const auto* later = std::get_if<PresetStatement>(&document.statements[k].node);
                    const bool is_same = later != nullptr && later->is_default == set->is_default &&
                                         !later->condition && same_path(later->path, set->path);
                    if (is_same) last = k;
                }
                expected[last] =
                    (set->is_default ? "default " : "set ") + path + " = " + unparse(*parse_expression(value));
                ASSERT_EQ(right_meanings(edit(document, path, value)), expected) << document.text();
                if (set->is_default) continue;
                expected.erase(expected.begin() + static_cast<std::ptrdiff_t>(last));
                ASSERT_EQ(right_meanings(without_preset(document, path)), expected) << document.text();
                ++sets;
            } else if (const auto* keep = std::get_if<KeepStatement>(&document.statements[i].node)) {
                std::erase(expected, unparse(document.statements[i]));
                ASSERT_EQ(right_meanings(without_keep(document, to_text(keep->path))), expected) << document.text();
                ++keeps;
            } else if (const auto* reroll = std::get_if<RerollStatement>(&document.statements[i].node)) {
                if (reroll->times == max_rerolls) continue;
                const std::string start = "reroll " + to_text(reroll->path);
                const auto is_later = [&](const Statement& statement) {
                    const auto* later = std::get_if<RerollStatement>(&statement.node);
                    return later != nullptr && same_path(later->path, reroll->path);
                };
                if (std::any_of(document.statements.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                document.statements.end(), is_later)) {
                    continue;
                }
                const bool is_kept = std::any_of(
                    document.statements.begin() + static_cast<std::ptrdiff_t>(i), document.statements.end(),
                    [](const Statement& later) { return std::holds_alternative<KeepStatement>(later.node); });
                if (is_kept) {
                    expected.push_back(start);
                } else {
                    expected[i] = start + " x " + std::to_string(reroll->times + 1);
                }
                ASSERT_EQ(right_meanings(with_reroll(document, to_text(reroll->path))), expected) << document.text();
                ++rerolls;
            }
        }
    }
    EXPECT_GT(sets, cases / 20);
    EXPECT_GT(keeps, cases / 20);
    EXPECT_GT(rerolls, cases / 20);
}

}  // namespace
}  // namespace filigree
