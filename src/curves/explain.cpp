#include "curves/explain.h"

#include <algorithm>
#include <cmath>

#include "base/number_text.h"
#include "curves/along.h"
#include "curves/explain_candidates.h"
#include "curves/match_order.h"
#include "curves/nearest.h"
#include "curves/refine.h"
#include "curves/weights.h"

namespace filigree::curves {
namespace {

constexpr std::size_t most_looked_at = 48;  // candidates that are looked at closely

// Which elements of the left side lie on the design, to within how much.
struct Count {
    std::size_t exact = 0, rough = 0;

    auto operator<=>(const Count&) const = default;
};

class Explainer {
public:
    Explainer(const Shape& left, const MatchIndex& design, const MatchOptions& options, std::optional<Vec> near)
        : left_(left),
          design_(design),
          options_(options),
          near_(near),
          centroid_(centroid_of(left)),
          reach_(reach_of(left)) {}

    Explanation run() {
        const Candidates candidates = partial_embeddings(left_, design_, options_, near_);
        std::optional<Score> best;
        for (const Transform& by : most_promising(candidates.by)) {
            Score score = score_of(explanation_at(mended(by)));
            if (!best || score.is_better_than(*best)) best = std::move(score);
        }
        Explanation found;
        if (best) {
            found = std::move(best->explanation);
        } else {
            found = explanation_at({});
            for (Finding& finding : found.findings) finding = without_transform(finding);
        }
        found.is_complete = candidates.is_complete && !is_cancelled(options_.job);
        return found;
    }

private:
    struct Score {
        Explanation explanation;
        bool is_here = true;
        std::size_t faults = 0;         // elements that do not fit, and ways in which the group is left
        double distance = 0, lack = 0;  // from the place that is meant; how much is missing, in elements

        bool is_better_than(const Score& other) const {
            if (is_here != other.is_here) return is_here;
            if (!is_here && distance != other.distance) return distance < other.distance;
            if (faults != other.faults) return faults < other.faults;
            // What rounding makes of equal distances must not outweigh what is missing.
            if (std::fabs(distance - other.distance) > 1e-6 * (distance + other.distance)) {
                return distance < other.distance;
            }
            if (std::fabs(lack - other.lack) > 1e-6 * (lack + other.lack)) return lack < other.lack;
            // Symmetries of what fits are left: as matches are told, not mirrored where it can be, and turned least.
            const auto turn = [](const Explanation& e) {
                return std::pair(determinant(e.by) < 0, std::round(e.angle_degrees * 1e6));
            };
            return turn(explanation) < turn(other.explanation);
        }
    };

    bool has_weight(const Element& carrier, const Element& part) const {
        return is_heavy_enough(carrier.weight, part.weight, options_.weights);
    }

    // The carriers of the left elements that lie on one within a reach (of each its own); null where there is none.
    template <class Reach>
    std::vector<const Element*> carriers_of(const Transform& by, Reach&& reach_of_part) const {
        std::vector<const Element*> carriers(left_.elements.size(), nullptr);
        for (std::size_t i = 0; i < carriers.size(); ++i) {
            const Element part = transformed(left_.elements[i], by);
            const Interval on = interval_of(part);
            double best = reach_of_part(part);
            const Vec middle = point_at(part, 0.5 * (on.from + on.to));
            design_.grid().visit_near(middle, best, [&](std::uint32_t slot) {
                const Element& carrier = design_.element(slot);
                if (carrier.kind != part.kind || carrier.layer != part.layer || !has_weight(carrier, part)) return;
                const auto off = misfit(carrier, part, best);
                if (!off || (carriers[i] != nullptr && *off == best)) return;
                best = *off;
                carriers[i] = &carrier;
            });
        }
        return carriers;
    }
    auto exactly() const {
        return [this](const Element&) { return options_.tolerance; };
    }
    auto roughly() const {
        return [this](const Element& part) { return std::max(10 * options_.tolerance, 1e-3 * rough_length(part)); };
    }
    static std::size_t number_of(const std::vector<const Element*>& carriers) {
        return static_cast<std::size_t>(std::count_if(carriers.begin(), carriers.end(), [](auto* c) { return c; }));
    }
    Count count_at(const Transform& by) const {
        const std::size_t rough = number_of(carriers_of(by, roughly()));
        return {rough == 0 ? 0 : number_of(carriers_of(by, exactly())), rough};
    }

