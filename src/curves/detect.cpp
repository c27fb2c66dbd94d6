#include "curves/detect.h"

#include "curves/search.h"

namespace filigree::curves {

Matches find_matches(const Shape& left, const MatchIndex& design, const MatchOptions& options) {
    const std::vector<Symmetry> own = symmetries(left, options);
    return Search(left, design, options, own).all();
}

}  // namespace filigree::curves
