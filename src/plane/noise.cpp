#include "plane/noise.h"

#include <cmath>

#include "base/random.h"

namespace filigree {
namespace {

// Lattices a half and some quarter of the wavelength wide, turned by 17 and by 52 degrees and moved off the origin.
constexpr double coarse_density = 2, fine_density = 3.7;
constexpr double fine_share = 0.2;
constexpr double gain = 2.5;  // before what is long is bent to stay below 1
constexpr double farthest = 0x1p50;
constexpr Vec coarse_axis{0.95630475596303548, 0.29237170472273677};
constexpr Vec fine_axis{0.61566147532565829, 0.78801075360672190};
constexpr Vec coarse_offset{0.371, 0.729}, fine_offset{0.583, 0.217};

constexpr Vec turned(Vec v, Vec axis) { return {dot(v, axis), cross(axis, v)}; }

// Its derivatives up to the second are 0 at 0 and 1.
constexpr double fade(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }
constexpr double mixed(double a, double b, double t) { return a + t * (b - a); }
constexpr Vec mixed(Vec a, Vec b, double t) { return a + t * (b - a); }

// Of places that are not too far away; without a call, as std::floor is one on many machines.
constexpr std::int64_t floor_of(double v) {
    const auto whole = static_cast<std::int64_t>(v);
    return whole - (v < static_cast<double>(whole) ? 1 : 0);
}

// 16 bits to -1..1.
constexpr double signed_unit(std::uint64_t bits) { return static_cast<double>(bits & 0xFFFF) * (2.0 / 65535) - 1; }

}  // namespace

NoiseField::NoiseField(std::uint64_t seed) : seed_(mix(seed)), coarse_(window * window), fine_(window * window) {}

Vec NoiseField::octave(Cells& cells, std::uint64_t seed, Vec place) {
    const std::int64_t column = floor_of(place.x), row = floor_of(place.y);
    Cell& cell = cells[static_cast<std::size_t>(row) % window * window + static_cast<std::size_t>(column) % window];
    if (cell.column != column || cell.row != row) {
        cell.column = column;
        cell.row = row;
        std::uint64_t of_column[2], of_row[2];  // a corner's bits are fold(fold(seed, column), row)
        for (std::int64_t i = 0; i < 2; ++i) {
            of_column[i] = fold(seed, static_cast<std::uint64_t>(column + i));
            of_row[i] = mix(static_cast<std::uint64_t>(row + i));
        }
        for (std::size_t corner = 0; corner < 4; ++corner) {
            const std::uint64_t bits = mix(of_column[corner & 1] ^ of_row[corner >> 1]);
            cell.x[corner] = {signed_unit(bits), signed_unit(bits >> 32)};
            cell.y[corner] = {signed_unit(bits >> 16), signed_unit(bits >> 48)};
        }
    }
    const Vec in{place.x - static_cast<double>(column), place.y - static_cast<double>(row)};
    const double u = fade(in.x), v = fade(in.y);
    const auto part = [&](std::size_t corner, double x, double y) { return cell.x[corner] * x + cell.y[corner] * y; };
    return mixed(mixed(part(0, in.x, in.y), part(1, in.x - 1, in.y), u),
                 mixed(part(2, in.x, in.y - 1), part(3, in.x - 1, in.y - 1), u), v);
}

Vec NoiseField::at(Vec place) {
    if (!(std::fabs(place.x) < farthest && std::fabs(place.y) < farthest)) return {};
    const Vec coarse = octave(coarse_, seed_, coarse_density * turned(place, coarse_axis) + coarse_offset);
    const Vec fine = octave(fine_, ~seed_, fine_density * turned(place, fine_axis) + fine_offset);
    const Vec sum = gain * (coarse + fine_share * fine);
    return sum * (1 / std::sqrt(1 + dot(sum, sum)));
}

double noise_along(std::uint64_t seed, double place) {
    if (!(std::fabs(place) < farthest)) return 0;
    const std::int64_t start = floor_of(place);
    const double in = place - static_cast<double>(start);
    const auto gradient = [&](std::int64_t at) { return signed_unit(fold(seed, static_cast<std::uint64_t>(at))); };
    return 2 * mixed(gradient(start) * in, gradient(start + 1) * (in - 1), fade(in));
}

}  // namespace filigree
