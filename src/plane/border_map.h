// The map that welded polygons draw: every vertex and every edge once, however many polygons share it.
//
// What is decided for an edge or a vertex holds for all polygons there, so neighbours stay neighbours.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plane/polygon.h"

namespace filigree {

struct BorderMap {
    struct Edge {
        std::uint32_t low = 0, high = 0;  // vertices; low's point comes before high's
    };
    static constexpr std::uint32_t none = UINT32_MAX;

    std::vector<Point> vertices;
    std::vector<Edge> edges;
    // Of each point of the polygons: the edge to the next one of its ring, and whether the ring runs from high to low;
    // none where both are one vertex.
    std::vector<std::uint32_t> sides;
    std::vector<std::uint32_t> ring_ends, polygon_ends;  // of the polygons, whose rings are ranges of sides

    static std::uint32_t edge_of(std::uint32_t side) { return side >> 1; }
    static bool is_turned(std::uint32_t side) { return (side & 1) != 0; }
    std::uint32_t start_of(std::uint32_t side) const {
        return is_turned(side) ? edges[edge_of(side)].high : edges[edge_of(side)].low;
    }
    std::uint32_t end_of(std::uint32_t side) const { return start_of(side ^ 1); }

    std::size_t side_count(std::size_t polygons) const {  // of the first ones
        const std::uint32_t rings = polygons == 0 ? 0 : polygon_ends[polygons - 1];
        return rings == 0 ? 0 : ring_ends[rings - 1];
    }
    std::span<const std::uint32_t> sides_of(std::size_t polygon) const {
        return {sides.data() + side_count(polygon), sides.data() + side_count(polygon + 1)};
    }
};

// Points closer together than `merge_within` px are one vertex, the least of them. Of polygons as `weld` leaves
// them, on the plane. The numbers of vertices and edges depend on the set of points alone.
BorderMap border_map(const Polygons& welded, double merge_within = 0);

// The same of polygons that are not welded yet (weld.h), in less time than one after the other. The numbering is
// another one.
BorderMap welded_border_map(const Polygons& polygons, double merge_within);

// Which edges end at each vertex.
struct EdgesAtVertices {
    std::vector<std::uint32_t> begins;  // of each vertex in `edges`, and one more
    std::vector<std::uint32_t> edges;

    std::span<const std::uint32_t> of(std::uint32_t vertex) const {
        return {edges.data() + begins[vertex], edges.data() + begins[vertex + 1]};
    }
};
EdgesAtVertices edges_at_vertices(const BorderMap& map);

}  // namespace filigree
