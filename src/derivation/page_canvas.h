// Where the page of a document lies around what is drawn on it.
#pragma once

#include "base/result.h"
#include "language/settings.h"
#include "plane/polygon.h"
#include "scene/drawing.h"

namespace filigree {

// A page that fits lies around the box, any other one has its centre there. A warning where the box is larger than the
// page within its margins; `what` names in it what the box is of ("starts").
Canvas page_canvas(const Settings& settings, const Document& document, const Box& box, std::string_view what,
                   Diagnostics& warnings);

}  // namespace filigree
