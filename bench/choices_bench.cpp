// A million choices made and recorded, against the same without a record: `ns_per_choice` is the difference, a choice.
// The work is timed in small pieces, and of each piece the best time of all repetitions counts, so that a busy machine
// disturbs it little. Memory is set up as in the program; else the kernel's small pages cost as much as the rest.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <numeric>
#include <vector>

#include "base/heap.h"
#include "language/choices.h"
#include "language/evaluate.h"
#include "language/parse.h"

namespace filigree {
namespace {

constexpr std::uint64_t pieces = 4000;
constexpr std::uint64_t steps_in_a_piece = 64;
constexpr std::uint64_t choices = 4 * pieces * steps_in_a_piece;

// The best seconds of each piece.
using Times = std::vector<double>;

// Evaluates an expression of four choices at each step; a sum that depends on every value. With a recorder each piece
// has a buffer of its own, which is appended.
double evaluate_all(const Expression& expression, ChoiceRecorder* recorder, Times& times) {
    Evaluation at;
    at.words = {"line", "wave", "zigzag"};
    at.site.name = "distance";
    double sum = 0;
    for (std::uint64_t piece = 0; piece < pieces; ++piece) {
        const auto begin = std::chrono::steady_clock::now();
        ChoiceBuffer buffer;
        ChoiceMaking making;
        if (recorder != nullptr) making.record = &buffer;
        at.choices = &making;
        for (std::uint64_t step = 0; step < steps_in_a_piece; ++step) {
            at.site.key = Key{mix(piece * steps_in_a_piece + step)};
            const Result<Value> value = evaluate(expression, at);
            const auto* list = value ? std::get_if<ValueList>(&value->data) : nullptr;
            if (list == nullptr) return 0;
            for (const Value& item : list->items) {
                if (const auto* number = std::get_if<Quantity>(&item.data)) sum += number->value;
            }
        }
        if (recorder != nullptr) recorder->append(buffer);
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
        times[piece] = std::min(times[piece], took.count());
    }
    return sum;
}

void recording(benchmark::State& state) {
    const Result<ExpressionPtr> expression =
        parse_expression("[5..9, normal(1, 0.2) in 0.6..1.6, one_of(line: 3, wave: 1, zigzag), 0..360]");
    if (!expression) return state.SkipWithError("the expression does not parse");
    Times alone(pieces, 1), recorded(pieces, 1);
    for (auto _ : state) {
        ChoiceRecorder recorder;
        const double sum = evaluate_all(**expression, nullptr, alone);
        const double again = evaluate_all(**expression, &recorder, recorded);
        if (sum != again || sum == 0) return state.SkipWithError("recording changes what is drawn");
        if (recorder.choices.size() != choices || recorder.choices.domain_table.size() != 4) {
            return state.SkipWithError("the record is not complete");
        }
    }
    const double evaluating = std::accumulate(alone.begin(), alone.end(), 0.0);
    const double both = std::accumulate(recorded.begin(), recorded.end(), 0.0);
    state.counters["ns_per_choice"] = (both - evaluating) / static_cast<double>(choices) * 1e9;
    state.counters["ns_to_evaluate"] = evaluating / static_cast<double>(choices) * 1e9;
}
BENCHMARK(recording)->Unit(benchmark::kMillisecond)->Iterations(8);

}  // namespace
}  // namespace filigree

int main(int argc, char** argv) {
    filigree::prepare_heap();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
