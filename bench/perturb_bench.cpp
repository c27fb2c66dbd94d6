// How fast drawings are perturbed. Each case first checks what it times, so that a faster wrong answer fails: the
// faces' areas add up to the outline's, and their hash is the one that was recorded.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <string>

#include "base/elementary.h"
#include "base/random.h"
#include "plane/perturb.h"
#include "plane/weld.h"

namespace filigree {
namespace {

// A square sheet of curved cells: columns and rows bend, and every border has `detail` vertices. Each second cell is
// cut once more, so that its neighbours have T-junctions.
PerturbInput sheet(int cells, int detail) {
    const double size = 1000, cell = size / cells;
    const auto place = [&](double u, double v) {
        const double x = u * cell, y = v * cell;
        const double inside =
            elementary::cos_sin(elementary::pi * x / size).sin * elementary::cos_sin(elementary::pi * y / size).sin;
        return snap({x + 0.4 * cell * inside * elementary::cos_sin(y / 23).sin,
                     y + 0.4 * cell * inside * elementary::cos_sin(x / 31).sin});
    };
    PerturbInput input;
    const auto add = [&](double left, double top, double width) {
        const auto side = [&](double u, double v, double du, double dv) {
            for (int k = 0; k < detail; ++k) {
                const double t = static_cast<double>(k) / detail;
                input.faces.polygons.points.push_back(place(u + t * du, v + t * dv));
            }
        };
        side(left, top, width, 0);
        side(left + width, top, 0, 1);
        side(left + width, top + 1, -width, 0);
        side(left, top + 1, 0, -1);
        input.faces.polygons.end_ring();
        input.faces.polygons.end_polygon();
        input.faces.wobbles.push_back({1.5, 60});
    };
    for (int i = 0; i < cells; ++i) {
        for (int j = 0; j < cells; ++j) {
            if ((i + j) % 2 == 0) {
                add(i, j, 1);
            } else {
                add(i, j, 0.375);
                add(i + 0.375, j, 0.625);
            }
        }
    }
    input.borders.polygons.points = {snap({0, 0}), snap({size, 0}), snap({size, size}), snap({0, size})};
    input.borders.polygons.end_ring();
    input.borders.polygons.end_polygon();
    input.borders.wobbles.push_back({1.5, 60});
    input.seed = 1;
    return input;
}

std::uint64_t hash_of(const Polygons& polygons) {
    std::uint64_t hash = 0;
    for (const Point p : polygons.points) {
        hash = fold(fold(hash, static_cast<std::uint64_t>(p.x)), static_cast<std::uint64_t>(p.y));
    }
    for (const std::uint32_t end : polygons.ring_ends) hash = fold(hash, end);
    return hash;
}

void perturb_sheet(benchmark::State& state, int cells, int detail, std::uint64_t expected) {
    const PerturbInput input = sheet(cells, detail);
    const Perturbed once = perturb(input);
    const double off = std::fabs(area(once.faces) - area(once.borders));
    const std::uint64_t hash = hash_of(once.faces);
    if (!(off <= 1e-9 * area(once.borders)) || hash != expected) {
        state.SkipWithError(
            ("the areas are off by " + std::to_string(off) + ", the hash is " + std::to_string(hash)).c_str());
        return;
    }
    for (auto _ : state) benchmark::DoNotOptimize(perturb(input));
    state.counters["shapes"] = static_cast<double>(input.faces.polygons.size());
    state.counters["points"] = static_cast<double>(input.faces.polygons.points.size());
}

void weld_sheet(benchmark::State& state) {
    const Polygons polygons = sheet(110, 7).faces.polygons;
    for (auto _ : state) benchmark::DoNotOptimize(weld(polygons));
    state.counters["points"] = static_cast<double>(polygons.points.size());
}

// The goals: well under 100 ms for the first where a machine allows it, 500 ms for the second.
BENCHMARK_CAPTURE(perturb_sheet, half_a_million_points, 110, 7, UINT64_C(1))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(perturb_sheet, a_million_points, 155, 7, UINT64_C(2))->Unit(benchmark::kMillisecond);
BENCHMARK(weld_sheet)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace filigree

BENCHMARK_MAIN();
