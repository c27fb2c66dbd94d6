#include "plane/inner_point.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <vector>

#include "plane/edge_tree.h"

namespace filigree {
namespace {

constexpr std::size_t most_tries = 4000;
constexpr double good_enough = 1.01;

// The middle of the widest stretch of the shape at a height, relative to `origin`; its width is 0 where there is none.
struct Stretch {
    Vec middle;
    double width = 0;
};
Stretch widest_stretch(PolygonView shape, Point origin, double y) {
    std::vector<double> crossings;
    for (std::size_t r = 0; r < shape.ring_count(); ++r) {
        const RingView ring = shape.ring(r);
        if (ring.empty()) continue;
        Vec a = to_px(ring.back(), origin);
        for (const Point p : ring) {
            const Vec b = to_px(p, origin);
            if ((a.y <= y) != (b.y <= y)) {
                // From the lower end, so that the direction of the edge does not matter.
                const Vec low = a.y < b.y ? a : b, high = a.y < b.y ? b : a;
                crossings.push_back(low.x + (high.x - low.x) * ((y - low.y) / (high.y - low.y)));
            }
            a = b;
        }
    }
    std::sort(crossings.begin(), crossings.end());
    Stretch best;
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
        const double width = crossings[i + 1] - crossings[i];
        if (width > best.width) best = {{crossings[i] + width / 2, y}, width};
    }
    return best;
}

// A height near `y` at which no vertex lies, so that no edge lies along it.
double free_height(PolygonView shape, Point origin, double y) {
    double below = -std::numeric_limits<double>::infinity(), above = -below;
    for (std::size_t r = 0; r < shape.ring_count(); ++r) {
        for (const Point p : shape.ring(r)) {
            const double at = to_px(p, origin).y;
            if (at <= y) below = std::max(below, at);
            if (at > y) above = std::min(above, at);
        }
    }
    return below + (above - below) / 2;
}

Vec quick_point(PolygonView shape, Point origin, double half_height) {
    for (const double part : {0.0, -0.5, 0.5, -0.9, 0.9}) {
        const Stretch stretch = widest_stretch(shape, origin, free_height(shape, origin, part * half_height));
        if (stretch.width > 0) return stretch.middle;
    }
    const RingView outer = shape.outer();
    return to_px(*std::min_element(outer.begin(), outer.end()), origin);
}

Point middle(const Box& box) { return {box.min.x / 2 + box.max.x / 2, box.min.y / 2 + box.max.y / 2}; }

// A square about a point, with how far the point is from the border (below 0 outside) and how far a point of the
// square can be at most.
struct Cell {
    Vec centre;
    double half = 0, distance = 0, potential = 0;
};
struct LessPromising {
    bool operator()(const Cell& a, const Cell& b) const {
        if (a.potential != b.potential) return a.potential < b.potential;
        return a.centre.x != b.centre.x ? a.centre.x > b.centre.x : a.centre.y > b.centre.y;
    }
};

}  // namespace

Vec quick_inner_point(PolygonView shape) {
    if (shape.point_count() == 0) return {};
    const Box box = bounds(shape);
    const Point origin = middle(box);
    return to_px(origin) + quick_point(shape, origin, to_px(box.max, origin).y);
}

Vec inner_point(PolygonView shape) {
    if (shape.point_count() == 0) return {};
    const Box box = bounds(shape);
    const Point origin = middle(box);
    const Vec extent = to_px(box.max, origin);
    const EdgeTree tree(edges_of(shape, origin));
    const double whole = 2 * length(extent) + 1;
    const auto distance = [&](Vec p) {
        const EdgeTree::Place place = tree.place(p, whole, whole);
        return place.is_inside ? place.distance : -place.distance;
    };
    const auto cell = [&](Vec centre, double half) {
        const double own = distance(centre);
        return Cell{centre, half, own, own + half * 1.4142135623730951};
    };
    Vec best = quick_point(shape, origin, extent.y);
    double best_distance = std::max(0.0, distance(best));
    const auto consider = [&](const Cell& tried) {
        if (tried.distance > best_distance) {
            best = tried.centre;
            best_distance = tried.distance;
        }
    };
    consider(cell(centroid(shape) - to_px(origin), 0));
    // Squares across the box; the long side has as many as fit.
    std::priority_queue<Cell, std::vector<Cell>, LessPromising> cells;
    const double half = std::max({std::min(extent.x, extent.y), std::max(extent.x, extent.y) / 16, 0x1p-26});
    for (double x = -extent.x + half; x < extent.x + half; x += 2 * half) {
        for (double y = -extent.y + half; y < extent.y + half; y += 2 * half) cells.push(cell({x, y}, half));
    }
    for (std::size_t tries = 0; tries < most_tries && !cells.empty(); tries += 4) {
        const Cell top = cells.top();
        cells.pop();
        consider(top);
        if (top.potential <= good_enough * best_distance || top.half < 0x1p-26) break;
        for (const double x : {-0.5, 0.5}) {
            for (const double y : {-0.5, 0.5}) {
                const Cell part = cell(top.centre + top.half * Vec{x, y}, top.half / 2);
                consider(part);
                if (part.potential > good_enough * best_distance) cells.push(part);
            }
        }
    }
    return to_px(origin) + best;
}

}  // namespace filigree
