// Perturbation: drawn lines waver as a hand does, and neighbours stay neighbours (gTangle, section 4.3).
//
// Shapes are welded, so that both sides of a border have the same vertices; long edges get more of them, decided
// by the edge alone; and every vertex is moved once, by coherent noise of its place. Where shapes of different
// amplitude meet, the least counts, and where wavelengths differ, the longest; both change gradually from there.
// Corners that two edges form alone are softened a little.
//
// Guarantees: what was shared is shared; no ring crosses itself or another and no two faces overlap, if none did
// before (vertices of edges that would cross are moved less, in the end not at all); so the faces' areas add up to
// that of the perturbed outline. No vertex moves by more than its amplitude, corners up to twice as far. The seed,
// the shapes and their wobbles as sets decide: not their order.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "plane/polygon.h"

namespace filigree {

struct Wobble {
    double amplitude = 0;    // px: how far a line leaves its place at most; no more than a twentieth of the wavelength
    double wavelength = 60;  // px: from crest to crest

    bool operator==(const Wobble&) const = default;
};
constexpr double shortest_wave = 1;  // px; shorter ones count as that
// Of faces that hold no other back: they move as their neighbours do.
constexpr Wobble follows_neighbours{std::numeric_limits<double>::infinity(), 60};

struct WobblyShapes {
    Polygons polygons;
    std::vector<Wobble> wobbles;  // one a polygon
};

struct PerturbInput {
    WobblyShapes faces;    // do not overlap; may touch
    WobblyShapes borders;  // run along the faces' borders and follow them; theirs counts where there is no face
    WobblyShapes marks;    // lie on top and share nothing with others
    std::uint64_t seed = 0;
};

struct Perturbed {  // the same polygons in the same order, with more points
    Polygons faces, borders, marks;
};

// O(points log points), with points counted after new ones came. Points must lie on the plane.
Perturbed perturb(const PerturbInput& input);

}  // namespace filigree
