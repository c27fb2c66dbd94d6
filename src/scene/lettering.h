// A small alphabet of single strokes, for labels in pictures: printable ASCII, and a box for all else.
//
// Drawn on a grid with 20 units to a capital's height; strokes are lines and elliptic arcs, widths are
// proportional and there is no kerning, so that widths add up. As polygons, letters are shapes that every
// format can write and that look the same everywhere; as strokes, a pen can follow them.
#pragma once

#include <string_view>
#include <vector>

#include "plane/path.h"
#include "plane/polygon.h"

namespace filigree {

struct LetteringStyle {
    double height = 10;  // px, of a capital, from the middle of a stroke to the middle of another
    double pen = 1;      // px
};

// How far strokes reach above and below the baseline, in capitals.
constexpr double lettering_ascent = 1.15;
constexpr double lettering_descent = 0.3;

// The strokes of a line of text. `at` is the left end of its baseline; y grows downwards. No strokes for a
// height that is not above 0. A byte that is no UTF-8 is drawn as a character that the alphabet lacks.
std::vector<Polyline> lettering_strokes(std::string_view utf8, Vec at, double height);

// How far a text moves the pen: each character takes a box of its own width, and its strokes lie inside it.
double lettering_width(std::string_view utf8, double height);

// The strokes drawn with a round pen, as clean polygons.
Polygons lettering(std::string_view utf8, Vec at, const LetteringStyle& style);

}  // namespace filigree
