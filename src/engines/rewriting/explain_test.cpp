#include "engines/rewriting/explain.h"

#include <gtest/gtest.h>

#include "engines/rewriting/random_grammar_test.h"
#include "engines/rewriting/read_grammar_test.h"

namespace filigree::rewriting {
namespace {

Explanation explained(const Grammar& grammar, std::uint64_t steps, std::uint64_t index) {
    Result<Explanation> explanation = explain(grammar, {}, steps, index, {});
    EXPECT_TRUE(explanation);
    return explanation ? *explanation : Explanation();
}
// What comes of the symbols on the way to one, and then of that.
std::vector<Fate> fates(const std::string& text, std::uint64_t steps, std::uint64_t index) {
    std::vector<Fate> all;
    const Grammar grammar = grammar_of(text);
    for (const SymbolMoment& moment : explained(grammar, steps, index).moments) all.push_back(moment.fate);
    return all;
}
// Why each rule of the symbol's letter does or does not apply to it; none: it was not tried.
std::vector<std::optional<Verdict>> verdicts(const std::string& text, std::uint64_t steps, std::uint64_t index) {
    std::vector<std::optional<Verdict>> all;
    const Grammar grammar = grammar_of(text);
    const Explanation explanation = explained(grammar, steps, index);
    for (const RuleTrial& trial : explanation.moments.back().trials) all.push_back(trial.verdict);
    return all;
}

TEST(Explain, SaysWhatComesOfASymbol) {
    using enum Fate;
    EXPECT_EQ(fates("axiom \"a==\"\na -> \"ab\"", 3, 1), (std::vector{asleep, asleep, rewritten, kept}));
    EXPECT_EQ(fates("axiom \"qqqi\"", 1, 1), (std::vector{counted, counted}));
    EXPECT_EQ(fates("axiom \"qqi\"", 0, 2), (std::vector{inverted}));
    EXPECT_EQ(fates("axiom \"a=\"\na -> \"b\"\nmask a@2", 2, 0), (std::vector{asleep, resting, rewritten}));
    EXPECT_EQ(fates("axiom \"q\"\nsleep q until t > 1", 1, 0), (std::vector{resting, counted}));
    EXPECT_EQ(fates("axiom \"as\"\na -> \"b\"", 1, 1), (std::vector{repeated, rewritten}));
    const std::string macro = "R = random 2 \"ab\"\naxiom \"RR==\"\n";
    EXPECT_EQ(fates(macro, 1, 1), (std::vector{drawn, kept}));
    EXPECT_EQ(fates(macro, 1, 2), (std::vector{asleep, recalled}));
    EXPECT_EQ(fates("axiom \"B\"\nsystem B { axiom \"b\"; b -> \"bb\"; iterations 1; mode grow }", 2, 1),
              (std::vector{grown, rewritten, at_rest}));
    EXPECT_EQ(fates("axiom \"a\"\na -> \"b\" * 0, \"c\" * 0", 0, 0), (std::vector{kept}));
}

TEST(Explain, SaysWhyRulesDoNotApply) {
    using enum Verdict;
    using Verdicts = std::vector<std::optional<Verdict>>;
    EXPECT_EQ(verdicts("axiom \"bac\"\na@2 -> \"x\"\nc < a -> \"x\"\nb < a > a -> \"x\"\na -> \"x\" when depth > 0\n"
                       "b < a > c -> \"y\"\na -> \"z\"",
                       0, 1),
              (Verdicts{other_iteration, no_left, no_right, does_not_hold, applies, std::nullopt}));
    EXPECT_EQ(verdicts("axiom \"a\"\na -> \"ab\" loop 2\na -> \"ac\" loop 1", 0, 0), (Verdicts{applies, std::nullopt}));
    EXPECT_EQ(verdicts("axiom \"a\"\na -> \"ab\" loop 2\na -> \"ac\" loop 1", 2, 0), (Verdicts{other_row, applies}));
    EXPECT_EQ(verdicts("axiom \"a\"\na -> \"ab\" loop 2\na -> \"ac\" loop 1", 3, 0), (Verdicts{other_row, other_row}));
    EXPECT_EQ(verdicts("axiom \"a=\"\na -> \"b\"", 0, 0), (Verdicts{applies})) << "what would be, were it awake";
    EXPECT_EQ(verdicts("axiom \"a=\"\na -> \"b\" when 1 / depth > 0", 0, 0), (Verdicts{})) << "as it is not asked";
}

TEST(Explain, SaysWhatStandsThereAndWhatWasDrawn) {
    const Grammar grammar = grammar_of(
        "register k 2\nignore \"+\"\naxiom \"cb+a[d]e\"\nx b < a -> \"x\"\na > e f -> \"x\"\na > \"[e]\" -> \"x\"\n"
        "a -> \"x\" when k * index > 10 && depth == 0\na -> \"y\" * k, \"z\" * 0");
    const Explanation explanation = explained(grammar, 0, 3);
    const std::vector<RuleTrial>& trials = explanation.moments.back().trials;
    ASSERT_EQ(trials.size(), 5U);
    EXPECT_EQ(trials[0].found, U"cb");
    EXPECT_EQ(trials[1].found, U"e");
    EXPECT_EQ(trials[2].found, U"[d]");
    const std::vector<std::pair<std::string, double>> values = {{"k", 2}, {"index", 3}, {"depth", 0}};
    EXPECT_EQ(trials[3].values, values);
    EXPECT_EQ(trials[4].weights, (std::vector<double>{2, 0}));
    EXPECT_EQ(trials[4].drawn, 0U);
    EXPECT_EQ(explanation.next, U"y");
}

TEST(Explain, WhatCannotBeExplained) {
    const Grammar grammar = grammar_of("axiom \"a=b\"\na -> \"aa\"");
    const Result<Explanation> none = explain(grammar, {}, 1, 2, {});
    ASSERT_FALSE(none);
    EXPECT_EQ(none.diagnostics().front().code, "rewriting.no-such-position");
    DeriveOptions options;
    options.limits.elements = 3;
    EXPECT_FALSE(explain(grammar, options, 3, 0, {}));
    const Result<Explanation> last = explain(grammar, options, 2, 0, {});
    ASSERT_TRUE(last);
    EXPECT_FALSE(last->next) << "the next iteration is too large";
}

// A parent is who a symbol descends from: by it, what a symbol draws by can be told from the word before.
TEST(Explain, ParentsAreAncestors) {
    std::uint64_t compared = 0;
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(1000); ++seed) {
        CaseRandom random(seed);
        Grammar grammar = RandomGrammar(random).made();
        grammar.draws = DrawMode::lineage;
        DeriveOptions options;
        options.limits.elements = 2000;
        Result<Derivation> derivation = begin(grammar, options);
        if (!derivation || derivation->word.keys.empty()) continue;
        for (int t = 0; t < 4; ++t) {
            const std::vector<std::uint64_t> old = derivation->word.keys;
            std::vector<std::uint32_t> parents;
            if (step(*derivation, grammar, options, {}, &parents)) break;
            const std::vector<std::uint64_t>& keys = derivation->word.keys;
            ASSERT_EQ(parents.size(), keys.size()) << described(grammar);
            std::uint64_t child = 0;
            for (std::size_t i = 0; i < keys.size(); ++i) {
                ASSERT_LT(parents[i], old.size());
                ASSERT_TRUE(i == 0 || parents[i - 1] <= parents[i]);
                child = i > 0 && parents[i - 1] == parents[i] ? child : 0;
                const std::uint64_t parent = old[parents[i]];
                if (keys[i] == parent) continue;  // it stayed
                ASSERT_EQ(keys[i], fold(parent, child++)) << described(grammar);
                ++compared;
            }
        }
    }
    EXPECT_GT(compared, case_count(1000));
}

// What an explanation tells is what the derivation does.
TEST(Explain, AgreesWithTheDerivation) {
    std::uint64_t rewritten = 0, next = 0;
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(300); ++seed) {
        CaseRandom random(seed);
        const Grammar grammar = RandomGrammar(random).made();
        DeriveOptions options;
        options.seed = seed;
        options.limits.elements = 500;
        const std::uint64_t index = random.below(8), steps = random.below(4);
        const Result<Explanation> explanation = explain(grammar, options, steps, index, {});
        if (!explanation) continue;
        ASSERT_EQ(explanation->moments.size(), steps + 1);
        Result<Derivation> derivation = begin(grammar, options);
        std::u32string all;  // letters of the last word but one
        for (std::size_t t = 0; t <= steps; ++t) {
            const SymbolMoment& moment = explanation->moments[t];
            all.clear();
            for (const Symbol symbol : derivation->word.symbols) {
                if (symbol != Alphabet::freeze) all += derivation->alphabet[symbol].letter;
            }
            ASSERT_EQ(moment.letter, all[moment.index]);
            const bool stays = moment.fate == Fate::asleep || moment.fate == Fate::resting ||
                               moment.fate == Fate::at_rest || moment.fate == Fate::kept;
            if (stays && t < steps) {
                ASSERT_EQ(explanation->moments[t + 1].letter, moment.letter) << described(grammar);
            }
            if (stays && t == steps && explanation->next) {
                ASSERT_EQ(explanation->next->substr(0, 1), std::u32string(1, moment.letter)) << described(grammar);
                ASSERT_EQ(explanation->next->find_first_not_of(U'=', 1), std::u32string::npos) << described(grammar);
            }
            ASSERT_EQ(moment.fate == Fate::rewritten, moment.rule != nullptr);
            rewritten += moment.rule != nullptr ? 1 : 0;
            if (step(*derivation, grammar, options, {})) break;
        }
        next += explanation->next ? 1 : 0;
    }
    EXPECT_GT(rewritten, case_count(300) / 2);
    EXPECT_GT(next, case_count(300) / 2);
}

}  // namespace
}  // namespace filigree::rewriting
