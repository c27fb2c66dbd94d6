// The search for subshapes in designs of 10^4 to 10^6 parabola arcs, in one thread.
//   index    making a design of random arcs ready
//   field    six arcs in a field of random ones, one copy planted for each 200 arcs, each in longer arcs
//   flowers  a petal in flowers of four arcs, where every arc may carry either arc of the petal in both senses
//   again    the same after a petal was drawn out of its flower, or put back, from what was found before
// Each case first checks how many matches there are: a faster wrong answer fails.
#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "base/test_cases.h"
#include "curves/along.h"
#include "curves/curve_test_shapes.h"
#include "curves/kept_matches.h"

namespace filigree::curves {
namespace {

using test_shapes::flower;
using test_shapes::petal;
using test_shapes::shape_of;

constexpr double tolerance = 1e-6;

Vec point_in(CaseRandom& draws, double size) { return {draws.between(0, size), draws.between(0, size)}; }

Transform similarity_in(CaseRandom& draws, double size) {
    const Vec to = point_in(draws, size);
    const double scale = draws.between(0.5, 2), flip = draws.coin() ? 1 : -1;
    return compose(translation(to), compose(rotation_degrees(draws.between(0, 360)), scaling(scale, flip * scale)));
}

Element random_arc(CaseRandom& draws, double size) {
    const Vec at = point_in(draws, size);
    return parabola_element(at, at + point_in(draws, 12) - Vec{6, 6}, at + point_in(draws, 12) - Vec{6, 6});
}

Shape six_arcs() {
    CaseRandom draws(6);
    std::vector<Element> arcs;
    for (int i = 0; i < 6; ++i) arcs.push_back(random_arc(draws, 12));
    return shape_of(arcs);
}

Shape field(std::size_t count, std::size_t copies) {
    CaseRandom draws(count);
    const double size = 6 * std::sqrt(static_cast<double>(count));
    const Shape left = six_arcs();
    std::vector<Element> arcs;
    for (std::size_t i = 0; i < copies; ++i) {
        const Transform by = similarity_in(draws, size);
        for (const Element& e : left.elements) {
            arcs.push_back(piece_of(transformed(e, by), {-draws.between(0, 0.2), 1 + draws.between(0, 0.2)}));
        }
    }
    while (arcs.size() < count) arcs.push_back(random_arc(draws, size));
    return shape_of(arcs);
}

Shape flowers(std::size_t count) {
    CaseRandom draws(count);
    const auto columns = static_cast<std::size_t>(std::sqrt(static_cast<double>(count) / 4));
    std::vector<Element> arcs;
    for (std::size_t i = 0; i < count / 4; ++i) {
        const Vec at{12 * static_cast<double>(i % columns), 12 * static_cast<double>(i / columns)};
        const double scale = draws.between(0.5, 1);
        const Transform by =
            compose(translation(at), compose(rotation_degrees(draws.between(0, 360)), scaling(scale, scale)));
        for (const Element& e : flower().elements) arcs.push_back(transformed(e, by));
    }
    return shape_of(arcs);
}

void check(benchmark::State& state, const Matches& matches, std::size_t expected) {
    if (matches.found.size() == expected) return;
    state.SkipWithError((std::to_string(matches.found.size()) + " matches").c_str());
}

void detect_index(benchmark::State& state) {
    const Shape design = field(static_cast<std::size_t>(state.range(0)), 0);
    for (auto _ : state) benchmark::DoNotOptimize(MatchIndex(design, tolerance));
}

void detect_field(benchmark::State& state) {
    const auto count = static_cast<std::size_t>(state.range(0));
    const Shape left = six_arcs();
    const MatchIndex design(field(count, count / 200), tolerance);
    check(state, find_matches(left, design, {}), count / 200);
    for (auto _ : state) benchmark::DoNotOptimize(find_matches(left, design, {}));
}

void detect_flowers(benchmark::State& state) {
    const auto count = static_cast<std::size_t>(state.range(0));
    const MatchIndex design(flowers(count), tolerance);
    check(state, find_matches(petal(), design, {}), count);
    for (auto _ : state) benchmark::DoNotOptimize(find_matches(petal(), design, {}));
}

// The index brought up to date, and the matches.
void detect_again(benchmark::State& state) {
    const auto count = static_cast<std::size_t>(state.range(0));
    const Shape design = flowers(count);
    MatchIndex index(design, tolerance);
    KeptMatches kept(petal(), index, {});
    const Match& one = kept.found()[count / 2];
    std::vector<Element> whole, cut;
    for (const std::uint32_t slot : one.carriers) whole.push_back(design.elements[slot]);
    for (std::size_t i = 0; i < 2; ++i) {
        const Element part = transformed(petal().elements[i], one.by);
        const auto on = along(whole[i], part, tolerance)->on;
        cut.push_back(*normal_form(transformed(part, translation({0.5, 0.25})), tolerance));
        // The rest of the arc, before the petal's part of it or behind.
        const Interval rest = on.from > 1 - on.to ? Interval{0, on.from} : Interval{on.to, 1};
        cut.push_back(*normal_form(piece_of(whole[i], rest), tolerance));
    }
    const auto step = [&](bool opens) {
        const auto change = opens ? index.update(whole, cut) : index.update(cut, whole);
        kept.update(index, change);
    };
    step(true);
    // The petal itself is still there, its two neighbours are not.
    if (kept.found().size() != count - 2) state.SkipWithError("not the matches of an open flower");
    step(false);
    if (kept.found().size() != count) state.SkipWithError("not the matches of all flowers");
    bool opens = true;
    for (auto _ : state) {
        step(opens);
        opens = !opens;
    }
}

BENCHMARK(detect_index)->Name("detect/index")->Arg(10000)->Arg(100000)->Arg(1000000)->Unit(benchmark::kMillisecond);
BENCHMARK(detect_field)->Name("detect/field")->Arg(10000)->Arg(100000)->Arg(1000000)->Unit(benchmark::kMillisecond);
BENCHMARK(detect_again)->Name("detect/again")->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond);
BENCHMARK(detect_flowers)->Name("detect/flowers")->Arg(10000)->Arg(100000)->Arg(1000000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace filigree::curves

BENCHMARK_MAIN();
