#include "curves/along.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/elementary.h"

namespace filigree::curves {
namespace {

constexpr double turn = 2 * elementary::pi;

// Compares a part with the piece of the carrier between two parameters, control point by control point.
std::optional<Along> compared(const Element& carrier, const Element& part, double first, double last, double reach) {
    const Element piece = piece_of(carrier, {first, last});
    const std::size_t count = part.kind == ElementKind::line ? 2 : part.kind == ElementKind::parabola ? 3 : 4;
    double most = 0;
    for (std::size_t i = 0; i < count; ++i) most = std::max(most, length(piece.at[i] - part.at[i]));
    if (!(most <= reach)) return std::nullopt;
    return Along{{std::min(first, last), std::max(first, last)}, last < first, most};
}

std::optional<Along> along_line(const Element& carrier, const Element& part, double reach) {
    const Vec way = carrier.at[1] - carrier.at[0];
    const double scale = 1 / dot(way, way);
    const double first = dot(part.at[0] - carrier.at[0], way) * scale;
    const double last = dot(part.at[1] - carrier.at[0], way) * scale;
    return compared(carrier, part, first, last, reach);
}

// Across its axis a parabola's parameter is linear, so no vertex is needed.
std::optional<Along> along_parabola(const Element& carrier, const Element& part, double reach) {
    const Vec a = carrier.at[0] - 2 * carrier.at[1] + carrier.at[2], b = 2 * (carrier.at[1] - carrier.at[0]);
    const double scale = 1 / cross(a, b);
    if (!std::isfinite(scale)) return std::nullopt;
    const double first = cross(a, part.at[0] - carrier.at[0]) * scale;
    const double last = cross(a, part.at[2] - carrier.at[0]) * scale;
    return compared(carrier, part, first, last, reach);
}

// The parameters where a cubic's descriptor comes nearest to a point, among those within `reach` of it.
struct Feet {
    std::array<double, 8> at{};
    std::size_t count = 0;
};
Feet feet_of(const Element& cubic, Vec point, double reach, std::optional<double> guess) {
    Feet feet;
    const auto take = [&](double t) {
        for (int round = 0; round < 12; ++round) {
            const Vec v = velocity_at(cubic, t);
            const double size = dot(v, v);
            if (!(size > 0)) return;
            const double step = dot(point_at(cubic, t) - point, v) / size;
            t -= std::clamp(step, -0.25, 0.25);
            if (std::fabs(step) < 1e-15) break;
        }
        if (!(length(point_at(cubic, t) - point) <= reach) || feet.count == feet.at.size()) return;
        for (std::size_t i = 0; i < feet.count; ++i) {
            if (std::fabs(feet.at[i] - t) <= 1e-9) return;
        }
        feet.at[feet.count++] = t;
    };
    if (guess) take(*guess);
    // From where the sampled distance has a minimum; a part that touches the carrier may lie a length beyond it.
    constexpr int samples = 72;
    std::array<double, samples + 1> distance{};
    const auto place = [](int i) { return -1 + 3.0 * i / samples; };
    for (int i = 0; i <= samples; ++i) {
        const Vec off = point_at(cubic, place(i)) - point;
        distance[static_cast<std::size_t>(i)] = dot(off, off);
    }
    for (int i = 0; i <= samples; ++i) {
        const double here = distance[static_cast<std::size_t>(i)];
        const bool is_least = (i == 0 || here <= distance[static_cast<std::size_t>(i - 1)]) &&
                              (i == samples || here <= distance[static_cast<std::size_t>(i + 1)]);
        if (is_least) take(place(i));
    }
    return feet;
}

Vec leading(const Element& cubic) { return cubic.at[3] - cubic.at[0] + 3 * (cubic.at[1] - cubic.at[2]); }
Vec second(const Element& cubic) { return 3 * (cubic.at[0] - 2 * cubic.at[1] + cubic.at[2]); }

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
    std::optional<double> first_guess, last_guess;
    if (const auto map = map_by_coefficients(carrier, part)) {
        first_guess = map->second;
        last_guess = map->first + map->second;
    }
    const Feet first = feet_of(carrier, part.at[0], reach, first_guess);
    if (first.count == 0) return std::nullopt;
    const Feet last = feet_of(carrier, part.at[3], reach, last_guess);
    std::optional<Along> best;
    for (std::size_t i = 0; i < first.count; ++i) {
        for (std::size_t j = 0; j < last.count; ++j) {
            const auto found = compared(carrier, part, first.at[i], last.at[j], reach);
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

// To first order, which is enough near the curve.
double distance_to_ellipse(const Element& arc, Vec p) {
    const Vec own = inside_axes(arc, p);
    if (is_circular(arc)) return std::fabs(length(p - arc.at[0]) - length(arc.at[1]));
    const Vec slope =
        arc.at[1] * (2 * own.x / dot(arc.at[1], arc.at[1])) + arc.at[2] * (2 * own.y / dot(arc.at[2], arc.at[2]));
    return std::fabs(dot(own, own) - 1) / std::max(length(slope), 1e-300);
}

std::optional<Along> along_arc(const Element& carrier, const Element& part, double reach) {
    constexpr int parts = 8;
    double most = 0;
    for (int i = 0; i <= parts; ++i) {
        const double t = part.from + (part.to - part.from) * i / parts;
        most = std::max(most, distance_to_ellipse(carrier, point_at(part, t)));
        if (!(most <= reach)) return std::nullopt;
    }
    if (is_closed(part)) return Along{{carrier.from, carrier.from + turn}, false, most};
    const double sweep = part.to - part.from;
    const auto angle = [&](double t) {
        const Vec own = inside_axes(carrier, point_at(part, t));
        return elementary::atan2(own.y, own.x);
    };
    // The sweep differs from the part's own by little; its middle says which way round.
    const double middle = angle(part.from + 0.5 * sweep);
    const auto within_half_turn = [](double a) { return a - turn * std::floor((a + elementary::pi) / turn); };
    const double to_first = within_half_turn(angle(part.from) - middle);
    const double to_last = within_half_turn(angle(part.to) - middle);
    const bool is_reversed = to_last < to_first;
    Interval on{middle + std::min(to_first, to_last), middle + std::max(to_first, to_last)};
    const double off = 0.5 * (carrier.from + carrier.to) - 0.5 * (on.from + on.to);
    const double shift = turn * std::floor(off / turn + 0.5);
    on.from += shift;
    on.to += shift;
    return Along{on, is_reversed, most};
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

double overhang(const Element& carrier, const Along& part) {
    if (carrier.kind == ElementKind::point || is_closed(carrier)) return 0;
    const Interval own = interval_of(carrier);
    return std::max((own.from - part.on.from) * length(velocity_at(carrier, own.from)),
                    (part.on.to - own.to) * length(velocity_at(carrier, own.to)));
}

std::optional<double> misfit(const Element& carrier, const Element& part, double reach) {
    const auto found = along(carrier, part, reach);
    if (!found) return std::nullopt;
    const double most = std::max(found->distance, overhang(carrier, *found));
    if (!(most <= reach)) return std::nullopt;
    return most;
}

}  // namespace filigree::curves
