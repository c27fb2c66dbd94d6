#include "plane/verify.h"

#include <climits>
#include <vector>

#include "base/number_text.h"
#include "plane/winding_check.h"

namespace filigree {
namespace {

constexpr double run_per_tolerance = 1024;

std::string count_text(std::size_t count) { return to_text(static_cast<std::uint64_t>(count)); }

std::string near_text(Vec at) {
    std::string text = " near (";
    append_fixed(text, at.x, 6);
    text += ", ";
    append_fixed(text, at.y, 6);
    return text + ")";
}

std::string ring_text(std::size_t ring) { return "ring " + count_text(ring); }

bool is_on_plane(Point p) { return -grid_limit <= p.x && p.x <= grid_limit && -grid_limit <= p.y && p.y <= grid_limit; }

Point next_point(RingView ring, std::size_t i) { return ring[i + 1 == ring.size() ? 0 : i + 1]; }

// The sign of a ring's area, exactly: the points must lie on the plane. Sums of triangles may pass 128 bits
// on the way, so they wrap; the whole does not.
int area_sign(RingView ring) {
    __extension__ typedef unsigned __int128 Wrapping;
    Wrapping sum = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        sum += static_cast<Wrapping>(cross(ring[0], ring[i], next_point(ring, i)));
    }
    const Int128 doubled = static_cast<Int128>(sum);
    return doubled > 0 ? 1 : doubled < 0 ? -1 : 0;
}

std::optional<std::string> find_ring_flaw(RingView ring, std::size_t index) {
    if (ring.size() < 3) return ring_text(index) + " has " + count_text(ring.size()) + " points, fewer than 3";
    for (std::size_t i = 0; i < ring.size(); ++i) {
        if (!is_on_plane(ring[i])) return ring_text(index) + " has a point off the plane" + near_text(to_px(ring[i]));
    }
    for (std::size_t i = 0; i < ring.size(); ++i) {
        if (ring[i] == next_point(ring, i)) {
            return ring_text(index) + " repeats its point " + count_text(i) + near_text(to_px(ring[i]));
        }
    }
    const int sign = area_sign(ring);
    if (sign == 0) return ring_text(index) + " has no area";
    if (index == 0 && sign < 0) return std::string("the outer ring has negative area");
    if (index > 0 && sign > 0) return ring_text(index) + ", a hole, has positive area";
    return std::nullopt;
}

void add_edges(RingView ring, bool turned_round, std::vector<DirectedEdge>& edges) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point from = ring[i], to = next_point(ring, i);
        edges.push_back(turned_round ? DirectedEdge{to, from} : DirectedEdge{from, to});
    }
}

// Which rings are to blame for a wrong winding number somewhere.
std::string blame(PolygonView polygon, FinePoint at) {
    std::vector<std::size_t> holes_there;
    for (std::size_t r = 0; r < polygon.ring_count(); ++r) {
        const int count = winding(polygon.ring(r), at);
        const int expected = r == 0 ? 1 : -1;
        if (count != 0 && count != expected) return ring_text(r) + " crosses itself" + near_text(to_px(at));
        if (r > 0 && count != 0) holes_there.push_back(r);
    }
    if (holes_there.size() == 1) {
        return ring_text(holes_there[0]) + ", a hole, reaches outside the outer ring" + near_text(to_px(at));
    }
    if (holes_there.size() > 1) {
        return "rings " + count_text(holes_there[0]) + " and " + count_text(holes_there[1]) + ", both holes, overlap" +
               near_text(to_px(at));
    }
    return "the rings cross" + near_text(to_px(at));
}

}  // namespace

std::optional<std::string> find_flaw(PolygonView polygon, double tolerance) {
    if (polygon.ring_count() == 0) return std::string("the polygon has no rings");
    std::vector<DirectedEdge> edges;
    edges.reserve(polygon.point_count());
    for (std::size_t r = 0; r < polygon.ring_count(); ++r) {
        if (auto flaw = find_ring_flaw(polygon.ring(r), r)) return flaw;
        add_edges(polygon.ring(r), false, edges);
    }
    const auto flaw = find_wrong_winding(edges, {0, 1, tolerance, run_per_tolerance * tolerance});
    if (!flaw) return std::nullopt;
    if (flaw->is_run) return "a ring runs along itself or another ring" + near_text(to_px(flaw->at));
    return blame(polygon, flaw->at);
}

std::optional<std::string> find_overlap(const Polygons& polygons, double tolerance) {
    std::vector<DirectedEdge> edges;
    edges.reserve(polygons.points.size());
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        const PolygonView polygon = polygons[i];
        for (std::size_t r = 0; r < polygon.ring_count(); ++r) {
            const RingView ring = polygon.ring(r);
            for (const Point p : ring) {
                if (!is_on_plane(p)) {
                    return "polygon " + count_text(i) + " has a point off the plane" + near_text(to_px(p));
                }
            }
            if (ring.size() >= 3) add_edges(ring, (area_sign(ring) > 0) != (r == 0), edges);
        }
    }
    const auto flaw = find_wrong_winding(edges, {INT_MIN, 1, tolerance, std::nullopt});
    if (!flaw) return std::nullopt;

    std::vector<std::size_t> there;
    for (std::size_t i = 0; i < polygons.size() && there.size() < 2; ++i) {
        const PolygonView polygon = polygons[i];
        int count = 0;
        for (std::size_t r = 0; r < polygon.ring_count(); ++r) {
            const RingView ring = polygon.ring(r);
            if (ring.size() >= 3) count += winding(ring, flaw->at) * ((area_sign(ring) > 0) == (r == 0) ? 1 : -1);
        }
        if (count > 0) there.push_back(i);
    }
    if (there.size() < 2) {
        const std::string which = there.empty() ? "a polygon" : "polygon " + count_text(there[0]);
        return which + " overlaps itself" + near_text(to_px(flaw->at));
    }
    return "polygons " + count_text(there[0]) + " and " + count_text(there[1]) + " overlap" +
           near_text(to_px(flaw->at));
}

}  // namespace filigree
