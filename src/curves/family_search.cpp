#include "curves/family_search.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/elementary.h"
#include "curves/crossing.h"
#include "curves/family_range.h"
#include "curves/match_order.h"
#include "curves/seats.h"

namespace filigree::curves {
namespace {

constexpr double degrees_per_radian = 180 / elementary::pi;

Vec unit_along(const Element& line) {
    const Vec way = line.at[1] - line.at[0];
    return way * (1 / length(way));
}

Interval stretch_of(const Element& line, Vec from, Vec along) {
    const double first = dot(line.at[0] - from, along), last = dot(line.at[1] - from, along);
    return {std::min(first, last), std::max(first, last)};
}

// A first transform, what it leaves free, and the carriers of the elements by which it was found.
struct Base {
    Similarity by;
    Vec centre, along{1, 0};
    std::vector<std::pair<std::uint32_t, std::uint32_t>> seated;  // a left element and a slot
};

class FamilySearch {
public:
    FamilySearch(const Embedding& embedding, std::span<const Symmetry> symmetries)
        : embedding_(embedding),
          design_(embedding.design()),
          options_(embedding.options()),
          elements_(embedding.left().elements),
          symmetries_(symmetries) {
        for (std::uint32_t i = 0; i < elements_.size(); ++i) {
            (elements_[i].kind == ElementKind::line    ? lines_
             : elements_[i].kind == ElementKind::point ? points_
                                                       : circles_)
                .push_back(i);
        }
        limits_.least_growth = least_growth();
        limits_.most_growth = options_.max_scale;
        limits_.slack = options_.tolerance;
    }

    Matches found() {
        if (lines_.empty()) {
            circles_.empty() ? find_points() : find_circles();
        } else if (!points_.empty()) {
            find_lines_through_a_point();
        } else {
            find_lines();
        }
        put_in_order(matches_.found, options_.tolerance);
        put_in_order(matches_.near_misses, options_.tolerance);
        std::sort(matches_.families.begin(), matches_.families.end(), [&](const Family& a, const Family& b) {
            const auto key = [&](const Family& f) {
                return std::tuple(rank_of(f.members.front(), options_.tolerance), f.carriers);
            };
            return key(a) < key(b);
        });
        return std::move(matches_);
    }

private:
    bool goes_on() {
        const std::size_t count = matches_.families.size() + matches_.found.size();
        if (is_cancelled(options_.job) || count >= options_.limit) matches_.is_complete = false;
        return matches_.is_complete;
    }
    std::vector<std::uint32_t> carriers_of(std::uint32_t i) const {
        std::vector<std::uint32_t> carriers;
        for (const std::uint32_t slot : design_.slots_of(elements_[i].kind)) {
            if (embedding_.may_carry(design_.glimpse(slot), elements_[i])) carriers.push_back(slot);
        }
        return carriers;
    }
    // The directions and reflections in which a line may lie on a line.
    template <class Take>
    void each_way(Vec from, Vec to, Take&& take) const {
        for (const bool is_reflected : {false, true}) {
            if (is_reflected && !allows_reflections(options_)) continue;
            for (const double sign : {1.0, -1.0}) {
                const Vec turn = over(to * sign, is_reflected ? conjugate(from) : from);
                if (options_.group != MatchGroup::translation) {
                    take(turn, is_reflected);
                } else if (length(turn - Vec{1, 0}) <= 1e-6) {
                    take(Vec{1, 0}, is_reflected);
                }
            }
        }
    }

    void find_points() {
        const Vec place = elements_[points_[0]].at[0];
        kind_ = options_.group == MatchGroup::similarity ? FamilyKind::turn_and_growth : FamilyKind::turn;
        for (const std::uint32_t slot : carriers_of(points_[0])) {
            const Vec to = design_.element(slot).at[0];
            for (const bool is_reflected : {false, true}) {
                if (is_reflected && !allows_reflections(options_)) continue;
                try_base({carrying(place, to, {1, 0}, is_reflected), to, {}, {{points_[0], slot}}});
            }
        }
    }

