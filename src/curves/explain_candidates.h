// Transforms under which a part of a left side may lie on a design, although the whole does not.
#pragma once

#include <optional>
#include <vector>

#include "curves/match.h"
#include "curves/match_index.h"
#include "curves/moments.h"
#include "curves/shape.h"

namespace filigree::curves {

struct Candidates {
    std::vector<Transform> by;
    bool is_complete = true;  // false where there would be more
};

// The matches of the left side without one element, whatever the scale and with reflections, then what carries one
// element onto another of its kind: parabolas by their frames, all else by contacts, centres, labelled points and ends.
// At most some tens of thousands; with a place, those first that cover it.
Candidates partial_embeddings(const Shape& left, const MatchIndex& design, const MatchOptions& options,
                              std::optional<Vec> near);

// How far a shape reaches from its middle.
double reach_of(const Shape& shape);

}  // namespace filigree::curves
