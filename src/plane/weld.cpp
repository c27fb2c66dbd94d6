#include "plane/weld.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "plane/point_tree.h"

namespace filigree {
namespace {

bool is_on_plane(Point p) { return -grid_limit <= p.x && p.x <= grid_limit && -grid_limit <= p.y && p.y <= grid_limit; }

// (b - a) . (c - a), exact.
Int128 along(Point a, Point b, Point c) {
    return static_cast<Int128>(b.x - a.x) * (c.x - a.x) + static_cast<Int128>(b.y - a.y) * (c.y - a.y);
}

class Welder {
public:
    Welder(const Polygons& polygons, double tolerance) : tree_(points_on_plane(polygons)) {
        const double units = tolerance * grid_per_px;
        tolerance_ = units > 0 ? units : 0;  // also for NaN
    }

    Polygons weld(const Polygons& polygons) {
        Polygons welded;
        welded.points.reserve(polygons.points.size() + polygons.points.size() / 4);
        welded.ring_ends.reserve(polygons.ring_ends.size());
        welded.polygon_ends = polygons.polygon_ends;
        std::size_t begin = 0;
        for (const std::uint32_t end : polygons.ring_ends) {
            for (std::size_t i = begin; i < end; ++i) {
                const Point a = polygons.points[i], b = polygons.points[i + 1 < end ? i + 1 : begin];
                welded.points.push_back(a);
                if (a != b && is_on_plane(a) && is_on_plane(b)) add_between(a, b, welded.points);
            }
            welded.end_ring();
            begin = end;
        }
        return welded;
    }

private:
    struct Insert {
        Int128 along = 0;
        Point at;
    };

    static std::vector<Point> points_on_plane(const Polygons& polygons) {
        std::vector<Point> points;
        points.reserve(polygons.points.size());
        std::copy_if(polygons.points.begin(), polygons.points.end(), std::back_inserter(points), is_on_plane);
        return points;
    }

    // The vertices that an edge takes, from a to b. Both sides of a border ask with the lesser end first.
    void find_inserts(Point a, Point b, std::vector<Insert>& inserts) {
        near_.clear();
        tree_.find_near(a, b, tolerance_, near_);
        if (near_.size() <= 2) return;  // the ends
        const double farthest = tolerance_ * std::sqrt(static_cast<double>(along(a, b, b)));
        for (const Point c : near_) {
            if (c == a || c == b) continue;
            const Int128 turn = cross(a, b, c), off = turn < 0 ? -turn : turn;
            const Int128 from_a = along(a, b, c);
            // Below 45 degrees at both ends every new edge is shorter than this one, so the work ends.
            if (off >= from_a || off >= along(b, a, c)) continue;
            if (static_cast<double>(off) > farthest) continue;
            inserts.push_back({from_a, c});
        }
        if (inserts.size() < 2) return;
        std::sort(inserts.begin(), inserts.end(), [](const Insert& x, const Insert& y) {
            return x.along != y.along ? x.along < y.along : x.at < y.at;
        });
    }

    void add_between(Point a, Point b, std::vector<Point>& points) {
        const std::size_t first = points.size();
        waiting_.clear();
        // Depth first, in order along the edge as it is asked; `waiting_` holds what is still to come, nearest last.
        for (Stretch stretch{std::min(a, b), std::max(a, b), b < a};;) {
            inserts_.clear();
            find_inserts(stretch.low, stretch.high, inserts_);
            if (inserts_.empty()) {
                points.push_back(stretch.turned_round ? stretch.low : stretch.high);
            } else {
                chain_.clear();
                chain_.push_back(stretch.low);
                for (const Insert& insert : inserts_) chain_.push_back(insert.at);
                chain_.push_back(stretch.high);
                if (stretch.turned_round) std::reverse(chain_.begin(), chain_.end());
                for (std::size_t i = chain_.size() - 1; i > 0; --i) {
                    const Point from = chain_[i - 1], to = chain_[i];
                    waiting_.push_back({std::min(from, to), std::max(from, to), to < from});
                }
            }
            if (waiting_.empty()) break;
            stretch = waiting_.back();
            waiting_.pop_back();
        }
        if (points.size() > first) points.pop_back();  // the far end is the next edge's start
    }

    struct Stretch {
        Point low, high;
        bool turned_round = false;  // the ring runs from high to low
    };

    const PointTree tree_;
    double tolerance_ = 0;  // grid units
    std::vector<Point> near_, chain_;
    std::vector<Insert> inserts_;
    std::vector<Stretch> waiting_;
};

}  // namespace

Polygons weld(const Polygons& polygons, double tolerance) { return Welder(polygons, tolerance).weld(polygons); }

}  // namespace filigree
