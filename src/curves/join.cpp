#include "curves/join.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "curves/along.h"

namespace filigree::curves {
namespace {

void set_ends(Element& e, Vec first, Vec last) {
    e.at[0] = first;
    e.at[e.kind == ElementKind::line ? 1 : e.kind == ElementKind::parabola ? 2 : 3] = last;
}

// How much of each control point of a Bezier makes the k-th control point of its piece between two parameters: the
// products of 1 - t and t over the parameters, of which k are v and the others u.
std::array<double, 4> shares(int degree, int k, double u, double v) {
    std::array<double, 4> share = {1, 0, 0, 0};
    for (int i = 0; i < degree; ++i) {
        const double t = i < degree - k ? u : v;
        for (int j = 3; j >= 0; --j) {
            const auto at = static_cast<std::size_t>(j);
            share[at] = share[at] * (1 - t) + (j > 0 ? share[at - 1] * t : 0);
        }
    }
    return share;
}

// Solves a symmetric positive system by elimination; the last column is the right side, and then the solution. False
// where it is singular.
constexpr std::size_t most_unknowns = 6;
using Row = std::array<double, most_unknowns + 1>;
using System = std::array<Row, most_unknowns>;
bool solve(System& rows, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        if (!(rows[i][i] > 0)) return false;
        for (std::size_t k = 0; k < count; ++k) {
            if (k == i) continue;
            const double by = rows[k][i] / rows[i][i];
            for (std::size_t j = 0; j <= most_unknowns; ++j) rows[k][j] -= by * rows[i][j];
        }
    }
    for (std::size_t i = 0; i < count; ++i) rows[i][most_unknowns] /= rows[i][i];
    return true;
}

// Adds an equation, its left side and then its right, to a system of least squares.
void add_equation(System& rows, std::size_t count, const Row& equation, double share) {
    for (std::size_t a = 0; a < count; ++a) {
        for (std::size_t b = 0; b < count; ++b) rows[a][b] += share * equation[a] * equation[b];
        rows[a][most_unknowns] += share * equation[a] * equation[most_unknowns];
    }
}

// An element that lies on a Bezier between two of its parameters.
struct Member {
    const Element& element;
    double u = 0, v = 1;  // where its first control point lies, and its last
};
using Members = std::array<Member, 2>;

Vec blossom(const Element& e, int degree, const std::array<double, 4>& share) {
    Vec sum;
    for (std::size_t j = 0; j <= static_cast<std::size_t>(degree); ++j) sum = sum + e.at[j] * share[j];
    return sum;
}

// How far members' control points lie from those of the Bezier's pieces there.
double off_members(const Element& e, const Members& members) {
    const int degree = e.kind == ElementKind::parabola ? 2 : 3;
    double most = 0;
    for (const Member& member : members) {
        for (int k = 0; k <= degree; ++k) {
            const Vec there = blossom(e, degree, shares(degree, k, member.u, member.v));
            most = std::max(most, length(member.element.at[static_cast<std::size_t>(k)] - there));
        }
    }
    return most;
}

// The Bezier between the same ends that fits two members best: least squares over its inner control points and over
// where the members' ends lie that are not its own; a step of Newton's towards them. Else what tells the descriptor
// would be one member alone, and errors would grow with each that is added.
void fit_bezier_once(Element& e, Members& members) {
    const int degree = e.kind == ElementKind::parabola ? 2 : 3;
    const std::size_t inner = static_cast<std::size_t>(degree) - 1;
    std::array<double*, 4> free{};
    std::size_t unknowns = 2 * inner;
    for (Member& member : members) {
        for (double* t : {&member.u, &member.v}) {
            if (*t > 0 && *t < 1 && unknowns < most_unknowns) free[unknowns++ - 2 * inner] = t;
        }
    }
    System rows{};
    for (const Member& member : members) {
        for (int k = 0; k <= degree; ++k) {
            const std::array<double, 4> share = shares(degree, k, member.u, member.v);
            const Vec rest = member.element.at[static_cast<std::size_t>(k)] - blossom(e, degree, share);
            Row by_x{}, by_y{};
            for (std::size_t j = 0; j < inner; ++j) by_x[2 * j] = by_y[2 * j + 1] = share[j + 1];
            for (std::size_t n = 2 * inner; n < unknowns; ++n) {
                const double* const t = free[n - 2 * inner];
                if (t != &member.u && t != &member.v) continue;
                constexpr double step = 1e-3;
                const double u = t == &member.u ? step : 0, v = t == &member.v ? step : 0;
                const Vec way = (blossom(e, degree, shares(degree, k, member.u + u, member.v + v)) -
                                 blossom(e, degree, shares(degree, k, member.u - u, member.v - v))) *
                                (0.5 / step);
                by_x[n] = way.x;
                by_y[n] = way.y;
            }
            by_x[most_unknowns] = rest.x;
            by_y[most_unknowns] = rest.y;
            add_equation(rows, unknowns, by_x, 1);
            add_equation(rows, unknowns, by_y, 1);
        }
    }
    for (std::size_t i = 0; i < unknowns; ++i) rows[i][i] *= 1 + 1e-12;
    if (!solve(rows, unknowns)) return;
    for (std::size_t j = 0; j < inner; ++j) {
        e.at[j + 1] = e.at[j + 1] + Vec{rows[2 * j][most_unknowns], rows[2 * j + 1][most_unknowns]};
    }
    for (std::size_t n = 2 * inner; n < unknowns; ++n) *free[n - 2 * inner] += rows[n][most_unknowns];
}

// What is off by rounding alone stays, so that exact curves do.
void fit_bezier(Element& e, Members members) {
    double farthest = 0;
    for (const Vec p : e.at) farthest = std::max(farthest, length(p));
    for (int round = 0; round < 2; ++round) {
        const double before = off_members(e, members);
        if (before <= 1e-15 * farthest) return;
        Element fitted = e;
        fit_bezier_once(fitted, members);
        if (!(off_members(fitted, members) < before)) return;
        e = fitted;
    }
}

// The ellipse, of a circle the circle, that comes nearest to two arcs which lie along one to within little: in the
// coordinates where it is the unit circle, what they are off is a constant and one wave (a shift), and of ellipses two
// waves.
Element fitted_ellipse(const Element& arc, const Element& other) {
    const std::size_t unknowns = is_circular(arc) ? 3 : 5;
    System rows{};
    const double total = rough_length(arc) + rough_length(other);
    for (const Element* e : {&arc, &other}) {
        constexpr int parts = 32;
        const double share = rough_length(*e) / total;
        for (int i = 0; i <= parts; ++i) {
            const Vec off = point_at(*e, e->from + (e->to - e->from) * i / parts) - arc.at[0];
            const double x = dot(off, arc.at[1]) / dot(arc.at[1], arc.at[1]);
            const double y = dot(off, arc.at[2]) / dot(arc.at[2], arc.at[2]);
            const double radius = std::sqrt(x * x + y * y), cosine = x / radius, sine = y / radius;
            const Row wave = {1, cosine, sine, cosine * cosine - sine * sine, 2 * cosine * sine, 0, radius - 1};
            add_equation(rows, unknowns, wave, share);
        }
    }
    // A short arc tells little of some of these: what it does not tell stays.
    for (std::size_t i = 0; i < unknowns; ++i) rows[i][i] += 1e-6 * rows[0][0];
    if (!solve(rows, unknowns)) return arc;
    const auto found = [&](std::size_t i) { return i < unknowns ? rows[i][most_unknowns] : 0; };
    const double grown = 1 + found(0), stretched = found(3), sheared = found(4);
    Element fitted = arc;
    fitted.at[0] = arc.at[0] + arc.at[1] * found(1) + arc.at[2] * found(2);
    fitted.at[1] = arc.at[1] * (grown + stretched) + arc.at[2] * sheared;
    fitted.at[2] = arc.at[1] * sheared + arc.at[2] * (grown - stretched);
    return fitted;
}

Element extended_arc(const Element& e, const Stretch& together, const Element& other, double tolerance) {
    const auto made = [&](const Element& on, Interval between) {
        Element arc = arc_element(on.at[0], on.at[1], on.at[2], between.from, between.to);
        arc.layer = e.layer;
        arc.weight = e.weight;
        return arc;
    };
    const auto lies = along(e, other, tolerance);
    if (!lies || lies->distance <= as_good_as_exact * tolerance) return made(e, together.on);
    // Its angles go by the ends again, since its axes turn where it is nearly round.
    const Element fitted = fitted_ellipse(e, other);
    const Element whole = made(fitted, {0, 7});
    const Vec before = point_at(e, together.on.from), after = point_at(e, together.on.to);
    const double from = parameter_near(whole, before, 0);
    const double to = parameter_near(whole, after, from + (together.on.to - together.on.from));
    return made(whole, {from, to});
}

}  // namespace

