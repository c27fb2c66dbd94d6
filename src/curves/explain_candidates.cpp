#include "curves/explain_candidates.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "curves/contacts.h"
#include "curves/detect.h"
#include "curves/frame.h"
#include "curves/similarity.h"

namespace filigree::curves {
namespace {

constexpr std::size_t most_candidates = 20000, most_kept = 200000, most_left_out = 16;

// A point of an element by which it may be laid onto another one.
struct Mark {
    enum class Kind : std::uint8_t { contact, end, centre };
    Kind kind = Kind::end;
    Vec at;
    Contact contact;
};

std::vector<Mark> marks_on(const Element& e, std::span<const Element> others, double reach) {
    std::vector<Mark> marks;
    for (const Element& other : others) {
        if (other == e) continue;
        for (const Contact& contact : contacts_of(e, other, reach)) {
            marks.push_back({Mark::Kind::contact, contact.at, contact});
        }
    }
    if (e.kind == ElementKind::arc) marks.push_back({Mark::Kind::centre, e.at[0], {}});
    if (!is_closed(e)) {
        const auto [first, last] = ends_of(e);
        marks.push_back({Mark::Kind::end, first, {}});
        marks.push_back({Mark::Kind::end, last, {}});
    }
    return marks;
}

struct MarkPair {
    Mark first, last;
};

// A few pairs by which an element should be laid: by contacts where it has two, else by its ends, too, which mean
// nothing where it is embedded. Of arcs the centre is the first.
std::vector<MarkPair> pairs_on(const Element& e, std::span<const Element> others, double reach) {
    std::vector<Mark> marks = marks_on(e, others, reach), contacts;
    std::copy_if(marks.begin(), marks.end(), std::back_inserter(contacts),
                 [](const Mark& a) { return a.kind == Mark::Kind::contact; });
    std::vector<MarkPair> pairs;
    if (e.kind == ElementKind::arc) {
        const auto centre =
            std::find_if(marks.begin(), marks.end(), [](const Mark& a) { return a.kind == Mark::Kind::centre; });
        const Mark at_centre = *centre;
        marks.erase(centre);
        for (const Mark& a : contacts.empty() ? marks : contacts) pairs.push_back({at_centre, a});
        return pairs;
    }
    const std::vector<Mark>& used = contacts.size() < 2 ? marks : contacts;
    std::optional<std::pair<std::size_t, std::size_t>> widest;
    for (std::size_t i = 0; i < used.size(); ++i) {
        for (std::size_t j = i + 1; j < used.size(); ++j) {
            const double width = length(used[i].at - used[j].at);
            if (!widest || width > length(used[widest->first].at - used[widest->second].at)) widest = {i, j};
        }
    }
    if (!widest) return pairs;
    pairs.push_back({used[widest->first], used[widest->second]});
    // Where one of the two is what lacks, another one serves.
    for (std::size_t i = 0; i < used.size() && pairs.size() < 3; ++i) {
        if (i == widest->first || i == widest->second) continue;
        pairs.push_back({used[widest->first], used[i]});
        pairs.push_back({used[widest->second], used[i]});
    }
    return pairs;
}

// Whether one mark may come to lie on another when +x is turned to m.
bool do_agree(const Mark& own, const Mark& other, Vec m, bool is_reflected) {
    if ((own.kind == Mark::Kind::centre) != (other.kind == Mark::Kind::centre)) return false;
    if (own.kind != Mark::Kind::contact) return true;
    if (other.kind != Mark::Kind::contact || own.contact.other != other.contact.other) return false;
    const Vec way = is_reflected ? conjugate(own.contact.other_way) : own.contact.other_way;
    constexpr double sine = 0.01;  // what lacks a little is turned a little
    return std::fabs(cross(times(m, way), other.contact.other_way)) <= sine * length(m);
}

class Collector {
public:
    Collector(const Shape& left, const MatchIndex& design, const MatchOptions& options, std::optional<Vec> near)
        : left_(left),
          design_(design),
          options_(options),
          near_(near),
          centroid_(centroid_of(left)),
          reach_(reach_of(left)) {}

    Candidates run() {
        leave_one_out();
        close_source(most_candidates);
        const std::size_t quota = std::max<std::size_t>(100, most_candidates / left_.elements.size());
        for (const Element& e : left_.elements) {
            if (is_cancelled(options_.job)) found_.is_complete = false;
            if (is_cancelled(options_.job)) break;
            if (e.kind == ElementKind::parabola) lay_by_frame(e);
            if (e.kind != ElementKind::parabola && e.kind != ElementKind::point) lay_by_marks(e);
            close_source(quota);
        }
        lay_by_centres();
        close_source(most_candidates);
        return std::move(found_);
    }

private:
    struct Offer {
        Transform by;
        bool is_far = false;
        double lack = 0, distance = 0;
        std::size_t number = 0;
    };

