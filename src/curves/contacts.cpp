#include "curves/contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace filigree::curves {
namespace {

Vec unit_of(Vec v) { return v * (1 / length(v)); }

// An element's interval, longer by about a reach at both ends; a whole ellipse keeps its own.
Interval reaching(const Element& e, double reach) {
    Interval on = interval_of(e);
    if (is_closed(e)) return on;
    const double width = on.to - on.from;
    const auto slack = [&](double t) {
        const double speed = length(velocity_at(e, t));
        return speed * width > 4 * reach ? reach / speed : 0.25 * width;
    };
    const double before = slack(on.from), behind = slack(on.to);
    return {on.from - before, on.to + behind};
}

struct Meeting {
    double s = 0, t = 0;
    bool is_tangential = false;
};

bool is_far(double t, Interval on) { return std::fabs(t - 0.5 * (on.from + on.to)) > 1.5 * (on.to - on.from); }

// Newton's iteration towards where two descriptors meet, from the middles of a piece of each and not far beyond them.
std::optional<Meeting> meeting_near(const Element& a, Interval on_a, const Element& b, Interval on_b) {
    Meeting at{0.5 * (on_a.from + on_a.to), 0.5 * (on_b.from + on_b.to)};
    for (int round = 0; round < 12; ++round) {
        const Vec u = velocity_at(a, at.s), v = velocity_at(b, at.t), off = point_at(b, at.t) - point_at(a, at.s);
        const double turn = cross(u, v);
        if (!(std::fabs(turn) > 1e-4 * length(u) * length(v))) return std::nullopt;
        const double ds = cross(off, v) / turn, dt = cross(off, u) / turn;
        at.s += ds;
        at.t += dt;
        if (is_far(at.s, on_a) || is_far(at.t, on_b)) return std::nullopt;
        if (std::fabs(ds) <= 1e-12 && std::fabs(dt) <= 1e-12) return at;
    }
    return std::nullopt;
}

// The change of the velocity; exact but for arcs.
Vec bend_at(const Element& e, double t) {
    constexpr double step = 1e-4;
    return (velocity_at(e, t + step) - velocity_at(e, t - step)) * (0.5 / step);
}

// The same towards where they run in one direction side by side. Where one bends as the other that is nowhere.
std::optional<Meeting> touch_near(const Element& a, Interval on_a, const Element& b, Interval on_b, double reach) {
    Meeting at{0.5 * (on_a.from + on_a.to), 0.5 * (on_b.from + on_b.to), true};
    for (int round = 0; round < 12; ++round) {
        const Vec u = velocity_at(a, at.s), v = velocity_at(b, at.t), off = point_at(b, at.t) - point_at(a, at.s);
        const Vec bend_a = bend_at(a, at.s), bend_b = bend_at(b, at.t);
        const double turn = cross(u, v), lag = dot(off, u);
        const double turn_s = cross(bend_a, v), turn_t = cross(u, bend_b), lag_s = dot(off, bend_a) - dot(u, u);
        const double lag_t = dot(u, v), size = turn_s * lag_t - turn_t * lag_s;
        constexpr double alike = 1e-3;  // how much of their speeds' product the bends differ by
        if (!(std::fabs(size) > alike * dot(u, u) * dot(v, v))) return std::nullopt;
        const double ds = -(turn * lag_t - turn_t * lag) / size, dt = -(turn_s * lag - turn * lag_s) / size;
        at.s += ds;
        at.t += dt;
        if (is_far(at.s, on_a) || is_far(at.t, on_b)) return std::nullopt;
        if (std::fabs(ds) <= 1e-11 && std::fabs(dt) <= 1e-11) {
            if (length(off) <= reach) return at;
            return std::nullopt;
        }
    }
    return std::nullopt;
}

double curvature_at(const Element& e, double t) {
    const Vec way = velocity_at(e, t);
    const double speed = length(way);
    return cross(way, bend_at(e, t)) / (speed * speed * speed);
}

// The same towards where they bend alike. There they may cross without an angle: where the tangents agree would then be
// known badly.
std::optional<Meeting> osculation_near(const Element& a, Interval on_a, const Element& b, Interval on_b, double reach) {
    Meeting at{0.5 * (on_a.from + on_a.to), 0.5 * (on_b.from + on_b.to), true};
    const double sign = dot(velocity_at(a, at.s), velocity_at(b, at.t)) < 0 ? -1 : 1;
    constexpr double step = 1e-5;
    for (int round = 0; round < 12; ++round) {
        const Vec u = velocity_at(a, at.s), v = velocity_at(b, at.t), off = point_at(b, at.t) - point_at(a, at.s);
        const double bends_more = curvature_at(a, at.s) - sign * curvature_at(b, at.t), lag = dot(off, u);
        const double more_s = (curvature_at(a, at.s + step) - curvature_at(a, at.s - step)) * (0.5 / step);
        const double more_t = sign * (curvature_at(b, at.t - step) - curvature_at(b, at.t + step)) * (0.5 / step);
        const double lag_s = dot(off, bend_at(a, at.s)) - dot(u, u), lag_t = dot(u, v);
        const double size = more_s * lag_t - more_t * lag_s;
        // How much sooner than in their own lengths the curvatures part.
        constexpr double alike = 1e-2;
        const double bend = std::fabs(curvature_at(a, at.s));
        if (!(std::fabs(size) > alike * bend * bend * dot(u, u) * length(v))) return std::nullopt;
        const double ds = -(bends_more * lag_t - more_t * lag) / size;
        const double dt = -(more_s * lag - bends_more * lag_s) / size;
        at.s += ds;
        at.t += dt;
        if (is_far(at.s, on_a) || is_far(at.t, on_b)) return std::nullopt;
        if (std::fabs(ds) > 1e-9 || std::fabs(dt) > 1e-9) continue;
        const bool is_parallel = std::fabs(cross(u, v)) <= 2e-4 * length(u) * length(v);
        if (length(off) <= reach && is_parallel) return at;
        return std::nullopt;
    }
    return std::nullopt;
}

Bounds box_of(const Element& e, double from, double to, double reach) {
    Bounds box = bounds_of(piece_of(e, {from, to}));
    box.min = box.min - Vec{reach, reach};
    box.max = box.max + Vec{reach, reach};
    return box;
}

double sine_between(Vec u, Vec v) { return dot(u, v) > 0 ? std::fabs(cross(u, v)) / (length(u) * length(v)) : 1; }

// How far a piece turns away from its direction in the middle, as a sine; 1 where its speed changes much.
double turn_of(const Element& e, Interval on) {
    if (e.kind == ElementKind::line) return 0;
    const Vec u = velocity_at(e, on.from), v = velocity_at(e, 0.5 * (on.from + on.to)), w = velocity_at(e, on.to);
    const double uu = dot(u, u), vv = dot(v, v), ww = dot(w, w);
    if (!(uu < 4 * vv && vv < 4 * uu && ww < 4 * vv && vv < 4 * ww)) return 1;
    return std::max(sine_between(u, v), sine_between(v, w));
}

std::array<Interval, 2> halves_of(Interval on) {
    const double middle = 0.5 * (on.from + on.to);
    return {Interval{on.from, middle}, Interval{middle, on.to}};
}

// Where pieces of two elements meet; some several times.
void find_meetings(const Element& a, Interval on_a, const Element& b, Interval on_b, double reach, double least_sine,
                   int depth, std::vector<Meeting>& meetings) {
    if (!do_overlap(box_of(a, on_a.from, on_a.to, reach), box_of(b, on_b.from, on_b.to, reach))) return;
    const Vec way_a = velocity_at(a, 0.5 * (on_a.from + on_a.to)), way_b = velocity_at(b, 0.5 * (on_b.from + on_b.to));
    const double between = std::fabs(cross(way_a, way_b)) / (length(way_a) * length(way_b));
    const double turns = turn_of(a, on_a) + turn_of(b, on_b);
    // Pieces that turn by less than the angle between them meet once at most.
    if (between > 1.5 * turns || depth == 0) {
        const auto at = meeting_near(a, on_a, b, on_b);
        if (at) meetings.push_back(*at);
        if (turns == 0 || (at && depth > 0)) return;
    }
    if (depth == 0 || turns + between < 0.9 * least_sine) {
        if (const auto at = touch_near(a, on_a, b, on_b, reach)) meetings.push_back(*at);
        if (const auto at = osculation_near(a, on_a, b, on_b, reach)) meetings.push_back(*at);
        return;
    }
    for (const Interval& part_a : halves_of(on_a)) {
        for (const Interval& part_b : halves_of(on_b)) {
            find_meetings(a, part_a, b, part_b, reach, least_sine, depth - 1, meetings);
        }
    }
}

// Whether a parameter is the element's, or its point is within a reach of an end.
bool is_reached(const Element& e, double t, double reach) {
    const Interval on = interval_of(e);
    if (t >= on.from && t <= on.to) return true;
    // The arithmetic's own error must not hide what touches exactly at the reach's end.
    return length(point_at(e, t) - point_at(e, t < on.from ? on.from : on.to)) <= reach * (1 + 1e-9);
}

}  // namespace

