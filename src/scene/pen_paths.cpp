// Strokes out of the edges of a map; declared in drawn_pen.h.
#include <algorithm>

#include "scene/drawn_pen.h"

namespace filigree {
namespace {

constexpr double go_on_cos = 0.85;  // 32 degrees: a stroke goes on at a crossing where it turns by less
constexpr double turn_back_cos =
    -0.5;  // 120 degrees: where two edges meet alone, a stroke goes on unless it turns by more

// The side that ends at a vertex, of an edge: half edges are numbered 2 * edge for the low end, + 1 for the high one.
constexpr std::uint32_t low_end(std::uint32_t edge) { return 2 * edge; }
constexpr std::uint32_t high_end(std::uint32_t edge) { return 2 * edge + 1; }

class PathFinder {
public:
    PathFinder(const BorderMap& map, std::span<const std::uint32_t> pens)
        : map_(map), pens_(pens), partners_(2 * map.edges.size(), BorderMap::none), is_used_(map.edges.size(), 0) {
        const EdgesAtVertices around = edges_at_vertices(map);
        for (std::uint32_t v = 0; v < map.vertices.size(); ++v) pair_at(v, around.of(v));
    }

    std::vector<PenPath> find() {
        std::vector<PenPath> paths;
        for (std::uint32_t e = 0; e < map_.edges.size(); ++e) {
            if (pens_[e] == no_pen || is_used_[e] != 0) continue;
            if (partners_[low_end(e)] == BorderMap::none)
                paths.push_back(path_from(low_end(e)));
            else if (partners_[high_end(e)] == BorderMap::none)
                paths.push_back(path_from(high_end(e)));
        }
        for (std::uint32_t e = 0; e < map_.edges.size(); ++e) {
            if (pens_[e] == no_pen || is_used_[e] != 0) continue;
            paths.push_back(path_from(low_end(e)));
            start_at_corner(paths.back());
        }
        return paths;
    }

private:
    struct Pair {
        double straightness = 0;  // 1 where the one goes straight on into the other
        std::uint32_t a = 0, b = 0;
        Point a_to, b_to;
    };

    std::uint32_t vertex_of(std::uint32_t end) const {
        return (end & 1) != 0 ? map_.edges[end / 2].high : map_.edges[end / 2].low;
    }
    Point far_point(std::uint32_t end) const { return map_.vertices[vertex_of(end ^ 1)]; }

    void pair_at(std::uint32_t v, std::span<const std::uint32_t> edges) {
        ends_.clear();
        for (const std::uint32_t e : edges) {
            if (pens_[e] != no_pen) ends_.push_back(map_.edges[e].low == v ? low_end(e) : high_end(e));
        }
        pairs_.clear();
        for (std::size_t i = 0; i < ends_.size(); ++i) {
            for (std::size_t j = i + 1; j < ends_.size(); ++j) {
                if (pens_[ends_[i] / 2] == pens_[ends_[j] / 2]) consider(v, ends_[i], ends_[j]);
            }
        }
        std::sort(pairs_.begin(), pairs_.end(), [](const Pair& a, const Pair& b) {
            if (a.straightness != b.straightness) return a.straightness > b.straightness;
            return a.a_to != b.a_to ? a.a_to < b.a_to : a.b_to < b.b_to;
        });
        for (const Pair& pair : pairs_) {
            if (partners_[pair.a] != BorderMap::none || partners_[pair.b] != BorderMap::none) continue;
            partners_[pair.a] = pair.b;
            partners_[pair.b] = pair.a;
        }
    }

    void consider(std::uint32_t v, std::uint32_t a, std::uint32_t b) {
        if (far_point(b) < far_point(a)) std::swap(a, b);
        const Point at = map_.vertices[v], p = far_point(a), q = far_point(b);
        const Vec from = to_px(Point{at.x - p.x, at.y - p.y}), to = to_px(Point{q.x - at.x, q.y - at.y});
        const double straightness = dot(from, to) / (length(from) * length(to));
        if (straightness > (ends_.size() == 2 ? turn_back_cos : go_on_cos))
            pairs_.push_back({straightness, a, b, p, q});
    }

    // From an end of an edge onwards.
    PenPath path_from(std::uint32_t end) {
        PenPath path;
        while (true) {
            path.vertices.push_back(vertex_of(end));
            path.edges.push_back(end / 2);
            is_used_[end / 2] = 1;
            const std::uint32_t next = partners_[end ^ 1];
            if (next == BorderMap::none) {
                path.vertices.push_back(vertex_of(end ^ 1));
                return path;
            }
            if (is_used_[next / 2] != 0) {
                path.is_closed = true;
                return path;
            }
            end = next;
        }
    }

    // Where a hand would begin: at the sharpest corner, the first in the order of points of several; the way to the
    // lesser neighbour.
    void start_at_corner(PenPath& path) const {
        const std::size_t count = path.vertices.size();
        const auto point = [&](std::size_t i) { return map_.vertices[path.vertices[i % count]]; };
        std::size_t best = 0;
        double best_cos = 2;
        for (std::size_t i = 0; i < count; ++i) {
            const Point before = point(i + count - 1), at = point(i), after = point(i + 1);
            const Vec from = to_px(Point{at.x - before.x, at.y - before.y}),
                      to = to_px(Point{after.x - at.x, after.y - at.y});
            const double cos = dot(from, to) / (length(from) * length(to));
            if (cos < best_cos || (cos == best_cos && at < point(best))) {
                best = i;
                best_cos = cos;
            }
        }
        const auto turn = static_cast<std::ptrdiff_t>(best);
        std::rotate(path.vertices.begin(), path.vertices.begin() + turn, path.vertices.end());
        std::rotate(path.edges.begin(), path.edges.begin() + turn, path.edges.end());
        if (count > 2 && point(count - 1) < point(1)) {
            std::reverse(path.vertices.begin() + 1, path.vertices.end());
            std::reverse(path.edges.begin(), path.edges.end());
        }
    }

    const BorderMap& map_;
    const std::span<const std::uint32_t> pens_;
    std::vector<std::uint32_t> partners_;  // of each end of an edge: where a stroke goes on
    std::vector<std::uint8_t> is_used_;
    std::vector<std::uint32_t> ends_;
    std::vector<Pair> pairs_;
};

}  // namespace

std::vector<PenPath> pen_paths(const BorderMap& map, std::span<const std::uint32_t> pens) {
    return PathFinder(map, pens).find();
}

}  // namespace filigree
