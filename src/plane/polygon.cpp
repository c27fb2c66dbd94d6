#include "plane/polygon.h"

#include <algorithm>

namespace filigree {

namespace {

__extension__ typedef unsigned __int128 UInt128;

constexpr double doubled_units_per_px2 = 2 * grid_per_px * grid_per_px;

// Sums that can run over in Int128 only when thousands of areas as large as the plane are added.
struct AreaSum {
    Int128 exact = 0;
    double spilt = 0;

    void add(Int128 doubled) {
        Int128 sum = 0;
        if (__builtin_add_overflow(exact, doubled, &sum)) {
            spilt += static_cast<double>(exact);
            sum = doubled;
        }
        exact = sum;
    }
    double px2() const { return (static_cast<double>(exact) + spilt) / doubled_units_per_px2; }
};

}  // namespace

void Polygons::add(PolygonView polygon) {
    for (std::size_t r = 0; r < polygon.ring_count(); ++r) add_ring(polygon.ring(r));
    end_polygon();
}

void Polygons::add_all(const Polygons& others) {
    if (&others == this) return add_all(Polygons(others));
    const auto points_before = static_cast<std::uint32_t>(points.size());
    const auto rings_before = static_cast<std::uint32_t>(ring_ends.size());
    points.insert(points.end(), others.points.begin(), others.points.end());
    for (const std::uint32_t end : others.ring_ends) ring_ends.push_back(points_before + end);
    for (const std::uint32_t end : others.polygon_ends) polygon_ends.push_back(rings_before + end);
}

Int128 doubled_area(RingView ring) {
    if (ring.size() < 3) return 0;
    // A fan of triangles from the first point. Partial sums may leave Int128 where a ring winds about its
    // first point at the plane's full size; unsigned sums wrap and come back.
    UInt128 sum = 0;
    const Point origin = ring[0];
    Point last{ring[1].x - origin.x, ring[1].y - origin.y};
    for (std::size_t i = 2; i < ring.size(); ++i) {
        const Point next{ring[i].x - origin.x, ring[i].y - origin.y};
        sum += static_cast<UInt128>(static_cast<Int128>(last.x) * next.y - static_cast<Int128>(last.y) * next.x);
        last = next;
    }
    return static_cast<Int128>(sum);
}

double area(RingView ring) { return static_cast<double>(doubled_area(ring)) / doubled_units_per_px2; }

double area(PolygonView polygon) {
    AreaSum sum;
    for (std::size_t r = 0; r < polygon.ring_count(); ++r) sum.add(doubled_area(polygon.ring(r)));
    return sum.px2();
}

double area(const Polygons& polygons) {
    AreaSum sum;
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        const PolygonView polygon = polygons[i];
        for (std::size_t r = 0; r < polygon.ring_count(); ++r) sum.add(doubled_area(polygon.ring(r)));
    }
    return sum.px2();
}

Box bounds(RingView ring) {
    Box box;
    for (const Point p : ring) extend(box, p);
    return box;
}

Box bounds(PolygonView polygon) { return polygon.ring_count() == 0 ? Box{} : bounds(polygon.outer()); }

Box bounds(const Polygons& polygons) {
    Box box;
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        const Box one = bounds(polygons[i]);
        if (is_empty(one)) continue;
        extend(box, one.min);
        extend(box, one.max);
    }
    return box;
}

Vec centroid(PolygonView polygon) {
    if (polygon.ring_count() == 0 || polygon.outer().empty()) return {};
    const Box box = bounds(polygon);
    // About the first point, in grid units: differences and cross products are exact before they are rounded.
    const Point origin = polygon.outer()[0];
    AreaSum doubled;
    Vec moment;
    for (std::size_t r = 0; r < polygon.ring_count(); ++r) {
        const RingView ring = polygon.ring(r);
        doubled.add(doubled_area(ring));
        for (std::size_t i = 0, last = ring.size() - 1; i < ring.size(); last = i++) {
            const double weight = static_cast<double>(cross(origin, ring[last], ring[i]));
            moment.x +=
                weight * (static_cast<double>(ring[last].x - origin.x) + static_cast<double>(ring[i].x - origin.x));
            moment.y +=
                weight * (static_cast<double>(ring[last].y - origin.y) + static_cast<double>(ring[i].y - origin.y));
        }
    }
    const Vec low = to_px(box.min);
    const Vec high = to_px(box.max);
    const double doubled_units = static_cast<double>(doubled.exact) + doubled.spilt;
    if (doubled_units == 0) return 0.5 * (low + high);
    const Vec centre = to_px(origin) + moment * (1 / (3 * doubled_units) / grid_per_px);
    // Of slivers so little area remains that rounding could carry the quotient off.
    return {std::clamp(centre.x, low.x, high.x), std::clamp(centre.y, low.y, high.y)};
}

int locate(RingView ring, Point p) {
    // Crossings of the ray from p towards +x, edges half open in y. The cross product is formed only where p
    // lies in the box of an edge, so it is in range whatever p is.
    bool inside = false;
    for (std::size_t i = 0, last = ring.size() - 1; i < ring.size(); last = i++) {
        const Point a = ring[last];
        const Point b = ring[i];
        if ((a.y > p.y) == (b.y > p.y)) {
            if (a.y != p.y && b.y != p.y) continue;
            if (b == p) return 0;
            if (a.y == b.y && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x)) return 0;
            continue;
        }
        if (a.x < p.x && b.x < p.x) continue;
        if (a.x > p.x && b.x > p.x) {
            inside = !inside;
            continue;
        }
        const int side = orientation(a, b, p);
        if (side == 0) return 0;
        if ((side > 0) == (b.y > a.y)) inside = !inside;
    }
    return inside ? 1 : -1;
}

int locate(PolygonView polygon, Point p) {
    if (polygon.ring_count() == 0) return -1;
    const int at = locate(polygon.outer(), p);
    if (at <= 0) return at;
    for (std::size_t r = 1; r < polygon.ring_count(); ++r) {
        const int in_hole = locate(polygon.ring(r), p);
        if (in_hole >= 0) return -in_hole;
    }
    return 1;
}

}  // namespace filigree