std::vector<Contact> contacts_of(const Element& e, const Element& other, double reach, double least_sine) {
    std::vector<Contact> contacts;
    if (e.kind == ElementKind::point || other.kind == ElementKind::point) return contacts;
    const Bounds box = bounds_of(e), other_box = bounds_of(other);
    const Vec margin{2 * reach, 2 * reach};
    if (!do_overlap({box.min - margin, box.max + margin}, other_box)) return contacts;
    std::vector<Meeting> meetings;
    constexpr int most_halvings = 9;
    find_meetings(e, reaching(e, reach), other, reaching(other, reach), reach, least_sine, most_halvings, meetings);
    std::erase_if(meetings,
                  [&](const Meeting& at) { return !is_reached(e, at.s, reach) || !is_reached(other, at.t, reach); });
    std::sort(meetings.begin(), meetings.end(),
              [](const Meeting& a, const Meeting& b) { return std::pair(a.s, a.t) < std::pair(b.s, b.t); });
    for (const Meeting& at : meetings) {
        const Vec place = point_at(e, at.s), way = velocity_at(e, at.s), other_way = velocity_at(other, at.t);
        const bool is_crossing = std::fabs(cross(way, other_way)) > least_sine * length(way) * length(other_way);
        if (is_crossing == at.is_tangential) continue;
        const double apart = (at.is_tangential ? 1e-6 : 1e-9) * (length(way) + length(other_way));
        const auto is_same = [&](const Contact& known) { return length(known.at - place) <= apart; };
        if (std::any_of(contacts.begin(), contacts.end(), is_same)) continue;
        contacts.push_back({place, unit_of(way), unit_of(other_way), other.kind, at.is_tangential});
    }
    return contacts;
}

}  // namespace filigree::curves
