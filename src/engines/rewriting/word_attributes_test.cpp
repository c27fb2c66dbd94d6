#include "engines/rewriting/word_attributes.h"

#include <gtest/gtest.h>

#include "engines/rewriting/word_cases.h"

namespace filigree::rewriting {
namespace {

TEST(WordAttributes, DistancesFollowThePath) {
    const std::u32string_view word = U"aP+[b=T[c]a]+a";
    std::vector<std::uint32_t> distances, depths;
    for (const SymbolAttributes& one : attributes_of(word, edit_tokens(word))) {
        distances.push_back(one.distance);
        depths.push_back(one.depth);
    }
    //                                                  a  P+ [  b= T  [  c  ]  a  ]  +  a
    EXPECT_EQ(distances, (std::vector<std::uint32_t>{0, 1, 1, 1, 2, 2, 2, 2, 2, 1, 1, 1}));
    EXPECT_EQ(depths, (std::vector<std::uint32_t>{0, 0, 0, 1, 1, 1, 2, 1, 1, 0, 0, 0}));
}

TEST(WordAttributes, AgesAreOfSymbolsThatAreNoFreeze) {
    const std::u32string_view word = U"=aT++=b==c";
    const std::vector<std::uint32_t> ages = {9, 5, 6, 7, 4};  // a T + + b
    std::vector<std::uint32_t> got;
    for (const SymbolAttributes& one : attributes_of(word, edit_tokens(word), ages)) got.push_back(one.age);
    EXPECT_EQ(got, (std::vector<std::uint32_t>{1, 9, 5, 4, 1}));  // none is known of c
}

TEST(WordAttributes, ObjectsAreLettersUnlessToldOtherwise) {
    EXPECT_TRUE(is_object(U'a') && is_object(U'F') && is_object(U'\u00F1') && is_object(U'\u0416'));
    for (const char32_t c : std::u32string_view(U"PTDXYZ[]+=~(1|")) EXPECT_FALSE(is_object(c)) << utf8({&c, 1});
    const std::u32string_view word = U"F+F|f";
    const auto draws = [](char32_t c) { return c == U'F' || c == U'|'; };
    EXPECT_EQ(density(word, edit_tokens(word), {0, 5}, draws), 3U);
    EXPECT_EQ(attributes_of(word, edit_tokens(word), {}, draws)[4].distance, 3U);
}

TEST(WordAttributes, HomogeneityCountsSymbols) {
    const std::u32string_view word = U"ab[aa=]T+\u00F1";
    const std::vector<EditToken> tokens = edit_tokens(word);
    const Homogeneity all = homogeneity(word, tokens, {0, static_cast<std::uint32_t>(tokens.size())});
    EXPECT_EQ(all.frequencies, (std::vector<SymbolFrequency>{{U'a', 3, 0.6}, {U'b', 1, 0.2}, {U'\u00F1', 1, 0.2}}));
    EXPECT_EQ(all.scalar, 11.0 / 25.0);
    EXPECT_EQ(homogeneity(word, tokens, {2, 6}).scalar, 1);  // the branch [aa=]
    EXPECT_EQ(homogeneity(word, tokens, {6, 7}).scalar, 0);  // a turn
}

TEST(WordAttributes, BranchesKnowWhatTheyHold) {
    const std::u32string_view word = U"a]a[b[c]d]e[[";
    const std::vector<WordBranch> branches = branches_of(word, edit_tokens(word));
    ASSERT_EQ(branches.size(), 2U);
    EXPECT_EQ(branches[0].range, (TokenRange{3, 10}));
    EXPECT_EQ(branches[1].range, (TokenRange{5, 8}));
    EXPECT_EQ(branches[1].ordinal, 1U);
    EXPECT_EQ(branches[1].depth, 2U);
    EXPECT_EQ(branches[1].distance, 3U);
    EXPECT_EQ(branches[0].density, 3U);
    EXPECT_EQ(branches[1].density, 1U);
}

// By the definition: the objects before a token that lie in no branch that is closed before it.
std::uint32_t distance_by_definition(std::u32string_view word, const std::vector<EditToken>& tokens, std::size_t at) {
    const std::vector<std::uint32_t> partners = bracket_partners(word, tokens);
    std::uint32_t distance = 0;
    for (std::size_t i = at; i-- > 0;) {
        const char32_t symbol = token_symbol(word, tokens[i]);
        if (symbol == U']') i = partners[i];
        distance += is_object(symbol) ? 1U : 0U;
    }
    return distance;
}

TEST(WordAttributes, AreWhatTheirDefinitionsSay) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(1000); ++seed) {
        CaseRandom random(seed);
        const std::u32string word = random_word(random, 30);
        const std::vector<EditToken> tokens = edit_tokens(word);
        const std::vector<SymbolAttributes> attributes = attributes_of(word, tokens);
        for (std::size_t i = 0; i < tokens.size(); ++i) {
            // A `]` stands where its branch began.
            const bool closes = attributes[i].symbol == U']';
            const std::size_t at = closes ? bracket_partners(word, tokens)[i] : i;
            ASSERT_EQ(attributes[i].distance, distance_by_definition(word, tokens, at)) << utf8(word) << " at " << i;
            const BracketShape before = bracket_shape(word.substr(0, tokens[i].begin));
            ASSERT_EQ(attributes[i].depth, before.opening - (closes ? 1U : 0U));
        }
        for (const WordBranch& branch : branches_of(word, tokens)) {
            ASSERT_EQ(branch.density, density(word, tokens, branch.range));
            ASSERT_EQ(branch.distance, attributes[branch.range.begin].distance);
            ASSERT_EQ(branch.depth, attributes[branch.range.begin].depth + 1);
            const Homogeneity mixed = homogeneity(word, tokens, branch.range);
            std::uint32_t sum = 0;
            double squares = 0;
            for (const SymbolFrequency& one : mixed.frequencies) {
                sum += one.count;
                squares += one.share * one.share;
            }
            ASSERT_EQ(sum, branch.density);
            ASSERT_NEAR(mixed.scalar, squares, 1e-12);
        }
    }
}

}  // namespace
}  // namespace filigree::rewriting
