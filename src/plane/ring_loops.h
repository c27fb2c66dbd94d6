// Small services for rings: a canonical start, loops between repeated points, and finding the ring around
// each of many points.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plane/polygon.h"

namespace filigree {

// Turns a ring so that it starts at its lexicographically least point; where that comes several times, at
// the one whose followers are least.
void start_at_least(std::span<Point> ring);

// The simple loops of a ring that comes to some points more than once; each keeps the ring's direction.
// Loops of fewer than three points are left out.
std::vector<std::vector<Point>> split_loops(RingView ring);

// For many points: the number of the ring that holds each, of rings with positive area and disjoint insides.
// Every edge looks up only the points above it: O((edges + points) log points + pairs found).
class RingFinder {
public:
    explicit RingFinder(std::vector<Point> points);
    void add_edge(Point a, Point b, std::int64_t ring);
    std::int64_t ring_of(std::size_t point) const;  // -1 where none, or several, do

private:
    struct Query {
        Point point;
        std::size_t index = 0;
    };
    struct Sum {
        std::int64_t turns = 0;
        std::int64_t ring_turns = 0;  // each turn times the ring's number: the number itself in the end
    };
    std::vector<Query> queries_;  // by x
    std::vector<Sum> sums_;
};

}  // namespace filigree
