// How far a family goes, from the room that its parts have on their carriers.
#pragma once

#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "curves/family.h"

namespace filigree::curves {

// A carrier that a part may have; no room where it does not bound the family.
struct Berth {
    std::uint32_t slot = 0;
    std::optional<Room> room;
};

struct RangeLimits {
    double least_growth = 0, most_growth = std::numeric_limits<double>::infinity();
    double px_per_move = 1;  // how far the farthest part goes; 1 of slides
    double slack = 0;        // px: nearer to the centre of growth than this is at it
};

struct Range {
    Interval moves, growth{1, 1};
    double gap = 0;  // px: how much room the parts lack; negative where they can move
};

// By the family's kind and rooms.
Range range_of(const Family& family, const RangeLimits& limits);

// Slides or turns, and growths, of members to choose from: at both ends, in the middle, as large as may be, as large as
// it was drawn.
std::vector<std::pair<double, double>> chosen_members(const Family& family, const RangeLimits& limits);

}  // namespace filigree::curves
