// Pieces in painter's order made whole again where the picture stays the same: most cuts divide what nothing comes
// between.
//
// A cut piece takes the place of its parts where one of them can be painted together with the others, as early as the
// first or as late as the last, since nothing that is painted in between overlaps it in the picture. Where too much
// lies in between to look at, the parts stay. Of what is not convex, or is a line of several stretches, the hull
// counts.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "space/picture_hulls.h"

namespace filigree {

std::vector<std::uint32_t> rejoined(const Pieces& pieces, std::span<const std::uint32_t> order,
                                    const PictureHulls& hulls);

}  // namespace filigree
