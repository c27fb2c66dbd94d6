#include "plane/level_walk.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace filigree {
namespace {

// The strip where a stretch from code a to code b starts; along a level, the side of the shape's inside.
std::int32_t strip_at_start(LevelCode a, LevelCode b, bool towards_greater_u) {
    const bool above = a == b ? towards_greater_u : b > a;
    return (a >> 1) + ((a & 1) != 0 && above ? 1 : 0);
}

// The nearest whole number for |x| < 2^51, without a call: the sum's last bit is worth 1, so the addition rounds.
inline double nearest(double x) {
    constexpr double shift = 0x1.8p52;
    return (x + shift) - shift;
}

// The grid point for a place inside an edge. Rounding to the nearest one bends the edge, and a lattice of equal
// pieces bends all its edges the same way, until the areas are off by more than 1e-9. So, of the eight columns
// (for steep edges, rows) around the place, the one is taken where the edge passes nearest to a grid point. Blocks of
// eight are fixed on the edge, so that places keep their order.
// `rise_of_phi` is how much phi changes along the whole edge: no point leaves its level by more than 2^-22 px.
Point point_on_edge(Point a, Point b, double fraction, double rise_of_phi) {
    constexpr std::int64_t block = 8;
    constexpr double reluctance = 1.0 / 512;  // of a grid unit off the edge, for a unit along it
    constexpr double most_off_level = 0x1p-22;
    const double dx = static_cast<double>(b.x - a.x), dy = static_cast<double>(b.y - a.y);
    const bool steep = std::fabs(dy) > std::fabs(dx);
    const double run = steep ? dy : dx, rise = steep ? dx : dy;
    const double length = std::fabs(run);
    const double slope = rise / length;
    const double place = fraction * length;
    const double most_moved = most_off_level * length / std::fabs(rise_of_phi);
    double best = std::nearbyint(place);
    if (rise != 0 && length < 0x1p51) {
        const double first = static_cast<double>(static_cast<std::int64_t>(best) / block * block);
        const double low = std::max({first, place - most_moved, 1.0});
        const double high = std::min({first + double{block - 1}, place + most_moved, length - 1});
        double least = std::numeric_limits<double>::infinity();
        for (double at = first; at < first + double{block}; ++at) {
            const double level = at * slope;
            const double cost = std::fabs(level - nearest(level)) + reluctance * std::fabs(at - place);
            if (cost < least && at >= low && at <= high) {
                least = cost;
                best = at;
            }
        }
    }
    const std::int64_t along = round_to_grid(run < 0 ? -best : best), across = round_to_grid(best * slope);
    return steep ? Point{a.x + across, a.y + along} : Point{a.x + along, a.y + across};
}

}  // namespace

LevelExtent LevelWalker::read(PolygonView shape, const LevelField& field) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    LevelExtent extent{infinity, -infinity, infinity, -infinity};
    corners_.resize(shape.point_count());
    ring_ends_.clear();
    std::size_t count = 0;
    for (std::size_t r = 0; r < shape.ring_count(); ++r) {
        const std::size_t begin = count;
        for (const Point p : shape.ring(r)) {
            if (count > begin && corners_[count - 1].point == p) continue;
            const Vec at = field.coordinates(p);
            if (at.x < extent.u_low) extent.u_low = at.x;
            if (at.x > extent.u_high) extent.u_high = at.x;
            if (at.y < extent.v_low) extent.v_low = at.y;
            if (at.y > extent.v_high) extent.v_high = at.y;
            corners_[count++] = {p, at.x, at.y, 0, 0, 0};
        }
        while (count > begin + 1 && corners_[count - 1].point == corners_[begin].point) --count;
        if (count < begin + 3) count = begin;
        ring_ends_.push_back(count);
    }
    return extent;
}

LevelTrail& LevelWalker::walk(const LevelField& field) {
    field_ = &field;
    trail_.points.clear();
    trail_.u.clear();
    trail_.rings.clear();
    trail_.events.clear();
    trail_.passes.clear();
    std::size_t begin = 0;
    for (const std::size_t end : ring_ends_) {
        if (begin == end) continue;
        std::int32_t strip = 0;
        for (std::size_t i = begin; i < end; ++i) {
            LevelCorner& corner = corners_[i];
            corner.phi = corner.v;
            if (!field.nodes.empty()) {
                const std::size_t node = field.node_before(corner.u);
                corner.phi -= field.profile(corner.u, node);
                corner.node = static_cast<std::uint32_t>(node);
            }
            if (i == begin) strip = field.find_strip(corner.phi);
            corner.code = field.place(corner.phi, strip);
        }
        walk_ring(corners_.data() + begin, end - begin);
        begin = end;
    }
    return trail_;
}

void LevelWalker::walk_ring(const LevelCorner* corners, std::size_t count) {
    LevelTrail::Ring ring;
    ring.first_point = static_cast<std::uint32_t>(trail_.points.size());
    ring.first_event = static_cast<std::uint32_t>(trail_.events.size());
    ring_begin_ = ring.first_point;
    const bool straight = field_->nodes.empty();
    for (std::size_t i = 0; i < count; ++i) {
        const LevelCorner& a = corners[i];
        const LevelCorner& b = corners[i + 1 == count ? 0 : i + 1];
        add_point(a.point, a.u);
        if (straight) {
            walk_straight(a, b);
        } else {
            walk_bent(a, b);
        }
    }
    ring.end_point = static_cast<std::uint32_t>(trail_.points.size());
    ring.end_event = static_cast<std::uint32_t>(trail_.events.size());
    ring.strip = strip_;
    if ((corners[0].code & 1) != 0) {  // its pass was the first event, before the strip was known
        LevelEvent& first = trail_.events[ring.first_event];
        first.in_above = strip_ > first.level;
    }
    trail_.rings.push_back(ring);
}

