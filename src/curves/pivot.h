// The element of a left side by which its transforms are found.
#pragma once

#include <cstdint>
#include <vector>

#include "curves/embedding.h"
#include "curves/frame.h"

namespace filigree::curves {

struct Pivot {
    std::uint32_t element = 0;
    ParabolaFrame frame;
    // How far each left element may be off its carrier, px, before the transform is mended by all of them.
    std::vector<double> reach;
};

Pivot pivot_at(const Embedding& embedding, std::uint32_t element);

// A place in the design's table where the pivot may lie.
struct Seat {
    std::uint32_t slot = 0;
    bool is_reflected = false;
};
// All seats of a pivot, and roughly how many there are.
std::vector<Seat> seats_of(const Embedding& embedding, const Pivot& pivot);
double estimated_seats(const Embedding& embedding, const Pivot& pivot);
// Whether it may lie on this one.
bool has_seat(const Embedding& embedding, const Pivot& pivot, Seat seat);

// What carries the pivot onto a seat within the group; not checked any further.
Similarity carrying(const Embedding& embedding, const Pivot& pivot, Seat seat);

}  // namespace filigree::curves
