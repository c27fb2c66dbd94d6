#include "plane/border_map.h"

#include <algorithm>
#include <utility>

#include "plane/point_tree.h"

namespace filigree {
namespace {

constexpr std::uint32_t few_sides = 16;  // at a vertex: compared each with each

// Of each point of the tree the vertex that it is part of; fills `vertices`.
std::vector<std::uint32_t> merged(const PointTree& tree, double within, std::vector<Point>& vertices) {
    const std::vector<Point>& points = tree.points();
    std::vector<std::uint32_t> parents(points.size());
    for (std::uint32_t i = 0; i < parents.size(); ++i) parents[i] = i;
    const auto root_of = [&](std::uint32_t i) {
        while (parents[i] != i) i = parents[i] = parents[parents[i]];
        return i;
    };
    if (within > 0) {
        std::vector<Point> near;
        for (std::uint32_t i = 0; i < points.size(); ++i) {
            near.clear();
            tree.find_near(points[i], points[i], within * grid_per_px, near);
            if (near.size() < 2) continue;
            for (const Point p : near) {
                const std::uint32_t a = root_of(i), b = root_of(tree.index_of(p));
                if (points[a] < points[b]) parents[b] = a;
                if (points[b] < points[a]) parents[a] = b;
            }
        }
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

// A side of a polygon while edges are looked for, filed under its lower vertex.
struct FiledSide {
    std::uint32_t high = 0, point = 0;
};

}  // namespace

std::span<const std::uint32_t> BorderMap::sides_of(const std::vector<std::uint32_t>& sides, const Polygons& polygons,
                                                   std::size_t polygon) {
    const auto end_of_rings = [&](std::size_t rings) { return rings == 0 ? 0 : polygons.ring_ends[rings - 1]; };
    const std::uint32_t begin = end_of_rings(polygon == 0 ? 0 : polygons.polygon_ends[polygon - 1]);
    return {sides.data() + begin, sides.data() + end_of_rings(polygons.polygon_ends[polygon])};
}

BorderMap border_map(const Polygons& welded, double merge_within) {
    BorderMap map;
    const PointTree tree(welded.points);
    const std::vector<std::uint32_t> vertex_of_tree = merged(tree, merge_within, map.vertices);
    const std::size_t count = welded.points.size();
    std::vector<std::uint32_t> vertex_of(count);
    for (std::size_t i = 0; i < count; ++i) vertex_of[i] = vertex_of_tree[tree.index_of(welded.points[i])];

    map.sides.assign(count, BorderMap::none);
    std::vector<std::uint32_t> ends(map.vertices.size() + 1, 0);
    const auto for_each_side = [&](auto visit) {
        std::size_t begin = 0;
        for (const std::uint32_t end : welded.ring_ends) {
            for (std::size_t i = begin; i < end; ++i) {
                const std::uint32_t from = vertex_of[i], to = vertex_of[i + 1 < end ? i + 1 : begin];
                if (from == to) continue;
                const bool is_turned = map.vertices[to] < map.vertices[from];
                visit(static_cast<std::uint32_t>(i), is_turned ? to : from, is_turned ? from : to, is_turned);
            }
            begin = end;
        }
    };
    for_each_side([&](std::uint32_t, std::uint32_t low, std::uint32_t, bool) { ++ends[low]; });
    std::uint32_t before = 0;
    for (std::uint32_t& end : ends) before += std::exchange(end, before);
    std::vector<FiledSide> filed(before);
    for_each_side([&](std::uint32_t point, std::uint32_t low, std::uint32_t high, bool is_turned) {
        filed[ends[low]++] = {high, point};
        map.sides[point] = is_turned ? 1 : 0;
    });
    std::uint32_t begin = 0;
    for (std::uint32_t low = 0; low < map.vertices.size(); ++low) {
        const std::uint32_t end = ends[low];
        const bool is_sorted = end - begin > few_sides;
        const auto by_high = [](const FiledSide& a, const FiledSide& b) { return a.high < b.high; };
        if (is_sorted) std::sort(filed.begin() + begin, filed.begin() + end, by_high);
        const std::size_t first_edge = map.edges.size();
        for (std::uint32_t s = begin; s < end; ++s) {
            std::size_t e = is_sorted && map.edges.size() > first_edge ? map.edges.size() - 1 : first_edge;
            while (e < map.edges.size() && map.edges[e].high != filed[s].high) ++e;
            if (e == map.edges.size()) map.edges.push_back({low, filed[s].high});
            map.sides[filed[s].point] |= static_cast<std::uint32_t>(e) << 1;
        }
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
