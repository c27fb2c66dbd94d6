#include "space/convex_parts.h"

#include <algorithm>
#include <cmath>

#include "plane/point.h"
#include "space/mesh.h"

namespace filigree {
namespace {

// Along the axis that the ring faces most, so that it runs from x towards y; on a grid of its own.
std::vector<Point> flattened(std::span<const Vec3> ring, Vec3 normal) {
    const double x = std::fabs(normal.x), y = std::fabs(normal.y), z = std::fabs(normal.z);
    const auto flat = [&](Vec3 p) -> Vec {
        if (z >= x && z >= y) return normal.z > 0 ? Vec{p.x, p.y} : Vec{p.y, p.x};
        if (y >= x) return normal.y > 0 ? Vec{p.z, p.x} : Vec{p.x, p.z};
        return normal.x > 0 ? Vec{p.y, p.z} : Vec{p.z, p.y};
    };
    const Vec origin = flat(ring[0]);
    double extent = 0;
    for (const Vec3 p : ring) {
        const Vec offset = flat(p) - origin;
        extent = std::max({extent, std::fabs(offset.x), std::fabs(offset.y)});
    }
    const double scale = extent > 0 ? 0x1p30 / extent : 0;
    std::vector<Point> points;
    points.reserve(ring.size());
    for (const Vec3 p : ring) {
        const Vec at = (flat(p) - origin) * scale;
        points.push_back({round_to_whole(at.x), round_to_whole(at.y)});
    }
    return points;
}

// It never turns back, and goes up and down again in the order of points only once.
bool is_convex(const std::vector<Point>& ring) {
    const std::size_t count = ring.size();
    std::size_t changes = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Point a = ring[i], b = ring[(i + 1) % count], c = ring[(i + 2) % count];
        if (a == b || orientation(a, b, c) < 0) return false;
        changes += (a < b) != (b < c) ? 1 : 0;
    }
    return changes == 2;
}

class EarClipper {
public:
    EarClipper(const std::vector<Point>& ring, const Job& job)
        : ring_(ring), job_(job), next_(ring.size()), previous_(ring.size()) {
        const auto count = static_cast<std::uint32_t>(ring.size());
        for (std::uint32_t i = 0; i < count; ++i) {
            next_[i] = (i + 1) % count;
            previous_[i] = (i + count - 1) % count;
        }
        for (std::uint32_t i = 0; i < count; ++i) {
            if (turn(i) < 0) reflex_.push_back(i);
        }
    }

    ConvexParts clip() && {
        std::size_t left = ring_.size(), passed = 0;
        std::uint32_t at = 0;
        std::uint32_t asked = 0;
        while (left >= 3) {
            if ((++asked & 0xFF) == 0 && is_cancelled(job_)) break;
            const bool is_stuck = passed > left;
            if (is_stuck) {
                // What is left on one line encloses nothing; anything else crosses itself.
                if (turn(at) != 0) parts_.is_whole = false;
            } else if (!is_ear(at)) {
                at = next_[at];
                ++passed;
                continue;
            }
            if (turn(at) > 0) {
                parts_.corners.insert(parts_.corners.end(), {previous_[at], at, next_[at]});
                parts_.ends.push_back(static_cast<std::uint32_t>(parts_.corners.size()));
            }
            next_[previous_[at]] = next_[at];
            previous_[next_[at]] = previous_[at];
            at = next_[next_[at]];  // not at once beside it: fans of slivers would come out
            std::erase_if(reflex_, [&](std::uint32_t i) { return turn(i) >= 0; });
            --left;
            passed = 0;
        }
        return std::move(parts_);
    }

private:
    int turn(std::uint32_t i) const { return orientation(ring_[previous_[i]], ring_[i], ring_[next_[i]]); }

    bool is_ear(std::uint32_t i) const {
        const Point a = ring_[previous_[i]], b = ring_[i], c = ring_[next_[i]];
        if (orientation(a, b, c) <= 0) return false;
        return std::none_of(reflex_.begin(), reflex_.end(), [&](std::uint32_t r) {
            const Point p = ring_[r];
            return p != a && p != b && p != c && orientation(a, b, p) >= 0 && orientation(b, c, p) >= 0 &&
                   orientation(c, a, p) >= 0;
        });
    }

    const std::vector<Point>& ring_;
    const Job& job_;
    std::vector<std::uint32_t> next_, previous_;
    std::vector<std::uint32_t> reflex_;  // of those left
    ConvexParts parts_;
};

}  // namespace

ConvexParts convex_parts(std::span<const Vec3> ring, double flat, const Job& job) {
    ConvexParts parts;
    const Vec3 normal = doubled_area(ring);
    if (ring.size() < 3 || !(length(normal) > 0)) return parts;
    const Vec3 across = unit(normal);
    const bool is_flat =
        std::all_of(ring.begin(), ring.end(), [&](Vec3 p) { return std::fabs(dot(across, p - ring[0])) <= flat; });
    const std::vector<Point> points = flattened(ring, normal);
    if (is_flat && is_convex(points)) {
        for (std::uint32_t i = 0; i < ring.size(); ++i) parts.corners.push_back(i);
        parts.ends.push_back(static_cast<std::uint32_t>(ring.size()));
        return parts;
    }
    parts = EarClipper(points, job).clip();
    parts.is_whole = parts.is_whole && is_flat;
    return parts;
}

}  // namespace filigree
