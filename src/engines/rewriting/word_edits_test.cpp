#include "engines/rewriting/word_edits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/random.h"
#include "engines/rewriting/word_cases.h"

namespace filigree::rewriting {
namespace {

using nlohmann::json;

template <class T>
std::string code_of(const Result<T>& result) {
    return result.diagnostics().empty() ? "" : result.diagnostics().front().code;
}

std::string text(const Result<std::u32string>& result) { return result ? utf8(*result) : code_of(result); }
std::string text(const Result<ChunkEdit>& result) { return result ? utf8(result->word) : code_of(result); }

std::string run_vector(const std::string& op, const json& args) {
    const auto word = [&](std::size_t i) { return utf32(args[i].get<std::string>()); };
    if (op == "compress") {
        std::vector<ChunkPair> pairs;
        for (const json& pair : args[1]) {
            pairs.push_back({utf32(pair[0].get<std::string>()), utf32(pair[1].get<std::string>())});
        }
        return text(compress(word(0), pairs));
    }
    if (op == "breed") return utf8(breed(word(0), word(1)));
    if (op == "breed_carry") return text(breed_carrying_headings(word(0), word(1)));
    if (op == "insert_before") {
        TokenSelector chosen;
        chosen.letters = word(2);
        return text(insert_beside(word(0), word(1), Side::before, chosen));
    }
    if (op == "append_begin") return text(append_to_branches(word(0), word(1), BranchEnd::begin));
    if (op == "react") {
        std::vector<Reaction> reactions;
        for (const auto& [key, product] : args[2].items()) {
            const std::vector<std::u32string> sides = texts_of(utf32(key));
            reactions.push_back({{sides[0]}, {sides[1]}, utf32(product.get<std::string>())});
        }
        EXPECT_EQ(args[3].get<std::string>(), "both");
        return text(react(word(0), word(1), reactions));
    }
    return "there is no op " + op;
}

TEST(WordEdits, GiveTheVectors) {
    std::ifstream file(FILIGREE_SOURCE_DIR "/tests/data/rewriting_vectors.json");
    std::size_t rows = 0;
    for (const json& row : json::parse(file)) {
        if (row["kind"].get<std::string>() != "edit") continue;
        ++rows;
        const std::string op = row["op"];
        const std::u32string word = utf32(row["args"][0].get<std::string>());
        const std::vector<EditToken> tokens = edit_tokens(word);
        if (op == "distance") {
            json distances = json::array();
            for (const SymbolAttributes& one : attributes_of(word, tokens)) {
                if (one.is_object) distances.push_back({utf8({&one.symbol, 1}), one.distance});
            }
            EXPECT_EQ(distances, row["result"]) << row;
        } else if (op == "density") {
            EXPECT_EQ(density(word, tokens, {0, static_cast<std::uint32_t>(tokens.size())}),
                      row["result"].get<std::uint32_t>())
                << row;
        } else {
            EXPECT_EQ(run_vector(op, row["args"]), row["result"].get<std::string>()) << row;
        }
    }
    EXPECT_EQ(rows, 14U);
}

TEST(WordEdits, HybridsKeepHeadings) {
    const auto bred = [](std::u32string_view a, std::u32string_view b) { return text(breed_carrying_headings(a, b)); };
    EXPECT_EQ(utf8(add_words(U"Xa", U"Yb")), "XaYb");
    EXPECT_EQ(utf8(breed(U"Xaaaa", U"Yaaaa")), "XYaaaaaaaa");
    EXPECT_EQ(bred(U"XaYa", U"bb"), "XabYab");                  // none of its own: what it finds
    EXPECT_EQ(bred(U"Xaa", U"XbYb"), "XabaYb");                 // no letter that changes nothing
    EXPECT_EQ(bred(U"X[Yaa]a", U"Zbbbb"), "[ZbYaZbYaZb]ZbXa");  // the brackets restore what was in force
    EXPECT_EQ(bred(U"aX", U"b"), "ab");                         // nothing behind it
    EXPECT_EQ(bred(U"XT+a", U"Yb"), "XT+YbXa");
    EXPECT_EQ(text(breed_carrying_headings(U"Xaaaa", U"Yaaaa", 15)), "rewriting.edited-word-too-large");
}

TEST(WordEdits, ReactionsLookAround) {
    const auto reacted = [](std::u32string_view a, std::u32string_view b, const std::vector<Reaction>& list,
                            Unreacted unreacted = Unreacted::both) {
        ReactOptions options;
        options.unreacted = unreacted;
        return text(react(a, b, list, options));
    };
    const std::vector<Reaction> plain = {{{U"a"}, {U"c"}, U"e[f]"}};
    EXPECT_EQ(reacted(U"aba", U"cccc", plain), "e[f]bce[f]c");
    EXPECT_EQ(reacted(U"aba", U"cccc", plain, Unreacted::a), "e[f]be[f]");
    EXPECT_EQ(reacted(U"aba", U"cccc", plain, Unreacted::b), "e[f]ce[f]c");
    EXPECT_EQ(reacted(U"aba", U"cccc", plain, Unreacted::none), "e[f]e[f]");
    EXPECT_EQ(reacted(U"a=a", U"cc=", plain), "a=cac=");  // frozen symbols do not react
    // Left of a: b on the way from the root, past the branch [c]; its '=' does not count.
    const std::vector<Reaction> left = {{{U"a", U"xb"}, {U"z"}, U"!"}};
    EXPECT_EQ(reacted(U"xb=[c]a", U"zzzzzz", left, Unreacted::a), "xb=[c]!");
    EXPECT_EQ(reacted(U"xb[[a]a]a", U"zzzzzzzzz", left, Unreacted::a), "xb[[!]!]!");
    EXPECT_EQ(reacted(U"xbca", U"zzzz", left, Unreacted::a), "xbca");
    EXPECT_EQ(reacted(U"ba", U"zz", left, Unreacted::a), "ba");
    // To the right it never leaves the branch.
    const std::vector<Reaction> right = {{{U"z"}, {U"a", {}, U"b"}, U"!"}};
    EXPECT_EQ(reacted(U"zzzzz", U"a[c]b", right, Unreacted::b), "![c]b");
    EXPECT_EQ(reacted(U"zzzzz", U"c[a]b", right, Unreacted::b), "c[a]b");
    EXPECT_EQ(reacted(U"zzzzz", U"a[b]c", right, Unreacted::b), "a[b]c");
}

TEST(WordEdits, ReactionsAskConditionsAndChance) {
    std::vector<Reaction> reactions = {{{U"a"}, {U"b"}, U"1"}, {{U"b"}, {U"a"}, U"2"}};
    reactions[0].condition = [](const SymbolAttributes& x, const SymbolAttributes& y) {
        return x.symbol == U'a' && x.age > 2 && y.distance > 0;
    };
    ReactOptions options;
    const std::vector<std::uint32_t> ages = {3, 3, 1};
    options.ages_a = ages;
    EXPECT_EQ(text(react(U"aaa", U"bbb", reactions, options)), "212");
    options.ages_a = {};
    options.ages_b = ages;  // now x stands in the second word
    EXPECT_EQ(text(react(U"bbb", U"aaa", reactions, options)), "212");
    reactions[0].condition = nullptr;
    reactions[0].happens = [](std::uint32_t pair) { return pair == 1; };
    EXPECT_EQ(text(react(U"aaa", U"bbb", reactions)), "212");
    EXPECT_EQ(text(react(U"aaa", U"bbb", std::vector<Reaction>{reactions[0]})), "ab1ab");
}

TEST(WordEdits, ReactionsAreChecked) {
    const auto code = [](const Reaction& one) { return code_of(react(U"a", U"b", std::vector<Reaction>{one})); };
    EXPECT_EQ(code({{U"a"}, {U"b"}, U"["}), "rewriting.unbalanced-text");
    EXPECT_EQ(code({{U"ab"}, {U"b"}, U""}), "rewriting.no-reactant");
    EXPECT_EQ(code({{U""}, {U"b"}, U""}), "rewriting.no-reactant");
    EXPECT_EQ(code({{U"a"}, {U"]"}, U""}), "rewriting.no-reactant");
    EXPECT_EQ(code({{U"a", U"[c"}, {U"b"}, U""}), "rewriting.bracket-in-context");
    EXPECT_EQ(code({{U"a", U"", std::u32string(65, U'c')}, {U"b"}, U""}), "rewriting.long-context");
    EXPECT_EQ(code({{U"a", U"", std::u32string(64, U'c')}, {U"b"}, U""}), "");
    ReactOptions small;
    small.most_symbols = 3;
    EXPECT_EQ(text(react(U"aa", U"bb", {}, small)), "rewriting.edited-word-too-large");
}

TEST(WordEdits, ChunksAreReplacedFromTheLeftLongestFirst) {
    const auto replaced = [](std::u32string_view word, const std::vector<ChunkPair>& pairs, std::uint32_t passes = 1) {
        return text(substitute(word, pairs, {.most_passes = passes}));
    };
    EXPECT_EQ(replaced(U"aaaaa", {{U"aa", U"x"}, {U"aaa", U"y"}}), "yx");
    EXPECT_EQ(replaced(U"abcab", {{U"bc", U"x"}, {U"ab", U"y"}}), "ycy");
    EXPECT_EQ(replaced(U"T+aTa", {{U"T", U"P"}, {U"+", U"-"}}), "T+aPa");  // never inside a token
    EXPECT_EQ(replaced(U"aa=a", {{U"aa", U"x"}, {U"a=", U"y"}}), "aya");
    EXPECT_EQ(replaced(U"a[b]", {{U"a[", U"[c"}, {U"b", U""}}), "[c]");
    EXPECT_EQ(replaced(U"ab", {{U"a", U"x"}, {U"a", U"y"}}), "xb");
    EXPECT_EQ(replaced(U"aaaaaaaa", {{U"aa", U"a"}}), "aaaa");
    EXPECT_EQ(replaced(U"aaaaaaaa", {{U"aa", U"a"}}, 9), "a");
    EXPECT_EQ(replaced(U"\u00F1=\u00F1", {{U"\u00F1=", U"ab"}}), "ab\u00F1");
    EXPECT_EQ(replaced(U"a", {{U"", U"x"}}), "rewriting.empty-chunk");
    EXPECT_EQ(replaced(U"a", {{U"a", U"]["}}), "rewriting.unbalanced-chunk");
    EXPECT_EQ(text(compress(U"aa", std::vector<ChunkPair>{{U"aa", U"bc"}})), "rewriting.not-one-symbol");
    EXPECT_EQ(text(compress(U"aa", std::vector<ChunkPair>{{U"aa", U"T+="}})), "T+=");
}

TEST(WordEdits, PassesAreCountedAndBounded) {
    const std::vector<ChunkPair> halving = {{U"aa", U"a"}};
    const Result<ChunkEdit> settled = compress(U"aaaaaaaa", halving, {.most_passes = 4});
    ASSERT_TRUE(settled);
    EXPECT_EQ(settled->passes, 4U);
    EXPECT_TRUE(settled->is_settled && settled->replaced == 7 && settled.diagnostics().empty());
    const Result<ChunkEdit> cut = compress(U"aaaaaaaa", halving, {.most_passes = 3});
    EXPECT_TRUE(cut && !cut->is_settled);
    EXPECT_EQ(code_of(cut), "rewriting.chunks-not-settled");
    const std::vector<ChunkPair> doubling = {{U"a", U"aa"}};
    EXPECT_EQ(text(substitute(U"a", doubling, {.most_passes = 1000})), "rewriting.edited-word-too-large");
    EXPECT_EQ(text(substitute(U"a", doubling, {.most_passes = 3, .most_symbols = 8})), "aaaaaaaa");
    EXPECT_EQ(text(substitute(U"a", doubling, {.most_passes = 0})), "a");
}

TEST(WordEdits, ProductionsRunBackwards) {
    const std::vector<ChunkPair> algae = {{U"a", U"ab"}, {U"b", U"a"}};
    EXPECT_EQ(text(compress_by_rules(U"abaababa", algae)), "abaab");
    const std::vector<ChunkPair> odd = {{U"a", U"a"}, {U"b", U""}, {U"c", U"[c"}, {U"d", U"[P+d]d"}};
    const Result<ChunkEdit> edit = compress_by_rules(U"a[P+d]dc", odd);
    EXPECT_EQ(text(edit), "adc");
    EXPECT_EQ(code_of(edit), "rewriting.unbalanced-production");
    EXPECT_EQ(text(compress_by_rules(U"a", std::vector<ChunkPair>{{U"ab", U"c"}})), "rewriting.not-one-symbol");
}

TEST(WordEdits, InsertionsAreForWhatIsChosen) {
    TokenSelector chosen;
    EXPECT_EQ(text(insert_beside(U"a[P+b=]+c", U"!", Side::after, chosen)), "a![P+b=!]+c!");  // all objects
    chosen.letters = U"P[";
    EXPECT_EQ(text(insert_beside(U"a[P+b]", U"[x]", Side::before, chosen)), "a[x][[x]P+b]");
    chosen.letters = U"a";
    EXPECT_EQ(text(insert_beside(U"aba", U"=", Side::after, chosen)), "a=ba=");
    chosen.letters.clear();
    chosen.where = [](std::uint32_t index, const SymbolAttributes& one) { return index > 0 && one.depth == 0; };
    EXPECT_EQ(text(insert_beside(U"aa[a]a", U"T+", Side::before, chosen)), "aT+a[a]T+a");
    const std::vector<std::uint32_t> ages = {1, 4, 1, 4};
    chosen.ages = ages;
    chosen.where = [](std::uint32_t, const SymbolAttributes& one) { return one.age > 3; };
    EXPECT_EQ(text(insert_beside(U"a=bcd", U"!", Side::before, chosen)), "a=!bc!d");
    EXPECT_EQ(text(insert_beside(U"a", U"[", Side::before, {})), "rewriting.unbalanced-text");
    EXPECT_EQ(text(insert_beside(U"aaa", U"bb", Side::before, {}, 8)), "rewriting.edited-word-too-large");
    EXPECT_EQ(text(insert_beside(U"aaa", U"bb", Side::before, {}, 9)), "bbabbabba");
}

TEST(WordEdits, BranchesAreAppendedTo) {
    EXPECT_EQ(text(append_to_branches(U"a[b[c]]", U"d", BranchEnd::end)), "a[b[cd]d]");
    BranchSelector chosen;
    chosen.with_trunk = true;
    EXPECT_EQ(text(append_to_branches(U"a[b[c]]", U"d", BranchEnd::end, chosen)), "a[b[cd]d]d");
    EXPECT_EQ(text(append_to_branches(U"a[=b[c]]", U"d", BranchEnd::begin, chosen)), "da[=db[dc]]");
    chosen.with_trunk = false;
    chosen.where = [](const WordBranch& branch) { return branch.depth == 2; };
    EXPECT_EQ(text(append_to_branches(U"a[b[c]][e]", U"d", BranchEnd::end, chosen)), "a[b[cd]][e]");
    chosen.where = [](const WordBranch& branch) { return branch.ordinal == 2; };
    EXPECT_EQ(text(append_to_branches(U"a[b[c]][e]", U"d", BranchEnd::end, chosen)), "a[b[c]][ed]");
    EXPECT_EQ(text(append_to_branches(U"a", U"]", BranchEnd::end)), "rewriting.unbalanced-text");
}

TEST(WordEdits, GeometryInsertsTurnsAndShrinks) {
    EXPECT_EQ(text(bend(U"a[ba]", {.letters = U"a"}, constant_turn(2))), "T++a[bT++a]");
    EXPECT_EQ(text(twist(U"aaa", {}, [](std::uint32_t k, std::uint32_t) { return static_cast<std::int32_t>(k) - 1; })),
              "D-aaD+a");
    EXPECT_EQ(text(twist(U"a[b]", {}, [](std::uint32_t, std::uint32_t i) { return static_cast<std::int32_t>(i); })),
              "a[D++b]");
    EXPECT_EQ(text(turn_before(U"a", {}, U'P', constant_turn(-1))), "P-a");
    EXPECT_EQ(text(turn_before(U"a", {}, U'a', constant_turn(1))), "rewriting.no-axis");
    EXPECT_EQ(text(bend(U"a", {}, constant_turn(INT32_MIN))), "rewriting.edited-word-too-large");
    EXPECT_EQ(text(shrink(U"ab", {.letters = U"b"}, constant_shrink(0.9))), "a~(0.9)b");
    EXPECT_EQ(text(shrink(U"ab", {}, [](std::uint32_t k, std::uint32_t) { return k == 0 ? 1 : 1e-9; })), "a~(1e-9)b");
    EXPECT_EQ(texts_of(*shrink(U"b", {}, constant_shrink(1e-9))).size(), 2U);
    for (const double wrong : {0.0, -1.0, HUGE_VAL, std::nan("")}) {
        EXPECT_EQ(text(shrink(U"a", {}, constant_shrink(wrong))), "rewriting.shrink-factor");
    }
}

TEST(WordEdits, RangesAndBranchesGo) {
    EXPECT_EQ(text(remove_range(U"aP++[b]c", {1, 5})), "ac");
    EXPECT_EQ(text(remove_range(U"ab", {1, 1})), "ab");
    EXPECT_EQ(text(remove_range(U"ab", {1, 3})), "rewriting.range-outside");
    EXPECT_EQ(text(remove_range(U"ab", {2, 1})), "rewriting.range-outside");
    const Result<std::u32string> torn = remove_range(U"ab[cd]", {1, 4});
    EXPECT_EQ(code_of(torn), "rewriting.torn-range");
    EXPECT_EQ(torn.diagnostics()[0].hints, (std::vector<std::string>{"a whole range is 1 to 6"}));
    BranchSelector chosen;
    EXPECT_EQ(utf8(remove_branches(U"a[b[c]]d[e]f]", chosen)), "adf]");
    chosen.where = [](const WordBranch& branch) { return branch.density == 1; };
    EXPECT_EQ(utf8(remove_branches(U"a[b[c]]d[e]f", chosen)), "a[b]df");
    chosen.with_trunk = true;
    EXPECT_EQ(utf8(remove_branches(U"a[b]", chosen)), "");
}

TEST(WordEdits, CrossoverSwaps) {
    const Result<WordPair> crossed = crossover(U"aT+[b]c", {1, 5}, U"xy", {2, 2});
    ASSERT_TRUE(crossed);
    EXPECT_EQ(utf8(crossed->a), "ac");
    EXPECT_EQ(utf8(crossed->b), "xyT+[b]");
    const Result<WordPair> branches = crossover_branches(U"a[b[c]]", 1, U"[x]y[zz]", 1);
    ASSERT_TRUE(branches);
    EXPECT_EQ(utf8(branches->a), "a[b[zz]]");
    EXPECT_EQ(utf8(branches->b), "[x]y[c]");
    EXPECT_EQ(code_of(crossover_branches(U"a[b]", 0, U"x", 0)), "rewriting.no-such-branch");
    EXPECT_EQ(crossover(U"a[b]", {0, 2}, U"x", {0, 5}).diagnostics().size(), 2U);
}

TEST(WordEdits, MutationsComeAtTheirRates) {
    const TokenBits bits = [](std::uint32_t token, MutationDraw draw) {
        return random_bits(5, Key{token}, "mutation", static_cast<std::uint64_t>(draw));
    };
    const std::u32string_view word = U"ab=[T+c]d";
    EXPECT_EQ(text(mutate(word, {}, U"", bits)), utf8(word));
    EXPECT_EQ(text(mutate(word, {.replace = 1}, U"x", bits)), "xx[xx]x");
    EXPECT_EQ(text(mutate(word, {.remove = 1}, U"", bits)), "[]");
    EXPECT_EQ(text(mutate(word, {.twice = 1}, U"", bits)), "aab=b=[T+T+cc]dd");
    EXPECT_EQ(text(mutate(word, {.swap = 1}, U"", bits)), "b=a[cT+]d");
    EXPECT_EQ(text(mutate(U"a[b]c[dc]", {.swap = 1}, U"", bits)), "a[b]c[cd]");  // not across brackets
    EXPECT_EQ(text(mutate(word, {.replace = 1}, U"[]", bits)), utf8(word));      // nothing to draw
    EXPECT_EQ(text(mutate(word, {.replace = 1.1}, U"", bits)), "rewriting.mutation-rate");
    EXPECT_EQ(text(mutate(word, {.swap = std::nan("")}, U"", bits)), "rewriting.mutation-rate");
    EXPECT_EQ(text(mutate(word, {.twice = 1}, U"", bits, 10)), "rewriting.edited-word-too-large");

    const std::u32string many(20000, U'a');
    const Result<std::u32string> mutated = mutate(many, {.replace = 0.25, .remove = 0.5}, U"xxxy", bits);
    ASSERT_TRUE(mutated);
    const auto count = [&](char32_t c) { return std::count(mutated->begin(), mutated->end(), c); };
    EXPECT_NEAR(static_cast<double>(count(U'x')), 3750, 250);
    EXPECT_NEAR(static_cast<double>(count(U'y')), 1250, 150);
    EXPECT_NEAR(static_cast<double>(count(U'a')), 7500, 300);
}

TEST(WordEdits, CleaningSaysWhatItDid) {
    const auto cleaned = [](std::u32string_view word) { return clean_up(word); };
    EXPECT_EQ(utf8(cleaned(U"==a]=b[c[T+ =]+").word), "ab[c[T+=]+]");
    const CleanedWord one = cleaned(U"= =a]=b[c[d");
    EXPECT_EQ(utf8(one.word), "ab[c[d]]");
    EXPECT_EQ(one.changes,
              (std::vector<std::string>{"removed 1 blank at 1", "removed 2 '=' with nothing before, at 0 and 2",
                                        "removed 1 ']' that closes nothing, at 4",
                                        "added 2 ']' at the end for '[' at 7 and 9"}));
    EXPECT_TRUE(cleaned(U"+a[T+b=]=-").changes.empty());  // bare modifiers are legal
    EXPECT_EQ(cleaned(std::u32string(10, U']')).changes,
              (std::vector<std::string>{"removed 10 ']' that close nothing, at 0, 1, 2, 3, 4, 5, 6, 7 and 2 more"}));
    EXPECT_EQ(utf8(cleaned(U"").word), "");
}

}  // namespace
}  // namespace filigree::rewriting