    void offer(const Transform& by, double lack = 0) {
        const double scale = std::sqrt(std::fabs(determinant(by)));
        if (!std::isfinite(by.e) || !std::isfinite(by.f) || !std::isfinite(scale)) return;
        // What is as small as this lies on anything.
        if (!(scale * reach_ > 4 * options_.tolerance)) {
            if (left_.elements.size() > 1 || left_.elements[0].kind != ElementKind::point) return;
        }
        Offer made{by, false, lack, 0, offers_.size()};
        if (near_) made.distance = length(apply(by, centroid_) - *near_);
        made.is_far = made.distance > scale * reach_;
        if (offers_.size() < most_kept) {
            offers_.push_back(made);
        } else {
            found_.is_complete = false;
        }
    }
    void offer(const Similarity& by, double lack = 0) { offer(to_transform(by), lack); }

    // What carries p to to_p in this direction, freely and within the group.
    void offer_turned(Vec p, Vec to_p, Vec m, bool is_reflected, double lack = 0) {
        offer(carrying(p, to_p, m, is_reflected), lack);
        if (options_.group == MatchGroup::isometry && std::fabs(length(m) - 1) > 1e-12) {
            offer(carrying(p, to_p, m * (1 / length(m)), is_reflected), lack);
        }
        if (options_.group == MatchGroup::translation && !is_reflected) offer(translation(to_p - p), lack);
    }

    // Takes over the best offers, in the order in which they were made.
    void close_source(std::size_t quota) {
        if (offers_.size() > quota) {
            found_.is_complete = false;
            std::sort(offers_.begin(), offers_.end(), [](const Offer& a, const Offer& b) {
                if (a.is_far != b.is_far) return b.is_far;
                if (a.lack != b.lack) return a.lack < b.lack;
                return a.distance != b.distance ? a.distance < b.distance : a.number < b.number;
            });
            offers_.resize(quota);
        }
        for (const Offer& made : offers_) found_.by.push_back(made.by);
        offers_.clear();
    }

    void leave_one_out() {
        if (left_.elements.size() < 2) return;
        MatchOptions options = options_;
        if (options.group != MatchGroup::affine) options.group = MatchGroup::similarity;
        options.with_reflections = true;
        options.weights = WeightRule::at_least;
        options.min_scale = 0;
        options.max_scale = MatchOptions{}.max_scale;
        options.limit = most_candidates / most_left_out;
        for (std::size_t i = 0; i < std::min(left_.elements.size(), most_left_out); ++i) {
            Shape rest = left_;
            rest.elements.erase(rest.elements.begin() + static_cast<std::ptrdiff_t>(i));
            for (Element& e : rest.elements) e.weight = 1e-9;  // weights are compared in the end
            const Matches matches = find_matches(rest, design_, options);
            for (const Match& match : matches.found) offer(match.by);
            for (const Match& match : matches.near_misses) offer(match.by);
            if (!matches.is_complete) found_.is_complete = false;
        }
        if (left_.elements.size() > most_left_out) found_.is_complete = false;
    }

    void lay_by_frame(const Element& own) {
        const ParabolaFrame frame = frame_of(own);
        const double width = frame.high - frame.low, slope = 0.5 * (frame.low + frame.high);
        const Vec middle = point_at(own, 0.5);
        for (const std::uint32_t slot : design_.slots_of(ElementKind::parabola)) {
            const ParabolaFrame& other = design_.frame(slot);
            for (const bool is_reflected : {false, true}) {
                const double low = is_reflected ? -frame.high : frame.low;
                const double lack = std::max(0.0, other.low - low) + std::max(0.0, low + width - other.high);
                // Beyond that it is another part of the parabola.
                if (!(lack < width)) continue;
                const Vec to = point_at(design_.glimpse(slot), parameter_at(other, is_reflected ? -slope : slope));
                offer_turned(middle, to, multiplier(frame, other, is_reflected), is_reflected, lack / width);
            }
        }
    }

    void lay_by_marks(const Element& own) {
        // Contacts of the left side are as good as drawn; those of the design may be just what lacks a little.
        const std::vector<MarkPair> pairs = pairs_on(own, left_.elements, 2 * options_.tolerance);
        if (pairs.empty()) return;
        for (const std::uint32_t slot : design_.slots_of(own.kind)) {
            const std::vector<Mark>& marks = marks_of_slot(slot);
            for (const MarkPair& pair : pairs) {
                for (const Mark& first : marks) {
                    for (const Mark& last : marks) {
                        if (first.at != last.at) lay(pair, first, last);
                    }
                }
            }
            if (is_cancelled(options_.job)) return;
        }
    }

