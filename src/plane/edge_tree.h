// A tree of boxes over a set of edges: is anything near this point, how near, and is it inside?
//
// Edges are taken four at a time in the order given, boxes again by four, so that building is one pass and
// neighbours along a ring stay together; there is no cell size to choose, and tiny and huge shapes cost the
// same. Answers do not depend on the order of the edges, to the last bit. Coordinates are px relative to an
// origin that the caller chooses. Queries cost O(log n) and the size of the answer for edges given in a good
// order, as `edges_of` gives them.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "plane/polygon.h"

namespace filigree {

struct Edge {
    Vec from, to;
};

struct VecBox {  // px, closed
    Vec min, max;
};
inline bool overlaps(const VecBox& a, const VecBox& b) {
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
}
inline VecBox around(Vec p, double reach) { return {{p.x - reach, p.y - reach}, {p.x + reach, p.y + reach}}; }
inline VecBox around(const Edge& e, double reach) {
    return {{std::min(e.from.x, e.to.x) - reach, std::min(e.from.y, e.to.y) - reach},
            {std::max(e.from.x, e.to.x) + reach, std::max(e.from.y, e.to.y) + reach}};
}

// Whether the edge comes nearer to p than the square root of `reach2`; free of divisions.
inline bool is_nearer(const Edge& e, Vec p, double reach2) {
    const Vec along = e.to - e.from;
    const Vec to_p = p - e.from;
    const double s = dot(to_p, along);
    if (s <= 0) return dot(to_p, to_p) < reach2;
    const double length2 = dot(along, along);
    if (s >= length2) return dot(p - e.to, p - e.to) < reach2;
    const double c = cross(along, to_p);
    return c * c < reach2 * length2;
}
double squared_distance(const Edge& e, Vec p);

class EdgeTree {
public:
    explicit EdgeTree(std::vector<Edge> edges);

    const std::vector<Edge>& edges() const { return edges_; }

    // Calls visit(index) for the edges whose boxes meet `box` (and some more that are within 1e-6 of their
    // coordinates from it), in order, until one returns true; whether one did.
    template <class Visit>
    bool any(const VecBox& box, Visit visit) const;
    // The same for up to four edges that lie close together, widened by `reach`: visit(which of them, index) in
    // no special order, for indices in the groups of four from that of `first` on.
    template <class Visit>
    bool any_near(std::span<const Edge> few, double reach, std::uint32_t first, Visit visit) const;

    bool is_any_nearer(Vec p, double reach) const;
    // How near the nearest edge is, or `at_most` where none is nearer than that, and which side p is on. For
    // clean polygons only: the nearest edge or corner within `sight` tells the side, and a ray is sent only where
    // none does.
    struct Place {
        double distance = 0;
        bool is_inside = false;
        Vec nearest;  // on the boundary; p itself where none was looked at
    };
    Place place(Vec p, double at_most, double sight) const;
    // Whether a point off the edges lies inside the rings that they form, by the even-odd rule.
    bool is_inside(Vec p) const;

private:
    // Four boxes side by side, rounded outwards: they only decide where to look. Maxima are kept negated, so
    // that two boxes meet where all four numbers of one are at most the negated opposites of the other.
    struct Boxes {
        std::array<float, 4> min_x, min_y, minus_max_x, minus_max_y;
    };
    struct Probe {  // the box asked about: its maxima, then its negated minima
        float max_x, max_y, minus_min_x, minus_min_y;
    };
    static Probe probe_of(const VecBox& box);
    static unsigned meeting(const Boxes& boxes, const Probe& probe);  // bit i for box i
    struct Nearest {
        double squared_distance = 0;
        double turn = 0;  // above 0: p is inside; 0: that cannot be told
        bool was_found = false;
        Vec point;
    };
    Nearest nearest(Vec p, double at_most) const;
    template <class VisitGroup>
    bool any_group(const Probe& probe, std::uint32_t first_group, VisitGroup visit_group) const;

