// How far each vertex of a perturbation may move; inner part of perturb.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plane/border_map.h"
#include "plane/wobble_net.h"

namespace filigree {

// At first what the net wishes. Along borders reaches change gradually, so lowering one lowers those around it.
// Where edges of different wavelengths meet, the vertex belongs to the longest, and for the others it is as if it
// did not move.
class WobbleReach {
public:
    explicit WobbleReach(const WobbleNet& net);  // which must outlive it

    double of(std::uint32_t vertex) const { return reaches_[vertex]; }
    void lower(std::uint32_t vertex, double reach);
    // To be called after lowering some: appends all vertices whose reach has changed since.
    void spread_from(const std::vector<std::uint32_t>& lowered, std::vector<std::uint32_t>& changed);

private:
    std::span<const std::uint32_t> edges_at(std::uint32_t vertex);
    void spread(std::vector<std::uint32_t> edges, std::vector<std::uint32_t>& changed);
    void spread_along(std::uint32_t side, std::vector<std::uint32_t>& lowered);

    const WobbleNet& net_;
    std::vector<double> reaches_;
    EdgesAtVertices at_vertices_;  // once they are needed
};

}  // namespace filigree
