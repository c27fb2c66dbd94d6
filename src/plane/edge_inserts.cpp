#include "plane/edge_inserts.h"

#include <algorithm>
#include <cmath>

namespace filigree {
namespace {

// (b - a) . (c - a), exact.
Int128 along(Point a, Point b, Point c) {
    return static_cast<Int128>(b.x - a.x) * (c.x - a.x) + static_cast<Int128>(b.y - a.y) * (c.y - a.y);
}

class InsertFinder {
public:
    InsertFinder(const PointTree& tree, double tolerance) : tree_(tree), points_(tree.points()) {
        const double units = tolerance * grid_per_px;
        tolerance_ = units > 0 ? units : 0;  // also for NaN
    }

    // Appends what lies between the ends of an edge.
    void add_between(const BorderMap::Edge& edge, std::vector<std::uint32_t>& found) {
        const std::size_t first = found.size();
        waiting_.clear();
        // Depth first, in order along the edge; `waiting_` holds what is still to come, nearest last.
        for (Stretch stretch{edge.low, edge.high, false};;) {
            find_inserts(stretch.low, stretch.high);
            if (inserts_.empty()) {
                found.push_back(stretch.turned_round ? stretch.low : stretch.high);
            } else {
                chain_.clear();
                chain_.push_back(stretch.low);
                for (const Insert& insert : inserts_) chain_.push_back(insert.at);
                chain_.push_back(stretch.high);
                if (stretch.turned_round) std::reverse(chain_.begin(), chain_.end());
                for (std::size_t i = chain_.size() - 1; i > 0; --i) {
                    const std::uint32_t from = chain_[i - 1], to = chain_[i];
                    const bool turned_round = points_[to] < points_[from];
                    waiting_.push_back({turned_round ? to : from, turned_round ? from : to, turned_round});
                }
            }
            if (waiting_.empty()) break;
            stretch = waiting_.back();
            waiting_.pop_back();
        }
        if (found.size() > first) found.pop_back();  // the far end
    }

private:
    struct Insert {
        Int128 along = 0;
        std::uint32_t at = 0;
    };
    struct Stretch {
        std::uint32_t low = 0, high = 0;
        bool turned_round = false;  // the edge runs from high to low here
    };

    void find_inserts(std::uint32_t low, std::uint32_t high) {
        inserts_.clear();
        near_.clear();
        const Point a = points_[low], b = points_[high];
        tree_.find_near(a, b, tolerance_, near_);
        if (near_.size() <= 2) return;  // the ends
        const double farthest = tolerance_ * std::sqrt(static_cast<double>(along(a, b, b)));
        for (const std::uint32_t at : near_) {
            if (at == low || at == high) continue;
            const Point c = points_[at];
            const Int128 turn = cross(a, b, c), off = turn < 0 ? -turn : turn;
            const Int128 from_a = along(a, b, c);
            // Below 45 degrees at both ends every new edge is shorter than this one, so the work ends.
            if (off >= from_a || off >= along(b, a, c)) continue;
            if (static_cast<double>(off) > farthest) continue;
            inserts_.push_back({from_a, at});
        }
        if (inserts_.size() < 2) return;
        std::sort(inserts_.begin(), inserts_.end(), [&](const Insert& x, const Insert& y) {
            return x.along != y.along ? x.along < y.along : points_[x.at] < points_[y.at];
        });
    }

    const PointTree& tree_;
    const std::vector<Point>& points_;
    double tolerance_ = 0;  // grid units
    std::vector<std::uint32_t> near_, chain_;
    std::vector<Insert> inserts_;
    std::vector<Stretch> waiting_;
};

}  // namespace

EdgeInserts edge_inserts(const PointTree& tree, std::span<const BorderMap::Edge> edges, double tolerance) {
    EdgeInserts inserts;
    inserts.begins.reserve(edges.size() + 1);
    InsertFinder finder(tree, tolerance);
    for (const BorderMap::Edge& edge : edges) {
        inserts.begins.push_back(static_cast<std::uint32_t>(inserts.points.size()));
        finder.add_between(edge, inserts.points);
    }
    inserts.begins.push_back(static_cast<std::uint32_t>(inserts.points.size()));
    return inserts;
}

}  // namespace filigree
