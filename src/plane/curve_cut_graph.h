// The planar graph of cut edges and its faces; inner part of cut_by_curves.
//
// Loose ends and bridges (edges with one face on both sides) go, faces are traced by always turning towards them,
// and winding numbers spread from face to face across the edges. Components that hang together with nothing else
// (a disc in a face, a hole that no curve reaches) are put into the face around them by a look to the left of their
// least points.
#pragma once

#include <cstdint>
#include <vector>

#include "plane/curve_cut_edges.h"

namespace filigree {

class CutGraph {
public:
    // Of edges that share ends at most, or are equal; `origin` lies among them.
    CutGraph(const std::vector<CutEdge>& edges, Point origin);

    // The faces inside the shape, each ring from its least point, without the vertices that were only put on the
    // shape's edges and cut nothing; holes in the order of their least points, faces in that of theirs.
    Polygons faces();

private:
    // Half-edge 2e leads from edges_[e].from to its other end, 2e + 1 back.
    using Half = std::uint32_t;
    static constexpr std::uint32_t none = UINT32_MAX;

    struct Loop {
        std::uint32_t first = 0, end = 0;  // of loop_points_
        std::uint32_t face = 0;            // the cycle of its outer ring
        bool is_hole = false;
    };

    void number_vertices();
    void collect_arms();
    void sort_arms(std::uint32_t vertex);
    void merge_equal_edges(std::uint32_t vertex);
    void prune();
    void remove(std::uint32_t edge);
    void link();
    void trace();
    bool remove_bridges();
    void spread_windings();
    void find_containers();
    std::uint32_t container_left_of(std::uint32_t component, const EdgeTree& tree) const;
    void add_loops(std::uint32_t cycle, std::uint32_t face);
    void add_loop(const Half* first, const Half* last, std::uint32_t face);

    Point tail(Half h) const { return (h & 1) != 0 ? edges_[h / 2].to : edges_[h / 2].from; }
    Point head(Half h) const { return tail(h ^ 1); }
    // How far the winding number to the left of it is above that to its right.
    std::int32_t rise(Half h) const { return (h & 1) != 0 ? -rises_[h / 2] : rises_[h / 2]; }
    bool comes_before(Half a, Half b) const;  // of half-edges from one vertex, by direction from -90 degrees up

    const std::vector<CutEdge>& edges_;
    Point origin_;
    std::vector<std::uint32_t> vertex_;      // that each half-edge leaves from
    std::vector<std::int32_t> rises_;        // of each edge
    std::vector<std::uint8_t> is_live_;      // of each edge
    std::vector<std::uint8_t> is_on_curve_;  // of each edge: whether a part of a curve lies there
    std::vector<std::uint32_t> arm_ends_;    // of each vertex
    std::vector<Half> arms_;                 // that leave each vertex, by direction
    std::vector<std::uint32_t> degree_;      // of each vertex: its live arms
    std::vector<std::uint8_t> is_idle_;      // of each vertex: it lies on an edge of the shape and cuts nothing
    std::vector<Half> next_;                 // along the face to the left
    std::vector<std::uint32_t> cycle_;       // of each half-edge: the face's boundary that it is a part of
    std::vector<Half> first_of_cycle_;
    std::vector<std::uint32_t> component_;    // of each cycle
    std::vector<std::int32_t> winding_;       // of each cycle's face; at first relative to its component
    std::vector<std::uint32_t> outer_cycle_;  // of each component: its boundary seen from outside
    std::vector<Half> least_half_;            // of each component: from its least point
    std::vector<std::uint32_t> container_;    // of each component: the cycle of the face that it lies in
    std::vector<std::uint32_t> position_;     // of each vertex on the way
    std::vector<Half> way_;
    std::vector<Point> loop_points_;
    std::vector<Loop> loops_;
};

}  // namespace filigree
