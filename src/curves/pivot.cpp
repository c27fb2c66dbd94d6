#include "curves/pivot.h"

#include <algorithm>
#include <cmath>

namespace filigree::curves {
namespace {

// The farthest that an element comes from a place.
double farthest(const Element& e, Vec from) {
    const Bounds box = bounds_of(e);
    const Vec far{std::max(from.x - box.min.x, box.max.x - from.x), std::max(from.y - box.min.y, box.max.y - from.y)};
    return length(far);
}

// The window of |m| that the group and the options leave, where the pivot's end may be off by `reach`.
struct Window {
    double low = 0, high = 0;
};
Window scales_of(const Embedding& embedding, const Pivot& pivot) {
    const MatchOptions& options = embedding.options();
    Window window{std::max(options.min_scale, embedding.least_scale()), options.max_scale};
    if (options.group == MatchGroup::isometry || options.group == MatchGroup::translation) window = {1, 1};
    const auto [first, last] = ends_of(embedding.left().elements[pivot.element]);
    const double slack = pivot.reach[pivot.element] / length(last - first);
    return {window.low * (1 - slack) - 1e-9, window.high * (1 + slack) + 1e-9};
}

bool allows_reflections(const MatchOptions& options) {
    return options.with_reflections && options.group != MatchGroup::translation;
}

// A pass over the rows of the table, each `stride`: calls take(row, is_reflected) where the pivot's interval lies in
// the row's, to within its reach.
template <class Take>
void pass(const Embedding& embedding, const Pivot& pivot, std::size_t stride, Take&& take) {
    const ParabolaTable& table = embedding.design().parabolas();
    const double reach = pivot.reach[pivot.element], low = pivot.frame.low, high = pivot.frame.high;
    const Window scales = scales_of(embedding, pivot);
    const double radius = length(pivot.frame.m);
    const bool reflects = allows_reflections(embedding.options());
    for (std::size_t row = 0; row < table.slots.size(); row += stride) {
        const double from = table.low[row] - reach * table.per_px_low[row];
        const double to = table.high[row] + reach * table.per_px_high[row];
        const bool is_direct = from <= low && high <= to, is_opposite = from <= -high && -low <= to;
        if (!(is_direct || is_opposite)) continue;
        const double scale = table.radius[row] / radius;
        if (!(scale >= scales.low && scale <= scales.high)) continue;
        if (is_direct) take(row, false);
        if (is_opposite && reflects) take(row, true);
    }
}

}  // namespace

Pivot pivot_at(const Embedding& embedding, std::uint32_t element) {
    const Element& own = embedding.left().elements[element];
    Pivot pivot{element, frame_of(own), {}};
    const auto [first, last] = ends_of(own);
    const double chord = length(last - first), loose = looseness(own), tolerance = embedding.options().tolerance;
    for (const Element& e : embedding.left().elements) {
        const double lever = std::max(1.0, farthest(e, embedding.middles()[element]) / chord);
        pivot.reach.push_back(tolerance * (10 + 0.2 * loose * lever));
    }
    return pivot;
}

std::vector<Seat> seats_of(const Embedding& embedding, const Pivot& pivot) {
    std::vector<Seat> seats;
    const std::vector<std::uint32_t>& slots = embedding.design().parabolas().slots;
    pass(embedding, pivot, 1, [&](std::size_t row, bool is_reflected) { seats.push_back({slots[row], is_reflected}); });
    return seats;
}

double estimated_seats(const Embedding& embedding, const Pivot& pivot) {
    constexpr std::size_t sample = 2000;
    const std::size_t stride = embedding.design().parabolas().slots.size() / sample + 1;
    std::size_t count = 0;
    pass(embedding, pivot, stride, [&](std::size_t, bool) { ++count; });
    return static_cast<double>(count * stride);
}

bool has_seat(const Embedding& embedding, const Pivot& pivot, Seat seat) {
    if (seat.is_reflected && !allows_reflections(embedding.options())) return false;
    const ParabolaFrame& frame = embedding.design().frame(seat.slot);
    const double reach = pivot.reach[pivot.element];
    const double from = frame.low - reach * slope_per_px(frame, frame.low);
    const double to = frame.high + reach * slope_per_px(frame, frame.high);
    const double low = seat.is_reflected ? -pivot.frame.high : pivot.frame.low;
    const double high = seat.is_reflected ? -pivot.frame.low : pivot.frame.high;
    const Window scales = scales_of(embedding, pivot);
    const double scale = length(frame.m) / length(pivot.frame.m);
    return from <= low && high <= to && scale >= scales.low && scale <= scales.high;
}

Similarity carrying(const Embedding& embedding, const Pivot& pivot, Seat seat) {
    const Glimpse& carrier = embedding.design().glimpse(seat.slot);
    const ParabolaFrame& frame = embedding.design().frame(seat.slot);
    Vec m = multiplier(pivot.frame, frame, seat.is_reflected);
    if (embedding.options().group == MatchGroup::isometry) m = m * (1 / length(m));
    if (embedding.options().group == MatchGroup::translation) m = {1, 0};
    // By the middle of the part, not by the vertices: those may lie far away and be known badly.
    const double slope = 0.5 * (pivot.frame.low + pivot.frame.high);
    const Vec from = embedding.middles()[pivot.element];
    const Vec to = point_at(carrier, parameter_at(frame, seat.is_reflected ? -slope : slope));
    return carrying(from, to, m, seat.is_reflected);
}

}  // namespace filigree::curves
