// Placing: points spread and relaxed, discs fitted and carved out, many small regions, regions full of holes, stipples
// by a density, and mosaics. Each case checks the hash of its results: a faster wrong answer fails.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <string>
#include <vector>

#include "base/random.h"
#include "plane/carve.h"
#include "plane/fit.h"
#include "plane/inset_test_shapes.h"
#include "plane/mosaic.h"
#include "plane/spread.h"

namespace filigree {
namespace {

std::uint64_t hash_of(const Polygons& polygons, std::uint64_t hash) {
    for (const Point& p : polygons.points) {
        hash = fold(fold(hash, static_cast<std::uint64_t>(p.x)), static_cast<std::uint64_t>(p.y));
    }
    return fold(hash, polygons.size());
}

void check(benchmark::State& state, std::uint64_t hash, std::uint64_t expected) {
    if (hash != expected) state.SkipWithError(("the result's hash is " + std::to_string(hash)).c_str());
}

Polygons large_region() {
    CaseRandom draws{5};
    return test_shapes::one_polygon({test_shapes::wobbly_ring(draws, {10, 20}, 200, 400, 0.5, 0.02)});
}

SpreadOptions options_for(double spacing) {
    SpreadOptions options;
    options.spacing = options.apart = spacing;
    options.clearance = 0.4 * spacing;
    options.least_clearance = 0.2 * spacing;
    return options;
}

// Blobs of 0.8 of the spacing, as the operator places them.
Carving placed(const Polygons& region, double spacing) {
    const EdgeTree border(edges_of(region[0], Point{0, 0}));
    std::vector<Pose> poses;
    for (const SpreadPoint& point : spread(region[0], options_for(spacing))) {
        poses.push_back({point.at, {1, 0}, 0.4 * spacing});
    }
    fit(poses, disc_motif(12), border, {});
    const std::vector<Vec> circle = unit_circle(24);
    Polygons objects;
    std::vector<std::uint32_t> owners;
    for (std::uint32_t i = 0; i < poses.size(); ++i) {
        if (poses[i].radius > 0) append(objects, blob_motif(circle, i), poses[i]);
        owners.resize(objects.size(), i);
    }
    return carve(region[0], border, objects, owners, false);
}

void spread_points(benchmark::State& state, double spacing, std::uint64_t expected) {
    const Polygons region = large_region();
    std::uint64_t hash = 0;
    std::int64_t count = 0;
    for (const SpreadPoint& point : spread(region[0], options_for(spacing))) {
        const Point at = snap(point.at);
        hash = fold(fold(hash, static_cast<std::uint64_t>(at.x)), static_cast<std::uint64_t>(at.y));
        ++count;
    }
    check(state, hash, expected);
    for (auto _ : state) benchmark::DoNotOptimize(spread(region[0], options_for(spacing)));
    state.SetItemsProcessed(state.iterations() * count);
    state.counters["points"] = static_cast<double>(count);
}

void place_blobs(benchmark::State& state, double spacing, std::uint64_t expected) {
    const Polygons region = large_region();
    const Carving carving = placed(region, spacing);
    check(state, hash_of(carving.remainder, hash_of(carving.placed, 0)), expected);
    for (auto _ : state) benchmark::DoNotOptimize(placed(region, spacing));
    state.counters["objects"] = static_cast<double>(carving.placed.size());
}

void place_in_what_remains(benchmark::State& state, std::uint64_t expected) {
    const Polygons region = placed(large_region(), 9).remainder;
    const Carving carving = placed(region, 4);
    check(state, hash_of(carving.remainder, hash_of(carving.placed, 0)), expected);
    for (auto _ : state) benchmark::DoNotOptimize(placed(region, 4));
    state.counters["objects"] = static_cast<double>(carving.placed.size());
    state.counters["holes"] = static_cast<double>(region.ring_ends.size() - 1);
}

void place_in_many(benchmark::State& state, double radius, std::uint64_t expected) {
    std::vector<Polygons> regions;
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        CaseRandom draws{seed};
        const Vec at{draws.between(-500, 500), draws.between(-500, 500)};
        regions.push_back(test_shapes::one_polygon({test_shapes::wobbly_ring(draws, at, radius, 40, 0.5, 0.02)}));
    }
    std::uint64_t hash = 0;
    std::size_t count = 0;
    for (const Polygons& region : regions) {
        const Carving carving = placed(region, 10);
        hash = hash_of(carving.remainder, hash_of(carving.placed, hash));
        count += carving.placed.size();
    }
    check(state, hash, expected);
    for (auto _ : state) {
        for (const Polygons& region : regions) benchmark::DoNotOptimize(placed(region, 10));
    }
    state.counters["objects"] = static_cast<double>(count);
}

void stipple(benchmark::State& state, std::uint64_t expected) {
    const Polygons region = large_region();
    SpreadOptions options = options_for(2);
    options.apart = 1;
    options.rounds = 4;
    options.density = [](Vec p) { return 0.5 + p.x / 500; };
    const std::vector<SpreadPoint> points = spread(region[0], options);
    std::uint64_t hash = 0;
    for (const SpreadPoint& point : points) hash = fold(hash, static_cast<std::uint64_t>(snap(point.at).x));
    check(state, hash, expected);
    for (auto _ : state) benchmark::DoNotOptimize(spread(region[0], options));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points.size()));
}

void mosaics(benchmark::State& state, std::uint64_t expected) {
    const Polygons region = large_region();
    std::vector<Vec> sites;
    for (const SpreadPoint& point : spread(region[0], options_for(6))) sites.push_back(point.at);
    const Mosaic cells = mosaic(region[0], sites);
    check(state, hash_of(cells.pieces, 0), expected);
    for (auto _ : state) benchmark::DoNotOptimize(mosaic(region[0], sites));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(cells.pieces.size()));
}

BENCHMARK_CAPTURE(spread_points, by_18, 18, 2310037930458342979U)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(spread_points, by_5_7, 5.7, 5080743648863306478U)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(place_blobs, by_18, 18, 3016793862819441148U)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(place_blobs, by_5_7, 5.7, 2836826266876565006U)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(place_in_what_remains, by_4, 1307079273561029107U)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(place_in_many, one_each, 7, 6710813449215135732U)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(place_in_many, few_each, 16, 13600899327021573838U)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stipple, by_2, 1857178108967673287U)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(mosaics, by_6, 4809213784392235767U)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace filigree

BENCHMARK_MAIN();
