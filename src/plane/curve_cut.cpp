#include "plane/curve_cut.h"

#include <algorithm>

#include "plane/curve_cut_edges.h"
#include "plane/curve_cut_graph.h"
#include "plane/ring_loops.h"

namespace filigree {
namespace {

constexpr std::size_t most_edges = std::size_t{1} << 30;

// The shape as it is, but for where rings start and in what order its holes come.
Polygons whole(PolygonView shape) {
    std::vector<std::vector<Point>> rings;
    for (std::size_t r = 0; r < shape.ring_count(); ++r) {
        rings.emplace_back(shape.ring(r).begin(), shape.ring(r).end());
        start_at_least(rings.back());
    }
    if (rings.size() > 1) std::sort(rings.begin() + 1, rings.end());
    Polygons result;
    for (const std::vector<Point>& ring : rings) result.add_ring(ring);
    result.end_polygon();
    return result;
}

// The curve's edges that can meet the box.
void append_curve(std::vector<CutEdge>& edges, const Polyline& curve, const Box& box) {
    if (curve.points.size() < 2) return;
    if (!std::all_of(curve.points.begin(), curve.points.end(), is_on_plane)) return;
    const auto add = [&](Point a, Point b) {
        if (a == b) return;
        Box own;
        extend(own, a);
        extend(own, b);
        if (overlaps(own, box)) edges.push_back({a, b});
    };
    Point last = snap(curve.points[0]);
    for (std::size_t i = 1; i < curve.points.size(); ++i) {
        const Point next = snap(curve.points[i]);
        add(last, next);
        last = next;
    }
    if (curve.closed) add(last, snap(curve.points[0]));
}

}  // namespace

Polygons cut_by_curves(PolygonView shape, std::span<const Polyline> curves) {
    if (shape.point_count() == 0) return {};
    const Box box = bounds(shape);
    std::vector<CutEdge> edges;
    for (std::size_t r = 0; r < shape.ring_count(); ++r) {
        const RingView ring = shape.ring(r);
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point next = ring[i + 1 == ring.size() ? 0 : i + 1];
            if (ring[i] != next) edges.push_back({ring[i], next, static_cast<std::uint32_t>(edges.size())});
        }
    }
    const std::size_t sides = edges.size();
    for (const Polyline& curve : curves) append_curve(edges, curve, box);
    if (edges.size() == sides || edges.size() > most_edges) return whole(shape);
    const Point origin{box.min.x / 2 + box.max.x / 2, box.min.y / 2 + box.max.y / 2};
    if (!cut_where_they_meet(edges, origin)) return whole(shape);
    return CutGraph(edges, origin).faces();
}

}  // namespace filigree
