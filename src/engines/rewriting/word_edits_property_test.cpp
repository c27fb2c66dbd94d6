#include <gtest/gtest.h>

#include <algorithm>

#include "base/random.h"
#include "engines/rewriting/word_cases.h"
#include "engines/rewriting/word_edits.h"

namespace filigree::rewriting {
namespace {

std::size_t token_count(std::u32string_view word) { return edit_tokens(word).size(); }

std::u32string sorted(std::u32string text) {
    std::sort(text.begin(), text.end());
    return text;
}

TEST(WordEditsProperty, HybridsHoldBothWordsInOrder) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(2000); ++seed) {
        CaseRandom random(seed);
        const std::u32string a = random_word(random, 25);
        const std::u32string b = random_word(random, 25);
        const std::u32string bred = breed(a, b);
        ASSERT_TRUE(is_balanced(bred));
        const std::vector<std::u32string> of_a = texts_of(a), of_b = texts_of(b), all = texts_of(bred);
        ASSERT_EQ(all.size(), of_a.size() + of_b.size()) << utf8(a) << " and " << utf8(b);
        const std::size_t common = std::min(of_a.size(), of_b.size());
        for (std::size_t i = 0; i < of_a.size(); ++i) ASSERT_EQ(all[i < common ? 2 * i : common + i], of_a[i]);
        for (std::size_t i = 0; i < of_b.size(); ++i) ASSERT_EQ(all[i < common ? 2 * i + 1 : common + i], of_b[i]);
        // Of any texts nothing is lost, even where tokens join.
        const std::u32string c = random_garbage(random, 25);
        ASSERT_EQ(sorted(breed(a, c)), sorted(a + c));
        ASSERT_EQ(*react(a, c, {}), breed(a, c));
    }
}

struct Headed {
    std::u32string token, heading;
};

// The tokens of a word with what heading each stands under.
std::vector<Headed> headed(std::u32string_view word) {
    std::vector<Headed> all;
    std::vector<std::u32string> stack(1);
    for (const std::u32string& token : texts_of(word)) {
        if (token[0] == U'[') stack.push_back(stack.back());
        if (token[0] == U']') stack.pop_back();
        if (token[0] == U'X' || token[0] == U'Y' || token[0] == U'Z') {
            stack.back() = token;
        } else {
            all.push_back({token, stack.back()});
        }
    }
    return all;
}

TEST(WordEditsProperty, TokensKeepTheHeadingsOfTheirParents) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(2000); ++seed) {
        CaseRandom random(seed);
        const std::u32string a = random_word(random, 25);
        const std::u32string b = random_word(random, 25);
        const std::u32string bred = *breed_carrying_headings(a, b);
        ASSERT_TRUE(is_balanced(bred));
        std::vector<Headed> wanted;
        const std::vector<Headed> of_a = headed(a), of_b = headed(b);
        for (std::size_t i = 0; i < std::max(of_a.size(), of_b.size()); ++i) {
            if (i < of_a.size()) wanted.push_back(of_a[i]);
            if (i < of_b.size()) wanted.push_back(of_b[i]);
        }
        const std::vector<Headed> got = headed(bred);
        ASSERT_EQ(got.size(), wanted.size()) << utf8(a) << " and " << utf8(b);
        for (std::size_t i = 0; i < got.size(); ++i) {
            ASSERT_EQ(got[i].token, wanted[i].token);
            if (is_bracket(got[i].token[0]) || wanted[i].heading.empty()) continue;
            ASSERT_EQ(got[i].heading, wanted[i].heading) << utf8(a) << " and " << utf8(b) << " at " << i;
        }
    }
}

