#include "plane/level_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace filigree {
namespace {

constexpr double least_step = 0x1p-16;           // px
constexpr double greatest_node_count = 4194304;  // 2^22
constexpr double greatest_value = 0x1p32;        // px, of samples
constexpr double safe_slope = 8;
constexpr double safe_spacing = 0x1p-10;  // px

}  // namespace

std::int32_t LevelField::find_strip(double phi) const {
    const auto above = std::upper_bound(levels.begin() + 1, levels.end() - 1, phi);
    return static_cast<std::int32_t>(above - levels.begin()) - 1;
}

bool LevelField::aim(const Frame& frame, const Profile& profile) {
    cut_nothing();
    const double square = dot(frame.direction, frame.direction);
    const bool sound = is_on_plane(frame.origin) && is_on_plane(frame.direction) && square > 0x1p-100 &&
                       (profile.samples.empty() || (profile.step >= least_step && profile.step <= greatest_value));
    const Frame used = sound ? frame : Frame{};
    origin = snap(used.origin);
    rest = used.origin - to_px(origin);
    along = used.direction;
    // A direction that is a unit vector but for rounding stays as it is, so that exact frames stay exact.
    if (sound && std::fabs(square - 1) > 0x1p-49) along = along * (1 / std::sqrt(square));
    across = perpendicular(along);
    step = profile.step;
    inverse_step = 1 / profile.step;
    return sound;
}

bool LevelField::cover(const Profile& profile, double u_low, double u_high) {
    nodes.clear();
    node_points.clear();
    if (profile.samples.empty()) return true;
    const double first = std::floor(u_low * inverse_step) - 1;
    const double last = std::floor(u_high * inverse_step) + 2;
    if (!(last - first < greatest_node_count)) return false;
    first_node = static_cast<std::int64_t>(first);
    const auto count = static_cast<std::size_t>(last - first) + 1;
    const auto period = static_cast<std::int64_t>(profile.samples.size());
    std::int64_t sample = first_node % period;
    if (sample < 0) sample += period;
    nodes.resize(count);
    node_points.resize(count);
    node_reach = 0;
    bool sound = true;
    for (std::size_t i = 0; i < count; ++i) {
        FieldNode& node = nodes[i];
        node.u = static_cast<double>(first_node + static_cast<std::int64_t>(i)) * step;
        node.value = profile.samples[static_cast<std::size_t>(sample)];
        sound &= std::fabs(node.value) <= greatest_value;
        if (++sample == period) sample = 0;
        node.slope = (profile.samples[static_cast<std::size_t>(sample)] - node.value) * inverse_step;
        const Vec at = (rest + node.u * along + node.value * across) * grid_per_px;
        node_points[i] = at;
        may_flip |= std::fabs(node.slope) > safe_slope;
        node_reach = std::max({node_reach, std::fabs(at.x), std::fabs(at.y)});
    }
    if (sound) return true;
    nodes.clear();
    node_points.clear();
    return false;
}

bool LevelField::choose_levels(std::span<const double> family_levels, double v_low, double v_high) {
    double value_low = 0, value_high = 0;
    if (!nodes.empty()) {
        value_low = value_high = nodes.front().value;
        for (const FieldNode& node : nodes) {
            value_low = std::min(value_low, node.value);
            value_high = std::max(value_high, node.value);
        }
    }
    // Twice the tolerance: a vertex at the end of the range must see every level that is near to it.
    const auto all_begin = family_levels.begin(), all_end = family_levels.end();
    const auto begin = std::lower_bound(all_begin, all_end, v_low - value_high - 2 * level_tolerance);
    const auto end = std::upper_bound(begin, all_end, v_high - value_low + 2 * level_tolerance);
    levels.assign(1, -std::numeric_limits<double>::infinity());
    strip_numbers.clear();
    for (auto k = begin; k != end; ++k) {
        if (!std::isfinite(*k)) return false;
        if (k != all_begin) {  // also for the first: shapes that begin elsewhere must make the same choice
            const double spacing = *k - *(k - 1);
            if (!(spacing > 0)) return false;
            if (spacing <= level_tolerance) continue;
            if (spacing < safe_spacing) may_flip = true;
        }
        levels.push_back(*k);
        strip_numbers.push_back(k - all_begin);
    }
    levels.push_back(std::numeric_limits<double>::infinity());
    strip_numbers.push_back(end - all_begin);
    return true;
}

void LevelField::cut_nothing() {
    nodes.clear();
    node_points.clear();
    may_flip = false;
    levels = {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    strip_numbers.assign(1, 0);
}

void LevelField::curve_points(std::int32_t k, std::size_t begin, std::size_t end, Point* out) const {
    const Vec offset = (level(k) * grid_per_px) * across;
    if (node_reach + std::fabs(offset.x) + std::fabs(offset.y) < 0x1p50) {
        // As round_to_grid does it, without the question at every point.
        constexpr double shift = 0x1.8p52;
        const std::uint64_t zero = std::bit_cast<std::uint64_t>(shift);
        const std::uint64_t base_x = static_cast<std::uint64_t>(origin.x) - zero;
        const std::uint64_t base_y = static_cast<std::uint64_t>(origin.y) - zero;
        for (std::size_t i = begin; i < end; ++i, ++out) {
            const double x = node_points[i].x + offset.x + shift, y = node_points[i].y + offset.y + shift;
            out->x = static_cast<std::int64_t>(std::bit_cast<std::uint64_t>(x) + base_x);
            out->y = static_cast<std::int64_t>(std::bit_cast<std::uint64_t>(y) + base_y);
        }
        return;
    }
    for (std::size_t i = begin; i < end; ++i, ++out) {
        const Vec at = node_points[i] + offset;
        *out = {origin.x + round_to_grid(at.x), origin.y + round_to_grid(at.y)};
    }
}

NodeRange nodes_between(const LevelField& field, double u_low, double u_high) {
    const double low = u_low + level_tolerance, high = u_high - level_tolerance;
    if (field.nodes.empty() || !(low < high)) return {};
    const auto count = static_cast<std::int64_t>(field.nodes.size());
    std::int64_t begin = static_cast<std::int64_t>(low * field.inverse_step) - field.first_node - 1;
    begin = std::clamp<std::int64_t>(begin, 0, count);
    while (begin < count && field.nodes[static_cast<std::size_t>(begin)].u <= low) ++begin;
    if (begin == count || field.nodes[static_cast<std::size_t>(begin)].u >= high) return {};
    std::int64_t end = static_cast<std::int64_t>(high * field.inverse_step) - field.first_node - 1;
    end = std::clamp<std::int64_t>(end, begin + 1, count);
    while (end < count && field.nodes[static_cast<std::size_t>(end)].u < high) ++end;
    return {static_cast<std::size_t>(begin), static_cast<std::size_t>(end)};
}

}  // namespace filigree
