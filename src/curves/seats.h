// Where in a design an anchor may lie, by what similarities keep of it: intervals of slopes, ratios, angles, and which
// lines touch.
#pragma once

#include <functional>
#include <span>

#include "curves/anchor.h"

namespace filigree::curves {

// Calls take() with some seats after others, until it says false. Every embedding has a seat; most seats have none.
void find_seats(const Embedding& embedding, const Anchor& anchor,
                const std::function<bool(std::span<const Seat>)>& take);
// The same for seats of a curve on some slots alone.
void find_seats_on(const Embedding& embedding, const Anchor& curve, std::span<const std::uint32_t> slots,
                   const std::function<bool(std::span<const Seat>)>& take);
// Roughly how many there are.
double estimated_seats(const Embedding& embedding, const Anchor& anchor);

}  // namespace filigree::curves
