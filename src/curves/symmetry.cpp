#include "curves/symmetry.h"

#include <algorithm>
#include <cmath>
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
    // Two symmetries look alike where what leads from one to the other, a symmetry itself, changes nothing. A symmetry
    // is known by how it turns.
    struct Turn {
        bool is_reflected;
        double angle;
        bool changes_nothing;
    };
    const auto order = [](const Turn& a, const Turn& b) {
        return std::pair(a.is_reflected, a.angle) < std::pair(b.is_reflected, b.angle);
    };
    std::vector<Turn> turns;
    for (const Symmetry& g : symmetries) {
        const auto is_kept = [&](const Shape& shape) { return are_equal(transformed(shape, g.by), shape, tolerance); };
        turns.push_back({determinant(g.by) < 0, angle_of(g.by),
                         is_kept(right) && std::all_of(conditions.begin(), conditions.end(), is_kept)});
    }
    std::sort(turns.begin(), turns.end(), order);
    const auto changes_nothing = [&](const Transform& by) {
        const bool is_reflected = determinant(by) < 0;
        const double angle = angle_of(by);
        const auto first = std::lower_bound(turns.begin(), turns.end(), Turn{is_reflected, 0, false}, order);
        const auto last = std::lower_bound(first, turns.end(), Turn{is_reflected, 360, false}, order);
        if (first == last) return false;
        const auto next = std::lower_bound(first, last, Turn{is_reflected, angle, false}, order);
        const auto off = [&](const Turn& turn) { return std::fabs(std::remainder(turn.angle - angle, 360)); };
        const Turn &after = next == last ? *first : *next, &before = next == first ? *(last - 1) : *(next - 1);
        return (off(after) < off(before) ? after : before).changes_nothing;
    };
    std::vector<Symmetry> different;
    for (const Symmetry& g : symmetries) {
        const auto looks_alike = [&](const Symmetry& other) {
            return changes_nothing(compose(inverse(other.by), g.by));
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
