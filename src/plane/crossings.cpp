#include "plane/crossings.h"

#include <algorithm>
#include <array>
#include <utility>

#include "plane/edge_tree.h"

namespace filigree {
namespace {

constexpr std::size_t few = 20;  // links that are compared each with each

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

Box box_of(Point a, Point b) {
    return {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
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
    if (links.size() <= few) {
        boxes_.clear();
        for (const DirectedLink& link : links) boxes_.push_back(box_of(at[link.from], at[link.to]));
        for (std::size_t i = 0; i < links.size(); ++i) {
            for (std::size_t j = i + 1; j < links.size(); ++j) {
                if (overlaps(boxes_[i], boxes_[j])) look_at(links[i], links[j], at, found);
            }
        }
    } else {
        const Point origin = at[links[0].from];
        std::vector<Edge> edges;
        edges.reserve(links.size());
        for (const DirectedLink& link : links) {
            edges.push_back({to_px(at[link.from], origin), to_px(at[link.to], origin)});
        }
        const EdgeTree tree(std::move(edges));
        for (std::size_t first = 0; first < links.size(); first += 4) {
            const std::size_t count = std::min<std::size_t>(4, links.size() - first);
            tree.any_near(std::span(tree.edges()).subspan(first, count), 0, static_cast<std::uint32_t>(first),
                          [&](std::size_t which, std::uint32_t other) {
                              if (other > first + which) look_at(links[first + which], links[other], at, found);
                              return false;
                          });
        }
    }
    if (!pinches_.empty()) look_at_pinches(links, at, found);
}

}  // namespace filigree
