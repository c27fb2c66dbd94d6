#include "plane/ring_loops.h"

#include <algorithm>
#include <numeric>

namespace filigree {

void start_at_least(std::span<Point> ring) {
    if (ring.empty()) return;
    std::size_t best = 0;
    for (std::size_t i = 1; i < ring.size(); ++i) {
        if (ring[best] < ring[i]) continue;
        if (ring[i] == ring[best]) {
            std::size_t n = 1;
            const auto at = [&](std::size_t start) { return ring[(start + n) % ring.size()]; };
            while (n < ring.size() && at(i) == at(best)) ++n;
            if (!(at(i) < at(best))) continue;
        }
        best = i;
    }
    std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(best), ring.end());
}

std::vector<std::vector<Point>> split_loops(RingView ring) {
    std::vector<std::size_t> order(ring.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return ring[a] != ring[b] ? ring[a] < ring[b] : a < b; });
    std::vector<std::size_t> first_of(ring.size());  // the first index with the same point
    for (std::size_t i = 0; i < order.size(); ++i) {
        first_of[order[i]] = i > 0 && ring[order[i]] == ring[order[i - 1]] ? first_of[order[i - 1]] : order[i];
    }
    constexpr std::size_t none = SIZE_MAX;
    std::vector<std::size_t> depth_of(ring.size(), none);  // of a point (by its first index) on the stack
    std::vector<std::size_t> stack;
    std::vector<std::vector<Point>> loops;
    const auto close = [&](std::size_t depth) {
        if (stack.size() - depth >= 3) {
            std::vector<Point>& loop = loops.emplace_back();
            for (std::size_t i = depth; i < stack.size(); ++i) loop.push_back(ring[stack[i]]);
        }
        for (std::size_t i = depth; i < stack.size(); ++i) depth_of[stack[i]] = none;
        stack.resize(depth);
    };
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const std::size_t point = first_of[i];
        if (depth_of[point] != none) close(depth_of[point]);
        depth_of[point] = stack.size();
        stack.push_back(point);
    }
    close(0);
    return loops;
}

RingFinder::RingFinder(std::vector<Point> points) : sums_(points.size()) {
    queries_.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) queries_.push_back({points[i], i});
    std::sort(queries_.begin(), queries_.end(), [](const Query& a, const Query& b) {
        return a.point != b.point ? a.point < b.point : a.index < b.index;
    });
}

void RingFinder::add_edge(Point a, Point b, std::int64_t ring) {
    const std::int64_t turn = a.x < b.x ? 1 : -1;
    if (turn < 0) std::swap(a, b);
    auto query = std::lower_bound(queries_.begin(), queries_.end(), a.x,
                                  [](const Query& q, std::int64_t x) { return q.point.x < x; });
    for (; query != queries_.end() && query->point.x < b.x; ++query) {
        if (orientation(a, b, query->point) <= 0) continue;
        sums_[query->index].turns += turn;
        sums_[query->index].ring_turns += turn * ring;
    }
}

std::int64_t RingFinder::ring_of(std::size_t point) const {
    return sums_[point].turns == 1 ? sums_[point].ring_turns : -1;
}

}  // namespace filigree
