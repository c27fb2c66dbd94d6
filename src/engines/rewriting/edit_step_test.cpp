#include "engines/rewriting/edit_step.h"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "base/test_cases.h"
#include "engines/rewriting/plain.h"
#include "engines/rewriting/read_grammar_test.h"
#include "engines/rewriting/word_cases.h"

namespace filigree::rewriting {
namespace {

// Ages are counted here.
DeriveOptions options_with_ages(const Read& said) {
    DeriveOptions options = options_of(said);
    options.with_ages = true;
    return options;
}

// Derives as far as the document says. The code of what goes wrong, if anything does.
std::string derive(const Read& said, Derivation& derivation, const OtherDocument& other = {}) {
    if (!said.problems.empty()) return said.problems.front().code;
    const DeriveOptions options = options_with_ages(said);
    const auto edit = [&](EditTime time) {
        const Diagnostics problems = apply_edits(derivation, said.grammar, time, options, other, {});
        return problems.empty() ? std::string() : problems.front().code;
    };
    Result<Derivation> begun = begin(said.grammar, options);
    if (!begun) return begun.diagnostics().front().code;
    derivation = std::move(*begun);
    for (std::uint32_t t = 0; t < said.grammar.systems[0].iterations; ++t) {
        if (const auto problem = step(derivation, said.grammar, options, {})) return problem->code;
        if (const std::string code = edit(EditTime::iteration); !code.empty()) return code;
    }
    return edit(EditTime::end);
}

std::string word(const std::string& text) {
    Derivation derivation;
    const std::string problem = derive(read(text), derivation);
    return problem.empty() ? to_text(derivation.word, derivation.alphabet) : problem;
}
// Of a word that is no more than its axiom.
std::string edited(const std::string& axiom, const std::string& edit) {
    return word("axiom \"" + axiom + "\"\nonce " + edit);
}

TEST(EditStep, EveryEditIsReached) {
    EXPECT_EQ(edited("ab", "add(with_word: \"cd\")"), "abcd");
    EXPECT_EQ(edited("abc", "breed(with_word: \"xy\")"), "axbyc");
    EXPECT_EQ(edited("Xaa", "breed(with_word: \"Yaa\", carry)"), "XaYaXaYa");
    EXPECT_EQ(edited("abab", "react(with_word: \"cdcd\", \"ac\" -> \"e\")"), "ebdebd");
    EXPECT_EQ(edited("abab", "react(with_word: \"cdcd\", \"ac\" -> \"e\", unreacted: none)"), "ee");
    EXPECT_EQ(edited("abab", "react(with_word: \"cdcd\", \"ac\" -> \"e\", unreacted: own)"), "ebeb");
    EXPECT_EQ(edited("abab", "react(with_word: \"cdcd\", \"ac\" -> \"e\", unreacted: other)"), "eded");
    EXPECT_EQ(edited("abab", "react(with_word: \"cdcd\", \"b < a  c\" -> \"e\")"), "acbdebd");
    EXPECT_EQ(edited("abab", "react(with_word: \"cdcd\", \"b < a > b  d < c > d\" -> \"e\")"), "acbdebd");
    EXPECT_EQ(edited("a[a]", "react(with_word: \"c[c]\", \"ac\" -> \"e\", where: depth > 0)"), "ac[[e]]");
    EXPECT_EQ(edited("abab", "react(with_word: \"cdcd\", \"ac\" -> \"e\", chance: 0)"), "acbdacbd");
    EXPECT_EQ(edited("aaaaaaa", "compress(\"aaa\" -> \"b\")"), "bba");
    EXPECT_EQ(edited("aaaa", "compress(\"aa\" -> \"b\", \"bb\" -> \"c\", passes: 9)"), "c");
    EXPECT_EQ(edited("aab", "substitute(\"a a\" -> \"{2 T+}c\")"), "T+T+cb") << "blanks are no symbols";
    EXPECT_EQ(edited("aaaa", "insert(\"T+\", at: \"a\")"), "T+aT+aT+aT+a");
    EXPECT_EQ(edited("a[b]", "insert(\"{2 c}\", place: after, where: depth > 0)"), "a[bcc]");
    EXPECT_EQ(edited("a[b[c]]", "append(\"d\", to: begin)"), "a[db[dc]]");
    EXPECT_EQ(edited("a[b[c]]", "append(\"d\", where: depth == 1, trunk)"), "a[b[c]d]d");
    EXPECT_EQ(edited("a[b[c]]d", "remove(where: density == 1)"), "a[b]d");
    EXPECT_EQ(edited("aP++bc", "remove(from: 1, to: 3)"), "ac");
    EXPECT_EQ(edited("a[b]", "crossover(with_word: \"x[y[z]]\", other_branch: 1)"), "a[z]");
    EXPECT_EQ(edited("a[b]", "crossover(with_word: \"x[y[z]]\", other_branch: 1, keep: other)"), "x[y[b]]");
    EXPECT_EQ(edited("abc", "crossover(with_word: \"xyz\", from: 1, to: 2, other_to: 2)"), "axyc");
    EXPECT_EQ(edited("a[a]", "mutate(replace: 1, by: \"x\")"), "x[x]");
    EXPECT_EQ(edited("a]b[c", "clean()"), "ab[c]");
    EXPECT_EQ(edited("ab", "shrink(0.5, \"b\")"), "a~(0.5)b");
    EXPECT_EQ(edited("a[b]", "twist(2, where: depth > 0)"), "a[D++b]");
    EXPECT_EQ(edited("aaaa", "bend(ordinal - 2)"), "T--aT-aaT+a");
}

TEST(EditStep, ArgumentsKnowTokensRegistersAndTheIteration) {
    EXPECT_EQ(word("axiom \"a\"\nregister k 2\niterations 2\na -> \"ab\"\nonce insert(\"{$k c}\", at: \"a\")"),
              "ccabb");
    EXPECT_EQ(word("axiom \"a\"\niterations 3\na -> \"ab\"\nonce bend(t, at: \"a\")"), "T+++abbb");
    EXPECT_EQ(word("param n = 2\naxiom \"aa\"\nonce bend(n * index)"), "aT++a");
    EXPECT_EQ(word("axiom \"aa===\"\niterations 3\na -> \"ab\"\nonce insert(\"!\", where: age > 2)"), "!a!bbba");
    EXPECT_EQ(word("axiom \"aba\"\nonce shrink(letter == \"a\" ? 0.5 : 1)"), "~(0.5)ab~(0.5)a");
    EXPECT_EQ(word("axiom \"aaa\"\nonce bend(0..0 + index)"), "aT+aT++a");
    // A choice is drawn for every token.
    const std::string drawn = word("seed 4\naxiom \"" + std::string(60, 'a') + "\"\nonce bend(1..3)");
    for (const char* turn : {"T+a", "T++a", "T+++a"}) EXPECT_NE(drawn.find(turn), std::string::npos) << drawn;
}

TEST(EditStep, ActsWhenItIsSaid) {
    const std::string grammar = "axiom \"a\"\niterations 3\na -> \"ab\"\n";
    EXPECT_EQ(word(grammar + "once add(with_word: \"c\")"), "abbbc");
    EXPECT_EQ(word(grammar + "after 2 add(with_word: \"a\")"), "abbbab");
    EXPECT_EQ(word(grammar + "after 2..3 add(with_word: \"c\")"), "abbbcc");
    EXPECT_EQ(word(grammar + "after 4 add(with_word: \"c\")"), "abbb");
    EXPECT_EQ(word(grammar + "each iteration add(with_word: \"c\")"), "abbbccc");
    EXPECT_EQ(word(grammar + "once add(with_word: \"z\")\neach iteration add(with_word: \"c\")"), "abbbcccz");
    EXPECT_EQ(word(grammar + "each iteration compress(\"bb\" -> \"c\")\nonce compress(by_rules)"), "ac");
    EXPECT_EQ(word(grammar + "once compress(by_rules)"), "abb") << "one pass takes one iteration back";
    EXPECT_EQ(word(grammar + "once compress(by_rules, passes: 4)"), "a");
}

TEST(EditStep, TheOtherWordIsThatOfASystemOrADocument) {
    const std::string grammar = "axiom \"aaa\"\nsystem B { axiom \"b\"; iterations 2; b -> \"bc\" }\n";
    EXPECT_EQ(word(grammar + "once breed(B)"), "abacac");
    EXPECT_EQ(word(grammar + "once breed(\"B\")"), "abacac");
    EXPECT_EQ(word(grammar + "once add(\"b.fil\")"), "rewriting.unknown-system") << "nobody knows documents here";
    const Read said = read(grammar + "once add(\"b.fil\")");
    Derivation derivation;
    EXPECT_EQ(derive(said, derivation, [](const std::string& name) { return utf32(name.substr(0, 1)); }), "");
    EXPECT_EQ(to_text(derivation.word, derivation.alphabet), "aaab");
}

// What an edit puts is rewritten as if it stood in the axiom; what it leaves goes on as it was.
TEST(EditStep, TheDerivationGoesOn) {
    EXPECT_EQ(word("axiom \"a\"\niterations 2\na -> \"ab\"\nafter 1 add(with_word: \"q=a\")"), "abbqab");
    EXPECT_EQ(word("axiom \"a\"\niterations 2\nafter 1 add(with_word: \"qqqi\")"), "aqqi");
    EXPECT_EQ(word("axiom \"q=\"\niterations 2\nafter 1 add(with_word: \"i\")"), "i")
        << "an i that comes to stand behind a run makes it shrink";
    EXPECT_EQ(word("axiom \"a\"\niterations 2\nafter 1 insert(\"=\", place: after)\na -> \"ab\""), "ab");
    EXPECT_EQ(word("axiom \"a\"\nonce insert(\"=\")"), "a") << "'=' behind nothing";
    // The letters of a system that grows stay its letters.
    EXPECT_EQ(
        word("axiom \"A\"\niterations 3\nA -> \"x\"\nsystem A { mode grow; axiom \"c\"; iterations 2; c -> \"cd\" }\n"
             "after 2 add(with_word: \"c\")"),
        "rewriting.special-letter");
    EXPECT_EQ(word("axiom \"A\"\niterations 3\nsystem A { mode grow; axiom \"c\"; iterations 2; c -> \"cd\" }\n"
                   "after 2 add(with_word: \"c\")"),
              "cddc");
    // An n that is put is counted, an ñ keeps where it came from.
    EXPECT_EQ(word("axiom \"nn\"\niterations 3\nn@1 -> \"\u00F1\"\n\u00F1@3 -> \"x\"\nafter 2 insert(\"\u00F1\")"),
              "xxxxxxxx");
    EXPECT_EQ(word("axiom \"nn\"\niterations 2\nn -> \"n\"\nafter 1 add(with_word: \"n\")"), "nnnnnnnnnn");
}

TEST(EditStep, ColumnsStayWithTheirSymbols) {
    const Read said =
        read("axiom \"ab\"\niterations 2\nrandom lineage\na -> \"a\", \"a\"\nafter 2 insert(\"cd\", at: \"b\")");
    const Read without = read("axiom \"ab\"\niterations 2\nrandom lineage\na -> \"a\", \"a\"");
    Derivation plain, changed;
    ASSERT_EQ(derive(without, plain), "");
    ASSERT_EQ(derive(said, changed), "");
    EXPECT_EQ(to_text(changed.word, changed.alphabet), "acdb");
    EXPECT_EQ(changed.word.ages, (std::vector<std::uint32_t>{3, 1, 1, 3}));
    ASSERT_EQ(changed.word.keys.size(), 4U);
    EXPECT_EQ(changed.word.keys.front(), plain.word.keys.front());
    EXPECT_EQ(changed.word.keys.back(), plain.word.keys.back());
    EXPECT_EQ(std::set<std::uint64_t>(changed.word.keys.begin(), changed.word.keys.end()).size(), 4U);
}

// A new symbol draws by whom it stands behind, so an edit far away changes nothing of it.
TEST(EditStep, NewSymbolsDescendFromWhatStandsBefore) {
    const std::string rest = "\niterations 1\nseed 5\nx -> \"x\", \"y\"\na -> \"a\"\nafter 1 insert(\"x\", at: \"b\")";
    const Read one = read("axiom \"abab\"" + rest), two = read("axiom \"ababacb\"" + rest);
    Derivation short_word, long_word;
    ASSERT_EQ(derive(one, short_word), "");
    ASSERT_EQ(derive(two, long_word), "");
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(short_word.word.keys[i], long_word.word.keys[i]) << i;
}

TEST(EditStep, MutationsHangOnSeedAndStatementAlone) {
    const std::string text =
        "axiom \"" + std::string(200, 'a') + "\"\nonce mutate(replace: 30%, twice: 10%, by: \"bc\")";
    EXPECT_EQ(word("seed 1\n" + text), word("seed 1\n" + text));
    EXPECT_NE(word("seed 1\n" + text), word("seed 2\n" + text));
    // The second of a document draws otherwise.
    const std::string other = "\nonce mutate(swap: 0)";
    EXPECT_EQ(word("seed 1\n" + text), word("seed 1\n" + text + other));
    EXPECT_NE(word("seed 1\n" + text),
              word("seed 1\n" + text.substr(0, text.find("\n")) + other + text.substr(text.find("\n"))));
}

TEST(EditStep, AnErrorLeavesAllAsItWas) {
    const Read said = read("axiom \"aaaa\"\nlimit elements 10\nonce insert(\"xx\")");
    ASSERT_TRUE(said.problems.empty());
    DeriveOptions options = options_with_ages(said);
    options.limits = said.settings.limits;
    Result<Derivation> derivation = begin(said.grammar, options);
    ASSERT_TRUE(derivation);
    const Result<EditReport> report = apply_edit(*derivation, said.grammar.edits[0], said.grammar, options, {}, {});
    ASSERT_FALSE(report);
    EXPECT_EQ(report.diagnostics().front().code, "rewriting.edited-word-too-large");
    EXPECT_EQ(report.diagnostics().front().fault, Fault::limit);
    EXPECT_EQ(report.diagnostics().front().span, said.grammar.edits[0].span);
    EXPECT_EQ(to_text(derivation->word, derivation->alphabet), "aaaa");
    EXPECT_EQ(edited("a", "bend(1000000 * 1000000)"), "language.out-of-range");
    EXPECT_EQ(edited("ab", "shrink(1 - index)"), "language.out-of-range") << "only for the second token";
    EXPECT_EQ(edited("ab", "remove(from: 1, to: 3)"), "rewriting.range-outside");
    EXPECT_EQ(edited("a", "crossover(with_word: \"b\")"), "rewriting.no-such-branch");
}

TEST(EditStep, AGrammarWithEditsIsNotPlain) {
    Read said = read("axiom \"a\"\na -> \"ab\"\nonce clean()");
    Result<Derivation> derivation = begin(said.grammar, options_of(said));
    ASSERT_TRUE(derivation);
    EXPECT_FALSE(plain_substitution(*derivation, said.grammar));
    said.grammar.edits.clear();
    EXPECT_TRUE(plain_substitution(*derivation, said.grammar));
}

TEST(EditStep, ReportsWhatWasDone) {
    const Read said = read("axiom \"aaab]\"\nonce compress(\"aa\" -> \"c\")\nonce clean()");
    const DeriveOptions options = options_with_ages(said);
    Result<Derivation> derivation = begin(said.grammar, options);
    ASSERT_TRUE(derivation);
    const Result<EditReport> chunks = apply_edit(*derivation, said.grammar.edits[0], said.grammar, options, {}, {});
    ASSERT_TRUE(chunks);
    EXPECT_EQ(chunks->before, 5U);
    EXPECT_EQ(chunks->kept, 3U);
    EXPECT_EQ(chunks->after, 4U);
    EXPECT_EQ(chunks->replaced, 1U);
    EXPECT_EQ(chunks->passes, 1U);
    const Result<EditReport> cleaned = apply_edit(*derivation, said.grammar.edits[1], said.grammar, options, {}, {});
    ASSERT_TRUE(cleaned);
    EXPECT_EQ(cleaned->changes, (std::vector<std::string>{"removed 1 ']' that closes nothing, at 3"}));
    EXPECT_EQ(to_text(derivation->word, derivation->alphabet), "cab");
}

// --- the traces of the library: every symbol that is not new is one of the word before, each at most once.

void expect_true_trace(std::u32string_view before, std::u32string_view after, const EditTrace& trace,
                       const char* edit) {
    ASSERT_EQ(trace.size(), after.size()) << edit << " of " << utf8(before);
    std::set<std::uint32_t> met;
    for (std::size_t i = 0; i < after.size(); ++i) {
        if (trace[i] == new_symbol) continue;
        ASSERT_LT(trace[i], before.size()) << edit;
        ASSERT_EQ(before[trace[i]], after[i]) << edit << " of " << utf8(before);
        ASSERT_TRUE(met.insert(trace[i]).second) << edit << " of " << utf8(before);
    }
}

TEST(EditTraces, NameEverySymbolThatStays) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(1000); ++seed) {
        CaseRandom random(seed);
        const std::u32string a = random_word(random, 20), b = random_word(random, 20);
        const auto size = static_cast<std::uint32_t>(edit_tokens(a).size());
        EditTrace trace;
        const auto look = [&](const Result<std::u32string>& made, const char* edit) {
            if (made) expect_true_trace(a, *made, trace, edit);
        };
        look(add_words(a, b, &trace), "add");
        EXPECT_TRUE(a.empty() || trace[0] == 0);
        look(breed(a, b, &trace), "breed");
        EXPECT_EQ(static_cast<std::size_t>(std::count(trace.begin(), trace.end(), new_symbol)), b.size());
        look(breed_carrying_headings(a, b, most_edited_symbols, &trace), "carry");
        look(insert_beside(a, U"T+", Side::after, {}, most_edited_symbols, &trace), "insert");
        look(append_to_branches(a, U"d", BranchEnd::begin, {}, most_edited_symbols, &trace), "append");
        look(turn_before(a, {}, U'T', constant_turn(-2), most_edited_symbols, &trace), "turn");
        look(shrink(a, {}, constant_shrink(0.5), most_edited_symbols, &trace), "shrink");
        look(remove_branches(a, {}, &trace), "branches");
        const std::uint32_t from = random.below(size + 1), to = from + random.below(size + 1 - from);
        look(remove_range(a, {from, to}, &trace), "range");
        const TokenBits bits = [&](std::uint32_t token, MutationDraw draw) {
            return random_bits(7, Key{token}, "x", static_cast<std::uint64_t>(draw));
        };
        const MutationRates rates = {.replace = 0.2, .remove = 0.2, .twice = 0.2, .swap = 0.5};
        look(mutate(a, rates, U"", bits, most_edited_symbols, &trace), "mutate");
        ReactOptions reacting;
        reacting.trace = &trace;
        const std::vector<Reaction> reactions = {{{U"a"}, {U"b"}, U"cc"}, {{U"a"}, {U"a"}, U"[a]"}};
        look(react(a, b, reactions, reacting), "react");
        const std::vector<ChunkPair> pairs = {{U"a", U"bb"}, {U"bb", U"c"}, {U"cb", U"T+"}};
        const Result<ChunkEdit> chunks = substitute(a, pairs, {.most_passes = 4, .trace = &trace});
        ASSERT_TRUE(chunks);
        expect_true_trace(a, chunks->word, trace, "chunks");
        const std::u32string dirty = U"=]" + a + U" [=" + b;
        expect_true_trace(dirty, clean_up(dirty, &trace).word, trace, "clean");
        PairTrace both;
        const Result<WordPair> crossed = crossover(a, {from, to}, b, {0, 0}, &both);
        if (!crossed) continue;
        expect_true_trace(a, crossed->a, both.a, "crossover");
        expect_true_trace(a, crossed->b, both.b, "crossover of the other");
    }
}

}  // namespace
}  // namespace filigree::rewriting
