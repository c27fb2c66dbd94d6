#include "curves/anchor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

#include "curves/crossing.h"

namespace filigree::curves {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// How far the ends of a cubic go where its control points move by one: tried on each of them.
double magnification(const Element& cubic) {
    const Bounds box = bounds_of(cubic);
    const double step = 1e-6 * length(box.max - box.min);
    const CubicFrame own = cubic_frame_of(cubic);
    double sum = 0;
    for (std::size_t i = 0; i < 8; ++i) {
        Element moved = cubic;
        moved.at[i / 2] = moved.at[i / 2] + (i % 2 == 0 ? Vec{step, 0} : Vec{0, step});
        const CubicFrame frame = cubic_frame_of(moved);
        const auto rate = rate_between(own, frame, false, false);
        if (!rate) return infinity;
        const Similarity by = carrying(point_at(cubic, 0.5), point_at(moved, frame.origin + *rate * (0.5 - own.origin)),
                                       multiplier(own, frame, *rate, false), false);
        const double first = length(apply(by, cubic.at[0]) - cubic.at[0]);
        sum += std::max(first, length(apply(by, cubic.at[3]) - cubic.at[3])) / step;
    }
    return sum;
}

// Collects anchors. Distances below `apart` are too small to fix a direction.
class Anchors {
public:
    explicit Anchors(const Embedding& embedding)
        : embedding_(embedding),
          elements_(embedding.left().elements),
          tolerance_(embedding.options().tolerance),
          apart_(least_distance(embedding.options())) {}

    std::vector<Anchor> found() {
        for (std::uint32_t i = 0; i < elements_.size(); ++i) add_curve(i);
        const bool is_fixed =
            std::any_of(anchors_.begin(), anchors_.end(), [](const Anchor& a) { return !a.is_loose; });
        for (std::uint32_t i = 0; i < elements_.size(); ++i) {
            if (is_place(elements_[i])) add_place(i);
            if (!is_fixed && elements_[i].kind == ElementKind::line) add_line(i);
        }
        std::sort(anchors_.begin(), anchors_.end(), [](const Anchor& a, const Anchor& b) {
            const auto most = [](const Anchor& x) { return *std::max_element(x.reach.begin(), x.reach.end()); };
            return std::tuple(a.is_loose, most(a), a.kind, a.elements) <
                   std::tuple(b.is_loose, most(b), b.kind, b.elements);
        });
        return std::move(anchors_);
    }

private:
    const Element& at(std::uint32_t i) const { return elements_[i]; }

    static Anchor made(AnchorKind kind, std::array<std::uint32_t, 3> elements) {
        Anchor anchor;
        anchor.kind = kind;
        anchor.elements = elements;
        return anchor;
    }

    // Noise of an anchor of some size about a place is magnified so much at its own ends, and by the lever beyond them.
    void set_reach(Anchor& anchor, Vec about, double size, double magnified) const {
        for (const Element& e : elements_) {
            anchor.reach.push_back(tolerance_ * (10 + magnified * std::max(1.0, farthest_from(e, about) / size)));
        }
    }

    void add_curve(std::uint32_t i) {
        const Element& e = at(i);
        Anchor anchor;
        anchor.elements = {i};
        double magnified = 0;
        if (e.kind == ElementKind::parabola) {
            anchor.kind = AnchorKind::parabola;
            anchor.parabola = frame_of(e);
            magnified = 0.2 * looseness(e);
        } else if (e.kind == ElementKind::cubic) {
            anchor.kind = AnchorKind::cubic;
            anchor.cubic = cubic_frame_of(e);
            magnified = magnification(e);
        } else if (e.kind == ElementKind::arc && !is_circle(e)) {
            anchor.kind = AnchorKind::ellipse;
            const double broad = length(e.at[1]), narrow = length(e.at[2]);
            magnified = broad / (broad - narrow) + 0.2 * looseness(e);
        } else {
            return;
        }
        const Bounds box = bounds_of(e);
        const double size = length(box.max - box.min);
        set_reach(anchor, embedding_.middles()[i], size, magnified);
        anchor.is_loose = anchor.reach[i] > 0.1 * size;
        anchors_.push_back(std::move(anchor));
    }

