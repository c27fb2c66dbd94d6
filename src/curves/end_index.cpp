#include "curves/end_index.h"

#include <algorithm>

namespace filigree::curves {
namespace {

// The bits of x and y interleaved: near places mostly have near codes.
std::uint64_t spread_bits(std::uint64_t v) {
    v = (v | v << 16) & 0x0000FFFF0000FFFFU;
    v = (v | v << 8) & 0x00FF00FF00FF00FFU;
    v = (v | v << 4) & 0x0F0F0F0F0F0F0F0FU;
    v = (v | v << 2) & 0x3333333333333333U;
    return (v | v << 1) & 0x5555555555555555U;
}

struct End {
    std::uint64_t code = 0;
    std::uint32_t element = 0;
    Vec at;
};

std::vector<End> ends_in_order(std::span<const Element> elements) {
    std::vector<End> ends;
    ends.reserve(2 * elements.size());
    Bounds all;
    for (std::uint32_t i = 0; i < elements.size(); ++i) {
        const auto [first, last] = ends_of(elements[i]);
        extend(all, first);
        extend(all, last);
        ends.push_back({0, i, first});
        if (first != last) ends.push_back({0, i, last});
    }
    const double size = std::max(all.max.x - all.min.x, all.max.y - all.min.y);
    const double scale = size > 0 ? 0x1p32 * (1 - 0x1p-40) / size : 0;
    for (End& end : ends) {
        const Vec cell = (end.at - all.min) * scale;
        end.code = spread_bits(static_cast<std::uint64_t>(cell.x)) | spread_bits(static_cast<std::uint64_t>(cell.y))
                                                                         << 1;
    }
    std::sort(ends.begin(), ends.end(),
              [](const End& a, const End& b) { return a.code != b.code ? a.code < b.code : a.element < b.element; });
    return ends;
}

std::vector<Edge> as_edges(const std::vector<End>& ends) {
    std::vector<Edge> edges;
    edges.reserve(ends.size());
    for (const End& end : ends) edges.push_back({end.at, end.at});
    return edges;
}

}  // namespace

EndIndex::EndIndex(std::span<const Element> elements) : tree_({}) {
    const std::vector<End> ends = ends_in_order(elements);
    element_of_.reserve(ends.size());
    for (const End& end : ends) element_of_.push_back(end.element);
    tree_ = EdgeTree(as_edges(ends));
}

std::vector<Pair> pairs_near(std::span<const Element> a, std::span<const Element> b, double reach) {
    std::vector<Pair> pairs;
    const auto look = [&](std::span<const Element> along, std::span<const Element> for_ends, bool is_turned) {
        const EndIndex index(for_ends);
        for (std::uint32_t i = 0; i < along.size(); ++i) {
            index.any(along[i], reach, [&](std::uint32_t j) {
                if (along[i].kind == for_ends[j].kind && along[i].layer == for_ends[j].layer) {
                    pairs.push_back(is_turned ? Pair{j, i} : Pair{i, j});
                }
                return false;
            });
        }
    };
    look(a, b, false);
    look(b, a, true);
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

}  // namespace filigree::curves
