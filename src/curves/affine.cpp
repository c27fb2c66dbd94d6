#include "curves/affine.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "curves/affine_frame.h"
#include "curves/along.h"
#include "curves/embedding.h"
#include "curves/match_order.h"
#include "curves/weights.h"

namespace filigree::curves {
namespace {

// How far each left element may be off its carrier before the map is mended by all of them.
std::vector<double> reach_of(const Shape& left, const AffineFrame& frame, double tolerance) {
    const double longest = std::max(
        {length(frame.at[1] - frame.at[0]), length(frame.at[2] - frame.at[0]), length(frame.at[2] - frame.at[1])});
    std::vector<double> reach;
    for (const Element& e : left.elements) {
        const double lever = std::max(1.0, farthest_from(e, frame.at[0]) / longest) / frame.roundness;
        reach.push_back(tolerance * (10 + 4 * lever));
    }
    return reach;
}

bool may_lie_on(const Element& own, const Element& carrier, WeightRule weights) {
    return own.kind == carrier.kind && own.layer == carrier.layer &&
           is_heavy_enough(carrier.weight, own.weight, weights);
}

// Whether a map leaves an area: its image of the frame is no line to within the tolerance, and no element becomes as
// short as that.
bool keeps_area(const Shape& left, const AffineSeat& seat, const Transform& by, double tolerance) {
    const Vec u = seat.at[1] - seat.at[0], v = seat.at[2] - seat.at[0];
    const double longest = std::max({length(u), length(v), length(v - u)});
    if (!(std::fabs(cross(u, v)) > 20 * tolerance * longest)) return false;
    return std::all_of(left.elements.begin(), left.elements.end(), [&](const Element& e) {
        return e.kind == ElementKind::point || rough_length(transformed(e, by)) > 4 * tolerance;
    });
}

double scale_of(const Transform& by) { return std::sqrt(std::fabs(determinant(by))); }

// Which of the maps that differ by a symmetry is told: one that does not reflect, then the one that turns least, then
// the one that shears least.
auto preference_of(const Transform& by) {
    const auto rounded = [](double v) { return std::round(v * 1e6); };
    return std::tuple(determinant(by) < 0, rounded(angle_of(by)), rounded(std::fabs(by.c + by.b)), rounded(by.a),
                      rounded(by.b), rounded(by.c), rounded(by.d));
}

class AffineSearch {
public:
    AffineSearch(const Shape& left, const MatchIndex& design, const MatchOptions& options, const AffineFrame& frame,
                 std::span<const Symmetry> symmetries)
        : embedding_(left, design, options), frame_(frame), symmetries_(symmetries) {
        reach_ = reach_of(left, frame, options.tolerance);
    }

    Matches run(const Registrations& own, const Registrations& design) {
        const MayCarry may_carry = [&](std::uint32_t element, std::uint32_t slot) {
            return may_lie_on(left().elements[element], embedding_.design().element(slot), options().weights);
        };
        ask_for_the_rest_first(own);
        find_seats(frame_, own, design, may_carry, [&](const AffineSeat& seat) { return try_seat(seat); });
        put_in_order(matches_.found, options().tolerance);
        put_in_order(matches_.near_misses, options().tolerance);
        return std::move(matches_);
    }

private:
    const Shape& left() const { return embedding_.left(); }
    const MatchOptions& options() const { return embedding_.options(); }

    // Elements whose carriers a seat tells are tested on them before any is looked up.
    void ask_for_the_rest_first(const Registrations& own) {
        std::vector<bool> is_bound(left().elements.size(), false);
        for (const std::uint32_t point : frame_.points) {
            for (const std::uint32_t element : own.points[point].elements) is_bound[element] = true;
        }
        std::vector<std::uint32_t> order;
        for (const bool bound : {false, true}) {
            for (std::uint32_t i = 0; i < is_bound.size(); ++i) {
                if (is_bound[i] == bound) order.push_back(i);
            }
        }
        embedding_.ask_in(std::move(order));
    }

    bool try_seat(const AffineSeat& seat) {
        if (++tried_ % 1024 == 0 && is_cancelled(options().job)) return stop();
        const Transform by = carrying(frame_.at, seat.at);
        if (!(determinant(by) > 0) && !options().with_reflections) return true;
        const double scale = scale_of(by);
        if (!(scale >= options().min_scale * (1 - 1e-9) && scale <= options().max_scale * (1 + 1e-9))) return true;
        for (std::size_t i = 0; i < seat.carriers.size(); ++i) {
            if (seat.carriers[i] == AffineSeat::unbound) continue;
            const Element& carrier = embedding_.design().element(seat.carriers[i]);
            if (!misfit(carrier, transformed(left().elements[i], by), reach_[i])) return true;
        }
        if (!keeps_area(left(), seat, by, options().tolerance)) return true;
        laid_.by = by;
        if (!embedding_.settle(laid_, reach_)) return true;
        take();
        return matches_.found.size() < options().limit || stop();
    }

    bool stop() {
        matches_.is_complete = false;
        return false;
    }

