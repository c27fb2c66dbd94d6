// A drawing as if drawn by hand: its lines waver, and pens press and miss a little.
//
// Perturbs the shapes of a drawing together (plane/perturb.h), and turns strokes that are to be drawn into filled
// polygons (scene/drawn_pen.h), so that every format can write the result as any other. A border that several
// shapes stroke is drawn once: by the last of them in the order of painting, or by the widest of one colour; where
// that one has an even stroke, by that. Shapes that waver lose their curves, and drawn strokes follow polygons.
#pragma once

#include <cstdint>
#include <vector>

#include "plane/perturb.h"
#include "scene/drawing.h"

namespace filigree {

struct HandStyle {
    Wobble wobble;
    bool has_drawn_line = false;

    bool is_plain() const { return !has_drawn_line && !(wobble.amplitude > 0); }
};

enum class HandRole : std::uint8_t {
    face,    // one of the shapes that divide up the plane among them
    border,  // painted along the borders of faces
    mark,    // lies on top of faces
};

struct HandShape {
    static constexpr std::uint32_t not_drawn = UINT32_MAX;

    std::uint32_t geometry = 0, polygon = 0;  // as in DrawnShape
    std::uint32_t shape = not_drawn;  // of Drawing::shapes; faces that are not drawn hold their neighbours' place
    HandRole role = HandRole::face;
    HandStyle style;
};

// `shapes` are all shapes of the drawing, each once, and faces that it leaves out. Strokes are painted over what
// both sides of them hold, below the overlay of the group that does. Nothing changes where all styles are plain.
void draw_by_hand(Drawing& drawing, const std::vector<HandShape>& shapes, std::uint64_t seed);

}  // namespace filigree
