#include "plane/weld.h"

#include <algorithm>
#include <iterator>

#include "plane/edge_inserts.h"
#include "plane/shared_edges.h"

namespace filigree {
namespace {

bool is_on_plane(Point p) { return -grid_limit <= p.x && p.x <= grid_limit && -grid_limit <= p.y && p.y <= grid_limit; }

std::vector<Point> points_on_plane(const Polygons& polygons) {
    std::vector<Point> points;
    points.reserve(polygons.points.size());
    std::copy_if(polygons.points.begin(), polygons.points.end(), std::back_inserter(points), is_on_plane);
    return points;
}

}  // namespace

Polygons weld(const Polygons& polygons, double tolerance) {
    const PointTree tree(points_on_plane(polygons));
    const std::vector<Point>& points = tree.points();
    const SharedEdges given = shared_edges(points, ring_links(polygons, tree));
    const EdgeInserts inserts = edge_inserts(tree, given.edges, tolerance);

    Polygons welded;
    welded.points.reserve(polygons.points.size() + 2 * inserts.points.size());
    welded.ring_ends.reserve(polygons.ring_ends.size());
    welded.polygon_ends = polygons.polygon_ends;
    std::size_t begin = 0;
    for (const std::uint32_t end : polygons.ring_ends) {
        for (std::size_t i = begin; i < end; ++i) {
            welded.points.push_back(polygons.points[i]);
            const std::uint32_t side = given.sides[i];
            if (side == BorderMap::none) continue;
            const auto between = inserts.of(BorderMap::edge_of(side));
            const std::size_t first = welded.points.size();
            for (const std::uint32_t at : between) welded.points.push_back(points[at]);
            if (BorderMap::is_turned(side)) {
                std::reverse(welded.points.begin() + static_cast<std::ptrdiff_t>(first), welded.points.end());
            }
        }
        welded.end_ring();
        begin = end;
    }
    return welded;
}

}  // namespace filigree
