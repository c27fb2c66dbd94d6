// Words by chunks and quick tables against words by symbol, which the reference (reference_test.cpp) holds to be right.
#include "engines/rewriting/rewrite.h"

#include <gtest/gtest.h>

#include "base/test_cases.h"
#include "engines/rewriting/random_grammar_test.h"
#include "engines/rewriting/read_grammar_test.h"

namespace filigree::rewriting {
namespace {

// Pieces of a word, runs and single symbols at random; with all that a word has beside its symbols.
Word random_word(CaseRandom& random, const Word& like, const Alphabet& alphabet) {
    Word word;
    while (word.size() < 400) {
        const std::uint32_t kind = random.below(10);
        if (kind < 7 && like.size() > 0) {
            const std::size_t begin = random.index(like.size());
            const std::size_t end = std::min(like.size(), begin + 1 + random.below(20));
            word.symbols.insert(word.symbols.end(), like.symbols.begin() + begin, like.symbols.begin() + end);
        } else {
            const auto symbol = static_cast<Symbol>(random.index(alphabet.size()));
            word.symbols.insert(word.symbols.end(), kind < 9 ? 1 : random.below(40), symbol);
        }
    }
    if (word.symbols.front() == Alphabet::freeze) word.symbols.insert(word.symbols.begin(), Symbol{1});
    for (const Symbol symbol : word.symbols) {
        if (alphabet[symbol].role == Role::follower) word.origins.push_back(1 + random.below(4));
        if (symbol != Alphabet::freeze) word.ages.push_back(1);
    }
    return word;
}

struct Compared {
    std::size_t chunks = 0, by_symbol = 0;
};

void compare(const Derivation& derivation, const StepPlan& plan, Compared& compared) {
    const Rewriting with_columns(derivation.word, derivation.alphabet, plan);
    const Measured slow = measure(with_columns);
    Word symbols_alone = derivation.word;
    symbols_alone.ages.clear();
    const Rewriting alone(symbols_alone, derivation.alphabet, plan);
    const Measured quick = measure(alone, 0);
    ASSERT_EQ(slow.table.has_value(), false);
    ASSERT_EQ(quick.table.has_value(), plan.resting.empty());
    compared.chunks += quick.chunks.size();
    for (const ChunkTable::Code code : quick.chunks) compared.by_symbol += code == ChunkTable::by_symbol ? 1 : 0;
    ASSERT_EQ(quick.symbols, slow.symbols);
    ASSERT_EQ(quick.followers, slow.followers);
    if (slow.symbols > 1'000'000) return;
    const Word wanted = rewrite(with_columns, slow, AgeMode::lineage), made = rewrite(alone, quick, AgeMode::lineage);
    ASSERT_EQ(wanted.size(), slow.symbols);
    ASSERT_EQ(wanted.origins.size(), slow.followers);
    ASSERT_EQ(made.symbols, wanted.symbols);
    ASSERT_EQ(made.origins, wanted.origins);
}

TEST(Rewrite, ChunksGoAsSymbolsDo) {
    const std::uint64_t cases = case_count(1000);
    Compared compared;
    for (std::uint64_t seed = first_seed(); seed < first_seed() + cases; ++seed) {
        CaseRandom random(seed);
        const Grammar grammar = RandomGrammar(random).made();
        DeriveOptions options;
        options.seed = seed;
        options.with_ages = true;
        options.limits.elements = 100'000;
        Result<Derivation> derivation = begin(grammar, options);
        if (!derivation) continue;
        for (int t = 0; t < 4; ++t) {
            if (derivation->alphabet.size() == 1) break;  // nothing but '='
            Derivation other = *derivation;
            other.word = random_word(random, derivation->word, derivation->alphabet);
            const Result<StepPlan> plan = plan_step(other, grammar, options, {});
            if (plan) compare(other, *plan, compared);
            ASSERT_FALSE(HasFatalFailure()) << "case " << seed << "\n" << described(grammar);
            if (step(*derivation, grammar, options, {})) break;
        }
    }
    if (cases < 500) return;  // too few to meet everything
    EXPECT_GT(compared.by_symbol, 10 * cases);
    EXPECT_GT(compared.chunks - compared.by_symbol, 10 * cases);
}

// Ages say nothing of the symbols, but are written symbol by symbol.
TEST(Rewrite, LongWordsAreThoseThatHaveAges) {
    struct Case {
        std::string grammar;
        int iterations;
    };
    const std::vector<Case> cases = {
        {"axiom \"a\"\na -> \"ab=\"\nb -> \"ba==\"", 26},
        {"axiom \"a\"\na -> \"aqb\"\nb -> \"agggib\"\ngain q 3\ngain g 2", 14},
        // Parts, images, words and runs that are longer than a block that is written at once.
        {"axiom \"{150n}b\"\nn@1 -> \"{300a}[~n]c=\"\n~n@2 -> \"{9000b}a\"", 1},
        {"axiom \"n~nn\"\nn -> \"{8192a}{8193~n}\"\n~n@2 -> \"ab\"", 2},
        {"axiom \"nbbn=\"\nn -> \"{20000a}n\"\nb -> \"{40000c}b\"", 3},
        {"axiom \"asb\"\na -> \"{9000a=c}\"\nb -> \"{100~n}\"", 2},
        {"axiom \"aqbqqibg=q\"\ngain q 50000\nb -> \"ab\"", 3},
        // More kinds of parts than are looked up.
        {"random position\naxiom \"{20x}\"\nx@1..3 -> \"{20x}\"\nx -> \"a\", \"b\", \"c==\", \"d=\", \"eq\", \"qi\"\n"
         "a -> \"ba\"\nb -> \"cqi\"\nc -> \"\"",
         6}};
    for (const Case& one : cases) {
        const Grammar grammar = grammar_of(one.grammar);
        DeriveOptions plain;
        DeriveOptions with_ages;
        with_ages.with_ages = true;
        Result<Derivation> made = begin(grammar, plain), wanted = begin(grammar, with_ages);
        ASSERT_TRUE(made) << one.grammar;
        for (int t = 0; t < one.iterations; ++t) {
            const std::optional<Diagnostic> problem = step(*made, grammar, plain, {});
            ASSERT_FALSE(problem) << one.grammar << "\n" << problem->message;
            ASSERT_FALSE(step(*wanted, grammar, with_ages, {})) << one.grammar;
            ASSERT_TRUE(made->word.symbols == wanted->word.symbols) << one.grammar << "\niteration " << t + 1;
            ASSERT_TRUE(made->word.origins == wanted->word.origins) << one.grammar << "\niteration " << t + 1;
        }
        EXPECT_GT(made->word.size(), 2 * chunks_pay_from) << one.grammar;
    }
}

}  // namespace
}  // namespace filigree::rewriting
