#include "engines/rewriting/word_tokens.h"

#include <gtest/gtest.h>

#include "engines/rewriting/word_cases.h"

namespace filigree::rewriting {
namespace {

using Texts = std::vector<std::u32string>;

TEST(WordTokens, KeepTurnsAndFreezesTogether) {
    EXPECT_EQ(texts_of(U"D+a+a"), (Texts{U"D+", U"a", U"+", U"a"}));
    EXPECT_EQ(texts_of(U"aaa===a[P<?b=]=c"), (Texts{U"a", U"a", U"a===", U"a", U"[", U"P<?", U"b=", U"]=", U"c"}));
    EXPECT_EQ(texts_of(U"T+=-a"), (Texts{U"T+=-", U"a"}));
    EXPECT_EQ(texts_of(U"+=+XY"), (Texts{U"+=", U"+", U"X", U"Y"}));
    EXPECT_EQ(texts_of(U"==a"), (Texts{U"==", U"a"}));
    EXPECT_EQ(texts_of(U"\u00F1=n"), (Texts{U"\u00F1=", U"n"}));
    EXPECT_TRUE(edit_tokens(U"").empty());
}

TEST(WordTokens, KnowShrinks) {
    EXPECT_EQ(texts_of(U"~(0.9)a~(1e-7)=b"), (Texts{U"~(0.9)", U"a", U"~(1e-7)=", U"b"}));
    EXPECT_EQ(texts_of(U"~(0)"), (Texts{U"~", U"(", U"0", U")"}));
    EXPECT_EQ(texts_of(U"~(-1)").size(), 5U);
    EXPECT_EQ(texts_of(U"~()").size(), 3U);
    EXPECT_EQ(texts_of(U"~(0.9").size(), 5U);
    EXPECT_EQ(texts_of(U"~(~(2)"), (Texts{U"~", U"(", U"~(2)"}));
    EXPECT_EQ(shrink_factor(U"~(0.9)"), 0.9);
    EXPECT_EQ(shrink_factor(U"~(25)=="), 25);
    for (const std::u32string_view text : {U"", U"a", U"~", U"~(0)", U"~(0.9)a", U"~(1e999)", U"~(.)"}) {
        EXPECT_EQ(shrink_factor(text), std::nullopt) << utf8(text);
    }
}

TEST(WordTokens, FindPartnersAndShapes) {
    const std::u32string_view word = U"]a[b[c=]P+]=[";
    const std::vector<std::uint32_t> wanted = {no_token, no_token, 8, no_token, 6, no_token, 4, no_token, 2, no_token};
    EXPECT_EQ(bracket_partners(word, edit_tokens(word)), wanted);
    EXPECT_EQ(bracket_shape(word), (BracketShape{1, 1}));
    EXPECT_EQ(bracket_shape(U"]]a[[b]["), (BracketShape{2, 2}));
    EXPECT_TRUE(is_balanced(U"[a[b]]c[]"));
    EXPECT_TRUE(is_balanced(U""));
    EXPECT_FALSE(is_balanced(U"]["));
}

TEST(WordTokens, WidenRangesToWholeBranches) {
    const std::u32string_view word = U"a[b[c]d]e[f]";
    const std::vector<EditToken> tokens = edit_tokens(word);
    EXPECT_EQ(balanced_range(word, tokens, {2, 3}), (TokenRange{2, 3}));
    EXPECT_EQ(balanced_range(word, tokens, {2, 4}), (TokenRange{2, 6}));
    EXPECT_EQ(balanced_range(word, tokens, {5, 8}), (TokenRange{1, 8}));
    EXPECT_EQ(balanced_range(word, tokens, {7, 10}), (TokenRange{1, 12}));
    EXPECT_EQ(balanced_range(word, tokens, {4, 4}), (TokenRange{4, 4}));
    EXPECT_EQ(balanced_range(U"a[", edit_tokens(U"a["), {0, 2}), std::nullopt);
}

TEST(WordTokens, MakeUpAnyText) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(5000); ++seed) {
        CaseRandom random(seed);
        const std::u32string word = random.coin() ? random_word(random, 30) : random_garbage(random, 60);
        std::u32string again;
        for (const EditToken token : edit_tokens(word)) {
            ASSERT_LT(token.begin, token.end);
            again += token_text(word, token);
            ASSERT_EQ(edit_tokens(token_text(word, token)).size(), 1U) << utf8(word);
        }
        ASSERT_EQ(again, word);
        ASSERT_EQ(edit_tokens(again), edit_tokens(word));
    }
}

TEST(WordTokens, ShapesTellWhatMayStandForWhat) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(2000); ++seed) {
        CaseRandom random(seed);
        const std::u32string garbage = random_garbage(random, 20);
        const BracketShape shape = bracket_shape(garbage);
        std::u32string closed(shape.closing, U'[');
        closed += garbage;
        closed.append(shape.opening, U']');
        ASSERT_TRUE(is_balanced(closed)) << utf8(garbage);
        ASSERT_EQ(is_balanced(garbage), shape.closing + shape.opening == 0);
        const std::u32string word = random_word(random, 20);
        const std::vector<EditToken> tokens = edit_tokens(word);
        const TokenRange range = random_balanced_range(random, word);
        ASSERT_TRUE(is_balanced(range_text(word, tokens, range))) << utf8(word);
    }
}

}  // namespace
}  // namespace filigree::rewriting
