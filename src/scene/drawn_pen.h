// Lines as a fineliner draws them by hand: strokes with ends, pressed a little more or less on the way.
//
// Borders come as the edges of a map, each once; edges that go on from each other are one stroke, through crossings
// too, so neighbours have one common line. A stroke goes a little too far or not quite far enough, and one that
// should close misses its start or runs past it. It becomes an ordinary polygon.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/random.h"
#include "plane/border_map.h"

namespace filigree {

struct PenPath {
    std::vector<std::uint32_t> vertices;  // of the map; a closed one comes back to its first, which is not repeated
    std::vector<std::uint32_t> edges;     // along it
    bool is_closed = false;
};

constexpr std::uint32_t no_pen = UINT32_MAX;

// The strokes that draw the edges of a map: `pens` says with which pen each edge is drawn, if any. A stroke keeps
// its pen. The result depends on the edges at each vertex, not on their numbers, but for its order.
std::vector<PenPath> pen_paths(const BorderMap& map, std::span<const std::uint32_t> pens);

// The stroke along a line, `pen` px wide: a clean polygon, or several where a line lies over itself. What it does by
// chance depends on the key and the place along the line. Nothing for a line without length.
Polygons drawn_stroke(std::span<const Point> line, bool is_closed, double pen, Key key);

}  // namespace filigree
