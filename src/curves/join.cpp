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

// An element that lies on a Bezier between two of its parameters.
struct Member {
    const Element& element;
    double u = 0, v = 1;  // where its first control point lies, and its last
};

// The least squares of what is left between members' control points and those of the Bezier's pieces there, over the
// Bezier's inner control points; its ends stay. Nothing is done where all is as good as exact.
void fit_bezier(Element& e, std::array<Member, 2> members, double tolerance) {
    const int degree = e.kind == ElementKind::parabola ? 2 : 3;
    double most = 0, aa = 0, ab = 0, bb = 0;
    Vec ar, br;
    for (const Member& member : members) {
        for (int k = 0; k <= degree; ++k) {
            const std::array<double, 4> share = shares(degree, k, member.u, member.v);
            Vec rest = member.element.at[static_cast<std::size_t>(k)];
            for (std::size_t j = 0; j <= static_cast<std::size_t>(degree); ++j) rest = rest - e.at[j] * share[j];
            most = std::max(most, length(rest));
            const double a = share[1], b = degree == 3 ? share[2] : 0;
            aa += a * a;
            ab += a * b;
            bb += b * b;
            ar = ar + rest * a;
            br = br + rest * b;
        }
    }
    if (most <= as_good_as_exact * tolerance) return;
    if (degree == 2) {
        e.at[1] = e.at[1] + ar * (1 / aa);
        return;
    }
    const double size = aa * bb - ab * ab;
    if (!(size > 1e-12 * aa * bb)) return;
    e.at[1] = e.at[1] + (ar * bb - br * ab) * (1 / size);
    e.at[2] = e.at[2] + (br * aa - ar * ab) * (1 / size);
}

// Solves a symmetric positive system in place by elimination; false where it is singular.
using Row = std::array<double, 6>;
bool solve(std::array<Row, 5>& rows, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        if (!(rows[i][i] > 1e-12)) return false;
        for (std::size_t k = 0; k < count; ++k) {
            if (k == i) continue;
            const double by = rows[k][i] / rows[i][i];
            for (std::size_t j = 0; j < 6; ++j) rows[k][j] -= by * rows[i][j];
        }
    }
    for (std::size_t i = 0; i < count; ++i) rows[i][5] /= rows[i][i];
    return true;
}

// The ellipse, of a circle the circle, that comes nearest to two arcs which lie along one to within little: in the
// coordinates where it is the unit circle, what they are off is a constant and one wave (a shift), and of ellipses two
// waves.
Element fitted_ellipse(const Element& arc, const Element& other) {
    const std::size_t unknowns = is_circular(arc) ? 3 : 5;
    std::array<Row, 5> rows{};
    const double total = rough_length(arc) + rough_length(other);
    for (const Element* e : {&arc, &other}) {
        constexpr int parts = 32;
        const double share = rough_length(*e) / total;
        for (int i = 0; i <= parts; ++i) {
            const Vec off = point_at(*e, e->from + (e->to - e->from) * i / parts) - arc.at[0];
            const double x = dot(off, arc.at[1]) / dot(arc.at[1], arc.at[1]);
            const double y = dot(off, arc.at[2]) / dot(arc.at[2], arc.at[2]);
            const double radius = std::sqrt(x * x + y * y), cosine = x / radius, sine = y / radius;
            const Row wave = {1, cosine, sine, cosine * cosine - sine * sine, 2 * cosine * sine, radius - 1};
            for (std::size_t a = 0; a < unknowns; ++a) {
                for (std::size_t b = 0; b < unknowns; ++b) rows[a][b] += share * wave[a] * wave[b];
                rows[a][5] += share * wave[a] * wave[5];
            }
        }
    }
    // A short arc tells little of some of these: what it does not tell stays.
    for (std::size_t i = 0; i < unknowns; ++i) rows[i][i] += 1e-6 * rows[0][0];
    if (!solve(rows, unknowns)) return arc;
    const double grown = 1 + rows[0][5], stretched = rows[3][5], sheared = rows[4][5];
    Element fitted = arc;
    fitted.at[0] = arc.at[0] + arc.at[1] * rows[1][5] + arc.at[2] * rows[2][5];
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
        fit_bezier(whole, {own, added}, tolerance);
    }
    return own_form(whole, tolerance);
}

}  // namespace filigree::curves
