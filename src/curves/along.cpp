#include "curves/along.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/elementary.h"

namespace filigree::curves {
namespace {

constexpr double turn = 2 * elementary::pi;

Vec leading(const Element& cubic) { return cubic.at[3] - cubic.at[0] + 3 * (cubic.at[1] - cubic.at[2]); }
Vec second(const Element& cubic) { return 3 * (cubic.at[0] - 2 * cubic.at[1] + cubic.at[2]); }

// Newton's iteration towards where a cubic's descriptor comes nearest to a point.
double nearest_on_cubic(const Element& cubic, Vec point, double t) {
    const Vec a = leading(cubic), b = second(cubic), c = 3 * (cubic.at[1] - cubic.at[0]);
    for (int round = 0; round < 20; ++round) {
        const Vec off = ((a * t + b) * t + c) * t + (cubic.at[0] - point);
        const Vec v = (3 * t * a + 2 * b) * t + c;
        const double speed = dot(v, v), bend = dot(off, 6 * t * a + 2 * b);
        if (!(speed > 0)) break;
        const double step = dot(off, v) / (bend > -0.5 * speed ? speed + bend : speed);
        t -= std::clamp(step, -0.25, 0.25);
        if (std::fabs(step) < 1e-15) break;
    }
    return t;
}

// The parameters where a cubic's descriptor comes nearest to a point, among those within `reach` of it.
struct Feet {
    std::array<double, 8> at{};
    std::size_t count = 0;
};
Feet feet_of(const Element& cubic, Vec point, double reach, std::optional<double> guess) {
    Feet feet;
    const auto take = [&](double t) {
        t = nearest_on_cubic(cubic, point, t);
        if (!(length(point_at(cubic, t) - point) <= reach) || feet.count == feet.at.size()) return;
        for (std::size_t i = 0; i < feet.count; ++i) {
            if (std::fabs(feet.at[i] - t) <= 1e-9) return;
        }
        feet.at[feet.count++] = t;
    };
    if (guess) take(*guess);
    // From about where the sampled distance has a minimum; a part that touches the carrier may lie a length beyond it.
    constexpr int samples = 72;
    constexpr double spacing = 3.0 / samples;
    const auto place = [](int i) { return -1 + spacing * i; };
    double distance[samples + 3];  // one more on each side
    for (int i = -1; i <= samples + 1; ++i) distance[i + 1] = length(point_at(cubic, place(i)) - point);
    for (int i = 0; i <= samples; ++i) {
        const double before = distance[i], here = distance[i + 1], after = distance[i + 2];
        if (before < here || after < here) continue;
        if (here > reach + 3 * spacing * length(velocity_at(cubic, place(i))) + (before + after - 2 * here)) continue;
        // Where the curve comes near to itself, two feet may lie between three samples.
        for (const double aside : {0.0, -0.5, 0.5}) take(place(i) + aside * spacing);
    }
    return feet;
}

// Where part(t) is carrier(rate t + start), by the two highest coefficients. Good where the part is not short.
std::optional<std::pair<double, double>> map_by_coefficients(const Element& carrier, const Element& part) {
    const Vec a = leading(carrier), b = leading(part);
    const double aa = dot(a, a);
    if (!(aa > 0)) return std::nullopt;
    const double rate = elementary::cbrt(dot(b, a) / aa);
    if (!(std::fabs(rate) > 0)) return std::nullopt;
    const Vec rest = second(part) * (1 / (rate * rate)) - second(carrier);
    const double start = dot(rest, a) / (3 * aa);
    return std::pair{rate, start};
}

std::optional<Along> along_cubic(const Element& carrier, const Element& part, double reach) {
    // The highest coefficient keeps its direction in every piece, and is off by eight times what control points are.
    const Vec a = leading(carrier);
    if (std::fabs(cross(a, leading(part))) > 8 * reach * length(a)) return std::nullopt;
    std::optional<double> first_guess, last_guess;
    if (const auto map = map_by_coefficients(carrier, part)) {
        first_guess = map->second;
        last_guess = map->first + map->second;
        if (const auto found = fitted_along(carrier, part, *first_guess, *last_guess, reach * 0x1p-6)) return found;
    }
    const Feet first = feet_of(carrier, part.at[0], reach, first_guess);
    if (first.count == 0) return std::nullopt;
    const Feet last = feet_of(carrier, part.at[3], reach, last_guess);
    std::optional<Along> best;
    for (std::size_t i = 0; i < first.count; ++i) {
        for (std::size_t j = 0; j < last.count; ++j) {
            const auto found = fitted_along(carrier, part, first.at[i], last.at[j], reach);
            if (found && (!best || found->distance < best->distance)) best = found;
        }
    }
    return best;
}

// A point in an ellipse's own coordinates, where it is the unit circle.
Vec inside_axes(const Element& arc, Vec p) {
    const Vec off = p - arc.at[0];
    return {dot(off, arc.at[1]) / dot(arc.at[1], arc.at[1]), dot(off, arc.at[2]) / dot(arc.at[2], arc.at[2])};
}

double angle_near(const Element& arc, Vec p) {
    const Vec own = inside_axes(arc, p);
    return elementary::atan2(own.y, own.x);
}

// To first order, which is enough near the curve.
double distance_to_ellipse(const Element& arc, Vec p) {
    if (is_circular(arc)) return std::fabs(length(p - arc.at[0]) - length(arc.at[1]));
    const Vec own = inside_axes(arc, p);
    const Vec slope =
        arc.at[1] * (2 * own.x / dot(arc.at[1], arc.at[1])) + arc.at[2] * (2 * own.y / dot(arc.at[2], arc.at[2]));
    return std::fabs(dot(own, own) - 1) / std::max(length(slope), 1e-300);
}

std::optional<Along> along_arc(const Element& carrier, const Element& part, double reach) {
    const double sweep = part.to - part.from;
    // What lies between two ellipses varies as a constant, one wave and two waves: enough points to see its most.
    const int parts = sweep < 1 ? 2 : sweep < elementary::pi ? 4 : 8;
    double most = 0;
    for (int i = 0; i <= parts; ++i) {
        most = std::max(most, distance_to_ellipse(carrier, point_at(part, part.from + sweep * i / parts)));
        if (!(most <= reach)) return std::nullopt;
    }
    if (is_closed(part)) return Along{{carrier.from, carrier.from + turn}, false, most};
    // The sweep differs from the part's own by little; its middle says which way round.
    const double middle = angle_near(carrier, point_at(part, part.from + 0.5 * sweep));
    const auto to_half_turn = [](double a) { return a - turn * std::floor((a + elementary::pi) / turn); };
    const double to_first = to_half_turn(angle_near(carrier, point_at(part, part.from)) - middle);
    const double to_last = to_half_turn(angle_near(carrier, point_at(part, part.to)) - middle);
    Interval on{middle + std::min(to_first, to_last), middle + std::max(to_first, to_last)};
    const double off = 0.5 * (carrier.from + carrier.to) - 0.5 * (on.from + on.to);
    const double shift = turn * std::floor(off / turn + 0.5);
    on.from += shift;
    on.to += shift;
    return Along{on, to_last < to_first, most};
}

}  // namespace

std::optional<Along> along(const Element& carrier, const Element& part, double reach) {
    if (carrier.kind != part.kind || carrier.layer != part.layer) return std::nullopt;
    switch (carrier.kind) {
        case ElementKind::point: {
            const double distance = length(part.at[0] - carrier.at[0]);
            if (!(distance <= reach)) return std::nullopt;
            return Along{{}, false, distance};
        }
        case ElementKind::line:
            return along_line(carrier, part, reach);
        case ElementKind::parabola:
            return along_parabola(carrier, part, reach);
        case ElementKind::arc:
            return along_arc(carrier, part, reach);
        case ElementKind::cubic:
            return along_cubic(carrier, part, reach);
    }
    return std::nullopt;
}

std::optional<Along> fitted_along(const Element& carrier, const Element& part, double first, double last,
                                  double reach) {
    const std::size_t count = carrier.kind == ElementKind::parabola ? 3 : 4;
    Along best;
    double least = 1e300;
    for (int round = 0;; ++round) {
        const Element piece = piece_of(carrier, {first, last});
        double most = 0;
        for (std::size_t i = 0; i < count; ++i) most = std::max(most, length(piece.at[i] - part.at[i]));
        if (most < least) {
            least = most;
            best = Along{{std::min(first, last), std::max(first, last)}, last < first, most};
        }
        if (round == 3 || most <= reach * 0x1p-10 || !(most <= 1e3 * reach)) break;
        // How the control points move with the two parameters; they are linear in each but for the cubic's.
        const double step = 1e-4 * (last - first);
        const Element by_first = piece_of(carrier, {first + step, last});
        const Element by_last = piece_of(carrier, {first, last + step});
        double aa = 0, ab = 0, bb = 0, ar = 0, br = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const Vec a = by_first.at[i] - piece.at[i], b = by_last.at[i] - piece.at[i], r = part.at[i] - piece.at[i];
            aa += dot(a, a);
            ab += dot(a, b);
            bb += dot(b, b);
            ar += dot(a, r);
            br += dot(b, r);
        }
        const double size = aa * bb - ab * ab;
        if (!(size > 0)) break;
        first += step * (ar * bb - br * ab) / size;
        last += step * (br * aa - ar * ab) / size;
    }
    return least <= reach ? std::optional(best) : std::nullopt;
}

