#include "curves/seats.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "curves/crossing.h"

namespace filigree::curves {
namespace {

using Take = std::function<bool(std::span<const Seat>)>;

// Hands seats on by the dozen, so that the memory can be asked for all of them before any is waited for.
class Batch {
public:
    Batch(const MatchIndex& design, const Take& take) : design_(design), take_(take) {}

    void add(const Seat& seat) {
        design_.fetch_frame(seat.slots[0]);
        design_.fetch_glimpse(seat.slots[0]);
        seats_[count_++] = seat;
        if (count_ == seats_.size()) flush();
    }
    void flush() {
        if (count_ > 0 && !is_over_) is_over_ = !take_({seats_.data(), count_});
        count_ = 0;
    }
    bool is_over() const { return is_over_; }

private:
    const MatchIndex& design_;
    const Take& take_;
    std::array<Seat, 64> seats_;
    std::size_t count_ = 0;
    bool is_over_ = false;
};

class Seats {
public:
    Seats(const Embedding& embedding, const Anchor& anchor)
        : embedding_(embedding), design_(embedding.design()), anchor_(anchor) {
        const MatchOptions& options = embedding.options();
        const Bounds box = bounds_of(part(0));
        const double size = length(box.max - box.min), slack = size > 0 ? reach(0) / size : 0;
        low_ = keeps_lengths(options) ? 1 : std::max(options.min_scale, embedding.least_scale());
        high_ = keeps_lengths(options) ? 1 : options.max_scale;
        low_ = low_ * (1 - slack) - 1e-9;
        high_ = high_ * (1 + slack) + 1e-9;
        reflects_ = allows_reflections(options);
        if (anchor.kind == AnchorKind::parabola) per_radius_ = 1 / length(anchor.parabola.m);
    }

    void find(Batch& batch) const {
        if (anchor_.kind == AnchorKind::parabola) {
            return pass_parabolas(1, [&](const Seat& seat) {
                if (!batch.is_over()) batch.add(seat);
            });
        }
        find_on(carriers_of(0), batch);
    }

    // Of curves and places: the first element on these alone.
    void find_on(std::span<const std::uint32_t> slots, Batch& batch) const {
        switch (anchor_.kind) {
            case AnchorKind::parabola:
                for (const std::uint32_t slot : slots) {
                    add_parabola(design_.row(slot), [&](const Seat& seat) { batch.add(seat); });
                }
                return;
            case AnchorKind::cubic:
                return add_each(slots, batch,
                                [&](std::uint32_t slot, const Seat& seat) { return may_be_cubic(slot, seat); });
            case AnchorKind::ellipse:
                return add_each(slots, batch, [&](std::uint32_t slot, const Seat&) { return is_such_ellipse(slot); });
            case AnchorKind::place:
                for (const std::uint32_t slot : slots) batch.add({{slot}, false, false});
                return;
            case AnchorKind::places:
                return find_places(slots, batch);
            case AnchorKind::place_and_line:
                return find_place_and_line(slots, batch);
            case AnchorKind::crossing:
            case AnchorKind::lines:
                return find_lines(slots, batch);
        }
    }

    // The carriers that the first element may have by its kind.
    std::vector<std::uint32_t> carriers_among(std::span<const std::uint32_t> slots) const {
        return carriers_among(slots, 0);
    }

    double estimate() const {
        const auto count = [&](std::size_t i) { return static_cast<double>(design_.slots_of(part(i).kind).size()); };
        switch (anchor_.kind) {
            case AnchorKind::parabola: {
                constexpr std::size_t sample = 2000;
                const std::size_t stride = design_.parabolas().slots.size() / sample + 1;
                std::size_t found = 0;
                pass_parabolas(stride, [&](const Seat&) { ++found; });
                return static_cast<double>(found * stride);
            }
            case AnchorKind::cubic:
            case AnchorKind::ellipse:
                return 4 * count(0);
            case AnchorKind::place:
                return count(0);
            case AnchorKind::places:
            case AnchorKind::place_and_line:
                return 2 * count(0) * count(1);
            case AnchorKind::crossing:
            case AnchorKind::lines: {
                const double lines = count(0), met = 2 * static_cast<double>(design_.meetings()) / (lines + 1);
                double seats = 2 * lines * (anchor_.do_meet[0] ? met : lines);
                if (anchor_.kind == AnchorKind::lines) seats *= anchor_.do_meet[1] ? met : lines;
                return seats;
            }
        }
        return 0;
    }

private:
    const Element& part(std::size_t i) const { return embedding_.left().elements[anchor_.elements[i]]; }
    double reach(std::size_t i) const { return anchor_.reach[anchor_.elements[i]]; }
    bool is_scale(double scale) const { return scale >= low_ && scale <= high_; }
    bool may_carry(std::uint32_t slot, std::size_t i) const {
        return embedding_.may_carry(design_.glimpse(slot), part(i));
    }