    std::vector<Edge> edges_;
    std::vector<Boxes> boxes_;                 // level by level, those of the edges first
    std::vector<std::uint32_t> level_starts_;  // of each level in boxes_
};

// The edges of all rings of a shape relative to `origin`; many rings in an order that keeps near ones together.
// Rings of fewer than three points have none.
std::vector<Edge> edges_of(PolygonView shape, Point origin);

// A point relative to an origin; exact while they are no more than 2^27 px apart.
inline Vec to_px(Point p, Point origin) { return to_px(Point{p.x - origin.x, p.y - origin.y}); }

inline EdgeTree::Probe EdgeTree::probe_of(const VecBox& box) {
    const auto above = [](double v) { return static_cast<float>(v + std::fabs(v) * 0x1p-22); };
    return {above(box.max.x), above(box.max.y), above(-box.min.x), above(-box.min.y)};
}

inline unsigned EdgeTree::meeting(const Boxes& boxes, const Probe& probe) {
#if defined(__SSE2__)
    const __m128 x = _mm_and_ps(_mm_cmple_ps(_mm_loadu_ps(boxes.min_x.data()), _mm_set1_ps(probe.max_x)),
                                _mm_cmple_ps(_mm_loadu_ps(boxes.minus_max_x.data()), _mm_set1_ps(probe.minus_min_x)));
    const __m128 y = _mm_and_ps(_mm_cmple_ps(_mm_loadu_ps(boxes.min_y.data()), _mm_set1_ps(probe.max_y)),
                                _mm_cmple_ps(_mm_loadu_ps(boxes.minus_max_y.data()), _mm_set1_ps(probe.minus_min_y)));
    return static_cast<unsigned>(_mm_movemask_ps(_mm_and_ps(x, y)));
#else
    unsigned bits = 0;
    for (unsigned i = 0; i < 4; ++i) {
        const bool meets = (boxes.min_x[i] <= probe.max_x) & (boxes.minus_max_x[i] <= probe.minus_min_x) &
                           (boxes.min_y[i] <= probe.max_y) & (boxes.minus_max_y[i] <= probe.minus_min_y);
        bits |= static_cast<unsigned>(meets) << i;
    }
    return bits;
#endif
}

template <class VisitGroup>
bool EdgeTree::any_group(const Probe& probe, std::uint32_t first_group, VisitGroup visit_group) const {
    if (edges_.empty()) return false;
    struct Node {
        std::uint32_t level, index;
    };
    std::array<Node, 64> stack;  // 16 levels of 4 hold every 32-bit count; 3 stay behind at each
    std::size_t depth = 0;
    stack[depth++] = {static_cast<std::uint32_t>(level_starts_.size() - 1), 0};
    while (depth > 0) {
        const Node node = stack[--depth];
        if (node.level == 0) {
            if (visit_group(node.index)) return true;
            continue;
        }
        const std::uint32_t child = node.index * 4;
        const std::uint32_t least = first_group >> (2 * (node.level - 1));
        for (unsigned bits = meeting(boxes_[level_starts_[node.level] + node.index], probe); bits != 0;) {
            const auto i = static_cast<std::uint32_t>(std::bit_width(bits) - 1);  // the last first: the first on top
            bits ^= 1U << i;
            if (child + i < least) break;
            stack[depth++] = {node.level - 1, child + i};
        }
    }
    return false;
}

template <class Visit>
bool EdgeTree::any(const VecBox& box, Visit visit) const {
    const Probe probe = probe_of(box);
    return any_group(probe, 0, [&](std::uint32_t group) {
        for (unsigned bits = meeting(boxes_[group], probe); bits != 0; bits &= bits - 1) {
            if (visit(group * 4 + static_cast<std::uint32_t>(std::countr_zero(bits)))) return true;
        }
        return false;
    });
}

template <class Visit>
bool EdgeTree::any_near(std::span<const Edge> few, double reach, std::uint32_t first, Visit visit) const {
    std::array<Probe, 4> probes;
    const std::size_t count = std::min<std::size_t>(few.size(), 4);
    if (count == 0) return false;
    for (std::size_t k = 0; k < count; ++k) probes[k] = probe_of(around(few[k], reach));
    Probe all = probes[0];
    for (std::size_t k = 1; k < count; ++k) {
        all.max_x = std::max(all.max_x, probes[k].max_x);
        all.max_y = std::max(all.max_y, probes[k].max_y);
        all.minus_min_x = std::max(all.minus_min_x, probes[k].minus_min_x);
        all.minus_min_y = std::max(all.minus_min_y, probes[k].minus_min_y);
    }
    return any_group(all, first / 4, [&](std::uint32_t group) {
        for (std::size_t k = 0; k < count; ++k) {
            for (unsigned bits = meeting(boxes_[group], probes[k]); bits != 0; bits &= bits - 1) {
                if (visit(k, group * 4 + static_cast<std::uint32_t>(std::countr_zero(bits)))) return true;
            }
        }
        return false;
    });
}

}  // namespace filigree
