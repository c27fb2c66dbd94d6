// The engine against a reference that is written for nothing but being right, over grammars at random.
#include "engines/rewriting/reference_test.h"

#include <gtest/gtest.h>

#include <array>

#include "engines/rewriting/random_grammar_test.h"
#include "engines/rewriting/read_grammar_test.h"

namespace filigree::rewriting {
namespace {

// A column of all units.
template <class Value>
std::vector<Value> column(const reference::Units& word, Value reference::Unit::*member) {
    std::vector<Value> values;
    for (const reference::Unit& unit : word) values.push_back(unit.*member);
    return values;
}

// What differs, or nothing. A column that the engine may do without says nothing.
std::string difference(const Derivation& engine, const reference::State& wanted, bool with_ages) {
    const auto problem = [&](std::string_view what) {
        return std::string(what) + " in iteration " + std::to_string(wanted.iteration) + ":\n  engine    " +
               to_text(engine.word, engine.alphabet) + "\n  reference " + to_utf8(reference::text_of(wanted.word));
    };
    const auto listed = [](const auto& values) {
        std::string text;
        for (const auto value : values) text += " " + std::to_string(value);
        return text;
    };
    if (to_text(engine.word, engine.alphabet) != to_utf8(reference::text_of(wanted.word))) return problem("text");
    std::vector<Gait> gaits;
    for (const Symbol symbol : engine.word.symbols) {
        if (symbol != Alphabet::freeze) gaits.push_back(engine.alphabet.gaits()[engine.alphabet[symbol].gait]);
    }
    if (gaits != column(wanted.word, &reference::Unit::gait)) return problem("gaits");
    const auto ages = column(wanted.word, &reference::Unit::age);
    if ((with_ages || !engine.word.ages.empty()) && engine.word.ages != ages) {
        return problem("ages") + "\n  engine    " + listed(engine.word.ages) + "\n  reference " + listed(ages);
    }
    std::vector<std::uint32_t> origins = column(wanted.word, &reference::Unit::origin);
    std::erase(origins, 0);
    if (engine.word.origins != origins) {
        return problem("origins") + "\n  engine    " + listed(engine.word.origins) + "\n  reference " + listed(origins);
    }
    if (!engine.word.keys.empty() && engine.word.keys != column(wanted.word, &reference::Unit::key)) {
        return problem("keys");
    }
    for (std::size_t k = 0; k < wanted.registers.size(); ++k) {
        if (engine.registers[k].value != wanted.registers[k].value)
            return problem("register " + engine.registers[k].name);
    }
    return "";
}

struct Comparison {
    std::string difference;      // empty: none
    std::uint32_t compared = 0;  // iterations
};

Comparison compare(const Grammar& grammar, std::uint64_t seed, std::uint32_t iterations, bool with_ages = true) {
    DeriveOptions options;
    options.seed = seed;
    options.root = Key{mix(seed)};
    options.with_ages = with_ages;
    reference::State wanted;
    if (reference::begin(wanted, grammar, options.seed, options.root) != reference::Outcome::fine) return {};
    Result<Derivation> engine = begin(grammar, options);
    if (!engine) return {"begin: " + engine.diagnostics().front().message};
    Comparison comparison{difference(*engine, wanted, with_ages)};
    while (comparison.difference.empty() && comparison.compared < iterations) {
        const reference::Outcome outcome = reference::step(wanted, grammar);
        if (outcome == reference::Outcome::too_large) break;
        const std::optional<Diagnostic> problem = step(*engine, grammar, options, {});
        if (problem.has_value() != (outcome == reference::Outcome::wrong)) {
            comparison.difference =
                problem ? "the engine alone has an error: " + problem->message
                        : "the engine has no error in iteration " + std::to_string(wanted.iteration + 1);
        }
        if (problem || outcome == reference::Outcome::wrong) break;
        comparison.difference = difference(*engine, wanted, with_ages);
        ++comparison.compared;
    }
    return comparison;
}

// Words that were worked out by hand, so that the two are not wrong alike.
TEST(Reference, WordsWorkedOutByHand) {
    const auto word = [](const std::string& text, int iterations) {
        const Grammar grammar = grammar_of(text);
        reference::State state;
        EXPECT_EQ(reference::begin(state, grammar, 1, Key{}), reference::Outcome::fine);
        for (; iterations > 0; --iterations) EXPECT_EQ(reference::step(state, grammar), reference::Outcome::fine);
        return to_utf8(reference::text_of(state.word));
    };
    EXPECT_EQ(word("axiom \"aa===\"\na -> \"ab\"", 4), "abbbbab");
    EXPECT_EQ(word("axiom \"aq==b\"\nb -> \"bq\"", 4), "aqqqbqqqqqqq");
    EXPECT_EQ(word("axiom \"ggggggiq=i\"\ngain g 4", 1), "ggiqi");
    EXPECT_EQ(word("axiom \"D+a+a\"\na@1 -> \"a[P<n]\"\nn@2 -> \"a[T<\u00F1]\"\n\u00F1@3 -> \"a\"", 3),
              "D+a[P<a[T<a]]+a[P<a[T<aa]a[T<aa]]");
    EXPECT_EQ(word("axiom \"as==\"\na -> \"ab\"", 4), "abbbbabbbabbbabbs");
    EXPECT_EQ(word("axiom \"ABC[DE][SG[HI[JK]L]MNO]\"\nB C < S > G[H]M -> \"X\"", 1), "ABC[DE][XG[HI[JK]L]MNO]");
    EXPECT_EQ(word("axiom \"ab\"\nafter cycle\na -> \"ab\" loop 2\na -> \"c\" loop 1\nb -> \"bb\" loop 1", 3),
              "cbbbbbbbbbbbbbb");
    EXPECT_EQ(word("axiom \"ab\"\nloop \"ab\" 2\na -> \"ac\"\na -> \"ad\" loop 1\nb -> \"be\"", 5), "adccbee");
    EXPECT_EQ(word("axiom \"aAb\"\na -> \"aa\"\nsystem A { axiom \"c\"; c -> \"cd\"; iterations 3 }", 2), "aaaacdddb");
}

// The smallest grammars of what the two did not agree about.
TEST(Reference, EngineAgreesOverWhatWasOnceDifferent) {
    struct Case {
        std::string text;
        std::uint32_t iterations = 4;
    };
    const std::vector<Case> cases = {
        // Of a system that is over, all is at rest: also a macro that is to recall.
        {"axiom \"B\"\nsystem B { axiom \"R=\"; mode grow; iterations 0; R = random 1 \"a\" }"},
        // The n of all systems are counted, whether or not they are rewritten.
        {"axiom \"nB\"\nsystem B { axiom \"n\"; mode grow; iterations 1; n -> \"a\" }"},
        {"axiom \"Bn\"\nn -> \"na\"\nsystem B { axiom \"n\"; mode grow; iterations 0 }", 3},
        // What an n puts may come from an array.
        {"axiom \"nn\"\narray N [1]\nN[0] -> \"\u00F1\"\nn@1 -> N[0]\n\u00F1 -> \"a\""},
        // t is that of the system, as it is behind '@'.
        {"axiom \"aB\"\na@1 -> \"B\"\nsystem B { axiom \"b\"; mode grow; iterations 3; b -> \"bb\" when t == 2 }"},
        // A letter stays the same letter in another system.
        {"axiom \"B[]\"\nsystem B { axiom \"[a]\"; mode grow; iterations 0 }"},
        // The word that s becomes holds an s.
        {"ages lineage\naxiom \"as\""},
        // A jump takes the rule, with all its alternatives,
        {"axiom \"rrrrrrrr\"\nb -> \"a\" * 0, \"c\", \"d\" * 2\nr -> goto b@1"},
        // and that of the iteration that it names.
        {"axiom \"rr=\"\nc -> \"x\" loop 1\nc -> \"y\" loop 2\nr@2 -> goto c@1\nr@1 -> goto c@3"},
        // Registers are known from the start.
        {"axiom \"a{$k+}\"\nregister k 2"},
        // Runs are runs, however their members are drawn, and grow as the last of them.
        {"axiom \"qqAi\"\nsystem A { axiom \"qq\"; angle 7 }"},
        {"axiom \"qAqBq\"\ngain q 2\nsystem A { axiom \"q\"; step 3 }\nsystem B { axiom \"qi\"; step 2 }"},
        // What grows for letters that are drawn in different ways is one system.
        {"axiom \"AB\"\nsystem A { axiom \"B\"; angle 7 }\nsystem B { axiom \"R=\"; mode grow; iterations 3; "
         "R = random 1..3 \"abR\" }"},
        // The last loop that names a row counts, and that of the rule before all others.
        {"axiom \"a\"\nafter cycle\nregister k 2\nloop a 5\nloop a@2..3 k\nloop a@2 t\na -> \"ab\" loop 1\n"
         "a -> \"ac\"\na -> \"ad\" { k = 1 }",
         9},
        // A symbol that might put a system, but stands nowhere any more.
        {"axiom \"B\"\nsystem B { axiom \"abc\"; mode grow; iterations 1 }", 120},
    };
    for (const Case& one : cases) {
        for (const DrawMode draws : {DrawMode::lineage, DrawMode::position}) {
            Grammar grammar = grammar_of(one.text);
            grammar.draws = draws;
            const Comparison comparison = compare(grammar, 1, one.iterations);
            EXPECT_EQ(comparison.difference, "") << one.text;
            EXPECT_EQ(comparison.compared, one.iterations) << one.text;
        }
    }
}

TEST(Reference, EngineAgreesOverGrammarsAtRandom) {
    const std::uint64_t cases = case_count(1000);
    std::uint64_t compared = 0;
    std::array<std::uint64_t, feature_count> met = {};  // iterations in which a feature was there
    for (std::uint64_t seed = first_seed(); seed < first_seed() + cases; ++seed) {
        CaseRandom random(seed);
        RandomGrammar maker(random);
        const Grammar grammar = maker.made();
        const Comparison comparison = compare(grammar, seed, 4 + random.below(3), random.coin());
        ASSERT_EQ(comparison.difference, "") << "case " << seed << "\n" << described(grammar);
        compared += comparison.compared;
        for (std::size_t k = 0; k < feature_count; ++k) {
            if (maker.has(static_cast<Feature>(k))) met[k] += comparison.compared;
        }
    }
    if (cases < 500) return;  // too few to meet everything
    EXPECT_GT(compared, 3 * cases);
    for (const std::uint64_t iterations : met) EXPECT_GT(iterations, cases / 3);
}

}  // namespace
}  // namespace filigree::rewriting
