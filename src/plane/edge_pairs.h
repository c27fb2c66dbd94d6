// Which edges may meet: all pairs whose boxes overlap, among edges in an order that mostly keeps near ones together.
//
// A binary tree of boxes over the edges in their order. Stretches of edges that go on from each other within one
// quadrant are never searched: their points lie in order both of x and of y, so they meet only where one edge goes on
// from the other. Smooth outlines are made of few such stretches. O(n) and the pairs found, for outlines.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "plane/point.h"

namespace filigree {

class EdgePairs {
public:
    void clear() { edges_.clear(); }
    void add(Point a, Point b) {
        if (b < a) std::swap(a, b);
        edges_.push_back({a, b, a.y <= b.y, Way::none, 0});
        read_run();
    }

    // Calls visit(i, j), i < j, for the pairs, in no special order: for all that meet elsewhere than where one goes on
    // from the other, and for more.
    template <class Visit>
    void for_each(Visit visit) {
        if (edges_.empty()) return;
        build();
        within(1, leaves_, visit);
    }

private:
    static constexpr std::size_t leaf_size = 4;

    // Where an edge goes on from the one before it.
    enum class Way : std::uint8_t { none, right, left };
    struct Edge {
        Point low, high;
        bool rises = false;  // from left to right
        Way way = Way::none;
        std::uint32_t run_begin = 0;  // the first edge of the stretch within one quadrant
    };

    void read_run() {
        const std::size_t last = edges_.size() - 1;
        Edge& edge = edges_[last];
        edge.run_begin = static_cast<std::uint32_t>(last);
        if (last == 0) return;
        const Edge& before = edges_[last - 1];
        if (edge.rises != before.rises || edge.low == edge.high || before.low == before.high) return;
        if (edge.low == before.high) edge.way = Way::right;
        if (edge.high == before.low) edge.way = Way::left;
        if (edge.way == Way::none) return;
        edge.run_begin = edge.way == before.way ? before.run_begin : static_cast<std::uint32_t>(last - 1);
    }

    void build() {
        leaves_ = 1;
        while (leaves_ * leaf_size < edges_.size()) leaves_ *= 2;
        boxes_.assign(2 * leaves_, {});
        for (std::size_t i = 0; i < edges_.size(); ++i) add_to(boxes_[leaves_ + i / leaf_size], box_of(edges_[i]));
        for (std::size_t node = leaves_; node-- > 1;) {
            add_to(boxes_[node], boxes_[2 * node]);
            add_to(boxes_[node], boxes_[2 * node + 1]);
        }
    }

    static Box box_of(const Edge& edge) {
        const Point a = edge.low, b = edge.high;
        return edge.rises ? Box{a, b} : Box{{a.x, b.y}, {b.x, a.y}};
    }
    static void add_to(Box& box, const Box& other) {
        box = {{std::min(box.min.x, other.min.x), std::min(box.min.y, other.min.y)},
               {std::max(box.max.x, other.max.x), std::max(box.max.y, other.max.y)}};
    }

    // `span`: of how many leaves the node consists.
    std::size_t begin_of(std::size_t node, std::size_t span) const { return (node * span - leaves_) * leaf_size; }
    std::size_t end_of(std::size_t node, std::size_t span) const {
        return std::min(begin_of(node, span) + span * leaf_size, edges_.size());
    }
    bool is_one_run(std::size_t begin, std::size_t end) const {
        return end <= begin || edges_[end - 1].run_begin <= begin;
    }

    template <class Visit>
    void within(std::size_t node, std::size_t span, Visit& visit) {
        const std::size_t begin = begin_of(node, span), end = end_of(node, span);
        if (is_one_run(begin, end)) return;
        if (span > 1) {
            within(2 * node, span / 2, visit);
            within(2 * node + 1, span / 2, visit);
            between(2 * node, 2 * node + 1, span / 2, visit);
            return;
        }
        for (std::size_t i = begin; i < end; ++i) try_all(i, i + 1, end, visit);
    }
    template <class Visit>
    void between(std::size_t a, std::size_t b, std::size_t span, Visit& visit) {
        if (!overlaps(boxes_[a], boxes_[b])) return;
        if (b == a + 1 && is_one_run(begin_of(a, span), end_of(b, span))) return;
        if (span > 1) {
            between(2 * a, 2 * b, span / 2, visit);
            between(2 * a, 2 * b + 1, span / 2, visit);
            between(2 * a + 1, 2 * b, span / 2, visit);
            between(2 * a + 1, 2 * b + 1, span / 2, visit);
            return;
        }
        for (std::size_t i = begin_of(a, 1); i < end_of(a, 1); ++i) {
            if (overlaps(box_of(edges_[i]), boxes_[b])) try_all(i, begin_of(b, 1), end_of(b, 1), visit);
        }
    }
    template <class Visit>
    void try_all(std::size_t i, std::size_t begin, std::size_t end, Visit& visit) {
        const Box box = box_of(edges_[i]);
        for (std::size_t j = begin; j < end; ++j) {
            if (overlaps(box, box_of(edges_[j]))) visit(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j));
        }
    }

    std::vector<Edge> edges_;
    std::size_t leaves_ = 1;
    std::vector<Box> boxes_;  // a heap: node n has the children 2n and 2n + 1
};

}  // namespace filigree