    void find_circles() {
        const Element& own = elements_[circles_[0]];
        kind_ = FamilyKind::turn;
        for (const std::uint32_t slot : carriers_of(circles_[0])) {
            const Element& carrier = design_.element(slot);
            if (!is_circular(carrier)) continue;
            double scale = length(carrier.at[1]) / length(own.at[1]);
            if (keeps_lengths(options_)) {
                if (std::fabs(length(carrier.at[1]) - length(own.at[1])) > 10 * options_.tolerance) continue;
                scale = 1;
            } else if (!(scale >= least_growth() && scale <= options_.max_scale)) {
                continue;
            }
            for (const bool is_reflected : {false, true}) {
                if (is_reflected && !allows_reflections(options_)) continue;
                try_base({carrying(own.at[0], carrier.at[0], {scale, 0}, is_reflected),
                          carrier.at[0],
                          {},
                          {{circles_[0], slot}}});
            }
        }
    }

    void find_lines_through_a_point() {
        const std::uint32_t p = points_[0], line = lines_[0];
        kind_ = FamilyKind::growth;
        const std::vector<std::uint32_t> lines = carriers_of(line);
        for (const std::uint32_t slot : carriers_of(p)) {
            const Vec to = design_.element(slot).at[0];
            for (const std::uint32_t other : lines) {
                const Element& carrier = design_.element(other);
                if (length(foot_on(carrier, to) - to) > 10 * options_.tolerance) continue;
                each_way(unit_along(elements_[line]), unit_along(carrier), [&](Vec turn, bool is_reflected) {
                    try_base(
                        {carrying(elements_[p].at[0], to, turn, is_reflected), to, {}, {{p, slot}, {line, other}}});
                });
            }
        }
    }

    void find_lines() {
        // The two that cross at the widest angle, and the two of parallel ones that are the farthest apart.
        std::pair<std::uint32_t, std::uint32_t> crossing, apart;
        double widest = 0, farthest = 0;
        for (const std::uint32_t i : lines_) {
            for (const std::uint32_t j : lines_) {
                const double sine = std::fabs(cross(unit_along(elements_[i]), unit_along(elements_[j])));
                if (i < j && sine > widest && crossing_of(elements_[i], elements_[j])) {
                    widest = sine;
                    crossing = {i, j};
                }
                const Vec middle = embedding_.middles()[j];
                const double off = length(middle - foot_on(elements_[i], middle));
                if (off > farthest) {
                    farthest = off;
                    apart = {i, j};
                }
            }
        }
        if (widest > 0) return find_crossing_lines(crossing.first, crossing.second);
        if (keeps_lengths(options_)) return find_slides(lines_[0]);
        if (farthest > least_distance(options_)) return find_parallels(apart.first, apart.second);
        find_slides(lines_[0]);
    }

    void find_crossing_lines(std::uint32_t i, std::uint32_t j) {
        kind_ = FamilyKind::growth;
        const auto from = crossing_of(elements_[i], elements_[j]);
        Anchor anchor;
        anchor.kind = AnchorKind::crossing;
        anchor.elements = {i, j};
        anchor.do_meet = {do_meet(elements_[i], elements_[j], options_.tolerance), false};
        anchor.reach.assign(elements_.size(), 10 * options_.tolerance);
        find_seats(embedding_, anchor, [&](std::span<const Seat> seats) {
            for (const Seat& seat : seats) {
                const Similarity by = carrying(embedding_, anchor, seat);
                if (!std::isfinite(by.t.x + by.t.y)) continue;
                try_base({by, apply(by, *from), {}, {{i, seat.slots[0]}, {j, seat.slots[1]}}});
            }
            return goes_on();
        });
    }

    // Of lines on one carrier, and within isometries of parallel ones.
    void find_slides(std::uint32_t i) {
        kind_ = options_.group == MatchGroup::similarity ? FamilyKind::slide_and_growth : FamilyKind::slide;
        for (const std::uint32_t slot : carriers_of(i)) {
            const Element& carrier = design_.element(slot);
            const Vec to = (carrier.at[0] + carrier.at[1]) * 0.5, along = unit_along(carrier);
            each_way(unit_along(elements_[i]), along, [&](Vec turn, bool is_reflected) {
                try_base({carrying(embedding_.middles()[i], to, turn, is_reflected), to, along, {{i, slot}}});
            });
        }
    }

