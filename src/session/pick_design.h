// The element of a design at a point, and the step that it came with.
#pragma once

#include "session/pick.h"

namespace filigree {

// The element that is drawn nearest, in the coordinates of the document's own drawing, px, within 3 px of it. `prefix`
// and `root`: of an embedded design.
std::optional<Picked> pick_element(const OpenedDocument& opened, const CheckedDocument& checked, const DesignRun& run,
                                   Key root, const std::string& prefix, Vec at);

}  // namespace filigree
