// Reading SVG: shapes as paths, labels, how they are grouped, and the document that an exported SVG carries.
//
// Understood: path, rect (with rx, ry), circle, ellipse, line, polyline, polygon; g, svg (nested, viewBox,
// preserveAspectRatio), use, symbol, a, switch, defs; transform lists; width, height and units (mm, cm, in,
// pt, pc, px, %); fill, fill-rule, stroke, stroke-width, display, visibility as attributes, in style="" and in
// <style> sheets with type, class, id and universal selectors. Opacities are not looked at. Left out with a warning:
// text where areas are wanted, image, clip paths and masks, filters. External references are refused: nothing is ever
// read from outside the given bytes. Limits (Fault::limit): 200 levels, 10^6 elements after `use` is expanded, 5 * 10^7
// points.
//
// Conventions: the root's width, height and view box give the scale to px (96 an inch), not a shift: shapes lie
// where the view box's coordinates put them, and `origin` is where the viewport's corner then is. Without width
// and height the view box is in px; without a view box too, 300 x 150 px. What is wrong with a shape is an error,
// and as many of them are reported as were found.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/colour.h"
#include "base/result.h"
#include "formats/svg_write.h"
#include "plane/clean.h"
#include "plane/path.h"

namespace filigree {

// What stands around others: g, svg, symbol, a, switch, use.
struct SvgGroup {
    std::string id, label;  // its own and Inkscape's name for it, or empty
    bool is_layer = false;  // of Inkscape
    std::optional<std::size_t> parent;
    SourceSpan span;
};

struct SvgShape {
    std::string id, label;  // its own and Inkscape's name for it, or empty
    // What the groups around it are called, outermost first: an Inkscape layer by its label and then its id, any
    // other by its id, else its label. A `use` is a group around what it shows.
    std::vector<std::string> groups;
    std::optional<std::size_t> group;  // the innermost, of SvgPicture::groups
    Path path;                         // px, all transforms applied
    FillRule fill_rule = FillRule::nonzero;
    bool filled = true;            // `fill` is neither none nor transparent, and it is no line
    std::optional<Colour> stroke;  // none where it is `none`, transparent or has no width; black for gradients
    double stroke_width = 0;       // px; where transforms stretch, the mean of all directions; 0 without a stroke
};

struct SvgLabel {  // a `text`
    std::string text;
    std::string id, label;            // as of shapes
    std::vector<std::string> groups;  // as of shapes
    std::optional<std::size_t> group;
    Vec place;  // px, where its first letter's tspan, else the text, says
};

struct SvgPicture {
    Vec origin;                    // px, of the viewport
    Vec size;                      // px
    std::vector<SvgShape> shapes;  // in painting order; what is not displayed is left out
    std::vector<SvgLabel> labels;  // likewise; those that say something
    std::vector<SvgGroup> groups;  // each behind the one around it; the empty ones, too
};
// What a file is read for: areas, or a drawing in which strokes and texts mean something, too. It decides whether texts
// become labels and which warnings there are.
enum class SvgPurpose { areas, drawing };
// Spans of diagnostics point into source `file` of the caller (byte offsets in `svg`).
Result<SvgPicture> read_svg(std::string_view svg, std::uint32_t file = 0, SvgPurpose purpose = SvgPurpose::areas);

// The document that an SVG of ours carries; none where there is none. Refused if it is damaged.
Result<std::optional<CarriedDocument>> carried_document(std::string_view svg, std::uint32_t file = 0);

}  // namespace filigree
