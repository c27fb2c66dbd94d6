// Polygons with holes on the grid, many at a time in flat arrays.
//
// Conventions: a polygon's first ring is its outer boundary and has positive area (it turns from +x towards
// +y); the rings after it are holes and have negative area. A ring does not repeat its first point at its
// end, has at least three points, no two equal in a row, and does not cross itself or another ring; rings
// may touch at points. `verify.h` checks all of it.
//
//   Polygons squares;
//   squares.points = {{0, 0}, {9, 0}, {9, 9}, {0, 9}};
//   squares.end_ring();
//   squares.end_polygon();
//   double px2 = area(squares[0]);
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plane/point.h"

namespace filigree {

using RingView = std::span<const Point>;

// One polygon somewhere in a Polygons; valid while that is neither changed nor destroyed.
class PolygonView {
public:
    PolygonView() = default;
    PolygonView(const Point* points, const std::uint32_t* ring_ends, std::size_t ring_begin, std::size_t ring_end)
        : points_(points), ring_ends_(ring_ends), ring_begin_(ring_begin), ring_end_(ring_end) {}

    std::size_t ring_count() const { return ring_end_ - ring_begin_; }
    RingView ring(std::size_t i) const {
        const std::size_t r = ring_begin_ + i;
        const std::uint32_t first = r == 0 ? 0 : ring_ends_[r - 1];
        return {points_ + first, points_ + ring_ends_[r]};
    }
    RingView outer() const { return ring(0); }
    std::size_t point_count() const {
        if (ring_count() == 0) return 0;
        return ring_ends_[ring_end_ - 1] - (ring_begin_ == 0 ? 0 : ring_ends_[ring_begin_ - 1]);
    }

private:
    const Point* points_ = nullptr;
    const std::uint32_t* ring_ends_ = nullptr;
    std::size_t ring_begin_ = 0, ring_end_ = 0;
};

struct Polygons {
    std::vector<Point> points;                // of all rings of all polygons
    std::vector<std::uint32_t> ring_ends;     // one past each ring's last point
    std::vector<std::uint32_t> polygon_ends;  // one past each polygon's last ring

    bool operator==(const Polygons&) const = default;

    std::size_t size() const { return polygon_ends.size(); }
    bool empty() const { return polygon_ends.empty(); }
    PolygonView operator[](std::size_t i) const {
        return {points.data(), ring_ends.data(), i == 0 ? 0 : polygon_ends[i - 1], polygon_ends[i]};
    }

    // Closes the ring of the points added since the last one ended, and the polygon of such rings.
    void end_ring() { ring_ends.push_back(static_cast<std::uint32_t>(points.size())); }
    void end_polygon() { polygon_ends.push_back(static_cast<std::uint32_t>(ring_ends.size())); }
    void add_ring(RingView ring) {
        points.insert(points.end(), ring.begin(), ring.end());
        end_ring();
    }
    void add(PolygonView polygon);         // a copy of one polygon, which must not be one of these
    void add_all(const Polygons& others);  // copies of all
    std::size_t memory_bytes() const {
        return points.capacity() * sizeof(Point) +
               (ring_ends.capacity() + polygon_ends.capacity()) * sizeof(std::uint32_t);
    }
};

Int128 doubled_area(RingView ring);     // exact, signed, in squared grid units
double area(RingView ring);             // px^2, signed
double area(PolygonView polygon);       // px^2: outer less holes
double area(const Polygons& polygons);  // px^2: their sum
Box bounds(RingView ring);
Box bounds(PolygonView polygon);  // of its outer ring
Box bounds(const Polygons& polygons);
Vec centroid(PolygonView polygon);  // px; the box's centre where the area is 0

// Where a point lies: +1 inside, 0 on the boundary, -1 outside. Exact. Linear in the points.
int locate(RingView ring, Point p);  // orientation of the ring does not matter
int locate(PolygonView polygon, Point p);

// Polygons from rings that do not cross: positive rings are outers, each negative ring is a hole of the
// smallest outer that holds it (an outer inside a hole of another is a polygon of its own, at any depth).
// Rings of zero area and holes that no outer holds are dropped. Order: outers as given, the holes of each as
// given. Rings may touch at points and share edges. O(points log points); where rings cross all the same, the
// rings come out whole but a hole may land with the wrong outer.
Polygons nest_rings(const std::vector<std::vector<Point>>& rings);

}  // namespace filigree
