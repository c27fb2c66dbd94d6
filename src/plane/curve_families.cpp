#include "plane/curve_families.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/elementary.h"
#include "plane/curve_cut.h"
#include "plane/edge_tree.h"
#include "plane/inner_point.h"
#include "plane/transform.h"

namespace filigree {
namespace {

constexpr double most_points = 0x1p22;

double degrees_of(Vec v) { return elementary::atan2(v.y, v.x) * (180 / elementary::pi); }

// An angle as one in [0, 360).
double wrapped(double degrees) {
    const double turns = std::floor(degrees / 360);
    const double rest = degrees - 360 * turns;
    return rest >= 360 ? 0 : rest;
}

// A chord of a circle lies r (1 - cos(half its angle)) inside: about pi^2 r / (2 n^2) for n corners.
double corners_of_circle(double radius, double tolerance) {
    const double wanted = std::ceil(elementary::pi * std::sqrt(radius / (2 * tolerance)) / 4) * 4;
    return std::clamp(wanted, 24.0, 4096.0);
}

bool add_curves(std::vector<Polyline>& curves, const Circles& circles, PolygonView) {
    double points = 0;
    for (const double radius : circles.radii) points += corners_of_circle(radius, circles.tolerance);
    if (!(points <= most_points)) return false;
    for (const double radius : circles.radii) {
        Polyline& circle = curves.emplace_back();
        circle.closed = true;
        const double count = corners_of_circle(radius, circles.tolerance);
        for (double i = 0; i < count; ++i)
            circle.points.push_back(circles.centre + radius * unit_at_degrees(360 * i / count));
    }
    return true;
}

bool add_curves(std::vector<Polyline>& curves, const Rays& rays, PolygonView shape) {
    const LevelRange reach = distance_range(shape, rays.centre);
    if (rays.curl == 0) {
        const double end = reach.high + 1;
        for (const double degrees : rays.degrees) {
            const Vec way = unit_at_degrees(degrees);
            curves.push_back({{rays.centre + rays.from * way, rays.centre + end * way}, false});
        }
        return true;
    }
    // Where they are sampled depends on the rays alone. A step of t radians about the centre at distance r leaves the
    // chord by about r t^2 / 8; near the centre the curve bends as a circle of half the length of a radian.
    const double radians = std::fabs(rays.curl) * (elementary::pi / 180);  // a px
    std::vector<double> distances;
    double last = rays.from;
    const double count = static_cast<double>(rays.degrees.size());
    for (double at = rays.from;;
         at += std::min(std::sqrt(8 * rays.tolerance / std::max(at, 0.5 / radians)), 0.5) / radians) {
        if (at < reach.low) {
            last = at;
            continue;
        }
        if (distances.empty()) distances.push_back(last);
        if (at > last) distances.push_back(at);
        last = at;
        if (at > reach.high) break;
        if (static_cast<double>(distances.size()) * count > most_points) return false;
    }
    for (const double degrees : rays.degrees) {
        Polyline& ray = curves.emplace_back();
        for (const double r : distances)
            ray.points.push_back(rays.centre + r * unit_at_degrees(degrees + rays.curl * r));
    }
    return true;
}

struct FrameBox {
    Vec low, high;
};
FrameBox frame_box(PolygonView shape, const Frame& frame) {
    constexpr double inf = std::numeric_limits<double>::infinity();
    FrameBox box{{inf, inf}, {-inf, -inf}};
    for (const Point p : shape.outer()) {
        const Vec at = to_frame(frame, to_px(p));
        box = {{std::min(box.low.x, at.x), std::min(box.low.y, at.y)},
               {std::max(box.high.x, at.x), std::max(box.high.y, at.y)}};
    }
    return box;
}

bool add_curves(std::vector<Polyline>& curves, const Copies& copies, PolygonView shape) {
    const DrawnCurve& curve = copies.curve;
    const FrameBox box = frame_box(shape, copies.frame);
    const double first = std::floor((box.low.x - curve.right) / curve.period);
    const double last = std::ceil((box.high.x - curve.left) / curve.period);
    double points = 0;
    for (const Polyline& line : curve.lines) points += static_cast<double>(line.points.size());
    points *= (last - first + 1) * static_cast<double>(copies.levels.size());
    if (!(points <= most_points)) return false;
    for (const double level : copies.levels) {
        if (level + curve.high < box.low.y || level + curve.low > box.high.y) continue;
        for (double k = first; k <= last; ++k) {
            for (const Polyline& line : curve.lines) {
                Polyline& copy = curves.emplace_back();
                copy.closed = line.closed;
                for (const Vec p : line.points) {
                    copy.points.push_back(from_frame(copies.frame, {p.x + k * curve.period, p.y + level}));
                }
                // One starts where the other ends, to the last bit.
                if (curve.goes_on) {
                    copy.points.front() = from_frame(copies.frame, {k * curve.period, level});
                    copy.points.back() = from_frame(copies.frame, {(k + 1) * curve.period, level});
                }
            }
        }
    }
    return true;
}

std::int32_t level_of(const std::vector<double>& levels, double at) {
    return static_cast<std::int32_t>(std::upper_bound(levels.begin(), levels.end(), at) - levels.begin());
}

std::int32_t strip_of(const Circles& circles, PolygonView, Vec p) {
    return circles.first_ring + level_of(circles.radii, length(p - circles.centre));
}

// The sector, and for curls that wind more than once around also the turn, by where the piece comes nearest to the
// centre: turns differ by the number of rays.
std::int32_t strip_of(const Rays& rays, PolygonView piece, Vec p) {
    if (rays.degrees.empty()) return 0;
    const double r = length(p - rays.centre);
    const double angle = wrapped(degrees_of(p - rays.centre) - rays.curl * r - rays.degrees[0]);
    std::int32_t sector = 0;
    const auto count = static_cast<std::int32_t>(rays.degrees.size());
    while (sector + 1 < count && rays.degrees[static_cast<std::size_t>(sector) + 1] - rays.degrees[0] <= angle)
        ++sector;
    if (rays.curl == 0) return sector;
    const double turn = std::floor(distance_range(piece, rays.centre).low * std::fabs(rays.curl) / 360);
    return sector + count * static_cast<std::int32_t>(std::min(turn, 1e6));
}

std::int32_t strip_of(const Copies& copies, PolygonView, Vec p) {
    const double middle = (copies.curve.low + copies.curve.high) / 2;
    return copies.first_strip + level_of(copies.levels, to_frame(copies.frame, p).y - middle);
}

}  // namespace

LevelRange distance_range(PolygonView shape, Vec from) {
    double least2 = std::numeric_limits<double>::infinity(), greatest2 = 0;
    for (std::size_t r = 0; r < shape.ring_count(); ++r) {
        const RingView ring = shape.ring(r);
        if (ring.empty()) continue;
        Vec a = to_px(ring.back());
        for (const Point p : ring) {
            const Vec b = to_px(p);
            const bool forward = a.x != b.x ? a.x < b.x : a.y < b.y;  // neighbours measure an edge alike
            least2 = std::min(least2, squared_distance(forward ? Edge{a, b} : Edge{b, a}, from));
            greatest2 = std::max(greatest2, dot(b - from, b - from));
            a = b;
        }
    }
    if (!(least2 <= greatest2)) return {};
    const bool is_inside = is_on_plane(from) && locate(shape, snap(from)) >= 0;
    return {is_inside ? 0 : std::sqrt(least2), std::sqrt(greatest2)};
}

std::optional<DrawnCurve> drawn_curve(std::span<const Polyline> lines) {
    DrawnCurve curve;
    for (const Polyline& line : lines) {
        if (line.points.size() < 2) continue;
        if (!std::all_of(line.points.begin(), line.points.end(), is_on_plane)) return std::nullopt;
        curve.lines.push_back(line);
    }
    if (curve.lines.empty()) return std::nullopt;
    Frame own{curve.lines[0].points.front(), {1, 0}};
    const Vec chord = curve.lines[0].points.back() - own.origin;
    const bool is_one = curve.lines.size() == 1 && !curve.lines[0].closed && length(chord) > 1e-6;
    if (is_one) own.direction = chord * (1 / length(chord));
    constexpr double inf = std::numeric_limits<double>::infinity();
    curve.low = curve.left = inf;
    curve.high = curve.right = -inf;
    for (Polyline& line : curve.lines) {
        for (Vec& p : line.points) {
            p = to_frame(own, p);
            curve.left = std::min(curve.left, p.x);
            curve.right = std::max(curve.right, p.x);
            curve.low = std::min(curve.low, p.y);
            curve.high = std::max(curve.high, p.y);
        }
    }
    curve.goes_on = is_one;
    curve.period = is_one ? length(chord) : curve.right - curve.left;
    if (!(curve.period > 1e-6)) return std::nullopt;
    return curve;
}

std::optional<Profile> profile_of(const DrawnCurve& curve, double tolerance) {
    constexpr double fewest = 16, most = 4096;
    if (curve.lines.size() != 1 || curve.lines[0].closed) return std::nullopt;
    const std::vector<Vec>& points = curve.lines[0].points;
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (!(points[i].x > points[i - 1].x)) return std::nullopt;
    }
    const auto height = [&, at = std::size_t{1}](double x) mutable {
        while (at + 1 < points.size() && points[at].x < x) ++at;
        const Vec a = points[at - 1], b = points[at];
        return a.y + (b.y - a.y) * std::clamp((x - a.x) / (b.x - a.x), 0.0, 1.0);
    };
    for (double count = fewest;; count *= 2) {
        Profile profile{curve.period / count, {}};
        auto sample = height;
        for (double i = 0; i < count; ++i) profile.samples.push_back(i == 0 ? 0 : sample(i * profile.step));
        // The drawn points must lie near the sampled curve.
        double worst = 0;
        for (const Vec p : points) {
            const double place = std::clamp(p.x / profile.step, 0.0, count);
            const double k = std::min(std::floor(place), count - 1);
            const double a = profile.samples[static_cast<std::size_t>(k)];
            const double b = k + 1 < count ? profile.samples[static_cast<std::size_t>(k) + 1] : 0;
            worst = std::max(worst, std::fabs(a + (place - k) * (b - a) - p.y));
        }
        if (worst <= tolerance) return profile;
        if (count >= most) return std::nullopt;  // too steep somewhere: better as it was drawn
    }
}

