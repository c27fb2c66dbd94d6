#include "plane/crossings.h"

#include <algorithm>

namespace filigree {
namespace {

// Whether segments without a common end meet; their boxes must.
bool do_meet(Point a, Point b, Point c, Point d) {
    const int c_side = orientation(a, b, c), d_side = orientation(a, b, d);
    if (c_side * d_side > 0) return false;
    const int a_side = orientation(c, d, a), b_side = orientation(c, d, b);
    return a_side * b_side <= 0;
}

bool leave_in_one_direction(Point from, Point a, Point b) {
    if (orientation(from, a, b) != 0) return false;
    const auto sign = [](std::int64_t v) { return v > 0 ? 1 : v < 0 ? -1 : 0; };
    return sign(a.x - from.x) == sign(b.x - from.x) && sign(a.y - from.y) == sign(b.y - from.y);
}

}  // namespace

void CrossingFinder::look_at(const DirectedLink& a, const DirectedLink& b, std::span<const Point> at,
                             std::vector<std::uint32_t>& found) {
    if (a.from == b.to && a.to == b.from) return;
    const bool from_one = a.from == b.from, to_one = a.to == b.to;
    if (from_one) pinches_.push_back(a.from);
    std::uint32_t common = 0, a_other = a.from, b_other = b.to;
    if (from_one) {
        common = a.from;
        a_other = a.to;
    } else if (to_one) {
        common = a.to;
        b_other = b.from;
    } else if (a.to == b.from) {
        common = a.to;
    } else if (a.from == b.to) {
        common = a.from;
        a_other = a.to;
        b_other = b.from;
    } else {
        if (do_meet(at[a.from], at[a.to], at[b.from], at[b.to])) {
            found.insert(found.end(), {a.from, a.to, b.from, b.to});
        }
        return;
    }
    if (leave_in_one_direction(at[common], at[a_other], at[b_other])) {
        found.insert(found.end(), {common, a_other, b_other});
    }
}

// Around a vertex, edges that leave it and edges that come to it take turns.
void CrossingFinder::look_at_pinches(std::span<const DirectedLink> links, std::span<const Point> at,
                                     std::vector<std::uint32_t>& found) {
    std::sort(pinches_.begin(), pinches_.end());
    pinches_.erase(std::unique(pinches_.begin(), pinches_.end()), pinches_.end());
    struct Spoke {
        std::uint32_t hub = 0, other = 0;
        bool leaves = false;
    };
    std::vector<Spoke> spokes;
    const auto add = [&](std::uint32_t hub, std::uint32_t other, bool leaves) {
        if (std::binary_search(pinches_.begin(), pinches_.end(), hub)) spokes.push_back({hub, other, leaves});
    };
    for (const DirectedLink& link : links) {
        add(link.from, link.to, true);
        add(link.to, link.from, false);
    }
    std::sort(spokes.begin(), spokes.end(), [&](const Spoke& a, const Spoke& b) {
        if (a.hub != b.hub) return a.hub < b.hub;
        const Point hub = at[a.hub], p = at[a.other], q = at[b.other];
        const bool p_is_low = p < hub, q_is_low = q < hub;
        if (p_is_low != q_is_low) return q_is_low;
        const int turn = orientation(hub, p, q);
        if (turn != 0) return turn > 0;
        return a.other != b.other ? a.other < b.other : a.leaves < b.leaves;
    });
    for (std::size_t begin = 0, end = 0; begin < spokes.size(); begin = end) {
        std::vector<Spoke> around;
        for (end = begin; end < spokes.size() && spokes[end].hub == spokes[begin].hub; ++end) {
            const Spoke& spoke = spokes[end];
            // An edge and its reverse bound nothing.
            if (!around.empty() && around.back().other == spoke.other && around.back().leaves != spoke.leaves) {
                around.pop_back();
            } else {
                around.push_back(spoke);
            }
        }
        for (std::size_t i = 0; i < around.size(); ++i) {
            const Spoke& next = around[i + 1 == around.size() ? 0 : i + 1];
            if (around[i].leaves != next.leaves) continue;
            found.insert(found.end(), {around[i].hub, around[i].other, next.other});
        }
    }
}

void CrossingFinder::find(std::span<const DirectedLink> links, std::span<const Point> at,
                          std::vector<std::uint32_t>& found) {
    pinches_.clear();
    pairs_.clear();
    for (const DirectedLink& link : links) pairs_.add(at[link.from], at[link.to]);
    pairs_.for_each([&](std::uint32_t i, std::uint32_t j) { look_at(links[i], links[j], at, found); });
    if (!pinches_.empty()) look_at_pinches(links, at, found);
}

}  // namespace filigree
