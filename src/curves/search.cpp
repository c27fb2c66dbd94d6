#include "curves/search.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "curves/family_search.h"
#include "curves/match_order.h"
#include "curves/seats.h"

namespace filigree::curves {
namespace {

std::size_t mark(std::uint32_t slot, bool is_reflected) { return std::size_t{2} * slot + is_reflected; }

bool has_frame(const Element& e) { return !is_place(e) && e.kind != ElementKind::line; }

}  // namespace

Search::Search(const Shape& left, const MatchIndex& design, const MatchOptions& options,
               std::span<const Symmetry> symmetries)
    : embedding_(left, design, options), symmetries_(symmetries), anchors_(anchors_of(embedding_)) {
    // The first anchor is the one from which all transforms are computed in the end. It comes from the left side alone,
    // so a match is the same to the last bit however it was found.
    if (!anchors_.empty()) {
        widest_reach_ = *std::max_element(anchors_[0].reach.begin(), anchors_[0].reach.end());
    }
}

bool Search::goes_on() {
    const MatchOptions& options = embedding_.options();
    if (is_cancelled(options.job) || matches_.found.size() >= options.limit) matches_.is_complete = false;
    return matches_.is_complete;
}

// The anchor with the fewest seats, where one that has to look far around them counts for more. Sets the order in which
// elements are asked for, too.
const Anchor& Search::cheapest() {
    const std::vector<Element>& elements = embedding_.left().elements;
    std::vector<double> seats_on(elements.size());
    for (std::size_t i = 0; i < elements.size(); ++i) {
        seats_on[i] = static_cast<double>(embedding_.design().slots_of(elements[i].kind).size());
    }
    const Anchor* best = nullptr;
    double best_cost = 0;
    for (const Anchor& anchor : anchors_) {
        if (anchor.is_loose && best != nullptr) continue;
        const double seats = estimated_seats(embedding_, anchor);
        const std::uint32_t i = anchor.elements[0];
        if (is_curve(anchor)) seats_on[i] = seats;
        const Bounds box = bounds_of(elements[i]);
        const double size = length(box.max - box.min);
        const double cost = (seats + 1) * (1 + (size > 0 ? 100 * anchor.reach[i] / size : 0));
        if (best != nullptr && cost >= best_cost) continue;
        best = &anchor;
        best_cost = cost;
    }
    std::vector<std::uint32_t> order(elements.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    // What is rare comes first, the anchor itself last: that it lies on its seat is known.
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        const bool a_last = a == best->elements[0], b_last = b == best->elements[0];
        return std::tuple(a_last, seats_on[a], a) < std::tuple(b_last, seats_on[b], b);
    });
    embedding_.ask_in(std::move(order));
    return *best;
}

bool Search::try_seats(const Anchor& anchor, std::span<const Seat> seats) {
    seats_.clear();
    by_.clear();
    for (const Seat& seat : seats) {
        if (!is_known_.empty() && is_known_[mark(seat.slots[0], seat.is_reflected)]) continue;
        const Similarity by = carrying(embedding_, anchor, seat);
        if (!std::isfinite(by.m.x + by.m.y + by.t.x + by.t.y)) continue;
        if (!boxes_.empty() && !comes_into(by, boxes_)) continue;
        seats_.push_back(seat);
        by_.push_back(to_transform(by));
    }
    embedding_.sift(by_, anchor.reach, passed_);
    for (const std::uint32_t i : passed_) {
        const Seat& seat = seats_[i];
        if (!is_known_.empty() && is_known_[mark(seat.slots[0], seat.is_reflected)]) continue;
        laid_.by = by_[i];
        if (!embedding_.settle(laid_, anchor.reach)) continue;
        take(anchor, seat.is_reflected);
        if (is_known_.empty()) continue;
        // A symmetry of the left side carries a parabola onto another, and so this seat to another, which need not be
        // tried then.
        for (const Symmetry& g : symmetries_) {
            is_known_[mark(laid_.carriers[g.images[anchor.elements[0]]], seat.is_reflected != g.is_reflected)] = true;
        }
    }
    return goes_on();
}

bool Search::comes_into(const Similarity& by, std::span<const Bounds> boxes) const {
    for (std::size_t i = 0; i < embedding_.middles().size(); ++i) {
        if (has_frame(embedding_.left().elements[i])) continue;
        const Vec at = apply(by, embedding_.middles()[i]);
        for (const Bounds& box : boxes) {
            if (at.x >= box.min.x && at.x <= box.max.x && at.y >= box.min.y && at.y <= box.max.y) return true;
        }
    }
    return false;
}

