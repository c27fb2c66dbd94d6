// Drawings as PNG, drawn by Cairo; curves as such. The same drawing and scale give the same bytes.
#pragma once

#include <string>

#include "base/job.h"
#include "base/result.h"
#include "scene/drawing.h"

namespace filigree {

struct PngOptions {
    double scale = 2;  // pixels a px: 1 is 96 dpi
    Job job = {};      // its progress is not reported
};
// Refused (Fault::limit) above 32,000 pixels a side or 400 million in all, and where scale or canvas are not
// above 0. Without a background of the canvas the paper is white; a translucent one stays so.
Result<std::string> to_png(const Drawing& drawing, const PngOptions& options);

}  // namespace filigree