TEST(WordEditsProperty, SubstitutionTakesCompressionBack) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(3000); ++seed) {
        CaseRandom random(seed);
        const std::u32string word = random_word(random, 40);
        const std::vector<EditToken> tokens = edit_tokens(word);
        std::vector<ChunkPair> pairs, back;
        for (std::uint32_t k = 0; k < 3; ++k) {
            const TokenRange range = random_balanced_range(random, word);
            if (range.begin == range.end) continue;
            const std::u32string symbol(1, U'\u03B1' + k);  // no word of the test has it
            pairs.push_back({std::u32string(range_text(word, tokens, range)), symbol});
            back.push_back({symbol, pairs.back().from});
        }
        const Result<ChunkEdit> small = compress(word, pairs);
        ASSERT_TRUE(small);
        ASSERT_EQ(small->replaced > 0, !pairs.empty());
        const Result<ChunkEdit> whole = substitute(small->word, back);
        ASSERT_TRUE(whole);
        ASSERT_EQ(whole->word, word) << utf8(small->word);
    }
}

// By the definition, chunk by chunk at every place.
std::u32string replaced_by_definition(const std::u32string& word, const std::vector<ChunkPair>& pairs) {
    const std::vector<std::u32string> tokens = texts_of(word);
    std::u32string out;
    for (std::size_t i = 0; i < tokens.size();) {
        std::size_t longest = 0;
        const ChunkPair* best = nullptr;
        for (const ChunkPair& pair : pairs) {
            const std::vector<std::u32string> chunk = texts_of(pair.from);
            if (chunk.size() <= longest || i + chunk.size() > tokens.size()) continue;
            if (!std::equal(chunk.begin(), chunk.end(), tokens.begin() + static_cast<std::ptrdiff_t>(i))) continue;
            longest = chunk.size();
            best = &pair;
        }
        out += best != nullptr ? best->to : tokens[i];
        i += std::max<std::size_t>(longest, 1);
    }
    return out;
}

TEST(WordEditsProperty, ChunksAreFoundAsDefined) {
    std::uint64_t replaced = 0;
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(5000); ++seed) {
        CaseRandom random(seed);
        // Few letters, so that chunks overlap, hold and end with one another.
        const auto text = [&](std::uint32_t least, std::uint32_t most) {
            std::u32string out;
            for (std::uint32_t left = random.whole(least, most); left > 0; --left) {
                out += one_of(random, {U"a", U"a", U"b", U"a=", U"T+"});
            }
            return out;
        };
        std::vector<ChunkPair> pairs;
        for (std::uint32_t left = random.below(6); left > 0; --left) pairs.push_back({text(1, 5), text(0, 3)});
        const std::u32string word = text(0, 40);
        const Result<ChunkEdit> edit = substitute(word, pairs);
        ASSERT_TRUE(edit);
        ASSERT_EQ(utf8(edit->word), utf8(replaced_by_definition(word, pairs))) << utf8(word);
        replaced += edit->replaced;
    }
    EXPECT_GT(replaced, case_count(5000));
}

// The neighbour of a token along its branch, walking as the definition says.
std::u32string neighbour_by_definition(std::u32string_view word, std::uint32_t token, bool is_left) {
    const std::vector<EditToken> tokens = edit_tokens(word);
    const std::vector<std::uint32_t> partners = bracket_partners(word, tokens);
    for (std::uint32_t i = token;;) {
        if (is_left ? i == 0 : i + 1 == tokens.size()) return {};
        is_left ? --i : ++i;
        const char32_t symbol = token_symbol(word, tokens[i]);
        if (!is_left && symbol == U']') return {};
        if (is_left && symbol == U'[') continue;  // on at the parent
        if (is_bracket(symbol)) {
            i = partners[i];
            continue;
        }
        return std::u32string(token_text(word, tokens[i]));
    }
}

