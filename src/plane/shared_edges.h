// Every edge once, of links that run between numbered points; inner part of weld and border_map.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plane/border_map.h"
#include "plane/crossings.h"
#include "plane/point_tree.h"

namespace filigree {

struct SharedEdges {
    std::vector<BorderMap::Edge> edges;
    std::vector<std::uint32_t> sides;  // of each link, as in a BorderMap; none where both ends are one
};
SharedEdges shared_edges(std::span<const Point> points, std::span<const DirectedLink> links);

// From each point of each ring to the next, by their numbers in the tree. Ends that it does not hold are one.
std::vector<DirectedLink> ring_links(const Polygons& polygons, const PointTree& tree);

}  // namespace filigree
