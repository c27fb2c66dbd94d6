#include "plane/inset.h"

#include <algorithm>
#include <cmath>

#include "plane/inset_check.h"
#include "plane/inset_front.h"
#include "plane/inset_general.h"

namespace filigree {

namespace {

constexpr double least_distance = 0x1p-20;

// Vertices nearer than this to the one before are left out of the private copy if that moves the boundary by no
// more than `most_moved`: what curved cuts leave behind costs events and means nothing.
constexpr double near_duplicate = 1e-3;
constexpr double most_moved = 0x1p-22;

struct Task {
    PolygonView shape;
    Box box;
    Point origin;
    double distance;
    double reach;  // how far from the boundary the result must lie
    JoinRule rule;
};

std::vector<Vec> tidy(RingView ring, Point origin) {
    std::vector<Vec> all;
    all.reserve(ring.size());
    for (const Point& p : ring) {
        const Vec at = to_px(p, origin);
        if (all.empty() || !(all.back() == at)) all.push_back(at);
    }
    while (all.size() > 1 && all.back() == all.front()) all.pop_back();

    std::size_t kept = 1;      // all[0, kept) stay
    std::size_t left_out = 1;  // all[left_out, i) were left out since the last that stays
    for (std::size_t i = 1; i < all.size(); ++i) {
        const Vec last = all[kept - 1];
        const Vec here = all[i];
        bool stays = dot(here - last, here - last) >= near_duplicate * near_duplicate;
        if (!stays) {
            const Edge chord{last, i + 1 < all.size() ? all[i + 1] : all[0]};
            for (std::size_t j = left_out; j <= i && !stays; ++j) {
                stays = squared_distance(chord, all[j]) > most_moved * most_moved;
            }
        }
        if (!stays) continue;
        all[kept++] = here;
        left_out = i + 1;
    }
    all.resize(std::min(kept, all.size()));
    return all;
}

bool events_hold(const Front& front, const EdgeTree& boundary, double slack) {
    for (const FrontEvent& event : front.events) {
        if (boundary.is_any_nearer(event.at, event.time - slack)) return false;
    }
    return true;
}

// The front's ring on the grid, without equal neighbours; empty where it is smaller than that.
std::vector<Point> snapped(const std::vector<Vec>& ring, const Task& task) {
    std::vector<Point> points;
    points.reserve(ring.size());
    const double most = 0x1p31;
    for (const Vec& v : ring) {
        if (!(std::fabs(v.x) <= most && std::fabs(v.y) <= most)) return {};
        const Point rounded = snap(v);
        const Point at{task.origin.x + rounded.x, task.origin.y + rounded.y};
        if (points.empty() || points.back() != at) points.push_back(at);
    }
    while (points.size() > 1 && points.back() == points.front()) points.pop_back();
    if (points.size() < 3) points.clear();
    return points;
}

bool is_inside_ring(RingView ring, Point origin, Vec p) {
    bool inside = false;
    Vec from = to_px(ring.back(), origin);
    for (const Point& point : ring) {
        const Vec to = to_px(point, origin);
        if ((from.y <= p.y) != (to.y <= p.y)) {
            const double side = cross(to - from, p - from);
            if ((from.y < to.y) == (side > 0)) inside = !inside;
        }
        from = to;
    }
    return inside;
}

// Whether each ring is the inset of its own ring of the shape: smaller, on the right side, and around it.
bool rings_correspond(const Task& task, std::span<const RingView> rings, const EdgeTree& boundary) {
    if (doubled_area(rings[0]) <= 0 || doubled_area(rings[0]) >= doubled_area(task.shape.outer())) return false;
    for (const RingView ring : rings) {
        if (!boundary.is_inside(to_px(ring[0], task.origin))) return false;
    }
    if (rings.size() == 1) return true;
    Polygons outer;
    outer.add_ring(rings[0]);
    outer.end_polygon();
    const EdgeTree outer_tree(edges_of(outer[0], task.origin));
    for (std::size_t r = 1; r < rings.size(); ++r) {
        const RingView hole = task.shape.ring(r);
        if (doubled_area(rings[r]) >= doubled_area(hole)) return false;
        if (!outer_tree.is_inside(to_px(rings[r][0], task.origin))) return false;
        if (!is_inside_ring(rings[r], task.origin, to_px(hole[0], task.origin))) return false;
    }
    return true;
}

struct FastResult {
    bool holds = false;
    Polygons inner;
};

FastResult fast_inset(const Task& task, const EdgeTree& boundary) {
    const double slack = task.distance - task.reach;
    std::vector<std::vector<Point>> rings;
    rings.reserve(task.shape.ring_count());
    for (std::size_t r = 0; r < task.shape.ring_count(); ++r) {
        const std::vector<Vec> ring = tidy(task.shape.ring(r), task.origin);
        if (ring.size() < 3) return {};
        const Front front = advance_front(ring, task.distance, task.rule);
        if (!events_hold(front, boundary, slack)) return {};
        rings.push_back(snapped(front.ring, task));
        if (!rings.back().empty()) continue;
        if (r > 0 || !front.ring.empty()) return {};
        for (const FrontEvent& event : front.events) {
            if (event.time > slack && !boundary.is_inside(event.at)) return {};
        }
        return {true, {}};
    }
    const std::vector<RingView> views(rings.begin(), rings.end());
    const Box box = bounds(views[0]);
    const auto steps = static_cast<std::int64_t>(task.reach * grid_per_px);
    if (box.min.x < task.box.min.x + steps || box.min.y < task.box.min.y + steps ||
        box.max.x > task.box.max.x - steps || box.max.y > task.box.max.y - steps) {
        return {};
    }
    if (!are_simple_and_apart(views, task.origin) || !keep_away(views, task.origin, boundary, task.reach) ||
        !rings_correspond(task, views, boundary)) {
        return {};
    }
    FastResult result;
    result.holds = true;
    std::size_t count = 0;
    for (const RingView view : views) count += view.size();
    result.inner.points.reserve(count);
    for (const RingView view : views) result.inner.add_ring(view);
    result.inner.end_polygon();
    return result;
}

bool holds(const Task& task, PolygonView inner, const EdgeTree& boundary) {
    std::vector<RingView> rings;
    for (std::size_t r = 0; r < inner.ring_count(); ++r) rings.push_back(inner.ring(r));
    if (!keep_away(rings, task.origin, boundary, task.reach)) return false;
    return std::all_of(rings.begin(), rings.end(),
                       [&](RingView ring) { return boundary.is_inside(to_px(ring[0], task.origin)); });
}

// From the shape itself, not from fronts that cross: their loops that turned over may reach into what is left.
Polygons slow_inset(const Task& task, const EdgeTree& boundary) {
    // Should the library's roundings bring a point too near, a hair more distance takes it away.
    Polygons kept;
    for (int attempt = 0; attempt < 3; ++attempt) {
        const double distance = task.distance + attempt * (task.distance - task.reach) / 2;
        const Polygons inner = general_inset(task.shape, task.origin, distance, task.rule);
        kept = {};
        for (std::size_t i = 0; i < inner.size(); ++i) {
            if (holds(task, inner[i], boundary)) kept.add(inner[i]);
        }
        if (kept.size() == inner.size()) break;
    }
    return kept;
}

}  // namespace

Inset inset(PolygonView shape, const InsetOptions& options) {
    Inset result;
    if (shape.ring_count() == 0 || shape.outer().size() < 3) return result;
    Task task;
    task.shape = shape;
    task.box = bounds(shape);
    task.distance = options.distance >= least_distance ? options.distance : least_distance;
    const Point size{task.box.max.x - task.box.min.x, task.box.max.y - task.box.min.y};
    if (2 * task.distance * grid_per_px >= static_cast<double>(std::min(size.x, size.y))) return result;
    task.origin = {task.box.min.x + size.x / 2, task.box.min.y + size.y / 2};
    task.reach = task.distance - inset_slack(task.distance, task.box);
    task.rule = join_rule(options, task.distance);

    const EdgeTree boundary(edges_of(shape, task.origin));
    FastResult fast = fast_inset(task, boundary);
    if (fast.holds) {
        result.inner = std::move(fast.inner);
    } else {
        result.took_general_way = true;
        result.inner = slow_inset(task, boundary);
    }
    return result;
}

Polygons without(PolygonView shape, const Polygons& inner) {
    Polygons band;
    if (inner.empty()) {
        band.add(shape);
        return band;
    }
    bool has_holes = false;
    for (std::size_t i = 0; i < inner.size(); ++i) has_holes = has_holes || inner[i].ring_count() > 1;
    if (!has_holes) {
        band.points.reserve(shape.point_count() + inner.points.size());
        for (std::size_t r = 0; r < shape.ring_count(); ++r) band.add_ring(shape.ring(r));
        for (std::size_t i = 0; i < inner.size(); ++i) {
            const RingView ring = inner[i].outer();
            band.points.insert(band.points.end(), ring.rbegin(), ring.rend());
            band.end_ring();
        }
        band.end_polygon();
        return band;
    }
    std::vector<std::vector<Point>> rings;
    rings.reserve(shape.ring_count() + inner.ring_ends.size());
    for (std::size_t r = 0; r < shape.ring_count(); ++r) {
        rings.emplace_back(shape.ring(r).begin(), shape.ring(r).end());
    }
    for (std::size_t i = 0; i < inner.size(); ++i) {
        for (std::size_t r = 0; r < inner[i].ring_count(); ++r) {
            const RingView ring = inner[i].ring(r);
            rings.emplace_back(ring.rbegin(), ring.rend());
        }
    }
    return nest_rings(rings);
}

}  // namespace filigree