    std::vector<std::uint32_t> carriers_among(std::span<const std::uint32_t> slots, std::size_t i) const {
        std::vector<std::uint32_t> carriers;
        for (const std::uint32_t slot : slots) {
            if (may_carry(slot, i) && is_circle(design_.element(slot)) == is_circle(part(i))) carriers.push_back(slot);
        }
        return carriers;
    }
    std::vector<std::uint32_t> carriers_of(std::size_t i) const {
        return carriers_among(design_.slots_of(part(i).kind), i);
    }

    template <class Add>
    void add_parabola(std::size_t row, Add&& add) const {
        const ParabolaTable& table = design_.parabolas();
        const double low = anchor_.parabola.low, high = anchor_.parabola.high, slack = reach(0);
        const double from = table.low[row] - slack * table.per_px_low[row];
        const double to = table.high[row] + slack * table.per_px_high[row];
        const bool is_direct = from <= low && high <= to;
        const bool is_opposite = reflects_ && from <= -high && -low <= to;
        if (!(is_direct || is_opposite) || !is_scale(table.radius[row] * per_radius_)) return;
        if (is_direct) add(Seat{{table.slots[row]}, false, false});
        if (is_opposite) add(Seat{{table.slots[row]}, true, false});
    }
    template <class Add>
    void pass_parabolas(std::size_t stride, Add&& add) const {
        for (std::size_t row = 0; row < design_.parabolas().slots.size(); row += stride) add_parabola(row, add);
    }

    // Both ways round and both reflections on each carrier of the first element, where `is_seat` says so.
    template <class IsSeat>
    void add_each(std::span<const std::uint32_t> slots, Batch& batch, IsSeat&& is_seat) const {
        for (const std::uint32_t slot : slots) {
            for (const bool is_reflected : {false, true}) {
                if (is_reflected && !reflects_) continue;
                for (const bool is_turned : {false, true}) {
                    const Seat seat{{slot}, is_reflected, is_turned};
                    if (!batch.is_over() && is_seat(slot, seat)) batch.add(seat);
                }
            }
        }
    }

    bool may_be_cubic(std::uint32_t slot, const Seat& seat) const {
        const CubicFrame& frame = design_.cubic_frame(slot);
        const auto rate = rate_between(anchor_.cubic, frame, seat.is_reflected, seat.is_turned);
        if (!rate) return false;
        // The part's interval, on the carrier; rough, since where a cubic is slow little is much.
        const double first = frame.origin - *rate * anchor_.cubic.origin, last = first + *rate;
        if (std::min(first, last) < -0.05 || std::max(first, last) > 1.05) return false;
        return is_scale(length(multiplier(anchor_.cubic, frame, *rate, seat.is_reflected)));
    }

    bool is_such_ellipse(std::uint32_t slot) const {
        const Element &own = part(0), &carrier = design_.element(slot);
        const double scale = length(carrier.at[1]) / length(own.at[1]);
        return is_scale(scale) && std::fabs(length(carrier.at[2]) - scale * length(own.at[2])) <= reach(0);
    }

    // Whether two lengths, each off by the reach at most, are of a scale that may be.
    bool is_stretched(double from, double to, double slack) const {
        return to >= low_ * from - slack && to <= high_ * from + slack && to > embedding_.options().tolerance;
    }
    // Whether a circle's radius goes with what two other lengths say of the scale; points have none.
    bool is_round(std::size_t i, std::uint32_t slot, double from, double to) const {
        if (part(i).kind == ElementKind::point) return true;
        return std::fabs(length(design_.element(slot).at[1]) - length(part(i).at[1]) * (to / from)) <= 4 * reach(i);
    }

    void find_places(std::span<const std::uint32_t> firsts, Batch& batch) const {
        const double apart = length(part(1).at[0] - part(0).at[0]), slack = reach(0) + reach(1);
        const std::vector<std::uint32_t> seconds = carriers_of(1);
        for (const std::uint32_t p : firsts) {
            for (const std::uint32_t q : seconds) {
                if (batch.is_over()) return;
                const double to = length(design_.element(q).at[0] - design_.element(p).at[0]);
                if (!is_stretched(apart, to, slack) || !is_round(0, p, apart, to) || !is_round(1, q, apart, to)) {
                    continue;
                }
                batch.add({{p, q}, false, false});
                if (reflects_) batch.add({{p, q}, true, false});
            }
        }
    }