    void add_place(std::uint32_t i) {
        const Vec place = at(i).at[0];
        const bool is_translation = embedding_.options().group == MatchGroup::translation;
        if (is_translation) {
            Anchor anchor = made(AnchorKind::place, {i});
            set_reach(anchor, place, 1, 0);
            anchors_.push_back(std::move(anchor));
            return;
        }
        std::uint32_t other = i;
        for (std::uint32_t j = 0; j < elements_.size(); ++j) {
            if (is_place(at(j)) && length(at(j).at[0] - place) > length(at(other).at[0] - place)) other = j;
            if (at(j).kind == ElementKind::line) add_place_and_line(i, j);
        }
        const double size = length(at(other).at[0] - place);
        if (!(size > apart_)) return;
        Anchor anchor = made(AnchorKind::places, {i, other});
        set_reach(anchor, (place + at(other).at[0]) * 0.5, size, 4);
        anchors_.push_back(std::move(anchor));
    }

    void add_place_and_line(std::uint32_t i, std::uint32_t j) {
        const Vec place = at(i).at[0], foot = foot_on(at(j), place);
        const double off = length(place - foot), size = length(at(j).at[1] - at(j).at[0]);
        Anchor anchor = made(AnchorKind::place_and_line, {i, j});
        anchor.is_on_line = off <= apart_;
        if (anchor.is_on_line && (at(i).kind != ElementKind::point || keeps_lengths(embedding_.options()))) {
            set_reach(anchor, place, size, 4);
        } else if (!anchor.is_on_line) {
            const double lever = length(foot - embedding_.middles()[j]) / size;
            set_reach(anchor, (place + foot) * 0.5, off, 4 * (1 + lever));
        } else {
            return;
        }
        anchors_.push_back(std::move(anchor));
    }

    void add_line(std::uint32_t i) {
        struct Crossing {
            bool is_free;  // the lines' carriers cross, but the lines do not
            double place;
            std::uint32_t other;
            double sine;
        };
        const Vec way = at(i).at[1] - at(i).at[0], unit = way * (1 / length(way));
        std::vector<Crossing> crossings;
        for (std::uint32_t j = 0; j < elements_.size(); ++j) {
            if (j == i || at(j).kind != ElementKind::line) continue;
            const auto crossing = crossing_of(at(i), at(j));
            if (!crossing) continue;
            const Vec other = at(j).at[1] - at(j).at[0];
            crossings.push_back({!do_meet(at(i), at(j), tolerance_), dot(*crossing - at(i).at[0], unit), j,
                                 std::fabs(cross(unit, other)) / length(other)});
        }
        if (crossings.empty()) return;
        // Those that touch are before those that do not; of each the first and the last along the line.
        std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) {
            return std::tuple(a.is_free, a.place, a.other) < std::tuple(b.is_free, b.place, b.other);
        });
        const Crossing& first = crossings.front();
        if (keeps_lengths(embedding_.options())) {
            Anchor anchor = made(AnchorKind::crossing, {i, first.other});
            anchor.do_meet = {!first.is_free, false};
            set_reach(anchor, at(i).at[0] + unit * first.place, length(way), 4 / first.sine);
            anchors_.push_back(std::move(anchor));
        }
        // The farthest of those that touch, or else of all.
        const Crossing* last = nullptr;
        for (const Crossing& c : crossings) {
            if (!(std::fabs(c.place - first.place) > apart_)) continue;
            if (last == nullptr || (c.is_free == last->is_free &&
                                    std::fabs(c.place - first.place) > std::fabs(last->place - first.place))) {
                last = &c;
            }
        }
        if (last == nullptr) return;
        Anchor anchor = made(AnchorKind::lines, {i, first.other, last->other});
        anchor.do_meet = {!first.is_free, !last->is_free};
        set_reach(anchor, at(i).at[0] + unit * (0.5 * (first.place + last->place)),
                  std::fabs(last->place - first.place), 4 / std::min(first.sine, last->sine));
        anchors_.push_back(std::move(anchor));
    }

    const Embedding& embedding_;
    const std::vector<Element>& elements_;
    double tolerance_, apart_;
    std::vector<Anchor> anchors_;
};

Vec within_group(Vec m, MatchGroup group) {
    if (group == MatchGroup::isometry) return m * (1 / length(m));
    return group == MatchGroup::translation ? Vec{1, 0} : m;
}

// What carries two points onto two others, as nearly as the group can: the middle onto the middle.
Similarity carrying_both(Vec p, Vec q, Vec to_p, Vec to_q, MatchGroup group, bool is_reflected) {
    const Vec m = over(to_q - to_p, is_reflected ? conjugate(q - p) : q - p);
    return carrying((p + q) * 0.5, (to_p + to_q) * 0.5, within_group(m, group), is_reflected);
}

// What turns one direction, reflected where that is called for, into another or its opposite.
Vec turn_between(Vec from, Vec to, const Seat& seat) {
    const Vec turn = over(seat.is_turned ? -to : to, seat.is_reflected ? conjugate(from) : from);
    return turn * (1 / length(turn));
}