TEST(WordEditsProperty, ReactionsSeeTheirNeighbours) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(3000); ++seed) {
        CaseRandom random(seed);
        const std::u32string word = random_word(random, 20);
        const std::vector<std::u32string> tokens = texts_of(word);
        if (tokens.empty()) continue;
        const auto at = static_cast<std::uint32_t>(random.index(tokens.size()));
        if (is_bracket(tokens[at][0])) continue;
        const bool is_left = random.coin();
        const bool is_second = random.coin();
        const std::u32string neighbour = neighbour_by_definition(word, at, is_left);
        Reaction reaction{{tokens[at], {}, {}}, {U"z", {}, {}}, U"!"};
        reaction.happens = [&](std::uint32_t pair) { return pair == at; };
        const auto reacts_beside = [&](const std::u32string& context) {
            (is_left ? reaction.x.left : reaction.x.right) = context;
            const std::u32string other(tokens.size(), U'z');
            const auto product = is_second ? react(other, word, std::vector<Reaction>{reaction})
                                           : react(word, other, std::vector<Reaction>{reaction});
            return product->find(U'!') != std::u32string::npos;
        };
        ASSERT_TRUE(reacts_beside(U""));
        ASSERT_FALSE(reacts_beside(U"!"));
        if (!neighbour.empty()) {
            ASSERT_TRUE(reacts_beside(neighbour)) << utf8(word) << " at " << at;
        }
        for (const std::u32string_view other : {U"a", U"b", U"T+"}) {
            const bool is_same = !neighbour.empty() && neighbour.substr(0, neighbour.find(U'=')) == other;
            ASSERT_EQ(reacts_beside(std::u32string(other)), is_same) << utf8(word) << " at " << at;
        }
    }
}

TokenBits bits_of(std::uint64_t seed) {
    return [seed](std::uint32_t token, MutationDraw draw) {
        return random_bits(seed, Key{token}, "mutation", static_cast<std::uint64_t>(draw));
    };
}

TEST(WordEditsProperty, MutationsHangOnTheirOwnDraws) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(1000); ++seed) {
        CaseRandom random(seed);
        const std::u32string word = random_word(random, 30);
        const MutationRates rates = {random.unit() / 2, 0, 0, 0};
        const std::u32string replaced = *mutate(word, rates, U"!", bits_of(seed));
        const std::vector<std::u32string> before = texts_of(word), after = texts_of(replaced);
        ASSERT_EQ(before.size(), after.size());
        MutationRates more = rates;
        more.twice = 1;
        std::u32string wanted;  // the same are replaced, all others doubled
        for (std::size_t i = 0; i < before.size(); ++i) {
            ASSERT_TRUE(after[i] == before[i] || (after[i] == U"!" && !is_bracket(before[i][0])));
            wanted += after[i];
            if (after[i] == before[i] && !is_bracket(before[i][0])) wanted += after[i];
        }
        ASSERT_EQ(utf8(*mutate(word, more, U"!", bits_of(seed))), utf8(wanted));
        // A higher rate replaces all that a lower one does.
        const std::vector<std::u32string> most = texts_of(*mutate(word, {rates.replace * 1.5}, U"!", bits_of(seed)));
        for (std::size_t i = 0; i < most.size(); ++i) ASSERT_TRUE(after[i] != U"!" || most[i] == U"!");
    }
}

TEST(WordEditsProperty, CrossoverComesBack) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(2000); ++seed) {
        CaseRandom random(seed);
        const std::u32string a = random_word(random, 25);
        const std::u32string b = random_word(random, 25);
        const TokenRange from_a = random_balanced_range(random, a);
        const TokenRange from_b = random_balanced_range(random, b);
        const Result<WordPair> crossed = crossover(a, from_a, b, from_b);
        ASSERT_TRUE(crossed);
        ASSERT_EQ(token_count(crossed->a) + token_count(crossed->b), token_count(a) + token_count(b));
        const TokenRange now_in_a = {from_a.begin, from_a.begin + (from_b.end - from_b.begin)};
        const TokenRange now_in_b = {from_b.begin, from_b.begin + (from_a.end - from_a.begin)};
        const Result<WordPair> again = crossover(crossed->a, now_in_a, crossed->b, now_in_b);
        ASSERT_TRUE(again);
        ASSERT_EQ(again->a, a);
        ASSERT_EQ(again->b, b);
        const Result<std::u32string> removed = remove_range(a, from_a);
        ASSERT_TRUE(removed);
        ASSERT_EQ(*removed, crossover(a, from_a, U"", {})->a);
    }
}

