#include "curves/affine_frame.h"

#include <algorithm>
#include <cmath>

namespace filigree::curves {
namespace {

double roundness_of(const std::array<Vec, 3>& at) {
    const Vec u = at[1] - at[0], v = at[2] - at[0], w = at[2] - at[1];
    const double longest = std::max({dot(u, u), dot(v, v), dot(w, w)});
    return longest > 0 ? std::fabs(cross(u, v)) / longest : 0;
}

bool share_an_element(const Registration& a, const Registration& b) {
    return std::find(b.elements.begin(), b.elements.end(), a.elements[0]) != b.elements.end() ||
           std::find(b.elements.begin(), b.elements.end(), a.elements[1]) != b.elements.end();
}

// As a contact with its elements the other way round.
Registration turned_round(Registration point) {
    std::swap(point.elements[0], point.elements[1]);
    std::swap(point.ways[0], point.ways[1]);
    std::swap(point.is_inside[0], point.is_inside[1]);
    std::swap(point.is_well_inside[0], point.is_well_inside[1]);
    return point;
}

class Seats {
public:
    Seats(const AffineFrame& frame, const Registrations& own, const Registrations& design, const MayCarry& may_carry,
          const std::function<bool(const AffineSeat&)>& take)
        : frame_(frame), own_(own), design_(design), may_carry_(may_carry), take_(take) {
        seat_.carriers.assign(own.on.size(), AffineSeat::unbound);
    }

    void find() { go_on(0); }

private:
    const Registration& own_point(std::size_t i) const { return own_.points[frame_.points[i]]; }

    // Finds places for the points from this one on; false when it is enough.
    bool go_on(std::size_t i) {
        if (i == (frame_.third == AffineFrame::Third::point ? 3U : 2U)) return finish();
        // Only those on a carrier that is known already, where there is one.
        const std::vector<std::uint32_t>* on = nullptr;
        for (const std::uint32_t element : own_point(i).elements) {
            const std::uint32_t slot = seat_.carriers[element];
            if (slot == AffineSeat::unbound) continue;
            if (on == nullptr || design_.on[slot].size() < on->size()) on = &design_.on[slot];
        }
        if (on != nullptr) {
            return std::all_of(on->begin(), on->end(), [&](std::uint32_t n) { return try_both(i, design_.points[n]); });
        }
        return std::all_of(design_.points.begin(), design_.points.end(),
                           [&](const Registration& point) { return try_both(i, point); });
    }

    bool try_both(std::size_t i, const Registration& point) {
        const Registration& own = own_point(i);
        if (point.is_contact != own.is_contact || point.is_tangential != own.is_tangential) return true;
        return try_point(i, point) && (!point.is_contact || try_point(i, turned_round(point)));
    }

    bool try_point(std::size_t i, const Registration& point) {
        for (std::size_t before = 0; before < i; ++before) {
            if (point.at == seat_.at[before]) return true;
        }
        const Registration& own = own_point(i);
        const std::array<std::uint32_t, 2> known = {seat_.carriers[own.elements[0]], seat_.carriers[own.elements[1]]};
        for (std::size_t side = 0; side < (own.is_contact ? 2U : 1U); ++side) {
            if (known[side] != AffineSeat::unbound && known[side] != point.elements[side]) return true;
            if (own.is_well_inside[side] && !point.is_inside[side]) return true;
            if (known[side] == AffineSeat::unbound && !may_carry_(own.elements[side], point.elements[side]))
                return true;
        }
        seat_.carriers[own.elements[0]] = point.elements[0];
        if (own.is_contact) seat_.carriers[own.elements[1]] = point.elements[1];
        seat_.at[i] = point.at;
        taken_[i] = point;
        const bool goes_on = go_on(i + 1);
        seat_.carriers[own.elements[0]] = known[0];
        if (own.is_contact) seat_.carriers[own.elements[1]] = known[1];
        return goes_on;
    }

    bool finish() {
        if (frame_.third != AffineFrame::Third::point) {
            const auto third = third_of(frame_, taken_[0], taken_[1]);
            if (!third) return true;
            seat_.at[2] = *third;
        }
        return take_(seat_);
    }

