// A million choices made and recorded, against the same without a record: `ns_per_choice` is the difference of the best
// times of either, a choice.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <ctime>

#include "language/choices.h"
#include "language/evaluate.h"
#include "language/parse.h"

namespace filigree {
namespace {

constexpr std::uint64_t steps = 250000;  // of four choices
constexpr std::uint64_t steps_in_a_buffer = 64;

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// A sum that depends on every value, so that a faster wrong answer fails.
double evaluate_all(const Expression& expression, bool is_recorded, ChoiceRecorder& recorder) {
    ChoiceBuffer buffer;
    ChoiceMaking making;
    if (is_recorded) making.record = &buffer;
    Evaluation at;
    at.words = {"line", "wave", "zigzag"};
    at.site.name = "distance";
    at.choices = &making;
    double sum = 0;
    for (std::uint64_t step = 0; step < steps; ++step) {
        at.site.key = Key{mix(step)};
        const Result<Value> value = evaluate(expression, at);
        const auto* list = value ? std::get_if<ValueList>(&value->data) : nullptr;
        if (list == nullptr) return 0;
        for (const Value& item : list->items) {
            if (const auto* number = std::get_if<Quantity>(&item.data)) sum += number->value;
        }
        if (is_recorded && (step + 1) % steps_in_a_buffer == 0) {
            recorder.append(buffer);
            buffer.rows.clear();
            buffer.places.clear();
        }
    }
    recorder.append(buffer);
    return sum;
}

void recording(benchmark::State& state) {
    const Result<ExpressionPtr> expression =
        parse_expression("[5..9, normal(1, 0.2) in 0.6..1.6, one_of(line: 3, wave: 1, zigzag), 0..360]");
    if (!expression) return state.SkipWithError("the expression does not parse");
    constexpr double choices = 4.0 * static_cast<double>(steps);
    double alone = 1e9, recorded = 1e9;
    for (auto _ : state) {
        ChoiceRecorder none, recorder;
        const double begin = processor_seconds();
        const double sum = evaluate_all(**expression, false, none);
        const double between = processor_seconds();
        const double again = evaluate_all(**expression, true, recorder);
        alone = std::min(alone, between - begin);
        recorded = std::min(recorded, processor_seconds() - between);
        if (sum != again || sum == 0) return state.SkipWithError("recording changes what is drawn");
        if (recorder.choices.size() != 4 * steps || recorder.choices.domain_table.size() != 4) {
            return state.SkipWithError("the record is not complete");
        }
    }
    state.counters["ns_per_choice"] = (recorded - alone) / choices * 1e9;
    state.counters["ns_to_evaluate"] = alone / choices * 1e9;
}
BENCHMARK(recording)->Unit(benchmark::kMillisecond)->Iterations(5);

}  // namespace
}  // namespace filigree

BENCHMARK_MAIN();
