// The search for families: what a left side that nothing fixes does on a design.
#pragma once

#include <span>

#include "curves/embedding.h"
#include "curves/matches.h"
#include "curves/symmetry.h"

namespace filigree::curves {

// Of a left side without anchors: lines, labelled points and circles alone. Families that differ by a symmetry are one.
Matches find_families(const Embedding& embedding, std::span<const Symmetry> symmetries);

}  // namespace filigree::curves
