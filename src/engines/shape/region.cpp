#include "engines/shape/region.h"

#include <algorithm>
#include <cmath>

namespace filigree::shape {
namespace {

bool is_inside(Vec p, const std::vector<Vec>& corners) {
    bool inside = false;
    for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
        const Vec a = corners[i], b = corners[j];
        if ((a.y > p.y) == (b.y > p.y)) continue;
        if (p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) inside = !inside;
    }
    return inside;
}

double distance_to_border(Vec p, const std::vector<Vec>& corners) {
    double least = 1e300;
    for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
        const Vec way = corners[i] - corners[j];
        const double size = dot(way, way);
        const double t = size > 0 ? std::clamp(dot(p - corners[j], way) / size, 0.0, 1.0) : 0;
        least = std::min(least, length(p - corners[j] - way * t));
    }
    return least;
}

bool is_deep(Vec p, const Region& region, double depth) {
    return is_inside(p, region.corners) && distance_to_border(p, region.corners) > depth;
}

// Where a segment crosses the border, as parts of its way, with both ends.
std::vector<double> crossings(Vec from, Vec to, const std::vector<Vec>& corners) {
    std::vector<double> at = {0, 1};
    for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
        const Vec side = corners[i] - corners[j], way = to - from;
        const double turn = cross(way, side);
        if (turn == 0) continue;
        const double along = cross(corners[j] - from, side) / turn, across = cross(corners[j] - from, way) / turn;
        if (along > 0 && along < 1 && across >= 0 && across <= 1) at.push_back(along);
    }
    std::sort(at.begin(), at.end());
    return at;
}

}  // namespace

Region transformed(const Region& region, const Transform& by) {
    Region moved = region;
    for (Vec& corner : moved.corners) corner = apply(by, corner);
    moved.error *= std::max(length(Vec{by.a, by.b}), length(Vec{by.c, by.d}));
    return moved;
}

curves::Bounds bounds_of(const Region& region) {
    curves::Bounds bounds;
    for (const Vec corner : region.corners) extend(bounds, corner);
    return bounds;
}

bool reaches_into(const curves::Element& element, const Region& region, double depth) {
    if (region.corners.size() < 3) return false;
    if (!do_overlap(bounds_of(element), bounds_of(region))) return false;
    depth = std::max(depth, region.error);
    if (element.kind == curves::ElementKind::point) return is_deep(element.at[0], region, depth);
    const int pieces = element.kind == curves::ElementKind::line ? 1 : 64;
    const curves::Interval on = curves::interval_of(element);
    const double step = (on.to - on.from) / pieces;
    Vec from = curves::point_at(element, on.from);
    for (int i = 0; i < pieces; ++i) {
        const Vec to = curves::point_at(element, on.from + step * (i + 1));
        const std::vector<double> parts = crossings(from, to, region.corners);
        for (std::size_t p = 1; p < parts.size(); ++p) {
            for (const double share : {0.25, 0.5, 0.75, 1.0}) {
                const double t = parts[p - 1] + share * (parts[p] - parts[p - 1]);
                if (is_deep(curves::point_at(element, on.from + step * (i + t)), region, depth)) return true;
            }
        }
        from = to;
    }
    return false;
}

}  // namespace filigree::shape