    void find_place_and_line(std::span<const std::uint32_t> places, Batch& batch) const {
        const Vec place = part(0).at[0];
        const double off = length(place - foot_on(part(1), place)), slack = reach(0) + reach(1);
        const std::vector<std::uint32_t> lines = carriers_of(1);
        for (const std::uint32_t p : places) {
            const Vec to_place = design_.element(p).at[0];
            for (const std::uint32_t q : lines) {
                if (batch.is_over()) return;
                const double to = length(to_place - foot_on(design_.element(q), to_place));
                if (anchor_.is_on_line) {
                    if (to > slack) continue;
                } else if (!is_stretched(off, to, slack) || !is_round(0, p, off, to)) {
                    continue;
                }
                for (const bool is_reflected : {false, true}) {
                    if (is_reflected && !reflects_) continue;
                    batch.add({{p, q}, is_reflected, false});
                    if (anchor_.is_on_line) batch.add({{p, q}, is_reflected, true});
                }
            }
        }
    }

    // The angle between two lines, which have no direction: twice it, as a unit.
    static Vec angle_between(const Element& a, const Element& b) {
        const Vec turn = over(b.at[1] - b.at[0], a.at[1] - a.at[0]), twice = times(turn, turn);
        return twice * (1 / length(twice));
    }

    void find_lines(std::span<const std::uint32_t> lines, Batch& batch) const {
        const double tolerance = embedding_.options().tolerance;
        const Vec angle = angle_between(part(0), part(1));
        const bool has_third = anchor_.kind == AnchorKind::lines;
        const Vec other_angle = has_third ? angle_between(part(0), part(2)) : Vec{};
        const auto noise = [&](const Element& e) { return 40 * tolerance / length(e.at[1] - e.at[0]); };
        double slack = 1e-9 + noise(part(0)) + noise(part(1));
        if (has_third) slack += noise(part(2));
        const auto beside = [&](std::uint32_t a, bool do_meet) -> const std::vector<std::uint32_t>& {
            return do_meet ? design_.met_by(a) : design_.slots_of(ElementKind::line);
        };
        for (const std::uint32_t a : lines) {
            const Element& first = design_.element(a);
            for (const std::uint32_t b : beside(a, anchor_.do_meet[0])) {
                if (b == a || !may_carry(b, 1)) continue;
                const Element& second = design_.element(b);
                const Vec to = angle_between(first, second);
                const double own_slack = slack + noise(first) + noise(second);
                for (const bool is_reflected : {false, true}) {
                    if (is_reflected && !reflects_) continue;
                    if (length(to - (is_reflected ? conjugate(angle) : angle)) > own_slack) continue;
                    if (batch.is_over()) return;
                    if (!has_third) {
                        batch.add({{a, b}, is_reflected, false});
                        batch.add({{a, b}, is_reflected, true});
                        continue;
                    }
                    for (const std::uint32_t c : beside(a, anchor_.do_meet[1])) {
                        if (c == a || c == b || !may_carry(c, 2)) continue;
                        const Element& third = design_.element(c);
                        const Vec found = angle_between(first, third);
                        const Vec wanted = is_reflected ? conjugate(other_angle) : other_angle;
                        if (length(found - wanted) > own_slack + noise(third)) continue;
                        batch.add({{a, b, c}, is_reflected, false});
                    }
                }
            }
        }
    }

    const Embedding& embedding_;
    const MatchIndex& design_;
    const Anchor& anchor_;
    double low_ = 0, high_ = 0;  // of scales
    bool reflects_ = false;
    double per_radius_ = 0;
};

}  // namespace

void find_seats(const Embedding& embedding, const Anchor& anchor, const Take& take) {
    Batch batch(embedding.design(), take);
    Seats(embedding, anchor).find(batch);
    batch.flush();
}

void find_seats_on(const Embedding& embedding, const Anchor& curve, std::span<const std::uint32_t> slots,
                   const Take& take) {
    Batch batch(embedding.design(), take);
    const Seats seats(embedding, curve);
    seats.find_on(seats.carriers_among(slots), batch);
    batch.flush();
}

double estimated_seats(const Embedding& embedding, const Anchor& anchor) { return Seats(embedding, anchor).estimate(); }

}  // namespace filigree::curves