constexpr Similarity nowhere() { return {{std::numeric_limits<double>::quiet_NaN(), 0}, {}, false}; }

}  // namespace

bool is_circle(const Element& e) { return e.kind == ElementKind::arc && is_circular(e); }

std::vector<Anchor> anchors_of(const Embedding& embedding) { return Anchors(embedding).found(); }

Similarity carrying(const Embedding& embedding, const Anchor& anchor, const Seat& seat) {
    const MatchIndex& design = embedding.design();
    const MatchGroup group = embedding.options().group;
    const Element& own = embedding.left().elements[anchor.elements[0]];
    const std::uint32_t slot = seat.slots[0];
    if (anchor.kind == AnchorKind::parabola) {
        // By the middle of the part, not by the vertices: those may lie far away and be known badly.
        const ParabolaFrame& frame = design.frame(slot);
        const double slope = 0.5 * (anchor.parabola.low + anchor.parabola.high);
        const Vec to = point_at(design.glimpse(slot), parameter_at(frame, seat.is_reflected ? -slope : slope));
        return carrying(embedding.middles()[anchor.elements[0]], to,
                        within_group(multiplier(anchor.parabola, frame, seat.is_reflected), group), seat.is_reflected);
    }
    const Element& carrier = design.element(slot);
    const Vec place = own.at[0], to_place = carrier.at[0];
    if (anchor.kind == AnchorKind::cubic) {
        const CubicFrame& frame = design.cubic_frame(slot);
        const auto rate = rate_between(anchor.cubic, frame, seat.is_reflected, seat.is_turned);
        if (!rate) return nowhere();
        const Vec m = multiplier(anchor.cubic, frame, *rate, seat.is_reflected);
        return carrying(point_at(own, 0.5), point_at(carrier, frame.origin + *rate * (0.5 - anchor.cubic.origin)),
                        within_group(m, group), seat.is_reflected);
    }
    if (anchor.kind == AnchorKind::ellipse) {
        const Vec m = turn_between(own.at[1], carrier.at[1], seat) * (length(carrier.at[1]) / length(own.at[1]));
        return carrying(place, to_place, within_group(m, group), seat.is_reflected);
    }
    if (anchor.kind == AnchorKind::place) return carrying(place, to_place, {1, 0}, false);
    const Element& second = embedding.left().elements[anchor.elements[1]];
    const Element& second_carrier = design.element(seat.slots[1]);
    if (anchor.kind == AnchorKind::places) {
        return carrying_both(place, second.at[0], to_place, second_carrier.at[0], group, seat.is_reflected);
    }
    if (anchor.kind == AnchorKind::place_and_line) {
        if (!anchor.is_on_line) {
            return carrying_both(place, foot_on(second, place), to_place, foot_on(second_carrier, to_place), group,
                                 seat.is_reflected);
        }
        const Vec turn = turn_between(second.at[1] - second.at[0], second_carrier.at[1] - second_carrier.at[0], seat);
        const double scale = own.kind == ElementKind::point ? 1 : length(carrier.at[1]) / length(own.at[1]);
        return carrying(place, to_place, within_group(turn * scale, group), seat.is_reflected);
    }
    const auto from = crossing_of(own, second), to = crossing_of(carrier, second_carrier);
    if (!from || !to) return nowhere();
    if (anchor.kind == AnchorKind::crossing) {
        const Vec turn = turn_between(own.at[1] - own.at[0], carrier.at[1] - carrier.at[0], seat);
        return carrying(*from, *to, within_group(turn, group), seat.is_reflected);
    }
    const auto from_other = crossing_of(own, embedding.left().elements[anchor.elements[2]]);
    const auto to_other = crossing_of(carrier, design.element(seat.slots[2]));
    if (!from_other || !to_other) return nowhere();
    return carrying_both(*from, *from_other, *to, *to_other, group, seat.is_reflected);
}

Similarity carrying(const Embedding& embedding, const Anchor& anchor, const std::array<std::uint32_t, 3>& slots,
                    const Similarity& roughly) {
    const Similarity one = carrying(embedding, anchor, {slots, roughly.is_reflected, false});
    const bool has_other = anchor.kind == AnchorKind::cubic || anchor.kind == AnchorKind::ellipse ||
                           anchor.kind == AnchorKind::crossing || anchor.is_on_line;
    if (!has_other) return one;
    const Similarity other = carrying(embedding, anchor, {slots, roughly.is_reflected, true});
    const auto off = [&](const Similarity& s) { return length(s.m - roughly.m); };
    return off(other) < off(one) ? other : one;  // where the other is none, its distance is no number
}

}  // namespace filigree::curves
