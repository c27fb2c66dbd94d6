// What documents say of the choices of words, example by example.
#include <gtest/gtest.h>

#include "formats/svg_write.h"
#include "tests/random_edit.h"

namespace filigree {
namespace {

using State = std::shared_ptr<DocumentState>;

State grown_now(const std::string& text, const Replay* replay = nullptr) {
    SerialExecutor serial;
    RunOptions options;
    options.lists_choices = true;
    options.replay = replay;
    return grown("grammar rewriting\n" + text, options, serial);
}

std::string word_of(const std::string& text) {
    const State state = grown_now(text);
    EXPECT_TRUE(state) << text;
    if (!state) return "";
    const rewriting::Derivation& derivation = state->run.word->derivation;
    return rewriting::to_text(derivation.word, derivation.alphabet);
}

std::string paths_of(const std::string& text) {
    const State state = grown_now(text);
    EXPECT_TRUE(state) << text;
    std::string paths;
    if (!state) return paths;
    for (const NamedChoice& choice : named_choices(*state)) paths += (paths.empty() ? "" : " ") + choice.path;
    return paths;
}

std::string first_error(const std::string& text) {
    const OpenedDocument opened = open_text("a.fil", "grammar rewriting\n" + text, {});
    const CheckedDocument checked = check_document(opened);
    return checked.diagnostics.empty() ? "" : checked.diagnostics.front().code;
}

TEST(WordChoices, ArePathsFromTheAxiomDownwards) {
    EXPECT_EQ(paths_of("axiom \"ab+a\"\niterations 2\na -> \"+b\", \"b+\"\n+ -> \"-\", \"-\""),
              "a[1].rule u2B[1].rule a[2].rule a[1]/u2B[1].rule a[2]/u2B[1].rule");
    EXPECT_EQ(paths_of("axiom \"bab\"\niterations 2\nrandom position\nb -> \"b\", \"b\"\na -> \"ab\""),
              "iteration[1]/b[1].rule iteration[1]/b[2].rule iteration[2]/b[1].rule iteration[2]/b[2].rule "
              "iteration[2]/b[3].rule");
    EXPECT_EQ(paths_of("axiom \"AA\"\niterations 1\nsystem A { axiom \"c\"; iterations 1; c -> \"d\", \"d\" }"),
              "A[1]/system/c[1].rule A[2]/system/c[1].rule");
    EXPECT_EQ(paths_of("axiom \"rR\"\niterations 1\nr -> goto a@1\na -> \"b\", \"c\"\nR = random 1..3 \"ab\""),
              "r[1].target R[1].letters");
    EXPECT_EQ(paths_of("axiom \"aaa\"\niterations 1\neach iteration mutate(replace: 50%, by: \"b\")\nonce mutate()"),
              "mutate[1].scatter");
}

// A symbol that draws and stays draws again in the next iteration.
TEST(WordChoices, OfASymbolThatStaysAreCounted) {
    EXPECT_EQ(paths_of("axiom \"a\"\niterations 3\na -> goto b@9, goto b@8"), "a[1].rule a[1].rule~2 a[1].rule~3");
}

TEST(WordChoices, AreSetByTextByNumberOrToNone) {
    const std::string text = "axiom \"aaR\"\niterations 1\na -> \"b\", \"c d\", \"c d\"\nR = random 1..3 \"ab\"\n";
    EXPECT_EQ(word_of(text + "set a[1].rule = \"b\"\nset a[2].rule = \"cd\"\nset R.letters = \"xy\"\n"), "bcdxy");
    EXPECT_EQ(word_of(text + "set a.rule = 2\nset a[1].rule = \"cd#2\"\nset R.letters = \"\"\n"), "cdcd");
    EXPECT_EQ(word_of(text + "set **.rule = \"none\"\nset **.is_random = false\ndefault R.letters = \"bbb\"\n"),
              "aabbb");
    EXPECT_EQ(word_of(text + "set **.is_random = false\n"), "bbaa");
    EXPECT_EQ(word_of(text + "set **/a.rule = \"b\" when index > 0\nset a[1].rule = one_of(\"b\": 0, 2)\n"
                             "set R.letters = \"\"\n"),
              "cdb");
}

TEST(WordChoices, WhatIsWrongIsSaidBeforeAnythingIsDerived) {
    const std::string text = "axiom \"aR\"\niterations 1\na -> \"b\", \"c\"\nb -> \"x\"\nR = random 1..3 \"ab\"\n";
    EXPECT_EQ(first_error(text + "set a.rule = \"d\"\n"), "preset.unknown-rule");
    EXPECT_EQ(first_error(text + "set a.rule = 3\n"), "preset.unknown-rule");
    EXPECT_EQ(first_error(text + "set a.rule = #a03\n"), "preset.not-a-rule");
    EXPECT_EQ(first_error(text + "set R.letters = 3\n"), "preset.no-letters");
    EXPECT_EQ(first_error(text + "set b.rule = \"x\"\n"), "preset.impossible-path");
    EXPECT_EQ(first_error(text + "set a/a.rule = \"b\"\n"), "preset.impossible-path");
    EXPECT_EQ(first_error(text + "set a.rule~2 = \"b\"\n"), "preset.no-such-draw");
    EXPECT_EQ(first_error(text + "set a.rule = \"b\" when ag > 1\n"), "language.unknown-name");
    EXPECT_EQ(first_error(text + "apply place(disc) to a\n"), "document.not-for-words");
    EXPECT_EQ(first_error(text + "set a.rule = \"b\"\nkeep R\nreroll **/a\n"), "");
}

TEST(WordChoices, APresetThatMeetsNothingIsNamed) {
    const State state = grown_now("axiom \"aa\"\niterations 1\na -> \"b\", \"c\"\nset a[3].rule = \"b\"\nkeep a[2]\n");
    ASSERT_TRUE(state);
    ASSERT_EQ(state->run.unmatched.size(), 1U);
    EXPECT_EQ(state->run.unmatched[0].path, "a[3].rule");
}

// A word inside shapes of another document: its choices stand below the step, and are replayed with it.
TEST(WordChoices, OfAnEmbeddedWordStandBelowItsHost) {
    const std::string text =
        "grammar tangle\nseed 3\nstart cloth = rectangle(300px, 100px)\nregular_split(line, 100px, angle: 0) : cloth "
        "-> "
        "cell\nembed(twig) : cell\nsystem twig { grammar rewriting; axiom \"Xa\"; iterations 4; a -> \"a+a\", \"aa\" "
        "}\n";
    SerialExecutor serial;
    RunOptions options;
    options.lists_choices = true;
    const State state = grown(text, options, serial);
    ASSERT_TRUE(state);
    std::string listing;
    list_choices(state->opened, state->checked, state->run, [&](std::string_view piece) { listing += piece; });
    EXPECT_NE(listing.find("/a[1]/a[2]\", \"name\": \"rule\""), std::string::npos) << listing;
    const Result<Replay> replay = read_choices(listing);
    ASSERT_TRUE(replay);
    const auto svg_of = [](const DocumentState& of) { return to_svg(of.run.drawing, {}); };
    options.replay = &*replay;
    const State again = grown(with_seed(state->opened.document, 99), options, serial);
    ASSERT_TRUE(again);
    EXPECT_TRUE(svg_of(*again) == svg_of(*state));
    options.replay = nullptr;
    const State drawn = grown(text + "reroll cloth/regular_split/cell/embed\n", options, serial);
    ASSERT_TRUE(drawn);
    EXPECT_FALSE(svg_of(*drawn) == svg_of(*state));
    const State set = grown(text + "set **/a.rule = \"aa\"\n", options, serial);
    ASSERT_TRUE(set);
    EXPECT_TRUE(set->run.unmatched.empty());
    const State set_again = grown(with_seed(set->opened.document, 99), options, serial);
    ASSERT_TRUE(set_again);
    EXPECT_TRUE(svg_of(*set) == svg_of(*set_again));
}

}  // namespace
}  // namespace filigree
