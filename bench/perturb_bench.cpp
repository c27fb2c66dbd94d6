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

// A square sheet of curved cells. Every second cell is cut in two; its neighbours do not know of the cut's ends, which
// lie in their edges.
class Sheet {
public:
    explicit Sheet(int cells) : cell_(size / cells) {
        for (int i = 0; i < cells; ++i) {
            for (int j = 0; j < cells; ++j) add_cell(i * detail, j * detail, (i + j) % 2 == 0);
        }
        const Point corners[] = {snap({0, 0}), snap({size, 0}), snap({size, size}), snap({0, size})};
        input_.borders.polygons.add_ring(corners);
        input_.borders.polygons.end_polygon();
        input_.borders.wobbles.push_back(wobble);
        input_.seed = 1;
    }

    const PerturbInput& input() const { return input_; }

private:
    static constexpr double size = 1000;
    static constexpr int detail = 7, cut = 3;  // points a side, and the one at which a cut begins
    static constexpr Wobble wobble{1.5, 60};

    Vec bent(int i, int j) const {
        const double x = i * cell_ / detail, y = j * cell_ / detail;
        const double inside =
            elementary::cos_sin(elementary::pi * x / size).sin * elementary::cos_sin(elementary::pi * y / size).sin;
        return {x + 0.4 * cell_ * inside * elementary::cos_sin(y / 23).sin,
                y + 0.4 * cell_ * inside * elementary::cos_sin(x / 31).sin};
    }
    void add_point(int i, int j) {
        const bool is_end = i % detail == cut && j % detail == 0;
        input_.faces.polygons.points.push_back(snap(is_end ? 0.5 * (bent(i - 1, j) + bent(i + 1, j)) : bent(i, j)));
    }
    void end_face() {
        input_.faces.polygons.end_ring();
        input_.faces.polygons.end_polygon();
        input_.faces.wobbles.push_back(wobble);
    }
    void add_part(int left, int right, int top, bool knows_cut) {
        const auto wanted = [&](int i) { return knows_cut || i % detail != cut; };
        const int bottom = top + detail;
        for (int i = left; i < right; ++i) {
            if (wanted(i)) add_point(i, top);
        }
        for (int j = top; j < bottom; ++j) add_point(right, j);
        for (int i = right; i > left; --i) {
            if (wanted(i)) add_point(i, bottom);
        }
        for (int j = bottom; j > top; --j) add_point(left, j);
        end_face();
    }
    void add_cell(int left, int top, bool is_whole) {
        if (is_whole) return add_part(left, left + detail, top, false);
        add_part(left, left + cut, top, true);
        add_part(left + cut, left + detail, top, true);
    }

    const double cell_;
    PerturbInput input_;
};

std::uint64_t hash_of(const Polygons& polygons) {
    std::uint64_t hash = 0;
    for (const Point p : polygons.points) {
        hash = fold(fold(hash, static_cast<std::uint64_t>(p.x)), static_cast<std::uint64_t>(p.y));
    }
    for (const std::uint32_t end : polygons.ring_ends) hash = fold(hash, end);
    return hash;
}

void perturb_sheet(benchmark::State& state, int cells, std::uint64_t expected) {
    const Sheet sheet(cells);
    const PerturbInput& input = sheet.input();
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
    const Polygons polygons = Sheet(123).input().faces.polygons;
    for (auto _ : state) benchmark::DoNotOptimize(weld(polygons));
    state.counters["points"] = static_cast<double>(polygons.points.size());
}

// The goals: well under 100 ms for the first where a machine allows it, 500 ms for the second.
BENCHMARK_CAPTURE(perturb_sheet, half_a_million_points, 123, UINT64_C(3760599126217303348))
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(perturb_sheet, a_million_points, 174, UINT64_C(8839162123180812658))->Unit(benchmark::kMillisecond);
BENCHMARK(weld_sheet)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace filigree

BENCHMARK_MAIN();
