#include "curves/detect.h"

#include "curves/search.h"

namespace filigree::curves {

Matches find_matches(const Shape& left, const MatchIndex& design, const MatchOptions& options) {
    return find_matches(left, design, options, symmetries(left, options));
}

Matches find_matches(const Shape& left, const MatchIndex& design, const MatchOptions& options,
                     std::span<const Symmetry> symmetries) {
    if (left.elements.empty()) {
        // Nothing lies everywhere; where it was drawn stands for that.
        Matches matches;
        matches.found.emplace_back();
        return matches;
    }
    return Search(left, design, options, symmetries).all();
}

}  // namespace filigree::curves
