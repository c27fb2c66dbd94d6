// Insets of 10,000 discs of 100 vertices (radius 10 to 20 px), all checks included, and scattered points. Each
// case checks the hash of its results: a faster wrong answer fails.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <string>
#include <vector>

#include "base/random.h"
#include "plane/inset.h"
#include "plane/inset_test_shapes.h"
#include "plane/scatter.h"

namespace filigree {
namespace {

std::uint64_t hash_of(const Polygons& polygons, std::uint64_t hash) {
    for (const Point& p : polygons.points) {
        hash = fold(fold(hash, static_cast<std::uint64_t>(p.x)), static_cast<std::uint64_t>(p.y));
    }
    return fold(hash, polygons.size());
}

std::vector<Polygons> discs(double jitter) {
    std::vector<Polygons> shapes;
    for (std::uint64_t seed = 0; seed < 10000; ++seed) {
        CaseRandom draws{seed};
        const double radius = draws.between(10, 20);
        shapes.push_back(test_shapes::one_polygon({test_shapes::wobbly_ring(draws, {0, 0}, radius, 100, 0.5, jitter)}));
    }
    return shapes;
}

void check(benchmark::State& state, std::uint64_t hash, std::uint64_t expected) {
    if (hash != expected) state.SkipWithError(("the result's hash is " + std::to_string(hash)).c_str());
}

void inset_discs(benchmark::State& state, double distance, Join join, double jitter, std::uint64_t expected) {
    const std::vector<Polygons> shapes = discs(jitter);
    InsetOptions options;
    options.distance = distance;
    options.join = join;
    std::uint64_t hash = 0;
    std::uint64_t general = 0;
    for (const Polygons& shape : shapes) {
        const Inset result = inset(shape[0], options);
        general += result.took_general_way;
        hash = hash_of(result.inner, hash);
    }
    check(state, hash, expected);
    for (auto _ : state) {
        for (const Polygons& shape : shapes) benchmark::DoNotOptimize(inset(shape[0], options));
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(shapes.size()));
    state.counters["general"] = static_cast<double>(general);
}

void scatter_points(benchmark::State& state, double spacing, std::uint64_t expected) {
    CaseRandom draws{5};
    const Polygons region = test_shapes::one_polygon({test_shapes::wobbly_ring(draws, {10, 20}, 200, 400, 0.5, 0.02)});
    ScatterOptions options;
    options.spacing = spacing;
    options.clearance = spacing / 3;
    std::uint64_t hash = 0;
    std::int64_t count = 0;
    for (const ScatteredPoint& point : scatter(region[0], options)) {
        const Point at = snap(point.at);
        hash = fold(fold(hash, static_cast<std::uint64_t>(at.x)), static_cast<std::uint64_t>(at.y));
        ++count;
    }
    check(state, hash, expected);
    for (auto _ : state) benchmark::DoNotOptimize(scatter(region[0], options));
    state.SetItemsProcessed(state.iterations() * count);
}

BENCHMARK_CAPTURE(inset_discs, mitre_half, 0.5, Join::mitre, 0.02, 8056181024301218246U)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(inset_discs, mitre_1, 1, Join::mitre, 0.02, 220961921634829185U)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(inset_discs, mitre_4, 4, Join::mitre, 0.02, 13015828241991962613U)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(inset_discs, round_1, 1, Join::round, 0.02, 5105872765474867776U)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(inset_discs, round_4, 4, Join::round, 0.02, 1784957094633797676U)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(inset_discs, rough_1, 1, Join::mitre, 0.15, 825888970641116326U)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(inset_discs, rough_4, 4, Join::mitre, 0.15, 10704300790036378698U)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(scatter_points, by_4, 4, 15584495041833600204U)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(scatter_points, by_1, 1, 15108754323317825530U)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace filigree

BENCHMARK_MAIN();