    void find_parallels(std::uint32_t i, std::uint32_t j) {
        kind_ = FamilyKind::slide;
        const Vec middle = embedding_.middles()[j];
        const double apart = length(middle - foot_on(elements_[i], middle));
        const std::vector<std::uint32_t> firsts = carriers_of(i), seconds = carriers_of(j);
        for (const std::uint32_t a : firsts) {
            const Element& carrier = design_.element(a);
            const Vec to = (carrier.at[0] + carrier.at[1]) * 0.5, along = unit_along(carrier);
            for (const std::uint32_t b : seconds) {
                if (std::fabs(cross(along, unit_along(design_.element(b)))) > 1e-3) continue;
                const Vec other = (design_.element(b).at[0] + design_.element(b).at[1]) * 0.5;
                const double scale = length(other - foot_on(carrier, other)) / apart;
                if (!(scale >= least_growth() && scale <= options_.max_scale)) continue;
                each_way(unit_along(elements_[i]), along, [&](Vec turn, bool is_reflected) {
                    try_base({carrying(embedding_.middles()[i], to, turn * scale, is_reflected),
                              to,
                              along,
                              {{i, a}, {j, b}}});
                });
            }
        }
    }

    double least_growth() const { return std::max(options_.min_scale, embedding_.least_scale()); }

    // Whether a symmetry of the left side makes another family of this one, which stands for both.
    bool is_repeated(const Base& base) const {
        const auto rank = [](bool is_reflected, double angle) {
            return std::pair(is_reflected, std::round(angle * 1e6));
        };
        const auto own = rank(base.by.is_reflected, turns() ? 0 : angle_of(to_transform(base.by)));
        return std::any_of(symmetries_.begin(), symmetries_.end(), [&](const Symmetry& g) {
            const Transform by = compose(to_transform(base.by), g.by);
            return rank(base.by.is_reflected != g.is_reflected, turns() ? 0 : angle_of(by)) < own;
        });
    }
    bool turns() const { return kind_ == FamilyKind::turn || kind_ == FamilyKind::turn_and_growth; }

    // All carriers that a left element may have while the family moves, each with its room.
    std::vector<Berth> berths_of(std::uint32_t i, const Base& base) const {
        const Element part = transformed(elements_[i], to_transform(base.by));
        const double near = 10 * options_.tolerance;
        std::vector<Berth> berths;
        const auto seated =
            std::find_if(base.seated.begin(), base.seated.end(), [&](const auto& pair) { return pair.first == i; });
        const auto take = [&](std::uint32_t slot) {
            if (seated != base.seated.end() && seated->second != slot) return;
            const Element& carrier = design_.element(slot);
            if (part.kind == ElementKind::point) {
                if (length(part.at[0] - carrier.at[0]) <= near) berths.push_back({slot, std::nullopt});
            } else if (part.kind == ElementKind::arc) {
                const bool is_such = is_circular(carrier) && length(part.at[0] - carrier.at[0]) <= near &&
                                     std::fabs(length(part.at[1]) - length(carrier.at[1])) <= near;
                if (!is_such || (is_closed(part) && !is_closed(carrier))) return;
                if (is_closed(carrier)) return berths.push_back({slot, std::nullopt});
                const Room room{part.from * degrees_per_radian, part.to * degrees_per_radian,
                                carrier.from * degrees_per_radian, carrier.to * degrees_per_radian};
                // As often round as that the first turn is below 360 degrees, and once more or less.
                const double first = -360 * std::floor((room.low - room.from) / 360);
                for (const double round : {first - 360, first, first + 360}) {
                    berths.push_back({slot, Room{room.from, room.to, room.low + round, room.high + round}});
                }
            } else {
                const Vec unit = unit_along(part);
                const auto is_off = [&](Vec at) { return std::fabs(cross(unit, at - part.at[0])) > near; };
                if (is_off(carrier.at[0]) || is_off(carrier.at[1])) return;
                const Vec along = kind_ == FamilyKind::growth ? unit : base.along;
                const Interval own = stretch_of(part, base.centre, along);
                const Interval room = stretch_of(carrier, base.centre, along);
                berths.push_back({slot, Room{own.from, own.to, room.from, room.to}});
            }
        };
        for (const std::uint32_t slot : carriers_of(i)) take(slot);
        return berths;
    }

