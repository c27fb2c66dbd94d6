#include "engines/rewriting/symbol_facts.h"

#include <gtest/gtest.h>

#include "engines/rewriting/derive.h"
#include "engines/rewriting/word_attributes.h"
#include "engines/rewriting/word_cases.h"
#include "language/parse.h"

namespace filigree::rewriting {
namespace {

TEST(SymbolFacts, AreThoseThatExpressionsName) {
    Grammar grammar;
    EXPECT_EQ(facts_asked(grammar), FactSet{});
    Rule rule;
    rule.condition = *parse_expression("age > 2");
    rule.successors.emplace_back().weight = *parse_expression("1 + depth");
    Pattern repeat;
    repeat.parts.push_back({U"", *parse_expression("2"), {{U"", *parse_expression("mod(count, 2)"), {}}}});
    grammar.systems[0].rules.push_back(rule);
    grammar.arrays.push_back({"M", {1}, {repeat}, OutOfRange::error});
    FactSet wanted{};
    for (const Fact fact : {Fact::age, Fact::depth, Fact::count}) wanted[static_cast<std::size_t>(fact)] = true;
    EXPECT_EQ(facts_asked(grammar), wanted);
}

// What rules know of a symbol is what edits of finished words know of it, and of the branch that it stands in.
TEST(SymbolFacts, AreAttributesOfWords) {
    FactSet all;
    all.fill(true);
    std::uint64_t in_branches = 0;
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(); ++seed) {
        CaseRandom random(seed);
        const std::u32string text = random_word(random, 40);
        Alphabet alphabet;
        Word word;
        word.symbols = *symbols_of(text, Roles{}, {random.below(2), 0}, alphabet);
        const SymbolFacts facts(word, alphabet, all);
        const std::vector<EditToken> tokens = edit_tokens(text);
        const std::vector<SymbolAttributes> attributes = attributes_of(text, tokens);
        const std::vector<WordBranch> branches = branches_of(text, tokens);
        std::size_t index = 0;
        for (std::uint32_t i = 0; i < tokens.size(); ++i) {
            const char32_t letter = token_symbol(text, tokens[i]);
            if (letter != U'=') {
                TokenRange around{0, static_cast<std::uint32_t>(tokens.size())};
                for (const WordBranch& branch : branches) {
                    const bool is_inside = branch.range.begin < i && i < branch.range.end - 1;
                    if (is_inside) around = branch.range;  // the later, the further in
                }
                in_branches += around.begin > 0 ? 1 : 0;
                ASSERT_EQ(facts.value(Fact::index, index), index);
                ASSERT_EQ(facts.value(Fact::depth, index), attributes[i].depth) << utf8(text);
                ASSERT_EQ(facts.value(Fact::distance, index), attributes[i].distance) << utf8(text);
                ASSERT_EQ(facts.value(Fact::density, index), density(text, tokens, around)) << utf8(text);
                ASSERT_EQ(facts.value(Fact::homogeneity, index), homogeneity(text, tokens, around).scalar);
                ASSERT_EQ(facts.count(letter), std::count(text.begin(), text.end(), letter));
            }
            for (const char32_t c : token_text(text, tokens[i])) index += c != U'=' ? 1 : 0;
        }
    }
    EXPECT_GT(in_branches, case_count());
}

}  // namespace
}  // namespace filigree::rewriting
