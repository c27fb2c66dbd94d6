// A left side laid onto a design by a transform: on which elements it lies, and how well.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "curves/match.h"
#include "curves/match_index.h"
#include "curves/refine.h"
#include "curves/shape.h"

namespace filigree::curves {

// Where a left side lies.
struct Laid {
    Transform by;
    std::vector<std::uint32_t> carriers;  // the slot of the design for each left element
    double misfit = 0;                    // px; of the element that fits worst
};

class Embedding {
public:
    // All three must outlive it.
    Embedding(const Shape& left, const MatchIndex& design, const MatchOptions& options);

    const Shape& left() const { return left_; }
    const MatchIndex& design() const { return design_; }
    const MatchOptions& options() const { return options_; }
    // A point of each left element, half way along it.
    const std::vector<Vec>& middles() const { return middles_; }
    // Below this scale an element of the left side would be no longer than the tolerance, and lie on anything.
    double least_scale() const { return least_scale_; }
    // The order in which the left elements are asked for; those that are rare in the design should come first.
    void ask_in(std::vector<std::uint32_t> order) { order_ = std::move(order); }

    // By kind, layer and weight.
    bool may_carry(const Glimpse& carrier, const Element& part) const;
    // Finds the best carriers under laid.by, each within its own reach, px. False where a left element has none; what
    // else stands in `laid` is then void.
    bool lay(Laid& laid, std::span<const double> reach) const;
    // Which of some transforms may pass lay(), by the element that is asked for first; indices, ascending. For many at
    // once, since the memory is then asked for all before any is waited for.
    void sift(std::span<const Transform> by, std::span<const double> reach, std::vector<std::uint32_t>& passed) const;
    // The same as lay(), but first mends laid.by by all elements where that is called for, and accepts what is within
    // ten tolerances.
    bool settle(Laid& laid, std::span<const double> reach) const;
    // The misfit on the carriers that are given; nothing where one is beyond `reach`.
    std::optional<double> misfit_on(const Laid& laid, double reach) const;
    // Mends laid.by for its carriers.
    void refine(Laid& laid) const;
    // What is laid, as a match.
    Match match_of(Laid laid, bool is_reflected) const;

private:
    const Shape& left_;
    const MatchIndex& design_;
    const MatchOptions& options_;
    std::vector<Vec> middles_;
    Vec centroid_;  // of the left side; its symmetries keep it
    double least_scale_ = 0;
    std::vector<std::uint32_t> order_;
    std::vector<double> ten_tolerances_;
    mutable std::vector<std::pair<std::uint32_t, std::uint32_t>> to_sift_;  // a transform and a slot
    mutable std::vector<Vec> places_;
};

// Whether a match this good needs no mending: a transform from one element alone then serves as it is.
inline bool is_exact(double misfit, double tolerance) { return misfit <= 0.05 * tolerance; }

}  // namespace filigree::curves