    void take() {
        const Symmetry* best = nullptr;
        auto preference = preference_of(laid_.by);
        for (const Symmetry& g : symmetries_) {
            const auto other = preference_of(compose(laid_.by, g.by));
            if (!(other < preference)) continue;
            best = &g;
            preference = other;
        }
        Laid laid = laid_;
        if (best != nullptr) {
            laid.by = compose(laid_.by, best->by);
            for (std::size_t i = 0; i < laid.carriers.size(); ++i) laid.carriers[i] = laid_.carriers[best->images[i]];
            // Of a left side that is symmetric to within the tolerance alone.
            const auto misfit = embedding_.misfit_on(laid, 10 * options().tolerance);
            if (misfit) {
                laid.misfit = *misfit;
            } else {
                laid = laid_;
            }
        }
        const bool is_reflected = determinant(laid.by) < 0;
        Match match = embedding_.match_of(std::move(laid), is_reflected);
        (match.misfit <= 1 ? matches_.found : matches_.near_misses).push_back(std::move(match));
    }

    Embedding embedding_;
    AffineFrame frame_;
    std::span<const Symmetry> symmetries_;
    std::vector<double> reach_;
    Laid laid_;
    std::size_t tried_ = 0;
    Matches matches_;
};

Symmetry identity_of(const Shape& shape) {
    Symmetry g;
    for (std::uint32_t i = 0; i < shape.elements.size(); ++i) g.images.push_back(i);
    return g;
}

// Onto which elements of its own a map carries a shape; nothing where one is none.
std::optional<std::vector<std::uint32_t>> images_of(const Shape& shape, const Transform& by, const AffineSeat& seat,
                                                    double tolerance) {
    std::vector<std::uint32_t> images = seat.carriers;
    for (std::uint32_t i = 0; i < images.size(); ++i) {
        const Element moved = transformed(shape.elements[i], by);
        double best = tolerance;
        const auto look_at = [&](std::uint32_t j) {
            const Element& carrier = shape.elements[j];
            if (!may_lie_on(moved, carrier, WeightRule::equal)) return;
            const auto off = misfit(carrier, moved, best);
            if (!off) return;
            best = *off;
            images[i] = j;
        };
        const std::uint32_t known = std::exchange(images[i], AffineSeat::unbound);
        if (known != AffineSeat::unbound) {
            look_at(known);
        } else {
            for (std::uint32_t j = 0; j < images.size(); ++j) look_at(j);
        }
        if (images[i] == AffineSeat::unbound) return std::nullopt;
    }
    return images;
}

std::vector<Symmetry> symmetries_by(const Shape& shape, const Registrations& own, const AffineFrame& frame,
                                    const MatchOptions& options) {
    const MayCarry may_carry = [&](std::uint32_t i, std::uint32_t j) {
        return may_lie_on(shape.elements[i], shape.elements[j], WeightRule::equal);
    };
    std::vector<Symmetry> found = {identity_of(shape)};
    find_seats(frame, own, own, may_carry, [&](const AffineSeat& seat) {
        const Transform by = carrying(frame.at, seat.at);
        const bool is_reflected = determinant(by) < 0;
        if (is_reflected && !options.with_reflections) return true;
        // A map that makes a bounded shape larger or smaller does not carry it onto itself.
        if (!(std::fabs(scale_of(by) - 1) < 1e-3)) return true;
        const auto images = images_of(shape, by, seat, options.tolerance);
        if (!images) return true;
        const auto is_same = [&](const Symmetry& g) {
            const auto near = [](double a, double b) { return std::fabs(a - b) < 1e-4; };
            return near(g.by.a, by.a) && near(g.by.b, by.b) && near(g.by.c, by.c) && near(g.by.d, by.d);
        };
        if (std::none_of(found.begin(), found.end(), is_same)) found.push_back({by, is_reflected, *images});
        return true;
    });
    std::sort(found.begin() + 1, found.end(),
              [](const Symmetry& a, const Symmetry& b) { return preference_of(a.by) < preference_of(b.by); });
    return found;
}

}  // namespace

bool fixes_affine_maps(const Shape& left, double tolerance) {
    const Registrations own = registrations_of(left, tolerance);
    return frame_of(left, own, own).has_value();
}

std::vector<Symmetry> affine_symmetries(const Shape& shape, const MatchOptions& options) {
    const Registrations own = registrations_of(shape, options.tolerance);
    const auto frame = frame_of(shape, own, own);
    return frame ? symmetries_by(shape, own, *frame, options) : std::vector<Symmetry>{identity_of(shape)};
}

AffineMatches find_affine_matches(const Shape& left, const MatchIndex& design, const MatchOptions& options) {
    MatchOptions affine = options;
    affine.group = MatchGroup::affine;
    const Registrations own = registrations_of(left, options.tolerance);
    const Registrations places = registrations_of(design, left, own, options.tolerance);
    const auto frame = frame_of(left, own, places);
    if (!frame) return {{}, true};
    const std::vector<Symmetry> symmetries = affine_symmetries(left, affine);
    return {AffineSearch(left, design, affine, *frame, symmetries).run(own, places), false};
}

}  // namespace filigree::curves
