#include "plane/border_map.h"

#include <algorithm>
#include <utility>

#include "plane/edge_inserts.h"
#include "plane/shared_edges.h"
#include "plane/weld.h"

namespace filigree {
namespace {

// Of each point of the tree the vertex that it is part of; fills `vertices`.
std::vector<std::uint32_t> merged(const PointTree& tree, double within, std::vector<Point>& vertices) {
    const std::vector<Point>& points = tree.points();
    std::vector<std::uint32_t> parents(points.size());
    for (std::uint32_t i = 0; i < parents.size(); ++i) parents[i] = i;
    const auto root_of = [&](std::uint32_t i) {
        while (parents[i] != i) i = parents[i] = parents[parents[i]];
        return i;
    };
    std::vector<PointTree::Pair> pairs;
    if (within > 0) tree.find_pairs(within * grid_per_px, pairs);
    for (const PointTree::Pair& pair : pairs) {
        const std::uint32_t a = root_of(pair.a), b = root_of(pair.b);
        if (points[a] < points[b]) parents[b] = a;
        if (points[b] < points[a]) parents[a] = b;
    }
    std::vector<std::uint32_t> vertex_of(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        if (parents[i] != i) continue;
        vertex_of[i] = static_cast<std::uint32_t>(vertices.size());
        vertices.push_back(points[i]);
    }
    for (std::uint32_t i = 0; i < points.size(); ++i) vertex_of[i] = vertex_of[root_of(i)];
    return vertex_of;
}

}  // namespace

BorderMap border_map(const Polygons& welded, double merge_within) {
    BorderMap map;
    map.ring_ends = welded.ring_ends;
    map.polygon_ends = welded.polygon_ends;
    const PointTree tree(welded.points);
    const std::vector<std::uint32_t> vertex_of = merged(tree, merge_within, map.vertices);
    std::vector<DirectedLink> links = ring_links(welded, tree);
    for (DirectedLink& link : links) link = {vertex_of[link.from], vertex_of[link.to]};
    SharedEdges shared = shared_edges(map.vertices, links);
    map.edges = std::move(shared.edges);
    map.sides = std::move(shared.sides);
    return map;
}

BorderMap welded_border_map(const Polygons& polygons, double merge_within) {
    const PointTree tree(polygons.points);
    const SharedEdges given = shared_edges(tree.points(), ring_links(polygons, tree));
    const EdgeInserts inserts = edge_inserts(tree, given.edges, weld_tolerance);

    BorderMap map;
    const std::vector<std::uint32_t> vertex_of = merged(tree, merge_within, map.vertices);
    std::vector<DirectedLink> parts;  // of each edge in turn, one more than it has inserts
    parts.reserve(given.edges.size() + inserts.points.size());
    for (std::uint32_t e = 0; e < given.edges.size(); ++e) {
        std::uint32_t before = vertex_of[given.edges[e].low];
        const auto add_part = [&](std::uint32_t point) {
            const std::uint32_t next = vertex_of[point];
            parts.push_back({before, next});
            before = next;
        };
        for (const std::uint32_t point : inserts.of(e)) add_part(point);
        add_part(given.edges[e].high);
    }
    SharedEdges shared = shared_edges(map.vertices, parts);
    map.edges = std::move(shared.edges);

    map.sides.reserve(given.sides.size() + 2 * inserts.points.size());
    map.ring_ends.reserve(polygons.ring_ends.size());
    map.polygon_ends = polygons.polygon_ends;
    std::size_t begin = 0;
    for (const std::uint32_t end : polygons.ring_ends) {
        for (std::size_t i = begin; i < end; ++i) {
            const std::uint32_t side = given.sides[i];
            if (side == BorderMap::none) continue;
            const std::uint32_t edge = BorderMap::edge_of(side);
            const std::uint32_t first = inserts.begins[edge] + edge, last = inserts.begins[edge + 1] + edge;
            for (std::uint32_t part = first; part <= last; ++part) {
                if (!BorderMap::is_turned(side)) {
                    map.sides.push_back(shared.sides[part]);
                } else {
                    const std::uint32_t turned = shared.sides[first + (last - part)];
                    map.sides.push_back(turned == BorderMap::none ? turned : turned ^ 1);
                }
            }
        }
        map.ring_ends.push_back(static_cast<std::uint32_t>(map.sides.size()));
        begin = end;
    }
    return map;
}

EdgesAtVertices edges_at_vertices(const BorderMap& map) {
    EdgesAtVertices all;
    all.begins.assign(map.vertices.size() + 1, 0);
    for (const BorderMap::Edge& edge : map.edges) {
        ++all.begins[edge.low];
        ++all.begins[edge.high];
    }
    std::uint32_t before = 0;
    for (std::uint32_t& begin : all.begins) before += std::exchange(begin, before);
    all.edges.resize(2 * map.edges.size());
    std::vector<std::uint32_t> next(all.begins.begin(), all.begins.end() - 1);
    for (std::uint32_t e = 0; e < map.edges.size(); ++e) {
        all.edges[next[map.edges[e].low]++] = e;
        all.edges[next[map.edges[e].high]++] = e;
    }
    return all;
}

}  // namespace filigree
