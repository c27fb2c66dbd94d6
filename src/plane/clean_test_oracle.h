// What the tests of polygons and of cleaning share: random outlines, and slow, independent answers.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/test_cases.h"
#include "plane/polygon.h"

namespace filigree::oracle {

constexpr std::int64_t px = std::int64_t{1} << 26;

using Ring = std::vector<Point>;
using Rings = std::vector<Ring>;

// Seconds that a test of speed may take: seconds of work where quadratic ways would take minutes.
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define FILIGREE_SLOW_BUILD
#endif
#endif
#if defined(FILIGREE_SLOW_BUILD) || defined(__SANITIZE_ADDRESS__) || !defined(__OPTIMIZE__)
constexpr double patience = 30;
#else
constexpr double patience = 5;
#endif
#undef FILIGREE_SLOW_BUILD

inline Ring random_ring(CaseRandom& random, std::int64_t points, std::int64_t size, std::int64_t step) {
    Ring ring;
    for (std::int64_t i = 0; i < points; ++i) {
        const std::int64_t x = random.whole(0, size), y = random.whole(0, size);
        ring.push_back({x * step, y * step});
    }
    return ring;
}

inline Ring scaled(Ring ring, std::int64_t by = px) {
    for (Point& p : ring) p = {p.x * by, p.y * by};
    return ring;
}

inline Rings rings_of(const Polygons& polygons) {
    Rings rings;
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        for (std::size_t r = 0; r < polygons[i].ring_count(); ++r) {
            const RingView ring = polygons[i].ring(r);
            rings.emplace_back(ring.begin(), ring.end());
        }
    }
    return rings;
}

struct LongVec {
    long double x = 0, y = 0;
};
struct LongEdge {
    LongVec low, high;  // by y
    int turn = 0;
};
inline std::vector<LongEdge> edges_by_y(const Rings& rings) {
    std::vector<LongEdge> edges;
    for (const Ring& ring : rings) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point a = ring[i], b = ring[(i + 1) % ring.size()];
            const LongVec p{static_cast<long double>(a.x), static_cast<long double>(a.y)};
            const LongVec q{static_cast<long double>(b.x), static_cast<long double>(b.y)};
            if (a.y < b.y) edges.push_back({p, q, 1});
            if (a.y > b.y) edges.push_back({q, p, -1});
        }
    }
    return edges;
}
inline long double x_at(const LongEdge& edge, long double y) {
    return edge.low.x + (edge.high.x - edge.low.x) * ((y - edge.low.y) / (edge.high.y - edge.low.y));
}

// The area in squared grid units by trapezoids between all heights at which anything happens.
template <class IsIn>
long double scan_line_area(const std::vector<LongEdge>& edges, const IsIn& is_in) {
    std::vector<long double> heights;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        heights.push_back(edges[i].low.y);
        heights.push_back(edges[i].high.y);
        for (std::size_t j = 0; j < i; ++j) {
            const LongEdge &a = edges[i], &b = edges[j];
            const long double ax = a.high.x - a.low.x, ay = a.high.y - a.low.y;
            const long double bx = b.high.x - b.low.x, by = b.high.y - b.low.y;
            const long double turn = ax * by - ay * bx;
            if (turn == 0) continue;
            const long double y = a.low.y + ((b.low.x - a.low.x) * by - (b.low.y - a.low.y) * bx) / turn * ay;
            if (y > std::max(a.low.y, b.low.y) && y < std::min(a.high.y, b.high.y)) heights.push_back(y);
        }
    }
    std::sort(heights.begin(), heights.end());
    struct Hit {
        long double x = 0;
        int turn = 0;
    };
    long double area = 0;
    std::vector<Hit> hits;
    for (std::size_t k = 0; k + 1 < heights.size(); ++k) {
        const long double middle = (heights[k] + heights[k + 1]) / 2;
        hits.clear();
        for (const LongEdge& edge : edges) {
            if (edge.low.y < middle && middle < edge.high.y) hits.push_back({x_at(edge, middle), edge.turn});
        }
        std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) { return a.x < b.x; });
        int winding = 0;
        for (std::size_t i = 0; i + 1 < hits.size(); ++i) {
            winding += hits[i].turn;
            if (is_in(winding)) area += (hits[i + 1].x - hits[i].x) * (heights[k + 1] - heights[k]);
        }
    }
    return area;
}
inline long double area_nonzero(const Rings& rings) {
    return scan_line_area(edges_by_y(rings), [](int winding) { return winding != 0; });
}
inline long double area_even_odd(const Rings& rings) {
    return scan_line_area(edges_by_y(rings), [](int winding) { return winding % 2 != 0; });
}

// The winding number about a point that lies on no edge, and how near (in grid units) the nearest edge is.
struct Winding {
    int number = 0;
    long double distance = 1e30L;
};
inline Winding winding_at(const Rings& rings, Point p) {
    Winding out;
    const LongVec at{static_cast<long double>(p.x), static_cast<long double>(p.y)};
    for (const Ring& ring : rings) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point from = ring[i], to = ring[(i + 1) % ring.size()];
            const LongVec a{static_cast<long double>(from.x) - at.x, static_cast<long double>(from.y) - at.y};
            const LongVec b{static_cast<long double>(to.x) - at.x, static_cast<long double>(to.y) - at.y};
            const LongVec d{b.x - a.x, b.y - a.y};
            const long double squared = d.x * d.x + d.y * d.y;
            long double part = squared == 0 ? 0 : -(a.x * d.x + a.y * d.y) / squared;
            part = std::clamp(part, 0.0L, 1.0L);
            const LongVec nearest{a.x + part * d.x, a.y + part * d.y};
            out.distance = std::min(out.distance, std::sqrt(nearest.x * nearest.x + nearest.y * nearest.y));
            const long double side = a.x * b.y - a.y * b.x;  // quarter turns would do; a ray upwards is shorter
            if (a.x <= 0 && b.x > 0 && side > 0) ++out.number;
            if (a.x > 0 && b.x <= 0 && side < 0) --out.number;
        }
    }
    return out;
}

// Whether two edges cross, share a piece, or one has a neighbour's point inside it where that is not allowed.
inline bool is_crossing(Point a, Point b, Point c, Point d) {
    const auto turn = [](Point p, Point q, Point r) {
        const Int128 value = Int128{q.x - p.x} * (r.y - p.y) - Int128{q.y - p.y} * (r.x - p.x);
        return value == 0 ? 0 : value > 0 ? 1 : -1;
    };
    const int ac = turn(a, b, c), ad = turn(a, b, d), ca = turn(c, d, a), cb = turn(c, d, b);
    if (ac == 0 && ad == 0) {
        const auto along = [&](Point p) { return Int128{b.x - a.x} * (p.x - a.x) + Int128{b.y - a.y} * (p.y - a.y); };
        const Int128 low = std::min(along(c), along(d)), high = std::max(along(c), along(d));
        return std::max<Int128>(low, 0) < std::min<Int128>(high, along(b));
    }
    return ac * ad < 0 && ca * cb < 0;
}
inline bool has_crossing(const Rings& rings) {
    struct Edge {
        Point a, b;
    };
    std::vector<Edge> edges;
    for (const Ring& ring : rings) {
        for (std::size_t i = 0; i < ring.size(); ++i) edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
    }
    for (std::size_t i = 0; i < edges.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (is_crossing(edges[i].a, edges[i].b, edges[j].a, edges[j].b)) return true;
        }
    }
    return false;
}

}  // namespace filigree::oracle
