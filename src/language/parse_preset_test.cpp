#include <gtest/gtest.h>

#include "language/parse.h"
#include "language/unparse.h"

namespace filigree {
namespace {

Parsed parsed(std::string_view text) { return parse_document("case.fil", text, nullptr); }

std::string meaning(std::string_view text) {
    const Parsed result = parsed(text);
    EXPECT_EQ(to_text(result.diagnostics, result.document.sources), "") << text;
    return unparse(result.document);
}
// "begin code | hint" of the only error.
std::string problem(std::string_view text) {
    const Parsed result = parsed(text);
    if (result.diagnostics.size() != 1) return std::to_string(result.diagnostics.size()) + " diagnostics";
    const Diagnostic& found = result.diagnostics[0];
    return std::to_string(found.span.begin) + " " + found.code + (found.hints.empty() ? "" : " | " + found.hints[0]);
}
template <class Node>
Node only(std::string_view text) {
    const Parsed result = parsed(text);
    EXPECT_EQ(result.document.statements.size(), 1U) << text;
    return std::get<Node>(result.document.statements.at(0).node);
}

TEST(ParsePreset, SetAndDefault) {
    EXPECT_EQ(meaning("set window/sketch/two_lights/circle.circle_n = 5\nset **/circle.circle_n = 5 when radius < 0.3\n"
                      "default a/**.way=line;set spacing=30; set let/gap~2 = 5..9 # note"),
              "set window/sketch/two_lights/circle.circle_n = 5\nset **/circle.circle_n = 5 when (radius < 0.3)\n"
              "default a/**.way = line\nset spacing = 30\nset let/gap~2 = (5 .. 9)\n");
    EXPECT_EQ(meaning("set a.b = normal(1, 2) in 0..2 when c\nset a.b = x > 3 ? 1 : 2 when (y)\n"
                      "set a.rule = one_of(\"a\", \"outline#2\")\nset a.when = when when when"),
              "set a.b = (normal(1, 2) in (0 .. 2)) when c\nset a.b = ((x > 3) ? 1 : 2) when y\n"
              "set a.rule = one_of(\"a\", \"outline#2\")\nset a.when = when when when\n");
    EXPECT_EQ(meaning("set a.b = max(1,\n  2)\nset a/2,5.x = [1,\n2]"), "set a.b = max(1, 2)\nset a/2,5.x = [1, 2]\n");
}

TEST(ParsePreset, KeepAndReroll) {
    EXPECT_EQ(
        meaning("keep a/b[1,3]\nkeep a.b;keep **\r\nreroll a/b\nreroll a.b x 3\nreroll x x2;reroll x3 x 1000000000"),
        "keep a/b[1,3]\nkeep a.b\nkeep **\nreroll a/b\nreroll a.b x 3\nreroll x x 2\nreroll x3 x 1000000000\n");
    const std::string text = "reroll a/b x 017";
    const RerollStatement reroll = only<RerollStatement>(text);
    EXPECT_EQ(reroll.times, 17U);
    EXPECT_EQ(text.substr(reroll.times_span.begin), "017");
    EXPECT_EQ(only<RerollStatement>("reroll a/b x12").times_span, (SourceSpan{0, 12, 14}));
    EXPECT_EQ(only<RerollStatement>("reroll a/b").times, 1U);
    EXPECT_EQ(only<RerollStatement>("reroll a/b").times_span.file, SourceSpan::no_file);
}

TEST(ParsePreset, Apply) {
    EXPECT_EQ(
        meaning("apply outline(5) to a/b\napply rim = place(20, size: 3) to a[1,3], b/2,5, **/c -> in, port: _, <>\n"
                "apply embed(\"x.fil\") to a;apply to = to() to to->[<x>,\n <y>]"),
        "apply outline(5) to a/b\napply rim = place(20, size: 3) to a[1,3], b/2,5, **/c -> in, port: _, <>\n"
        "apply embed(\"x.fil\") to a\napply to = to() to to -> x, y\n");
    const std::string text = "apply rim = outline(5) to a/b , c -> in";
    const ApplyStatement apply = only<ApplyStatement>(text);
    const auto bytes = [&](SourceSpan span) { return text.substr(span.begin, span.end - span.begin); };
    EXPECT_EQ(bytes(apply.name->span), "rim");
    EXPECT_EQ(bytes(apply.operator_name.span), "outline");
    EXPECT_EQ(bytes(apply.targets.at(0).span), "a/b");
    EXPECT_EQ(bytes(apply.targets.at(1).span), "c");
    EXPECT_EQ(bytes(apply.outputs.at(0).span), "in");
}

TEST(ParsePreset, KeywordsAreKeywordsByPositionOnly) {
    EXPECT_EQ(
        meaning("set = outline(3) : keep -> reroll, apply\ndefault = f() : set\nkeep = f() : set\nreroll =f() : to\n"
                "apply= f() : system -> operator\nsystem = f() : a\noperator = f() : default\nlet set = 5\n"
                "start apply = circle(set)\nstyle keep, operator { fill: system }\nset set/keep.apply = set\n"
                "apply set = keep(to) to to, to"),
        "set = outline(3) : keep -> reroll, apply\ndefault = f() : set\nkeep = f() : set\nreroll = f() : to\n"
        "apply = f() : system -> operator\nsystem = f() : a\noperator = f() : default\nlet set = 5\n"
        "start apply = circle(set)\nstyle keep, operator { fill: system; }\nset set/keep.apply = set\n"
        "apply set = keep(to) to to, to\n");
}

TEST(ParsePreset, WrongOnes) {
    EXPECT_EQ(problem("set"), "3 language.missing-path | write it as in 'set leaf/outline.distance = 5..9'");
    EXPECT_EQ(problem("set = 5"), "4 language.missing-path | write it as in 'set leaf/outline.distance = 5..9'");
    EXPECT_EQ(problem("set a.b"), "7 language.missing-equals | write it as in 'set leaf/outline.distance = 5..9'");
    EXPECT_EQ(problem("default a.b 5"),
              "12 language.missing-equals | write it as in 'default leaf/outline.distance = 25'");
    EXPECT_EQ(problem("set a.b == 5"), "8 language.missing-equals | write it as in 'set leaf/outline.distance = 5..9'");
    EXPECT_EQ(problem("set a.b ="), "9 language.missing-value");
    EXPECT_EQ(problem("set a.b = when c"), "15 language.unexpected-token");
    EXPECT_EQ(problem("set a.b = 5 when"), "16 language.missing-value");
    EXPECT_EQ(problem("set a.b = 5 weight 2"), "12 language.unexpected-token");
    EXPECT_EQ(problem("set a.b = c = 5"), "12 language.lone-equals | a comparison is written '=='");
    EXPECT_EQ(problem("set a / b = 5"), "5 language.bad-path | a path has no blanks, as in 'leaf/outline.distance'");
    EXPECT_EQ(problem("set a .b = 5"), "5 language.bad-path | a path has no blanks, as in 'leaf/outline.distance'");
    EXPECT_EQ(problem("set a.b: 5"),
              "7 language.bad-path | a value is given with '=', as in 'set leaf/outline.distance = 25'");
    EXPECT_EQ(problem("keep"), "4 language.missing-path | write it as in 'keep leaf/outline'");
    EXPECT_EQ(problem("keep a = 5"),
              "7 language.unexpected-token | 'keep' takes a path alone; a value is given with 'set'");
    EXPECT_EQ(problem("keep a, b"), "6 language.unexpected-token | each path has a 'keep' of its own");
    EXPECT_EQ(problem("keep a x 3"), "7 language.unexpected-token");
    EXPECT_EQ(problem("reroll a = 5"),
              "9 language.unexpected-token | 'reroll' takes no value; one is given with 'set'");
    EXPECT_EQ(problem("reroll a 5"), "9 language.unexpected-token | how often is written with an 'x', as in 'x 2'");
    EXPECT_EQ(problem("reroll a, b"), "8 language.unexpected-token | each path has a 'reroll' of its own");
    for (const std::string_view times :
         {"x 0", "x 1000000001", "x 1.5", "x 3mm", "x 5x", "x 99999999999999999999999999", "x", "x -3", "x three"}) {
        const std::string at = times == "x" ? "10" : "11";
        EXPECT_EQ(problem("reroll a " + std::string(times)),
                  at + " language.bad-times | how often is a whole number from 1 to 1000000000");
    }
    EXPECT_EQ(problem("reroll a x0"), "10 language.bad-times | how often is a whole number from 1 to 1000000000");
    EXPECT_EQ(problem("reroll a x3.5"), "11 language.unexpected-token");
    EXPECT_EQ(problem("reroll a x 3 4"), "13 language.unexpected-token");
    EXPECT_EQ(problem("reroll a xyz"), "9 language.unexpected-token");
}

TEST(ParsePreset, WrongApplies) {
    const std::string example = " | write it as in 'apply outline(5) to leaf/outline/in -> rim, core'";
    EXPECT_EQ(problem("apply outline(5) a/b"), "17 language.missing-to" + example);
    EXPECT_EQ(problem("apply outline(5)"), "16 language.missing-to" + example);
    EXPECT_EQ(problem("apply outline(5) : a -> b"), "17 language.missing-to" + example);
    EXPECT_EQ(problem("apply outline(5) to"),
              "19 language.missing-path | the path of a group is written as in 'leaf/outline/in'");
    EXPECT_EQ(problem("apply outline(5) to -> b"),
              "20 language.missing-path | the path of a group is written as in 'leaf/outline/in'");
    EXPECT_EQ(problem("apply outline(5) to a/b.distance"),
              "23 language.bad-target | write the path without '.distance'");
    EXPECT_EQ(problem("apply outline(5) to a, b~2 -> c"), "24 language.bad-target | write the path without '~2'");
    EXPECT_EQ(problem("apply outline(5) to a,b"), "21 language.bad-path | paths are separated by ',' and a blank");
    EXPECT_EQ(problem("apply outline(5) to a, "), "21 language.trailing-comma | paths stay on one line");
    EXPECT_EQ(problem("apply outline(5) to a,\n  b/c, d -> e\nkeep a"),
              "21 language.trailing-comma | paths stay on one line");
    EXPECT_EQ(problem("apply outline(5) to a, -> b"), "21 language.trailing-comma | paths stay on one line");
    EXPECT_EQ(problem("apply outline(5) to a b"), "22 language.unexpected-token");
    EXPECT_EQ(problem("apply outline(5) to a when x > 3"),
              "22 language.unexpected-token | a step by hand takes no 'when', for it is always made");
    EXPECT_EQ(problem("apply outline(5) to a -> b when x"), "27 language.unexpected-token");
    EXPECT_EQ(problem("apply outline(5) to a -> b,"),
              "26 language.trailing-comma | tags go on in the next line only inside '[' and ']'");
    EXPECT_EQ(problem("apply outline to a"),
              "14 language.missing-arguments | an operator without arguments is written 'outline()'");
    EXPECT_EQ(problem("apply rim = 5 to a"), "12 language.missing-operator" + example);
    EXPECT_EQ(problem("apply"), "5 language.missing-name");
    EXPECT_EQ(problem("apply 5 to a"), "6 language.missing-name | a name starts with a letter or '_'");
    EXPECT_EQ(problem("apply outline(5 to a"), "13 language.unclosed-bracket | expected ')' before 'to'");
}

// A path ends with its line: brackets and quotes in it hide nothing that follows.
TEST(ParsePreset, AWrongPathCostsItsStatementAlone) {
    for (const std::string_view wrong :
         {"keep a[1", "keep a[1,\n", "keep a\"b", "set a[( = 3", "keep a//b; ", "keep a{b}", "reroll a[1, 3] x 2",
          "set a/ b = (3)", "keep \"a", "apply f() to a[1"}) {
        const std::string text = std::string(wrong) + "\nset q.x = [1, 2]\n";
        const Parsed result = parsed(text);
        EXPECT_EQ(result.diagnostics.size(), 1U) << text << to_text(result.diagnostics, result.document.sources);
        EXPECT_EQ(unparse(result.document), "set q.x = [1, 2]\n") << text;
    }
}

TEST(ParsePreset, AnIncludedFilesStatementsAreTakenOver) {
    const IncludeLoader loader = [](std::string_view) {
        return Result<std::string>(
            std::string("unit mm\nset a.b = 3\ndefault a.b = 4\nkeep a\nreroll a\napply f() to a\n"
                        "system s { unit cm; seed 3; start a = circle(3) }\n"
                        "operator o(n) -> p { f() : a -> p }\nseed 5\n"));
    };
    const Parsed result = parse_document("a.fil", "include \"b.fil\"", loader);
    EXPECT_TRUE(result.diagnostics.empty());
    EXPECT_EQ(unparse(result.document),
              "include \"b.fil\"\nset a.b = 3\ndefault a.b = 4\nkeep a\nreroll a\napply f() to a\n"
              "system s { unit cm; seed 3; start a = circle(3); }\noperator o(n) -> p { f() : a -> p; }\n");
    EXPECT_EQ(result.document.units, (std::vector<Unit>{Unit::px, Unit::mm}));
    EXPECT_EQ(std::get<KeepStatement>(result.document.statements.at(3).node).path.span.file, 1U);
}

// --- parts ------------------------------------------------------------------------------------------------------

TEST(ParseParts, CallsAndOutputs) {
    const Result<OperatorCall> call = parse_call(" rim = outline(5, # five\n a: 3) # note\n", 2);
    ASSERT_TRUE(call);
    EXPECT_EQ(call->name->text, "rim");
    EXPECT_EQ(call->operator_name.text, "outline");
    EXPECT_EQ(call->arguments.size(), 2U);
    EXPECT_EQ(call->span, (SourceSpan{2, 1, 31}));
    EXPECT_FALSE(parse_call("outline(5)")->name);
    for (const std::string_view wrong : {"", "outline", "outline(5) to a", "outline(5); seed 3", "outline(5", "a = 5",
                                         "outline(5)\nkeep a", "outline(5) }"}) {
        EXPECT_FALSE(parse_call(wrong)) << wrong;
    }
    EXPECT_EQ(parse_outputs("in, port: _, <>")->size(), 3U);
    EXPECT_EQ(parse_outputs("[<in>,\n <b>]\n")->at(1).tag, "b");
    for (const std::string_view wrong : {"", "->", "-> a", "a,", "a b", "a; b", "a\nb", "[a", "5", "a when b", "a }"}) {
        EXPECT_FALSE(parse_outputs(wrong)) << wrong;
    }
    EXPECT_EQ(parse_outputs("a b", 3).diagnostics().front().span, (SourceSpan{3, 2, 3}));
}

TEST(SplitAssignment, AtTheFirstEqualsSignThatSeparates) {
    const auto split = [](std::string_view text) {
        const Result<Assignment> result = split_assignment(text);
        return result ? result->path + "|" + result->value : result.diagnostics().front().code;
    };
    EXPECT_EQ(split("spacing=30"), "spacing|30");
    EXPECT_EQ(split(" a/b[1,3].c~2 = a == b ? 1 : 2 "), "a/b[1,3].c~2|a == b ? 1 : 2");
    EXPECT_EQ(split("a.rule=\"x=y\""), "a.rule|\"x=y\"");
    EXPECT_EQ(split("\"x=\\\"=y\"=3"), "\"x=\\\"=y\"|3");
    EXPECT_EQ(split("a[b=c](d=e)=3=4"), "a[b=c](d=e)|3=4");
    EXPECT_EQ(split("a==b"), "language.missing-equals");
    EXPECT_EQ(split("a<=b>=c!=d"), "language.missing-equals");
    EXPECT_EQ(split("a<=b=c"), "a<=b|c");
    EXPECT_EQ(split(""), "language.missing-equals");
    EXPECT_EQ(split("=3"), "language.missing-path");
    EXPECT_EQ(split("a= "), "language.missing-value");
    EXPECT_EQ(split("\"a=b\\"), "language.missing-equals");
    const Result<Assignment> wrong = split_assignment("spacing 30");
    EXPECT_EQ(wrong.diagnostics().at(0).fault, Fault::usage);
    EXPECT_EQ(wrong.diagnostics().at(0).message, "'spacing 30' has no '='");
}

}  // namespace
}  // namespace filigree
