#include "curves/faces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/elementary.h"

namespace filigree::curves {
namespace {

constexpr std::uint32_t none = UINT32_MAX;

// The nodes where lines end and meet; places nearer than the tolerance are one.
class Nodes {
public:
    explicit Nodes(double tolerance) : reach_(2 * tolerance), cell_(4 * tolerance) {}

    std::uint32_t at(Vec p) {
        const auto column = cell_of(p.x), row = cell_of(p.y);
        for (std::int64_t x = column - 1; x <= column + 1; ++x) {
            for (std::int64_t y = row - 1; y <= row + 1; ++y) {
                const auto found = cells_.find({x, y});
                if (found == cells_.end()) continue;
                for (const std::uint32_t node : found->second) {
                    if (length(places[node] - p) <= reach_) return node;
                }
            }
        }
        places.push_back(p);
        const auto node = static_cast<std::uint32_t>(places.size() - 1);
        cells_[{column, row}].push_back(node);
        return node;
    }

    std::vector<Vec> places;

private:
    std::int64_t cell_of(double v) const {
        return static_cast<std::int64_t>(std::floor(std::clamp(v / cell_, -1e18, 1e18)));
    }

    double reach_, cell_;
    std::map<std::pair<std::int64_t, std::int64_t>, std::vector<std::uint32_t>> cells_;  // looked up only
};

// Where two lines come within the tolerance, as parameters of both; ends that touch belong to it.
void add_meeting(const Element& a, const Element& b, double tolerance, std::vector<double>& on_a,
                 std::vector<double>& on_b) {
    const Vec u = a.at[1] - a.at[0], v = b.at[1] - b.at[0];
    const double turn = cross(u, v), size_a = length(u), size_b = length(v);
    if (std::fabs(turn) <= 1e-12 * size_a * size_b) return;  // their common ends are nodes already
    const Vec off = b.at[0] - a.at[0];
    const double s = cross(off, v) / turn, t = cross(off, u) / turn;
    const double slack_a = tolerance / size_a, slack_b = tolerance / size_b;
    if (s < -slack_a || s > 1 + slack_a || t < -slack_b || t > 1 + slack_b) return;
    on_a.push_back(std::clamp(s, 0.0, 1.0));
    on_b.push_back(std::clamp(t, 0.0, 1.0));
}

struct Half {
    std::uint32_t to = 0, twin = 0, next = none;
    double angle = 0;
};

// Half-edges by the node that they leave, each node's by angle.
struct Graph {
    std::vector<Half> halves;
    std::vector<std::vector<std::uint32_t>> arms;
};

Graph graph_of(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& edges, const std::vector<Vec>& places) {
    Graph graph;
    graph.arms.resize(places.size());
    for (const auto& [from, to] : edges) {
        const Vec way = places[to] - places[from];
        const auto first = static_cast<std::uint32_t>(graph.halves.size());
        graph.halves.push_back({to, first + 1, none, elementary::atan2(way.y, way.x)});
        graph.halves.push_back({from, first, none, elementary::atan2(-way.y, -way.x)});
        graph.arms[from].push_back(first);
        graph.arms[to].push_back(first + 1);
    }
    for (auto& arms : graph.arms) {
        std::sort(arms.begin(), arms.end(), [&](std::uint32_t a, std::uint32_t b) {
            return std::pair(graph.halves[a].angle, a) < std::pair(graph.halves[b].angle, b);
        });
        // Behind an edge that comes in, a face goes on with the arm before its twin.
        for (std::size_t i = 0; i < arms.size(); ++i) {
            const std::uint32_t in = graph.halves[arms[i]].twin;
            graph.halves[in].next = arms[(i + arms.size() - 1) % arms.size()];
        }
    }
    return graph;
}

// A cycle without its straight nodes, or nothing where it is not convex or turns the wrong way.
std::vector<Vec> corners_of(const std::vector<Vec>& cycle, double tolerance) {
    std::vector<Vec> corners;
    for (std::size_t i = 0; i < cycle.size(); ++i) {
        const Vec before = cycle[(i + cycle.size() - 1) % cycle.size()], here = cycle[i];
        const Vec behind = cycle[(i + 1) % cycle.size()];
        const Vec in = here - before, out = behind - here;
        const double turn = cross(in, out) / std::max(length(behind - before), 1e-300);
        if (std::fabs(turn) <= tolerance && dot(in, out) > 0) continue;
        if (!(turn > tolerance)) return {};
        corners.push_back(here);
    }
    if (corners.size() < 3 || !(area_of(corners) > 0)) return {};
    return corners;
}

bool is_inside(Vec p, const std::vector<Vec>& corners, double depth) {
    for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
        const Vec side = corners[i] - corners[j];
        if (!(cross(side, p - corners[j]) > depth * length(side))) return false;
    }
    return true;
}

bool has_something_inside(const Face& face, const std::vector<Vec>& nodes, const Shape& shape, double tolerance) {
    const double depth = 4 * tolerance;
    Bounds box;
    for (const Vec corner : face.corners) extend(box, corner);
    const auto is_in = [&](Vec p) {
        return p.x > box.min.x && p.x < box.max.x && p.y > box.min.y && p.y < box.max.y &&
               is_inside(p, face.corners, depth);
    };
    if (std::any_of(nodes.begin(), nodes.end(), is_in)) return true;
    for (const Element& e : shape.elements) {
        if (e.kind == ElementKind::line || e.kind == ElementKind::point) continue;
        if (!do_overlap(bounds_of(e), box)) continue;
        const Interval on = interval_of(e);
        for (int i = 0; i <= 64; ++i) {
            if (is_in(point_at(e, on.from + (on.to - on.from) * i / 64))) return true;
        }
    }
    return false;
}

}  // namespace