double parameter_near(const Element& carrier, Vec point, double guess) {
    switch (carrier.kind) {
        case ElementKind::point:
            return 0;
        case ElementKind::line: {
            const Vec way = carrier.at[1] - carrier.at[0];
            return dot(point - carrier.at[0], way) / dot(way, way);
        }
        case ElementKind::parabola:
            return ParabolaPath(carrier).parameter_near(point, 0);
        case ElementKind::arc: {
            const double angle = angle_near(carrier, point);
            return angle + turn * std::floor((guess - angle) / turn + 0.5);
        }
        case ElementKind::cubic:
            return nearest_on_cubic(carrier, point, guess);
    }
    return 0;
}

double overhang(const Element& carrier, const Along& part) {
    if (carrier.kind == ElementKind::point || is_closed(carrier)) return 0;
    const Interval own = interval_of(carrier);
    double most = 0;
    if (part.on.from < own.from) most = rough_length(carrier, {part.on.from, own.from});
    if (part.on.to > own.to) most = std::max(most, rough_length(carrier, {own.to, part.on.to}));
    return most;
}

std::optional<double> misfit(const Element& carrier, const Element& part, double reach) {
    const auto found = along(carrier, part, reach);
    if (!found) return std::nullopt;
    const double most = std::max(found->distance, overhang(carrier, *found));
    if (!(most <= reach)) return std::nullopt;
    return most;
}

}  // namespace filigree::curves
