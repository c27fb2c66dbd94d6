#include "curves/fingerprint.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "base/random.h"
#include "curves/algebra.h"
#include "curves/match_order.h"
#include "curves/moments.h"

namespace filigree::curves {
namespace {

std::uint64_t kinds_of(const Shape& shape) {
    std::map<std::pair<ElementKind, std::uint32_t>, std::uint64_t> counts;
    for (const Element& e : shape.elements) ++counts[{e.kind, e.layer}];
    std::uint64_t hash = 0;
    for (const auto& [kind, count] : counts) {
        hash = fold(fold(fold(hash, static_cast<std::uint64_t>(kind.first)), kind.second), count);
    }
    return hash;
}

// A place by which an element can be recognised: an end; of a whole ellipse a tip, of a whole circle the middle.
struct Mark {
    Vec at;               // from the middle of the shape
    double distance = 0;  // px
    std::uint32_t element = 0;
};

std::vector<Mark> marks_of(const Shape& shape, Vec middle) {
    std::vector<Mark> marks;
    for (std::uint32_t i = 0; i < shape.elements.size(); ++i) {
        const Element& e = shape.elements[i];
        const auto add = [&](Vec p) { marks.push_back({p - middle, length(p - middle), i}); };
        if (e.kind == ElementKind::point || (is_closed(e) && is_circular(e))) {
            add(e.at[0]);
        } else {
            const auto [first, last] = is_closed(e) ? std::pair(e.at[0] + e.at[1], e.at[0] - e.at[1]) : ends_of(e);
            add(first);
            add(last);
        }
    }
    return marks;
}

bool are_of_one_sort(const Element& a, const Element& b) {
    return a.kind == b.kind && a.layer == b.layer && a.weight == b.weight && is_closed(a) == is_closed(b);
}

// Whether a shape is another, moved: by their middles and one mark, which fix a similarity. Every mark that may be
// where the chosen one went is tried; most ways fail at the next mark.
class Comparison {
public:
    Comparison(const Shape& a, const Shape& b, double scale, double slack)
        : a_(a), b_(b), of_a_(moments_of(a)), of_b_(moments_of(b)), scale_(scale), slack_(slack) {
        marks_of_a_ = marks_of(a, of_a_.middle);
        by_distance_ = marks_of(b, of_b_.middle);
        by_x_ = by_distance_;
        std::sort(by_distance_.begin(), by_distance_.end(),
                  [](const Mark& p, const Mark& q) { return p.distance < q.distance; });
        std::sort(by_x_.begin(), by_x_.end(), [](const Mark& p, const Mark& q) { return p.at.x < q.at.x; });
    }

    bool finds_any(bool with_reflections) const {
        bool is_any = false;
        visit_maps(with_reflections, [&](const Transform&) {
            is_any = true;
            return false;
        });
        return is_any;
    }

    // Calls visit(map) for each map that there is, some twice, until it says false.
    template <class Visit>
    void visit_maps(bool with_reflections, Visit visit) const {
        if (marks_of_a_.size() != by_x_.size()) return;
        const auto agrees_and_ends = [&](Vec m, bool is_mirrored) {
            const Transform by = map_of(m, is_mirrored);
            return agrees(by) && !visit(by);
        };
        const Mark* const pivot = rarest_mark();
        if (pivot == nullptr) {  // round about the middle
            agrees_and_ends(Vec{scale_, 0}, false);
            return;
        }
        for (const Mark& mark : candidates(*pivot)) {
            if (!are_of_one_sort(a_.elements[pivot->element], b_.elements[mark.element])) continue;
            for (int mirrored = 0; mirrored <= (with_reflections ? 1 : 0); ++mirrored) {
                const Vec p = mirrored != 0 ? Vec{pivot->at.x, -pivot->at.y} : pivot->at;
                // mark / p as complex numbers, at the known scale.
                const Vec turn{dot(p, mark.at), cross(p, mark.at)};
                if (agrees_and_ends(turn * (scale_ / length(turn)), mirrored != 0)) return;
            }
        }
    }

private:
    std::span<const Mark> candidates(const Mark& mark) const {
        const auto is_nearer = [](const Mark& m, double distance) { return m.distance < distance; };
        const double wanted = scale_ * mark.distance;
        const auto from = std::lower_bound(by_distance_.begin(), by_distance_.end(), wanted - slack_, is_nearer);
        const auto to = std::lower_bound(from, by_distance_.end(), wanted + slack_, is_nearer);
        return {from, to};
    }

    // Of those far out, which fix the turn well, the one that fewest marks of the other shape may be; null where all
    // lie in the middle.
    const Mark* rarest_mark() const {
        double farthest = 0;
        for (const Mark& mark : marks_of_a_) farthest = std::max(farthest, mark.distance);
        if (farthest * scale_ <= 4 * slack_) return nullptr;
        const Mark* best = nullptr;
        std::size_t fewest = SIZE_MAX;
        for (const Mark& mark : marks_of_a_) {
            if (mark.distance < 0.5 * farthest) continue;
            const std::size_t count = candidates(mark).size();
            if (count < fewest) best = &mark;
            fewest = std::min(fewest, count);
        }
        return best;
    }

