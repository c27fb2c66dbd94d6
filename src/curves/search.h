// The search itself: an anchor is tried on all its seats, and what lies on the design there is a match.
#pragma once

#include <span>

#include "curves/anchor.h"
#include "curves/matches.h"
#include "curves/symmetry.h"

namespace filigree::curves {

class Search {
public:
    // All must outlive it. Of matches that differ by one of the symmetries one is found.
    Search(const Shape& left, const MatchIndex& design, const MatchOptions& options,
           std::span<const Symmetry> symmetries);

    // Whether anything fixes a transform; if not, only families are found.
    bool has_anchor() const { return !anchors_.empty(); }
    Matches all();
    // Only those that lie on one of these slots.
    Matches on(std::span<const std::uint32_t> slots);

private:
    const Anchor& cheapest();
    // Tries the transforms that seats say of an anchor; false where enough was found.
    bool try_seats(const Anchor& anchor, std::span<const Seat> seats);
    // Whether a transform carries the middle of an element without a frame into one of the boxes.
    bool comes_into(const Similarity& by, std::span<const Bounds> boxes) const;
    void take(const Anchor& anchor, bool is_reflected);
    bool goes_on();

    Embedding embedding_;
    std::span<const Symmetry> symmetries_;
    std::vector<Anchor> anchors_;
    double widest_reach_ = 0;  // of the first anchor
    Matches matches_;
    // Of the anchor that is tried: of parabolas, which slots are known to carry it, directly and reflected.
    std::vector<bool> is_known_;
    std::span<const Bounds> boxes_;
    // Scratch.
    Laid laid_;
    std::vector<Seat> seats_;
    std::vector<Transform> by_;
    std::vector<std::uint32_t> passed_;
};

}  // namespace filigree::curves
