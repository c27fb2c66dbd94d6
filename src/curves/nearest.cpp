#include "curves/nearest.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/elementary.h"

namespace filigree::curves {
namespace {

constexpr double turn = 2 * elementary::pi;

Foot foot_at(const Element& e, Vec p, double t) { return {t, length(point_at(e, t) - p)}; }
const Foot& nearer(const Foot& a, const Foot& b) { return b.distance < a.distance ? b : a; }

Foot foot_on_circle(const Element& e, Vec p) {
    const Vec off = p - e.at[0];
    const double angle = elementary::atan2(off.y, off.x);
    // The angle as one at or behind the arc's start.
    const double t = angle + turn * std::ceil((e.from - angle) / turn);
    if (t <= e.to) return {t, std::fabs(length(off) - length(e.at[1]))};
    return nearer(foot_at(e, p, e.from), foot_at(e, p, e.to));
}

// Newton's iteration on the distance, kept between two parameters; shorter steps where one does not come nearer.
Foot descended(const Element& e, Vec p, double t, double low, double high) {
    Foot best = foot_at(e, p, t);
    const double difference = 1e-4 * (high - low);
    double share = 1;
    for (int round = 0; round < 24 && share > 1e-3; ++round) {
        const Vec off = point_at(e, best.t) - p, way = velocity_at(e, best.t);
        const Vec bend =
            (velocity_at(e, best.t + difference) - velocity_at(e, best.t - difference)) * (0.5 / difference);
        const double speed = dot(way, way), curve = speed + dot(off, bend);
        if (!(speed > 0)) break;
        const double step = dot(off, way) / (curve > 0.02 * speed ? curve : speed);
        const Foot next = foot_at(e, p, std::clamp(best.t - share * step, low, high));
        if (next.t == best.t) break;
        if (next.distance < best.distance) {
            best = next;
        } else {
            share *= 0.25;
        }
    }
    return best;
}

}  // namespace

Foot foot_on(const Element& e, Vec p) {
    if (e.kind == ElementKind::point) return {0, length(e.at[0] - p)};
    if (e.kind == ElementKind::line) {
        const Vec way = e.at[1] - e.at[0];
        return foot_at(e, p, std::clamp(dot(p - e.at[0], way) / dot(way, way), 0.0, 1.0));
    }
    if (e.kind == ElementKind::arc && is_circular(e)) return foot_on_circle(e, p);
    constexpr std::size_t parts = 16;
    const Interval on = interval_of(e);
    std::array<double, parts + 1> distance;
    const auto place = [&on](std::size_t i) { return on.from + (on.to - on.from) * (static_cast<double>(i) / parts); };
    for (std::size_t i = 0; i <= parts; ++i) distance[i] = length(point_at(e, place(i)) - p);
    const double least = *std::min_element(distance.begin(), distance.end());
    const double spacing = rough_length(e) / parts;
    Foot best{on.from, distance[0]};
    for (std::size_t i = 0; i <= parts; ++i) {
        const std::size_t before = i == 0 ? 0 : i - 1, behind = std::min(i + 1, parts);
        // A minimum between two samples is less than what the curve can win over half their distance.
        if (distance[i] > distance[before] || distance[i] > distance[behind] || distance[i] > least + 2 * spacing) {
            continue;
        }
        best = nearer(best, descended(e, p, place(i), place(before), place(behind)));
    }
    return best;
}

double farthest_of(const Element& part, int count, const Element& from) {
    const Interval on = interval_of(part);
    double most = 0;
    for (int i = 0; i < count; ++i) {
        const double f = static_cast<double>(i) / (count - 1);
        most = std::max(most, foot_on(from, point_at(part, on.from * (1 - f) + on.to * f)).distance);
    }
    return most;
}

}  // namespace filigree::curves
