#include "plane/motif.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "base/random.h"
#include "plane/edge_tree.h"
#include "plane/transform.h"

namespace filigree {

namespace {

constexpr double drawing_radius = 1024;  // px: where drawn motifs are cleaned
constexpr double frail = 1e-4;           // of the radius: parts that come nearer to each other make a motif frail

void end_ring(Motif& motif) { motif.ring_ends.push_back(static_cast<std::uint32_t>(motif.points.size())); }
void end_polygon(Motif& motif) { motif.polygon_ends.push_back(static_cast<std::uint32_t>(motif.ring_ends.size())); }

void add_circle(Motif& motif, double radius, int corners) {
    for (const Vec p : unit_circle(corners)) motif.points.push_back(radius * p);
}

// Scales all so that the farthest point lies on the circle of radius 1.
void fill_circle(Motif& motif) {
    double farthest = 0;
    for (const Vec p : motif.points) farthest = std::max(farthest, length(p));
    if (!(farthest > 0)) return;
    for (Vec& p : motif.points) p = p * (1 / farthest);
}

struct Circle {
    Vec centre;
    double radius2 = -1;

    bool holds(Vec p) const { return dot(p - centre, p - centre) <= radius2 * (1 + 1e-12) + 1e-300; }
};
Circle circle_of(Vec a, Vec b) {
    const Vec centre = 0.5 * (a + b);
    return {centre, dot(a - centre, a - centre)};
}
Circle circle_of(Vec a, Vec b, Vec c) {
    const Vec u = b - a, v = c - a;
    const double turn = 2 * cross(u, v);
    if (turn == 0) {
        Circle widest = circle_of(a, b);
        for (const Circle& other : {circle_of(a, c), circle_of(b, c)}) {
            if (other.radius2 > widest.radius2) widest = other;
        }
        return widest;
    }
    const Vec to_centre{(v.y * dot(u, u) - u.y * dot(v, v)) / turn, (u.x * dot(v, v) - v.x * dot(u, u)) / turn};
    return {a + to_centre, dot(to_centre, to_centre)};
}

// Welzl's smallest enclosing circle, with the points in an order drawn for their number.
Circle enclosing_circle(const std::vector<Vec>& given) {
    std::vector<Vec> points;
    points.reserve(given.size());
    for (const std::uint32_t i : permutation(0, Key{}, "circle", static_cast<std::uint32_t>(given.size()))) {
        points.push_back(given[i]);
    }
    Circle circle;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (circle.holds(points[i])) continue;
        circle = {points[i], 0};
        for (std::size_t j = 0; j < i; ++j) {
            if (circle.holds(points[j])) continue;
            circle = circle_of(points[i], points[j]);
            for (std::size_t k = 0; k < j; ++k) {
                if (!circle.holds(points[k])) circle = circle_of(points[i], points[j], points[k]);
            }
        }
    }
    return circle;
}

// Douglas and Peucker's, between two points that stay.
void keep_needed(const std::vector<Vec>& points, std::size_t first, std::size_t last, double tolerance2,
                 std::vector<std::uint8_t>& is_kept) {
    std::vector<std::pair<std::size_t, std::size_t>> open{{first, last}};
    while (!open.empty()) {
        const auto [from, to] = open.back();
        open.pop_back();
        const Edge chord{points[from], points[to]};
        double worst = tolerance2;
        std::size_t at = from;
        for (std::size_t i = from + 1; i < to; ++i) {
            const double off = squared_distance(chord, points[i]);
            if (off > worst) {
                worst = off;
                at = i;
            }
        }
        if (at == from) continue;
        is_kept[at] = 1;
        open.push_back({from, at});
        open.push_back({at, to});
    }
}

// A closed outline with fewer points; its two ends are the first point and the one farthest from it.
Polyline simplified(const Polyline& outline, double tolerance) {
    if (outline.points.size() < 4) return outline;
    std::vector<Vec> points = outline.points;
    points.push_back(points.front());
    std::size_t far = 0;
    double farthest = -1;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double distance = length(points[i] - points[0]);
        if (distance > farthest) {
            farthest = distance;
            far = i;
        }
    }
    std::vector<std::uint8_t> is_kept(points.size(), 0);
    is_kept.front() = is_kept[far] = 1;
    keep_needed(points, 0, far, tolerance * tolerance, is_kept);
    keep_needed(points, far, points.size() - 1, tolerance * tolerance, is_kept);
    Polyline result{{}, true};
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        if (is_kept[i]) result.points.push_back(points[i]);
    }
    return result;
}

