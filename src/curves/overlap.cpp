#include "curves/overlap.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "curves/along.h"
#include "curves/join.h"

namespace filigree::curves {
namespace {

constexpr double turn = 2 * elementary::pi;

// Whether a is to be the carrier of b: the longer, and of equally long ones the first.
bool carries(const Element& a, const Element& b) {
    if (is_closed(a) != is_closed(b)) return is_closed(a);
    const double of_a = rough_length(a), of_b = rough_length(b);
    return of_a != of_b ? of_a > of_b : !comes_before(b, a);
}

// Where another element lies on the parameter of one, and how its ends follow each other there.
struct Placed {
    Interval on;
    Vec first, last;  // its ends, in the order of the parameter
    double distance = 0;
};

// On the parameter of the carrier.
std::optional<Placed> placed_on_carrier(const Element& carrier, const Element& part, double reach) {
    const auto found = along(carrier, part, reach);
    if (!found) return std::nullopt;
    auto [first, last] = ends_of(part);
    if (found->is_reversed) std::swap(first, last);
    return Placed{found->on, first, last, found->distance};
}

// On the parameter of the part, beyond its ends to about where the carrier ends.
std::optional<Placed> placed_on_part(const Element& part, const Element& carrier, double reach) {
    const auto found = along(carrier, part, reach);
    if (!found) return std::nullopt;
    const Interval own = interval_of(part), other = interval_of(carrier), on = found->on;
    const double rate = (own.to - own.from) / (on.to - on.from);
    auto [first, last] = ends_of(carrier);
    Interval placed{own.from + (other.from - on.from) * rate, own.from + (other.to - on.from) * rate};
    if (found->is_reversed) {
        placed = {own.to - (other.to - on.from) * rate, own.to - (other.from - on.from) * rate};
        std::swap(first, last);
    }
    // Where it ends on the part, exactly.
    if (!is_closed(carrier)) {
        for (const auto& [end, at] : {std::pair(&placed.from, first), std::pair(&placed.to, last)}) {
            if (*end > own.from && *end < own.to) *end = parameter_near(part, at, *end);
        }
    }
    return Placed{placed, first, last, found->distance};
}

// The shorter of two Beziers may have more of the parameter, and tell more of the descriptor, where the longer is fast.
bool may_carry_either(const Element& e) { return e.kind == ElementKind::parabola || e.kind == ElementKind::cubic; }

std::optional<Placed> placed_on(const Element& e, const Element& other, double reach) {
    const bool is_carrier = carries(e, other);
    auto placed = is_carrier ? placed_on_carrier(e, other, reach) : placed_on_part(e, other, reach);
    if (placed || !may_carry_either(e) || e.kind != other.kind) return placed;
    return is_carrier ? placed_on_part(e, other, reach) : placed_on_carrier(e, other, reach);
}

// Whether two lines plainly lie in different directions: where many meet in a point this is asked most.
bool are_apart(const Element& a, const Element& b, double reach) {
    if (a.kind != ElementKind::line || b.kind != ElementKind::line) return false;
    const Vec of_a = a.at[1] - a.at[0], of_b = b.at[1] - b.at[0];
    const double off = cross(of_a, of_b);
    return off * off > 4 * reach * reach * std::max(dot(of_a, of_a), dot(of_b, of_b));
}

// Two elements in the order of carrier and part, and where the part lies.
struct Related {
    const Element &carrier, &part;
    Placed placed;
};
std::optional<Related> related(const Element& a, const Element& b, double reach) {
    if (are_apart(a, b, reach)) return std::nullopt;
    const bool a_carries = carries(a, b);
    const Element &longer = a_carries ? a : b, &shorter = a_carries ? b : a;
    if (const auto placed = placed_on_carrier(longer, shorter, reach)) return Related{longer, shorter, *placed};
    if (!may_carry_either(a) || a.kind != b.kind) return std::nullopt;
    if (const auto placed = placed_on_carrier(shorter, longer, reach)) return Related{shorter, longer, *placed};
    return std::nullopt;
}

// Calls visit(interval) for the places of an interval around an ellipse, or for it alone.
template <class Visit>
void for_each_turn(const Element& e, Interval on, Visit visit) {
    if (e.kind != ElementKind::arc) return visit(on);
    for (const double by : {-turn, 0.0, turn}) visit(Interval{on.from + by, on.to + by});
}

// Calls visit(stretch, on) for where an interval, and so what is placed there, lies on an element; `on` is the interval
// before it was cut to the element's own.
template <class Visit>
void for_each_stretch(const Element& e, const Element& other, const Placed& placed, Visit visit) {
    const Interval own = interval_of(e);
    const auto look = [&](Interval on) {
        const Stretch stretch{{std::max(on.from, own.from), std::min(on.to, own.to)}, placed.first, placed.last};
        if (stretch.on.from < stretch.on.to) visit(stretch, on);
    };
    if (is_closed(other)) return look(own);
    for_each_turn(e, placed.on, look);
}

Stretches stretches_of(const Element& e, const Element& other, const Placed& placed, double tolerance,
                       Ambiguities* ambiguities) {
    if (e.kind == ElementKind::point) return {{Stretch{interval_of(e), e.at[0], e.at[0]}}, 1, true};
    Stretches found;
    const Interval own = interval_of(e);
    for_each_stretch(e, other, placed, [&](Stretch stretch, Interval on) {
        const double size = rough_length(e, stretch.on);
        if (!(size > tolerance) || found.count == found.all.size()) return;
        if (stretch.on != on) {
            const Vec middle = point_at(e, 0.5 * (stretch.on.from + stretch.on.to));
            note(ambiguities, Doubt::overlap, middle, size, tolerance);
        }
        const double lost = rough_length(e, {on.from, stretch.on.from}) + rough_length(e, {stretch.on.to, on.to});
        found.has_all = lost <= as_good_as_exact * tolerance;
        if (stretch.on.from == own.from) stretch.first = point_at(e, own.from);
        if (stretch.on.to == own.to) stretch.last = point_at(e, own.to);
        found.all[found.count++] = stretch;
    });
    return found;
}

// Where two elements that are not taken for parts of one curve lie together nevertheless.
void note_beside(const Element& e, const Element& other, double tolerance, Ambiguities& ambiguities) {
    const auto placed = placed_on(e, other, doubtful * tolerance);
    if (!placed) return;
    if (e.kind == ElementKind::point) return note(&ambiguities, Doubt::place, e.at[0], placed->distance, tolerance);
    for_each_stretch(e, other, *placed, [&](const Stretch& stretch, Interval) {
        if (rough_length(e, stretch.on) <= doubtful * tolerance) return;
        const Vec middle = point_at(e, 0.5 * (stretch.on.from + stretch.on.to));
        note(&ambiguities, Doubt::descriptor, middle, placed->distance, tolerance);
    });
}

}  // namespace

Stretches covered(const Element& e, const Element& other, double tolerance, Ambiguities* ambiguities) {
    if (const auto placed = placed_on(e, other, tolerance)) {
        return stretches_of(e, other, *placed, tolerance, ambiguities);
    }
    if (ambiguities != nullptr) note_beside(e, other, tolerance, *ambiguities);
    return {};
}

std::vector<Element> common(const Element& a, const Element& b, double tolerance, Ambiguities* ambiguities) {
    std::vector<Element> pieces;
    const auto relation = related(a, b, tolerance);
    if (!relation) {
        if (ambiguities != nullptr) note_beside(a, b, tolerance, *ambiguities);
        return pieces;
    }
    const auto& [carrier, part, placed] = *relation;
    const Stretches stretches = stretches_of(carrier, part, placed, tolerance, ambiguities);
    for (const Stretch& stretch : stretches.span()) {
        auto piece = stretches.has_all ? std::optional(part) : piece_between(carrier, stretch, tolerance);
        if (!piece) continue;
        piece->weight = std::min(a.weight, b.weight);
        pieces.push_back(*piece);
    }
    return pieces;
}

std::vector<Element> uncovered(const Element& e, std::vector<Stretch> stretches, double tolerance,
                               Ambiguities* ambiguities) {
    if (stretches.empty()) return {e};
    std::vector<Element> rests;
    if (e.kind == ElementKind::point) return rests;
    std::sort(stretches.begin(), stretches.end(), [](const Stretch& a, const Stretch& b) {
        return a.on.from != b.on.from ? a.on.from < b.on.from : a.on.to < b.on.to;
    });
    const auto add = [&](const Stretch& rest) {
        if (!(rest.on.from < rest.on.to)) return;
        const double size = rough_length(e, rest.on);
        if (!(size > tolerance)) return;
        const auto piece = piece_between(e, rest, tolerance);
        if (!piece) return;
        note(ambiguities, Doubt::rest, point_at(e, 0.5 * (rest.on.from + rest.on.to)), size, tolerance);
        rests.push_back(*piece);
    };
    const Interval own = interval_of(e);
    Stretch rest{own, point_at(e, own.from), {}};
    if (is_closed(e)) {
        // Round the seam: from behind the one that reaches farthest to the first, a turn later.
        const Stretch first = stretches.front();
        stretches.push_back({{first.on.from + turn, first.on.to + turn}, first.first, first.last});
        rest.on.from = first.on.from;
    } else {
        stretches.push_back({{own.to, own.to}, point_at(e, own.to), {}});
    }
    for (const Stretch& stretch : stretches) {
        rest.on.to = stretch.on.from;
        rest.last = stretch.first;
        add(rest);
        if (stretch.on.to > rest.on.from) rest = {{stretch.on.to, 0}, stretch.last, {}};
    }
    return rests;
}

std::optional<Element> joined(const Element& a, const Element& b, double tolerance) {
    const auto relation = related(a, b, tolerance);
    if (!relation) return std::nullopt;
    const auto& [carrier, part, placed] = *relation;
    if (carrier.kind == ElementKind::point || is_closed(carrier)) return carrier;
    const Interval own = interval_of(carrier);
    std::optional<Stretch> together;
    const double noticeable = as_good_as_exact * tolerance;
    for_each_turn(carrier, placed.on, [&](Interval on) {
        const double gap = on.from > own.to   ? rough_length(carrier, {own.to, on.from})
                           : own.from > on.to ? rough_length(carrier, {on.to, own.from})
                                              : 0;
        if (!(gap <= tolerance)) return;
        if (!together) together = Stretch{own, point_at(carrier, own.from), point_at(carrier, own.to)};
        if (on.from < together->on.from && rough_length(carrier, {on.from, together->on.from}) > noticeable) {
            together->on.from = on.from;
            together->first = placed.first;
        }
        if (on.to > together->on.to && rough_length(carrier, {together->on.to, on.to}) > noticeable) {
            together->on.to = on.to;
            together->last = placed.last;
        }
    });
    if (!together) return std::nullopt;
    if (together->on == own) return carrier;
    return extended(carrier, *together, part, {placed.on, placed.first, placed.last}, tolerance);
}

void note_nearly_joined(const Element& a, const Element& b, double tolerance, Ambiguities& ambiguities) {
    const auto close = related(a, b, tolerance);
    const auto relation = close ? close : related(a, b, doubtful * tolerance);
    if (!relation) return;
    const auto& [carrier, part, placed] = *relation;
    if (carrier.kind == ElementKind::point) {
        return note(&ambiguities, Doubt::place, carrier.at[0], placed.distance, tolerance);
    }
    const Interval own = interval_of(carrier);
    double least = 1e300;
    Vec where;
    for_each_turn(carrier, placed.on, [&](Interval on) {
        double gap = 0;
        double at = std::clamp(0.5 * (on.from + on.to), own.from, own.to);
        if (on.from > own.to) gap = rough_length(carrier, {at = own.to, on.from});
        if (own.from > on.to) gap = rough_length(carrier, {on.to, at = own.from});
        if (is_closed(carrier)) gap = 0;
        if (gap >= least) return;
        least = gap;
        where = point_at(carrier, at);
    });
    if (least > doubtful * tolerance) return;
    // Of one curve and apart, or together and of nearly one curve. What is itself that short lies near anything.
    if (placed.distance <= tolerance) {
        note(&ambiguities, Doubt::gap, where, least, tolerance);
    } else if (rough_length(part) > doubtful * doubtful * tolerance) {
        note(&ambiguities, Doubt::descriptor, where, placed.distance, tolerance);
    }
}

}  // namespace filigree::curves