// Puts what laid_ says among the matches, as the one of its coset that does not reflect where there is one, and is
// turned least.
void Search::take(const Anchor& anchor, bool is_reflected) {
    const double tolerance = embedding_.options().tolerance;
    Laid laid = laid_;
    double angle = angle_of(laid.by);
    const Symmetry* best = nullptr;
    if (symmetries_.size() > 1) {
        const auto rank = [](bool reflects, double degrees) { return std::pair(reflects, std::round(degrees * 1e6)); };
        const bool own = is_reflected;
        for (const Symmetry& g : symmetries_) {
            const Transform by = compose(laid_.by, g.by);
            const bool reflects = own != g.is_reflected;
            if (const double degrees = angle_of(by); rank(reflects, degrees) < rank(is_reflected, angle)) {
                best = &g;
                is_reflected = reflects;
                angle = degrees;
                laid.by = by;
            }
        }
    }
    if (best != nullptr) {
        for (std::size_t i = 0; i < laid.carriers.size(); ++i) laid.carriers[i] = laid_.carriers[best->images[i]];
    }
    if (best != nullptr || &anchor != anchors_.data() || !is_exact(laid.misfit, tolerance)) {
        const Anchor& first = anchors_[0];
        std::array<std::uint32_t, 3> slots{};
        for (std::size_t i = 0; i < slots.size(); ++i) slots[i] = laid.carriers[first.elements[i]];
        const Transform roughly = laid.by;
        laid.by = to_transform(carrying(embedding_, first, slots, to_similarity(roughly)));
        auto misfit = embedding_.misfit_on(laid, 2 * widest_reach_);
        if (!misfit) laid.by = roughly;
        if (!misfit || !is_exact(*misfit, tolerance)) {
            embedding_.refine(laid);
            misfit = embedding_.misfit_on(laid, 10 * tolerance);
        }
        if (!misfit) return;
        laid.misfit = *misfit;
    }
    Match match = embedding_.match_of(std::move(laid), is_reflected);
    (match.misfit <= 1 ? matches_.found : matches_.near_misses).push_back(std::move(match));
}

Matches Search::all() {
    if (!has_anchor()) return find_families(embedding_, symmetries_);
    matches_ = {};
    const Anchor& anchor = cheapest();
    if (anchor.kind == AnchorKind::parabola) is_known_.assign(2 * embedding_.design().slot_count(), false);
    find_seats(embedding_, anchor, [&](std::span<const Seat> seats) { return try_seats(anchor, seats); });
    put_in_order(matches_.found, embedding_.options().tolerance);
    put_in_order(matches_.near_misses, embedding_.options().tolerance);
    return std::move(matches_);
}

Matches Search::on(std::span<const std::uint32_t> slots) {
    matches_ = {};
    if (!has_anchor()) return {};
    const Anchor& anchor = cheapest();
    is_known_.clear();
    // A curve on something new fixes the transform.
    for (const Anchor& curve : anchors_) {
        if (!is_curve(curve)) continue;
        find_seats_on(embedding_, curve, slots, [&](std::span<const Seat> seats) { return try_seats(curve, seats); });
    }
    // Of lines and places all transforms are asked whether they carry one there.
    std::vector<Bounds> boxes;
    for (const std::uint32_t slot : slots) {
        const Element& e = embedding_.design().element(slot);
        if (has_frame(e)) continue;
        Bounds box = bounds_of(e);
        const Vec slack{2 * widest_reach_, 2 * widest_reach_};
        boxes.push_back({box.min - slack, box.max + slack});
    }
    if (!boxes.empty()) {
        boxes_ = boxes;
        find_seats(embedding_, anchor, [&](std::span<const Seat> seats) { return try_seats(anchor, seats); });
        boxes_ = {};
    }
    const auto is_elsewhere = [&](const Match& match) {
        return std::none_of(slots.begin(), slots.end(), [&](std::uint32_t slot) {
            return std::find(match.carriers.begin(), match.carriers.end(), slot) != match.carriers.end();
        });
    };
    std::erase_if(matches_.found, is_elsewhere);
    std::erase_if(matches_.near_misses, is_elsewhere);
    put_in_order(matches_.found, embedding_.options().tolerance);
    put_in_order(matches_.near_misses, embedding_.options().tolerance);
    return std::move(matches_);
}

}  // namespace filigree::curves