FamilyCut cut_by_families(PolygonView shape, const CurveFamily& first, const CurveFamily* second) {
    std::vector<Polyline> curves;
    const auto add = [&](const CurveFamily& family) {
        return std::visit([&](const auto& one) { return add_curves(curves, one, shape); }, family);
    };
    const bool fits = add(first) && (second == nullptr || add(*second));
    if (!fits) curves.clear();
    const Polygons pieces = cut_by_curves(shape, curves);
    struct Place {
        std::int32_t column = 0, row = 0;
        std::size_t piece = 0;
    };
    std::vector<Place> places(pieces.size());
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Vec inside = quick_inner_point(pieces[i]);
        const auto strip = [&](const CurveFamily& family) {
            return std::visit([&](const auto& one) { return strip_of(one, pieces[i], inside); }, family);
        };
        places[i] = {strip(first), second == nullptr ? 0 : strip(*second), i};
    }
    std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
        if (a.column != b.column) return a.column < b.column;
        return a.row != b.row ? a.row < b.row : a.piece < b.piece;
    });
    FamilyCut result;
    result.too_large = !fits;
    for (const Place& place : places) {
        result.pieces.add(pieces[place.piece]);
        result.columns.push_back(place.column);
        result.rows.push_back(place.row);
    }
    return result;
}

}  // namespace filigree