std::optional<Element> piece_between(const Element& e, const Stretch& stretch, double tolerance) {
    Element piece = piece_of(e, stretch.on);
    if (e.kind != ElementKind::arc) {
        const auto exact = [&](Vec wanted, Vec there) {
            return length(wanted - there) <= as_good_as_exact * tolerance ? wanted : there;
        };
        const auto [first, last] = ends_of(piece);
        set_ends(piece, exact(stretch.first, first), exact(stretch.last, last));
    }
    return own_form(piece, tolerance);
}

std::optional<Element> extended(const Element& e, const Stretch& together, const Element& other, const Stretch& on,
                                double tolerance) {
    if (e.kind == ElementKind::arc) return own_form(extended_arc(e, together, other, tolerance), tolerance);
    Element whole = piece_of(e, together.on);
    set_ends(whole, together.first, together.last);
    if (e.kind != ElementKind::line) {
        const double size = together.on.to - together.on.from;
        const auto place = [&](double t) { return (t - together.on.from) / size; };
        const bool is_reversed = ends_of(other).first != on.first;
        const Member own{e, place(interval_of(e).from), place(interval_of(e).to)};
        const Member added{other, place(is_reversed ? on.on.to : on.on.from),
                           place(is_reversed ? on.on.from : on.on.to)};
        fit_bezier(whole, {own, added});
    }
    return own_form(whole, tolerance);
}

}  // namespace filigree::curves
