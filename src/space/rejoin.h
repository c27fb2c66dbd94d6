// Pieces in painter's order made whole again where the picture stays the same: most cuts divide what nothing comes
// between.
//
// A cut piece takes the place of its parts where one of them can be painted together with another, earlier or later,
// since nothing that is painted in between overlaps it in the picture. Overlaps are found on a grid; where too much
// lies in between the parts stay. Of what is not convex, or is a line of several stretches, the hull counts.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plane/point.h"
#include "space/painters_order.h"

namespace filigree {

// `places` has where each of Pieces::corners lies in the picture, `widths` how wide the line of each piece is drawn
// there (0 of polygons). Both in px.
std::vector<std::uint32_t> rejoined(const Pieces& pieces, std::span<const std::uint32_t> order,
                                    std::span<const Vec> places, std::span<const double> widths);

}  // namespace filigree
