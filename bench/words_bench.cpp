// How many symbols a second one iteration writes (items_per_second) of words that program their rewriting, in one
// thread and through everything that an iteration does.
//   freezes    many symbols sleep, and the word doubles
//   asleep     nearly all sleep: the word hardly grows
//   drawn      symbols in no order, some of which sleep
//   counters   many short runs that grow and shrink
//   long_runs  few long ones
//   ordinals   each n becomes as many copies as there are n before it
//   followers  the same, then the ñ that they put
//   contexts   each symbol looks at its neighbour
//   chances    each draws its successor, by its lineage
//   macros     many become random letters
// Each case first checks the hash of its word: a faster wrong answer fails.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "base/random.h"
#include "engines/rewriting/derive.h"
#include "engines/rewriting/read_grammar.h"
#include "language/parse.h"
#include "language/settings.h"

namespace filigree::rewriting {
namespace {

struct Case {
    const char* grammar;
    int iterations;
    std::uint64_t hash;
};

constexpr Case freezes{"axiom \"a\"\na -> \"ab=\"\nb -> \"ba==\"", 37, 3716878735127561103U};
constexpr Case asleep{"axiom \"a\"\na -> \"a===b======\"\nb -> \"ab=====\"", 99, 17033097510921193340U};
constexpr Case drawn{
    "random position\naxiom \"{24x}\"\nx@1..4 -> \"{18x}\"\n"
    "x@5 -> \"x\", \"a\", \"b=\", \"cb\", \"d\", \"xa==\"\nx@6 -> \"xa\"\na -> \"abc\"\nb -> \"ca\"\nc -> \"cb=\"",
    6, 3721732843511234794U};
constexpr Case counters{"axiom \"a\"\na -> \"aqb\"\nb -> \"aqqqib\"", 21, 6050926317001290433U};
constexpr Case long_runs{"axiom \"{1000aq}\"\ngain q 600", 20, 9102485902106267183U};
constexpr Case ordinals{"axiom \"{3500n}\"\nn -> \"ab\"", 1, 9656553232479718564U};
constexpr Case followers{"axiom \"{300n}\"\nn@1 -> \"a[~n]\"\n~n@2 -> \"bc\"", 2, 12323412405697983303U};
constexpr Case contexts{"axiom \"a\"\na -> \"ab\"\na < b -> \"ba\"\nb < b -> \"a\"", 24, 7524816352593116034U};

constexpr Case chances{"axiom \"{1000a}\"\na -> \"ab\", \"ba\" * 2, \"aca\"\nb -> \"a\", \"bc\"", 12, 6351837693442490234U};
constexpr Case macros{"axiom \"{50000a}\"\na -> \"aR\"\nR = random 1..4 \"abbc\"", 2, 10073345911684481255U};

constexpr std::uint64_t most_symbols = 1 << 26;

std::uint64_t hash_of(const Word& word) {
    return hash_text({reinterpret_cast<const char*>(word.symbols.data()), word.size()});
}

void words(benchmark::State& state, const Case& what) {
    const Parsed parsed = parse_document("a.fil", std::string("grammar rewriting\n") + what.grammar, {});
    const Result<Settings> settings = read_settings(parsed.document);
    if (!settings) return state.SkipWithError("the settings are wrong");
    const Result<Grammar> grammar = read_grammar(*settings, parsed.document);
    if (!grammar) return state.SkipWithError("the grammar is wrong");
    DeriveOptions options;
    options.document = &parsed.document;
    options.globals = &settings->globals;
    options.limits.elements = most_symbols;
    Result<Derivation> before = begin(*grammar, options);
    if (!before) return state.SkipWithError("the axiom is wrong");
    for (int t = 1; t < what.iterations; ++t) {
        if (step(*before, *grammar, options, {})) return state.SkipWithError("a step fails");
    }
    Derivation after;
    const auto last_step = [&] { return !step(after, *grammar, options, {}); };
    after = *before;
    if (!last_step()) return state.SkipWithError("a step fails");
    const std::uint64_t hash = hash_of(after.word);
    if (hash != what.hash) return state.SkipWithError(("the word's hash is " + std::to_string(hash)).c_str());
    for (auto _ : state) {
        state.PauseTiming();
        after = *before;
        state.ResumeTiming();
        if (!last_step()) return state.SkipWithError("a step fails");
    }
    if (hash_of(after.word) != hash) return state.SkipWithError("the word is another one");
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * after.word.size()));
    state.counters["symbols"] = static_cast<double>(after.word.size());
    state.counters["growth"] = static_cast<double>(after.word.size()) / static_cast<double>(before->word.size());
}

#define WORDS(name) BENCHMARK_CAPTURE(words, name, name)->Unit(benchmark::kMillisecond)
WORDS(freezes);
WORDS(asleep);
WORDS(drawn);
WORDS(counters);
WORDS(long_runs);
WORDS(ordinals);
WORDS(followers);
WORDS(contexts);
WORDS(chances);
WORDS(macros);
#undef WORDS

}  // namespace
}  // namespace filigree::rewriting

BENCHMARK_MAIN();
