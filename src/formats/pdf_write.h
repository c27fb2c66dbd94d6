// Drawings as PDF: one page as large as the canvas, every shape a path, the document that made it as an attachment.
//
// Guarantee: the same drawing gives the same bytes, on any number of threads; no date is written. Coordinates are
// whole multiples of 10^-decimals px, as integers; one matrix scales them to the page and turns y upwards.
//
// Shapes are painted in the order of painting_steps(), by the even-odd rule; what does not change from one shape to
// the next is not said again. Curves are cubics. Where a translucent stroke lies on a fill, the fill shows through it,
// as in SVG.
#pragma once

#include <string>

#include "base/executor.h"
#include "formats/svg_write.h"
#include "scene/drawing.h"

namespace filigree {

struct PdfOptions {
    // Digits after the point, 0..6; fewer where a coordinate would not fit 32 bits.
    int decimals = 3;
    const CarriedDocument* carried = nullptr;  // attached if given
    std::string title;                         // of the document; none if empty
    Executor* executor = nullptr;              // writes and packs pieces of the page side by side if given
};
std::string to_pdf(const Drawing& drawing, const PdfOptions& options);

}  // namespace filigree
