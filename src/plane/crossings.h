// Edges that may only share their ends and meet all the same: the exact check that what was moved is still clean.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plane/edge_pairs.h"

namespace filigree {

// Edges between numbered vertices. Those of one call bound an area on one side each: they turn from +x towards +y
// around it, holes the other way.
struct DirectedLink {
    std::uint32_t from = 0, to = 0;
};

class CrossingFinder {
public:
    // Appends vertices of edges that meet elsewhere than at a common vertex, that leave one in the same direction,
    // or that meet at one in the wrong order; in no special order, and some several times. `at` tells where vertices
    // lie. An edge and its reverse may lie on each other. O(n log n) and the size of the answer for links in an order
    // that keeps near ones together; finds nothing only where there is nothing.
    void find(std::span<const DirectedLink> links, std::span<const Point> at, std::vector<std::uint32_t>& found);

private:
    void look_at(const DirectedLink& a, const DirectedLink& b, std::span<const Point> at,
                 std::vector<std::uint32_t>& found);
    void look_at_pinches(std::span<const DirectedLink> links, std::span<const Point> at,
                         std::vector<std::uint32_t>& found);

    std::vector<std::uint32_t> pinches_;  // vertices that are left more than once
    EdgePairs pairs_;
};

}  // namespace filigree
