#include "plane/line_inside.h"

#include <algorithm>

namespace filigree {
namespace {

// Where a stretch meets the border, as shares of its length in 0..1, in order. Touching counts: which side a part lies
// on is asked of its middle.
std::vector<double> meetings(const Edge& stretch, const EdgeTree& border) {
    std::vector<double> at;
    const Vec along = stretch.to - stretch.from;
    const auto add = [&](double share) {
        if (share > 0 && share < 1) at.push_back(share);
    };
    border.any(around(stretch, 0), [&](std::uint32_t index) {
        const Edge& edge = border.edges()[index];
        const Vec beside = edge.to - edge.from;
        const double turn = cross(along, beside);
        const Vec apart = edge.from - stretch.from;
        if (turn == 0) {  // one along the other begins and ends at the edge's ends
            if (cross(apart, along) != 0) return false;
            add(dot(apart, along) / dot(along, along));
            add(dot(edge.to - stretch.from, along) / dot(along, along));
            return false;
        }
        const double on_edge = cross(apart, along) / turn;
        if (on_edge >= 0 && on_edge <= 1) add(cross(apart, beside) / turn);
        return false;
    });
    std::sort(at.begin(), at.end());
    at.erase(std::unique(at.begin(), at.end()), at.end());
    return at;
}

}  // namespace

void add_parts_inside(Polygons& to, RingView line, const EdgeTree& border) {
    std::size_t begun = to.ring_ends.empty() ? 0 : to.ring_ends.back();
    const auto add = [&](Vec p) {
        const Point point = snap(p);
        if (to.points.size() == begun || to.points.back() != point) to.points.push_back(point);
    };
    const auto end = [&] {
        if (to.points.size() - begun < 2) {
            to.points.resize(begun);
        } else {
            to.end_ring();
            to.end_polygon();
        }
        begun = to.points.size();
    };
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Edge stretch{to_px(line[i - 1]), to_px(line[i])};
        const auto at_share = [&](double share) { return stretch.from + share * (stretch.to - stretch.from); };
        std::vector<double> shares = meetings(stretch, border);
        shares.push_back(1);
        double from = 0;
        for (const double share : shares) {
            if (border.is_inside(at_share((from + share) / 2))) {
                add(from == 0 ? stretch.from : at_share(from));
                add(share == 1 ? stretch.to : at_share(share));
            } else {
                end();
            }
            from = share;
        }
    }
    end();
}

}  // namespace filigree
