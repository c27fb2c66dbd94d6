// Whether polygons whose vertices were moved are still clean; inner part of perturb.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plane/crossings.h"
#include "plane/polygon.h"

namespace filigree {

// Polygons as lists of vertices.
struct VertexRings {
    std::vector<std::uint32_t> vertices;
    std::vector<std::uint32_t> ring_ends, polygon_ends;

    std::span<const std::uint32_t> ring(std::size_t i) const {
        return {vertices.data() + (i == 0 ? 0 : ring_ends[i - 1]), vertices.data() + ring_ends[i]};
    }
    std::size_t first_ring(std::size_t polygon) const { return polygon == 0 ? 0 : polygon_ends[polygon - 1]; }
    std::span<const std::uint32_t> of_polygon(std::size_t polygon) const {
        const auto end_of = [&](std::size_t rings) { return rings == 0 ? 0 : ring_ends[rings - 1]; };
        return {vertices.data() + end_of(first_ring(polygon)), vertices.data() + end_of(polygon_ends[polygon])};
    }
};

// The sign of a ring's area, exact.
int area_sign(std::span<const std::uint32_t> ring, std::span<const Point> at);

class FaceCheck {
public:
    // `from` and `at`: where vertices lay and lie.
    FaceCheck(const VertexRings& rings, std::span<const Point> from, std::span<const Point> at)
        : rings_(rings), from_(from), at_(at) {}

    // Appends vertices where a polygon is no longer clean, some several times.
    void find(std::size_t polygon, std::vector<std::uint32_t>& found);

private:
    bool has_turned_over(std::span<const std::uint32_t> ring, bool is_outer) const;
    bool is_outside(std::span<const std::uint32_t> hole, std::span<const std::uint32_t> outer) const;
    bool is_nested_wrongly(std::size_t first, std::size_t end) const;
    void sort_by_place();

    const VertexRings& rings_;
    const std::span<const Point> from_, at_;
    CrossingFinder crossings_;
    std::vector<DirectedLink> links_;
    std::vector<std::uint32_t> order_;
};

}  // namespace filigree
