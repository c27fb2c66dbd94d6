#include "plane/mosaic.h"

#include <algorithm>
#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <optional>
#include <tuple>

#include "plane/curve_cut.h"
#include "plane/edge_tree.h"

namespace filigree {

namespace {

using Diagram = boost::polygon::voronoi_diagram<double>;

constexpr double far = 4;             // region sizes: where sites stand that no place of the region belongs to
constexpr double far_units = 0x1p29;  // the same on the whole numbers that the diagram is made on

// The part of a segment inside a box; what is cut off lies far outside the region.
std::optional<Edge> clipped(Edge edge, const VecBox& box) {
    double begin = 0, end = 1;
    const Vec along = edge.to - edge.from;
    const auto cut = [&](double towards, double room) {  // where towards * t <= room
        if (towards == 0) return room >= 0;
        const double t = room / towards;
        if (towards > 0) {
            end = std::min(end, t);
        } else {
            begin = std::max(begin, t);
        }
        return begin < end;
    };
    if (!cut(along.x, box.max.x - edge.from.x) || !cut(-along.x, edge.from.x - box.min.x) ||
        !cut(along.y, box.max.y - edge.from.y) || !cut(-along.y, edge.from.y - box.min.y)) {
        return std::nullopt;
    }
    const Edge whole = edge;
    if (begin > 0) edge.from = whole.from + along * begin;
    if (end < 1) edge.to = whole.from + along * end;
    return edge;
}

std::vector<Polyline> borders_of_cells(const std::vector<boost::polygon::point_data<std::int32_t>>& points, Vec centre,
                                       double scale, double size) {
    Diagram diagram;
    boost::polygon::construct_voronoi(points.begin(), points.end(), &diagram);
    const VecBox box = around(centre, size);
    std::vector<Polyline> borders;
    for (const Diagram::edge_type& edge : diagram.edges()) {
        if (!edge.is_finite() || edge.cell()->source_index() > edge.twin()->cell()->source_index()) continue;
        const Vec from{edge.vertex0()->x() / scale, edge.vertex0()->y() / scale};
        const Vec to{edge.vertex1()->x() / scale, edge.vertex1()->y() / scale};
        if (const auto inside = clipped({centre + from, centre + to}, box)) {
            borders.push_back({{inside->from, inside->to}, false});
        }
    }
    return borders;
}

// Finds the nearest of many points.
class Nearest {
public:
    Nearest(std::span<const Vec> points, double first_reach) : first_reach_(first_reach), tree_(edges_of(points)) {
        for (std::uint32_t i = 0; i < points.size(); ++i) order_.push_back({points[i], i});
        std::sort(order_.begin(), order_.end(), [](const Place& a, const Place& b) { return key(a) < key(b); });
    }
    std::uint32_t to(Vec p) const {
        for (double reach = first_reach_;; reach *= 2) {
            if (!tree_.is_any_nearer(p, reach) && reach < 0x1p40) continue;
            const Vec at = tree_.place(p, reach, reach).nearest;
            const Place wanted{at, 0};
            const auto found = std::lower_bound(order_.begin(), order_.end(), wanted,
                                                [](const Place& a, const Place& b) { return key(a) < key(b); });
            return found == order_.end() ? 0 : found->index;
        }
    }

private:
    struct Place {
        Vec at;
        std::uint32_t index;
    };
    static std::tuple<double, double, std::uint32_t> key(const Place& place) {
        return {place.at.x, place.at.y, place.index};
    }
    static std::vector<Edge> edges_of(std::span<const Vec> points) {
        std::vector<Edge> edges;
        for (const Vec p : points) edges.push_back({p, p});
        return edges;
    }

    double first_reach_;
    EdgeTree tree_;
    std::vector<Place> order_;
};

}  // namespace

Mosaic mosaic(PolygonView region, std::span<const Vec> sites) {
    Mosaic result;
    if (sites.size() < 2) {
        result.pieces.add(region);
        result.sites = {0};
        return result;
    }
    const Box box = bounds(region);
    const Vec low = to_px(box.min), high = to_px(box.max), centre = 0.5 * (low + high);
    double size = std::max(high.x - low.x, high.y - low.y);
    for (const Vec site : sites) size = std::max({size, std::fabs(site.x - centre.x), std::fabs(site.y - centre.y)});
    const double scale = far_units / (far * size);
    std::vector<boost::polygon::point_data<std::int32_t>> points;
    points.reserve(sites.size() + 8);
    const auto add = [&](Vec at) {
        points.emplace_back(static_cast<std::int32_t>(std::lround(at.x * scale)),
                            static_cast<std::int32_t>(std::lround(at.y * scale)));
    };
    for (const Vec site : sites) add(site - centre);
    // Sites all around, so that every border that comes to the region has two ends.
    for (int x = -1; x <= 1; ++x) {
        for (int y = -1; y <= 1; ++y) {
            if (x != 0 || y != 0) add(Vec{far * x, far * y} * size);
        }
    }
    const std::vector<Polyline> borders = borders_of_cells(points, centre, scale, size);
    result.pieces = cut_by_curves(region, borders);
    const Nearest nearest(sites, size / std::sqrt(static_cast<double>(sites.size())));
    result.sites.reserve(result.pieces.size());
    // A cell is convex, so the centroid of any piece of it lies in it.
    for (std::size_t i = 0; i < result.pieces.size(); ++i)
        result.sites.push_back(nearest.to(centroid(result.pieces[i])));
    return result;
}

}  // namespace filigree
