#include "plane/perturb.h"

#include <algorithm>
#include <span>
#include <utility>

#include "plane/face_check.h"
#include "plane/noise.h"
#include "plane/wobble_net.h"
#include "plane/wobble_reach.h"

namespace filigree {
namespace {

constexpr int halvings = 6;               // of the reach of what crosses; after that it does not move
constexpr double merge_within = 0x1p-20;  // px: what is nearer than rounding cannot be kept apart

VertexRings vertex_rings(const WobbleNet& net) {
    VertexRings rings;
    rings.vertices.reserve(net.map.sides.size() + (net.places.size() - net.map.vertices.size()) * 2);
    rings.ring_ends.reserve(net.map.ring_ends.size());
    rings.polygon_ends = net.map.polygon_ends;
    std::size_t begin = 0;
    for (const std::uint32_t end : net.map.ring_ends) {
        for (std::size_t i = begin; i < end; ++i) {
            const std::uint32_t side = net.map.sides[i];
            if (side != BorderMap::none) net.walk(side, [&](std::uint32_t v) { rings.vertices.push_back(v); });
        }
        rings.ring_ends.push_back(static_cast<std::uint32_t>(rings.vertices.size()));
        begin = end;
    }
    return rings;
}

class Perturber {
public:
    Perturber(WobbleNet net, std::size_t faces, std::uint64_t seed)
        : net_(std::move(net)),
          rings_(vertex_rings(net_)),
          faces_(faces),
          reach_(net_),
          shifts_(net_.places.size()),
          at_(net_.places) {
        NoiseField noise(seed);
        for (std::uint32_t v = 0; v < at_.size(); ++v) {
            if (!(net_.wishes[v] > 0)) continue;
            shifts_[v] = noise.at(to_px(net_.places[v]) * (1 / net_.waves[v]));
            move(v);
        }
    }

    // Moves vertices of edges that cross less, until none does. Where all faces are clean and their common outline
    // does not cross itself, no two overlap: each place is covered as often as the outline turns around it.
    void settle(const std::vector<DirectedLink>& outline) {
        std::vector<std::uint8_t> is_stale(faces_, 1), has_moved(at_.size());
        bool is_outline_stale = true;
        std::vector<std::uint32_t> found, changed;
        FaceCheck faces(rings_, net_.places, at_);
        CrossingFinder crossings;
        for (int round = 0;; ++round) {
            found.clear();
            for (std::size_t p = 0; p < faces_; ++p) {
                if (is_stale[p] != 0) faces.find(p, found);
            }
            if (is_outline_stale) crossings.find(outline, at_, found);
            std::sort(found.begin(), found.end());
            found.erase(std::unique(found.begin(), found.end()), found.end());
            std::erase_if(found, [&](std::uint32_t v) { return !(reach_.of(v) > 0); });
            if (found.empty()) return;  // what crosses without moving did so before
            for (const std::uint32_t v : found) reach_.lower(v, round < halvings ? reach_.of(v) / 2 : 0);
            changed.clear();
            reach_.spread_from(found, changed);
            std::fill(has_moved.begin(), has_moved.end(), std::uint8_t{0});
            for (const std::uint32_t v : changed) {
                has_moved[v] = 1;
                move(v);
            }
            for (std::size_t p = 0; p < faces_; ++p) {
                const auto vertices = rings_.of_polygon(p);
                is_stale[p] =
                    std::any_of(vertices.begin(), vertices.end(), [&](std::uint32_t v) { return has_moved[v] != 0; });
            }
            is_outline_stale = std::any_of(outline.begin(), outline.end(), [&](const DirectedLink& link) {
                return has_moved[link.from] != 0 || has_moved[link.to] != 0;
            });
        }
    }

    std::vector<DirectedLink> outline() const {
        std::vector<DirectedLink> links;
        const std::size_t face_sides = net_.map.side_count(faces_);
        for (std::size_t s = 0; s < face_sides; ++s) {
            const std::uint32_t side = net_.map.sides[s];
            if (side == BorderMap::none || net_.is_outline[BorderMap::edge_of(side)] == 0) continue;
            std::uint32_t before = BorderMap::none;
            const auto pass = [&](std::uint32_t v) {
                if (before != BorderMap::none) links.push_back({before, v});
                before = v;
            };
            net_.walk(side, pass);
            pass(net_.map.end_of(side));
        }
        return links;
    }

    Polygons polygons(std::size_t first, std::size_t end) const {
        Polygons moved;
        for (std::size_t p = first; p < end; ++p) {
            for (std::size_t r = rings_.first_ring(p); r < rings_.polygon_ends[p]; ++r) {
                const std::span<const std::uint32_t> ring = rings_.ring(r);
                // A needle thinner than the weld's tolerance is nothing but edges on each other.
                if (area_sign(ring, at_) == 0) continue;
                for (const std::uint32_t v : ring) moved.points.push_back(at_[v]);
                moved.end_ring();
            }
            moved.end_polygon();
        }
        return moved;
    }

private:
    void move(std::uint32_t v) {
        const double reach = reach_.of(v);
        const Point by = snap(reach * shifts_[v] + (reach / net_.wishes[v]) * net_.pulls[v]), from = net_.places[v];
        const Point to{from.x + by.x, from.y + by.y};
        const auto is_off = [](std::int64_t c) { return c < -grid_limit || c > grid_limit; };
        at_[v] = is_off(to.x) || is_off(to.y) ? from : to;
    }

    const WobbleNet net_;
    const VertexRings rings_;
    const std::size_t faces_;
    WobbleReach reach_;
    std::vector<Vec> shifts_;  // of each vertex, where it may go 1 px far
    std::vector<Point> at_;
};

Polygons perturbed_marks(const WobblyShapes& marks, std::uint64_t seed) {
    const bool are_still = std::all_of(marks.wobbles.begin(), marks.wobbles.end(),
                                       [](const Wobble& wobble) { return amplitude_of(wobble) == 0; });
    if (are_still) return marks.polygons;
    const std::size_t count = marks.polygons.size();
    BorderMap map = border_map(marks.polygons, merge_within);
    Perturber perturber(wobble_net(std::move(map), marks.wobbles, count, Detail::given), count, seed);
    perturber.settle({});
    return perturber.polygons(0, count);
}

}  // namespace

Perturbed perturb(const PerturbInput& input) {
    Polygons all = input.faces.polygons;
    all.add_all(input.borders.polygons);
    std::vector<Wobble> wobbles = input.faces.wobbles;
    wobbles.insert(wobbles.end(), input.borders.wobbles.begin(), input.borders.wobbles.end());
    const std::size_t faces = input.faces.polygons.size();
    BorderMap map = welded_border_map(all, merge_within);
    Perturber perturber(wobble_net(std::move(map), wobbles, faces, Detail::more), faces, input.seed);
    perturber.settle(perturber.outline());
    return {perturber.polygons(0, faces), perturber.polygons(faces, all.size()),
            perturbed_marks(input.marks, input.seed)};
}

}  // namespace filigree