TEST(WordEditsProperty, InsertionsCanBeCutOut) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(2000); ++seed) {
        CaseRandom random(seed);
        const std::u32string word = random_word(random, 30);
        const Side side = random.coin() ? Side::before : Side::after;
        TokenSelector chosen;
        chosen.letters = random.coin() ? U"" : U"aT[]";
        const std::size_t count = selected_tokens(word, edit_tokens(word), chosen).size();
        const std::u32string put = *insert_beside(word, U"[!]", side, chosen);
        ASSERT_EQ(put.size(), word.size() + 3 * count);
        const std::vector<ChunkPair> cut = {{U"[!]", U""}};
        ASSERT_EQ(substitute(put, cut)->word, word);
        const std::u32string appended = *append_to_branches(word, U"[!]", BranchEnd::end, {});
        ASSERT_EQ(appended.size(), word.size() + 3 * branches_of(word, edit_tokens(word)).size());
        ASSERT_EQ(substitute(appended, cut)->word, word);
    }
}

// Every edit, on any two texts. What comes out is balanced if what went in was.
void edit_in_all_ways(CaseRandom& random, const std::u32string& a, const std::u32string& b) {
    const bool was_balanced = is_balanced(a) && is_balanced(b);
    const auto look = [&](const std::u32string& word, const char* edit) {
        ASSERT_TRUE(!was_balanced || is_balanced(word)) << edit << " of " << utf8(a) << " and " << utf8(b);
    };
    const auto look_if_made = [&](const Result<std::u32string>& word, const char* edit) {
        if (word) look(*word, edit);
    };
    const auto count_a = static_cast<std::uint32_t>(token_count(a));
    const auto count_b = static_cast<std::uint32_t>(token_count(b));
    const std::u32string put = random.coin() ? random_word(random, 4) : random_garbage(random, 4);
    const std::uint64_t seed = random.bits();
    look(add_words(a, b), "add");
    look(breed(a, b), "breed");
    look_if_made(breed_carrying_headings(a, b), "breed, carrying headings");

    std::vector<Reaction> reactions;
    const std::vector<std::u32string> texts_a = texts_of(a), texts_b = texts_of(b);
    for (std::size_t i = 0; i < std::min({texts_a.size(), texts_b.size(), std::size_t{3}}); ++i) {
        reactions.push_back({{texts_a[i], {}, {}}, {texts_b[i], {}, {}}, put, {}, {}});
    }
    ReactOptions options;
    options.unreacted = static_cast<Unreacted>(random.below(4));
    look_if_made(react(a, b, reactions, options), "react");

    const std::vector<EditToken> tokens = edit_tokens(a);
    const std::uint32_t begin = random.below(count_a + 1);
    const TokenRange range = {begin, begin + random.below(count_a - begin + 1)};
    const std::vector<ChunkPair> pairs = {{std::u32string(range_text(a, tokens, range)), put}, {put, U"a"}};
    for (const auto& edit : {substitute(a, pairs, {.most_passes = 3, .most_symbols = 10000}), compress(a, pairs),
                             compress_by_rules(a, pairs, {.most_passes = 2, .most_symbols = 10000})}) {
        if (edit) look(edit->word, "chunks");
    }

    TokenSelector chosen;
    if (random.coin()) chosen.letters = U"a[]+~=";
    BranchSelector branches;
    branches.with_trunk = random.below(4) == 0;
    if (random.coin()) branches.where = [](const WordBranch& branch) { return branch.ordinal % 2 == 0; };
    look_if_made(insert_beside(a, put, random.coin() ? Side::before : Side::after, chosen), "insert");
    look_if_made(append_to_branches(a, put, random.coin() ? BranchEnd::begin : BranchEnd::end, branches), "append");
    look_if_made(bend(a, chosen, constant_turn(2)), "bend");
    look_if_made(twist(a, chosen, constant_turn(-1)), "twist");
    look_if_made(shrink(a, chosen, constant_shrink(0.5)), "shrink");
    look_if_made(remove_range(a, range), "remove");
    look(remove_branches(a, branches), "remove branches");
    const Result<WordPair> swapped = crossover(a, range, b, {0, random.below(count_b + 2)});
    if (swapped) look(swapped->a + swapped->b, "crossover");
    if (swapped) look(swapped->a, "crossover");
    const Result<WordPair> grafted = crossover_branches(a, random.below(3), b, random.below(3));
    if (grafted) look(grafted->a, "crossover of branches");
    const MutationRates rates = {random.unit(), random.unit(), random.unit(), random.unit()};
    look_if_made(mutate(a, rates, put, bits_of(seed)), "mutate");

    const CleanedWord clean = clean_up(a);
    ASSERT_TRUE(is_balanced(clean.word)) << utf8(a);
    ASSERT_EQ(clean.changes.empty(), clean.word == a) << utf8(a);
    const CleanedWord again = clean_up(clean.word);
    ASSERT_EQ(again.word, clean.word) << utf8(a);
    ASSERT_TRUE(again.changes.empty());
}

