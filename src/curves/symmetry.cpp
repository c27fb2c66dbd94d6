#include "curves/symmetry.h"

#include <algorithm>
#include <numeric>

#include "curves/algebra.h"
#include "curves/match_order.h"
#include "curves/search.h"

namespace filigree::curves {

std::vector<Symmetry> symmetries(const Shape& shape, const MatchOptions& options) {
    MatchOptions own = options;
    own.group = options.group == MatchGroup::similarity ? MatchGroup::isometry : options.group;
    own.weights = WeightRule::equal;
    own.limit = SIZE_MAX;
    Symmetry identity;
    identity.images.resize(shape.elements.size());
    std::iota(identity.images.begin(), identity.images.end(), 0U);
    const std::vector<Symmetry> one = {identity};
    if (shape.elements.empty()) return one;
    const MatchIndex index(shape, options.tolerance);
    Matches matches = Search(shape, index, own, one).all();
    // What turns freely stands for all its turns.
    for (Family& family : matches.families) matches.found.push_back(std::move(family.members.front()));
    std::vector<Symmetry> found;
    for (Match& match : matches.found) found.push_back({match.by, match.is_reflected, std::move(match.carriers)});
    if (found.empty()) return one;
    std::sort(found.begin(), found.end(), [](const Symmetry& a, const Symmetry& b) {
        return std::pair(a.is_reflected, angle_of(a.by)) < std::pair(b.is_reflected, angle_of(b.by));
    });
    return found;
}

std::vector<Symmetry> variants(std::span<const Symmetry> symmetries, const Shape& right,
                               std::span<const Shape> conditions, double tolerance) {
    std::vector<Symmetry> different;
    for (const Symmetry& g : symmetries) {
        const auto looks_alike = [&](const Symmetry& other) {
            const auto is_same = [&](const Shape& shape) {
                return are_equal(transformed(shape, g.by), transformed(shape, other.by), tolerance);
            };
            return is_same(right) && std::all_of(conditions.begin(), conditions.end(), is_same);
        };
        if (std::none_of(different.begin(), different.end(), looks_alike)) different.push_back(g);
    }
    return different;
}

std::vector<Transform> applications(const Match& match, std::span<const Symmetry> variants) {
    std::vector<Transform> by;
    by.reserve(variants.size());
    for (const Symmetry& g : variants) by.push_back(compose(match.by, g.by));
    return by;
}

}  // namespace filigree::curves
