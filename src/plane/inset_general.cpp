#include "plane/inset_general.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <polyclipping/clipper.hpp>

#include "plane/edge_tree.h"

namespace filigree {

namespace {

namespace clipper = ClipperLib;

// The library computes crossings in doubles; past so many steps they would err by more than a step.
constexpr double most_steps = 0x1p46;

class RawRing {
public:
    RawRing(double distance, double steps_per_px) : distance_(distance), steps_per_px_(steps_per_px) {}

    clipper::Path make(const std::vector<Vec>& ring, const JoinRule& rule) {
        const std::size_t n = ring.size();
        std::vector<Vec> directions(n);
        std::vector<double> lengths(n);
        for (std::size_t i = 0; i < n; ++i) {
            const Vec along = ring[i + 1 < n ? i + 1 : 0] - ring[i];
            lengths[i] = length(along);
            directions[i] = along * (1 / lengths[i]);
        }
        std::vector<Vec> fill;
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t before = i == 0 ? n - 1 : i - 1;
            const Vec in = directions[before];
            const Vec out = directions[i];
            const Vec last = perpendicular(in);
            const Vec next = perpendicular(out);
            if (opens_gap(in, out)) {
                fill.clear();
                append_fill(in, out, rule, fill);
                fill.push_back(next);
                Vec normal = last;
                for (const Vec& n2 : fill) {
                    add(ring[i] + corner_velocity(normal, n2) * distance_);
                    normal = n2;
                }
                continue;
            }
            // Strips that overlap at the corner may be cut where they meet, if that is before half of both: what
            // the cut gives back then lies under two strips, and no point is given back twice by one strip.
            const double cosine = dot(in, out);
            if (cosine > 0) {
                const double taken = distance_ * cross(in, out) / (1 + cosine);
                if (2 * taken <= std::min(lengths[before], lengths[i])) {
                    add(ring[i] + corner_velocity(last, next) * distance_);
                    continue;
                }
            }
            add(ring[i] + last * distance_);
            add(ring[i]);
            add(ring[i] + next * distance_);
        }
        return std::move(path_);
    }

private:
    void add(Vec p) {
        const clipper::IntPoint at(std::llround(p.x * steps_per_px_), std::llround(p.y * steps_per_px_));
        if (path_.empty() || path_.back() != at) path_.push_back(at);
    }

    double distance_, steps_per_px_;
    clipper::Path path_;
};

struct Grid {
    Point origin;
    std::int64_t step = 1;
};

// False for a ring that is no more than rounding.
bool add_ring(const clipper::Path& path, const Grid& grid, Polygons& to) {
    const std::size_t first = to.points.size();
    for (const clipper::IntPoint& p : path) {
        const Point at{grid.origin.x + p.X * grid.step, grid.origin.y + p.Y * grid.step};
        if (to.points.size() == first || to.points.back() != at) to.points.push_back(at);
    }
    while (to.points.size() > first + 1 && to.points.back() == to.points[first]) to.points.pop_back();
    const RingView ring(to.points.data() + first, to.points.size() - first);
    double perimeter = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        perimeter += length(to_px(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]));
    }
    const double least_width = 16 * static_cast<double>(grid.step) / grid_per_px;
    if (ring.size() < 3 || std::fabs(area(ring)) <= perimeter * least_width) {
        to.points.resize(first);
        return false;
    }
    to.end_ring();
    return true;
}

void add_polygons(const clipper::PolyNode& parent, const Grid& grid, Polygons& to) {
    for (const clipper::PolyNode* outer : parent.Childs) {
        if (!add_ring(outer->Contour, grid, to)) continue;
        for (const clipper::PolyNode* hole : outer->Childs) add_ring(hole->Contour, grid, to);
        to.end_polygon();
        for (const clipper::PolyNode* hole : outer->Childs) add_polygons(*hole, grid, to);
    }
}

}  // namespace

Polygons general_inset(PolygonView shape, Point origin, double distance, const JoinRule& rule) {
    Grid grid{origin, 1};
    const Box box = bounds(shape);
    const double size = std::max(static_cast<double>(box.max.x) - static_cast<double>(box.min.x),
                                 static_cast<double>(box.max.y) - static_cast<double>(box.min.y));
    while (size / static_cast<double>(grid.step) > most_steps) grid.step *= 2;

    Polygons result;
    try {
        clipper::Clipper machine;
        for (std::size_t r = 0; r < shape.ring_count(); ++r) {
            std::vector<Vec> ring;
            for (const Point& p : shape.ring(r)) {
                const Vec at = to_px(p, origin);
                if (ring.empty() || !(ring.back() == at)) ring.push_back(at);
            }
            while (ring.size() > 1 && ring.back() == ring.front()) ring.pop_back();
            if (ring.size() < 3) continue;
            machine.AddPath(RawRing(distance, grid_per_px / static_cast<double>(grid.step)).make(ring, rule),
                            clipper::ptSubject, true);
        }
        clipper::PolyTree tree;
        machine.Execute(clipper::ctUnion, tree, clipper::pftPositive, clipper::pftPositive);
        add_polygons(tree, grid, result);
    } catch (const std::exception&) {
        return {};
    }
    return result;
}

}  // namespace filigree
