// Planar rings in space as convex parts.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/job.h"
#include "space/vector.h"

namespace filigree {

struct ConvexParts {
    std::vector<std::uint32_t> corners;  // of all parts: indices into the ring, in its direction
    std::vector<std::uint32_t> ends;     // one past each part's last corner
    bool is_whole = true;                // whether the parts cover just what the ring encloses
};

// The ring itself where it is convex and no corner is farther than `flat` from its plane. Else triangles by clipping
// ears, with exact decisions on coordinates rounded to 2^-30 of the ring's extent; where the ring is not planar they
// span it all the same, and where it crosses itself they cover some of it; then it is not whole. Cost: linear for
// convex rings, for others at worst the square of the number of corners. Where the job is cancelled, some parts are
// left out.
ConvexParts convex_parts(std::span<const Vec3> ring, double flat, const Job& job = {});

}  // namespace filigree
