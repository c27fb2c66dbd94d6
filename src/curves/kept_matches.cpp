#include "curves/kept_matches.h"

#include <algorithm>

#include "curves/search.h"

namespace filigree::curves {

std::size_t MatchBook::place_of(const MatchRank& rank) const {
    const auto at =
        std::lower_bound(order_.begin(), order_.end(), rank,
                         [&](std::uint32_t page, const MatchRank& than) { return pages_[page].rank < than; });
    return static_cast<std::size_t>(at - order_.begin());
}

void MatchBook::enter(std::vector<Match> matches, double tolerance) {
    const bool is_first = order_.empty();  // they come in order, so all can be appended
    for (Match& match : matches) {
        std::uint32_t page = static_cast<std::uint32_t>(pages_.size());
        if (free_.empty()) {
            pages_.emplace_back();
        } else {
            page = free_.back();
            free_.pop_back();
        }
        for (const std::uint32_t slot : match.carriers) {
            if (slot >= pages_on_.size()) pages_on_.resize(slot + 1);
            // Several elements of the left side may lie on one.
            if (pages_on_[slot].empty() || pages_on_[slot].back() != page) pages_on_[slot].push_back(page);
        }
        pages_[page].rank = rank_of(match, tolerance);
        pages_[page].match = std::move(match);
        const std::size_t place = is_first ? order_.size() : place_of(pages_[page].rank);
        order_.insert(order_.begin() + static_cast<std::ptrdiff_t>(place), page);
    }
}

void MatchBook::strike(std::span<const std::uint32_t> slots) {
    for (const std::uint32_t slot : slots) {
        if (slot >= pages_on_.size()) continue;
        while (!pages_on_[slot].empty()) {
            const std::uint32_t page = pages_on_[slot].back();
            std::size_t place = place_of(pages_[page].rank);
            while (order_[place] != page) ++place;
            order_.erase(order_.begin() + static_cast<std::ptrdiff_t>(place));
            for (const std::uint32_t other : pages_[page].match.carriers) std::erase(pages_on_[other], page);
            pages_[page] = {};
            free_.push_back(page);
        }
    }
}

KeptMatches::KeptMatches(Shape left, const MatchIndex& design, MatchOptions options)
    : left_(std::move(left)), options_(std::move(options)), symmetries_(symmetries(left_, options_)) {
    search_all(design);
}

void KeptMatches::search_all(const MatchIndex& design) {
    Matches matches = find_matches(left_, design, options_, symmetries_);
    found_ = {};
    near_misses_ = {};
    found_.enter(std::move(matches.found), options_.tolerance);
    near_misses_.enter(std::move(matches.near_misses), options_.tolerance);
    families_ = std::move(matches.families);
    is_complete_ = matches.is_complete;
}

void KeptMatches::update(const MatchIndex& design, const MatchIndex::Change& change) {
    Search search(left_, design, options_, symmetries_);
    // A search that was cut short does not know what it left out.
    if (!search.has_anchor() || !is_complete_) return search_all(design);
    found_.strike(change.removed);
    near_misses_.strike(change.removed);
    std::vector<std::uint32_t> added = change.added;
    std::sort(added.begin(), added.end());
    added.erase(std::unique(added.begin(), added.end()), added.end());
    std::erase_if(added, [&](std::uint32_t slot) { return !design.is_taken(slot); });
    Matches fresh = search.on(added);
    // What was entered by an earlier of several changes is found again.
    found_.strike(added);
    near_misses_.strike(added);
    found_.enter(std::move(fresh.found), options_.tolerance);
    near_misses_.enter(std::move(fresh.near_misses), options_.tolerance);
    is_complete_ = fresh.is_complete;
}

}  // namespace filigree::curves
