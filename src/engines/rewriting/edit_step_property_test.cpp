// Edits amid derivations of grammars at random.
#include <gtest/gtest.h>

#include <set>

#include "engines/rewriting/edit_step.h"
#include "engines/rewriting/random_grammar_test.h"
#include "engines/rewriting/read_edit.h"
#include "engines/rewriting/word_cases.h"
#include "language/parse.h"

namespace filigree::rewriting {
namespace {

// Calls that any word may meet, of all kinds.
constexpr std::string_view calls[] = {
    "add(with_word: \"ab[n]s\")",
    "breed(with_word: \"Xa[b]\", carry)",
    "breed(with_word: \"qqi=c\")",
    "react(with_word: \"abcab\", \"aa\" -> \"b\", \"bc\" -> \"[c]\", chance: 0.7, unreacted: own)",
    "compress(\"ab\" -> \"c\", \"aa\" -> \"b\", passes: 2)",
    "compress(by_rules)",
    "substitute(\"a\" -> \"ba\", \"[\" -> \"[T+\")",
    "insert(\"=\", place: after, where: age > 1)",
    "insert(\"{2 b}\", \"ac\", where: index < 5)",
    "append(\"\u00F1\", to: begin, where: depth < 3)",
    "remove(where: density < 2)",
    "crossover(with_word: \"ab\", other_to: 1)",
    "mutate(replace: 0.1, remove: 0.1, twice: 0.1, swap: 0.1)",
    "clean()",
    "shrink(1 / (1 + depth), \"a\")",
    "twist(-1..1)",
    "bend(ordinal - 1, where: distance > 1)",
};

// Reads a call for a grammar; the parts of the document that it points into stay in `document`.
std::optional<WordEdit> read(std::string_view text, const Grammar& grammar, const Document& document,
                             const Scope& globals) {
    const Result<OperatorCall> call = parse_edit_call(text);
    EXPECT_TRUE(call) << text;
    if (!call) return std::nullopt;
    Result<WordEdit> edit = read_edit({call->operator_name, call->arguments, call->span}, grammar, document, globals);
    EXPECT_TRUE(edit) << text << " " << edit.diagnostics().front().message;
    if (!edit) return std::nullopt;
    return std::move(*edit);
}

bool is_sound(const Word& word, const Alphabet& alphabet) {
    const auto followers =
        static_cast<std::size_t>(std::count_if(word.symbols.begin(), word.symbols.end(),
                                               [&](Symbol symbol) { return alphabet[symbol].role == Role::follower; }));
    const auto others = static_cast<std::size_t>(std::count_if(
        word.symbols.begin(), word.symbols.end(), [](Symbol symbol) { return symbol != Alphabet::freeze; }));
    const auto fits = [&](const auto& column) { return column.empty() || column.size() == others; };
    const bool begins_well = word.symbols.empty() || word.symbols.front() != Alphabet::freeze;
    return begins_well && word.origins.size() == followers && fits(word.keys) && fits(word.ages);
}

struct Setting {
    Document document;
    Scope globals;
    DeriveOptions options;

