#include "plane/moved_polygon.h"

#include <algorithm>

namespace filigree {

void tidy_ring(std::vector<Point>& points) {
    std::size_t count = 0;
    for (const Point p : points) {
        if (count > 0 && points[count - 1] == p) continue;
        if (count > 1 && points[count - 2] == p) {
            --count;
        } else {
            points[count++] = p;
        }
    }
    points.resize(count);
    for (bool is_tidy = false; !is_tidy && points.size() > 1;) {  // the same where the ring closes
        count = points.size();
        if (points.back() == points.front() || points[count - 2] == points.front()) {
            points.pop_back();
        } else if (points.back() == points[1]) {
            points.erase(points.begin());
        } else {
            is_tidy = true;
        }
    }
}

bool add_moved(Polygons& to, PolygonView moved, bool is_reflected) {
    std::vector<Point> ring;
    for (std::size_t r = 0; r < moved.ring_count(); ++r) {
        ring.assign(moved.ring(r).begin(), moved.ring(r).end());
        tidy_ring(ring);
        if (is_reflected) std::reverse(ring.begin(), ring.end());
        const Int128 area = ring.size() < 3 ? 0 : doubled_area(ring);
        if (r == 0 ? area > 0 : area < 0) {
            to.add_ring(ring);
        } else if (r == 0) {
            return false;
        }
    }
    if (moved.ring_count() == 0) return false;
    to.end_polygon();
    return true;
}

bool add_moved_line(Polygons& to, RingView moved) {
    const std::size_t first = to.points.size();
    for (const Point p : moved) {
        if (to.points.size() == first || to.points.back() != p) to.points.push_back(p);
    }
    if (to.points.size() < first + 2) {
        to.points.resize(first);
        return false;
    }
    to.end_ring();
    to.end_polygon();
    return true;
}

}  // namespace filigree