// Whether a corner comes near to an edge that does not end in it.
bool comes_near_itself(const Polygons& polygons, double reach) {
    std::vector<Edge> edges;
    std::uint32_t first = 0;
    for (const std::uint32_t end : polygons.ring_ends) {
        for (std::uint32_t i = first, last = end - 1; i < end; last = i++) {
            edges.push_back({to_px(polygons.points[last]), to_px(polygons.points[i])});
        }
        first = end;
    }
    std::vector<Vec> corners;
    for (const Point p : polygons.points) corners.push_back(to_px(p));
    std::sort(corners.begin(), corners.end(), [](Vec a, Vec b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    if (std::adjacent_find(corners.begin(), corners.end()) != corners.end()) return true;
    const EdgeTree tree(std::move(edges));
    return std::any_of(corners.begin(), corners.end(), [&](Vec corner) {
        return tree.any(around(corner, reach), [&](std::uint32_t e) {
            const Edge& edge = tree.edges()[e];
            return !(edge.from == corner) && !(edge.to == corner) && is_nearer(edge, corner, reach * reach);
        });
    });
}

// The outline of a stroke along a line of points: forth on one side, back on the other, with round ends.
Motif stroke_motif(const std::vector<Vec>& line, double half_width, int end_corners) {
    Motif motif;
    const auto aside = [&](std::size_t i) {
        const Vec along = line[std::min(i + 1, line.size() - 1)] - line[i == 0 ? 0 : i - 1];
        return perpendicular(along) * (half_width / length(along));
    };
    const auto add_end = [&](Vec at, Vec from) {  // half around, without the two ends of the arc
        for (int k = 1; k < end_corners; ++k) {
            const Vec turn = unit_at_degrees(180.0 * k / end_corners);
            motif.points.push_back(at + turn.x * from + turn.y * perpendicular(from));
        }
    };
    for (std::size_t i = 0; i < line.size(); ++i) motif.points.push_back(line[i] - aside(i));
    add_end(line.back(), -aside(line.size() - 1));
    for (std::size_t i = line.size(); i-- > 0;) motif.points.push_back(line[i] + aside(i));
    add_end(line.front(), aside(0));
    end_ring(motif);
    end_polygon(motif);
    fill_circle(motif);
    return motif;
}

}  // namespace

int circle_corners(double radius, double tolerance) {
    // A chord of a circle lies r (1 - cos(half its angle)) inside: about pi^2 r / (2 n^2) for n corners.
    const double flatness = std::clamp(tolerance, radius * 1e-5, radius / 8);
    const double wanted = std::ceil(elementary::pi * std::sqrt(radius / (2 * flatness)) / 4) * 4;
    return static_cast<int>(std::clamp(wanted, 12.0, 256.0));
}

Motif disc_motif(int corners) {
    Motif motif;
    motif.is_round = true;
    add_circle(motif, 1, corners);
    end_ring(motif);
    end_polygon(motif);
    return motif;
}

std::vector<Vec> unit_circle(int corners) {
    std::vector<Vec> circle;
    circle.reserve(static_cast<std::size_t>(corners));
    for (int i = 0; i < corners; ++i) circle.push_back(unit_at_degrees(360.0 * i / corners));
    return circle;
}

Motif blob_motif(const std::vector<Vec>& circle, std::uint64_t bits) {
    // Waves of two to four turns, the finer the flatter, each of its own strength.
    constexpr std::size_t waves = 3;
    Vec wave[waves];
    const double most[waves] = {0.085, 0.045, 0.014};
    for (std::size_t k = 0; k < waves; ++k) {
        const double strength = most[k] * (0.45 + 0.55 * to_unit(mix(bits ^ (2 * k + 1))));
        wave[k] = strength * unit_at_degrees(360 * to_unit(mix(bits ^ (2 * k + 2))));
    }
    Motif motif;
    motif.is_round = true;
    motif.points.reserve(circle.size());
    for (std::size_t i = 0; i < circle.size(); ++i) {
        double reach = 1;
        for (std::size_t k = 0; k < waves; ++k) reach += dot(wave[k], circle[(k + 2) * i % circle.size()]);
        motif.points.push_back(reach * circle[i]);
    }
    double doubled = 0;
    Vec moment;
    for (std::size_t i = 0, last = motif.points.size() - 1; i < motif.points.size(); last = i++) {
        const double weight = cross(motif.points[last], motif.points[i]);
        doubled += weight;
        moment = moment + (motif.points[last] + motif.points[i]) * weight;
    }
    for (Vec& p : motif.points) p = p - moment * (1 / (3 * doubled));
    end_ring(motif);
    end_polygon(motif);
    fill_circle(motif);
    return motif;
}

Motif square_motif() {
    Motif motif;
    const double half = 0.7071067811865475;
    motif.points = {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
    end_ring(motif);
    end_polygon(motif);
    return motif;
}

Motif dash_motif(double width, int corners) {
    const double half = std::clamp(width, 0.01, 0.99);
    return stroke_motif({{half - 1, 0}, {1 - half, 0}}, half, std::max(corners / 2, 2));
}

Motif curve_motif(double width, int corners) {
    std::vector<Vec> line;
    for (int i = -6; i <= 6; ++i) {
        const double u = i / 6.0;
        line.push_back({u, 0.45 * u * (1 - u * u)});
    }
    return stroke_motif(line, std::clamp(width, 0.01, 0.5), std::max(corners / 2, 2));
}

Motif ring_motif(double width, int corners) {
    Motif motif;
    motif.is_round = true;
    add_circle(motif, 1, corners);
    end_ring(motif);
    add_circle(motif, 1 - 2 * std::clamp(width, 0.005, 0.45), corners);
    std::reverse(motif.points.begin() + corners, motif.points.end());
    end_ring(motif);
    end_polygon(motif);
    return motif;
}

Motif drawn_motif(const std::vector<Polyline>& outlines, FillRule rule, double tolerance) {
    std::vector<Vec> all;
    for (const Polyline& outline : outlines) all.insert(all.end(), outline.points.begin(), outline.points.end());
    if (all.empty()) return {};
    // What is filled may be smaller than what is drawn: the circle is taken around the cleaned outlines.
    Circle around = enclosing_circle(all);
    Polygons filled;
    for (int pass = 0; pass < 2; ++pass) {
        const double radius = std::sqrt(around.radius2);
        if (!(radius > 0) || !is_on_plane(around.centre) || !(radius < 0x1p31)) return {};
        std::vector<Polyline> scaled;
        for (const Polyline& outline : outlines) {
            Polyline copy{{}, true};
            for (const Vec p : outline.points) copy.points.push_back((p - around.centre) * (drawing_radius / radius));
            scaled.push_back(simplified(copy, tolerance * drawing_radius));
        }
        filled = clean(scaled, rule);
        if (filled.empty()) return {};
        std::vector<Vec> corners;
        for (const Point p : filled.points) corners.push_back(to_px(p));
        const Circle found = enclosing_circle(corners);
        if (std::sqrt(found.radius2) > drawing_radius * (1 - 1e-6)) break;
        around = {around.centre + found.centre * (radius / drawing_radius),
                  found.radius2 * around.radius2 / (drawing_radius * drawing_radius)};
    }
    Motif motif;
    motif.is_frail = comes_near_itself(filled, frail * drawing_radius);
    for (const Point p : filled.points) motif.points.push_back(to_px(p) * (1 / drawing_radius));
    motif.ring_ends = filled.ring_ends;
    motif.polygon_ends = filled.polygon_ends;
    double farthest = 1;
    for (const Vec p : motif.points) farthest = std::max(farthest, length(p));
    for (Vec& p : motif.points) p = p * (1 / farthest);
    return motif;
}

void append(Polygons& polygons, const Motif& motif, const Pose& pose) {
    const Vec along = pose.direction * pose.radius, aside = perpendicular(along);
    const auto placed = [&](Vec p) { return snap(pose.at + along * p.x + aside * p.y); };
    if (motif.is_frail || pose.radius < 0x1p-8) {
        std::vector<std::vector<Point>> rings;
        std::uint32_t first = 0;
        for (const std::uint32_t end : motif.ring_ends) {
            std::vector<Point>& ring = rings.emplace_back();
            for (std::uint32_t i = first; i < end; ++i) ring.push_back(placed(motif.points[i]));
            first = end;
        }
        polygons.add_all(clean(rings, FillRule::nonzero));
        return;
    }
    const auto first_point = polygons.points.size();
    const auto first_ring = polygons.ring_ends.size();
    for (const Vec p : motif.points) polygons.points.push_back(placed(p));
    for (const std::uint32_t end : motif.ring_ends) {
        polygons.ring_ends.push_back(static_cast<std::uint32_t>(first_point + end));
    }
    for (const std::uint32_t end : motif.polygon_ends) {
        polygons.polygon_ends.push_back(static_cast<std::uint32_t>(first_ring + end));
    }
}

}  // namespace filigree
