// What an edit costs: a document of 18,000 shapes and some 400 steps, derived anew and after changes of a step at a
// leaf and of one near the start, all in the library from the new text to the tangle; and listing a million choices.
#include <benchmark/benchmark.h>

#include <fstream>
#include <iterator>
#include <string>

#include "base/executor.h"
#include "session/list_choices.h"
#include "session/run.h"

namespace filigree {
namespace {

OpenedDocument read_document(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    return open_text("quilt.fil", {std::istreambuf_iterator<char>(stream), {}}, {});
}

struct Derived {
    OpenedDocument opened;
    CheckedDocument checked;
    tangle::Tangle tangle;
};

std::unique_ptr<Derived> derived(OpenedDocument opened, const tangle::Tangle* previous) {
    SerialExecutor serial;
    auto all = std::make_unique<Derived>();
    all->opened = std::move(opened);
    all->checked = check_document(all->opened);
    RunOptions options;
    options.previous = previous;
    Result<tangle::Tangle> tangle = derive_document(all->opened, all->checked, options, serial, {});
    if (tangle) all->tangle = std::move(*tangle);
    return all;
}

bool same_shapes(const tangle::Tangle& a, const tangle::Tangle& b) {
    if (a.groups.size() != b.groups.size() || a.steps.size() != b.steps.size()) return false;
    for (std::size_t g = 0; g < a.groups.size(); ++g) {
        if (a.groups[g].key != b.groups[g].key || a.groups[g].shapes.size() != b.groups[g].shapes.size()) return false;
    }
    return true;
}

std::uint64_t leaves(const tangle::Tangle& tangle) {
    std::uint64_t count = 0;
    for (const tangle::Group& group : tangle.groups) {
        if (group.consumer == tangle::none) count += group.shapes.size();
    }
    return count;
}

// `edit`: a statement at the end; empty for none.
void derive_after(benchmark::State& state, const char* edit, bool with_previous) {
    const OpenedDocument before = read_document("bench/documents/quilt.fil");
    const auto first = derived(before, nullptr);
    const std::string text = before.document.text() + edit + "\n";
    const auto expected = derived(reopened(before, text), nullptr);
    if (!same_shapes(expected->tangle, derived(reopened(before, text), &first->tangle)->tangle)) {
        state.SkipWithError("another result than without the earlier derivation");
    }
    for (auto _ : state) {
        benchmark::DoNotOptimize(derived(reopened(before, text), with_previous ? &first->tangle : nullptr));
    }
    state.counters["shapes"] = static_cast<double>(leaves(expected->tangle));
    state.counters["steps"] = static_cast<double>(expected->tangle.steps.size());
}

constexpr const char* leaf_edit =
    "set sheet/regular_split/field/ungroup/patch[7]/*/bit/regroup/part[1]/outline.distance = 1.1";
constexpr const char* start_edit = "set sheet/regular_split.offset = 90";

BENCHMARK_CAPTURE(derive_after, fresh, "", false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(derive_after, leaf_step, leaf_edit, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(derive_after, near_start_fresh, start_edit, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(derive_after, near_start, start_edit, true)->Unit(benchmark::kMillisecond);

// A million choices, each of a shape of its own.
void list_million(benchmark::State& state) {
    const OpenedDocument opened =
        open_text("million.fil",
                  "grammar tangle\nlimit elements 4000000\nstart sheet = rectangle(4000, 4000)\n"
                  "regular_split(line, 4, dual: true, angle: 0) : sheet -> cell\n"
                  "outline(each(0.1..0.5)) : cell -> core, rim\n",
                  {});
    SerialExecutor serial;
    const CheckedDocument checked = check_document(opened);
    Run run;
    if (auto tangle = derive_document(opened, checked, {}, serial, {})) run.tangle = std::move(*tangle);
    const std::size_t count = run.tangle.choices.size();
    if (count < 1'000'000) state.SkipWithError("too few choices");
    std::uint64_t bytes = 0;
    for (auto _ : state) {
        list_choices(opened, checked, run, [&](std::string_view piece) { bytes += piece.size(); });
    }
    benchmark::DoNotOptimize(bytes);
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(count));
}
BENCHMARK(list_million)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace filigree

BENCHMARK_MAIN();
