#include "plane/inset_check.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace filigree {

namespace {

// As point.h's orientation, by doubles where they decide.
int fast_orientation(Point a, Point b, Point c) {
    const double left = static_cast<double>(b.x - a.x) * static_cast<double>(c.y - a.y);
    const double right = static_cast<double>(b.y - a.y) * static_cast<double>(c.x - a.x);
    const double turn = left - right;
    const double uncertain = 1e-15 * (std::fabs(left) + std::fabs(right));
    if (turn > uncertain) return 1;
    if (turn < -uncertain) return -1;
    return orientation(a, b, c);
}

bool boxes_meet(Point a, Point b, Point c, Point d) {
    return std::min(a.x, b.x) <= std::max(c.x, d.x) && std::min(c.x, d.x) <= std::max(a.x, b.x) &&
           std::min(a.y, b.y) <= std::max(c.y, d.y) && std::min(c.y, d.y) <= std::max(a.y, b.y);
}

// Whether the closed segments ab and cd have a point in common.
bool segments_meet(Point a, Point b, Point c, Point d) {
    if (!boxes_meet(a, b, c, d)) return false;
    if (fast_orientation(a, b, c) * fast_orientation(a, b, d) > 0) return false;
    return fast_orientation(c, d, a) * fast_orientation(c, d, b) <= 0;
}

// Whether the path a, b, c turns back onto itself.
bool turns_back(Point a, Point b, Point c) {
    if (fast_orientation(a, b, c) != 0) return false;
    const Int128 along = static_cast<Int128>(b.x - a.x) * (c.x - b.x) + static_cast<Int128>(b.y - a.y) * (c.y - b.y);
    return along < 0;
}

bool comes_nearer(const Edge& f, const Edge& e, double reach2) {
    const Vec es = e.to - e.from;
    const double from_side = cross(es, f.from - e.from);
    const double to_side = cross(es, f.to - e.from);
    // Most edges lie beyond the other's line as a whole.
    const double least = std::min(from_side, to_side);
    if (least > 0 && least * least >= reach2 * dot(es, es)) return false;
    if (is_nearer(e, f.from, reach2) || is_nearer(f, e.from, reach2)) return true;
    if (from_side * to_side > 0) return false;
    const Vec fs = f.to - f.from;
    return cross(fs, e.from - f.from) * cross(fs, e.to - f.from) <= 0;
}

}  // namespace

double inset_slack(double distance, const Box& shape_box) {
    const double size = std::max(static_cast<double>(shape_box.max.x) - static_cast<double>(shape_box.min.x),
                                 static_cast<double>(shape_box.max.y) - static_cast<double>(shape_box.min.y));
    return std::min(std::max(5e-7, size / grid_per_px * 0x1p-44), distance / 2);
}

bool are_simple_and_apart(std::span<const RingView> rings, Point origin) {
    std::vector<Point> from, to;
    std::vector<std::uint32_t> next;
    std::vector<Edge> edges;
    std::size_t count = 0;
    for (const RingView ring : rings) count += ring.size();
    from.reserve(count);
    to.reserve(count);
    next.reserve(count);
    edges.reserve(count);
    for (const RingView ring : rings) {
        const std::size_t n = ring.size();
        if (n < 3) return false;
        const auto first = static_cast<std::uint32_t>(next.size());
        for (std::size_t i = 0; i < n; ++i) {
            const Point b = ring[i + 1 < n ? i + 1 : 0];
            if (ring[i] == b || turns_back(ring[i], b, ring[i + 2 < n ? i + 2 : i + 2 - n])) return false;
            from.push_back(ring[i]);
            to.push_back(b);
            next.push_back(i + 1 < n ? static_cast<std::uint32_t>(next.size() + 1) : first);
            edges.push_back({to_px(ring[i], origin), to_px(b, origin)});
        }
    }
    const EdgeTree tree(std::move(edges));
    const std::span<const Edge> all = tree.edges();
    for (std::uint32_t first = 0; first < next.size(); first += 4) {
        const std::size_t few = std::min<std::size_t>(4, next.size() - first);
        const bool meets = tree.any_near(all.subspan(first, few), 0, first, [&](std::size_t k, std::uint32_t j) {
            const auto i = static_cast<std::uint32_t>(first + k);
            return i < j && next[i] != j && next[j] != i && segments_meet(from[i], to[i], from[j], to[j]);
        });
        if (meets) return false;
    }
    return true;
}

bool keep_away(std::span<const RingView> rings, Point origin, const EdgeTree& boundary, double reach) {
    const double reach2 = reach * reach;
    for (const RingView ring : rings) {
        if (ring.empty()) continue;
        std::array<Edge, 4> few;
        Vec last = to_px(ring.back(), origin);
        for (std::size_t first = 0; first < ring.size(); first += 4) {
            const std::size_t count = std::min<std::size_t>(4, ring.size() - first);
            for (std::size_t k = 0; k < count; ++k) {
                const Vec next = to_px(ring[first + k], origin);
                few[k] = {last, next};
                last = next;
            }
            const bool meets = boundary.any_near({few.data(), count}, reach, 0, [&](std::size_t k, std::uint32_t e) {
                return comes_nearer(few[k], boundary.edges()[e], reach2);
            });
            if (meets) return false;
        }
    }
    return true;
}

}  // namespace filigree