    // Those candidates that lay most elements on something, each once.
    std::vector<Transform> most_promising(const std::vector<Transform>& candidates) const {
        struct Ranked {
            bool is_here = true;
            double distance = 0;
            Count count;
            std::size_t number = 0;
        };
        std::vector<Ranked> ranked;
        for (std::size_t i = 0; i < candidates.size(); ++i) {
            if (is_cancelled(options_.job)) break;
            ranked.push_back({is_here(candidates[i]), distance_of(candidates[i]), count_at(candidates[i]), i});
        }
        std::sort(ranked.begin(), ranked.end(), [](const Ranked& a, const Ranked& b) {
            if (a.is_here != b.is_here) return a.is_here;
            if (a.count.rough != b.count.rough) return a.count.rough > b.count.rough;
            if (a.count.exact != b.count.exact) return a.count.exact > b.count.exact;
            return a.distance != b.distance ? a.distance < b.distance : a.number < b.number;
        });
        std::vector<Transform> best;
        for (const Ranked& candidate : ranked) {
            if (best.size() == most_looked_at) break;
            const Transform& by = candidates[candidate.number];
            const auto is_same = [&](const Transform& other) {
                const double linear = std::max({std::fabs(by.a - other.a), std::fabs(by.b - other.b),
                                                std::fabs(by.c - other.c), std::fabs(by.d - other.d)});
                return linear * reach_ + length(apply(by, centroid_) - apply(other, centroid_)) <
                       0.01 * options_.tolerance;
            };
            if (std::none_of(best.begin(), best.end(), is_same)) best.push_back(by);
        }
        return best;
    }

    // Mended by those elements that lie on something, where that helps.
    Transform mended(const Transform& by) const {
        Transform best = by;
        Count count = count_at(by);
        for (const auto& carriers : {carriers_of(by, exactly()), carriers_of(by, roughly())}) {
            std::vector<Pairing> pairs;
            for (std::size_t i = 0; i < carriers.size(); ++i) {
                if (carriers[i] != nullptr) pairs.push_back({&left_.elements[i], carriers[i]});
            }
            if (pairs.empty()) continue;
            const Transform made = refined(by, group_of(by), pairs);
            const Count now = count_at(made);
            if (!(now > count)) continue;
            best = made;
            count = now;
        }
        return best;
    }

    static double scale_of(const Transform& by) { return std::sqrt(std::fabs(determinant(by))); }
    // How much something must be turned or grown that the left side reaches a tolerance farther.
    double slack() const { return options_.tolerance / std::max(reach_, options_.tolerance) + 1e-9; }
    bool is_scale_outside(const Transform& by) const {
        const double scale = scale_of(by);
        if (keeps_lengths(options_)) return std::fabs(scale - 1) > slack();
        return scale < options_.min_scale * (1 - slack()) || scale > options_.max_scale * (1 + slack());
    }
    bool is_turn_outside(const Transform& by) const {
        if (options_.group != MatchGroup::translation) return false;
        return length(Vec{by.a, by.b} * (1 / length(Vec{by.a, by.b})) - Vec{1, 0}) > slack();
    }
    bool needs_reflection(const Transform& by) const { return determinant(by) < 0 && !allows_reflections(options_); }
    // The smallest group that a candidate keeps to.
    MatchGroup group_of(const Transform& by) const {
        if (options_.group == MatchGroup::affine) return MatchGroup::affine;
        const bool is_outside =
            (keeps_lengths(options_) && is_scale_outside(by)) || is_turn_outside(by) || needs_reflection(by);
        return is_outside ? MatchGroup::similarity : options_.group;
    }

    double distance_of(const Transform& by) const { return near_ ? length(apply(by, centroid_) - *near_) : 0; }
    bool is_here(const Transform& by) const { return distance_of(by) <= scale_of(by) * reach_; }

