// Coherent noise: values that wander smoothly from place to place, as a hand does (after Perlin, 1985).
//
// Gradient noise over a square lattice whose gradients are hashes of the lattice point (base/random.h), so a
// place's value depends on the seed and the place alone and never repeats. Two sizes of waves on lattices turned
// against each other, so that neither axes nor lattice points show.
#pragma once

#include <cstdint>
#include <vector>

#include "plane/point.h"

namespace filigree {

// A field of vectors shorter than 1, half as long on the whole. For many places near one another keep one of these:
// it remembers the lattice cells that it was last asked about.
class NoiseField {
public:
    explicit NoiseField(std::uint64_t seed);

    // `place` in wavelengths: crests are about 1 apart, and the value changes by some 4 a wavelength, nowhere by
    // more than 16. Any finite place; one beyond 2^50 has no noise.
    Vec at(Vec place);

private:
    struct Cell {  // of a lattice, with the gradients of two fields at its corners: their x side by side, and their y
        std::int64_t column = INT64_MIN, row = 0;
        Vec x[4], y[4];
    };
    // A window of so many columns and rows is remembered wherever it lies, each cell in its own place.
    static constexpr std::size_t window = 16;
    using Cells = std::vector<Cell>;
    static Vec octave(Cells& cells, std::uint64_t seed, Vec place);

    std::uint64_t seed_;
    Cells coarse_, fine_;
};

// Noise along a line, in -1..1, for a place in wavelengths.
double noise_along(std::uint64_t seed, double place);

}  // namespace filigree
