#include "curves/embedding.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "curves/along.h"
#include "curves/match_order.h"
#include "curves/moments.h"
#include "curves/weights.h"

namespace filigree::curves {
namespace {

// Whether a point that lies on a part may come within the reach of its carrier; rough, but quick, and never wrongly no.
bool comes_near(const Glimpse& carrier, Vec at, double reach) {
    const double squared = 4 * reach * reach;
    if (carrier.kind == ElementKind::parabola) {
        const Vec a = carrier.a, b = carrier.b;
        const double ab = cross(a, b), t = cross(a, at - carrier.at) / ab;
        const Vec off = point_at(carrier, t) - at, way = b + a * (2 * t);
        // `off` is along the axis; what counts is across the curve.
        if (dot(off, off) * (ab * ab) > squared * dot(a, a) * dot(way, way)) return false;
        const double beyond = t < 0 ? -t : t - 1;
        const Vec end = t < 0 ? b : b + a * 2;
        return !(beyond > 0 && beyond * beyond * dot(end, end) > squared);
    }
    if (carrier.kind == ElementKind::line) {
        const double off = cross(carrier.b, at - carrier.at);
        return off * off <= squared * dot(carrier.b, carrier.b);
    }
    return true;
}

}  // namespace

Embedding::Embedding(const Shape& left, const MatchIndex& design, const MatchOptions& options)
    : left_(left), design_(design), options_(options), ten_tolerances_(left.elements.size(), 10 * options.tolerance) {
    order_.resize(left.elements.size());
    std::iota(order_.begin(), order_.end(), 0U);
    middles_.reserve(left.elements.size());
    centroid_ = centroid_of(left);
    for (const Element& e : left.elements) {
        const Interval on = interval_of(e);
        middles_.push_back(point_at(e, 0.5 * (on.from + on.to)));
        if (e.kind == ElementKind::point) continue;
        const Bounds box = bounds_of(e);
        least_scale_ = std::max(least_scale_, 2 * options.tolerance / length(box.max - box.min));
    }
}

bool Embedding::may_carry(const Glimpse& carrier, const Element& part) const {
    if (carrier.kind != part.kind || carrier.layer != part.layer) return false;
    return is_heavy_enough(carrier.weight, part.weight, options_.weights);
}

bool Embedding::lay(Laid& laid, std::span<const double> reach) const {
    laid.carriers.resize(left_.elements.size());
    laid.misfit = 0;
    for (const std::uint32_t i : order_) {
        const Element& own = left_.elements[i];
        const Vec middle = apply(laid.by, middles_[i]);
        Element part;
        bool is_moved = false;
        double best = reach[i];
        std::uint32_t carrier = UINT32_MAX;
        design_.grid().visit_near(middle, reach[i], [&](std::uint32_t slot) {
            const Glimpse& glimpse = design_.glimpse(slot);
            if (!may_carry(glimpse, own) || !comes_near(glimpse, middle, best)) return;
            if (!is_moved) part = transformed(own, laid.by);
            is_moved = true;
            const auto off = misfit(design_.element(slot), part, best);
            if (!off || (*off == best && slot > carrier)) return;
            best = *off;
            carrier = slot;
        });
        if (carrier == UINT32_MAX) return false;
        laid.carriers[i] = carrier;
        laid.misfit = std::max(laid.misfit, best);
    }
    return true;
}

void Embedding::sift(std::span<const Transform> by, std::span<const double> reach,
                     std::vector<std::uint32_t>& passed) const {
    passed.clear();
    places_.clear();
    to_sift_.clear();
    const std::uint32_t first = order_.front();
    for (const Transform& t : by) {
        places_.push_back(apply(t, middles_[first]));
        design_.grid().fetch(places_.back());
    }
    for (std::uint32_t i = 0; i < by.size(); ++i) {
        design_.grid().visit_near(places_[i], reach[first], [&](std::uint32_t slot) {
            to_sift_.emplace_back(i, slot);
            design_.fetch_glimpse(slot);
        });
    }
    for (const auto& [i, slot] : to_sift_) {
        if (!passed.empty() && passed.back() == i) continue;
        const Glimpse& glimpse = design_.glimpse(slot);
        if (may_carry(glimpse, left_.elements[first]) && comes_near(glimpse, places_[i], reach[first])) {
            passed.push_back(i);
        }
    }
}

std::optional<double> Embedding::misfit_on(const Laid& laid, double reach) const {
    double most = 0;
    for (std::size_t i = 0; i < laid.carriers.size(); ++i) {
        const auto off = misfit(design_.element(laid.carriers[i]), transformed(left_.elements[i], laid.by), reach);
        if (!off) return std::nullopt;
        most = std::max(most, *off);
    }
    return most;
}

void Embedding::refine(Laid& laid) const {
    std::vector<Pairing> pairs;
    pairs.reserve(laid.carriers.size());
    for (std::size_t i = 0; i < laid.carriers.size(); ++i) {
        pairs.push_back({&left_.elements[i], &design_.element(laid.carriers[i])});
    }
    laid.by = refined(laid.by, options_.group, pairs);
}

bool Embedding::settle(Laid& laid, std::span<const double> reach) const {
    if (!lay(laid, reach)) return false;
    if (is_exact(laid.misfit, options_.tolerance)) return true;
    // With better carriers the transform may become better once more.
    for (int round = 0; round < 3; ++round) {
        const std::vector<std::uint32_t> before = laid.carriers;
        refine(laid);
        if (!lay(laid, ten_tolerances_)) return false;
        if (laid.carriers == before) break;
    }
    return true;
}

Match Embedding::match_of(Laid laid, bool is_reflected) const {
    Match match;
    match.by = laid.by;
    match.is_reflected = is_reflected;
    match.scale = options_.group == MatchGroup::similarity ? length(Vec{laid.by.a, laid.by.b})
                  : options_.group == MatchGroup::affine   ? std::sqrt(std::fabs(determinant(laid.by)))
                                                           : 1;
    match.angle_degrees = angle_of(laid.by);
    match.centroid = apply(laid.by, centroid_);
    match.carriers = std::move(laid.carriers);
    match.misfit = laid.misfit / options_.tolerance;
    match.is_ambiguous = match.misfit > 0.1;
    return match;
}

}  // namespace filigree::curves
