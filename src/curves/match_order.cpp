#include "curves/match_order.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"

namespace filigree::curves {
namespace {

// Whether two matches lie in the same place. Those of one left side that do agree in their carriers, but for elements
// that two others carry equally well.
bool is_repeat(const Match& a, const Match& b, double tolerance) {
    const double off = length(a.centroid - b.centroid), spread = 1e-5 * (a.scale + b.scale);
    const auto near = [&](double x, double y) { return std::fabs(x - y) <= spread; };
    return off <= 8 * tolerance && near(a.by.a, b.by.a) && near(a.by.b, b.by.b) && near(a.by.c, b.by.c) &&
           near(a.by.d, b.by.d);
}

}  // namespace

MatchRank rank_of(const Match& match, double tolerance) {
    int exponent = 0;
    const double mantissa = std::frexp(match.scale, &exponent), per_px = 1 / (8 * tolerance);
    MatchRank rank;
    rank.scale = std::ldexp(std::round(mantissa * 0x1p24), exponent);
    rank.x = std::round(match.centroid.x * per_px);
    rank.y = std::round(match.centroid.y * per_px);
    rank.angle = std::round(match.angle_degrees * 1e6);
    rank.is_reflected = match.is_reflected;
    rank.exact_scale = match.scale;
    rank.exact_x = match.centroid.x;
    rank.exact_y = match.centroid.y;
    rank.exact_angle = match.angle_degrees;
    return rank;
}

double angle_of(const Transform& by) {
    const double degrees = elementary::atan2(by.b, by.a) * (180 / elementary::pi);
    const double rounded = std::round((degrees < 0 ? degrees + 360 : degrees) * 1e9) * 1e-9;
    return rounded >= 360 ? 0 : rounded;
}

void put_in_order(std::vector<Match>& matches, double tolerance) {
    std::vector<std::pair<MatchRank, std::size_t>> order;
    order.reserve(matches.size());
    for (std::size_t i = 0; i < matches.size(); ++i) order.emplace_back(rank_of(matches[i], tolerance), i);
    std::sort(order.begin(), order.end(), [](const auto& a, const auto& b) {
        const auto key = a.first.key(), other = b.first.key();
        return key != other ? key < other : a.second < b.second;
    });
    std::vector<Match> sorted;
    sorted.reserve(matches.size());
    for (const auto& [rank, i] : order) {
        if (!sorted.empty() && is_repeat(sorted.back(), matches[i], tolerance)) {
            if (matches[i].misfit < sorted.back().misfit) sorted.back() = std::move(matches[i]);
        } else {
            sorted.push_back(std::move(matches[i]));
        }
    }
    matches = std::move(sorted);
}

}  // namespace filigree::curves
