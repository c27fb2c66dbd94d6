#include "plane/point_tree.h"

#include <algorithm>
#include <array>
#include <utility>

namespace filigree {
namespace {

constexpr std::uint32_t leaf_points = 8;
constexpr double rounding = 0x1p-45;  // relative, far above what the few operations below can lose

}  // namespace

PointTree::PointTree(std::vector<Point> points) : points_(std::move(points)) {
    std::sort(points_.begin(), points_.end());
    points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
    nodes_.reserve(points_.size() / (leaf_points / 2) + 1);
    if (!points_.empty()) build(0, static_cast<std::uint32_t>(points_.size()));
}

void PointTree::build(std::uint32_t begin, std::uint32_t end) {
    const std::size_t self = nodes_.size();
    Node node{{}, begin, end, 0};
    for (std::uint32_t i = begin; i < end; ++i) extend(node.box, points_[i]);
    nodes_.push_back(node);
    if (end - begin <= leaf_points) return;

    const std::uint32_t middle = begin + (end - begin) / 2;
    const bool along_x = node.box.max.x - node.box.min.x >= node.box.max.y - node.box.min.y;
    std::nth_element(points_.begin() + begin, points_.begin() + middle, points_.begin() + end,
                     [along_x](Point p, Point q) { return along_x ? p.x < q.x : p.y < q.y; });
    build(begin, middle);
    nodes_[self].high = static_cast<std::uint32_t>(nodes_.size());
    build(middle, end);
}

void PointTree::find_near(Point a, Point b, double distance, std::vector<Point>& found) const {
    if (nodes_.empty()) return;
    const double dx = static_cast<double>(b.x - a.x), dy = static_cast<double>(b.y - a.y);
    const double width = std::fabs(dx), height = std::fabs(dy);
    // No vertex is farther from another than 2^58, so that much room is as good as more.
    const double room = std::min(distance, 0x1p58) + 1;
    const std::int64_t reach = static_cast<std::int64_t>(room) + 1;
    const Box around{{std::min(a.x, b.x) - reach, std::min(a.y, b.y) - reach},
                     {std::max(a.x, b.x) + reach, std::max(a.y, b.y) + reach}};
    const double off_line = room * (width + height);  // at least room times the length

    std::array<std::uint32_t, 64> stack;
    std::size_t waiting = 0;
    stack[waiting++] = 0;
    while (waiting > 0) {
        const std::uint32_t index = stack[--waiting];
        const Node& node = nodes_[index];
        if (!overlaps(node.box, around)) continue;
        const double half_width = static_cast<double>(node.box.max.x - node.box.min.x) / 2;
        const double half_height = static_cast<double>(node.box.max.y - node.box.min.y) / 2;
        const double to_x = static_cast<double>(node.box.min.x - a.x) + half_width;
        const double to_y = static_cast<double>(node.box.min.y - a.y) + half_height;
        const double lost = rounding * (width * std::fabs(to_y) + height * std::fabs(to_x));
        if (std::fabs(dx * to_y - dy * to_x) > width * half_height + height * half_width + off_line + lost) continue;
        if (node.high != 0) {
            stack[waiting++] = node.high;
            stack[waiting++] = index + 1;
            continue;
        }
        for (std::uint32_t i = node.begin; i < node.end; ++i) {
            const Point p = points_[i];
            if (!overlaps(Box{p, p}, around)) continue;
            const double px = static_cast<double>(p.x - a.x), py = static_cast<double>(p.y - a.y);
            if (std::fabs(dx * py - dy * px) > off_line + rounding * (width * std::fabs(py) + height * std::fabs(px))) {
                continue;
            }
            found.push_back(p);
        }
    }
}

}  // namespace filigree
