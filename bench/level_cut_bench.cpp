// How fast shapes are split by level families. Each case first checks the pieces it times, so that a faster
// wrong answer fails: their areas add up, and their hash is the one that was recorded.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <string>

#include "base/elementary.h"
#include "base/random.h"
#include "plane/level_cut.h"

namespace filigree {
namespace {

double noise(std::uint64_t draw, std::uint64_t shape) {
    return to_unit(random_bits(1, Key{shape}, "noise", draw)) - 0.5;
}

// A star-like ring around a centre; its radius swells in a few lobes and shakes from vertex to vertex.
void add_wobbly_ring(Polygons& polygons, Vec centre, double radius, int count, double swell, double shake, bool hole,
                     std::uint64_t key) {
    for (int i = 0; i < count; ++i) {
        const int step = hole ? count - 1 - i : i;
        const double angle = 2 * elementary::pi * step / count;
        const double lobes = elementary::cos_sin(7 * angle + 0.3).sin + 0.5 * elementary::cos_sin(13 * angle).cos;
        const double r = radius * (1 + swell * lobes + shake * noise(static_cast<std::uint64_t>(step), key));
        const elementary::CosSin turn = elementary::cos_sin(angle);
        polygons.points.push_back(snap({centre.x + r * turn.cos, centre.y + r * turn.sin}));
    }
    polygons.end_ring();
}

// 2,000 vertices: an outer ring of 1,600 some 600 px across, and four holes of 100.
Polygons big_shape() {
    Polygons shape;
    add_wobbly_ring(shape, {400, 400}, 290, 1600, 0.08, 0.01, false, 1);
    const Vec centres[] = {{290, 300}, {510, 290}, {500, 510}, {300, 500}};
    for (std::uint64_t i = 0; i < 4; ++i) add_wobbly_ring(shape, centres[i], 45, 100, 0.1, 0.03, true, 2 + i);
    shape.end_polygon();
    return shape;
}

Polygons small_shapes() {
    Polygons shapes;
    for (std::uint64_t i = 0; i < 10000; ++i) {
        const double radius = 15 + 10 * noise(0, 100 + i);
        add_wobbly_ring(shapes, {60.0 * static_cast<double>(i % 100), 60.0 * static_cast<double>(i / 100)}, radius, 100,
                        0.08, 0.02, false, 20000 + i);
        shapes.end_polygon();
    }
    return shapes;
}

// Lines or waves (a sum of two sines, sampled every 2 px), a little turned so that nothing is aligned.
LevelFamily family(bool curved, double spacing, int count, double centre) {
    LevelFamily result;
    const elementary::CosSin turn = elementary::cos_sin_degrees(17);
    result.frame = {{centre, centre}, {turn.cos, turn.sin}};
    if (curved) {
        result.profile.step = 2;
        for (int i = 0; i < 401; ++i) {
            const double u = 2 * elementary::pi * i / 401;
            result.profile.samples.push_back(12 * elementary::cos_sin(9 * u).sin + 5 * elementary::cos_sin(23 * u).sin);
        }
    }
    for (int k = 0; k < count; ++k) result.levels.push_back((k - count / 2) * spacing);
    return result;
}

std::uint64_t hash_of(const LevelCut& cut, std::uint64_t hash = 0) {
    for (const Point p : cut.pieces.points)
        hash = fold(fold(hash, static_cast<std::uint64_t>(p.x)), static_cast<std::uint64_t>(p.y));
    for (const std::uint32_t end : cut.pieces.ring_ends) hash = fold(hash, end);
    for (const std::uint32_t end : cut.pieces.polygon_ends) hash = fold(hash, end);
    for (const std::int32_t strip : cut.strips) hash = fold(hash, static_cast<std::uint64_t>(strip));
    return hash;
}

struct Expected {
    std::size_t pieces = 0;
    std::uint64_t hash = 0;
};

void run(benchmark::State& state, const Polygons& shapes, const LevelFamily& lines, Expected expected) {
    std::size_t pieces = 0, points = 0;
    std::uint64_t hash = 0;
    double cut_area = 0;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const LevelCut result = cut(shapes[i], lines);
        pieces += result.pieces.size();
        points += result.pieces.points.size();
        hash = hash_of(result, hash);
        cut_area += area(result.pieces);
    }
    if (std::fabs(cut_area - area(shapes)) > 1e-9 * area(shapes)) {
        state.SkipWithError("the pieces' areas do not add up");
        return;
    }
    if (pieces != expected.pieces || hash != expected.hash) {
        const std::string found = "the pieces changed: " + std::to_string(pieces) + " of hash " + std::to_string(hash);
        state.SkipWithError(found.c_str());
        return;
    }
    for (auto _ : state) {
        for (std::size_t i = 0; i < shapes.size(); ++i) {
            LevelCut result = cut(shapes[i], lines);
            benchmark::DoNotOptimize(result.pieces.points.data());
        }
    }
    state.counters["pieces"] = static_cast<double>(pieces);
    state.counters["points"] = static_cast<double>(points);
    state.counters["pieces/s"] =
        benchmark::Counter(static_cast<double>(pieces), benchmark::Counter::kIsIterationInvariantRate);
}

void big_straight(benchmark::State& state) {
    run(state, big_shape(), family(false, 1.6, 500, 400), {806, 2752065444927327821U});
}
void big_curved(benchmark::State& state) {
    run(state, big_shape(), family(true, 1.6, 500, 400), {1055, 9206730383363496131U});
}
void small_straight(benchmark::State& state) {
    run(state, small_shapes(), family(false, 4, 4000, 3000), {95694, 2949020356746708396U});
}
void small_curved(benchmark::State& state) {
    run(state, small_shapes(), family(true, 4, 4000, 3000), {119913, 6873477236629806295U});
}

BENCHMARK(big_straight)->Unit(benchmark::kMillisecond);
BENCHMARK(big_curved)->Unit(benchmark::kMillisecond);
BENCHMARK(small_straight)->Unit(benchmark::kMillisecond);
BENCHMARK(small_curved)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace filigree

BENCHMARK_MAIN();
