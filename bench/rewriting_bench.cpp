// How many symbols a second D0L rewriting writes (items_per_second), in one thread.
//   steps       the last step alone, into memory that was used before
//   power       all steps at once, into memory that was used before
//   cold_step   the last step, into memory that the system gives anew each time
//   cold_power  all steps at once, into new memory
// Each case first checks the hash of its word: a faster wrong answer fails.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "base/random.h"
#include "engines/rewriting/substitution.h"

namespace filigree::rewriting {
namespace {

struct System {
    Substitution substitution;
    std::uint8_t axiom = 0;
    std::uint64_t steps = 0;
    std::uint64_t hash = 0;
};

void set(Substitution& substitution, char symbol, std::string_view image) {
    substitution.images[static_cast<std::uint8_t>(symbol)].assign(image.begin(), image.end());
}

System koch() {
    System system{{}, 'F', 9, 2663189713968081896U};
    set(system.substitution, 'F', "F-F+F+FF-F-F+F");
    return system;
}
System hilbert() {
    System system{{}, 'L', 13, 7372286850224993050U};
    set(system.substitution, 'L', "+RF-LFL-FR+");
    set(system.substitution, 'R', "-LF+RFR+FL-");
    return system;
}
System plant() {
    System system{{}, 'X', 13, 9021887270080829063U};
    set(system.substitution, 'X', "F-[[X]+X]+F[+FX]-X");
    set(system.substitution, 'F', "FF");
    return system;
}

constexpr std::uint64_t most_symbols = std::uint64_t{1} << 32;

std::uint64_t hash_of(const ByteWord& word) {
    return hash_text({reinterpret_cast<const char*>(word.data()), word.size()});
}

enum class Way { steps, power };

void rewriting(benchmark::State& state, System (*make)(), Way way, bool cold) {
    const System system = make();
    const std::span<const std::uint8_t> axiom(&system.axiom, 1);
    SerialExecutor serial;
    ByteWord word, before;
    for (std::uint64_t step = 0; step < system.steps; ++step) {
        before.swap(word);
        Result<ByteWord> next = apply(system.substitution, step == 0 ? axiom : before.symbols(), most_symbols, serial);
        if (!next) return state.SkipWithError("a step fails");
        word = *std::move(next);
    }
    const std::uint64_t hash = hash_of(word);
    if (hash != system.hash) return state.SkipWithError(("the word's hash is " + std::to_string(hash)).c_str());
    for (auto _ : state) {
        if (cold) {
            state.PauseTiming();
            ByteWord().swap(word);
            state.ResumeTiming();
        }
        Result<ByteWord> made =
            way == Way::steps ? apply(system.substitution, before.symbols(), most_symbols, serial, std::move(word))
                              : power(system.substitution, axiom, system.steps, most_symbols, serial, std::move(word));
        if (!made) return state.SkipWithError("a step fails");
        word = *std::move(made);
    }
    if (hash_of(word) != hash) return state.SkipWithError("the word is another one");
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * word.size()));
    state.counters["symbols"] = static_cast<double>(word.size());
}

#define SYSTEM(name)                                                                                       \
    BENCHMARK_CAPTURE(rewriting, name##_steps, name, Way::steps, false)->Unit(benchmark::kMillisecond);    \
    BENCHMARK_CAPTURE(rewriting, name##_power, name, Way::power, false)->Unit(benchmark::kMillisecond);    \
    BENCHMARK_CAPTURE(rewriting, name##_cold_step, name, Way::steps, true)->Unit(benchmark::kMillisecond); \
    BENCHMARK_CAPTURE(rewriting, name##_cold_power, name, Way::power, true)->Unit(benchmark::kMillisecond)
SYSTEM(koch);
SYSTEM(hilbert);
SYSTEM(plant);
#undef SYSTEM

}  // namespace
}  // namespace filigree::rewriting

BENCHMARK_MAIN();
