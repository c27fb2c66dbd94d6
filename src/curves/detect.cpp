#include "curves/detect.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>

#include "base/elementary.h"
#include "curves/embedding.h"
#include "curves/pivot.h"
#include "curves/symmetry.h"

namespace filigree::curves {
namespace {

// From here on only those elements of a left side count that are curves with a frame.
bool has_frame(const Element& e) { return e.kind == ElementKind::parabola; }

double angle_of(const Transform& by) {
    const double degrees = elementary::atan2(by.b, by.a) * (180 / elementary::pi);
    const double rounded = std::round((degrees < 0 ? degrees + 360 : degrees) * 1e9) * 1e-9;
    return rounded >= 360 ? 0 : rounded;
}

// The order of matches. Rounding must not decide it, so all but the last are coarse.
struct Rank {
    double scale, x, y, angle;
    bool is_reflected;
    double exact_x, exact_y, exact_angle;

    auto key() const { return std::tie(scale, x, y, angle, is_reflected, exact_x, exact_y, exact_angle); }
};
Rank rank_of(const Match& match, double tolerance) {
    int exponent = 0;
    const double mantissa = std::frexp(match.scale, &exponent);
    const double per_px = 1 / (8 * tolerance);
    return {std::ldexp(std::round(mantissa * 0x1p24), exponent),
            std::round(match.centroid.x * per_px),
            std::round(match.centroid.y * per_px),
            std::round(match.angle_degrees * 1e6),
            match.is_reflected,
            match.centroid.x,
            match.centroid.y,
            match.angle_degrees};
}

void sort_by_rank(std::vector<Match>& matches, double tolerance) {
    std::vector<std::pair<Rank, std::size_t>> order;
    order.reserve(matches.size());
    for (std::size_t i = 0; i < matches.size(); ++i) order.emplace_back(rank_of(matches[i], tolerance), i);
    std::sort(order.begin(), order.end(), [](const auto& a, const auto& b) {
        const auto key = a.first.key(), other = b.first.key();
        return key != other ? key < other : a.second < b.second;
    });
    std::vector<Match> sorted;
    sorted.reserve(matches.size());
    for (const auto& [rank, i] : order) sorted.push_back(std::move(matches[i]));
    matches = std::move(sorted);
}

class Search {
public:
    Search(const Shape& left, const MatchIndex& design, const MatchOptions& options, std::vector<Symmetry> symmetries)
        : embedding_(left, design, options), symmetries_(std::move(symmetries)) {
        const double count = static_cast<double>(left.elements.size());
        for (const Vec middle : embedding_.middles()) centroid_ = centroid_ + middle * (1 / count);
        anchor_ = anchor();
    }

    Matches run() {
        if (!anchor_) return {};
        const std::optional<Pivot> pivot = rarest();
        if (!pivot) return {};
        std::vector<bool> is_known(2 * embedding_.design().slot_count(), false);
        const auto mark = [&](const Seat& seat) { return std::size_t{2} * seat.slot + seat.is_reflected; };
        constexpr std::size_t at_once = 64;
        const std::vector<Seat> seats = seats_of(embedding_, *pivot);
        std::array<Transform, at_once> by;
        std::vector<std::uint32_t> passed;
        for (std::size_t first = 0; first < seats.size() && matches_.is_complete; first += at_once) {
            const std::size_t count = std::min(at_once, seats.size() - first);
            for (std::size_t i = first + count; i < std::min(seats.size(), first + count + at_once); ++i) {
                embedding_.design().fetch_frame(seats[i].slot);
                embedding_.design().fetch_glimpse(seats[i].slot);
            }
            for (std::size_t i = 0; i < count; ++i)
                by[i] = to_transform(carrying(embedding_, *pivot, seats[first + i]));
            embedding_.sift({by.data(), count}, pivot->reach, passed);
            for (const std::uint32_t i : passed) {
                const Seat& seat = seats[first + i];
                if (is_known[mark(seat)]) continue;
                laid_.by = by[i];
                if (!embedding_.settle(laid_, pivot->reach)) continue;
                take(*pivot, seat);
                // A symmetry of the left side carries the pivot onto another element, and so to another seat.
                for (const Symmetry& g : symmetries_) {
                    is_known[mark({laid_.carriers[g.images[pivot->element]], seat.is_reflected != g.is_reflected})] =
                        true;
                }
            }
            if (is_cancelled(embedding_.options().job)) matches_.is_complete = false;
            if (matches_.found.size() >= embedding_.options().limit) matches_.is_complete = false;
        }
        return std::move(matches_);
    }

private:
    // The element from which the transforms of all matches are computed in the end: by the left side alone, so that a
    // match is the same to the last bit however it was found.
    std::optional<Pivot> anchor() const {
        const std::vector<Element>& elements = embedding_.left().elements;
        std::optional<std::uint32_t> best;
        for (std::uint32_t i = 0; i < elements.size(); ++i) {
            if (!has_frame(elements[i])) continue;
            if (!best || looseness(elements[i]) < looseness(elements[*best])) best = i;
        }
        if (!best) return std::nullopt;
        return pivot_at(embedding_, *best);
    }

