#include "language/preset_tree.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace filigree {

namespace {

struct SegmentOrder {
    using Place = std::pair<std::uint32_t, const PathSegment*>;  // a node, and a segment behind it

    bool operator()(const Place& a, const Place& b) const {
        return std::tie(a.first, a.second->kind, a.second->name, a.second->ordinals) <
               std::tie(b.first, b.second->kind, b.second->name, b.second->ordinals);
    }
};

void link(PresetTree::Node& from, const PathSegment& segment, std::uint32_t to) {
    switch (segment.kind) {
        case PathSegment::Kind::name:
            if (segment.ordinals.empty()) from.names.push_back({segment.name, 0, to});
            for (const std::uint32_t ordinal : segment.ordinals) from.names.push_back({segment.name, ordinal, to});
            break;
        case PathSegment::Kind::shapes:
            for (const std::uint32_t shape : segment.ordinals) from.shapes.push_back({shape, to});
            break;
        case PathSegment::Kind::any:
            from.any = to;
            break;
        case PathSegment::Kind::any_depth:
            from.any_depth = to;
            break;
    }
}

template <typename Edge>
void append_equal(const std::vector<Edge>& edges, Edge wanted, std::vector<std::uint32_t>& reached) {
    wanted.to = 0;
    auto edge = std::lower_bound(edges.begin(), edges.end(), wanted);
    for (; edge != edges.end(); ++edge) {
        wanted.to = edge->to;
        if (*edge != wanted) break;
        reached.push_back(edge->to);
    }
}

}  // namespace

void grow(PresetTree& tree, std::span<const Preset> presets) {
    std::map<SegmentOrder::Place, std::uint32_t, SegmentOrder> known;
    for (std::size_t i = 0; i < presets.size(); ++i) {
        const ChoicePath& path = *presets[i].path;
        std::uint32_t at = 0;
        for (const PathSegment& segment : path.segments) {
            const auto next = static_cast<std::uint32_t>(tree.nodes.size());
            const auto [place, is_new] = known.try_emplace({at, &segment}, next);
            if (is_new) {
                tree.nodes.emplace_back().stays = segment.kind == PathSegment::Kind::any_depth;
                link(tree.nodes[at], segment, next);
            }
            at = place->second;
            tree.names_shapes |= segment.kind == PathSegment::Kind::shapes || segment.kind == PathSegment::Kind::any;
        }
        tree.nodes[at].ends.push_back(tree.first_preset + static_cast<std::uint32_t>(i));
        if (!path.parameter.empty()) tree.parameters.push_back(path.parameter);
    }
    for (PresetTree::Node& node : tree.nodes) {
        std::sort(node.names.begin(), node.names.end());
        std::sort(node.shapes.begin(), node.shapes.end());
    }
    std::sort(tree.parameters.begin(), tree.parameters.end());
    tree.parameters.erase(std::unique(tree.parameters.begin(), tree.parameters.end()), tree.parameters.end());
}

void follow(const PresetTree& tree, std::uint32_t node, const WalkSegment& segment, bool by_name,
            std::vector<std::uint32_t>& reached) {
    const PresetTree::Node& from = tree.nodes[node];
    if (segment.shape != 0) {
        append_equal(from.shapes, {segment.shape, 0}, reached);
    } else {
        append_equal(from.names, {segment.name, 0, 0}, reached);
        // The only group is the first.
        append_equal(from.names, {segment.name, std::max<std::uint32_t>(segment.ordinal, 1), 0}, reached);
    }
    if (!by_name && from.any != PresetTree::none) reached.push_back(from.any);
}

}  // namespace filigree