std::vector<Face> convex_faces(const Shape& shape, double tolerance) {
    std::vector<const Element*> lines;
    for (const Element& e : shape.elements) {
        if (e.kind == ElementKind::line) lines.push_back(&e);
    }
    std::vector<Bounds> boxes;
    for (const Element* line : lines) boxes.push_back(bounds_of(*line));
    std::vector<std::uint32_t> by_left(lines.size());
    for (std::uint32_t i = 0; i < lines.size(); ++i) by_left[i] = i;
    std::sort(by_left.begin(), by_left.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::pair(boxes[a].min.x, a) < std::pair(boxes[b].min.x, b);
    });
    std::vector<std::vector<double>> cuts(lines.size(), {0, 1});
    for (std::size_t i = 0; i < by_left.size(); ++i) {
        for (std::size_t j = i + 1; j < by_left.size(); ++j) {
            const std::uint32_t a = by_left[i], b = by_left[j];
            if (boxes[b].min.x > boxes[a].max.x + tolerance) break;
            if (do_overlap(boxes[a], boxes[b], tolerance))
                add_meeting(*lines[a], *lines[b], tolerance, cuts[a], cuts[b]);
        }
    }
    Nodes nodes(tolerance);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        std::sort(cuts[i].begin(), cuts[i].end());
        std::uint32_t last = none;
        for (const double t : cuts[i]) {
            const std::uint32_t node = nodes.at(point_at(*lines[i], t));
            if (last != none && node != last) edges.emplace_back(std::min(last, node), std::max(last, node));
            last = node;
        }
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    Graph graph = graph_of(edges, nodes.places);

    std::vector<Face> faces;
    std::vector<std::uint8_t> is_seen(graph.halves.size());
    for (std::uint32_t first = 0; first < graph.halves.size(); ++first) {
        std::vector<Vec> cycle;
        for (std::uint32_t h = first; is_seen[h] == 0; h = graph.halves[h].next) {
            is_seen[h] = 1;
            cycle.push_back(nodes.places[graph.halves[h].to]);
        }
        if (cycle.size() < 3) continue;
        Face face{corners_of(cycle, tolerance)};
        if (face.corners.empty() || has_something_inside(face, nodes.places, shape, tolerance)) continue;
        const auto least = std::min_element(face.corners.begin(), face.corners.end(),
                                            [](Vec a, Vec b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); });
        std::rotate(face.corners.begin(), least, face.corners.end());
        faces.push_back(std::move(face));
    }
    std::sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) {
        return std::lexicographical_compare(a.corners.begin(), a.corners.end(), b.corners.begin(), b.corners.end(),
                                            [](Vec p, Vec q) { return std::pair(p.x, p.y) < std::pair(q.x, q.y); });
    });
    return faces;
}

double area_of(const std::vector<Vec>& corners) {
    double twice = 0;
    for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
        twice += cross(corners[j] - corners[0], corners[i] - corners[0]);
    }
    return 0.5 * twice;
}

Vec stretched(Vec p, const std::vector<Vec>& from, const std::vector<Vec>& to) {
    const std::size_t count = from.size();
    // On a side, or beyond it, by the ends of that side alone.
    std::size_t nearest = 0;
    double least = 1e300;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec side = from[(i + 1) % count] - from[i];
        const double inwards = cross(side, p - from[i]) / length(side);
        if (inwards < least) least = inwards, nearest = i;
    }
    const Vec a = from[nearest], b = from[(nearest + 1) % count];
    if (least <= 1e-9 * length(b - a)) {
        const double t = dot(p - a, b - a) / dot(b - a, b - a);
        const Vec u = to[nearest], v = to[(nearest + 1) % count];
        return u * (1 - t) + v * t;
    }
    Vec sum;
    double total = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec before = from[(i + count - 1) % count], here = from[i], behind = from[(i + 1) % count];
        const double weight =
            cross(here - before, behind - here) / (cross(here - before, p - before) * cross(behind - here, p - here));
        sum = sum + to[i] * weight;
        total += weight;
    }
    return sum * (1 / total);
}

}  // namespace filigree::curves
