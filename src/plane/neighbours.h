// Which polygons lie side by side: for colouring them, and for telling borders from edges of the whole.
#pragma once

#include <cstdint>
#include <vector>

#include "plane/polygon.h"

namespace filigree {

// Neighbours of each polygon, ascending: those that share a stretch of border with it, not a mere corner. Compressed
// rows: those of polygon i are to[starts[i]] .. to[starts[i + 1] - 1]. Vertices of one border need not be the same on
// both sides (they are welded first, weld.h). O(points log points).
struct Neighbours {
    std::vector<std::uint32_t> starts;
    std::vector<std::uint32_t> to;
};
Neighbours neighbours(const Polygons& polygons);

// A colour 0 .. colours - 1 for each polygon such that neighbours differ wherever the colours suffice: always with six,
// nearly always with four. Where they do not suffice, as few neighbours as can be seen from one polygon are alike.
std::vector<std::uint32_t> coloured(const Neighbours& neighbours, std::uint32_t colours);

}  // namespace filigree
