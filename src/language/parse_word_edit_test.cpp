#include <gtest/gtest.h>

#include "language/parse.h"
#include "language/unparse.h"

namespace filigree {
namespace {

// The one statement below the grammar, as it is understood; or the code of the first error and what it points to.
std::string understood(const std::string& text) {
    const Parsed result = parse_document("a.fil", "grammar rewriting\n" + text, {});
    if (!result.diagnostics.empty()) {
        const Diagnostic& first = result.diagnostics.front();
        return first.code + "@" + result.document.text().substr(first.span.begin, first.span.end - first.span.begin);
    }
    if (result.document.statements.size() != 2) return std::to_string(result.document.statements.size());
    return unparse(result.document.statements[1]);
}

TEST(ParseWordEdit, TimesAndArguments) {
    EXPECT_EQ(understood("once clean()"), "once clean()");
    EXPECT_EQ(understood("once insert(\"T+\", at: \"a\", where: depth > 2)  # a turn"),
              "once insert(\"T+\", at: \"a\", where: (depth > 2))");
    EXPECT_EQ(understood("after 3 breed(B, carry)"), "after 3..3 breed(B, carry)");
    EXPECT_EQ(understood("after 2 .. 5 clean()"), "after 2..5 clean()");
    EXPECT_EQ(understood("each iteration mutate(replace: 5%)"), "each iteration mutate(replace: 5%)");
    EXPECT_EQ(understood("once compress(\"aaa\" -> \"b\",\n  \"c\" -> \"d\", passes: 2)"),
              "once compress(\"aaa\" -> \"b\", \"c\" -> \"d\", passes: 2)");
    EXPECT_EQ(understood("system A { axiom \"c\"; once clean() }"), "system A { axiom \"c\"; once clean(); }");
    EXPECT_EQ(understood("after hold"), "after hold") << "a setting";
    EXPECT_EQ(understood("o -> \"once\""), "\"o\" -> \"once\"");
    const std::string written = understood("after 2..5 react(B, \"a > b  c\" -> \"d\", chance: 30%)");
    EXPECT_EQ(understood(written), written);
}

TEST(ParseWordEdit, PartsKnowTheirPlaces) {
    const Parsed result = parse_document("a.fil", "grammar rewriting\nafter 2 clean( )  # so\n", {});
    ASSERT_EQ(result.document.statements.size(), 2U);
    const auto& edit = std::get<WordEditStatement>(result.document.statements[1].node);
    const auto bytes = [&](SourceSpan span) {
        return result.document.text().substr(span.begin, span.end - span.begin);
    };
    EXPECT_EQ(bytes(result.document.statements[1].span), "after 2 clean( )");
    EXPECT_EQ(bytes(edit.call_span), "clean( )");
    EXPECT_EQ(bytes(edit.edit_name.span), "clean");
}

TEST(ParseWordEdit, Failures) {
    EXPECT_EQ(understood("once"), "language.missing-operator@");
    EXPECT_EQ(understood("once clean"), "language.missing-arguments@");
    EXPECT_EQ(understood("once clean() now"), "language.unexpected-token@now");
    EXPECT_EQ(understood("each time clean()"), "language.missing-iteration@time");
    EXPECT_EQ(understood("after 1.5 clean()"), "language.missing-iteration@1.5");
    EXPECT_EQ(understood("after 3..2 clean()").substr(0, 20), "language.empty-range");
    EXPECT_EQ(understood("once compress(\"a\": \"b\")"), "language.missing-arrow@:");
    EXPECT_EQ(understood("once compress(a -> \"b\")"), "language.missing-text@a");
    EXPECT_EQ(understood("once compress(\"a\" -> )"), "language.missing-value@)");
    EXPECT_EQ(understood("once compress(\"a\" -> \"b\" -> \"c\")"), "language.unclosed-bracket@(");
    EXPECT_EQ(understood("once compress((\"a\" -> \"b\"))"), "language.unclosed-bracket@(");
    EXPECT_EQ(understood("onse clean()"), "language.unknown-statement@onse");
}

// Arrows stand among the arguments of edits alone.
TEST(ParseWordEdit, OtherCallsTakeNoPairs) {
    const Parsed tangle = parse_document("a.fil", "grammar tangle\noutline(\"a\" -> 3) : x -> y\n", {});
    ASSERT_FALSE(tangle.diagnostics.empty());
    EXPECT_EQ(tangle.diagnostics.front().code, "language.unclosed-bracket");
    EXPECT_TRUE(parse_edit_call(" compress(\"a\" -> \"b\") "));
    EXPECT_FALSE(parse_edit_call("compress(\"a\" -> \"b\") once"));
    EXPECT_FALSE(parse_call("compress(\"a\" -> \"b\")"));
}

}  // namespace
}  // namespace filigree