    // From the middle of one to that of the other.
    Transform map_of(Vec m, bool is_mirrored) const {
        const Transform turned =
            is_mirrored ? Transform{m.x, m.y, m.y, -m.x, 0, 0} : Transform{m.x, m.y, -m.y, m.x, 0, 0};
        return compose(translation(of_b_.middle), compose(turned, translation(-of_a_.middle)));
    }

    bool agrees(const Transform& by) const {
        for (const Mark& mark : marks_of_a_) {
            const Vec there = apply(by, of_a_.middle + mark.at) - of_b_.middle;
            const auto is_left = [](const Mark& other, double x) { return other.at.x < x; };
            auto at = std::lower_bound(by_x_.begin(), by_x_.end(), there.x - slack_, is_left);
            while (at != by_x_.end() && at->at.x <= there.x + slack_ &&
                   (length(at->at - there) > slack_ ||
                    !are_of_one_sort(a_.elements[mark.element], b_.elements[at->element]))) {
                ++at;
            }
            if (at == by_x_.end() || at->at.x > there.x + slack_) return false;
        }
        return are_equal(transformed(a_, by), b_, slack_);
    }

    const Shape &a_, &b_;
    Moments of_a_, of_b_;
    double scale_, slack_;
    std::vector<Mark> marks_of_a_, by_distance_, by_x_;  // the last two of b
};

}  // namespace

Fingerprint fingerprint(const Shape& shape, UpTo up_to) {
    Fingerprint print;
    print.kinds = kinds_of(shape);
    const Moments moments = moments_of(shape);
    switch (up_to) {
        case UpTo::nothing:
            print.values = {moments.middle.x, moments.middle.y, moments.spread};
            break;
        case UpTo::translation:
            print.values = {moments.length, moments.along_x, moments.along_y};
            break;
        case UpTo::isometry:
            print.values = {moments.length, moments.spread, 0};
            break;
        case UpTo::similarity:
            // Points alone have no length that grows as they spread.
            print.values = {has_curves(shape) ? moments.length / moments.spread : 0, 0, 0};
            break;
    }
    return print;
}

bool are_same_design(const Shape& a, const Shape& b, UpTo up_to, double tolerance, bool with_reflections) {
    const double slack = 4 * tolerance;
    if (a.elements.size() != b.elements.size() || kinds_of(a) != kinds_of(b)) return false;
    if (up_to == UpTo::nothing || a.elements.empty()) return are_equal(a, b, slack);
    const Moments of_a = moments_of(a), of_b = moments_of(b);
    if (up_to == UpTo::translation) {
        return are_equal(transformed(a, translation(of_b.middle - of_a.middle)), b, slack);
    }
    const bool may_grow = up_to == UpTo::similarity && of_a.spread > 0 && of_b.spread > 0;
    const double scale = may_grow ? of_b.spread / of_a.spread : 1;
    if (std::fabs(of_a.spread * scale - of_b.spread) > slack) return false;
    return Comparison(a, b, scale, slack).finds_any(with_reflections);
}

std::vector<Transform> maps_onto_itself(const Shape& shape, double tolerance) {
    std::vector<Transform> maps = {Transform{}};
    if (shape.elements.empty()) return maps;
    const double slack = 4 * tolerance, size = diagonal_of(bounds_of(shape.elements));
    Comparison(shape, shape, 1, slack).visit_maps(true, [&](const Transform& by) {
        // Two maps that turn alike are one: they all keep the middle.
        const auto is_known = [&](const Transform& other) {
            const double turn = std::fabs(by.a - other.a) + std::fabs(by.b - other.b);
            return determinant(by) * determinant(other) > 0 && turn * size <= 2 * slack;
        };
        if (std::none_of(maps.begin(), maps.end(), is_known)) maps.push_back(by);
        return true;
    });
    const auto rank = [&](const Transform& by) { return std::pair(determinant(by) < 0, angle_of(by)); };
    std::sort(maps.begin() + 1, maps.end(), [&](const Transform& a, const Transform& b) { return rank(a) < rank(b); });
    return maps;
}

std::optional<std::uint32_t> DesignSet::find_or_add(const Shape& design, std::uint32_t number) {
    const Fingerprint print = fingerprint(design, up_to_);
    // Wide beside what rounding does to sums over all elements, narrow beside what a rule does.
    const double cell = 1e4 * tolerance_;
    Bucket own{static_cast<std::int64_t>(print.kinds), 0, 0, 0};
    std::array<std::int64_t, 3> other{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double at = std::clamp(print.values[i] / (up_to_ == UpTo::similarity ? 1e-3 : cell), -1e18, 1e18);
        own[i + 1] = static_cast<std::int64_t>(std::floor(at));
        other[i] = at - std::floor(at) < 0.5 ? -1 : 1;
    }
    for (unsigned corner = 0; corner < 8; ++corner) {
        Bucket bucket = own;
        for (std::size_t i = 0; i < 3; ++i) {
            if ((corner >> i & 1U) != 0) bucket[i + 1] += other[i];
        }
        const auto found = buckets_.find(bucket);
        if (found == buckets_.end()) continue;
        for (const Entry& entry : found->second) {
            if (are_same_design(entry.design, design, up_to_, tolerance_, with_reflections_)) return entry.number;
        }
    }
    buckets_[own].push_back({design, number});
    return std::nullopt;
}

}  // namespace filigree::curves
