// Elliptic arcs as SVG can say them with rounded numbers; inner part of path data.
//
// An arc that turns by nearly a half moves by the square root of what its ends or radii are rounded by, and one that
// turns by nearly a whole turns about its ends. So what comes of the rounded numbers is asked, and where it lies off
// the arc by more than one and a half units, the arc is said in two, four or eight pieces. For very thin ellipses that
// does not help, either.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "plane/arc.h"

namespace filigree {

struct RoundedArc {
    std::int64_t rx = 0, ry = 0;  // units of 10^-decimals
    double rotation = 0;          // degrees
    bool is_large = false, is_sweep = false;
    Point to;  // units
};

// What to write for an arc that is no line, where the path stands at `at` (units): as a rule one arc; none where it
// must be said by other curves. `rotation` is as Verb::arc has it. All points must lie on the plane.
std::optional<std::vector<RoundedArc>> rounded_arcs(const CentreArc& arc, double rotation, Vec to, Point at,
                                                    int decimals);

}  // namespace filigree
