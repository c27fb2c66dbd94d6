// What `symmetry NAME` and `page tile W x H` make of a drawing: its copies, over the page (docs/decisions/0010).
#pragma once

#include "base/job.h"
#include "base/result.h"
#include "derivation/plane_start.h"
#include "language/settings.h"
#include "scene/drawing.h"

namespace filigree {

// `motif` grew from `start`, whose symmetry must be set; its canvas counts only for whether files are in mm and for the
// margin of a page that fits. Warns of what a tile cannot have. Fault::limit above the document's limit of elements.
Result<Drawing> repeated_over_page(const Drawing& motif, const PlaneStart& start, const Settings& settings,
                                   const Job& job);

}  // namespace filigree
