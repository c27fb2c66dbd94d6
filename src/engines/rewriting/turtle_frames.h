// Frames in space, and how they turn.
#pragma once

#include "base/elementary.h"
#include "engines/rewriting/turtle.h"

namespace filigree::rewriting {

enum class Axis : std::uint8_t { up, left, heading };

// Counterclockwise as seen against the axis. Quarter turns of the world's axes are exact, and no number is -0.
Frame turned(const Frame& frame, Axis axis, elementary::CosSin by);

// Of a frame that is nearly so: the direction of the heading is kept, left and up give way.
Frame orthonormal(const Frame& frame);

constexpr Frame frame_along_x{};
constexpr Frame frame_along_y{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}};
constexpr Frame frame_along_z{{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}};

}  // namespace filigree::rewriting
