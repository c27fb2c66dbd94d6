#include "engines/tangle/verify.h"

#include <algorithm>
#include <cmath>

#include "base/number_text.h"
#include "plane/verify.h"

namespace filigree::tangle {
namespace {

template <class Work>
void for_each_leaf(const Tangle& tangle, const Work& work) {
    for (const Group& group : tangle.groups) {
        if (group.consumer != none) continue;
        for (const Shape& shape : group.shapes) work(shape);
    }
}

double border_length(const Tangle& tangle) {
    double sum = 0;
    for (std::uint32_t g = 0; g < tangle.start_groups; ++g) {
        for (const Shape& shape : tangle.groups[g].shapes) {
            const PolygonView polygon = tangle.polygon(shape);
            for (std::size_t r = 0; r < polygon.ring_count(); ++r) {
                const RingView ring = polygon.ring(r);
                for (std::size_t i = 0; i < ring.size(); ++i) {
                    sum += length(to_px(ring[i + 1 == ring.size() ? 0 : i + 1]) - to_px(ring[i]));
                }
            }
        }
    }
    return sum;
}

}  // namespace

Areas areas(const Tangle& tangle) {
    Areas sums;
    for (std::uint32_t g = 0; g < tangle.start_groups; ++g) {
        for (const Shape& shape : tangle.groups[g].shapes) sums.start += area(tangle.polygon(shape));
    }
    for_each_leaf(tangle, [&](const Shape& shape) {
        if (!shape.is_mark) sums.leaves += area(tangle.polygon(shape));
    });
    return sums;
}

Polygons leaf_polygons(const Tangle& tangle) {
    Polygons leaves;
    for_each_leaf(tangle, [&](const Shape& shape) {
        if (!shape.is_mark) leaves.add(tangle.polygon(shape));
    });
    return leaves;
}

std::vector<std::string> broken_invariants(const Tangle& tangle) {
    std::vector<std::string> broken;
    const Areas sums = areas(tangle);
    // A new vertex on a start's border is off it by up to a grid unit; only for starts of a few px does that count.
    const double rounding = border_length(tangle) / grid_per_px;
    if (!(std::fabs(sums.start - sums.leaves) <= std::max(1e-9 * sums.start, rounding))) {
        broken.push_back("the leaves' areas add up to " + to_text(sums.leaves) + " px^2, the start's to " +
                         to_text(sums.start));
    }
    for_each_leaf(tangle, [&](const Shape& shape) {
        if (broken.size() > 10) return;
        if (const auto flaw = find_flaw(tangle.polygon(shape))) {
            broken.push_back("shape " + to_hex(shape.key.value) + ": " + *flaw);
        }
    });
    if (const auto overlap = find_overlap(leaf_polygons(tangle))) broken.push_back("leaves: " + *overlap);

    for (std::size_t s = 0; s < tangle.steps.size(); ++s) {
        const Step& step = tangle.steps[s];
        if (tangle.groups[step.group].consumer != s)
            broken.push_back("step " + std::to_string(s + 1) + " expands a group that another step expanded");
        if (s > 0 && tangle.steps[s - 1].group >= step.group)
            broken.push_back("step " + std::to_string(s + 1) + " is out of order");
    }
    std::vector<std::uint64_t> keys;
    for_each_leaf(tangle, [&](const Shape& shape) { keys.push_back(shape.key.value); });
    std::sort(keys.begin(), keys.end());
    if (std::adjacent_find(keys.begin(), keys.end()) != keys.end()) broken.push_back("two shapes have the same key");
    return broken;
}

}  // namespace filigree::tangle
