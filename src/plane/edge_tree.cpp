#include "plane/edge_tree.h"

#include <limits>
#include <utility>

namespace filigree {

namespace {

constexpr float nowhere = std::numeric_limits<float>::infinity();

// An order of edges and points to choose by among equally near ones.
bool comes_before(Vec a, Vec b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }
bool comes_before(const Edge& a, const Edge& b) {
    return a.from == b.from ? comes_before(a.to, b.to) : comes_before(a.from, b.from);
}

// The bits of x and y interleaved: near places mostly have near codes.
std::uint64_t spread_bits(std::uint64_t v) {
    v &= 0xFFFFFFFFU;
    v = (v | v << 16) & 0x0000FFFF0000FFFFU;
    v = (v | v << 8) & 0x00FF00FF00FF00FFU;
    v = (v | v << 4) & 0x0F0F0F0F0F0F0F0FU;
    v = (v | v << 2) & 0x3333333333333333U;
    return (v | v << 1) & 0x5555555555555555U;
}

}  // namespace

double squared_distance(const Edge& e, Vec p) {
    const Vec along = e.to - e.from;
    const Vec to_p = p - e.from;
    const double s = dot(to_p, along);
    if (s <= 0) return dot(to_p, to_p);
    const double length2 = dot(along, along);
    if (s >= length2) return dot(p - e.to, p - e.to);
    const double c = cross(along, to_p);
    return c * c / length2;
}

EdgeTree::EdgeTree(std::vector<Edge> edges) : edges_(std::move(edges)) {
    if (edges_.empty()) return;
    Boxes none;
    none.min_x = none.min_y = none.minus_max_x = none.minus_max_y = {nowhere, nowhere, nowhere, nowhere};
    boxes_.reserve(edges_.size() / 3 + 8);
    boxes_.resize((edges_.size() + 3) / 4, none);
    const auto below = [](double v) { return static_cast<float>(v - std::fabs(v) * 0x1p-22); };
    for (std::size_t e = 0; e < edges_.size(); ++e) {
        const Edge& edge = edges_[e];
        Boxes& boxes = boxes_[e / 4];
        boxes.min_x[e % 4] = below(std::min(edge.from.x, edge.to.x));
        boxes.min_y[e % 4] = below(std::min(edge.from.y, edge.to.y));
        boxes.minus_max_x[e % 4] = below(-std::max(edge.from.x, edge.to.x));
        boxes.minus_max_y[e % 4] = below(-std::max(edge.from.y, edge.to.y));
    }
    level_starts_.push_back(0);
    const auto least = [](const std::array<float, 4>& v) {
        return std::min(std::min(v[0], v[1]), std::min(v[2], v[3]));
    };
    for (std::size_t begin = 0, end = boxes_.size(); end - begin > 1; begin = end, end = boxes_.size()) {
        level_starts_.push_back(static_cast<std::uint32_t>(end));
        boxes_.resize(end + (end - begin + 3) / 4, none);
        for (std::size_t i = begin; i < end; ++i) {
            Boxes& above = boxes_[end + (i - begin) / 4];
            const std::size_t slot = (i - begin) % 4;
            above.min_x[slot] = least(boxes_[i].min_x);
            above.min_y[slot] = least(boxes_[i].min_y);
            above.minus_max_x[slot] = least(boxes_[i].minus_max_x);
            above.minus_max_y[slot] = least(boxes_[i].minus_max_y);
        }
    }
}

bool EdgeTree::is_any_nearer(Vec p, double reach) const {
    if (!(reach > 0)) return false;
    const double reach2 = reach * reach;
    return any(around(p, reach), [&](std::uint32_t e) { return is_nearer(edges_[e], p, reach2); });
}

EdgeTree::Nearest EdgeTree::nearest(Vec p, double at_most) const {
    constexpr std::uint32_t none = UINT32_MAX;
    double best2 = at_most * at_most;
    std::uint32_t side = none;                             // the nearest edge, where its nearest point is no end
    std::uint32_t ends_there = none, starts_there = none;  // the edges at the nearest corner
    std::uint32_t corner_edges = 0;
    Vec corner;
    any(around(p, at_most), [&](std::uint32_t i) {
        const Edge& e = edges_[i];
        const double d2 = squared_distance(e, p);
        const bool found_any = side != none || corner_edges > 0;
        if (d2 > best2 || (d2 == best2 && !found_any)) return false;
        if (d2 < best2) {
            side = ends_there = starts_there = none;
            corner_edges = 0;
        }
        best2 = d2;
        const Vec along = e.to - e.from;
        const double s = dot(p - e.from, along);
        if (s > 0 && s < dot(along, along)) {
            if (side == none || comes_before(e, edges_[side])) side = i;
            return false;
        }
        const Vec at = s <= 0 ? e.from : e.to;
        if (corner_edges == 0 || comes_before(at, corner)) corner = at;
        ++corner_edges;
        (s <= 0 ? starts_there : ends_there) = i;
        return false;
    });
    Nearest found{best2, 0, side != none || corner_edges > 0, p};
    if (side != none) {
        const Edge& e = edges_[side];
        const Vec along = e.to - e.from;
        found.turn = cross(along, p - e.from);
        found.point = e.from + along * (dot(p - e.from, along) / dot(along, along));
    } else if (corner_edges > 0) {
        found.point = corner;
        // Two edges that end and start at one corner, and nothing else that near.
        if (corner_edges == 2 && ends_there != none && starts_there != none &&
            edges_[ends_there].to == edges_[starts_there].from) {
            const Edge& in = edges_[ends_there];
            const Edge& out = edges_[starts_there];
            found.turn = -cross(in.to - in.from, out.to - out.from);  // what is nearest to a reflex corner is inside
        }
    }
    return found;
}

EdgeTree::Place EdgeTree::place(Vec p, double at_most, double sight) const {
    Nearest found = nearest(p, at_most);
    const double distance = found.was_found ? std::sqrt(found.squared_distance) : at_most;
    if (!found.was_found && sight > at_most) found = nearest(p, sight);
    return {distance, found.turn == 0 ? is_inside(p) : found.turn > 0, found.point};
}

bool EdgeTree::is_inside(Vec p) const {
    bool inside = false;
    any(VecBox{p, {std::numeric_limits<double>::infinity(), p.y}}, [&](std::uint32_t i) {
        const Edge& e = edges_[i];
        if ((e.from.y <= p.y) == (e.to.y <= p.y)) return false;
        // Taken upwards, so that an edge and its reverse answer alike.
        const bool rises = e.from.y < e.to.y;
        const Vec low = rises ? e.from : e.to;
        const Vec high = rises ? e.to : e.from;
        if (cross(high - low, p - low) > 0) inside = !inside;
        return false;
    });
    return inside;
}

std::vector<Edge> edges_of(PolygonView shape, Point origin) {
    struct Place {
        std::uint64_t code;
        std::size_t ring;
        auto operator<=>(const Place&) const = default;
    };
    const std::size_t ring_count = shape.ring_count();
    std::vector<Place> places(ring_count);
    for (std::size_t r = 0; r < ring_count; ++r) places[r] = {0, r};
    if (ring_count > 8) {
        const Box all = bounds(shape);
        const double size =
            static_cast<double>(std::max({all.max.x - all.min.x, all.max.y - all.min.y, std::int64_t{1}}));
        const auto code_of = [&](std::int64_t low, std::int64_t high, std::int64_t least) {
            const double middle = (static_cast<double>(low - least) + static_cast<double>(high - least)) / 2;
            return spread_bits(static_cast<std::uint64_t>(std::clamp(middle / size, 0.0, 1.0) * 65535.0));
        };
        for (std::size_t r = 1; r < ring_count; ++r) {
            const Box box = bounds(shape.ring(r));
            if (is_empty(box)) continue;
            places[r].code = code_of(box.min.x, box.max.x, all.min.x) | code_of(box.min.y, box.max.y, all.min.y) << 1;
        }
        std::sort(places.begin() + 1, places.end());
    }
    std::vector<Edge> edges;
    edges.reserve(shape.point_count());
    for (const Place& place : places) {
        const RingView ring = shape.ring(place.ring);
        if (ring.size() < 3) continue;
        Vec last = to_px(ring.back(), origin);
        for (const Point& p : ring) {
            const Vec next = to_px(p, origin);
            edges.push_back({last, next});
            last = next;
        }
    }
    return edges;
}

}  // namespace filigree
