#include "plane/shared_edges.h"

#include <algorithm>
#include <utility>

namespace filigree {
namespace {

constexpr std::uint32_t few_links = 16;  // at a point: compared each with each

// While edges are looked for, a link is filed under its lower end.
struct FiledLink {
    std::uint32_t high = 0, link = 0;
};

}  // namespace

SharedEdges shared_edges(std::span<const Point> points, std::span<const DirectedLink> links) {
    SharedEdges shared;
    shared.sides.assign(links.size(), BorderMap::none);
    std::vector<std::uint32_t> ends(points.size() + 1, 0);
    for (std::size_t i = 0; i < links.size(); ++i) {
        const DirectedLink& link = links[i];
        if (link.from == link.to) continue;
        const bool is_turned = points[link.to] < points[link.from];
        shared.sides[i] = is_turned ? 1 : 0;
        ++ends[is_turned ? link.to : link.from];
    }
    std::uint32_t before = 0;
    for (std::uint32_t& end : ends) before += std::exchange(end, before);
    std::vector<FiledLink> filed(before);
    for (std::uint32_t i = 0; i < links.size(); ++i) {
        if (shared.sides[i] == BorderMap::none) continue;
        const bool is_turned = shared.sides[i] != 0;
        filed[ends[is_turned ? links[i].to : links[i].from]++] = {is_turned ? links[i].from : links[i].to, i};
    }
    shared.edges.reserve(filed.size());
    std::uint32_t begin = 0;
    for (std::uint32_t low = 0; low < points.size(); ++low) {
        const std::uint32_t end = ends[low];
        const bool is_sorted = end - begin > few_links;
        const auto by_high = [](const FiledLink& a, const FiledLink& b) { return a.high < b.high; };
        if (is_sorted) std::sort(filed.begin() + begin, filed.begin() + end, by_high);
        const std::size_t first_edge = shared.edges.size();
        for (std::uint32_t f = begin; f < end; ++f) {
            std::size_t e = is_sorted && shared.edges.size() > first_edge ? shared.edges.size() - 1 : first_edge;
            while (e < shared.edges.size() && shared.edges[e].high != filed[f].high) ++e;
            if (e == shared.edges.size()) shared.edges.push_back({low, filed[f].high});
            shared.sides[filed[f].link] |= static_cast<std::uint32_t>(e) << 1;
        }
        begin = end;
    }
    return shared;
}

std::vector<DirectedLink> ring_links(const Polygons& polygons, const PointTree& tree) {
    std::vector<DirectedLink> links(polygons.points.size());
    std::size_t begin = 0;
    for (const std::uint32_t end : polygons.ring_ends) {
        for (std::size_t i = begin; i < end; ++i) {
            const std::uint32_t here = tree.index_of(polygons.points[i]);
            links[i].from = here;
            links[i > begin ? i - 1 : end - 1].to = here;
        }
        for (std::size_t i = begin; i < end; ++i) {
            if (links[i].from == PointTree::none) links[i].to = PointTree::none;
            if (links[i].to == PointTree::none) links[i].from = PointTree::none;
        }
        begin = end;
    }
    return links;
}

}  // namespace filigree