    void try_base(const Base& base) {
        if (!goes_on() || is_repeated(base)) return;
        if (kind_ == FamilyKind::turn && !circles_.empty()) {
            double radius = 0;
            for (const std::uint32_t i : circles_) radius = std::max(radius, length(elements_[i].at[1]));
            limits_.px_per_move = radius * length(base.by.m) / degrees_per_radian;
        }
        std::vector<std::vector<Berth>> berths;
        for (std::uint32_t i = 0; i < elements_.size(); ++i) {
            berths.push_back(berths_of(i, base));
            if (berths.back().empty()) return;
        }
        Family family;
        family.kind = kind_;
        family.by = to_transform(base.by);
        family.is_reflected = base.by.is_reflected;
        family.centre = base.centre;
        family.along = base.along;
        family.carriers.resize(elements_.size());
        seat(family, berths, 0);
    }

    // Gives the elements from `i` on their carriers in all ways that leave room.
    void seat(Family& family, const std::vector<std::vector<Berth>>& berths, std::size_t i) {
        if (i == elements_.size()) return enter(family);
        for (const Berth& berth : berths[i]) {
            family.carriers[i] = berth.slot;
            if (berth.room) family.rooms.push_back(*berth.room);
            if (range_of(family, limits_).gap <= 20 * options_.tolerance) seat(family, berths, i + 1);
            if (berth.room) family.rooms.pop_back();
        }
    }

    void enter(Family family) {
        const Range range = range_of(family, limits_);
        family.moves = range.moves;
        family.growth = range.growth;
        family.turns_freely = turns() && family.rooms.empty();
        if (family.turns_freely) family.moves = {0, 360};
        // Of turns that a symmetry makes of each other, the first.
        if (turns() && !family.turns_freely && !is_first_turn(family.moves.from)) return;
        if (range.gap >= -2 * options_.tolerance) {
            const double growth = 0.5 * (family.growth.from + family.growth.to);
            const Interval moves = moves_at(family, growth);
            if (auto match = member(family, 0.5 * (moves.from + moves.to), growth)) {
                (match->misfit <= 1 ? matches_.found : matches_.near_misses).push_back(std::move(*match));
            }
            return;
        }
        for (const auto& [move, growth] : chosen_members(family, limits_)) {
            auto match = member(family, move, growth);
            if (match && match->misfit <= 1) family.members.push_back(std::move(*match));
        }
        put_in_order(family.members, options_.tolerance);
        if (!family.members.empty()) matches_.families.push_back(std::move(family));
    }

    bool is_first_turn(double turn) const {
        double least = 360;
        for (const Symmetry& g : symmetries_) {
            if (!g.is_reflected && angle_of(g.by) > 1e-6) least = std::min(least, angle_of(g.by));
        }
        return turn >= -1e-6 && turn < least - 1e-6;
    }

    std::optional<Match> member(const Family& family, double move, double growth) const {
        Laid laid{member_of(family, move, growth), family.carriers, 0};
        auto misfit = embedding_.misfit_on(laid, 20 * options_.tolerance);
        if (misfit && !is_exact(*misfit, options_.tolerance)) {
            embedding_.refine(laid);
            misfit = embedding_.misfit_on(laid, 10 * options_.tolerance);
        }
        if (!misfit) return std::nullopt;
        laid.misfit = *misfit;
        return embedding_.match_of(std::move(laid), family.is_reflected);
    }

    const Embedding& embedding_;
    const MatchIndex& design_;
    const MatchOptions& options_;
    const std::vector<Element>& elements_;
    std::span<const Symmetry> symmetries_;
    std::vector<std::uint32_t> lines_, points_, circles_;
    FamilyKind kind_ = FamilyKind::slide;
    RangeLimits limits_;
    Matches matches_;
};

}  // namespace

Matches find_families(const Embedding& embedding, std::span<const Symmetry> symmetries) {
    return FamilySearch(embedding, symmetries).found();
}

}  // namespace filigree::curves