    void lay(const MarkPair& pair, const Mark& first, const Mark& last) {
        const Vec way = pair.last.at - pair.first.at, to = last.at - first.at;
        for (const bool is_reflected : {false, true}) {
            const Vec m = over(to, is_reflected ? conjugate(way) : way);
            if (!do_agree(pair.first, first, m, is_reflected) || !do_agree(pair.last, last, m, is_reflected)) continue;
            offer_turned(pair.first.at, first.at, m, is_reflected);
            // Within the group the two ends are two ways to lay it.
            if (options_.group == MatchGroup::isometry && std::fabs(length(m) - 1) > 1e-12) {
                offer(carrying(pair.last.at, last.at, m * (1 / length(m)), is_reflected));
            }
            if (options_.group == MatchGroup::translation && !is_reflected) offer(translation(last.at - pair.last.at));
        }
    }

    const std::vector<Mark>& marks_of_slot(std::uint32_t slot) {
        if (marks_.empty()) marks_.resize(design_.slot_count());
        if (!marks_[slot]) {
            const Element& e = design_.element(slot);
            const double reach = 0.05 * rough_length(e);
            std::vector<Element> others;
            for (const std::uint32_t number : design_.grid().found_along(e, reach)) {
                if (number != slot) others.push_back(design_.element(number));
            }
            marks_[slot] = marks_on(e, others, reach);
        }
        return *marks_[slot];
    }

    // By labelled points and the centres of arcs: the widest pair of the left side onto all pairs; one alone as it
    // lies.
    void lay_by_centres() {
        struct Centre {
            Vec at;
            ElementKind kind = ElementKind::point;
            double radius = 0;
        };
        const auto centre_of = [](const Element& e) {
            return Centre{e.at[0], e.kind, e.kind == ElementKind::arc ? length(e.at[1]) : 0};
        };
        std::vector<Centre> own, others;
        for (const Element& e : left_.elements) {
            if (e.kind == ElementKind::point || e.kind == ElementKind::arc) own.push_back(centre_of(e));
        }
        if (own.empty()) return;
        for (const ElementKind kind : {ElementKind::point, ElementKind::arc}) {
            for (const std::uint32_t slot : design_.slots_of(kind)) others.push_back(centre_of(design_.element(slot)));
        }
        for (const Centre& to : others) {
            if (to.kind != own[0].kind) continue;
            const double scale = to.kind == ElementKind::arc ? to.radius / own[0].radius : 1;
            offer_turned(own[0].at, to.at, {scale, 0}, false);
        }
        std::pair<std::size_t, std::size_t> widest;
        for (std::size_t i = 0; i < own.size(); ++i) {
            for (std::size_t j = i + 1; j < own.size(); ++j) {
                if (length(own[i].at - own[j].at) > length(own[widest.first].at - own[widest.second].at)) {
                    widest = {i, j};
                }
            }
        }
        const Centre &p = own[widest.first], &q = own[widest.second];
        if (!(length(q.at - p.at) > options_.tolerance)) return;
        constexpr std::size_t most_pairs = 20000000;
        if (others.size() > most_pairs / others.size()) {
            others.resize(most_pairs / others.size());
            found_.is_complete = false;
        }
        for (const Centre& to_p : others) {
            if (is_cancelled(options_.job)) return;
            for (const Centre& to_q : others) {
                if (to_p.kind != p.kind || to_q.kind != q.kind || to_p.at == to_q.at) continue;
                const double scale = length(to_q.at - to_p.at) / length(q.at - p.at);
                const auto is_as_large = [&](const Centre& a, const Centre& b) {
                    return std::fabs(a.radius * scale - b.radius) <= 0.01 * b.radius;
                };
                if (!is_as_large(p, to_p) || !is_as_large(q, to_q)) continue;
                for (const bool is_reflected : {false, true}) {
                    const Vec way = q.at - p.at;
                    const Vec m = over(to_q.at - to_p.at, is_reflected ? conjugate(way) : way);
                    offer_turned(p.at, to_p.at, m, is_reflected);
                }
            }
        }
    }

    const Shape& left_;
    const MatchIndex& design_;
    const MatchOptions& options_;
    std::optional<Vec> near_;
    Vec centroid_;
    double reach_;
    std::vector<Offer> offers_;
    std::vector<std::optional<std::vector<Mark>>> marks_;  // of each slot, once they were asked for
    Candidates found_;
};

}  // namespace

double reach_of(const Shape& shape) { return 0.5 * diagonal_of(bounds_of(shape.elements)); }

Candidates partial_embeddings(const Shape& left, const MatchIndex& design, const MatchOptions& options,
                              std::optional<Vec> near) {
    if (left.elements.empty()) return {};
    return Collector(left, design, options, near).run();
}

}  // namespace filigree::curves