    explicit Setting(std::uint64_t seed) {
        options.seed = seed;
        options.limits.elements = 20'000;
        options.document = &document;
        options.globals = &globals;
        options.with_ages = true;
    }
};

TEST(EditStepProperty, WordsStaySoundAmidDerivations) {
    int made = 0;
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(600); ++seed) {
        CaseRandom random(seed);
        RandomGrammar maker(random);
        Grammar grammar = maker.made();
        const Setting setting(seed);
        for (std::uint32_t k = 1 + random.below(3); k > 0; --k) {
            std::optional<WordEdit> edit =
                read(calls[random.index(std::size(calls))], grammar, setting.document, setting.globals);
            ASSERT_TRUE(edit);
            edit->is_once = random.below(4) == 0;
            edit->first = 1 + random.below(3);
            grammar.edits.push_back(std::move(*edit));
        }
        Result<Derivation> derivation = begin(grammar, setting.options);
        if (!derivation) continue;
        for (int t = 0; t < 4; ++t) {
            if (step(*derivation, grammar, setting.options, {})) break;
            const Derivation before = *derivation;
            const EditTime time = t == 3 ? EditTime::end : EditTime::iteration;
            const Diagnostics problems = apply_edits(*derivation, grammar, time, setting.options, {}, {});
            ASSERT_TRUE(is_sound(derivation->word, derivation->alphabet)) << "case " << seed << "\n"
                                                                          << described(grammar);
            ASSERT_EQ(derivation->registers.size(), before.registers.size());
            // The same once more gives the same.
            Derivation twin = before;
            ASSERT_EQ(apply_edits(twin, grammar, time, setting.options, {}, {}), problems);
            ASSERT_EQ(twin.word.symbols, derivation->word.symbols) << "case " << seed;
            ASSERT_EQ(twin.word.keys, derivation->word.keys);
            ASSERT_EQ(twin.word.ages, derivation->word.ages);
            ASSERT_EQ(twin.word.origins, derivation->word.origins);
            if (has_errors(problems)) break;
            ++made;
        }
    }
    EXPECT_GT(made, static_cast<int>(case_count(600)));
}

// No two symbols draw alike, however often a word is edited.
TEST(EditStepProperty, KeysStayApart) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(300); ++seed) {
        CaseRandom random(seed);
        Grammar grammar;
        grammar.systems[0].axiom.parts.push_back({random_word(random, 20), nullptr, {}});
        Rule rule;
        rule.letter = U'a';
        rule.successors.resize(2);
        for (Successor& successor : rule.successors) successor.pattern.parts.push_back({U"a", nullptr, {}});
        grammar.systems[0].rules.push_back(rule);
        const Setting setting(seed);
        Result<Derivation> derivation = begin(grammar, setting.options);
        ASSERT_TRUE(derivation);
        for (int k = 0; k < 3; ++k) {
            const std::string_view call = calls[random.index(std::size(calls))];
            const std::optional<WordEdit> edit = read(call, grammar, setting.document, setting.globals);
            ASSERT_TRUE(edit);
            const Result<EditReport> report = apply_edit(*derivation, *edit, grammar, setting.options, {}, {});
            if (!report) continue;
            grammar.edits.push_back(*edit);
            const std::vector<std::uint64_t>& keys = derivation->word.keys;
            ASSERT_EQ(std::set<std::uint64_t>(keys.begin(), keys.end()).size(), keys.size()) << call;
            ASSERT_EQ(report->after, derivation->word.size());
            ASSERT_LE(report->kept, report->before);
        }
    }
}

std::u32string letters(const Derivation& derivation) { return letters_of(derivation.word, derivation.alphabet); }

TEST(EditStepProperty, TheLawsOfTheLibraryHoldByName) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + case_count(300); ++seed) {
        CaseRandom random(seed);
        const std::u32string a = random_word(random, 25), b = random_word(random, 25);
        Grammar grammar;
        grammar.systems[0].axiom.parts.push_back({a, nullptr, {}});
        grammar.systems[0].frees_braces = true;
        const Setting setting(seed);
        const Result<Derivation> begun = begin(grammar, setting.options);
        ASSERT_TRUE(begun);
        const auto edited = [&](const std::string& call, Derivation derivation) {
            const std::optional<WordEdit> edit = read(call, grammar, setting.document, setting.globals);
            EXPECT_TRUE(edit && apply_edit(derivation, *edit, grammar, setting.options, {}, {})) << call;
            return derivation;
        };
        const std::u32string bred = letters(edited("breed(with_word: \"" + utf8(b) + "\")", *begun));
        ASSERT_EQ(edit_tokens(bred).size(), edit_tokens(a).size() + edit_tokens(b).size()) << utf8(bred);
        ASSERT_TRUE(is_balanced(bred));
        // '@' is in no word.
        const Derivation compressed = edited("compress(\"ab\" -> \"@\")", *begun);
        ASSERT_EQ(letters(edited("substitute(\"@\" -> \"ab\")", compressed)), letters(*begun));
        const Derivation cleaned = edited("clean()", *begun);
        ASSERT_EQ(cleaned.word.symbols, begun->word.symbols);
        ASSERT_EQ(cleaned.word.ages, begun->word.ages);
    }
}

}  // namespace
}  // namespace filigree::rewriting
