#include "curves/match_index.h"

#include <cmath>

#include "curves/crossing.h"

namespace filigree::curves {
namespace {

template <class T>
void drop_row(std::vector<T>& column, std::size_t row) {
    column[row] = column.back();
    column.pop_back();
}

Glimpse glimpse_of(const Element& e) {
    Glimpse glimpse{e.at[0], {}, {}, e.weight, e.layer, e.kind};
    if (e.kind == ElementKind::line) glimpse.b = e.at[1] - e.at[0];
    if (e.kind == ElementKind::parabola) {
        glimpse.a = e.at[0] - 2 * e.at[1] + e.at[2];
        glimpse.b = 2 * (e.at[1] - e.at[0]);
    }
    return glimpse;
}

Vec middle_of(const Element& e) {
    const Interval on = interval_of(e);
    return point_at(e, 0.5 * (on.from + on.to));
}

}  // namespace

MatchIndex::MatchIndex(const Shape& design, double tolerance)
    : tolerance_(tolerance),
      elements_(design.elements),
      glimpses_(elements_.size()),
      frames_(elements_.size()),
      row_(elements_.size(), none),
      met_(elements_.size()),
      grid_(elements_) {
    for (std::uint32_t slot = 0; slot < elements_.size(); ++slot) enter(slot);
    for (const std::uint32_t slot : slots_of(ElementKind::line)) meet_others(slot, true);
}

void MatchIndex::meet_others(std::uint32_t slot, bool below_only) {
    // What touches in the left side to within the tolerance may be apart by more here, where it is scaled up and both
    // are carried to within the tolerance.
    const double reach = 20 * tolerance_;
    for (const std::uint32_t other : grid_.found_along(elements_[slot], reach)) {
        if (other == slot || (below_only && other > slot) || elements_[other].kind != ElementKind::line) continue;
        if (!do_meet(elements_[slot], elements_[other], reach)) continue;
        met_[slot].push_back(other);
        met_[other].push_back(slot);
        ++meetings_;
    }
}

void MatchIndex::part_from_others(std::uint32_t slot) {
    for (const std::uint32_t other : met_[slot]) std::erase(met_[other], slot);
    meetings_ -= met_[slot].size();
    met_[slot].clear();
}

void MatchIndex::enter(std::uint32_t slot) {
    const Element& e = elements_[slot];
    glimpses_[slot] = glimpse_of(e);
    if (e.kind != ElementKind::parabola) {
        auto& slots = slots_[static_cast<std::size_t>(e.kind)];
        row_[slot] = static_cast<std::uint32_t>(slots.size());
        slots.push_back(slot);
        if (e.kind == ElementKind::cubic) cubics_.push_back(cubic_frame_of(e));
        return;
    }
    const ParabolaFrame frame = frame_of(e);
    frames_[slot] = frame;
    row_[slot] = static_cast<std::uint32_t>(parabolas_.slots.size());
    parabolas_.low.push_back(frame.low);
    parabolas_.high.push_back(frame.high);
    parabolas_.per_px_low.push_back(slope_per_px(frame, frame.low));
    parabolas_.per_px_high.push_back(slope_per_px(frame, frame.high));
    parabolas_.radius.push_back(length(frame.m));
    parabolas_.slots.push_back(slot);
}

void MatchIndex::leave(std::uint32_t slot) {
    const std::uint32_t row = row_[slot];
    row_[slot] = none;
    if (elements_[slot].kind != ElementKind::parabola) {
        auto& slots = slots_[static_cast<std::size_t>(elements_[slot].kind)];
        if (slots.back() != slot) row_[slots.back()] = row;
        drop_row(slots, row);
        if (elements_[slot].kind == ElementKind::cubic) drop_row(cubics_, row);
        return;
    }
    if (parabolas_.slots.back() != slot) row_[parabolas_.slots.back()] = row;
    drop_row(parabolas_.low, row);
    drop_row(parabolas_.high, row);
    drop_row(parabolas_.per_px_low, row);
    drop_row(parabolas_.per_px_high, row);
    drop_row(parabolas_.radius, row);
    drop_row(parabolas_.slots, row);
}

MatchIndex::Change MatchIndex::update(std::span<const Element> removed, std::span<const Element> added) {
    Change change;
    for (const Element& e : removed) {
        std::uint32_t found = none;
        const Vec middle = middle_of(e);
        // Rounding may have put the middle into the next cell.
        const double off = 1e-12 * (std::fabs(middle.x) + std::fabs(middle.y) + rough_length(e));
        grid_.visit_near(middle, off, [&](std::uint32_t slot) {
            if (elements_[slot] == e) found = slot;
        });
        if (found == none) continue;
        leave(found);
        part_from_others(found);
        grid_.remove(found, e);
        free_.push_back(found);
        change.removed.push_back(found);
    }
    for (const Element& e : added) {
        std::uint32_t slot = static_cast<std::uint32_t>(elements_.size());
        if (free_.empty()) {
            elements_.emplace_back();
            glimpses_.emplace_back();
            frames_.emplace_back();
            row_.push_back(none);
            met_.emplace_back();
        } else {
            slot = free_.back();
            free_.pop_back();
        }
        elements_[slot] = e;
        enter(slot);
        grid_.insert(slot, e);
        if (e.kind == ElementKind::line) meet_others(slot, false);
        change.added.push_back(slot);
    }
    if (grid_.insertions() > 64 + 2 * elements_.size()) {
        ElementGrid fresh(elements_);
        for (const std::uint32_t slot : free_) fresh.remove(slot, elements_[slot]);
        grid_ = std::move(fresh);
    }
    return change;
}

}  // namespace filigree::curves
