// Drawings as SVG: one `<path>` a shape, one `<g data-path>` a step, the document that made it in the metadata.
//
// Guarantee: the same drawing gives the same bytes. Coordinates are written relative, as whole multiples of
// 10^-decimals; a path's rounding never adds up (each step is the difference of rounded absolutes). Curves are written
// by their own commands.
//
// Conventions: a group whose shapes all look alike says so once, for plotter tools as presentation attributes
// and never as a style sheet; else each path does. A shape's id is `s` and the first eight digits of its key; where two
// meet in one file, the later ones get -2, -3, ... The background is a `<rect id="background">`.
#pragma once

#include <string>
#include <vector>

#include "scene/drawing.h"

namespace filigree {

// A document that travels inside an SVG, with the files that it read.
struct CarriedFile {
    std::string name;  // as the document names it
    std::string bytes;

    bool operator==(const CarriedFile&) const = default;
};
struct CarriedDocument {
    CarriedFile document;
    std::vector<CarriedFile> inputs;

    bool operator==(const CarriedDocument&) const = default;
};

struct SvgOptions {
    int decimals = 3;  // digits after the point, 0..6
    // No groups, ids or paths: opaque shapes of one style in a row become one path, but for filled curves. Where shapes
    // of one group that are both filled and stroked overlap, all their strokes show.
    bool lean = false;
    const CarriedDocument* carried = nullptr;  // put into the metadata if given
    std::string title;                         // of the document; none if empty
};
std::string to_svg(const Drawing& drawing, const SvgOptions& options);

}  // namespace filigree