TEST(WordEditsProperty, BalancedWordsStayBalanced) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(3000); ++seed) {
        CaseRandom random(seed);
        edit_in_all_ways(random, random_word(random, 25), random_word(random, 25));
        if (HasFatalFailure()) FAIL() << "with seed " << seed;
    }
}

TEST(WordEditsProperty, AnyTextMayBeEdited) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(5000); ++seed) {
        CaseRandom random(seed);
        edit_in_all_ways(random, random_garbage(random, 40), random_garbage(random, 40));
        if (HasFatalFailure()) FAIL() << "with seed " << seed;
    }
}

// Words on which anything that is not linear would take hours.
TEST(WordEditsProperty, LargeWordsAreNoHarderThanSmallOnes) {
    constexpr std::size_t size = 1'000'000;
    std::u32string branches, nested(size / 2, U'['), shrinks, turns = U"XT";
    while (branches.size() < size) branches += U"[a]";
    nested.append(size / 2, U']');
    while (shrinks.size() < size) shrinks += U"~(1";
    turns.append(size, U'+');
    const std::u32string letters(size, U'a');
    const std::u32string chunk = std::u32string(size / 4, U'a') + U"b";
    const std::vector<ChunkPair> pairs = {{chunk, U"c"}, {std::u32string(size / 4, U'a'), U"d"}};
    EXPECT_EQ(substitute(letters, pairs)->word, U"dddd");
    const std::vector<Reaction> reactions = {{{U"a", U"aaab", {}}, {U"a", {}, U"a"}, U"!", {}, {}}};
    for (const std::u32string& word : {branches, nested, shrinks, turns, letters}) {
        EXPECT_EQ(breed(word, letters).size(), word.size() + size);
        EXPECT_TRUE(breed_carrying_headings(word, letters));
        EXPECT_TRUE(react(word, branches, reactions));
        EXPECT_TRUE(append_to_branches(word, U"b", BranchEnd::end));
        EXPECT_TRUE(insert_beside(word, U"bc", Side::after, {}));
        EXPECT_TRUE(bend(word, {}, constant_turn(1)));
        EXPECT_TRUE(substitute(word, std::vector<ChunkPair>{{U"[a]", U"k"}, {U"+", U"-"}}));
        EXPECT_TRUE(mutate(word, {.replace = 0.1, .remove = 0.1, .twice = 0.1, .swap = 0.1}, U"abc", bits_of(1)));
        EXPECT_TRUE(remove_range(word, {0, static_cast<std::uint32_t>(token_count(word))}));
        EXPECT_EQ(clean_up(word).word.size(), word.size());
    }
    const std::u32string long_heading = U"X" + std::u32string(size, U'+') + letters;
    EXPECT_FALSE(breed_carrying_headings(long_heading, U"Y" + letters));
    EXPECT_EQ(clean_up(std::u32string(size, U']')).word.size(), 0U);
    EXPECT_EQ(clean_up(std::u32string(size, U'[')).word.size(), 2 * size);
}

}  // namespace
}  // namespace filigree::rewriting
