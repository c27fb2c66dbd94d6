#include "curves/detect.h"

#include "curves/search.h"

namespace filigree::curves {

Matches find_matches(const Shape& left, const MatchIndex& design, const MatchOptions& options) {
    if (left.elements.empty()) {
        // Nothing lies everywhere; where it was drawn stands for that.
        Matches matches;
        matches.found.emplace_back();
        return matches;
    }
    const std::vector<Symmetry> own = symmetries(left, options);
    return Search(left, design, options, own).all();
}

}  // namespace filigree::curves
