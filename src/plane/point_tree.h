// A set of points, arranged so that those near a segment are found in time logarithmic in the set.
//
// A balanced k-d tree with a few points to a leaf, so clusters of any density cost nothing extra.
#pragma once

#include <cstdint>
#include <vector>

#include "plane/point.h"

namespace filigree {

class PointTree {
public:
    // Equal points count once. All must lie on the plane (|x| <= grid_limit).
    explicit PointTree(std::vector<Point> points);

    // Appends all points within `distance` grid units of the segment (and a few that are a little farther).
    void find_near(Point a, Point b, double distance, std::vector<Point>& found) const;

private:
    struct Node {
        Box box;
        std::uint32_t begin = 0, end = 0;  // its points
        std::uint32_t high = 0;            // its second child; the first follows it; 0 for a leaf
    };
    void build(std::uint32_t begin, std::uint32_t end);

    std::vector<Point> points_;
    std::vector<Node> nodes_;
};

}  // namespace filigree
