// How fast shapes are cut by curves that keep to no family. Each case first checks the pieces it times, so that a
// faster wrong answer fails: their areas add up, and their number and hash are the ones that were recorded.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "base/elementary.h"
#include "base/random.h"
#include "plane/curve_cut.h"

namespace filigree {
namespace {

double noise(std::uint64_t draw, std::uint64_t key) { return to_unit(random_bits(1, Key{key}, "noise", draw)) - 0.5; }

void add_wobbly_ring(Polygons& polygons, Vec centre, double radius, int count, bool hole, std::uint64_t key) {
    for (int i = 0; i < count; ++i) {
        const int step = hole ? count - 1 - i : i;
        const double angle = 2 * elementary::pi * step / count;
        const double r = radius * (1 + 0.08 * elementary::cos_sin(7 * angle + 0.3).sin +
                                   0.01 * noise(static_cast<std::uint64_t>(step), key));
        const elementary::CosSin turn = elementary::cos_sin(angle);
        polygons.points.push_back(snap(centre + r * Vec{turn.cos, turn.sin}));
    }
    polygons.end_ring();
}

// 2,000 vertices: an outer ring of 1,600 some 600 px across, and four holes of 100.
Polygons big_shape() {
    Polygons shape;
    add_wobbly_ring(shape, {400, 400}, 290, 1600, false, 1);
    const Vec centres[] = {{290, 300}, {510, 290}, {500, 510}, {300, 500}};
    for (std::uint64_t i = 0; i < 4; ++i) add_wobbly_ring(shape, centres[i], 45, 100, true, 2 + i);
    shape.end_polygon();
    return shape;
}

// Curves side by side that swing about a line through the shape, some 700 px long, none crossing another.
std::vector<Polyline> swinging(int curves, int points, double degrees) {
    std::vector<Polyline> result;
    const elementary::CosSin turn = elementary::cos_sin_degrees(degrees);
    for (int c = 0; c < curves; ++c) {
        Polyline& line = result.emplace_back();
        for (int i = 0; i < points; ++i) {
            const double u = 700.0 * i / (points - 1) - 350;
            const double v = 640.0 * (c + 0.5) / curves - 320 + 12 * elementary::cos_sin(u / 30).sin;
            line.points.push_back(Vec{400, 400} + Vec{u * turn.cos - v * turn.sin, u * turn.sin + v * turn.cos});
        }
    }
    return result;
}

// Closed curves with loops, each of them crossing itself and many others.
std::vector<Polyline> tangled(int curves, int points, double size) {
    std::vector<Polyline> result;
    for (int c = 0; c < curves; ++c) {
        const auto key = static_cast<std::uint64_t>(100 + c);
        const Vec centre{400 + 560 * noise(0, key), 400 + 560 * noise(1, key)};
        Polyline& line = result.emplace_back();
        line.closed = true;
        for (int i = 0; i < points; ++i) {
            const double angle = 2 * elementary::pi * i / points;
            const elementary::CosSin a = elementary::cos_sin(2 * angle + noise(2, key)),
                                     b = elementary::cos_sin(3 * angle);
            line.points.push_back(centre + size * Vec{a.cos + 0.4 * b.sin, a.sin + 0.4 * b.cos});
        }
    }
    return result;
}

std::uint64_t hash_of(const Polygons& pieces) {
    std::uint64_t hash = 0;
    for (const Point p : pieces.points)
        hash = fold(fold(hash, static_cast<std::uint64_t>(p.x)), static_cast<std::uint64_t>(p.y));
    for (const std::uint32_t end : pieces.ring_ends) hash = fold(hash, end);
    for (const std::uint32_t end : pieces.polygon_ends) hash = fold(hash, end);
    return hash;
}

struct Expected {
    std::size_t pieces = 0;
    std::uint64_t hash = 0;
};

void run(benchmark::State& state, const Polygons& shape, const std::vector<Polyline>& curves, Expected expected) {
    const Polygons pieces = cut_by_curves(shape[0], curves);
    if (std::fabs(area(pieces) - area(shape)) > 1e-9 * area(shape)) {
        state.SkipWithError("the pieces' areas do not add up");
        return;
    }
    if (pieces.size() != expected.pieces || hash_of(pieces) != expected.hash) {
        const std::string found =
            "the pieces changed: " + std::to_string(pieces.size()) + " of hash " + std::to_string(hash_of(pieces));
        state.SkipWithError(found.c_str());
        return;
    }
    for (auto _ : state) {
        Polygons result = cut_by_curves(shape[0], curves);
        benchmark::DoNotOptimize(result.points.data());
    }
    std::size_t segments = 0;
    for (const Polyline& curve : curves) segments += curve.points.size() - (curve.closed ? 0 : 1);
    state.counters["segments"] = static_cast<double>(segments);
    state.counters["pieces"] = static_cast<double>(pieces.size());
    state.counters["segments/s"] =
        benchmark::Counter(static_cast<double>(segments), benchmark::Counter::kIsIterationInvariantRate);
}

// The target: 200,000 segments over 2,000 vertices.
void big_apart(benchmark::State& state) {
    run(state, big_shape(), swinging(500, 401, 17), {974, 14973155338929238119U});
}
// Two such families across each other: 40,000 crossings.
void big_crossing(benchmark::State& state) {
    std::vector<Polyline> curves = swinging(250, 401, 17);
    for (Polyline& line : swinging(250, 401, 98)) curves.push_back(std::move(line));
    run(state, big_shape(), curves, {36996, 5965001927649440998U});
}
void big_tangled(benchmark::State& state) {
    run(state, big_shape(), tangled(500, 400, 40), {57387, 9394531502105730550U});
}
void small_apart(benchmark::State& state) {
    Polygons shape;
    add_wobbly_ring(shape, {400, 400}, 290, 100, false, 1);
    shape.end_polygon();
    run(state, shape, swinging(10, 30, 17), {11, 12078678529770509487U});
}

BENCHMARK(big_apart)->Unit(benchmark::kMillisecond);
BENCHMARK(big_crossing)->Unit(benchmark::kMillisecond);
BENCHMARK(big_tangled)->Unit(benchmark::kMillisecond);
BENCHMARK(small_apart)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace filigree

BENCHMARK_MAIN();