inline void LevelWalker::add_point(Point p, double u) {
    if (trail_.points.size() > ring_begin_ && trail_.points.back() == p) return;
    trail_.points.push_back(p);
    trail_.u.push_back(u);
}

// The last point lies on a level; the ring goes on into `strip`.
void LevelWalker::pass(LevelCode code, std::int32_t strip) {
    const std::int32_t level = code >> 1;
    trail_.passes.push_back(static_cast<std::uint32_t>(trail_.events.size()));
    trail_.events.push_back({last_place(), level, strip_ > level, strip > level});
}

// An edge's stretch between two samples, in the ring's direction. add_point_at(k) adds the crossing of level k.
template <class AddPoint>
inline void LevelWalker::walk_stretch(LevelCode a, LevelCode b, bool towards_greater_u, AddPoint&& add_point_at) {
    const std::int32_t start = strip_at_start(a, b, towards_greater_u);
    if ((a & 1) != 0) pass(a, start);
    strip_ = start;
    if (b > a) {
        for (std::int32_t k = (a + 1) >> 1; 2 * k + 1 < b; ++k) {
            add_point_at(k);
            trail_.events.push_back({last_place(), k, false, true});
            strip_ = k + 1;
        }
    } else {
        for (std::int32_t k = (a >> 1) - 1; 2 * k + 1 > b; --k) {
            add_point_at(k);
            trail_.events.push_back({last_place(), k, true, false});
            strip_ = k;
        }
    }
}

void LevelWalker::walk_straight(const LevelCorner& from, const LevelCorner& to) {
    if (from.code == to.code && (from.code & 1) == 0) {
        strip_ = from.code >> 1;
        return;
    }
    const bool forward = from.point < to.point;
    const LevelCorner& a = forward ? from : to;
    const LevelCorner& b = forward ? to : from;
    const double rise = 1 / (b.phi - a.phi);
    walk_stretch(from.code, to.code, to.u > from.u,
                 [&](std::int32_t k) { add_inside(a, b, (field_->level(k) - a.phi) * rise, 1 / rise); });
}

void LevelWalker::walk_bent(const LevelCorner& from, const LevelCorner& to) {
    if (from.node == to.node) {
        walk_straight(from, to);
        return;
    }
    const bool rightwards = to.u > from.u;
    const NodeRange nodes = rightwards ? nodes_between(*field_, from.u, to.u) : nodes_between(*field_, to.u, from.u);
    if (nodes.begin == nodes.end) {
        walk_straight(from, to);
        return;
    }
    const bool forward = from.point < to.point;
    const LevelCorner& a = forward ? from : to;
    const LevelCorner& b = forward ? to : from;
    sample(a, b, nodes);
    const std::size_t stretches = samples_.size() - 1;
    for (std::size_t j = 0; j < stretches; ++j) {
        const std::size_t i = forward ? j : stretches - 1 - j;  // between samples i and i + 1
        const FieldSample& low = samples_[i];
        const FieldSample& high = samples_[i + 1];
        const FieldSample& start = forward ? low : high;
        const FieldSample& end = forward ? high : low;
        if (start.code == end.code && (start.code & 1) == 0) {
            strip_ = start.code >> 1;
            continue;
        }
        // A breakpoint on a level becomes a point of the ring, seen from either side of the edge.
        const double rise = (high.fraction - low.fraction) / (high.phi - low.phi);
        if (j > 0 && (start.code & 1) != 0) add_inside(a, b, start.fraction, 1 / rise);
        walk_stretch(start.code, end.code, rightwards, [&](std::int32_t k) {
            add_inside(a, b, low.fraction + (field_->level(k) - low.phi) * rise, 1 / rise);
        });
    }
}

void LevelWalker::sample(const LevelCorner& a, const LevelCorner& b, NodeRange nodes) {
    const std::size_t count = nodes.end - nodes.begin;
    if (samples_.size() != count + 2) samples_.resize(count + 2);
    FieldSample* out = samples_.data();
    *out++ = {a.u, 0, a.phi, a.code};
    const double inverse_width = 1 / (b.u - a.u), rise = b.v - a.v;
    std::int32_t strip = a.code >> 1;
    const bool rightwards = b.u > a.u;
    for (std::size_t i = 0; i < count; ++i) {
        const FieldNode& node = field_->nodes[rightwards ? nodes.begin + i : nodes.end - 1 - i];
        const double fraction = (node.u - a.u) * inverse_width;
        const double phi = a.v + fraction * rise - node.value;
        const LevelCode code = field_->place(phi, strip);
        *out++ = {node.u, fraction, phi, code};
    }
    *out = {b.u, 1, b.phi, b.code};
}

inline void LevelWalker::add_inside(const LevelCorner& a, const LevelCorner& b, double fraction, double rise_of_phi) {
    add_point(point_on_edge(a.point, b.point, fraction, rise_of_phi), a.u + fraction * (b.u - a.u));
}

}  // namespace filigree
