#include "engines/rewriting/derive.h"

#include <gtest/gtest.h>

#include "base/test_cases.h"
#include "engines/rewriting/plain.h"
#include "engines/rewriting/read_grammar_test.h"

namespace filigree::rewriting {
namespace {

// The words of iterations 0 to n, between blanks; or the code of what went wrong.
std::string words(const std::string& text, int n, const Limits& limits = {}, const Inputs& inputs = {}) {
    const Read said = read(text, inputs);
    if (!said.problems.empty()) return said.problems.front().code;
    DeriveOptions options = options_of(said);
    options.limits = limits;
    Result<Derivation> derivation = begin(said.grammar, options);
    if (!derivation) return derivation.diagnostics().front().code;
    std::string all = to_text(derivation->word, derivation->alphabet);
    for (int i = 0; i < n; ++i) {
        if (const auto problem = step(*derivation, said.grammar, options, {})) return all + " " + problem->code;
        all += " " + to_text(derivation->word, derivation->alphabet);
    }
    return all;
}

TEST(Derive, TheWorkedExamples) {
    EXPECT_EQ(words("axiom \"aa===\"\na -> \"ab\"", 4), "aa=== aba== abba= abbba abbbbab");
    EXPECT_EQ(words("axiom \"a\"\na -> \"{3b+c}bbb\"", 1), "a b+cb+cb+cbbb");
    EXPECT_EQ(words("axiom \"D+a+a+a\"\na@1 -> \"a[P<n]\"\nn@2 -> \"a[T<\u00F1]\"\n~n@3 -> \"a\"", 3),
              "D+a+a+a D+a[P<n]+a[P<n]+a[P<n] "
              "D+a[P<a[T<\u00F1]]+a[P<a[T<\u00F1]a[T<\u00F1]]+a[P<a[T<\u00F1]a[T<\u00F1]a[T<\u00F1]] "
              "D+a[P<a[T<a]]+a[P<a[T<aa]a[T<aa]]+a[P<a[T<aaa]a[T<aaa]a[T<aaa]]");
}

TEST(Derive, RepeatsByNumbersNamesAndExpressions) {
    EXPECT_EQ(words("axiom \"{2{2a}b}{0c}{-1d}{}{e}\"", 0), "aabaabe");
    EXPECT_EQ(words("param k = 3\naxiom \"a\"\na -> \"{$k b}{(t + 1) c}\"", 1), "a bbbcc");
    EXPECT_EQ(words("axiom \"{3a\"", 0), "rewriting.unmatched-brace");
    EXPECT_EQ(words("free \"{}\"\naxiom \"{3a\"", 0), "{3a");
}

TEST(Derive, ContextsAreSeenAcrossBranches) {
    EXPECT_EQ(words("axiom \"b[c]a\"\nb < a -> \"x\"", 1), "b[c]a b[c]x");
    EXPECT_EQ(words("axiom \"b+a\"\nignore \"+\"\nb < a -> \"x\"", 1), "b+a b+x");
    EXPECT_EQ(words("axiom \"b[a]\"\nb < a -> \"x\"", 1), "b[a] b[x]");
    EXPECT_EQ(words("axiom \"a[c]b\"\na > b -> \"x\"", 1), "a[c]b x[c]b");
    EXPECT_EQ(words("axiom \"[a]b\"\na > b -> \"x\"", 1), "[a]b [a]b") << "a branch is never left to the right";
    EXPECT_EQ(words("axiom \"a[cd]e\"\na > [c] -> \"x\"", 1), "a[cd]e x[cd]e");
    EXPECT_EQ(words("axiom \"a=b\"\na > b -> \"x\"\nb -> \"c\"", 2), "a=b ac ac");
    EXPECT_EQ(words("axiom \"a]b\"\na > b -> \"x\"", 1), "a]b a]b");
}

TEST(Derive, ConditionsAndRegisters) {
    EXPECT_EQ(words("axiom \"aaa\"\na -> \"b\" when index == 1", 1), "aaa aba");
    EXPECT_EQ(words("axiom \"a[a[a]]\"\na -> \"b\" when depth >= 1", 1), "a[a[a]] a[b[b]]");
    // All read what the registers were before; behind the iteration the last assignment holds.
    EXPECT_EQ(words("register k 1\naxiom \"aa\"\na -> \"{$k a}\" { k = k + 1 }", 2), "aa aa aaaa");
    EXPECT_EQ(words("axiom \"a\"\na -> \"b\" { k = 1 }", 1), "rewriting.unknown-register");
    EXPECT_EQ(words("axiom \"a\"\narray M [2]\nM[1] -> \"x\"\na -> M[t - 1]", 2), "a  ");
    EXPECT_EQ(words("axiom \"a\"\narray M [2]\na -> M[t + 1]", 1), "a rewriting.index-out-of-range");
    EXPECT_EQ(words("axiom \"a\"\na -> M[1]", 1), "rewriting.unknown-array");
}

TEST(Derive, RulesAskForAttributes) {
    EXPECT_EQ(words("axiom \"ab\"\na -> \"c\" when age > 2", 3), "ab ab ab cb");
    EXPECT_EQ(words("ages lineage\naxiom \"a\"\na -> \"xa\" when age < 3\na -> \"y\"", 4), "a xa xxa xxy xxy");
    // Objects on the way from the root: axis letters, signs and branches beside the way do not count.
    EXPECT_EQ(words("axiom \"bP+[bb[b]a]a[ba]ba\"\na -> \"{(distance) x}y\"", 1),
              "bP+[bb[b]a]a[ba]ba bP+[bb[b]xxxy]xy[bxxxy]bxxxy");
    // Of the branch around the symbol, with the branches in it; brackets belong to what is around them.
    EXPECT_EQ(words("axiom \"a[abc[aP]a]\"\na -> \"{(density) x}\"\n\"]\" -> \"{(density) y}\"", 1),
              "a[abc[aP]a] xxxxxx[xxxxxbc[xPyyyyyxxxxxyyyyyy");
    EXPECT_EQ(
        words("axiom \"aabb[aaaa]\"\na -> \"x\" when homogeneity == 1\nb -> \"y\" when homogeneity == 40 / 64", 1),
        "aabb[aaaa] aayy[xxxx]");
    EXPECT_EQ(words("axiom \"ab[a\"\na -> \"{(count) x}\"", 1), "ab[a xxb[xx");
    EXPECT_EQ(words("axiom \"a\"\na -> \"aa\" * count, \"b\" * (2 - count)\na -> \"c\"", 1).size(), 4U);
    EXPECT_EQ(words("register k\naxiom \"a[a]\"\na -> \"{$k b}a\" { k = k + depth + count }", 2),
              "a[a] a[a] bbba[bbba]");
    // What is the same for all symbols of a letter can be asked where its rows are chosen.
    EXPECT_EQ(words("axiom \"aa\"\na -> \"ab\" loop count\na -> \"c\" loop 1", 3), "aa abab abbabb cbbcbb");
    EXPECT_EQ(words("axiom \"a\"\na -> \"ab\" loop 1\na -> \"ac\" loop t\na -> \"d\" loop 1", 4), "a ab acb accb dccb");
}

TEST(Derive, FreezesAreCounted) {
    EXPECT_EQ(words("register k 2\naxiom \"a{3}=\"\na -> \"ab{$k} = c{(k - 2)}=\"", 4), "a=== a== a= a ab==c");
    EXPECT_EQ(words("axiom \"{2 a{2}=}{3}b\"", 0), "a==a==b") << "braces without anything to repeat";
    EXPECT_EQ(words("axiom \"{2}=a\"", 0), "a") << "behind nothing";
}

TEST(Derive, SymbolsSleepUntilAConditionHolds) {
    EXPECT_EQ(words("axiom \"ab\"\nsleep a until t > 2\na -> \"aa\"\nb -> \"bb\"", 3), "ab abb abbbb aabbbbbbbb");
    // Also those that no rule rewrites; a sleeping member ends a run and holds it.
    EXPECT_EQ(words("axiom \"qqbq\"\nsleep q until index > 2", 2), "qqbq qqbqq qqbqqq");
    EXPECT_EQ(words("axiom \"aqq\"\nsleep q until index > 1", 1), "aqq aqqq") << "the first alone sleeps";
    EXPECT_EQ(words("axiom \"qqi\"\nsleep i until t == 2", 2), "qqi qqqi qqi");
    EXPECT_EQ(words("axiom \"as\"\nsleep s until t == 2", 2), "as as aas");
    EXPECT_EQ(words("axiom \"R=a\"\nR = random 1 \"x\"\nsleep R until t == 3", 3), "R=a R=a R=a xa");
    // '=' counts down as always.
    EXPECT_EQ(words("axiom \"a==\"\nsleep a until t == 2\na -> \"b\"", 4), "a== a= a a a");
    EXPECT_EQ(words("axiom \"nn\"\nn -> \"a\"\nsleep n until index > 0", 1), "nn naa") << "it is counted all the same";
}

TEST(Derive, MasksKeepSymbols) {
    EXPECT_EQ(words("axiom \"ab\"\na -> \"aa\"\nb -> \"bb\"\nmask a@2", 3), "ab aabb aabbbb aaaabbbbbbbb");
    EXPECT_EQ(words("axiom \"a[a[ab]]\"\na -> \"c\"\nb -> \"c\"\nmask \"ab\" when depth > 1", 1), "a[a[ab]] c[c[ab]]");
    EXPECT_EQ(words("axiom \"ab\"\na -> \"x\"\nb -> \"y\"\nmask a@1, b@2..3 when true\nmask b@1", 4), "ab ab xb xb xy");
    // Rows go on under a mask.
    EXPECT_EQ(words("axiom \"a\"\na -> \"ab\" loop 1\na -> \"ac\" loop 1\nmask a@1", 2), "a a ac");
    EXPECT_EQ(words("axiom \"B\"\nsystem B { axiom \"a\"; a -> \"aa\"; mask a@1; mode grow; iterations 2 }", 3),
              "B a a aa");
    EXPECT_EQ(words("axiom \"a\"\nmask a when agee > 1", 0), "language.unknown-name");
    EXPECT_EQ(words("axiom \"a\"\nmask \"=\"", 0), "rewriting.bad-letter");
    EXPECT_EQ(words("axiom \"a\"\nsleep a until \"b\"", 0), "language.wrong-kind");
}

TEST(Derive, ArraysLeadIndexesBackInside) {
    const std::string cells = "M[0] -> \"x\"\nM[1] -> \"y\"\nM[2] -> \"z\"\na -> M[index - 2]\naxiom \"aaaaaaa\"\n";
    EXPECT_EQ(words("array M [3] wrap\n" + cells, 1), "aaaaaaa yzxyzxy");
    EXPECT_EQ(words("array M [3] clamp\n" + cells, 1), "aaaaaaa xxxyzzz");
    EXPECT_EQ(words("array M [3] error\n" + cells, 1), "aaaaaaa rewriting.index-out-of-range");
    EXPECT_EQ(words("array M [3] wrap\naxiom \"a\"\na -> M[t / 2]", 1), "a rewriting.index-out-of-range");
    EXPECT_EQ(words("array M [3] clamp\naxiom \"a\"\na -> M[t + 7.5]", 1), "a rewriting.index-out-of-range");
    EXPECT_EQ(words("array M [3] round\naxiom \"a\"", 0), "rewriting.bad-word");
    EXPECT_EQ(words("array M\naxiom \"a\"", 0), "rewriting.bad-setting");
    EXPECT_EQ(words("array M wrap\naxiom \"a\"\na -> M[0]", 0), "rewriting.bad-setting");
}

TEST(Derive, ArraysComeFromTables) {
    const Inputs inputs = {{"rules.csv", "ab,\"P+C\"\n\"{2 b}\",\n"},
                           {"one.csv", "x\ny\n"},
                           {"ragged.csv", "a,b\nc\n"},
                           {"wrong.csv", "a\n{2\n"},
                           {"unknown.csv", "{(agee) a}\n"}};
    const auto from = [&](const std::string& file, const std::string& rules) {
        return words("axiom \"a\"\narray M from \"" + file + "\"" + rules, 1, {}, inputs);
    };
    EXPECT_EQ(from("rules.csv", "\na -> M[0][1]"), "a P+C");
    EXPECT_EQ(from("rules.csv", "\na -> M[1][0]"), "a bb");
    EXPECT_EQ(from("rules.csv", " wrap\na -> M[-1][-1]"), "a ");
    EXPECT_EQ(from("rules.csv", "\nM[1][1] -> \"c\"\na -> M[1][1]"), "a c");
    EXPECT_EQ(from("rules.csv", "\na -> M[1]"), "rewriting.unknown-array");
    EXPECT_EQ(from("one.csv", " clamp\na -> M[7]"), "a y") << "one column is a sequence";
    EXPECT_EQ(from("ragged.csv", "\na -> M[0]"), "csv.ragged");
    EXPECT_EQ(from("wrong.csv", ""), "rewriting.unmatched-brace");
    EXPECT_EQ(from("unknown.csv", ""), "language.unknown-name");
    EXPECT_EQ(from("none.csv", "\na -> M[0]"), "input.missing");
    const Read said = read("axiom \"a\"\narray M from \"ragged.csv\"\na -> M[0]", inputs);
    ASSERT_EQ(said.problems.size(), 1U) << "what follows from it is not said";
    EXPECT_EQ(said.problems[0].message, "in 'ragged.csv', line 2 has 1 cell, where the first has 2 cells");
}

TEST(Derive, ExpressionsAreCheckedBeforehand) {
    const std::string head = "axiom \"a\"\nregister k 0\n";
    EXPECT_EQ(words(head + "a -> \"b\" when agee > 2", 0), "language.unknown-name");
    EXPECT_EQ(words(head + "a -> \"b\" when \"c\"", 0), "language.wrong-kind");
    EXPECT_EQ(words(head + "a -> \"b\" * agee, \"c\"", 0), "language.unknown-name");
    EXPECT_EQ(words(head + "a -> \"{(agee) b}\"", 0), "language.unknown-name");
    EXPECT_EQ(words(head + "a -> \"b\" loop age", 0), "language.unknown-name") << "a row serves all of its letter";
    EXPECT_EQ(words(head + "a -> \"b\" { k = true }", 0), "language.wrong-kind");
    EXPECT_EQ(words(head + "array M [2]\na -> M[x]", 0), "language.unknown-name");
    EXPECT_EQ(words(head + "array M [2]\nM[0] -> \"{$x a}\"", 0), "language.unknown-name");
    EXPECT_EQ(words("axiom \"{(age) a}\"", 0), "language.unknown-name");
    EXPECT_EQ(words("axiom \"a\"\nregister age 1", 0), "rewriting.reserved-name");
    EXPECT_EQ(words(head + "a -> \"b\" when 1 / k > 2", 0), "a") << "which is wrong only with some values";
}

TEST(Derive, RowsServeTheirIterations) {
    const std::string rows = "axiom \"a\"\na -> \"ab\" loop 2\na -> \"ac\" loop 1\n";
    EXPECT_EQ(words(rows, 5), "a ab abb acbb acbb acbb");
    EXPECT_EQ(words(rows + "after hold", 5), "a ab abb acbb accbb acccbb");
    EXPECT_EQ(words(rows + "after cycle", 5), "a ab abb acbb abcbb abbcbb");
    EXPECT_EQ(words("axiom \"a\"\na -> \"b\" loop 0", 2), "a a a");
    EXPECT_EQ(words("axiom \"a\"\na -> \"b\" loop 0\nafter cycle", 2), "a a a");
    // Of whole rows: of a letter, of the second rules of several; a parameter, a register that rules change.
    EXPECT_EQ(words("axiom \"a\"\nloop a 2\na -> \"ab\"\na -> \"ac\" loop 1", 4), "a ab abb acbb acbb");
    EXPECT_EQ(words("param n = 2 in 1..9\naxiom \"ab\"\nloop \"ab\"@2 n\na -> \"ac\"\na -> \"ad\"\na -> \"ae\"\n"
                    "b -> \"b\"\nb -> \"bf\"",
                    4),
              "ab acb adcbf addcbff aeddcbff");
    EXPECT_EQ(words("axiom \"a\"\nafter cycle\nregister k 1\nloop a@1 k\na -> \"ba\"\na -> \"+a\" { k = k + 1 }", 5),
              "a ba b+a b+ba b+bba b+bb+a");
    EXPECT_EQ(
        words("axiom \"A\"\na -> \"aa\"\nsystem A { mode grow; axiom \"a\"; iterations 9; loop a 2; a -> \"ab\" }", 4),
        "A a ab abb abb")
        << "of this system's letter";
    EXPECT_EQ(words("axiom \"a\"\nloop b 2\na -> \"b\"", 1), "rewriting.no-such-row");
    EXPECT_EQ(words("axiom \"a\"\nloop a@2 2\na -> \"b\"", 1), "rewriting.no-such-row");
    EXPECT_EQ(words("axiom \"a\"\nloop a age\na -> \"b\"", 1), "language.unknown-name");
}

TEST(Derive, SubsystemsAtOnceAndGrowing) {
    const std::string inner = "axiom \"aAb\"\na -> \"aa\"\nsystem A { axiom \"c\"; c -> \"cd\"; iterations 3";
    EXPECT_EQ(words(inner + " }", 2), "aAb aacdddb aaaacdddb");
    EXPECT_EQ(words(inner + "; mode grow }", 5),
              "aAb aacb aaaacdb aaaaaaaacddb aaaaaaaaaaaaaaaacdddb aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaacdddb");
    // A system that waits takes up nothing.
    const std::string waits = "system B { axiom \"abcd\"; mode grow }\naxiom \"B\"\nsleep B until t > 150";
    EXPECT_EQ(words(waits, 151).substr(2 * 150), "B abcd");
    EXPECT_EQ(words("axiom \"A\"\nsystem A { axiom \"A\"; system A { axiom \"a\" } }", 1), "rewriting.doubled-name");
}

TEST(Derive, WhatIsTooLargeEndsBeforeItIsMade) {
    Limits limits;
    limits.elements = 1000;
    EXPECT_EQ(words("axiom \"ss\"", 3, limits),
              "ss ssss ssssssssssssssss ssssssssssssssssssssssssssssssssssssssssssssssss"
              "ssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssss"
              "ssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssss"
              "ssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssssss");
    EXPECT_EQ(words("axiom \"ssssssss\"", 3, limits).substr(9 + 65), "limit.elements") << "8, 64, then 4096";
    EXPECT_EQ(words("axiom \"{5000a}\"", 0, limits), "limit.elements");
    EXPECT_EQ(words("axiom \"{99999999{99999999a}}\"", 0), "limit.elements");
    EXPECT_EQ(words("axiom \"a\"\na -> \"{1000000000 a}\"", 1, limits), "limit.elements") << "when it is read";
    EXPECT_EQ(words("register k 1000000000\naxiom \"a\"\na -> \"{$k a}\"", 1, limits), "a limit.elements");
}

TEST(Derive, DrawsHangOnLineage) {
    const std::string text = "seed 5\naxiom \"aa\"\na -> \"ab\", \"ac\", \"aa\"\n";
    const std::string once = words(text, 6);
    EXPECT_EQ(once, words(text, 6));
    EXPECT_NE(once, words("seed 6\naxiom \"aa\"\na -> \"ab\", \"ac\", \"aa\"\n", 6));
    // What grows at the left does not matter to the right.
    const auto tail = [](const std::string& all) { return all.substr(all.rfind('x')); };
    const std::string left = "seed 5\naxiom \"yxa\"\na -> \"ab\", \"ac\", \"aa\"\ny -> ";
    EXPECT_EQ(tail(words(left + "\"y\"", 6)), tail(words(left + "\"yyy\"", 6)));
    EXPECT_EQ(words("axiom \"a\"\na -> \"b\" * 0, \"c\" * 0", 1), "a a") << "nothing can be drawn";
}

// Where a grammar is a substitution, that makes the words that steps make.
TEST(Derive, PlainGrammarsAreSubstitutions) {
    SerialExecutor executor;
    std::uint64_t compared = 0;
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(); ++seed) {
        CaseRandom random(seed);
        std::string text = "axiom \"ab{2c}\"\n";
        for (const char letter : std::string("abcF[]+")) {
            if (random.below(3) == 0) continue;
            text += "\"" + std::string(1, letter) + "\" -> \"";
            for (int i = random.whole(0, 4); i > 0; --i) text += "abcdF[]+-"[random.index(9)];
            text += "\"\n";
        }
        const Read said = read(text);
        ASSERT_TRUE(said.problems.empty()) << text;
        DeriveOptions options;
        options.limits.elements = 20000;
        Result<Derivation> stepped = begin(said.grammar, options), at_once = begin(said.grammar, options);
        ASSERT_TRUE(stepped && at_once);
        const auto plain = plain_substitution(*at_once, said.grammar);
        ASSERT_TRUE(plain) << text;
        std::optional<Diagnostic> problem;
        const auto steps = random.below(7);
        for (std::uint32_t i = 0; i < steps && !problem; ++i) problem = step(*stepped, said.grammar, options, {});
        const auto other = step_plainly(*at_once, *plain, steps, options.limits, executor);
        ASSERT_EQ(problem.has_value(), other.has_value()) << text;
        if (problem) {
            EXPECT_EQ(problem->code, other->code);
            continue;
        }
        ++compared;
        ASSERT_EQ(to_text(stepped->word, stepped->alphabet), to_text(at_once->word, at_once->alphabet)) << text;
        ASSERT_EQ(stepped->iteration, at_once->iteration);
    }
    EXPECT_GT(compared, case_count() / 2);
    for (const char* other :
         {"axiom \"a=\"", "axiom \"q\"", "axiom \"a\"\na@2 -> \"b\"", "axiom \"a\"\na -> \"s\"",
          "axiom \"a\"\nmask a@2", "axiom \"a\"\na -> \"b\", \"c\"", "axiom \"a\"\na < a -> \"b\""}) {
        const Read said = read(other);
        Result<Derivation> derivation = begin(said.grammar, {});
        ASSERT_TRUE(derivation);
        EXPECT_FALSE(plain_substitution(*derivation, said.grammar)) << other;
    }
}

TEST(Derive, RulesOfLaterIterationsMayChangeOnTheWay) {
    const std::string head = "axiom \"ab\"\nregister k 2\na -> \"ab\" { k = k + 1 }\n";
    const Read before = read(head + "b@3 -> \"c\"");
    // Of what it did not count before, such as lineages and ages, it knows from here on.
    const Read after = read(head + "register m 4\nb@3 -> \"{(k + m) d}\"\nd@4 -> \"e\", \"f\" when age < 3");
    ASSERT_TRUE(before.problems.empty() && after.problems.empty());
    Result<Derivation> derivation = begin(before.grammar, {});
    ASSERT_TRUE(derivation);
    for (int i = 0; i < 2; ++i) ASSERT_FALSE(step(*derivation, before.grammar, {}, {}));
    EXPECT_EQ(to_text(derivation->word, derivation->alphabet), "abbb");
    go_on_with(*derivation, after.grammar, {});
    ASSERT_FALSE(step(*derivation, after.grammar, {}, {}));
    EXPECT_EQ(to_text(derivation->word, derivation->alphabet), "ab" + std::string(3 * 8, 'd'));
    ASSERT_FALSE(step(*derivation, after.grammar, {}, {}));
    const std::string drawn = to_text(derivation->word, derivation->alphabet);
    EXPECT_EQ(drawn.find('d'), std::string::npos) << drawn;
    EXPECT_NE(drawn.find('e'), std::string::npos) << drawn;
    EXPECT_NE(drawn.find('f'), std::string::npos) << drawn;
    // What changes behind an iteration changes nothing before it.
    Result<Derivation> anew = begin(after.grammar, {});
    ASSERT_TRUE(anew);
    for (int i = 0; i < 3; ++i) ASSERT_FALSE(step(*anew, after.grammar, {}, {}));
    EXPECT_EQ(to_text(anew->word, anew->alphabet), "ab" + std::string(3 * 8, 'd'));
}

TEST(Derive, WhatIsDecidedIsCountedAlongTheWay) {
    // Each of a million symbols would put a hundred thousand.
    const Read said = read("axiom \"{1000000 a}\"\nregister r 50000\na -> \"{$r ab}\"");
    ASSERT_TRUE(said.problems.empty());
    DeriveOptions options;
    options.limits.elements = 2'000'000;
    Result<Derivation> derivation = begin(said.grammar, options);
    ASSERT_TRUE(derivation);
    const std::optional<Diagnostic> problem = step(*derivation, said.grammar, options, {});
    ASSERT_TRUE(problem);
    EXPECT_EQ(problem->code, "limit.elements");
    EXPECT_EQ(derivation->word.size(), 1'000'000U);
}

TEST(Derive, NegativeNumbersAreWrong) {
    const auto wrong = [](const std::string& rules) {
        const Read said = read("register k 1\nparam low = -2\naxiom \"ab\"\n" + rules);
        if (said.problems.empty()) return std::string("nothing");
        const SourceSpan span = said.problems[0].span;
        return said.problems[0].code + " " + said.document.text().substr(span.begin, span.end - span.begin);
    };
    EXPECT_EQ(wrong("a -> \"b\" * -1"), "rewriting.negative-number -1");
    EXPECT_EQ(wrong("a -> \"b\", \"c\" * (low + 1)"), "rewriting.negative-number (low + 1)");
    EXPECT_EQ(wrong("a -> \"b\" loop -3"), "rewriting.negative-number -3");
    EXPECT_EQ(wrong("a -> \"b\" * 0 loop -0.4"), "nothing") << "a loop is rounded";
    EXPECT_EQ(wrong("a -> \"b\" * (1 - k) loop 2 - t"), "nothing") << "that hangs on the iteration";
    EXPECT_EQ(words("axiom \"a\"\na -> \"ab\" * (1 - t), \"a\"", 2), "a a rewriting.negative-number");
    EXPECT_EQ(words("axiom \"a\"\na -> \"ab\" loop 1 - 2 * t", 1), "a rewriting.negative-number");
    const Read said = read("axiom \"a\"\na -> \"ab\" * (2 - 3 * t), \"a\"");
    Result<Derivation> derivation = begin(said.grammar, options_of(said));
    ASSERT_TRUE(derivation);
    const std::optional<Diagnostic> problem = step(*derivation, said.grammar, options_of(said), {});
    ASSERT_TRUE(problem);
    EXPECT_EQ(problem->message, "expected 0 or more as a weight, but this is -1");
    EXPECT_EQ(said.document.text().substr(problem->span.begin, 11), "(2 - 3 * t)");
}

TEST(Derive, RegistersMayBeginBelowZero) {
    for (const char* said : {"register k -2", "register k, -2", "register k - 2"}) {
        EXPECT_EQ(words("axiom \"a\"\na -> \"{$k b}a\" { k = k + 3 }\n" + std::string(said), 2), "a a ba") << said;
    }
}

TEST(Derive, WrongGrammars) {
    EXPECT_EQ(words("a -> \"b\"", 0), "rewriting.missing-axiom");
    EXPECT_EQ(words("axiom \"a\"\naxiom \"b\"", 0), "rewriting.repeated-setting");
    EXPECT_EQ(words("axiom \"a\"\nq -> \"b\"", 0), "rewriting.special-letter");
    EXPECT_EQ(words("axiom \"a\"\nfree q\nq -> \"b\"", 0), "a");
    EXPECT_EQ(words("axiom 5", 0), "rewriting.bad-setting");
    EXPECT_EQ(words("axiom \"a\"\ndialect abop", 0), "rewriting.bad-word");
    EXPECT_EQ(words("axiom \"a\"\niterations -1", 0), "rewriting.out-of-range");
    EXPECT_EQ(words("axiom \"a\"\nR = random 3..1 \"ab\"", 0), "rewriting.bad-macro");
    EXPECT_EQ(words("axiom \"a\"\nR = random 3 \"\"", 0), "rewriting.bad-macro");
    EXPECT_EQ(words("axiom \"a\"\n\"b[\" < a -> \"c\"", 0), "rewriting.unmatched-bracket");
    EXPECT_EQ(words("axiom \"a\"\narray M [2] [3]\nM[2][0] -> \"a\"", 0), "rewriting.out-of-range");
    EXPECT_EQ(words("axiom \"a\"\n\" \" -> \"c\"", 0), "rewriting.bad-letter");
    std::string many = "axiom \"a\"\n";
    for (int i = 0; i < 300; ++i)
        many += "a -> \"" + to_utf8(std::u32string(1, static_cast<char32_t>(0x4E00 + i))) + "\"\n";
    EXPECT_EQ(words(many + "a -> \"b\"", 1).substr(0, 1), "a");
    std::u32string all;
    for (int i = 0; i < 300; ++i) all += static_cast<char32_t>(0x4E00 + i);
    EXPECT_EQ(words("axiom \"" + to_utf8(all) + "\"", 0), "rewriting.too-many-symbols");
}

}  // namespace
}  // namespace filigree::rewriting
