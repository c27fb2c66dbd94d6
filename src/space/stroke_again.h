// Which strokes along edges have to be painted again, since something that is painted later lies beside them.
//
// A stroke lies half outside its face. What touches the edge there, or goes on behind it, may well be painted later and
// covers that half; what hides the edge itself covers the stroke by right.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "space/picture_hulls.h"

namespace filigree {

struct StrokeAgain {
    std::uint32_t place = 0;  // of the order: right behind what is painted there
    std::uint32_t piece = 0;  // whose edge it is
    std::vector<Vec> line;
};

// Sorted by their places. `strokes` says of each of Pieces::corners how wide the stroke that goes on from it is, with
// what a seam beside it would take, and 0 where there is none. What is stroked along the same edge itself, as a
// neighbour, covers nothing.
std::vector<StrokeAgain> strokes_again(const Pieces& pieces, std::span<const std::uint32_t> order,
                                       std::span<const Vec> places, const PictureHulls& hulls,
                                       std::span<const double> strokes);

}  // namespace filigree
