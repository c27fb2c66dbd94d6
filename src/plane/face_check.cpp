#include "plane/face_check.h"

#include <algorithm>
#include <cmath>

namespace filigree {
namespace {

std::vector<Point> points_of(std::span<const std::uint32_t> ring, std::span<const Point> at) {
    std::vector<Point> points;
    points.reserve(ring.size());
    for (const std::uint32_t v : ring) points.push_back(at[v]);
    return points;
}

}  // namespace

int area_sign(std::span<const std::uint32_t> ring, std::span<const Point> at) {
    if (ring.size() < 3) return 0;
    // In doubles where that is certain: every term is off by less than 2^-50 of its size.
    const Point origin = at[ring[0]];
    const auto from_origin = [&](std::uint32_t v) {
        return Vec{static_cast<double>(at[v].x - origin.x), static_cast<double>(at[v].y - origin.y)};
    };
    double sum = 0, size = 0;
    Vec before = from_origin(ring[1]);
    for (std::size_t i = 2; i < ring.size(); ++i) {
        const Vec here = from_origin(ring[i]);
        const double left = before.x * here.y, right = before.y * here.x;
        sum += left - right;
        size += std::fabs(left) + std::fabs(right);
        before = here;
    }
    if (std::fabs(sum) > size * 0x1p-50 * static_cast<double>(ring.size())) return sum > 0 ? 1 : -1;
    Int128 doubled = 0;
    for (std::size_t i = 2; i < ring.size(); ++i) doubled += cross(origin, at[ring[i - 1]], at[ring[i]]);
    return doubled > 0 ? 1 : doubled < 0 ? -1 : 0;
}

void FaceCheck::find(std::size_t polygon, std::vector<std::uint32_t>& found) {
    const std::size_t first = rings_.first_ring(polygon), end = rings_.polygon_ends[polygon];
    order_.clear();
    for (std::size_t r = first; r < end; ++r) order_.push_back(static_cast<std::uint32_t>(r));
    if (order_.size() > 8) sort_by_place();
    links_.clear();
    for (const std::uint32_t r : order_) {
        const auto ring = rings_.ring(r);
        for (std::size_t i = 0; i < ring.size(); ++i) {
            links_.push_back({ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]});
        }
    }
    const std::size_t before = found.size();
    crossings_.find(links_, at_, found);
    if (found.size() > before) return;
    const auto add = [&](std::size_t r) { found.insert(found.end(), rings_.ring(r).begin(), rings_.ring(r).end()); };
    for (std::size_t r = first; r < end; ++r) {
        if (has_turned_over(rings_.ring(r), r == first)) add(r);
    }
    const bool is_misplaced = end - first == 2  ? is_outside(rings_.ring(first + 1), rings_.ring(first))
                              : end - first > 2 ? is_nested_wrongly(first, end)
                                                : false;
    if (is_misplaced) {
        for (std::size_t r = first; r < end; ++r) add(r);
    }
}

// Where it turned before is only asked of what does not turn as a clean polygon does.
bool FaceCheck::has_turned_over(std::span<const std::uint32_t> ring, bool is_outer) const {
    const int sign = area_sign(ring, at_);
    if (sign == (is_outer ? 1 : -1)) return false;
    return sign != area_sign(ring, from_) && (sign != 0 || ring.size() > 2);
}

// Of rings that do not cross: by the first point that does not lie on the outer one.
bool FaceCheck::is_outside(std::span<const std::uint32_t> hole, std::span<const std::uint32_t> outer) const {
    const std::vector<Point> ring = points_of(outer, at_);
    for (const std::uint32_t v : hole) {
        const int side = locate(ring, at_[v]);
        if (side != 0) return side < 0;
    }
    return false;
}

bool FaceCheck::is_nested_wrongly(std::size_t first, std::size_t end) const {
    std::vector<std::vector<Point>> rings;
    for (std::size_t r = first; r < end; ++r) {
        if (area_sign(rings_.ring(r), at_) != 0) rings.push_back(points_of(rings_.ring(r), at_));
    }
    const Polygons nested = nest_rings(rings);
    return nested.size() != 1 || nested.ring_ends.size() != rings.size();
}

// In bands, from left to right and back, so that near links stand near each other.
void FaceCheck::sort_by_place() {
    std::erase_if(order_, [&](std::uint32_t r) { return rings_.ring(r).empty(); });
    Box box;
    for (const std::uint32_t r : order_) extend(box, at_[rings_.ring(r)[0]]);
    const auto bands = static_cast<std::int64_t>(std::sqrt(static_cast<double>(order_.size())));
    const std::int64_t height = (box.max.y - box.min.y) / std::max<std::int64_t>(bands, 1) + 1;
    std::sort(order_.begin(), order_.end(), [&](std::uint32_t a, std::uint32_t b) {
        const Point p = at_[rings_.ring(a)[0]], q = at_[rings_.ring(b)[0]];
        const std::int64_t p_band = (p.y - box.min.y) / height, q_band = (q.y - box.min.y) / height;
        if (p_band != q_band) return p_band < q_band;
        if (p.x != q.x) return p_band % 2 == 0 ? p.x < q.x : q.x < p.x;
        return a < b;
    });
}

}  // namespace filigree
