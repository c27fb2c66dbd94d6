// Text as outlines: what the letters of a font draw, shaped and set in lines.
//
// A line is ordered by the Unicode bidirectional algorithm (each line is a paragraph; its first strong letter says
// the direction), cut into runs of one script, and shaped by HarfBuzz: ligatures, kerning, marks and joined letters
// come out as the font wants them. Outlines are read in the font's own units, without hinting, and scaled in doubles
// here, so that the same font and text give the same curves on every machine.
//
// Coordinates: px, y downwards; the first line's baseline is y = 0, each line lies one line height below the last;
// lines start (left), are centred (centre) or end (right) at x = 0. Contours may overlap: fill them nonzero.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "plane/path.h"

namespace filigree {

enum class TextAlign : std::uint8_t { left, centre, right };

struct TextOptions {
    double line_height = 1.2;  // from baseline to baseline, in sizes
    TextAlign align = TextAlign::left;
    // px more after each letter but a line's last; other than 0, ligatures that are a matter of taste are left out.
    // Letters of scripts that join, like Arabic, stay together.
    double letter_spacing = 0;
};

// A letter as people see it: with its marks, or several in one where the font has a ligature.
struct Glyph {
    Path path;              // closed subpaths: lines, quadratic or cubic curves
    std::size_t begin = 0;  // byte offset of its text
    std::string text;       // of the letter
};

// In the order of drawing: lines from the top, in a line from left to right. What draws nothing (spaces) is left
// out. `size` is px an em, in (0, 1e6].
//
// `font` is TrueType or OpenType (glyf, CFF or CFF2; of a variable font its default, of a collection its first). A
// font that is cut off or broken is an error, before any shaping. Characters that the font lacks leave a gap as wide
// as its sign for them and a warning that names them. At most 100,000 bytes of text (Fault::limit).
Result<std::vector<Glyph>> text_outlines(std::string_view font, std::string_view text, double size,
                                         const TextOptions& options = {});

}  // namespace filigree