    // The element with the fewest seats, where a loose one counts for more; sets the order of all.
    std::optional<Pivot> rarest() {
        const std::vector<Element>& elements = embedding_.left().elements;
        std::optional<Pivot> best;
        double best_cost = 0;
        std::vector<std::pair<double, std::uint32_t>> order;
        for (std::uint32_t i = 0; i < elements.size(); ++i) {
            if (!has_frame(elements[i])) {
                order.emplace_back(embedding_.design().slots_of(elements[i].kind).size(), i);
                continue;
            }
            Pivot pivot = pivot_at(embedding_, i);
            const double seats = estimated_seats(embedding_, pivot);
            order.emplace_back(seats, i);
            const auto [first, last] = ends_of(elements[i]);
            const double cost = (seats + 1) * (1 + 100 * pivot.reach[i] / length(last - first));
            if (best && !(cost < best_cost || (cost == best_cost && i == anchor_->element))) continue;
            best = std::move(pivot);
            best_cost = cost;
        }
        std::sort(order.begin(), order.end());
        // The pivot lies on its seat for sure, so it is asked for last.
        std::vector<std::uint32_t> asked;
        for (const auto& [seats, i] : order) {
            if (!best || i != best->element) asked.push_back(i);
        }
        if (best) asked.push_back(best->element);
        embedding_.ask_in(std::move(asked));
        return best;
    }

    // Puts the match that laid_ stands for among the others, as the one of its coset that does not reflect where there
    // is one, and is turned least.
    void take(const Pivot& pivot, const Seat& seat) {
        Laid laid = laid_;
        bool is_reflected = seat.is_reflected;
        double angle = angle_of(laid.by);
        const Symmetry* best = nullptr;
        if (symmetries_.size() > 1) {
            const auto rank = [](bool reflects, double degrees) {
                return std::pair(reflects, std::round(degrees * 1e6));
            };
            for (const Symmetry& g : symmetries_) {
                const Transform by = compose(laid_.by, g.by);
                const bool reflects = seat.is_reflected != g.is_reflected;
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
        if (best != nullptr || pivot.element != anchor_->element || !is_exact(laid.misfit, tolerance())) {
            laid.by = to_transform(carrying(embedding_, *anchor_, {laid.carriers[anchor_->element], is_reflected}));
            const double reach = *std::max_element(anchor_->reach.begin(), anchor_->reach.end());
            auto misfit = embedding_.misfit_on(laid, 2 * reach);
            if (!misfit || !is_exact(*misfit, tolerance())) {
                embedding_.refine(laid);
                misfit = embedding_.misfit_on(laid, 20 * tolerance());
            }
            if (!misfit) return;
            laid.misfit = *misfit;
            angle = angle_of(laid.by);
        }
        if (laid.misfit > 10 * tolerance()) return;
        Match match;
        match.by = laid.by;
        match.is_reflected = is_reflected;
        match.scale = length(Vec{laid.by.a, laid.by.b});
        match.angle_degrees = angle;
        match.centroid = apply(laid.by, centroid_);
        match.carriers = std::move(laid.carriers);
        match.misfit = laid.misfit / tolerance();
        match.is_ambiguous = match.misfit > 0.1;
        (match.misfit <= 1 ? matches_.found : matches_.near_misses).push_back(std::move(match));
    }

    double tolerance() const { return embedding_.options().tolerance; }

    Embedding embedding_;
    std::vector<Symmetry> symmetries_;
    Vec centroid_;
    std::optional<Pivot> anchor_;
    Laid laid_;
    Matches matches_;
};

Matches sorted(Matches matches, double tolerance) {
    sort_by_rank(matches.found, tolerance);
    sort_by_rank(matches.near_misses, tolerance);
    return matches;
}

Symmetry identity_of(const Shape& shape) {
    Symmetry g;
    for (std::uint32_t i = 0; i < shape.elements.size(); ++i) g.images.push_back(i);
    return g;
}

}  // namespace

std::vector<Symmetry> symmetries(const Shape& shape, const MatchOptions& options) {
    MatchOptions own = options;
    own.group = options.group == MatchGroup::similarity ? MatchGroup::isometry : options.group;
    own.weights = WeightRule::equal;
    own.limit = SIZE_MAX;
    const MatchIndex index(shape);
    Matches matches = Search(shape, index, own, {identity_of(shape)}).run();
    std::sort(matches.found.begin(), matches.found.end(), [](const Match& a, const Match& b) {
        return std::pair(a.is_reflected, a.angle_degrees) < std::pair(b.is_reflected, b.angle_degrees);
    });
    std::vector<Symmetry> found;
    for (Match& match : matches.found) found.push_back({match.by, match.is_reflected, std::move(match.carriers)});
    if (found.empty()) found.push_back(identity_of(shape));
    return found;
}

Matches find_matches(const Shape& left, const MatchIndex& design, const MatchOptions& options) {
    return sorted(Search(left, design, options, symmetries(left, options)).run(), options.tolerance);
}

}  // namespace filigree::curves
