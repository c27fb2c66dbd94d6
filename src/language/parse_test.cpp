#include "language/parse.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <map>

#include "base/test_cases.h"
#include "language/random_text.h"
#include "language/unparse.h"

namespace filigree {
namespace {

Parsed parsed(std::string_view text) { return parse_document("case.fil", text, nullptr); }

// A document that is to be right, written again from its parts.
std::string meaning(std::string_view text) {
    const Parsed result = parsed(text);
    EXPECT_EQ(to_text(result.diagnostics, result.document.sources), "");
    return unparse(result.document);
}
std::string value(std::string_view text) {
    const Result<ExpressionPtr> result = parse_expression(text);
    return result ? unparse(*result) : result.diagnostics().front().code;
}
std::string first_code(std::string_view text) {
    const Parsed result = parsed(text);
    return result.diagnostics.empty() ? "" : result.diagnostics.front().code;
}
std::string repeated(std::string_view text, std::size_t count) {
    std::string result;
    for (std::size_t i = 0; i < count; ++i) result += text;
    return result;
}
IncludeLoader loader_of(std::map<std::string, std::string, std::less<>> files) {
    return [files = std::move(files)](std::string_view name) -> Result<std::string> {
        const auto found = files.find(name);
        if (found == files.end()) return fault(Fault::document, "files.missing", "there is no file");
        return found->second;
    };
}

// --- statements ------------------------------------------------------------------------------------------------

TEST(Parse, TheLeafOfThePaper) {
    EXPECT_EQ(meaning("# leaf.fil: the grammar of gTangle's Figure 9\n"
                      "filigree 1\ngrammar tangle\nseed 2016\nunit mm\n"
                      "param spacing = 25 in 10..60  step 1 \"centre to centre of the blobs\"\n"
                      "start big_poly = file(\"leaf.svg\", id: \"a\")\nstart from \"portrait.svg\"\n"
                      "outline(25)                          : big_poly   -> in, out\n"
                      "place(blob, size: 20, spacing)       : out        -> remainder: rem  # note\n"
                      "regularSplit(line, 90, 1)            : in         -> [<quads>]\n"
                      "two = regroup(2) : quads when area > 40 weight 2 \xE2\x86\x92 [<>, _, <ung_quads>]\n"
                      "style in_3, blob when area > 40 { fill: black; stroke: none\n stroke-width: 0.3mm }\n"
                      "style * { }\nembed(\"knot.fil\") : medallion"),
              "filigree 1\ngrammar tangle\nseed 2016\nunit mm\n"
              "param spacing = 25 in (10 .. 60) step 1 \"centre to centre of the blobs\"\n"
              "start big_poly = file(\"leaf.svg\", id: \"a\")\nstart from \"portrait.svg\"\n"
              "outline(25) : big_poly -> in, out\nplace(blob, size: 20, spacing) : out -> remainder: rem\n"
              "regularSplit(line, 90, 1) : in -> quads\n"
              "two = regroup(2) : quads when (area > 40) weight 2 -> <>, _, ung_quads\n"
              "style in_3, blob when (area > 40) { fill: black; stroke: none; stroke-width: 0.3mm; }\n"
              "style * { }\nembed(\"knot.fil\") : medallion\n");
}

TEST(Parse, KeywordsAreKeywordsByPositionOnly) {
    EXPECT_EQ(meaning("outline(25): in when in > 3 weight weight -> in, when, weight\nstart from = circle(when)\n"
                      "seed = outline(2) : match -> from: _, seed\nlet let = 5\nparam in = in in in..in step step\n"
                      "page x x x margin margin\nlimit limit limit\nstyle when, style when when { when: when }"),
              "outline(25) : in when (in > 3) weight weight -> in, when, weight\nstart from = circle(when)\n"
              "seed = outline(2) : match -> from: _, seed\nlet let = 5\nparam in = in in (in .. in) step step\n"
              "page x x x margin margin\nlimit limit limit\nstyle when, style when when { when: when; }\n");
}

TEST(Parse, TagsMayStartWithDigits) {
    EXPECT_EQ(meaning("outline(2in): 0_medium_poly -> 2in, 5deg\nstart 1e5 = circle(5deg)\nstyle 3d { fill: #a03 }"),
              "outline(2in) : 0_medium_poly -> 2in, 5deg\nstart 1e5 = circle(5deg)\nstyle 3d { fill: #aa0033; }\n");
}

TEST(Parse, PagesOfEveryKind) {
    EXPECT_EQ(meaning("page fit"), "page fit\n");
    EXPECT_EQ(meaning("page a4 margin 10mm"), "page a4 margin 10mm\n");
    EXPECT_EQ(meaning("page 210mm x 297mm margin 10mm"), "page 210mm x 297mm margin 10mm\n");
    EXPECT_EQ(meaning("page tile 100 x w * 2"), "page tile 100 x (w * 2)\n");
    EXPECT_EQ(meaning("page fit margin 1cm"), "page fit margin 1cm\n");
}

TEST(Parse, OtherStatements) {
    EXPECT_EQ(meaning("palette ink = [#1a1a1a,\n  #a03020  # red\n]\nsymmetry p4m\nresolution 0.1mm\nlimit memory 4GB"),
              "palette ink = [#1a1a1a, #a03020]\nsymmetry p4m\nresolution 0.1mm\nlimit memory 4GB\n");
    EXPECT_EQ(meaning("seed 0; seed_ = outline(1) : a;; ;\nunit in"), "seed 0\nseed_ = outline(1) : a\nunit in\n");
    EXPECT_EQ(meaning("seed 18446744073709551615"), "seed 18446744073709551615\n");
    EXPECT_EQ(meaning(""), "");
    EXPECT_EQ(meaning("\xEF\xBB\xBF# nothing\n\n"), "");
}

TEST(Parse, VersionSeedAndUnitStandOnce) {
    EXPECT_EQ(first_code("seed 1\nseed 1"), "language.repeated-statement");
    EXPECT_EQ(first_code("unit mm; unit mm"), "language.repeated-statement");
    EXPECT_EQ(first_code("filigree 1\nfiligree 1"), "language.repeated-statement");
    const Parsed result = parsed("unit mm\nunit cm\nunit pt");
    EXPECT_EQ(result.diagnostics.size(), 2U);
    EXPECT_EQ(result.document.units, std::vector<Unit>{Unit::mm});
}

TEST(Parse, LineEndsOfEveryKind) {
    const std::string text = "grammar tangle\nstart a = rectangle(\n  10, # wide\n  20)\nstyle a {\n fill: black\n}\n";
    std::string with_returns;
    for (const char c : text) with_returns += c == '\n' ? std::string("\r\n") : std::string(1, c);
    EXPECT_EQ(meaning(with_returns), meaning(text));
    EXPECT_EQ(meaning("let a = \"x\\ny\\\"\\\\\\u{e9}\\u{1F33F}\""),
              "let a = \"x\\ny\\\"\\\\\xC3\xA9\xF0\x9F\x8C\xBF\"\n");
}

TEST(Parse, NamesAreComparedInNormalForm) {
    EXPECT_EQ(meaning("let pe\xCC\x81tale = 1"), meaning("let p\xC3\xA9tale = 1"));
    EXPECT_EQ(parsed("let pe\xCC\x81tale = 1").document.text(), "let pe\xCC\x81tale = 1");
}

TEST(Parse, PlacesOfParts) {
    const std::string text = "  two = outline ( 25 ) : leaf -> in, port : out  # note\nseed  7 ;let a = (1 + 2)\n";
    const Parsed result = parsed(text);
    const auto bytes = [&](SourceSpan span) { return text.substr(span.begin, span.end - span.begin); };
    ASSERT_EQ(result.document.statements.size(), 3U);
    const GroupRule& rule = std::get<GroupRule>(result.document.statements[0].node);
    EXPECT_EQ(bytes(result.document.statements[0].span), "two = outline ( 25 ) : leaf -> in, port : out");
    EXPECT_EQ(bytes(rule.label->span), "two");
    EXPECT_EQ(bytes(rule.operator_name.span), "outline");
    EXPECT_EQ(bytes(rule.arguments[0].value->span), "25");
    EXPECT_EQ(bytes(rule.tag.span), "leaf");
    EXPECT_EQ(bytes(rule.outputs[1].span), "port : out");
    EXPECT_EQ(bytes(std::get<SeedStatement>(result.document.statements[1].node).value_span), "7");
    EXPECT_EQ(bytes(std::get<LetStatement>(result.document.statements[2].node).value->span), "(1 + 2)");
}

// --- expressions -----------------------------------------------------------------------------------------------

TEST(ParseExpression, TiersBindAsUsual) {
    EXPECT_EQ(value("a || b && c == d + e * f"), "(a || (b && (c == (d + (e * f)))))");
    EXPECT_EQ(value("a * b + c == d && e || f"), "(((((a * b) + c) == d) && e) || f)");
    EXPECT_EQ(value("a - b - c / d / e"), "((a - b) - ((c / d) / e))");
    EXPECT_EQ(value("-a * -!b"), "((-a) * (-(!b)))");
    EXPECT_EQ(value("-a.b"), "(-(a.b))");
    EXPECT_EQ(value("1 + 2 .. 3 * 4"), "((1 + 2) .. (3 * 4))");
    EXPECT_EQ(value("-3..3"), "((-3) .. 3)");
    EXPECT_EQ(value("normal(1.0, 0.2) in 0.6..1.6"), "(normal(1, 0.2) in (0.6 .. 1.6))");
    EXPECT_EQ(value("a > 1 ? 2..3 : b ? c : d"), "((a > 1) ? (2 .. 3) : (b ? c : d))");
    EXPECT_EQ(value("a ? b ? c : d : e"), "(a ? (b ? c : d) : e)");
    EXPECT_EQ(value("one_of(line: 3, wave: 1)"), "one_of(line: 3, wave: 1)");
    EXPECT_EQ(value("f(a ? b : c, d ? e : f : g)"), "f((a ? b : c), (d ? e : f): g)");
    EXPECT_EQ(value("(1, 2)"), "(1, 2)");
    EXPECT_EQ(value("((1)) + [(1, 2, 3), []]"), "(1 + [(1, 2, 3), []])");
    EXPECT_EQ(value("page.width / 40"), "((page.width) / 40)");
    EXPECT_EQ(value("\n true # yes\n"), "true");
}

TEST(ParseExpression, RefusesMore) {
    EXPECT_EQ(value(""), "language.missing-value");
    EXPECT_EQ(value("1; 2"), "language.unexpected-token");
    EXPECT_EQ(value("1\n2"), "language.unexpected-token");
    EXPECT_EQ(value("1 2"), "language.unexpected-token");
    EXPECT_EQ(value("a = 2"), "language.lone-equals");
    EXPECT_EQ(value("\xFF"), "language.not-utf8");
    EXPECT_EQ(parse_expression("(1", 3).diagnostics().front().span, (SourceSpan{3, 0, 1}));
}

// --- bounds ----------------------------------------------------------------------------------------------------

TEST(ParseBounds, NestingAndChains) {
    EXPECT_EQ(value(repeated("(", 200) + "1" + repeated(")", 200)), "1");
    EXPECT_EQ(value(repeated("(", 201) + "1" + repeated(")", 201)), "language.nesting");
    EXPECT_EQ(value(repeated("[", 20000)), "language.nesting");
    EXPECT_EQ(value(repeated("f(", 201)), "language.nesting");
    EXPECT_EQ(value(repeated("a ? ", 20000)), "language.nesting");
    EXPECT_EQ(value(repeated("a ? b : ", 20000) + "c"), "language.long-chain");
    EXPECT_EQ(value(repeated("- ", 20000) + "1"), "language.long-chain");
    EXPECT_EQ(value("1" + repeated("+1", 20000)), "language.long-chain");
    EXPECT_EQ(value("a" + repeated(".a", 20000)), "language.long-chain");
    EXPECT_NE(value("1" + repeated("+1", 499)), "language.long-chain");
    EXPECT_EQ(value("1" + repeated("+1", 500)), "language.long-chain");
    EXPECT_EQ(value(std::string(1001, 'a')), "language.long-name");
    EXPECT_EQ(value(std::string(1000, 'a')), std::string(1000, 'a'));
}

TEST(ParseBounds, AFailureBehindDeepNestingIsOne) {
    const Parsed result = parsed("let a = " + repeated("[\n", 300) + repeated("]\n", 300) + "\nstrat b = 5\n");
    ASSERT_EQ(result.diagnostics.size(), 2U);
    EXPECT_EQ(result.diagnostics[0].code, "language.nesting");
    EXPECT_EQ(result.diagnostics[1].code, "language.unknown-statement");
}

TEST(ParseBounds, TooManyErrors) {
    const Parsed result = parsed(repeated("strat a = 5\n", 5000));
    ASSERT_EQ(result.diagnostics.size(), max_diagnostics + 1);
    EXPECT_EQ(result.diagnostics.back().code, "language.too-many-errors");
}

TEST(ParseBounds, TooLarge) {
    const std::string text(max_document_bytes + 1, ' ');
    EXPECT_EQ(first_code(text), "language.too-large");
    EXPECT_EQ(value(text), "language.too-large");
    const Parsed result =
        parse_document("a.fil", "include \"b.fil\"", loader_of({{"b.fil", std::string(max_document_bytes - 5, ' ')}}));
    ASSERT_EQ(result.diagnostics.size(), 1U);
    EXPECT_EQ(result.diagnostics[0].code, "language.too-large");
}

// Texts that make careless parsers quadratic: each would take minutes.
TEST(ParseBounds, StaysLinear) {
    constexpr std::size_t size = 1U << 18;
    for (const std::string_view part : {"(",
                                        "[",
                                        "{",
                                        "<",
                                        "\"",
                                        "#",
                                        "# ",
                                        "\n",
                                        ";",
                                        "a",
                                        "e\xCC\x81",
                                        "1",
                                        "-",
                                        ".",
                                        "..",
                                        "f(1 1\n",
                                        "f({",
                                        "a{ ",
                                        "style a { b\n",
                                        "style a {",
                                        "style a { b: 1;",
                                        "f(1,",
                                        "a ? b :",
                                        "f() : a -> [<a>,",
                                        "((\n",
                                        "({",
                                        "{{{\n",
                                        "[\n",
                                        "f(1 1) : a -> b\n",
                                        "f() : a -> b,\n",
                                        "f() : a ->\n",
                                        "\\",
                                        "\"\\\"\\",
                                        "let a = \"x\ny",
                                        "seed 1\n",
                                        "f(}\n",
                                        "unit ",
                                        "f(\n1 1, [\n",
                                        "a = b ->\n",
                                        "a = ->\n\n",
                                        "a (b;",
                                        "#\xC3\xA9"}) {
        std::string text = repeated(part, size / part.size());
        parsed(text);
        parsed("let a = " + text);
        parsed("let a = [" + text);
        parsed("f() : a -> [" + text);
        parsed("grammar shape\n" + text);
    }
}

// --- includes --------------------------------------------------------------------------------------------------

TEST(Include, BringsStatementsButNotTheDocumentsOwn) {
    const Parsed result = parse_document(
        "a.fil", "grammar tangle\nunit mm\ninclude \"b.fil\"\nlet z = 1\n",
        loader_of({{"b.fil",
                    "filigree 1\ngrammar tangle\nseed 9\nunit cm\npage a4\nstart q = circle(5)\nlimit depth 3\n"
                    "let y = 2\nstyle a { fill: red }\noutline(3) : a -> b\ninclude \"c.fil\""},
                   {"c.fil", "param x = 3\n"}}));
    EXPECT_EQ(to_text(result.diagnostics, result.document.sources), "");
    EXPECT_EQ(unparse(result.document),
              "grammar tangle\nunit mm\ninclude \"b.fil\"\nlet y = 2\nstyle a { fill: red; }\noutline(3) : a -> b\n"
              "include \"c.fil\"\nparam x = 3\nlet z = 1\n");
    EXPECT_EQ(result.document.units, (std::vector<Unit>{Unit::mm, Unit::cm, Unit::px}));
    ASSERT_EQ(result.document.sources.size(), 3U);
    EXPECT_EQ(result.document.sources[2].name, "c.fil");
    EXPECT_EQ(result.document.statements[7].span.file, 2U);
}

TEST(Include, EachFileOnce) {
    const Parsed result =
        parse_document("a.fil", "include \"b.fil\"\ninclude \"c.fil\"; include \"./b.fil\"\n",
                       loader_of({{"b.fil", "let b = 1"}, {"c.fil", "include \"b.fil\"\nlet c = 1"}}));
    EXPECT_TRUE(result.diagnostics.empty());
    EXPECT_EQ(result.document.sources.size(), 3U);
}

TEST(Include, ACircleIsAnError) {
    const Parsed own = parse_document("a.fil", "include \"./a.fil\"", loader_of({}));
    ASSERT_EQ(own.diagnostics.size(), 1U);
    EXPECT_EQ(own.diagnostics[0].code, "language.include-cycle");

    const Parsed result =
        parse_document("a.fil", "include \"b.fil\"",
                       loader_of({{"b.fil", "include \"c.fil\""}, {"c.fil", "let c = 1\ninclude \"b.fil\""}}));
    ASSERT_EQ(result.diagnostics.size(), 1U);
    EXPECT_EQ(result.diagnostics[0].code, "language.include-cycle");
    EXPECT_EQ(result.diagnostics[0].span, (SourceSpan{2, 18, 25}));
    EXPECT_EQ(result.diagnostics[0].hints.at(0), "the circle is b.fil -> c.fil -> b.fil");
}

TEST(Include, ErrorsHavePlaces) {
    const Parsed missing = parse_document("a.fil", "let a = 1\ninclude \"b.fil\"", loader_of({}));
    ASSERT_EQ(missing.diagnostics.size(), 1U);
    EXPECT_EQ(missing.diagnostics[0].code, "files.missing");
    EXPECT_EQ(missing.diagnostics[0].span, (SourceSpan{0, 18, 25}));
    EXPECT_EQ(parsed("include \"b.fil\"").diagnostics.at(0).code, "language.no-include");

    const Parsed inside =
        parse_document("a.fil", "include \"b.fil\"\nsed 5", loader_of({{"b.fil", "let a = 1\nlet = 2"}}));
    ASSERT_EQ(inside.diagnostics.size(), 2U);
    EXPECT_EQ(inside.diagnostics[0].code, "language.missing-name");
    EXPECT_EQ(inside.diagnostics[0].span, (SourceSpan{1, 14, 15}));
    EXPECT_EQ(inside.diagnostics[1].span.file, 0U);
}

TEST(Include, DepthIsBounded) {
    const IncludeLoader endless = [](std::string_view name) -> Result<std::string> {
        return "include \"" + std::string(name) + "x\"";
    };
    const Parsed result = parse_document("a.fil", "include \"b\"", endless);
    ASSERT_EQ(result.diagnostics.size(), 1U);
    EXPECT_EQ(result.diagnostics[0].code, "language.include-depth");
}

// --- the published grammars ------------------------------------------------------------------------------------

TEST(PublishedGrammars, AllRulesParse) {
    std::ifstream file(FILIGREE_SOURCE_DIR "/tests/data/published_grammars.txt", std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    const Parsed result = parsed(text);
    EXPECT_EQ(to_text(result.diagnostics, result.document.sources), "");
    EXPECT_EQ(result.document.statements.size(), 186U);
    EXPECT_EQ(result.document.text(), text);
    for (const Statement& statement : result.document.statements) {
        ASSERT_TRUE(std::holds_alternative<GroupRule>(statement.node));
        // Written in the papers' notation, a rule is its own bytes but for blanks.
        std::string bytes = text.substr(statement.span.begin, statement.span.end - statement.span.begin);
        std::string written = "";
        const GroupRule& rule = std::get<GroupRule>(statement.node);
        for (const OutputTag& output : rule.outputs) written += (written.empty() ? "<" : ",<") + output.tag + ">";
        GroupRule head = rule;
        head.outputs.clear();
        written = unparse(Statement{statement.span, head}) + "->[" + written + "]";
        std::erase(bytes, ' ');
        std::erase(written, ' ');
        EXPECT_EQ(written, bytes);
    }
}

// --- properties ------------------------------------------------------------------------------------------------

// `head` is what a statement needs above it to mean the same on its own.
void expect_right(const RandomDocument& wanted, const std::string& head, std::uint64_t seed) {
    const Parsed result = parsed(wanted.text);
    ASSERT_EQ(to_text(result.diagnostics, result.document.sources), "") << "seed " << seed << "\n" << wanted.text;
    ASSERT_EQ(result.document.statements.size(), wanted.statements) << "seed " << seed << "\n" << wanted.text;
    ASSERT_EQ(result.document.text(), wanted.text) << "seed " << seed;
    const std::string written = unparse(result.document);
    ASSERT_EQ(meaning(written), written) << "seed " << seed << "\n" << wanted.text;
    std::uint32_t last = 0;
    for (const Statement& statement : result.document.statements) {
        ASSERT_GE(statement.span.begin, last) << "seed " << seed;
        last = statement.span.end;
        const std::string bytes = wanted.text.substr(statement.span.begin, statement.span.end - statement.span.begin);
        ASSERT_EQ(meaning(head + bytes), head + unparse(statement) + "\n") << "seed " << seed;
    }
}

TEST(ParseProperty, RandomDocumentsAreRight) {
    const std::uint64_t cases = case_count();
    for (std::uint64_t seed = 0; seed < cases && !HasFatalFailure(); ++seed) {
        expect_right(RandomText(seed).document(), "", seed);
        expect_right(RandomText(seed).shape_document(), "grammar shape\n", seed);
    }
}

TEST(ParseProperty, RandomDocumentsHaveStatementsOfEveryKind) {
    std::map<std::size_t, std::size_t> counts;
    const std::uint64_t cases = 1000;
    for (std::uint64_t seed = 0; seed < cases; ++seed) {
        RandomText random(seed);
        for (const RandomDocument& document : {random.document(), random.shape_document()}) {
            const Parsed result = parsed(document.text);
            for (const Statement& statement : result.document.statements) ++counts[statement.node.index()];
        }
    }
    // All but `include` and the six of words alone.
    EXPECT_EQ(counts.size(), std::variant_size_v<decltype(Statement::node)> - 7);
    for (const auto& [kind, count] : counts) EXPECT_GT(count, cases / 20) << kind;
}

void expect_sound(const Parsed& result, const std::string& text, std::uint64_t seed) {
    ASSERT_EQ(result.document.text(), text) << "seed " << seed;
    for (const Diagnostic& diagnostic : result.diagnostics) {
        ASSERT_EQ(diagnostic.code.rfind("language.", 0), 0U) << "seed " << seed << " " << diagnostic.code;
        ASSERT_FALSE(diagnostic.message.empty()) << "seed " << seed;
        ASSERT_EQ(diagnostic.span.file, 0U) << "seed " << seed;
        ASSERT_LE(diagnostic.span.begin, diagnostic.span.end) << "seed " << seed;
        ASSERT_LE(diagnostic.span.end, text.size()) << "seed " << seed;
    }
}

TEST(ParseProperty, DamagedDocumentsAreSurvived) {
    const std::uint64_t cases = 10 * case_count();
    for (std::uint64_t seed = 0; seed < cases; ++seed) {
        RandomText random(seed);
        const std::string text = damaged((seed % 3 == 0 ? random.shape_document() : random.document()).text, random);
        const Parsed result = parsed(text);
        expect_sound(result, text, seed);
        if (!result.diagnostics.empty()) continue;
        const std::string written = unparse(result.document);
        ASSERT_EQ(meaning(written), written) << "seed " << seed << "\n" << text;
    }
}

TEST(ParseProperty, RandomBytesAreSurvived) {
    const std::uint64_t cases = 10 * case_count();
    for (std::uint64_t seed = 0; seed < cases; ++seed) {
        RandomText random(seed);
        std::string text;
        const std::uint32_t size = random.below(200);
        const bool is_ascii = random.chance(2);
        for (std::uint32_t i = 0; i < size; ++i) text += static_cast<char>(random.below(is_ascii ? 128 : 256));
        expect_sound(parsed(text), text, seed);
        const Result<ExpressionPtr> expression = parse_expression(text, 0);
        ASSERT_TRUE(expression || has_errors(expression.diagnostics())) << "seed " << seed;
    }
}

// A broken statement between right ones costs one error and no neighbour.
TEST(ParseProperty, OneErrorForOneBrokenStatement) {
    const std::uint64_t cases = case_count();
    for (std::uint64_t seed = 0; seed < cases; ++seed) {
        RandomText random(seed);
        const std::string broken = random.pick({"strat a = circle(1)",
                                                "let = 5",
                                                "let a 5",
                                                "f(1 : a -> b",
                                                "f(1, : a -> b",
                                                "f(1,) : a -> b",
                                                "f(1) a -> b",
                                                "f(1) : -> b",
                                                "f(1) : a b",
                                                "f(1) : a ->",
                                                "f(1) : a -> b,",
                                                "f(1) : a -> [<b>",
                                                "f(1) : a -> [<b, c]",
                                                "let a = \"b",
                                                "let a = 5 % 3",
                                                "let a = 5x",
                                                "let a = 1e999",
                                                "let a = #a0",
                                                "start 5 = circle(1)",
                                                "seed x",
                                                "style a { b 5 }",
                                                "style a { b: 5 c: 5 }",
                                                "style a { b: (5 }",
                                                "f(\n 1 1,\n 2) : a",
                                                "f(\n 1,\n @) : a",
                                                "}",
                                                ")",
                                                "page 5",
                                                "f(1)) : a -> b",
                                                "#x",
                                                "let a = (1, 2, 3, 4)",
                                                "f(]) : a",
                                                "let a = b = c",
                                                "f(x = 1) : a -> b",
                                                "set a",
                                                "set a.b = ",
                                                "set a//b = 3",
                                                "keep a[1",
                                                "keep a = 3",
                                                "reroll a x 0",
                                                "apply f() to a,\n b/c -> d",
                                                "apply f() : a",
                                                "system s { keep a } b",
                                                "system s\n{\n keep a\n}",
                                                "system {\n keep a\n}",
                                                "operator s {\n f() : a\n}"});
        const std::string text =
            "let before = 1\n" + broken + "\noutline(3) : z -> y\nstyle q { fill: black }\nlet after = 2\n";
        const Parsed result = parsed(text);
        ASSERT_EQ(result.diagnostics.size(), 1U) << text << to_text(result.diagnostics, result.document.sources);
        ASSERT_EQ(unparse(result.document),
                  "let before = 1\noutline(3) : z -> y\nstyle q { fill: black; }\nlet after = 2\n")
            << text;
    }
}

}  // namespace
}  // namespace filigree
