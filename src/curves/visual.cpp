#include "curves/visual.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "base/elementary.h"
#include "curves/contacts.h"
#include "curves/detect.h"
#include "curves/explain_candidates.h"
#include "curves/match_order.h"
#include "curves/moments.h"
#include "curves/nearest.h"
#include "curves/similarity.h"
#include "curves/symmetry.h"
#include "curves/weights.h"

namespace filigree::curves {
namespace {

constexpr std::size_t most_candidates = 200000;
constexpr double most_sine = 0.35;  // between the directions of what looks alike

// A point of a part with the design's point that is nearest to it, on a curve that may carry it and runs as it does.
struct Sample {
    Vec at, foot;
    std::uint32_t slot = 0;
    double t = 0, distance = 0;
};

std::optional<Sample> sample_at(const Element& part, double t, const MatchIndex& design, double reach,
                                WeightRule weights) {
    Sample sample;
    sample.at = point_at(part, t);
    sample.distance = reach;
    const Vec way = velocity_at(part, t);
    bool is_found = false;
    design.grid().visit_near(sample.at, reach, [&](std::uint32_t slot) {
        const Element& carrier = design.element(slot);
        if (carrier.layer != part.layer || (carrier.kind == ElementKind::point) != (part.kind == ElementKind::point)) {
            return;
        }
        if (!is_heavy_enough(carrier.weight, part.weight, weights)) return;
        const Foot foot = foot_on(carrier, sample.at);
        if (!(foot.distance <= sample.distance)) return;
        if (is_found && foot.distance == sample.distance && slot >= sample.slot) return;
        if (part.kind != ElementKind::point) {
            const Vec other = velocity_at(carrier, foot.t);
            if (!(std::fabs(cross(way, other)) <= most_sine * length(way) * length(other))) return;
        }
        sample.foot = point_at(carrier, foot.t);
        sample.slot = slot;
        sample.t = foot.t;
        sample.distance = foot.distance;
        is_found = true;
    });
    if (!is_found) return std::nullopt;
    return sample;
}

double parameter_of(const Element& part, int i, int count) {
    const Interval on = interval_of(part);
    return count < 2 ? on.from : on.from + (on.to - on.from) * i / (count - 1);
}

// What looks may be laid by: ends and contacts.
std::vector<Vec> marks_on(const Element& e, std::span<const Element> others, double reach) {
    std::vector<Vec> marks;
    const auto add = [&](Vec p) {
        if (std::none_of(marks.begin(), marks.end(), [&](Vec q) { return length(p - q) <= 1e-9; })) marks.push_back(p);
    };
    if (!is_closed(e)) {
        const auto [first, last] = ends_of(e);
        add(first);
        add(last);
    }
    for (const Element& other : others) {
        for (const Contact& contact : contacts_of(e, other, reach)) add(contact.at);
        // What goes on where this ends goes on to its other end.
        const auto [first, last] = ends_of(e);
        const auto [other_first, other_last] = ends_of(other);
        for (const Vec end : {first, last}) {
            if (length(other_first - end) <= reach) add(other_last);
            if (length(other_last - end) <= reach) add(other_first);
        }
    }
    return marks;
}

class LookAlikes {
public:
    LookAlikes(const Shape& left, const MatchIndex& design, const MatchOptions& options)
        : left_(left), design_(design), options_(options), centroid_(centroid_of(left)) {
        if (options_.group == MatchGroup::affine) options_.group = MatchGroup::similarity;
        const Bounds box = bounds_of(left.elements);
        corners_ = {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
    }

    Matches run() {
        symmetries_ = symmetries(left_, options_);
        Matches exact = find_matches(left_, design_, options_);
        const Candidates partial = partial_embeddings(left_, design_, options_, std::nullopt);
        matches_.is_complete = exact.is_complete && partial.is_complete;
        for (const Transform& by : partial.by) try_map(by);
        lay_by_marks();
        return distinct(exact.found);
    }

private:
    double reach() const { return options_.visual_tolerance; }

    // The widest pair of each left element onto all pairs of each element of the design.
    void lay_by_marks() {
        std::vector<std::vector<Vec>> marks(design_.slot_count());
        for (std::uint32_t slot = 0; slot < marks.size(); ++slot) {
            if (!design_.is_taken(slot) || design_.element(slot).kind == ElementKind::point) continue;
            std::vector<Element> others;
            for (const std::uint32_t other : design_.grid().found_along(design_.element(slot), reach())) {
                if (other != slot) others.push_back(design_.element(other));
            }
            marks[slot] = marks_on(design_.element(slot), others, reach());
        }
        for (const Element& own : left_.elements) {
            if (own.kind == ElementKind::point || is_closed(own)) continue;
            const auto [p, q] = ends_of(own);
            if (!(length(q - p) > 0)) continue;
            for (const std::vector<Vec>& places : marks) {
                for (const Vec to_p : places) {
                    for (const Vec to_q : places) {
                        if (to_p != to_q) lay(p, q, to_p, to_q);
                    }
                }
                if (is_cancelled(options_.job) || tried_ >= most_candidates) {
                    matches_.is_complete = false;
                    return;
                }
            }
        }
    }

    void lay(Vec p, Vec q, Vec to_p, Vec to_q) {
        for (const bool is_reflected : {false, true}) {
            if (is_reflected && !allows_reflections(options_)) continue;
            Vec m = over(to_q - to_p, is_reflected ? conjugate(q - p) : q - p);
            if (options_.group == MatchGroup::translation) m = {1, 0};
            if (options_.group == MatchGroup::isometry) m = m * (1 / length(m));
            try_map(to_transform(carrying(p, to_p, m, is_reflected)));
        }
    }

    bool is_allowed(const Transform& by) const {
        const double size = determinant(by), scale = std::sqrt(std::fabs(size));
        if (!std::isfinite(scale) || !std::isfinite(by.e) || !std::isfinite(by.f)) return false;
        if (size < 0 && !allows_reflections(options_)) return false;
        if (keeps_lengths(options_) && std::fabs(scale - 1) > 1e-9) return false;
        if (options_.group == MatchGroup::translation && std::fabs(by.b) > 1e-9) return false;
        if (scale < options_.min_scale * (1 - 1e-9) || scale > options_.max_scale * (1 + 1e-9)) return false;
        // What is no longer than a few tolerances looks like anything.
        return std::all_of(left_.elements.begin(), left_.elements.end(), [&](const Element& e) {
            return e.kind == ElementKind::point || rough_length(e) * scale > 8 * reach();
        });
    }

    // The samples of all left elements, or nothing where one is too far off.
    std::optional<std::vector<Sample>> samples_at(const Transform& by, double reach_of_all) const {
        std::vector<Sample> samples;
        for (const Element& e : left_.elements) {
            const Element part = transformed(e, by);
            const int count = e.kind == ElementKind::point ? 1 : samples_of_curve;
            for (int i = 0; i < count; ++i) {
                const double t = parameter_of(part, i, count);
                auto sample = sample_at(part, t, design_, reach_of_all, options_.weights);
                if (!sample) return std::nullopt;
                samples.push_back(*sample);
            }
        }
        return samples;
    }

    static double worst_of(const std::vector<Sample>& samples) {
        double worst = 0;
        for (const Sample& sample : samples) worst = std::max(worst, sample.distance);
        return worst;
    }

    // By the map within the group that carries the samples nearest to their feet.
    Transform mended(const Transform& by, const std::vector<Sample>& samples) const {
        Vec from, to;
        const double share = 1 / static_cast<double>(samples.size());
        for (const Sample& sample : samples) {
            from = from + sample.at * share;
            to = to + sample.foot * share;
        }
        Vec m;
        double size = 0;
        for (const Sample& sample : samples) {
            m = m + times(sample.foot - to, conjugate(sample.at - from));
            size += dot(sample.at - from, sample.at - from);
        }
        m = m * (1 / size);
        if (options_.group == MatchGroup::translation || !(size > 0)) m = {1, 0};
        if (options_.group == MatchGroup::isometry) m = m * (1 / length(m));
        return compose(to_transform(carrying(from, to, m, false)), by);
    }

    void try_map(Transform by) {
        if (++tried_ > most_candidates || !is_allowed(by)) return;
        // What is off by a little more may be mended.
        auto samples = samples_at(by, 2 * reach());
        if (!samples) return;
        for (int round = 0; round < 6; ++round) {
            const Transform better = mended(by, *samples);
            auto now = samples_at(better, 2 * reach());
            if (!now || !is_allowed(better) || !(worst_of(*now) < 0.999 * worst_of(*samples))) break;
            by = better;
            samples = std::move(now);
        }
        const double worst = worst_of(*samples);
        // On curves of its own descriptors it is exact, or of a family that is.
        if (worst > reach() || worst <= 10 * options_.tolerance) return;
        Match match;
        match.by = by;
        match.is_reflected = determinant(by) < 0;
        match.scale = std::sqrt(std::fabs(determinant(by)));
        match.angle_degrees = angle_of(by);
        match.centroid = apply(by, centroid_);
        for (std::size_t i = 0, first = 0; i < left_.elements.size(); ++i) {
            const std::size_t count = left_.elements[i].kind == ElementKind::point ? 1 : samples_of_curve;
            match.carriers.push_back((*samples)[first + count / 2].slot);
            first += count;
        }
        match.misfit = worst / reach();
        match.is_visual = true;
        matches_.found.push_back(std::move(match));
    }

    // Whether two maps, or what a symmetry makes of one, look the same.
    bool look_alike(const Transform& a, const Transform& b) const {
        return std::any_of(symmetries_.begin(), symmetries_.end(), [&](const Symmetry& g) {
            const Transform by = compose(b, g.by);
            return std::all_of(corners_.begin(), corners_.end(),
                               [&](Vec corner) { return length(apply(a, corner) - apply(by, corner)) <= 4 * reach(); });
        });
    }

    // The best of each that look the same, without those that are exact.
    Matches distinct(const std::vector<Match>& exact) {
        std::vector<Match> all = std::move(matches_.found);
        put_in_order(all, options_.tolerance);
        std::vector<std::size_t> order(all.size());
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
        // Coarsely, so that rounding does not decide.
        const auto rank = [&](std::size_t i) { return std::pair(std::round(all[i].misfit * 1e6), i); };
        std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
        matches_.found.clear();
        for (const std::size_t i : order) {
            const auto is_same = [&](const Match& other) { return look_alike(all[i].by, other.by); };
            if (std::any_of(exact.begin(), exact.end(), is_same)) continue;
            if (std::any_of(matches_.found.begin(), matches_.found.end(), is_same)) continue;
            if (matches_.found.size() >= options_.limit) {
                matches_.is_complete = false;
                break;
            }
            matches_.found.push_back(std::move(all[i]));
        }
        put_in_order(matches_.found, options_.tolerance);
        return std::move(matches_);
    }

    static constexpr int samples_of_curve = 17;

    const Shape& left_;
    const MatchIndex& design_;
    MatchOptions options_;
    Vec centroid_;
    std::array<Vec, 4> corners_;
    std::vector<Symmetry> symmetries_;
    std::size_t tried_ = 0;
    Matches matches_;
};

// A part of a design's element, as far as samples reach.
struct Cover {
    std::uint32_t slot = 0;
    Interval on;
    double last = 0;  // where the last sample was
};

}  // namespace

Matches find_look_alikes(const Shape& left, const MatchIndex& design, const MatchOptions& options) {
    if (left.elements.empty() || !(options.visual_tolerance > 0)) return {};
    return LookAlikes(left, design, options).run();
}

std::vector<Element> covered_pieces(const Shape& left, const MatchIndex& design, const Match& match,
                                    double visual_tolerance) {
    std::vector<Element> pieces;
    for (const Element& e : left.elements) {
        const Element part = transformed(e, match.by);
        const int count = e.kind == ElementKind::point ? 1 : 129;
        std::vector<Cover> covers;
        for (int i = 0; i < count; ++i) {
            const auto sample = sample_at(part, parameter_of(part, i, count), design, visual_tolerance * (1 + 1e-9),
                                          WeightRule::at_least);
            if (!sample) continue;
            const auto known = std::find_if(covers.begin(), covers.end(),
                                            [&](const Cover& cover) { return cover.slot == sample->slot; });
            if (known == covers.end()) {
                covers.push_back({sample->slot, {sample->t, sample->t}, sample->t});
                continue;
            }
            double t = sample->t;
            // Across the place where a whole ellipse begins.
            constexpr double turn = 2 * elementary::pi;
            if (is_closed(design.element(known->slot))) t += turn * std::round((known->last - t) / turn);
            known->on = {std::min(known->on.from, t), std::max(known->on.to, t)};
            known->last = t;
        }
        const double spacing = visual_tolerance + 2 * rough_length(part) / count;
        for (Cover& cover : covers) {
            const Element& carrier = design.element(cover.slot);
            if (carrier.kind == ElementKind::point) {
                pieces.push_back(carrier);
                continue;
            }
            // Where one carrier goes on in another, both are covered up to their ends.
            if (!is_closed(carrier)) {
                const auto [begin, end] = ends_of(carrier);
                const Interval own = interval_of(carrier);
                if (length(point_at(carrier, cover.on.from) - begin) <= spacing) cover.on.from = own.from;
                if (length(point_at(carrier, cover.on.to) - end) <= spacing) cover.on.to = own.to;
            }
            if (cover.on.from < cover.on.to) pieces.push_back(piece_of(carrier, cover.on));
        }
    }
    return pieces;
}

}  // namespace filigree::curves
