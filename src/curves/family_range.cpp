#include "curves/family_range.h"

#include <algorithm>
#include <cmath>

namespace filigree::curves {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Of parts that grow from a centre, each along its own line.
Interval growth_of(const Family& family, const RangeLimits& limits) {
    Interval growth{limits.least_growth, limits.most_growth};
    // growth * part <= bound, or >=.
    const auto bound = [&](double part, double at, bool is_upper) {
        if (part == 0) return;
        if ((part > 0) == is_upper) {
            growth.to = std::min(growth.to, at / part);
        } else {
            growth.from = std::max(growth.from, at / part);
        }
    };
    for (const Room& room : family.rooms) {
        // What is at the centre stays there.
        const bool starts = std::fabs(room.from) <= limits.slack, ends = std::fabs(room.to) <= limits.slack;
        if ((starts && room.low > 10 * limits.slack) || (ends && room.high < -10 * limits.slack)) return {1, 0};
        if (!starts) bound(room.from, room.low, false);
        if (!ends) bound(room.to, room.high, true);
    }
    return growth;
}

// Of parts on one line, which may be slid as well: each pair of them has to find room at once.
Interval growth_on_line(const Family& family, const RangeLimits& limits) {
    Interval growth{limits.least_growth, limits.most_growth};
    for (const Room& a : family.rooms) {
        for (const Room& b : family.rooms) {
            // low_a - growth from_a <= high_b - growth to_b
            const double part = b.to - a.from, room = b.high - a.low;
            if (part > 0) growth.to = std::min(growth.to, room / part);
            if (part < 0) growth.from = std::max(growth.from, room / part);
        }
    }
    return growth;
}

double extent_of(const Family& family) {
    double most = 0;
    for (const Room& room : family.rooms) most = std::max({most, std::fabs(room.from), std::fabs(room.to)});
    return most;
}

}  // namespace

Range range_of(const Family& family, const RangeLimits& limits) {
    Range range;
    switch (family.kind) {
        case FamilyKind::turn_and_growth:
            range.growth = {limits.least_growth, limits.most_growth};
            range.gap = -infinity;
            break;
        case FamilyKind::slide:
        case FamilyKind::turn:
            range.moves = {-infinity, infinity};
            for (const Room& room : family.rooms) {
                range.moves.from = std::max(range.moves.from, room.low - room.from);
                range.moves.to = std::min(range.moves.to, room.high - room.to);
            }
            range.gap = (range.moves.from - range.moves.to) * limits.px_per_move;
            break;
        case FamilyKind::growth:
        case FamilyKind::slide_and_growth:
            range.growth =
                family.kind == FamilyKind::growth ? growth_of(family, limits) : growth_on_line(family, limits);
            if (family.kind == FamilyKind::slide_and_growth) range.moves = moves_at(family, range.growth.to);
            range.gap = family.rooms.empty() ? -infinity : (range.growth.from - range.growth.to) * extent_of(family);
            break;
    }
    return range;
}

std::vector<std::pair<double, double>> chosen_members(const Family& family, const RangeLimits& limits) {
    std::vector<std::pair<double, double>> members;
    const auto add_moves = [&](double growth) {
        const Interval moves = moves_at(family, growth);
        members.insert(members.end(),
                       {{moves.from, growth}, {0.5 * (moves.from + moves.to), growth}, {moves.to, growth}});
    };
    const Interval growth = family.growth;
    const bool has_drawn = growth.from <= 1 && growth.to >= 1;
    switch (family.kind) {
        case FamilyKind::slide:
            add_moves(1);
            break;
        case FamilyKind::turn:
            if (family.turns_freely) {
                members = {{0, 1}};
            } else {
                add_moves(1);
            }
            break;
        case FamilyKind::growth:
            members = {{0, growth.to}};
            if (has_drawn) members.emplace_back(0, 1);
            if (growth.from > limits.least_growth) members.emplace_back(0, growth.from);
            break;
        case FamilyKind::slide_and_growth:
            members = {{0.5 * (family.moves.from + family.moves.to), growth.to}};
            if (has_drawn) add_moves(1);
            break;
        case FamilyKind::turn_and_growth:
            members = {{0, std::clamp(1.0, growth.from, growth.to)}};
            break;
    }
    return members;
}

}  // namespace filigree::curves