    Explanation explanation_at(const Transform& by) const {
        Explanation found;
        found.by = by;
        found.scale = scale_of(by);
        found.angle_degrees = angle_of(by);
        found.centroid = apply(by, centroid_);
        found.is_scale_outside = is_scale_outside(by);
        found.is_turn_outside = is_turn_outside(by);
        found.needs_reflection = needs_reflection(by);
        for (const Element& e : left_.elements) {
            found.findings.push_back(finding_of(transformed(e, by)));
            found.fitting += found.findings.back().lack == Lack::none;
        }
        return found;
    }

    Score score_of(Explanation explanation) const {
        Score score;
        score.is_here = is_here(explanation.by);
        score.distance = distance_of(explanation.by);
        const std::size_t outside =
            explanation.is_scale_outside + explanation.is_turn_outside + explanation.needs_reflection;
        score.faults = explanation.findings.size() - explanation.fitting + outside;
        score.lack = 0.2 * static_cast<double>(outside);
        for (const Finding& finding : explanation.findings) {
            switch (finding.lack) {
                case Lack::none:
                    break;
                case Lack::ends_early:
                    score.lack += std::min(finding.share, 1.0);
                    break;
                case Lack::off:
                    score.lack += std::min(finding.tolerances / 100, 1.0);
                    break;
                case Lack::other_layer:
                case Lack::too_light:
                case Lack::too_heavy:
                    score.lack += ink_price;
                    break;
                case Lack::nothing_here:
                case Lack::nothing_of_kind:
                    score.lack += 1;
                    break;
            }
        }
        score.explanation = std::move(explanation);
        return score;
    }

    // What is missing where one carrier is taken, and how much of the part's size that is.
    struct Try {
        Finding finding;
        double price = 0;
    };

    Try try_of(const Element& part, std::uint32_t slot) const {
        const Element& carrier = design_.element(slot);
        const Interval on = interval_of(part), own = interval_of(carrier);
        const Vec middle = point_at(part, 0.5 * (on.from + on.to));
        const double size = part.kind == ElementKind::point ? reach_ : rough_length(part);
        Try made{{Lack::none, part.kind, slot, middle, 0, 0}, 0};
        Element same = part;
        same.layer = carrier.layer;
        const auto found = along(carrier, same, options_.tolerance);
        const bool overlaps = found && (is_closed(carrier) || part.kind == ElementKind::point ||
                                        (found->on.from < own.to && found->on.to > own.from));
        if (!overlaps) {
            const double off = farthest_of(part, 9, carrier);
            made.finding.lack = Lack::off;
            made.finding.tolerances = off / options_.tolerance;
            made.price = off / size;
        } else if (overhang(carrier, *found) > options_.tolerance) {
            const double before = found->on.from < own.from ? rough_length(carrier, {found->on.from, own.from}) : 0;
            const double behind = found->on.to > own.to ? rough_length(carrier, {own.to, found->on.to}) : 0;
            made.finding.lack = Lack::ends_early;
            made.finding.at = point_at(carrier, before > behind ? own.from : own.to);
            made.finding.share = std::max(before, behind) / size;
            made.price = made.finding.share;
        }
        Lack ink = Lack::none;
        if (!has_weight(carrier, part)) ink = carrier.weight < part.weight ? Lack::too_light : Lack::too_heavy;
        if (carrier.layer != part.layer) ink = Lack::other_layer;
        if (ink == Lack::none) return made;
        // What lies elsewhere and has another colour lies elsewhere above all.
        made.price += ink_price;
        if (made.finding.lack == Lack::none) made.finding.lack = ink;
        return made;
    }

    Finding finding_of(const Element& part) const {
        const Interval on = interval_of(part);
        const double size = part.kind == ElementKind::point ? reach_ : rough_length(part);
        const double reach = std::max(0.25 * size, 100 * options_.tolerance);
        std::vector<std::uint32_t> slots;
        for (const double f : {0.1, 0.5, 0.9}) {
            design_.grid().visit_near(point_at(part, on.from * (1 - f) + on.to * f), 0.5 * reach,
                                      [&](std::uint32_t slot) {
                                          if (design_.element(slot).kind == part.kind) slots.push_back(slot);
                                      });
        }
        std::sort(slots.begin(), slots.end());
        slots.erase(std::unique(slots.begin(), slots.end()), slots.end());
        std::optional<Try> best;
        for (const std::uint32_t slot : slots) {
            Try made = try_of(part, slot);
            if (made.finding.lack == Lack::off && made.finding.tolerances * options_.tolerance > reach) continue;
            if (!best || made.price < best->price) best = std::move(made);
        }
        if (best) return best->finding;
        return without_transform(
            {Lack::nothing_here, part.kind, std::nullopt, point_at(part, 0.5 * (on.from + on.to)), 0, 0});
    }

