#include "language/expression.h"

#include <gtest/gtest.h>

#include <vector>

#include "base/test_cases.h"
#include "language/parse.h"
#include "language/random_text.h"
#include "language/unparse.h"

namespace filigree {
namespace {

ExpressionPtr parsed(std::string_view text) {
    const Result<ExpressionPtr> result = parse_expression(text);
    EXPECT_TRUE(result) << text << "\n" << to_text(result.diagnostics(), {});
    return result ? *result : std::make_shared<Expression>();
}
bool same(std::string_view a, std::string_view b) { return same_meaning(*parsed(a), *parsed(b)); }

TEST(SameMeaning, LooksPastBlanksBracketsAndSpelling) {
    EXPECT_TRUE(same("a+b*2", "( a + (b * 2) )"));
    EXPECT_TRUE(same("1e3", "1000"));
    EXPECT_TRUE(same("#a03", "#aa0033ff"));
    EXPECT_TRUE(same("\"\\u{41}\"", "\"A\""));
    EXPECT_TRUE(same("p\xC3\xA9tale", "pe\xCC\x81tale"));
    EXPECT_TRUE(same("f(a: 1, [2, 3])", "f (a : 1,\n [2 , 3])"));
    EXPECT_TRUE(same("a ? b : c ? d : e", "a ? b : (c ? d : e)"));
}

TEST(SameMeaning, SeesEveryDifference) {
    const std::vector<std::string_view> all = {
        "1",         "1mm",   "100%",      "-1",        "!a",        "a",         "b",         "\"a\"",
        "true",      "false", "#a03",      "#a04",      "[]",        "[a]",       "[a, b]",    "(a, b)",
        "(a, b, c)", "f()",   "g()",       "f(a)",      "f(a: a)",   "f(b: a)",   "f(a, a)",   "a + b",
        "b + a",     "a - b", "a..b",      "b..a",      "a in 1..2", "a in 1..3", "b in 1..2", "a.b",
        "a.c",       "c.b",   "a ? b : c", "b ? b : c", "a ? c : c", "a ? b : b", "a & b",     "a == b",
    };
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t j = 0; j < all.size(); ++j)
            EXPECT_EQ(same(all[i], all[j]), i == j) << all[i] << " and " << all[j];
    }
}

TEST(SameMeaning, AgreesWithTheWrittenForm) {
    const std::uint64_t cases = case_count();
    std::vector<ExpressionPtr> all;
    for (std::uint64_t seed = 0; seed < cases; ++seed) {
        RandomText random(seed);
        const ExpressionPtr expression = parsed(random.expression(seed % 4));
        all.push_back(expression);
        const std::string written = unparse(expression);
        EXPECT_TRUE(same_meaning(*expression, *parsed(written))) << "seed " << seed << ": " << written;
        const ExpressionPtr& other = all[random.below(static_cast<std::uint32_t>(all.size()))];
        EXPECT_EQ(same_meaning(*expression, *other), written == unparse(other)) << "seed " << seed << ": " << written;
    }
}

}  // namespace
}  // namespace filigree
