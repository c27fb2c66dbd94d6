// Splits along streamlines. Each case checks the hash of its pieces: a faster wrong answer fails.
//   tile    a square of 80 px at 6.2 px, as the published tiger splits dozens of them
//   small   20 points, 10 px wide
//   large   200 points, 20 lines
#include <benchmark/benchmark.h>

#include <cstdint>
#include <string>

#include "base/random.h"
#include "plane/streamline_cut.h"
#include "plane/streamline_test_shapes.h"

namespace filigree {
namespace {

std::uint64_t hash_of(const StreamlineCut& cut) {
    std::uint64_t hash = cut.pieces.size();
    for (const Point& p : cut.pieces.points) {
        hash = fold(fold(hash, static_cast<std::uint64_t>(p.x)), static_cast<std::uint64_t>(p.y));
    }
    for (const StreamlineCut::Place& place : cut.places) hash = fold(hash, place.key);
    return hash;
}

Polygons shape_of(std::string_view name) {
    CaseRandom random(3);
    if (name == "tile") return test_shapes::rectangle(80, 80);
    if (name == "small") return test_shapes::one_polygon({test_shapes::wobbly_ring(random, {0, 0}, 5, 20, 0.2, 0)});
    return test_shapes::one_polygon({test_shapes::wobbly_ring(random, {0, 0}, 100, 200, 0.5, 0.01)});
}

void split(benchmark::State& state, std::string_view name, StreamlineKind kind, bool by_field, bool dual, double offset,
           std::uint64_t expected) {
    const Polygons shape = shape_of(name);
    StreamlineCutOptions options;
    options.kind = kind;
    options.by_field = by_field;
    options.dual = dual;
    options.offsets = {offset};
    options.centre = centroid(shape[0]);
    const StreamlineCut cut = cut_by_streamlines(shape[0], options);
    if (hash_of(cut) != expected) state.SkipWithError(("the result's hash is " + std::to_string(hash_of(cut))).c_str());
    for (auto _ : state) benchmark::DoNotOptimize(cut_by_streamlines(shape[0], options));
    state.counters["pieces"] = static_cast<double>(cut.pieces.size());
}

constexpr StreamlineKind smooth = StreamlineKind::smooth, strip = StreamlineKind::strip,
                         circular = StreamlineKind::circular;
BENCHMARK_CAPTURE(split, tile_smooth, "tile", smooth, false, false, 6.2, 7356601660039629067U)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(split, tile_field, "tile", smooth, true, false, 6.2, 12506416580736826506U)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(split, tile_dual, "tile", smooth, false, true, 6.2, 8582098756177913872U)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(split, small_smooth, "small", smooth, false, false, 6.2, 14804062568915844211U)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(split, small_smooth_fine, "small", smooth, false, false, 1, 6864707044268099690U)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(split, small_strip, "small", strip, false, false, 6.2, 13870390537934467076U)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(split, small_field, "small", smooth, true, false, 6.2, 14268081930503628008U)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(split, large_smooth, "large", smooth, false, false, 5, 5398267710290686066U)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(split, large_smooth_field, "large", smooth, true, false, 5, 8129510086954755689U)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(split, large_strip, "large", strip, false, false, 10, 6187772397145748244U)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(split, large_strip_field, "large", strip, true, false, 10, 11405781976418655155U)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(split, large_circular, "large", circular, false, false, 5, 16347276599575852756U)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace filigree

BENCHMARK_MAIN();