    Finding without_transform(Finding finding) const {
        finding.lack = design_.slots_of(finding.kind).empty() ? Lack::nothing_of_kind : Lack::nothing_here;
        finding.carrier.reset();
        return finding;
    }

    // As much of an element's size as another colour or weight counts for: a curve that is shorter by less is nearer.
    static constexpr double ink_price = 0.01;

    const Shape& left_;
    const MatchIndex& design_;
    const MatchOptions& options_;
    std::optional<Vec> near_;
    Vec centroid_;
    double reach_;
};

// To two digits that count.
std::string amount_text(double value) {
    std::string text;
    int decimals = 1;
    for (double tenth = 1; value < tenth && decimals < 12; tenth /= 10) ++decimals;
    append_fixed(text, value, value < 10 ? decimals : 0);
    return text;
}

std::string place_text(Vec at, double px_per_unit) {
    std::string text = "(";
    append_fixed(text, at.x / px_per_unit, 3);
    text += ", ";
    append_fixed(text, at.y / px_per_unit, 3);
    return text + ")";
}

std::string text_of(const Finding& finding, double px_per_unit) {
    switch (finding.lack) {
        case Lack::none:
            return "fits";
        case Lack::ends_early:
            return "its curve ends " + amount_text(100 * finding.share) + " % too early, at " +
                   place_text(finding.at, px_per_unit);
        case Lack::off:
            if (finding.tolerances > 1000) {
                return "there is no " + std::string(name_of(finding.kind)) + " like it near " +
                       place_text(finding.at, px_per_unit) + ", the nearest lies " + amount_text(finding.tolerances) +
                       " tolerances off";
            }
            return "lies " + amount_text(finding.tolerances) + " tolerances off, near " +
                   place_text(finding.at, px_per_unit);
        case Lack::other_layer:
            return finding.kind == ElementKind::point ? "the label there is another one"
                                                      : "the colour there is another one";
        case Lack::too_light:
            return "what lies there is too light";
        case Lack::too_heavy:
            return "what lies there is too heavy";
        case Lack::nothing_here:
            return "there is no " + std::string(name_of(finding.kind)) + " near " + place_text(finding.at, px_per_unit);
        case Lack::nothing_of_kind:
            return "there is no " + std::string(name_of(finding.kind)) + " in the whole design";
    }
    return "";
}

}  // namespace

Explanation explain(const Shape& left, const MatchIndex& design, const MatchOptions& options, std::optional<Vec> near) {
    if (left.elements.empty()) return {};
    return Explainer(left, design, options, near).run();
}

std::vector<std::string> text_of(const Explanation& explanation, double px_per_unit) {
    std::vector<std::string> sentences;
    if (explanation.is_scale_outside) {
        sentences.push_back("the scale, " + amount_text(explanation.scale) + ", is not allowed");
    }
    if (explanation.is_turn_outside) {
        sentences.push_back("it would have to be turned by " + amount_text(explanation.angle_degrees) + " degrees");
    }
    if (explanation.needs_reflection) sentences.emplace_back("it would have to be reflected");
    for (std::size_t i = 0; i < explanation.findings.size(); ++i) {
        const Finding& finding = explanation.findings[i];
        if (finding.lack == Lack::none) continue;
        std::string sentence =
            "element " + to_text(std::uint64_t{i + 1}) + " (" + std::string(name_of(finding.kind)) + "): ";
        sentences.push_back(sentence + text_of(finding, px_per_unit));
    }
    if (sentences.empty()) sentences.emplace_back("every element lies on the design");
    return sentences;
}

}  // namespace filigree::curves
