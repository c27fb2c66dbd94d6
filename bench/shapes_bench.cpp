// The algebra of curved shapes on fields of curves, in one thread.
//   maximal/N          N pieces of parabolas, lines, arcs and cubics, four to a curve, that overlap or touch
//   maximal_again/N    the same of what is maximal already
//   sum/N, difference/N, product/N, is_part_of/N    of shapes of N elements that have a half in common
//   replaced/N         one rule application in a design of N elements, all of its cost but the copy of the design
//   derivation/N       a thousand of them, one behind the other
// Each case first checks what comes out: a faster wrong answer fails.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <string>
#include <vector>

#include "base/test_cases.h"
#include "curves/algebra.h"

namespace filigree::curves {
namespace {

constexpr double tolerance = 1e-6;
constexpr double spacing = 10;

// One of each kind in turn, near the place that belongs to its number.
Element curve_at(std::size_t number, std::size_t columns) {
    CaseRandom random(number + 1);
    const Vec place{spacing * static_cast<double>(number % columns), spacing * static_cast<double>(number / columns)};
    const auto near = [&] { return place + Vec{random.between(-8, 8), random.between(-8, 8)}; };
    const Vec p = near(), q = near(), r = near(), s = near();
    switch (number % 4) {
        case 0:
            return line_element(p, q);
        case 1:
            return arc_element(p, {random.between(2, 6), 0}, {0, random.between(2, 6)}, 0, random.between(2, 6));
        case 2:
            return number % 8 == 2 ? cubic_element(p, q, r, s) : parabola_element(p, q, r);
        default:
            return parabola_element(p, q, r);
    }
}

std::size_t columns_of(std::size_t count) {
    std::size_t columns = 1;
    while (columns * columns < count) ++columns;
    return columns;
}

std::vector<Element> field(std::size_t first, std::size_t count, std::size_t columns) {
    std::vector<Element> curves;
    for (std::size_t i = first; i < first + count; ++i) curves.push_back(curve_at(i, columns));
    return curves;
}

std::vector<Element> cut(const std::vector<Element>& curves) {
    std::vector<Element> pieces;
    for (const Element& e : curves) {
        const Interval on = interval_of(e);
        const auto at = [&](double share) { return on.from + (on.to - on.from) * share; };
        for (const auto& [from, to] :
             {std::pair(0.0, 0.3), std::pair(0.3, 0.6), std::pair(0.75, 0.5), std::pair(1.0, 0.7)}) {
            pieces.push_back(piece_of(e, {at(from), at(to)}));
        }
    }
    return pieces;
}

void make_maximal(benchmark::State& state) {
    const auto count = static_cast<std::size_t>(state.range(0)) / 4;
    const std::vector<Element> curves = field(0, count, columns_of(count)), pieces = cut(curves);
    const Shape wanted = maximal(curves, tolerance);
    const Shape found = maximal(pieces, tolerance);
    if (found.elements.size() != wanted.elements.size()) return state.SkipWithError("not the curves that were cut");
    if (!are_equal(found, wanted, tolerance)) return state.SkipWithError("not equal to the curves that were cut");
    for (auto _ : state) benchmark::DoNotOptimize(maximal(pieces, tolerance));
}

void make_maximal_again(benchmark::State& state) {
    const auto count = static_cast<std::size_t>(state.range(0));
    const Shape shape = maximal(field(0, count, columns_of(count)), tolerance);
    if (maximal(shape.elements, tolerance) != shape) return state.SkipWithError("not its own maximal shape");
    for (auto _ : state) benchmark::DoNotOptimize(maximal(shape.elements, tolerance));
}

struct Two {
    Shape a, b, common;
};
Two two_shapes(std::size_t count) {
    const std::size_t columns = columns_of(2 * count);
    return {maximal(field(0, count, columns), tolerance), maximal(field(count / 2, count, columns), tolerance),
            maximal(field(count / 2, count - count / 2, columns), tolerance)};
}

void add(benchmark::State& state) {
    const Two two = two_shapes(static_cast<std::size_t>(state.range(0)));
    if (!is_part_of(two.a, sum(two.a, two.b, tolerance), tolerance)) return state.SkipWithError("a part is lost");
    for (auto _ : state) benchmark::DoNotOptimize(sum(two.a, two.b, tolerance));
}
void subtract(benchmark::State& state) {
    const Two two = two_shapes(static_cast<std::size_t>(state.range(0)));
    const Shape back = sum(difference(two.a, two.b, tolerance), two.common, tolerance);
    if (!are_equal(back, two.a, tolerance)) return state.SkipWithError("the difference is another one");
    for (auto _ : state) benchmark::DoNotOptimize(difference(two.a, two.b, tolerance));
}
void multiply(benchmark::State& state) {
    const Two two = two_shapes(static_cast<std::size_t>(state.range(0)));
    if (!are_equal(product(two.a, two.b, tolerance), two.common, tolerance)) return state.SkipWithError("another one");
    for (auto _ : state) benchmark::DoNotOptimize(product(two.a, two.b, tolerance));
}
void compare(benchmark::State& state) {
    const Two two = two_shapes(static_cast<std::size_t>(state.range(0)));
    if (is_part_of(two.a, two.b, tolerance)) return state.SkipWithError("no part");
    for (auto _ : state) benchmark::DoNotOptimize(is_part_of(two.common, two.a, tolerance));
}

// A design and, of the n-th curve, a rule that moves half of it.
struct Moves {
    Shape design;
    std::vector<Shape> left, right;
};
Moves moves_in(std::size_t count) {
    Moves moves;
    const std::size_t columns = columns_of(count);
    moves.design = maximal(field(0, count, columns), tolerance);
    for (std::size_t i = 0; i < 1000; ++i) {
        const Element e = curve_at(i * 7919 % count, columns);
        const Interval on = interval_of(e);
        const Element half = piece_of(e, {on.from, 0.5 * (on.from + on.to)});
        moves.left.push_back(maximal({half}, tolerance));
        moves.right.push_back(maximal({transformed(half, translation({0.25, 0.5}))}, tolerance));
    }
    return moves;
}

void replace(benchmark::State& state) {
    Moves moves = moves_in(static_cast<std::size_t>(state.range(0)));
    const Shape start = moves.design;
    std::size_t i = 0;
    for (auto _ : state) {
        const std::size_t at = i++ % moves.left.size();
        const Change change = change_by(moves.design, moves.left[at], moves.right[at], tolerance);
        apply(change, moves.design);
        state.PauseTiming();
        apply(inverse(change), moves.design);
        state.ResumeTiming();
    }
    if (moves.design != start) state.SkipWithError("not where it began");
}

void derive(benchmark::State& state) {
    const Moves moves = moves_in(static_cast<std::size_t>(state.range(0)));
    for (auto _ : state) {
        Shape design = moves.design;
        for (std::size_t i = 0; i < moves.left.size(); ++i) {
            design = replaced(std::move(design), moves.left[i], moves.right[i], tolerance);
        }
        if (design == moves.design) return state.SkipWithError("nothing has changed");
    }
}

BENCHMARK(make_maximal)->Name("maximal")->Arg(10'000)->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK(make_maximal_again)->Name("maximal_again")->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK(add)->Name("sum")->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK(subtract)->Name("difference")->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK(multiply)->Name("product")->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK(compare)->Name("is_part_of")->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK(replace)->Name("replaced")->Arg(10'000)->Arg(100'000)->Unit(benchmark::kMillisecond);
BENCHMARK(derive)->Name("derivation")->Arg(10'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace filigree::curves

BENCHMARK_MAIN();
