#include "plane/clean.h"

#include <algorithm>

#include "plane/noding.h"
#include "plane/overlay.h"

namespace filigree {

namespace {

using Rings = std::vector<std::vector<Point>>;

bool is_on_grid(Point p) { return p.x >= -grid_limit && p.x <= grid_limit && p.y >= -grid_limit && p.y <= grid_limit; }

// Without the points that lie on the straight line between their neighbours. The ring has an area and does
// not turn back on itself.
std::vector<Point> without_straight_points(const std::vector<Point>& ring) {
    std::vector<Point> corners;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point before = corners.empty() ? ring.back() : corners.back();
        const Point after = ring[i + 1 == ring.size() ? 0 : i + 1];
        if (orientation(before, ring[i], after) != 0) corners.push_back(ring[i]);
    }
    return corners;
}

bool is_higher(Point a, Point b) { return a.y != b.y ? a.y < b.y : a.x < b.x; }

void start_at_highest(std::vector<Point>& ring) {
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end(), is_higher), ring.end());
}

bool comes_before(RingView a, RingView b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), is_higher);
}

// The same region always comes out in the same order, whatever made it.
Polygons in_order(Rings rings) {
    for (std::vector<Point>& ring : rings) {
        ring = without_straight_points(ring);
        start_at_highest(ring);
    }
    std::sort(rings.begin(), rings.end(),
              [](const std::vector<Point>& a, const std::vector<Point>& b) { return comes_before(a, b); });
    return nest_rings(rings);
}

void append_polygons(std::vector<WeightedEdge>& edges, const Polygons& polygons, Winding weight) {
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        const PolygonView polygon = polygons[i];
        for (std::size_t r = 0; r < polygon.ring_count(); ++r) append_edges(edges, polygon.ring(r), weight);
    }
}

Polygons overlay(const Polygons& a, const Polygons& b, Region region) {
    std::vector<WeightedEdge> edges;
    append_polygons(edges, a, {1, 0});
    append_polygons(edges, b, {0, 1});
    node_edges(edges, false);
    return in_order(boundary(std::move(edges), region));
}

}  // namespace

Polygons clean(const std::vector<Polyline>& outlines, FillRule rule) {
    Rings rings;
    for (const Polyline& outline : outlines) {
        if (!std::all_of(outline.points.begin(), outline.points.end(), is_on_plane)) continue;
        std::vector<Point>& ring = rings.emplace_back();
        ring.reserve(outline.points.size());
        for (const Vec p : outline.points) ring.push_back(snap(p));
    }
    return clean(rings, rule);
}

Polygons clean(const Rings& rings, FillRule rule) {
    std::vector<WeightedEdge> edges;
    for (const std::vector<Point>& ring : rings) {
        if (std::all_of(ring.begin(), ring.end(), is_on_grid)) append_edges(edges, ring, {1, 0});
    }
    const bool parity = rule == FillRule::even_odd;
    node_edges(edges, parity);
    return in_order(boundary(std::move(edges), parity ? Region::first_odd : Region::first));
}

Polygons unite(const Polygons& a, const Polygons& b) { return overlay(a, b, Region::either); }
Polygons subtract(const Polygons& a, const Polygons& b) { return overlay(a, b, Region::only_first); }
Polygons intersect(const Polygons& a, const Polygons& b) { return overlay(a, b, Region::both); }

}  // namespace filigree
