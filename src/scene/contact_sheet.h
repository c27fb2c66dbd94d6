// Many drawings side by side on one sheet, each with its label: variations to choose from.
//
// Every drawing's canvas is fitted into a square of the same size, so that equal canvases have equal scales, and
// centred in a box of its own; the boxes are no larger than the canvases need. Labels stand below in the letters
// of lettering.h and are cut where they are too long. What reaches beyond a canvas is cut off.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/drawing.h"

namespace filigree {

struct SheetCell {
    const Drawing* drawing = nullptr;  // none leaves the place empty
    std::string label;
};

struct SheetOptions {
    std::uint32_t columns = 0;  // 0: as many as rows, or one more
    double cell = 240;          // px, the side of the square
    double gap = 28;            // px, between boxes; the margin is twice as wide
    std::string title;
    double label_height = 9;  // px, of a capital; the title is half as large again
};

// Pens are scaled too, but none to less than this.
constexpr double thinnest_sheet_pen = 0.35;  // px

// On white paper, the canvas from (0, 0) on in whole px. The group of cell number 3 has the path "3". Lengths
// must be above 0.
Drawing contact_sheet(const std::vector<SheetCell>& cells, const SheetOptions& options);

}  // namespace filigree
