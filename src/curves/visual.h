// Look-alikes: where a left side lies on a design to the eye, although curves have other descriptors there. A line and
// a parabola of low curvature, an arc and the quadratic that was drawn for it, a cubic near a parabola, two pieces that
// go on in each other nearly. Paper: section 5, figure 23.
//
// Such embeddings are never isolated, since what lies within a tolerance may be moved a little: of those that look the
// same one that fits well is told, found from ends and contacts.
#pragma once

#include <vector>

#include "curves/match_index.h"
#include "curves/matches.h"
#include "curves/shape.h"

namespace filigree::curves {

// Embeddings in which every left element lies within options.visual_tolerance of curves of its layer all along, running
// as they do; points lie on points of their label. Without those that find_matches() finds. Misfits are in visual
// tolerances; the carrier of an element is that of its middle. Candidates are bounded in number: where there would be
// more, the answer is not complete. Of the affine group the similarities are searched.
Matches find_look_alikes(const Shape& left, const MatchIndex& design, const MatchOptions& options);

// What of a design the left elements cover in such a match: what a rule takes away there. Pieces of the design's
// elements, by element of the left side.
std::vector<Element> covered_pieces(const Shape& left, const MatchIndex& design, const Match& match,
                                    double visual_tolerance);

}  // namespace filigree::curves
