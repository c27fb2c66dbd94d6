// Recorded choices of words over grammars at random: to record changes nothing, and what was recorded gives the same
// word again, whatever the seed.
#include "engines/rewriting/word_choices.h"

#include <gtest/gtest.h>

#include <set>

#include "engines/rewriting/derive.h"
#include "engines/rewriting/random_grammar_test.h"
#include "language/parse.h"

namespace filigree::rewriting {
namespace {

constexpr std::uint64_t most_symbols = 3000;

// A derivation, and by what its choices were made.
struct Derived {
    Document document;
    Scope globals;
    Derivation derivation;
    bool is_whole = false;  // no error, no limit
};

void derive(const Grammar& grammar, std::uint64_t seed, bool records, const Replay* replay, Derived& out) {
    DocumentSite site;
    site.replay = replay;
    out.document = parse_document("a.fil", "grammar rewriting\n", {}).document;
    DeriveOptions options;
    options.seed = seed;
    options.limits.elements = most_symbols;
    options.document = &out.document;
    options.globals = &out.globals;
    if (records || replay != nullptr) {
        PresetWalk walk = begin_walk(site, out.document, out.globals, seed);
        options.choices = std::make_shared<WordChoices>(std::move(walk), WordChoiceOptions{false, records});
    }
    Result<Derivation> begun = begin(grammar, options);
    out.is_whole = static_cast<bool>(begun);
    if (!begun) return;
    out.derivation = std::move(*begun);
    for (int t = 0; t < 4 && out.is_whole; ++t) out.is_whole = !step(out.derivation, grammar, options, {});
}

Replay replay_of(const WordChoices& choices) {
    const Choices& made = choices.made();
    Replay replay;
    for (std::size_t row = 0; row < made.size(); ++row) {
        replay.add(made.keys[row], made.name_table[made.names[row]], value_of(made, row));
    }
    return replay;
}

TEST(WordChoices, WhatWasRecordedGivesTheSameWordUnderAnotherSeed) {
    const std::uint64_t count = case_count(1000);
    std::uint64_t drawn = 0, others = 0;
    for (std::uint64_t seed = first_seed(); seed < first_seed() + count; ++seed) {
        CaseRandom random(seed);
        const Grammar grammar = RandomGrammar(random).made();
        Derived plain, recorded, replayed, redrawn;
        derive(grammar, seed, false, nullptr, plain);
        derive(grammar, seed, true, nullptr, recorded);
        ASSERT_EQ(plain.is_whole, recorded.is_whole) << described(grammar);
        if (!plain.is_whole) continue;
        const std::string word = to_text(plain.derivation.word, plain.derivation.alphabet);
        EXPECT_EQ(to_text(recorded.derivation.word, recorded.derivation.alphabet), word) << described(grammar);
        EXPECT_EQ(recorded.derivation.word.keys, plain.derivation.word.keys);
        const Replay replay = replay_of(*recorded.derivation.choices);
        if (replay.size() == 0) continue;
        ++drawn;
        EXPECT_EQ(replay.size(), recorded.derivation.choices->made().size()) << described(grammar);
        derive(grammar, seed + 987654321, false, &replay, replayed);
        ASSERT_TRUE(replayed.is_whole) << described(grammar);
        EXPECT_EQ(to_text(replayed.derivation.word, replayed.derivation.alphabet), word) << described(grammar);
        derive(grammar, seed + 987654321, false, nullptr, redrawn);
        others += to_text(redrawn.derivation.word, redrawn.derivation.alphabet) != word ? 1 : 0;
    }
    EXPECT_GT(drawn * 8, count);
    EXPECT_GT(others * 3, drawn);
}

// No two choices of a derivation have one path and one name.
TEST(WordChoices, PathsTellAllChoicesApart) {
    const std::uint64_t count = case_count(1000);
    std::uint64_t seen = 0;
    for (std::uint64_t seed = first_seed(); seed < first_seed() + count; ++seed) {
        CaseRandom random(seed);
        const Grammar grammar = RandomGrammar(random).made();
        Derived recorded;
        derive(grammar, seed, true, nullptr, recorded);
        if (!recorded.is_whole) continue;
        const WordChoices& choices = *recorded.derivation.choices;
        std::set<std::string> paths;
        for (std::size_t row = 0; row < choices.made().size(); ++row) {
            const std::string path = choices.path_of(choices.spots_of_made()[row]) + "." +
                                     choices.made().name_table[choices.made().names[row]];
            EXPECT_TRUE(paths.insert(path).second) << path << "\n" << described(grammar);
            EXPECT_TRUE(parse_path(path)) << path;
            ++seen;
        }
    }
    EXPECT_GT(seen, count);
}

TEST(WordChoices, SegmentsOfLettersThatNoPathCanHold) {
    EXPECT_EQ(segment_of(U'a'), "a");
    EXPECT_EQ(segment_of(U'\u00F1'), "\u00F1");
    EXPECT_EQ(segment_of(U'+'), "u2B");
    EXPECT_EQ(segment_of(U'7'), "u37");
}

}  // namespace
}  // namespace filigree::rewriting
