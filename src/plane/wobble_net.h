// What a perturbation moves: the welded borders with the vertices that long edges get; inner part of perturb.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plane/border_map.h"
#include "plane/perturb.h"

namespace filigree {

// Vertices of the map keep their numbers; those that edges get come behind, edge by edge from its low end.
struct WobbleNet {
    BorderMap map;
    std::vector<std::uint32_t> first_inner;  // of each edge among the vertices, and one more
    std::vector<double> wavelengths;         // of each edge
    std::vector<std::uint8_t> is_outline;    // of each edge: whether it has a face on one side alone

    // Of each vertex.
    std::vector<Point> places;
    std::vector<double> wishes;  // how far it may go
    std::vector<double> waves;
    std::vector<Vec> pulls;  // px, what softens a corner

    std::uint32_t inner_count(std::uint32_t edge) const { return first_inner[edge + 1] - first_inner[edge]; }
    // The edge on which a vertex that is not the map's lies.
    std::uint32_t edge_of_inner(std::uint32_t vertex) const;
    bool is_inner(std::uint32_t vertex) const { return vertex >= map.vertices.size(); }

    // Calls visit(vertex) along a side: its start and all before its end.
    template <class Visit>
    void walk(std::uint32_t side, Visit visit) const {
        const std::uint32_t edge = BorderMap::edge_of(side), first = first_inner[edge], end = first_inner[edge + 1];
        if (BorderMap::is_turned(side)) {
            visit(map.edges[edge].high);
            for (std::uint32_t v = end; v > first; --v) visit(v - 1);
        } else {
            visit(map.edges[edge].low);
            for (std::uint32_t v = first; v < end; ++v) visit(v);
        }
    }
};

enum class Detail : std::uint8_t {
    given,  // only the polygons' own vertices
    more,   // long edges get vertices, corners are softened
};
// Of the map of polygons, each with its wobble; the first `faces` of them are faces.
WobbleNet wobble_net(BorderMap map, std::span<const Wobble> wobbles, std::size_t faces, Detail detail);

// The amplitude that counts.
double amplitude_of(const Wobble& wobble);
double wavelength_of(const Wobble& wobble);

}  // namespace filigree
