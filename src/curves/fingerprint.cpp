#include "curves/fingerprint.h"

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "curves/algebra.h"
#include "curves/detect.h"
#include "curves/maximal.h"
#include "curves/moments.h"

namespace filigree::curves {
namespace {

std::uint64_t kinds_of(const Shape& shape) {
    std::map<std::pair<ElementKind, std::uint32_t>, std::uint64_t> counts;
    for (const Element& e : shape.elements) ++counts[{e.kind, e.layer}];
    std::uint64_t hash = 0;
    for (const auto& [kind, count] : counts) {
        hash = fold(fold(fold(hash, static_cast<std::uint64_t>(kind.first)), kind.second), count);
    }
    return hash;
}

Shape moved(const Shape& shape, const Transform& by, double tolerance) {
    std::vector<Element> elements;
    for (const Element& e : shape.elements) elements.push_back(transformed(e, by));
    return maximal(std::move(elements), tolerance);
}

}  // namespace

Fingerprint fingerprint(const Shape& shape, UpTo up_to) {
    Fingerprint print;
    print.kinds = kinds_of(shape);
    const Moments moments = moments_of(shape);
    if (!(moments.length > 0)) return print;
    const Vec middle = moments.first * (1 / moments.length);
    // How far the curves spread about their middle, along x, along y and in all.
    const double x = std::sqrt(std::max(0.0, moments.xx / moments.length - middle.x * middle.x));
    const double y = std::sqrt(std::max(0.0, moments.yy / moments.length - middle.y * middle.y));
    const double spread = std::hypot(x, y);
    switch (up_to) {
        case UpTo::nothing:
            print.values = {middle.x, middle.y, spread};
            break;
        case UpTo::translation:
            print.values = {moments.length, x, y};
            break;
        case UpTo::isometry:
            print.values = {moments.length, spread, 0};
            break;
        case UpTo::similarity:
            print.values = {spread > 0 ? moments.length / spread : 0, 0, 0};
            break;
    }
    return print;
}

bool are_same_design(const Shape& a, const Shape& b, UpTo up_to, double tolerance) {
    const double slack = 4 * tolerance;
    if (a.elements.size() != b.elements.size()) return false;
    if (up_to == UpTo::nothing || a.elements.empty()) return are_equal(a, b, slack);
    if (up_to == UpTo::translation) {
        const Moments from = moments_of(a), to = moments_of(b);
        const Vec by = to.first * (1 / to.length) - from.first * (1 / from.length);
        return are_equal(moved(a, translation(by), tolerance), b, slack);
    }
    MatchOptions options;
    options.group = up_to == UpTo::isometry ? MatchGroup::isometry : MatchGroup::similarity;
    options.tolerance = slack;
    options.weights = WeightRule::equal;
    const MatchIndex index(b, slack);
    const Matches matches = find_matches(a, index, options);
    return std::any_of(matches.found.begin(), matches.found.end(),
                       [&](const Match& match) { return are_equal(moved(a, match.by, tolerance), b, slack); });
}

std::optional<std::uint32_t> DesignSet::find_or_add(const Shape& design, std::uint32_t number) {
    const Fingerprint print = fingerprint(design, up_to_);
    // Wide beside what rounding does to sums over all elements, narrow beside what a rule does.
    const double cell = 1e4 * tolerance_;
    Bucket own{static_cast<std::int64_t>(print.kinds), 0, 0, 0};
    std::array<std::int64_t, 3> other{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double at = print.values[i] / (up_to_ == UpTo::similarity ? 1e-3 : cell);
        own[i + 1] = static_cast<std::int64_t>(std::floor(at));
        other[i] = at - std::floor(at) < 0.5 ? -1 : 1;
    }
    for (unsigned corner = 0; corner < 8; ++corner) {
        Bucket bucket = own;
        for (std::size_t i = 0; i < 3; ++i) {
            if ((corner >> i & 1U) != 0) bucket[i + 1] += other[i];
        }
        const auto found = buckets_.find(bucket);
        if (found == buckets_.end()) continue;
        for (const Entry& entry : found->second) {
            if (are_same_design(entry.design, design, up_to_, tolerance_)) return entry.number;
        }
    }
    buckets_[own].push_back({design, number});
    return std::nullopt;
}

}  // namespace filigree::curves