    const AffineFrame& frame_;
    const Registrations& own_;
    const Registrations& design_;
    const MayCarry& may_carry_;
    const std::function<bool(const AffineSeat&)>& take_;
    AffineSeat seat_;
    std::array<Registration, 3> taken_;
};

}  // namespace

std::optional<Vec> third_of(const AffineFrame& frame, const Registration& first, const Registration& second) {
    const bool meets = frame.third == AffineFrame::Third::meeting;
    const Vec along = first.ways[frame.ways[0]];
    const Vec against = meets ? second.ways[frame.ways[1]] : first.ways[1 - frame.ways[0]];
    const double turn = cross(along, against);
    if (!(std::fabs(turn) > 1e-4)) return std::nullopt;
    return first.at + along * (cross(second.at - first.at, against) / turn);
}

std::optional<AffineFrame> frame_of(const Shape& left, const Registrations& own, const Registrations& design) {
    const double count = static_cast<double>(design.points.size()) + 1;
    std::size_t used = 1;
    for (const auto& on : design.on) used += !on.empty();
    const double by_element = 2 * count / static_cast<double>(used);  // the registration points of an element
    const double size = diagonal_of(bounds_of(left.elements));
    std::optional<AffineFrame> best;
    // What is flat, small or far away beside the shape knows the map badly.
    const auto price_of = [](const AffineFrame& frame) {
        return frame.cost * (1 + 0.01 / (frame.roundness * frame.roundness));
    };
    const auto take = [&](AffineFrame frame) {
        frame.roundness = roundness_of(frame.at);
        const double longest = std::max(length(frame.at[1] - frame.at[0]), length(frame.at[2] - frame.at[0]));
        if (!(frame.roundness > 1e-3) || !(longest > 1e-3 * size) || !(longest < 1e2 * size)) return;
        if (!best || price_of(frame) < price_of(*best)) best = frame;
    };
    const auto points = static_cast<std::uint32_t>(std::min<std::size_t>(own.points.size(), 40));
    for (std::uint32_t p = 0; p < points; ++p) {
        const Registration& first = own.points[p];
        for (std::uint32_t q = 0; q < points; ++q) {
            if (q == p) continue;
            const Registration& second = own.points[q];
            AffineFrame frame;
            frame.points = {p, q, q};
            frame.at = {first.at, second.at, {}};
            const double pairs = count * (share_an_element(first, second) ? by_element : count);
            frame.cost = pairs;
            const auto derive = [&](AffineFrame::Third third, std::array<std::size_t, 2> ways) {
                frame.third = third;
                frame.ways = ways;
                const auto at = third_of(frame, first, second);
                if (!at) return;
                frame.at[2] = *at;
                take(frame);
            };
            for (std::size_t way = 0; way < 2; ++way) {
                if (!first.is_contact) break;
                derive(AffineFrame::Third::beside, {way, 0});
                for (std::size_t other = 0; other < (second.is_contact ? 2U : 0U); ++other) {
                    derive(AffineFrame::Third::meeting, {way, other});
                }
            }
            for (std::uint32_t r = 0; r < points; ++r) {
                const Registration& third = own.points[r];
                const bool shares = share_an_element(third, first) || share_an_element(third, second);
                frame.third = AffineFrame::Third::point;
                frame.points[2] = r;
                frame.at[2] = third.at;
                frame.cost = pairs * (shares ? by_element : count);
                take(frame);
            }
            frame.points[2] = q;
            frame.cost = pairs;
        }
    }
    return best;
}

Transform carrying(const std::array<Vec, 3>& from, const std::array<Vec, 3>& to) {
    const Vec u = from[1] - from[0], v = from[2] - from[0], to_u = to[1] - to[0], to_v = to[2] - to[0];
    const double area = cross(u, v);
    Transform by;
    by.a = (to_u.x * v.y - to_v.x * u.y) / area;
    by.c = (to_v.x * u.x - to_u.x * v.x) / area;
    by.b = (to_u.y * v.y - to_v.y * u.y) / area;
    by.d = (to_v.y * u.x - to_u.y * v.x) / area;
    by.e = to[0].x - by.a * from[0].x - by.c * from[0].y;
    by.f = to[0].y - by.b * from[0].x - by.d * from[0].y;
    return by;
}

void find_seats(const AffineFrame& frame, const Registrations& own, const Registrations& design,
                const MayCarry& may_carry, const std::function<bool(const AffineSeat&)>& take) {
    Seats(frame, own, design, may_carry, take).find();
}

}  // namespace filigree::curves
