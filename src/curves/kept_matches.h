// The matches of one left side, kept while the design changes: after a rule only what lies near the change is searched.
//
// What is kept is what find_matches() would find now, in the same order. Where only curves with frames change, an
// update costs by what changes, not by how many matches there are: those on a slot that was emptied are known by the
// slot, and what is new lies on something new. Where lines, points or circles change, all seats of the left side's
// anchor are passed over, and of a left side that nothing fixes all is searched again.
#pragma once

#include <span>
#include <vector>

#include "curves/detect.h"
#include "curves/match_order.h"
#include "curves/symmetry.h"

namespace filigree::curves {

// Matches in order, each found again by the slots that it lies on.
class MatchBook {
public:
    void enter(std::vector<Match> matches, double tolerance);
    void strike(std::span<const std::uint32_t> slots);  // all that lie on one of these

    std::size_t size() const { return order_.size(); }
    const Match& operator[](std::size_t i) const { return pages_[order_[i]].match; }

private:
    struct Page {
        Match match;
        MatchRank rank;
    };
    std::size_t place_of(const MatchRank& rank) const;

    std::vector<Page> pages_;
    std::vector<std::uint32_t> free_;                   // pages that are empty
    std::vector<std::uint32_t> order_;                  // pages, by rank
    std::vector<std::vector<std::uint32_t>> pages_on_;  // of each slot
};

class KeptMatches {
public:
    KeptMatches(Shape left, const MatchIndex& design, MatchOptions options);

    // After the design was updated; with more than one update since, all their changes after each other.
    void update(const MatchIndex& design, const MatchIndex::Change& change);

    const MatchBook& found() const { return found_; }
    const MatchBook& near_misses() const { return near_misses_; }
    const std::vector<Family>& families() const { return families_; }
    bool is_complete() const { return is_complete_; }

private:
    void search_all(const MatchIndex& design);

    Shape left_;
    MatchOptions options_;
    std::vector<Symmetry> symmetries_;
    MatchBook found_, near_misses_;
    std::vector<Family> families_;
    bool is_complete_ = true;
};

}  // namespace filigree::curves
